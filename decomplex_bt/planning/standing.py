"""How a task stands: the values that a pursuit gives, and what all kinds of tasks ask of task, belief and bindings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum

from decomplex_bt.domain.nouns import be
from decomplex_bt.planning.abilities import holds_things, is_fixed, runs_shut
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.ground_task import FINDING_OUT, GroundTask, Referent
from decomplex_bt.planning.others import without_others
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.problem import fact_name
from decomplex_bt.planning.whereabouts import is_at, likely_places, places_of, room_distances

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
    success and FAILED failure. `gave_up` (FAILED): a planner did, on what may be possible; there is no truth then.
    `doing`: in words what is being done now, for feedback. `bindings` replaces the bindings that were handed in.
    """

    status: PursuitStatus
    goal_atoms: tuple[Atom, ...] = ()
    truth: bool | None = None
    reason: str = ""
    gave_up: bool = False
    doing: str = ""
    bindings: Bindings = field(default_factory=dict)


class NothingLeftError(Exception):
    """Nothing is left to try; `truth` is what the task is as a condition."""

    def __init__(self, reason: str, truth: bool | None = False) -> None:
        super().__init__(reason)
        self.truth = truth


class Standing:
    """One task at one moment: what its phrases mean, what was seen since it became due, what can still be tried."""

    def __init__(self, task: GroundTask, belief: Belief, bindings: Bindings, since: int) -> None:
        self.task, self.belief, self.bindings, self.since = task, belief, bindings, max(since, 0)
        self.domain = belief.domain
        self.house = belief.domain.house
        self.wheres = self._places_of([self._meant(referent) for referent in task.places])
        lost = self._lost_landmarks() if task.type in FINDING_OUT else ()
        self.theres = self.wheres if not lost else self._known_wheres(lost)
        self._refused: dict[tuple[Atom, ...], None] = {}  # the goals asked about that were given up, in order

    # -- referents ----------------------------------------------------------------------------------------------------

    def _meant(self, referent: Referent | None) -> tuple[str, ...]:
        """What a referent may still mean."""
        if referent is None:
            return ()
        names = self.bindings.get(referent, referent.candidates)
        return without_others(referent, names, self.bindings) if referent.others else names

    def _needed(self, referent: Referent) -> int:
        """How many of its candidates are needed."""
        return len(self._meant(referent)) if referent.is_all else referent.count

    def _fitting(self, referent: Referent) -> tuple[str, ...]:
        """Candidates that are not known to differ from how the phrase describes them ("the clean mug"), and of one that
        is to be changed, not to be so already."""
        names = self._described(referent)
        if referent in self.bindings or not self.task.seeks_change(referent):
            return names
        return self._to_change(names) or names

    def _to_change(self, names: Sequence[str]) -> tuple[str, ...]:
        """Those that are not known to have been as the task wants them before it became due, of those that may turn up;
        of those that lie where the task says, if any does."""
        value = self.task.state or ""
        pair = self.domain.kinds.pair_of(value)
        there = [name for name in names if self._is_there(name)] if self.task.places else []

        def is_to_change(name: str) -> bool:
            is_so = self.belief.state(name, pair) == value
            pairs = [pair]
            if runs_shut(name, value, self.domain):
                is_so &= self.belief.state(name, "aperture") != "open"
                pairs.append("aperture")
            was_so = is_so and max(self.belief.state_changed(name, each) for each in pairs) < self.since
            return not was_so and self._counts(name)

        return tuple(filter(is_to_change, there or names))

    def _described(self, referent: Referent) -> tuple[str, ...]:
        """Candidates that are not known to differ from how the phrase describes them."""
        if referent in self.bindings or not referent.where:
            return self._meant(referent)
        is_change = self.task.type == "change_state" and self.task.state is not None
        changes = self.domain.kinds.pair_of(self.task.state or "") if is_change else None

        def differs(name: str, pair: str, value: str) -> bool:
            if self.belief.state(name, pair) in (None, value):
                return False
            return pair != changes or self.belief.state_changed(name, pair) < self.since

        return tuple(
            n for n in self._meant(referent) if not any(differs(n, pair, value) for pair, value in referent.where)
        )

    def _found(self, is_done: Callable[[str], bool]) -> dict[Referent, list[str]] | None:
        """Which candidates settle every object; None while one of them is open."""
        found: dict[Referent, list[str]] = {}
        for referent in self.task.objects:
            done = [name for name in self._fitting(referent) if is_done(name)]
            if referent.is_all:
                left = [name for name in self._fitting(referent) if name not in done and self._counts(name)]
                if left or not (done or self.task.may_be_none(referent)):
                    return None
            elif len(done) < self._needed(referent):
                return None
            found[referent] = done if referent.is_all else done[: self._needed(referent)]
        return found

    def _counts(self, name: str) -> bool:
        """Whether one of "all" is still to be dealt with: it is there, or may still turn up."""
        return self._is_located(name) or bool(self._open_for([name]))

    def _missing(self, is_done: Callable[[str], bool]) -> list[str]:
        """The candidates of the first object that is not settled."""
        for referent in self.task.objects:
            left = [name for name in self._fitting(referent) if not is_done(name)]
            if len(self._fitting(referent)) - len(left) < self._needed(referent):
                return left
        return []

    def _bind(self, bound: Mapping[Referent, Sequence[str]]) -> Bindings:
        return {**self.bindings, **{referent: tuple(names) for referent, names in bound.items() if names}}

    # -- facts --------------------------------------------------------------------------------------------------------

    def _is_located(self, name: str) -> bool:
        if name in self.house.things:
            return self.belief.room_of(name) is not None
        return name not in self.house.people or self.belief.place_of(name) is not None

    def _is_there(self, name: str) -> bool:
        """Whether an object is where the task says, if it says a place."""
        return not self.task.places or is_at(name, self.theres, self.belief)

    def _is_on_map(self) -> bool:
        """Whether the map tells whether the objects are where the task says: all of it is fixed."""
        names = [name for referent in (*self.task.objects, *self.task.places) for name in referent.candidates]
        return bool(self.task.objects) and all(is_fixed(name, self.domain) for name in names)

    def _lost_landmarks(self) -> tuple[str, ...]:
        """The things and people beside whom the task looks ("under the pillow", "with Tom") that are not found yet."""
        names = (name for referent in self.task.places for name in self._meant(referent))
        moved = (*self.house.things, *self.house.people)
        return tuple(name for name in names if name in moved and self.belief.place_of(name) is None)

    def _known_wheres(self, lost: Sequence[str]) -> tuple[str, ...]:
        """The places that the task names for sure: what lies where a thing may be need not lie beside it."""
        return self._places_of([[n for n in self._meant(r) if n not in lost] for r in self.task.places])

    def _places_of(self, groups: Iterable[Iterable[str]]) -> tuple[str, ...]:
        is_of_people = self._asks_people()
        return tuple(place for names in groups for place in places_of(names, self.belief, for_people=is_of_people))

    def _was_seen(self, name: str) -> bool:
        """Whether an entity was in view; a room is found by being in it, an opening in a wall by being at it."""
        if self._is_space(name):
            return self.belief.visited(name) >= self.since
        if not is_fixed(name, self.domain):
            return self.belief.seen(name) >= self.since
        states = (self.belief.state_seen(name, pair) for pair in self.domain.kind(name).states)
        return max((self.belief.inspected(name), *states)) >= self.since

    def _is_space(self, name: str) -> bool:
        """Whether it is a room or an opening without a door, which one is in and does not see."""
        doorway = self.house.doorways.get(name)
        return name in self.house.rooms or (doorway is not None and doorway.kind is None)

    def _was_noted(self, predicate: str, *objects: str) -> bool:
        return self.belief.noted(Atom(predicate, objects)) > self.since

    def _asks_people(self) -> bool:
        asked = self.task.told_there() or self.task.objects
        names = [name for referent in asked for name in referent.candidates]
        return bool(names) and all(name in self.house.people for name in names)

    def _distance(self, name: str) -> int:
        room = self.belief.room_of(name)
        return room_distances(self.domain, self.belief.room).get(room, 99) if room is not None else 99

    def _inspected_goal(self, place: str) -> tuple[Atom, ...]:
        """To have looked at a place, of a room at its floor, to have seen what holds nothing, or to be at a person."""
        if place in self.house.rooms:
            place = self.house.floor_of(place)
        if place in self.house.people:
            return (Atom("at", (place,)),)
        if not holds_things(place, self.domain):
            return self._seen_goal(place)
        return self._atoms("searching", {"location": place})

    def _seen_goal(self, name: str) -> tuple[Atom, ...]:
        """To have what is fixed in view, which its states tell, or what lies there; to be in a room, at an opening."""
        if self._is_space(name):
            return self._atoms("motion", {"goal": name})
        states = self.domain.kind(name).states
        if states:
            return (Atom("known", (fact_name(states[0], name),)),)
        return self._atoms("searching", {"location": name})

    def _is_open(self, place: str | None) -> bool:
        """Whether a place can still be looked at: not inspected since the task became due, and not given up."""
        return place is not None and not self._was_inspected(place) and self._is_possible(self._inspected_goal(place))

    def _open_for(self, names: Sequence[str]) -> list[str]:
        """The places where one of these may be that can still be looked at, likeliest of the first first.

        Those inspected before the last sight of what has been moved since are among them.
        """
        lost = [name for name in names if self.belief.place_of(name) is None]
        sight = max((self.belief.seen(name) for name in lost), default=0)

        def is_open(place: str) -> bool:
            is_stale = holds_things(place, self.domain) and self.belief.inspected(place) < sight
            return self._is_open(place) or (is_stale and self._is_possible(self._inspected_goal(place)))

        return [place for place in likely_places(names, self.belief) if is_open(place)]

    def _was_inspected(self, place: str) -> bool:
        if place in self.house.people:
            return self.belief.visited(place) >= self.since
        if not holds_things(place, self.domain):
            return self._was_seen(place)
        return self.belief.inspected(place) >= self.since

    # -- what comes out -----------------------------------------------------------------------------------------------

    def _goal(self, roles: Mapping[str, str]) -> tuple[Atom, ...]:
        return self._atoms(self.task.type, roles)

    def _atoms(self, task_type: str, roles: Mapping[str, str]) -> tuple[Atom, ...]:
        filled = self.domain.goals.fill(task_type, roles, self.domain.has_type)
        return tuple(Atom(predicate, tuple(objects)) for predicate, *objects in filled)

    def _is_possible(self, goal: tuple[Atom, ...]) -> bool:
        if self.belief.given_up(goal, since=self.since) is None:
            return True
        self._refused[goal] = None
        return False

    def _unanswered(self) -> str | None:
        """What a planner gave up on of what was still to be tried, and why; None where all that failed had to fail.

        That no plan was found in time says nothing of whether there is one.
        """
        open_goals = {
            goal: reason for goal in self._refused if (reason := self.belief.unanswered(goal, since=self.since))
        }
        if not open_goals:
            return None
        goal, reason = next(iter(open_goals.items()))
        more = f" and {len(open_goals) - 1} more" if len(open_goals) > 1 else ""
        return f"the planner gave up on {' '.join(map(str, goal))}{more}: {reason}"

    def _first_open(self, goals: Iterable[tuple[Atom, ...]]) -> tuple[Atom, ...] | None:
        return next((goal for goal in goals if goal and self._is_possible(goal)), None)

    def _bring_about(self, goals: Sequence[tuple[Atom, ...]], doing: str) -> Pursuit:
        goal = self._first_open(goals)
        if goal is None:
            raise NothingLeftError(
                self._why(f"no way was found to {doing}", [n for g in goals for a in g for n in a.objects])
            )
        return self._ongoing(goal, doing)

    def nothing_left(self, error: NothingLeftError) -> Pursuit:
        """The failure of a task for which nothing is left to try; neither true nor false where a planner gave up."""
        unanswered = self._unanswered()
        if unanswered is None:
            return Pursuit(PursuitStatus.FAILED, truth=error.truth, reason=str(error), bindings=self.bindings)
        return Pursuit(PursuitStatus.FAILED, reason=unanswered, gave_up=True, bindings=self.bindings)

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
        known = sum(map(self._is_located, self._fitting(referent)))
        is_known = known >= (1 if referent.is_all else referent.count)
        is_other = bool(referent.where) and any(map(self._is_located, self._meant(referent)))
        summary = (
            f"no way was found to do it with {referent.phrase!r}"
            if is_known
            else f"{referent.phrase!r} {be(referent.phrase)} nowhere to be found{', only what is not so' * is_other}"
        )
        return self._why(summary, names)

    def _objects_phrase(self) -> str:
        return " and ".join(referent.phrase for referent in self.task.objects) or "it"

    def _phrase_of(self, names: Iterable[str]) -> str:
        wanted = set(names)
        phrases = [referent.phrase for referent in self.task.objects if wanted & set(referent.candidates)]
        return " and ".join(phrases) or self._objects_phrase()
