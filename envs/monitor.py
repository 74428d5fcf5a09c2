"""The judge of an episode: by the instruction's flow and the true world alone it says what was due and what was done.

It knows nothing of the agent. Where a phrase may mean several things, every consistent reading is followed at once: the
episode succeeds when one of them is carried out in full, and it is a violation only when it is one in all of them.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations, product
from typing import TYPE_CHECKING

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.bindings import Bindings, candidates, given_up, name_candidates, needed
from decomplex_bt.envs.evidence import Evidence, Record, places_in, true_room
from decomplex_bt.envs.feasibility import Assumed, Course, enter, find_cause, plan_course, plan_rest
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.means import is_means, is_on_the_way
from decomplex_bt.envs.outcomes import JUDGED_BY_ROW, goal_holds, outcomes
from decomplex_bt.envs.truth import Moment, Truth
from decomplex_bt.envs.verdict import Branch, Verdict, Violation
from decomplex_bt.flow import If, Node
from decomplex_bt.planning.ground_task import FINDING_OUT, HERE, GroundInstruction, GroundTask, Referent

if TYPE_CHECKING:
    from decomplex_bt.envs.world import Event

MOMENTUM = 4
"""Looks within which a robot under way, for which something else has just become due, may still roll on to where it was
going."""
MOST_READINGS = 64
"""Readings followed at once; beyond it the least advanced are dropped."""
_OK = Result.OK  # asking an enum takes ten times as long
_ON_REACHING = frozenset(("motion", "following"))
"""Types of tasks whose goal is where the robot is."""
_ON_DEEDS = JUDGED_BY_ROW - _ON_REACHING
"""Types of tasks whose goal is how the world is, whatever the robot was seen to do."""


@dataclass(frozen=True)
class Reading:
    """One consistent reading of the instruction, and how far it has come.

    `agenda`: what is still to come, the task due now first. `since`: the step at which that one became due, `room`
    where the robot was. `is_impossible`: the true world does not allow it. `moment`: the world as it was then, by which
    a condition is judged that finds something out. `tried`: the outcomes it was taken for in other readings.
    `untold`: what has come out by what the world is, which the robot has yet to find out for itself: conditions that
    fail, and what held before anything was done. `chosen`:
    phrases that a task has been done with, and that therefore mean one thing, whichever it was.
    """

    agenda: tuple[Node, ...]
    bindings: Bindings
    since: int = -1
    room: str = ""
    met: tuple[int, ...] = ()
    branches: tuple[Branch, ...] = ()
    is_impossible: bool = False
    moment: Moment | None = None
    tried: frozenset[tuple[bool, tuple[tuple[str, ...], ...]]] = frozenset()
    untold: tuple[int, ...] = ()
    chosen: tuple[Referent, ...] = ()

    @property
    def due(self) -> Node | None:
        return self.agenda[0] if self.agenda else None

    def of(self, truth: Truth) -> Reading:
        """The same reading, in another world."""
        if self.moment is None:
            return self
        other = object.__new__(Reading)  # every reset comes by, and `replace` takes ten times as long
        other.__dict__.update(self.__dict__, moment=self.moment.of(truth))
        return other


class Monitor:
    """Judges one episode. Make it when the world has been drawn, then `update` it once per control step."""

    def __init__(self, instruction: GroundInstruction, domain: Domain, truth: Truth) -> None:
        self.instruction = instruction
        self.domain = domain
        self.truth = truth
        self.record = Record()
        self.course: Course = plan_course(instruction, domain, truth)
        self.readings: tuple[Reading, ...] = (self._make_due(Reading(tuple(instruction.flow.nodes), {})),)
        self._ended: Reading | None = None
        self._violations: tuple[Violation, ...] = ()
        self.minds_leading = False
        self._view: Hashable = None
        self._watch: tuple[str, ...] = ()
        self.minds_position = True
        self._room = truth.room
        self._executed = tuple(instruction.task(node.task) for node, _ in instruction.flow.walk())
        self._has_following = any(task.type == "following" for task in self._executed)
        self._holds = self._goals_that_hold()
        self._after_deed: Mapping[int, bool] = {}
        self.verdict = self._judge()

    def again(self, truth: Truth) -> Monitor:
        """The judge of another episode, in which all that was asked of the truth so far has the same answers."""
        other = object.__new__(Monitor)
        other.__dict__.update(self.__dict__)
        other.truth, other.record = truth, self.record.copy()
        other.readings = tuple(reading.of(truth) for reading in self.readings)
        other._view = truth.view(self._watch)
        return other

    def start(self) -> Verdict:
        """Takes in the first look, before anything was done."""
        return self.update(None)

    def update(self, event: Event | None) -> Verdict:
        """Takes in one control step: the world as it is now, and the interaction that was tried, if any."""
        if self.verdict.is_over:
            return self.verdict
        self.record.begin(event)
        has_acted = event is not None and event.result is _OK
        if not has_acted and self._is_still():
            return self.verdict
        for reading in self.readings:
            self._look(reading)
        self._find_violations(event)
        self._advance()
        self._room = self.truth.room
        watch = tuple(dict.fromkeys(name for reading in self.readings for name in self._watched_by(reading)))
        if watch != self._watch:
            self._watch = watch
            self._view = self.truth.view(watch)
        self.verdict = self._judge()
        return self.verdict

    def finish(self) -> Verdict:
        """Takes in that the robot has finished: of what it was to do, a reading in which nothing is left counts."""
        if not self.verdict.is_over:
            self._ended = next((reading for reading in self.readings if reading.due is None), None)
            self.verdict = self._judge()
        return self.verdict

    def take_in(self, name: str) -> None:
        """Takes in that somebody else has moved a thing or opened a door: so it is from now on, and it is not the
        robot's doing."""
        if name in self.domain.house.things:  # before the robot does anything in a step, and maybe to where it is
            self._holds = self._goals_that_hold()
        for reading in self.readings:
            if reading.moment is not None:
                reading.moment.take_in(name)
        self._view = None

    def brace(self) -> None:
        """Takes in how things are just before the robot does something: what has come about since its last deed is no
        deed of its own, be it that somebody did it or that a thing was pushed along. But where it is, it drove to."""
        now = self._goals_that_hold()
        by_driving = {number: self._holds[number] for number in now if self._type_of(number) in _ON_REACHING}
        self._holds = {**now, **by_driving}

    def note_deed(self) -> None:
        """Takes in how things are right after the robot has done something, before anybody else does in that step."""
        now = self._goals_that_hold()
        self._after_deed = {number: holds for number, holds in now.items() if self._type_of(number) in _ON_DEEDS}

    def _type_of(self, number: int) -> str:
        return self.instruction.task(number).type

    def can_lie(self, thing: str, place: str) -> bool:
        """Whether what is still to come could be carried out as well if a thing lay at another place."""
        now, then = (Assumed(self.domain, self.truth, places) for places in ({}, {thing: place}))
        return not any(
            plan_rest(self.instruction, reading.agenda, reading.bindings, now).is_feasible
            and not plan_rest(self.instruction, reading.agenda, reading.bindings, then).is_feasible
            for reading in self.readings
        )

    def carried_out(self) -> tuple[list[tuple[GroundTask, bool]], Bindings, dict[str, str]]:
        """What was due and is settled, in order, each with its truth; what the phrases turned out to mean; and where
        people led the robot last."""
        best = self._best()
        false = {branch.task for branch in best.branches if branch.truth is False}
        tasks = [(self.instruction.task(number), number not in false) for number in best.met]
        led = {person: goal for person, (_, goal) in self.record.led.items() if goal is not None}
        return tasks, best.bindings, led

    def _is_still(self) -> bool:
        """Whether nothing has come into view that the judge could go by, since it last looked closely."""
        before, self._view = self._view, self.truth.view(self._watch)
        return self._view == before and not self.minds_leading and not self.minds_position

    # -- readings -----------------------------------------------------------------------------------------------------

    def _make_due(self, reading: Reading) -> Reading:
        """The reading with its next task become due: whether the true world allows it is settled here."""
        since = self.record.step
        room = self.truth.room
        bindings, moment, is_impossible = reading.bindings, None, False
        if reading.due is not None:
            task = self.instruction.task(reading.due.task)
            bindings = name_candidates(task, bindings, self.domain, self.truth)
            is_impossible = find_cause(task, bindings, self.domain, self.truth) is not None
            moment = self._moment(task, bindings) if isinstance(reading.due, If) else None
        return replace(
            reading,
            bindings=bindings,
            since=since,
            room=room,
            is_impossible=is_impossible,
            moment=moment,
            tried=frozenset(),
        )

    def _moment(self, task: GroundTask, bindings: Bindings) -> Moment | None:
        if task.type not in FINDING_OUT:
            return None
        names = (name for referent in task.referents() for name in candidates(referent, bindings))
        return Moment(self.domain, self.truth, names)

    def _advance(self) -> None:
        """Follows every reading as far as it goes; a reading that is carried out in full ends the episode."""
        pending, waiting = list(self.readings), []
        while pending:
            reading = pending.pop(0)
            stays, followers = (reading, []) if reading.due is None else self._follow(reading)
            pending.extend(followers)
            if stays is not None:
                waiting.append(stays)
        ended = (r for r in waiting if r.due is None and not any(_is_idler(r, other) for other in waiting))
        self._ended = self._ended or next(ended, None)
        self.readings = tuple(_without_twins(waiting))[:MOST_READINGS]
        due = (reading.due for reading in self.readings)
        self.minds_position = any(node is not None and self._minds_position(node.task) for node in due)

    def _minds_position(self, number: int) -> bool:
        """Whether a task may be done by being somewhere: motion, following, finding a room, and whatever a domain of
        one's own has."""
        task = self.instruction.task(number)
        if task.type in FINDING_OUT:
            return any(name in self.domain.house.rooms for sought in task.objects for name in sought.candidates)
        return task.type in _ON_REACHING or task.type not in JUDGED_BY_ROW

    def _follow(self, reading: Reading) -> tuple[Reading | None, list[Reading]]:
        """What a reading becomes in this step: itself, if the task due may still count otherwise, and its followers."""
        node = reading.due
        assert node is not None
        task = self.instruction.task(node.task)
        is_condition = isinstance(node, If)
        followers: list[Reading] = []
        is_settled = False
        if self._is_beyond_hope(task, reading, is_condition):
            untold = replace(reading, untold=(*reading.untold, task.number))
            return None, list(self._settle(untold, node, task.is_denied, given_up(task, reading.bindings)))
        evidence = self._evidence(reading)
        for outcome in outcomes(task, reading.bindings, evidence, is_condition=is_condition):
            key = (outcome.truth, tuple(candidates(referent, outcome.bindings) for referent in task.referents()))
            if key in reading.tried:
                continue
            reading = replace(reading, tried=reading.tried | {key})
            held_before = task.type not in FINDING_OUT and self.record.step <= max(reading.since, 0)
            follower = replace(reading, untold=(*reading.untold, task.number)) if held_before else reading
            followers.extend(self._settle(follower, node, outcome.truth, outcome.bindings))
            is_settled |= outcome.is_final
        return (None if is_settled else reading), followers

    def _is_beyond_hope(self, task: GroundTask, reading: Reading, is_condition: bool) -> bool:
        """Whether the world itself settles a condition: what cannot be done or is nowhere to be found is false, and
        true where that is what it asks (`GroundTask.is_denied`).

        Whether something is in the house at all has an answer, no, as a plain step too.
        """
        if task.type == "check_state":
            return task.state == HERE and not task.places and not self._are_here(task, reading.bindings)
        if not is_condition:
            return False
        if task.type == "searching":
            return reading.is_impossible and not task.places
        return reading.is_impossible

    def _are_here(self, task: GroundTask, bindings: Bindings) -> bool:
        """Whether as many as each phrase asks for are in the house."""

        def is_here(name: str) -> bool:
            return true_room(self.domain, self.truth, name) is not None

        among = {referent: candidates(referent, bindings) for referent in task.objects}
        return all(sum(map(is_here, names)) >= needed(referent, names) for referent, names in among.items())

    def _settle(self, reading: Reading, node: Node, truth: bool, bindings: Bindings) -> Iterator[Reading]:
        """What comes of a reading whose task due has come out as true or false."""
        branch, ahead = enter(node, truth)
        chosen = (*reading.chosen, *_chosen_with(self.instruction.task(node.task), truth))
        settled = replace(
            reading,
            agenda=(*ahead, *reading.agenda[1:]),
            bindings=bindings,
            met=(*reading.met, node.task),
            branches=(*reading.branches, *branch),
            chosen=tuple(dict.fromkeys(chosen)),
        )
        for one in self._taken_apart(settled):
            follower = self._make_due(one)
            self._look(follower)
            yield follower

    def _taken_apart(self, reading: Reading) -> Iterator[Reading]:
        """The reading or, where something is to be found out about what an earlier task was done with, one for each
        thing that it may have been: of the cupboard that was closed it is asked what is in it, not of both."""
        due = None if reading.due is None else self.instruction.task(reading.due.task)
        asked = due.referents() if due is not None and due.type in FINDING_OUT else ()
        referents = [referent for referent in reading.chosen if referent in asked]
        among = [(candidates(referent, reading.bindings), referent.count) for referent in referents]
        for choice in product(*(combinations(names, min(count, len(names))) for names, count in among)):
            yield replace(reading, bindings={**reading.bindings, **dict(zip(referents, choice, strict=True))})

    def _evidence(self, reading: Reading) -> Evidence:
        return Evidence(self.domain, reading.moment or self.truth, self.record, reading.since)

    def _look(self, reading: Reading) -> None:
        """Takes down what bears on the task due."""
        self.record.look(self.truth, self._watched_by(reading))

    def _watched_by(self, reading: Reading) -> dict[str, None]:
        """All that is looked at for the task due, in order."""
        names: dict[str, None] = {}
        if reading.due is not None:
            task = self.instruction.task(reading.due.task)
            for referent in task.referents():
                for name in candidates(referent, reading.bindings):
                    names.update(dict.fromkeys(self._watched(name)))
            if any(name in self.domain.house.people for referent in task.objects for name in referent.candidates):
                names.update(dict.fromkeys(self._floors(task)))
        return names

    def _watched(self, name: str) -> tuple[str, ...]:
        """What is looked at for a candidate: of a room its places, with a thing also what it lies on or in."""
        house = self.domain.house
        if name in house.rooms:
            return places_in(self.domain, name)
        place = self.truth.place(name) if name in house.things else None
        return (name, place) if place is not None and self.domain.room_of(place) is not None else (name,)

    def _floors(self, task: GroundTask) -> Iterator[str]:
        """The floors of the rooms of the places that a task names, on which people stand."""
        for referent in task.places:
            rooms = (self.domain.room_of(name) for name in referent.candidates)
            yield from (self.domain.house.floor_of(room) for room in rooms if room is not None)

    # -- violations ---------------------------------------------------------------------------------------------------

    def _find_violations(self, event: Event | None) -> None:
        """Ends every reading in which a task that is not due was brought about by no means to the one that is."""
        has_acted = event is not None and event.result is Result.OK
        if has_acted and event is not None and event.interaction is Interaction.SAY and event.goal is not None:
            self.minds_leading = self._has_following
        if not has_acted and self.truth.room == self._room and not self.minds_leading:
            return
        before, self._holds = self._holds, self._goals_that_hold()
        by_others = {number: True for number, holds in self._after_deed.items() if self._holds[number] and not holds}
        before, self._after_deed = {**before, **by_others}, {}
        faults = [(reading, self._fault(reading, event if has_acted else None, before)) for reading in self.readings]
        left = tuple(reading for reading, fault in faults if fault is None)
        found = [(reading, fault) for reading, fault in faults if fault is not None]
        if found and not left:
            self._ended, fault = max(found, key=lambda pair: len(pair[0].met))
            self._violations = (fault,)
        self.readings = left

    def _fault(self, reading: Reading, event: Event | None, before: Mapping[int, bool]) -> Violation | None:
        """The task not due that this step brought about in a reading, if any."""
        due = self.instruction.task(reading.due.task) if reading.due is not None else None
        pursued = [self.instruction.task(number) for number in reading.untold] + ([due] if due is not None else [])
        pursued += [task.question for task in pursued if task.question is not None]
        is_excused = event is None or due is None
        if event is not None and not is_excused:
            is_excused = any(is_means(event, goal, reading.bindings, self.domain) for goal in pursued)
        for task in self.instruction.tasks:
            if due is None or task.number == due.number or task.number in reading.met or task.number not in before:
                continue
            if task.type in _ON_REACHING:
                if self._arrived(task, before) and not self._excuses_arrival(reading, pursued):
                    return Violation(task.number, due.number, self._blame(task, due))
            elif not is_excused and event is not None and self._brought_about(task, event, before):
                return Violation(task.number, due.number, self._blame(task, due))
        return None

    def _brought_about(self, task: GroundTask, event: Event, before: Mapping[int, bool]) -> bool:
        if task.type == "informing":
            is_said = event.interaction is Interaction.SAY and event.goal is None
            return is_said and any(event.target in referent.candidates for referent in task.recipients)
        return self._holds[task.number] and not before[task.number]

    def _arrived(self, task: GroundTask, before: Mapping[int, bool]) -> bool:
        if task.type == "following" and not self.minds_leading:
            return False
        return self._holds[task.number] and not before[task.number]

    def _excuses_arrival(self, reading: Reading, pursued: list[GroundTask]) -> bool:
        """Whether the robot is where it is on behalf of what it pursues, or still rolling when that became due."""
        is_rolling = self.record.step - reading.since <= MOMENTUM and self._room == reading.room
        return is_rolling or any(self._serves(task, reading) for task in pursued)

    def _serves(self, due: GroundTask, reading: Reading) -> bool:
        """Whether it may serve the task due that the robot is in the room it is in."""
        return due.type == "following" or is_on_the_way(
            self.truth.room, reading.room, due, reading.bindings, self.domain, self.truth
        )

    def _goals_that_hold(self) -> dict[int, bool]:
        """For every task that is executed, whether what it is to bring about holds, for any of its candidates."""
        evidence = Evidence(self.domain, self.truth, self.record, -1)
        return {task.number: goal_holds(task, {}, evidence) for task in self._executed}

    def _blame(self, task: GroundTask, due: GroundTask) -> str:
        return f"task {task.number} ({task.phrase}) was brought about while task {due.number} ({due.phrase}) was due"

    # -- the verdict --------------------------------------------------------------------------------------------------

    def _judge(self) -> Verdict:
        best = self._best()
        is_success = best.due is None and not self._violations
        total = len(self.course.tasks)
        return Verdict(
            is_success=is_success,
            met=total if is_success else min(len(best.met), total - 1),
            total=total,
            branches=(*best.branches, *self._undecided(best)),
            violations=self._violations,
            unsettled=best.due.task if best.due is not None else None,
        )

    def _best(self) -> Reading:
        return self._ended or max(self.readings, key=lambda reading: (reading.due is not None, len(reading.met)))

    def _undecided(self, reading: Reading) -> Iterator[Branch]:
        """The condition that was reached and that nothing has decided yet."""
        if isinstance(reading.due, If):
            yield Branch(reading.due.task, None, None)


def _chosen_with(task: GroundTask, truth: bool) -> Iterator[Referent]:
    """The phrases of a task that mean one thing from when it has come out: that with which it was done or found so."""
    is_of_value = task.type == "check_state" and task.state != HERE
    if task.type not in FINDING_OUT:
        referents = task.referents() if truth else ()
    else:
        referents = tuple(r for r in task.objects if truth != task.is_denied or (is_of_value and not r.is_any))
    yield from (referent for referent in referents if not referent.is_all)


def _is_idler(one: Reading, other: Reading) -> bool:
    """Whether nothing is to be done in one reading because a condition came out otherwise than in another, in which
    something is: "if the window is open, close it", of which one is open and one is not."""
    if not one.branches or one.branches[-1].taken is not None or one.branches[-1].task != one.met[-1]:
        return False
    last = one.branches[-1]
    is_opposed = any(branch.task == last.task and branch.truth != last.truth for branch in other.branches)
    return is_opposed and not other.is_impossible


def _without_twins(readings: list[Reading]) -> Iterator[Reading]:
    """The readings, the most advanced first, without those that expect the very same as another."""
    seen: list[Reading] = []
    for reading in sorted(readings, key=lambda reading: -len(reading.met)):
        if not any(_expects_the_same(reading, other) for other in seen):
            seen.append(reading)
            yield reading


def _expects_the_same(one: Reading, other: Reading) -> bool:
    return (
        one.agenda == other.agenda
        and one.since == other.since
        and one.tried == other.tried
        and one.branches == other.branches
        and dict(one.bindings) == dict(other.bindings)
    )
