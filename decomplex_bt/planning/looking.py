"""Looking: tasks that find something out, a thing's place or its state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from decomplex_bt.domain.nouns import be, deny
from decomplex_bt.planning.belief import ROBOT
from decomplex_bt.planning.ground_task import Referent
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.problem import fact_name
from decomplex_bt.planning.standing import NothingLeftError, Pursuit, PursuitStatus, Standing
from decomplex_bt.planning.whereabouts import next_place, places_of


class Looking(Standing):
    """How a search or a check stands, and where to look next."""

    # -- searching ----------------------------------------------------------------------------------------------------

    def _look_at_places(self) -> Pursuit:
        """A search for nothing in particular: every place the task names is to be inspected."""
        failures: list[str] = []
        for referent in self.task.places:
            names = self._meant(referent)
            done = [name for name in names if all(self._was_inspected(p) for p in self._parts(name))]
            if len(done) >= self._needed(referent):
                continue
            for name in names:
                open_places = [place for place in self._parts(name) if self._is_open(place)]
                if name not in done and open_places:
                    return self._inspect(next_place((), self.belief, open_places), "")
            failures.append(referent.phrase)
        if not failures:
            return self._done({referent: self._meant(referent) for referent in self.task.places})
        raise NothingLeftError(self._why(f"{failures[0]!r} could not be inspected", self.wheres), truth=None)

    def _parts(self, name: str) -> tuple[str, ...]:
        return places_of((name,), self.belief)

    def _look_through(self, *, may_be_partial: bool) -> Pursuit:
        """A search through the places that the task names; false when they were inspected in vain."""
        names = [name for referent in self.task.objects for name in self._fitting(referent)]
        known = [
            place for name in names if (place := self.belief.place_of(name)) in self.wheres and self._is_open(place)
        ]
        open_places = known or [place for place in self.wheres if self._is_open(place)]
        place = next_place((not known and self._lost_landmarks()) or names, self.belief, open_places)
        if place is not None:
            return self._inspect(place, self._objects_phrase())
        inspected = [place for place in self.wheres if self._was_inspected(place)]
        if len(inspected) == len(self.wheres) or (inspected and may_be_partial and not self._unanswered()):
            return self._not_there()
        raise NothingLeftError(self._why("not all places could be inspected", self.wheres), truth=None)

    def _look_at_fixed(self) -> Pursuit:
        """A search for what is fixed: it is where the map has it, and nothing has to be opened for it."""
        if self._found(self._is_there) is None:
            return self._not_there()
        there = [name for name in self._missing(self._was_seen) if self._is_there(name)]
        return self._bring_about(list(map(self._seen_goal, there)), f"going to {self._objects_phrase()}")

    def _not_there(self) -> Pursuit:
        reason = deny(self._objects_phrase(), "there")
        return Pursuit(PursuitStatus.DONE, truth=False, reason=reason, bindings=self.bindings)

    def _look_for(self, names: Sequence[str]) -> Pursuit:
        """A search through the house, for what is not where the robot has looked."""
        for name in names:
            if name in self.house.things or name in self.house.people:
                place = self.belief.place_of(name)
                goals = [self._inspected_goal(place)] if place not in (None, ROBOT) else []
                if (goal := self._first_open(goals)) is not None:
                    return self._ongoing(goal, f"going to where {self._objects_phrase()} {be(self._objects_phrase())}")
            elif (goal := self._first_open([self._seen_goal(name)])) is not None:
                return self._ongoing(goal, f"going to {self._objects_phrase()}")
        open_places = self._open_for(names)
        place = next_place(names, self.belief, open_places)
        if place is not None:
            return self._inspect(place, self._phrase_of(names))
        what = self._phrase_of(names)
        raise NothingLeftError(self._why(f"{what} {be(what)} nowhere to be found", names))

    def _inspect(self, place: str | None, what: str) -> Pursuit:
        assert place is not None
        where = place.replace("_", " ")
        doing = f"looking for {what} at the {where}" if what else f"looking at the {where}"
        return self._ongoing(self._inspected_goal(place), doing)

    # -- states -------------------------------------------------------------------------------------------------------

    def _check_value(self) -> Pursuit:
        """Looks at the objects until what was seen settles whether they have the state."""
        value = self.task.state or ""
        pair = self.domain.kinds.pair_of(value)
        settled: dict[Referent, list[str]] = {}
        for referent in self.task.objects:
            if (nothing_there := self._none_there(referent)) is not None:
                return nothing_there
            seen = [name for name in self._fitting(referent) if self.belief.state_seen(name, pair) >= self.since]
            seen = [name for name in seen if not self.wheres or self._is_there(name)] or (
                [] if self._may_be_there() else seen
            )
            so = [name for name in seen if self.belief.state(name, pair) == value]
            not_so = [name for name in seen if name not in so]
            left = [name for name in self._fitting(referent) if name not in seen and self._may_be_seen(name)]
            if self._may_be_there() and not any(self._is_open(place) for place in self.wheres):
                left = [name for name in left if self._is_there(name)]  # what is elsewhere was not asked about
            has_given_up = not left and self._unanswered() is not None
            is_all_seen = not left and not has_given_up
            if referent.is_all and (not_so or is_all_seen) and seen:
                if not_so:
                    return self._false({})
                settled[referent] = so
            elif not referent.is_all and len(so) >= self._needed(referent):
                settled[referent] = so[: self._needed(referent)]
            elif not_so and not referent.is_any:
                return self._false({referent: not_so[:1]})
            elif is_all_seen and referent.is_any and (not_so or self.task.places):
                return self._false({})
            elif has_given_up:
                raise self._unseen(referent)
            else:
                return self._look_at(left, pair, referent)
        return self._done(settled)

    def _none_there(self, referent: Referent) -> Pursuit | None:
        """That what a check is about is not where the task says it is, once all of that was looked at."""
        there = [name for name in self._fitting(referent) if self._is_there(name)]
        if not self.wheres or len(there) >= (1 if referent.is_all else referent.count):
            return None
        if any(map(self._is_open, self.wheres)):
            return None
        if all(map(self._was_inspected, self.wheres)):
            return self._not_there()
        raise NothingLeftError(self._why("not all places could be inspected", self.wheres), truth=None)

    def _look_at(self, names: Sequence[str], pair: str, referent: Referent) -> Pursuit:
        """Goes where the state of one of these can be seen."""
        doing = f"checking {referent.phrase}"
        if self.wheres and self._may_be_there():
            there = [name for name in names if self._is_there(name)]
            if not there:
                place = next_place(names, self.belief, [place for place in self.wheres if self._is_open(place)])
                return self._inspect(place, referent.phrase)
            names = there
        located = [name for name in names if self._is_located(name)]
        goals = [(Atom("known", (fact_name(pair, name),)),) for name in sorted(located, key=self._distance)]
        goal = self._first_open(goals)
        if goal is not None:
            return self._ongoing(goal, doing)
        unknown = [name for name in names if not self._is_located(name)]
        open_places = self._open_for(unknown)
        place = next_place(unknown, self.belief, open_places)
        if place is not None:
            return self._inspect(place, referent.phrase)
        raise self._unseen(referent)

    def _unseen(self, referent: Referent) -> NothingLeftError:
        why = self._why(f"the state of {referent.phrase!r} could not be seen", referent.candidates)
        return NothingLeftError(why, truth=None)

    def _may_be_there(self) -> bool:
        """Whether a place that the task names is still to be looked at, or has one of the objects."""
        names = [name for referent in self.task.objects for name in self._fitting(referent)]
        return any(self._is_open(place) for place in self.wheres) or any(
            self._is_there(name) for name in names if self.wheres
        )

    def _may_be_seen(self, name: str) -> bool:
        """Whether an entity is known to be somewhere, or may still turn up."""
        if self.task.places and self.task.objects[0].is_any and not self._is_located(name):
            return any(self._is_open(place) for place in self.wheres)
        return self._is_located(name) or bool(self._open_for([name]))

    def _false(self, bound: Mapping[Referent, Sequence[str]]) -> Pursuit:
        reason = deny(self._objects_phrase(), str(self.task.state))
        return Pursuit(PursuitStatus.DONE, truth=False, reason=reason, bindings=self._bind(bound))
