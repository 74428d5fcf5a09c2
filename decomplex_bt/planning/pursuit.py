"""The pursuit of one task at run time: what to bring about next, or that it is done or past hope.

How the leaf of a behaviour tree uses it (`bindings` is shared by all leaves of an instruction, `since` is the belief's
tick when the task became due):

    belief.update(percept)                               # every tick
    pursuit = pursue(task, belief, bindings, since=since)
    bindings = pursuit.bindings
    if pursuit.status is ONGOING:                        # keep the running plan while pursuit.goal_atoms stay the same
        problem = belief_problem(belief, pursuit.goal_atoms)     # planning/problem.py
        result = planner.solve(problem)                          # planning/planner.py
        if result.status is not SOLVED: belief.give_up(pursuit.goal_atoms, result.reason)   # and pursue again
        else run the skills of result.steps in order; a skill's end is reported by
            belief.succeeded(step)   or   belief.failed(step, reason)                        # and pursue again

`pursue` is a pure function of its arguments and cheap; calling it whenever `belief.revision` has changed lets the leaf
see at once that a thing has turned up on the way, or that the goal holds already.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from decomplex_bt.planning.abilities import holds_things
from decomplex_bt.planning.belief import ROBOT, Belief
from decomplex_bt.planning.ground_task import HERE, GroundTask, Referent
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.problem import fact_name
from decomplex_bt.planning.whereabouts import is_at, likely_places, next_place, places_in, places_of, room_distances

Bindings = Mapping[Referent, tuple[str, ...]]
"""Which entities a referent has turned out to mean; final once a task that names it is done."""


class PursuitStatus(Enum):
    """How a task stands."""

    ONGOING = "ongoing"
    DONE = "done"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class Pursuit:
    """How a task stands and what to bring about next.

    `goal_atoms` (ONGOING): the goal of the next plan. `truth` (DONE, FAILED): what the task is as a condition: true,
    false, or None where it is neither, which is a failure with the `reason` whatever the flow. As a plain step DONE is
    success and FAILED failure. `doing`: in words what is being done now, for feedback. `bindings` replaces the bindings
    that were handed in.
    """

    status: PursuitStatus
    goal_atoms: tuple[Atom, ...] = ()
    truth: bool | None = None
    reason: str = ""
    doing: str = ""
    bindings: Bindings = field(default_factory=dict)


def pursue(task: GroundTask, belief: Belief, bindings: Bindings, *, since: int) -> Pursuit:
    """How the task stands, by what the robot has perceived since `belief.tick` was `since` (contracts.md)."""
    pursuer = _Pursuer(task, belief, bindings, since)
    try:
        pursuer.settle_all()
        return getattr(pursuer, f"_{task.type}", pursuer._other)()
    except _NothingLeftError as error:
        return Pursuit(PursuitStatus.FAILED, truth=error.truth, reason=str(error), bindings=bindings)


class _NothingLeftError(Exception):
    """Nothing is left to try; `truth` is what the task is as a condition."""

    def __init__(self, reason: str, truth: bool | None = False) -> None:
        super().__init__(reason)
        self.truth = truth


class _Pursuer:
    """One task at one moment: each method named for a task type says how it stands."""

    def __init__(self, task: GroundTask, belief: Belief, bindings: Bindings, since: int) -> None:
        self.task, self.belief, self.bindings, self.since = task, belief, bindings, max(since, 0)
        self.domain = belief.domain
        self.house = belief.domain.house
        self.wheres = tuple(
            place for r in task.places for place in places_of(r, belief, for_people=self._asks_people())
        )

    def settle_all(self) -> None:
        """Binds "everything on the table", once the places were looked at, to what is there then."""
        if self.task.type not in _HANDLING or not self.wheres or any(self._is_open(place) for place in self.wheres):
            return
        for referent in self.task.objects:
            if referent.is_all and referent not in self.bindings:
                there = [name for name in self._fitting(referent) if self._is_there(name)]
                if not there:
                    raise _NothingLeftError(self._why(f"{referent.phrase!r}: nothing of it is there", self.wheres))
                self.bindings = self._bind({referent: there})

    # -- one for each task type -------------------------------------------------------------------------------------------

    def _motion(self) -> Pursuit:
        target = self.task.goal or self.task.recipient
        assert target is not None
        reached = [name for name in self._meant(target) if self._was_at(name)]
        if len(reached) >= self._needed(target):
            return self._done({target: reached})
        return self._go(target, [name for name in self._meant(target) if name not in reached])

    def _searching(self) -> Pursuit:
        if not self.task.objects:
            return self._look_at_places()
        found = self._found(lambda name: self.belief.seen(name) >= self.since and self._is_there(name))
        if found is not None:
            return self._done(found)
        if not self.task.places:
            return self._look_for(self._missing(lambda name: self.belief.seen(name) >= self.since))
        return self._look_through(may_be_partial=True)

    def _check_state(self) -> Pursuit:
        if self.task.state != HERE:
            return self._check_value()
        found = self._found(lambda name: self._was_seen(name) and self._is_there(name))
        if found is not None:
            return self._done(found)
        if self.task.places:
            return self._look_through(may_be_partial=False)
        try:
            return self._look_for(self._missing(self._was_seen))
        except _NothingLeftError as error:
            # All was looked at in vain: that is an answer.
            return Pursuit(PursuitStatus.DONE, truth=False, reason=str(error), bindings=self.bindings)

    def _taking(self) -> Pursuit:
        return self._handle("taking", lambda name: self.belief.carried(name) >= self.since, {})

    def _placing(self) -> Pursuit:
        return self._put("placing")

    def _bringing(self) -> Pursuit:
        return self._put("bringing")

    def _change_state(self) -> Pursuit:
        value = self.task.state or ""
        pair = self.domain.kinds.pair_of(value)

        def has_become(name: str) -> bool:
            if self.belief.state(name, pair) != value:
                return False
            was_asked = any(pair == other for r in self.task.objects if name in r.candidates for other, _ in r.where)
            return not was_asked or self.belief.state_changed(name, pair) >= self.since

        return self._handle("change_state", has_become, {"state": value}, batch=1)

    def _following(self) -> Pursuit:
        rooms = [self.domain.room_of(name) or name for name in self._meant(self.task.goal)] if self.task.goal else []

        def has_come(person: str) -> bool:
            if rooms:
                is_there = self.belief.room in rooms and self.belief.place_of(person) in rooms
                return is_there or any(self._was_noted("followed", person, room) for room in rooms)
            return self._was_noted("accompanied", person)

        found = self._found(has_come)
        if found is not None:
            return self._done(found)
        roles = {"goal": rooms[0]} if rooms else {}
        return self._with_people(self.task.objects, lambda who: self._goal({"object": who, **roles}), has_come)

    def _informing(self) -> Pursuit:
        assert self.task.recipient is not None

        def was_told(person: str) -> bool:
            return self._was_noted("told", person)

        return self._with_people((self.task.recipient,), lambda who: self._goal({"recipient": who}), was_told)

    def _other(self) -> Pursuit:
        """A task type of a domain of one's own: its goal template, with the first candidate of every phrase."""
        roles = {"object": self.task.objects[0]} if self.task.objects else {}
        roles |= {
            role: r for role, r in (("goal", self.task.goal), ("recipient", self.task.recipient)) if r is not None
        }
        goal = self._goal({role: self._meant(referent)[0] for role, referent in roles.items()})
        if all(self.belief.noted(atom) > self.since for atom in goal):
            return self._done({})
        return self._bring_about([goal], self.task.phrase)

    # -- searching ----------------------------------------------------------------------------------------------------------

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
        raise _NothingLeftError(self._why(f"{failures[0]!r} could not be inspected", self.wheres), truth=None)

    def _parts(self, name: str) -> tuple[str, ...]:
        return places_of(Referent(name, (name,)), self.belief)

    def _look_through(self, *, may_be_partial: bool) -> Pursuit:
        """A search through the places that the task names; false when they were inspected in vain."""
        names = [name for referent in self.task.objects for name in self._fitting(referent)]
        known = [
            place for name in names if (place := self.belief.place_of(name)) in self.wheres and self._is_open(place)
        ]
        open_places = known or [place for place in self.wheres if self._is_open(place)]
        place = next_place(names, self.belief, open_places)
        if place is not None:
            return self._inspect(place, self._objects_phrase())
        inspected = [place for place in self.wheres if self._was_inspected(place)]
        if len(inspected) == len(self.wheres) or (inspected and may_be_partial):
            reason = f"{self._objects_phrase()} is not there"
            return Pursuit(PursuitStatus.DONE, truth=False, reason=reason, bindings=self.bindings)
        raise _NothingLeftError(self._why("not all places could be inspected", self.wheres), truth=None)

    def _look_for(self, names: Sequence[str]) -> Pursuit:
        """A search through the house, for what is not where the robot has looked."""
        for name in names:
            if name in self.house.things or name in self.house.people:
                place = self.belief.place_of(name)
                holder = place if place in self.house.people else None
                goals = [self._inspected_goal(place or "")] if holder is None else [(Atom("at", (holder,)),)]
                if place is not None and (goal := self._first_open(goals)) is not None:
                    return self._ongoing(goal, f"going to where {self._objects_phrase()} is")
            elif (goal := self._first_open([(Atom("at", (name,)),)])) is not None:
                return self._ongoing(goal, f"going to {self._objects_phrase()}")
        open_places = [place for place in likely_places(names, self.belief) if self._is_open(place)]
        place = next_place(names, self.belief, open_places)
        if place is not None:
            return self._inspect(place, self._phrase_of(names))
        raise _NothingLeftError(self._why(f"{self._phrase_of(names)} is nowhere to be found", names))

    def _inspect(self, place: str | None, what: str) -> Pursuit:
        assert place is not None
        where = place.replace("_", " ")
        doing = f"looking for {what} at the {where}" if what else f"looking at the {where}"
        return self._ongoing(self._inspected_goal(place), doing)

    def _inspected_goal(self, place: str) -> tuple[Atom, ...]:
        """To have looked at a place; at what holds nothing one is, and a person's room is looked over."""
        if place in self.house.rooms:
            place = self.house.floor_of(place)
        if place in self.house.people or not holds_things(place, self.domain):
            return (Atom("at", (place,)),)
        return self._atoms("searching", {"location": place})

    def _is_open(self, place: str | None) -> bool:
        """Whether a place can still be looked at: not inspected since the task became due, and not given up."""
        return place is not None and not self._was_inspected(place) and self._is_possible(self._inspected_goal(place))

    def _was_inspected(self, place: str) -> bool:
        if place in self.house.people or not holds_things(place, self.domain):
            return self.belief.visited(place) >= self.since
        return self.belief.inspected(place) >= self.since

    # -- states -------------------------------------------------------------------------------------------------------------

    def _check_value(self) -> Pursuit:
        """Looks at the objects until what was seen settles whether they have the state."""
        value = self.task.state or ""
        pair = self.domain.kinds.pair_of(value)
        settled: dict[Referent, list[str]] = {}
        for referent in self.task.objects:
            seen = [name for name in self._fitting(referent) if self.belief.state_seen(name, pair) >= self.since]
            seen = [name for name in seen if not self.wheres or self._is_there(name)] or (
                [] if self._may_be_there() else seen
            )
            so = [name for name in seen if self.belief.state(name, pair) == value]
            not_so = [name for name in seen if name not in so]
            is_any = _is_indefinite(referent)
            left = [name for name in self._fitting(referent) if name not in seen and self._may_be_seen(name)]
            if referent.is_all and (not_so or not left) and seen:
                if not_so:
                    return self._false({referent: not_so})
                settled[referent] = so
            elif not referent.is_all and len(so) >= self._needed(referent):
                settled[referent] = so[: self._needed(referent)]
            elif not_so and not is_any:
                return self._false({referent: not_so[:1]})
            elif not left and is_any and (not_so or self.task.places):
                return self._false({})
            else:
                return self._look_at(left, pair, referent)
        return self._done(settled)

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
        open_places = [place for place in likely_places(unknown, self.belief) if self._is_open(place)]
        place = next_place(unknown, self.belief, open_places)
        if place is not None:
            return self._inspect(place, referent.phrase)
        raise _NothingLeftError(
            self._why(f"the state of {referent.phrase!r} could not be seen", referent.candidates), truth=None
        )

    def _may_be_there(self) -> bool:
        """Whether a place that the task names is still to be looked at, or has one of the objects."""
        names = [name for referent in self.task.objects for name in self._fitting(referent)]
        return any(self._is_open(place) for place in self.wheres) or any(
            self._is_there(name) for name in names if self.wheres
        )

    def _may_be_seen(self, name: str) -> bool:
        """Whether an entity is known to be somewhere, or may still turn up."""
        if self.task.places and _is_indefinite(self.task.objects[0]) and not self._is_located(name):
            return any(self._is_open(place) for place in self.wheres)
        return self._is_located(name) or any(self._is_open(place) for place, _ in self.belief.likely_places(name))

    def _false(self, bound: Mapping[Referent, Sequence[str]]) -> Pursuit:
        reason = f"{self._objects_phrase()} is not {self.task.state}"
        return Pursuit(PursuitStatus.DONE, truth=False, reason=reason, bindings=self._bind(bound))

    # -- handling things ------------------------------------------------------------------------------------------------------

    def _put(self, task_type: str) -> Pursuit:
        """Placing and bringing: the things end up at the goal, or with the recipient."""
        target = self.task.recipient or self.task.goal
        assert target is not None
        role = "recipient" if self.task.recipient is not None else "goal"
        people = [name for name in self._meant(target) if name in self.house.people]
        places = [place for name in self._meant(target) if name not in people for place in self._landing(name)]

        def has_arrived(name: str) -> bool:
            place = self.belief.place_of(name)
            return place is not None and place != ROBOT and self._is_target(place, target)

        found = self._found(has_arrived)
        if found is not None:
            return self._done(found)
        lost = [name for name in people if not self._is_located(name)]
        ends = [name for name in (*people, *places) if name not in lost]
        if not ends and lost:
            return self._look_for_people(target, lost)
        for end in ends:
            pursuit = self._handle(
                task_type, has_arrived, {role if end in people else "goal": end}, is_last=end == ends[-1]
            )
            if pursuit is not None:
                return pursuit
        raise _NothingLeftError(self._why(f"there is no way to {target.phrase!r}", target.candidates))

    def _is_target(self, place: str, target: Referent) -> bool:
        for name in self._meant(target):
            if place == name or (name in self.house.rooms and self.domain.room_of(place) == name):
                return True
            if name in self.house.things and self.belief.place_of(name) == place:
                return True
        return False

    def _landing(self, name: str) -> list[str]:
        """Where a thing is put for a goal: the place itself, in a room a surface that suits it, beside a thing its place."""
        if name in self.house.things:
            place = self.belief.place_of(name)
            return [place] if place is not None and place != ROBOT else []
        if name not in self.house.rooms:
            return [name]
        things = [thing for referent in self.task.objects for thing in self._fitting(referent)]
        weights = [dict(self.belief.prior.places.get(thing, ())) for thing in things]
        surfaces = [place for place in places_in(name, self.domain) if not self.domain.kind(place).has_door]
        return sorted(
            surfaces, key=lambda place: (-sum(weight.get(place, 0.0) for weight in weights), surfaces.index(place))
        )

    def _handle(
        self,
        task_type: str,
        is_done: Callable[[str], bool],
        roles: Mapping[str, str],
        *,
        batch: int = 2,
        is_last: bool = True,
    ) -> Any:
        """Brings something about for the objects: finds them all first, then plans for a few at a time.

        None, where this is not the last thing to try, when nothing is left to try.
        """
        found = self._found(is_done)
        if found is not None:
            return self._done(found)
        chosen: list[str] = []
        for referent in self.task.objects:
            picked, unknown = self._choose(referent, is_done, task_type, roles)
            if len(picked) < self._needed(referent) and unknown:
                place = self._next_for(unknown)
                if place is not None:
                    return self._inspect(place, referent.phrase)
            if not self._is_enough(referent, picked):
                if not is_last:
                    return None
                raise _NothingLeftError(self._why_not(referent, roles))
            chosen += [name for name in picked if not is_done(name)]
        goals = [self._atoms(task_type, {**roles, "object": name}) for name in chosen]
        joint = tuple(sorted({atom for goal in goals[:batch] for atom in goal}))
        goal = self._first_open([joint, *goals])
        if goal is None:
            raise _NothingLeftError(self._why(f"no way was found to do it with {self._objects_phrase()}", chosen))
        return self._ongoing(goal, self.task.phrase)

    def _choose(
        self, referent: Referent, is_done: Callable[[str], bool], task_type: str, roles: Mapping[str, str]
    ) -> tuple[list[str], list[str]]:
        """Those of a referent's candidates that will do and are located, best first, and those that may still turn up."""

        def is_possible(name: str) -> bool:
            return is_done(name) or self._is_possible(self._atoms(task_type, {**roles, "object": name}))

        able = [name for name in self._fitting(referent) if is_possible(name)]
        located = [name for name in able if self._is_located(name)]
        if self.wheres and referent not in self.bindings:
            there = [
                name for name in located if is_done(name) or self._is_there(name) or self.belief.place_of(name) == ROBOT
            ]
            if referent.is_all or there or any(self._is_open(place) for place in self.wheres):
                located = there
        unknown = [name for name in able if not self._is_located(name)]
        if self.wheres and not unknown and len(located) < self._needed(referent):
            unknown = able
        located.sort(key=lambda name: (not is_done(name), self.belief.place_of(name) != ROBOT, self._distance(name)))
        if referent.is_all:
            return located, unknown
        return located[: self._needed(referent)], unknown

    def _next_for(self, unknown: Sequence[str]) -> str | None:
        """Where to look next for things: at the places the task names, then wherever they may be."""
        place = next_place(unknown, self.belief, [place for place in self.wheres if self._is_open(place)])
        if place is not None or (self.wheres and any(r.is_all for r in self.task.objects)):
            return place
        return next_place(unknown, self.belief, [p for p in likely_places(unknown, self.belief) if self._is_open(p)])

    def _is_enough(self, referent: Referent, picked: Sequence[str]) -> bool:
        """Of "all" those will do that there are; else as many as are asked for."""
        return bool(picked) if referent.is_all else len(picked) >= self._needed(referent)

    # -- people and places to go to ---------------------------------------------------------------------------------------------

    def _go(self, target: Referent, names: Sequence[str]) -> Pursuit:
        located = [name for name in names if self._is_located(name)]
        goals = [self._atoms("motion", {"goal": self._standing_for(name)}) for name in located]
        goal = self._first_open(goals)
        if goal is not None:
            return self._ongoing(goal, f"going to {target.phrase}")
        lost = [name for name in names if name not in located]
        if lost:
            return self._look_for_people(target, lost)
        raise _NothingLeftError(self._why(f"there is no way to {target.phrase!r}", target.candidates))

    def _standing_for(self, name: str) -> str:
        """The room or position one goes to for a name: of a thing its place, of a floor its room."""
        if name in self.house.things:
            place = self.belief.place_of(name)
            return self.belief.room if place in (None, ROBOT) else str(place)
        return name.removesuffix("_floor") if name.removesuffix("_floor") in self.house.rooms else name

    def _was_at(self, name: str) -> bool:
        name = self._standing_for(name)
        return self.belief.visited(name) >= self.since

    def _with_people(
        self, referents: Sequence[Referent], goal_of: Callable[[str], tuple[Atom, ...]], is_done: Callable[[str], bool]
    ) -> Pursuit:
        """Does something with people, one after the other, looking for those whose whereabouts are not known."""
        for referent in referents:
            done = [name for name in self._meant(referent) if is_done(name)]
            if len(done) >= self._needed(referent):
                continue
            left = [name for name in self._meant(referent) if name not in done]
            located = sorted((name for name in left if self._is_located(name)), key=self._distance)
            goal = self._first_open([goal_of(name) for name in located])
            if goal is not None:
                return self._ongoing(goal, self.task.phrase)
            lost = [name for name in left if name not in located]
            if lost and self._next_for(lost) is not None:
                return self._look_for_people(referent, lost)
            if not (done and referent.is_all):
                raise _NothingLeftError(
                    self._why(f"{referent.phrase!r} is not to be found or reached", referent.candidates)
                )
        return self._done(
            {referent: [name for name in self._meant(referent) if is_done(name)] for referent in referents}
        )

    def _look_for_people(self, referent: Referent, lost: Sequence[str]) -> Pursuit:
        place = next_place(lost, self.belief, [p for p in likely_places(lost, self.belief) if self._is_open(p)])
        if place is None:
            raise _NothingLeftError(self._why(f"{referent.phrase!r} is nowhere to be found", lost))
        return self._inspect(place, referent.phrase)

    # -- referents ----------------------------------------------------------------------------------------------------------

    def _meant(self, referent: Referent | None) -> tuple[str, ...]:
        """What a referent may still mean."""
        return () if referent is None else self.bindings.get(referent, referent.candidates)

    def _needed(self, referent: Referent) -> int:
        return len(self._meant(referent)) if referent.is_all else min(referent.count, len(self._meant(referent)))

    def _fitting(self, referent: Referent) -> tuple[str, ...]:
        """Candidates that are not known to differ from how the phrase describes them ("the clean mug")."""
        if referent in self.bindings or not referent.where:
            return self._meant(referent)
        is_change = self.task.type == "change_state" and self.task.state is not None
        changes = self.domain.kinds.pair_of(self.task.state or "") if is_change else None

        def differs(name: str, pair: str, value: str) -> bool:
            if self.belief.state(name, pair) in (None, value):
                return False
            return pair != changes or self.belief.state_changed(name, pair) < self.since

        return tuple(
            n for n in referent.candidates if not any(differs(n, pair, value) for pair, value in referent.where)
        )

    def _found(self, is_done: Callable[[str], bool]) -> dict[Referent, list[str]] | None:
        """Which candidates settle every object; None while one of them is open."""
        found: dict[Referent, list[str]] = {}
        for referent in self.task.objects:
            done = [name for name in self._fitting(referent) if is_done(name)]
            if referent.is_all:
                left = [name for name in self._fitting(referent) if name not in done and self._counts(name)]
                if not done or left:
                    return None
            elif len(done) < self._needed(referent):
                return None
            found[referent] = done if referent.is_all else done[: self._needed(referent)]
        return found

    def _counts(self, name: str) -> bool:
        """Whether one of "all" is still to be dealt with: it is there, or may still turn up."""
        return self._is_located(name) or any(self._is_open(place) for place, _ in self.belief.likely_places(name))

    def _missing(self, is_done: Callable[[str], bool]) -> list[str]:
        """The candidates of the first object that is not settled."""
        for referent in self.task.objects:
            left = [name for name in self._fitting(referent) if not is_done(name)]
            if len(self._fitting(referent)) - len(left) < self._needed(referent):
                return left
        return []

    def _bind(self, bound: Mapping[Referent, Sequence[str]]) -> Bindings:
        return {**self.bindings, **{referent: tuple(names) for referent, names in bound.items() if names}}

    # -- facts ----------------------------------------------------------------------------------------------------------------

    def _is_located(self, name: str) -> bool:
        if name in self.house.things:
            return self.belief.room_of(name) is not None
        return name not in self.house.people or self.belief.place_of(name) is not None

    def _is_there(self, name: str) -> bool:
        """Whether an object is where the task says, if it says a place."""
        return not self.task.places or is_at(name, self.wheres, self.belief)

    def _was_seen(self, name: str) -> bool:
        if name in self.house.things or name in self.house.people:
            return self.belief.seen(name) >= self.since
        return max(self.belief.seen(name), self.belief.visited(name)) >= self.since

    def _was_noted(self, predicate: str, *objects: str) -> bool:
        return self.belief.noted(Atom(predicate, objects)) > self.since

    def _asks_people(self) -> bool:
        names = [name for referent in self.task.objects for name in referent.candidates]
        return bool(names) and all(name in self.house.people for name in names)

    def _distance(self, name: str) -> int:
        room = self.belief.room_of(name)
        return room_distances(self.domain, self.belief.room).get(room, 99) if room is not None else 99

    # -- what comes out -----------------------------------------------------------------------------------------------------

    def _goal(self, roles: Mapping[str, str]) -> tuple[Atom, ...]:
        return self._atoms(self.task.type, roles)

    def _atoms(self, task_type: str, roles: Mapping[str, str]) -> tuple[Atom, ...]:
        filled = self.domain.goals.fill(task_type, roles, self.domain.has_type)
        return tuple(Atom(predicate, tuple(objects)) for predicate, *objects in filled)

    def _is_possible(self, goal: tuple[Atom, ...]) -> bool:
        return self.belief.given_up(goal, since=self.since) is None

    def _first_open(self, goals: Iterable[tuple[Atom, ...]]) -> tuple[Atom, ...] | None:
        return next((goal for goal in goals if goal and self._is_possible(goal)), None)

    def _bring_about(self, goals: Sequence[tuple[Atom, ...]], doing: str) -> Pursuit:
        goal = self._first_open(goals)
        if goal is None:
            raise _NothingLeftError(
                self._why(f"no way was found to {doing}", [n for g in goals for a in g for n in a.objects])
            )
        return self._ongoing(goal, doing)

    def _ongoing(self, goal: tuple[Atom, ...], doing: str) -> Pursuit:
        return Pursuit(PursuitStatus.ONGOING, goal, doing=doing, bindings=self.bindings)

    def _done(self, bound: Mapping[Referent, Sequence[str]]) -> Pursuit:
        return Pursuit(PursuitStatus.DONE, truth=True, bindings=self._bind(bound))

    def _why(self, summary: str, names: Iterable[str]) -> str:
        """The summary with what went wrong last with one of these."""
        reason = self.belief.last_reason(names)
        return f"{summary}: {reason}" if reason else summary

    def _why_not(self, referent: Referent, roles: Mapping[str, str]) -> str:
        names = (*self._meant(referent), *roles.values())
        is_known = any(self._is_located(name) for name in self._meant(referent))
        summary = (
            f"no way was found to do it with {referent.phrase!r}"
            if is_known
            else f"{referent.phrase!r} is nowhere to be found"
        )
        return self._why(summary, names)

    def _objects_phrase(self) -> str:
        return " and ".join(referent.phrase for referent in self.task.objects) or "it"

    def _phrase_of(self, names: Iterable[str]) -> str:
        wanted = set(names)
        phrases = [referent.phrase for referent in self.task.objects if wanted & set(referent.candidates)]
        return " and ".join(phrases) or self._objects_phrase()


_HANDLING = ("taking", "placing", "bringing", "change_state")
_INDEFINITE = frozenset(("a", "an", "any", "some", "anything", "something", "anybody", "anyone", "somebody", "someone"))


def _is_indefinite(referent: Referent) -> bool:
    """Whether a phrase asks for any one, not for a certain one."""
    return referent.phrase.lower().split(" ", 1)[0] in _INDEFINITE
