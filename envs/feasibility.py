"""Whether an instruction can be carried out in a true world by one who knows everything, and if not, why.

Exact and without a planner: in this domain every room, door and container is open to the robot, nothing is used up and
every step can be undone, so that a task has a plan if and only if its things are in the house, its people at home, a
working device there for what it asks, and its places within reach, those at which its things lie as well. A test holds
this against the planner.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice, product
from typing import Literal

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.bindings import Bindings, candidates, given_up, name_candidates, needed
from decomplex_bt.envs.evidence import BEFORE, Evidence, Record, holds_things, is_as_ordered, is_there, true_room
from decomplex_bt.envs.outcomes import outcomes
from decomplex_bt.envs.reach import is_reachable
from decomplex_bt.envs.truth import ROBOT, Truth
from decomplex_bt.envs.verdict import Branch, Cause, CauseKind
from decomplex_bt.flow import If, Node
from decomplex_bt.planning.abilities import is_fixed, runs_shut, wipers_of
from decomplex_bt.planning.ground_task import FINDING_OUT, HERE, GroundInstruction, GroundTask, Referent

MOST_READINGS = 32
"""Ways to take a task's phrases that are tried at most; two candidates for each of five phrases."""


@dataclass(frozen=True, slots=True)
class Course:
    """How an instruction goes in a world for one who knows everything.

    `cause`: why it cannot be carried out, None if it can. `tasks`: all tasks and conditions that come due, in order, up
    to the one that cannot be done. `branches`: what the conditions lead to.
    """

    cause: Cause | None = None
    tasks: tuple[int, ...] = ()
    branches: tuple[Branch, ...] = ()

    @property
    def is_feasible(self) -> bool:
        return self.cause is None


def plan_course(instruction: GroundInstruction, domain: Domain, truth: Truth) -> Course:
    """The course of an instruction from this moment of the true world; the first feasible reading of its phrases."""
    return plan_rest(instruction, tuple(instruction.flow.nodes), {}, Assumed(domain, truth))


def find_cause(task: GroundTask, bindings: Bindings, domain: Domain, truth: Truth) -> Cause | None:
    """Why a task cannot be done whatever the robot tries; None if it can.

    A search that names places can always be done; so can a check of presence, or of how something is that is said to be
    somewhere, whose answer is then no.
    """
    result = _possible(task, bindings, domain, truth)
    return result if isinstance(result, Cause) else None


def feasible_bindings(task: GroundTask, bindings: Bindings, domain: Domain, truth: Truth) -> Bindings:
    """The bindings with what a task is to be done with narrowed to what it can be done with.

    As they are where it cannot be done at all; of a phrase that means all of something, nothing is left out.
    """
    result = _possible(task, bindings, domain, truth)
    if isinstance(result, Cause):
        return bindings
    able = {referent: names for referent, names in result.items() if not referent.is_all}
    return {**bindings, **{r: names for r, names in able.items() if len(names) < len(candidates(r, bindings))}}


# -- one task ---------------------------------------------------------------------------------------------------------


def _possible(task: GroundTask, bindings: Bindings, domain: Domain, truth: Truth) -> Bindings | Cause:
    """The bindings narrowed to the candidates with which the task can be done, or why there are none."""
    narrowed = dict(bindings)
    for role, referent in _roles(task):
        among = candidates(referent, bindings)
        need = needed(referent, among, task)
        if len(among) < need:
            return _too_few(referent, among, task, domain, truth)
        why = {name: _obstacle(domain, truth, task, role, name, bindings) for name in among}
        able = tuple(name for name in among if why[name] is None)
        if len(able) < need:
            kind, entity = next(found for name in among if (found := why[name]) is not None)
            return Cause(kind, entity, task.number)
        narrowed[referent] = able
    return narrowed


def _too_few(referent: Referent, among: Sequence[str], task: GroundTask, domain: Domain, truth: Truth) -> Cause:
    """Why no more than these are what a phrase means: the others are not in the house, or not as the phrase says."""
    others = [name for name in referent.candidates if name not in among]
    if others[0] in domain.house.people:
        return Cause("person out", others[0], task.number)
    is_otherwise = any(true_room(domain, truth, name) is not None for name in others)
    return Cause("thing nowhere", referent.phrase if is_otherwise else others[0], task.number)


def _roles(task: GroundTask) -> Iterator[tuple[str, Referent]]:
    """The referents without which the task cannot be done, each with what is asked of it."""
    if task.type == "check_state" and (task.state == HERE or task.places):
        yield from (("place", place) for place in task.places)
        return
    if task.type == "searching" and task.places:
        yield from (("place", place) for place in task.places)
        return
    yield from (("object", referent) for referent in task.objects)
    yield from (("recipient", referent) for referent in task.recipients)
    if task.goal is not None and not task.recipients:
        yield "goal", task.goal


def _obstacle(
    domain: Domain, truth: Truth, task: GroundTask, role: str, name: str, bindings: Bindings
) -> tuple[CauseKind, str] | None:
    """Why a candidate will not do in its role; None if it will."""
    house = domain.house
    if name in house.people:
        return None if truth.place(name) is not None else ("person out", name)
    if name in house.things and truth.place(name) is None:
        return "thing nowhere", name
    far = _out_of_reach(domain, truth, task, name)
    if far is not None and not _is_done(domain, truth, task, role, name, bindings):
        return "place not reachable", far
    if name in house.things:
        return _state_obstacle(domain, truth, name, task) if _brings_state(task, role) else None
    if role == "object" and task.type in ("taking", "placing", "bringing"):
        return "goal not possible", name
    is_put_there = role == "goal" and task.type in ("placing", "bringing")
    if is_put_there and name not in house.rooms and not holds_things(domain, name):
        return "goal not possible", name
    return _state_obstacle(domain, truth, name, task) if _brings_state(task, role) else None


def _out_of_reach(domain: Domain, truth: Truth, task: GroundTask, name: str) -> str | None:
    """The place that the robot cannot get to for the task: this one, or that at which this thing lies. None if it can.

    A thing that is only to be found or looked at may be seen from afar, unless a door is closed before it.
    """
    is_thing = name in domain.house.things
    place = truth.place(name) if is_thing else name
    if place is None or not is_fixed(place, domain) or is_reachable(domain, place):
        return None
    is_in_sight = is_thing and task.type in FINDING_OUT and truth.state(place, "aperture") != "closed"
    return None if is_in_sight else place


def _is_done(domain: Domain, truth: Truth, task: GroundTask, role: str, name: str, bindings: Bindings) -> bool:
    """Whether a candidate is as the task wants it already, so that the robot need not get to it."""
    if _brings_state(task, role):
        return is_as_ordered(domain, truth, name, task.state)
    if task.type not in ("placing", "bringing") or task.goal is None or task.recipients:
        return False
    if role == "object":
        return any(is_there(domain, truth, name, goal) for goal in candidates(task.goal, bindings))
    among = {referent: candidates(referent, bindings) for referent in task.objects}
    there = {r: sum(is_there(domain, truth, thing, name) for thing in names) for r, names in among.items()}
    return all(there[referent] >= needed(referent, names, task) for referent, names in among.items())


def _brings_state(task: GroundTask, role: str) -> bool:
    return task.type == "change_state" and role == "object"


def _state_obstacle(domain: Domain, truth: Truth, name: str, task: GroundTask) -> tuple[CauseKind, str] | None:
    """Why an entity cannot be brought into the state of a task; None if it can, or is in it."""
    value = task.state
    assert value is not None
    kind = domain.kind(name)
    try:
        pair = domain.kinds.pair_of(value)
    except KeyError:
        return "goal not possible", name
    if pair not in kind.states:
        return "goal not possible", name
    if truth.state(name, pair) == value:
        return None
    if pair == "power":
        return ("device broken", name) if value == "on" and truth.is_broken(name) else None
    if pair == "aperture":
        return None
    if name not in domain.house.things:
        return _place_state_obstacle(domain, truth, name, value, task)
    return _device_obstacle(domain, truth, name, task)


def _place_state_obstacle(
    domain: Domain, truth: Truth, name: str, value: str, task: GroundTask
) -> tuple[CauseKind, str] | None:
    """A place is emptied by hand, and wiped with a thing that wipes it."""
    if value == "empty":
        return None
    tools = wipers_of(name, domain) if value == "clean" else ()
    if not tools:
        return "goal not possible", name
    here = [tool for tool in tools if truth.place(tool) is not None]
    if not here:
        return "thing nowhere", tools[0]
    far = [_out_of_reach(domain, truth, task, tool) for tool in here]
    return None if None in far else ("place not reachable", str(far[0]))


def _device_obstacle(domain: Domain, truth: Truth, thing: str, task: GroundTask) -> tuple[CauseKind, str] | None:
    """A thing needs a place that heats, cools, cleans, fills or empties it, in reach and in order."""
    useful = task.devices(thing, domain)
    if not useful:
        return "goal not possible", thing
    reachable = [place for place in useful if is_reachable(domain, place)]
    if not reachable:
        return "place not reachable", useful[0]
    return None if any(not truth.is_broken(place) for place in reachable) else ("device broken", reachable[0])


# -- the whole course -------------------------------------------------------------------------------------------------


def plan_rest(instruction: GroundInstruction, agenda: Sequence[Node], bindings: Bindings, world: Assumed) -> Course:
    """The course of what is still to come: the first without an obstacle, else that of the first reading."""
    if not agenda:
        return Course()
    node, rest = agenda[0], tuple(agenda[1:])
    task = instruction.task(node.task)
    failed: Course | None = None
    bindings = name_candidates(task, bindings, world.domain, world)
    for truth, bound, after in _readings(task, bindings, world, is_condition=isinstance(node, If)):
        if isinstance(truth, Cause):
            undecided = (Branch(task.number, None, None),) if isinstance(node, If) else ()
            course = Course(truth, (task.number,), undecided)
        else:
            branch, ahead = enter(node, truth)
            course = plan_rest(instruction, (*ahead, *rest), bound, after)
            course = Course(course.cause, (task.number, *course.tasks), (*branch, *course.branches))
        if course.is_feasible:
            return course
        failed = failed or course
    assert failed is not None
    return failed


def enter(node: Node, truth: bool) -> tuple[tuple[Branch, ...], tuple[Node, ...]]:
    """The branch that a settled node leads to, as a record of it (none for a plain task) and as what comes next."""
    if not isinstance(node, If):
        return (), ()
    ahead = node.then if truth else node.orelse
    taken: Literal["then", "else"] | None = ("then" if truth else "else") if ahead else None
    return (Branch(node.task, truth, taken),), ahead


def _readings(
    task: GroundTask, bindings: Bindings, world: Assumed, *, is_condition: bool
) -> Iterator[tuple[bool | Cause, Bindings, Assumed]]:
    """What the task comes to in a world that is known: its truth (or why it has none), and the world afterwards."""
    possible = _possible(task, bindings, world.domain, world)
    if task.type in FINDING_OUT:
        if isinstance(possible, Cause):
            is_absence = task.type == "searching" and is_condition and not task.places
            yield (False if is_absence else possible), bindings, world
            return
        found = outcomes(task, bindings, Omniscient(world.domain, world), is_condition=is_condition)
        yield from ((outcome.truth, outcome.bindings, world) for outcome in found)
        if not found:
            yield task.is_denied, bindings, world
        return
    if isinstance(possible, Cause):
        yield (False if is_condition else possible), given_up(task, bindings), world
        return
    for bound in islice(_choices(task, possible, world), MOST_READINGS):
        yield True, bound, world.after(task, bound)


def _choices(task: GroundTask, possible: Bindings, world: Assumed) -> Iterator[Bindings]:
    """Ways to settle on as many of the candidates as each phrase asks for; those that are so already come first."""
    referents = [referent for _, referent in _roles(task)]
    options: list[list[tuple[str, ...]]] = []
    for referent in referents:
        among = candidates(referent, possible)
        if task.type == "change_state":
            among = tuple(sorted(among, key=lambda name: not is_as_ordered(world.domain, world, name, task.state)))
        need = needed(referent, among, task)
        options.append([among[i : i + need] for i in range(len(among) - need + 1)])
    for choice in product(*options):
        yield {**possible, **dict(zip(referents, choice, strict=True))}


@dataclass(frozen=True)
class Assumed:
    """The true world with the effects of tasks that are assumed to be done. Implements `Truth`, but sees nothing."""

    domain: Domain
    truth: Truth
    places: Mapping[str, str | None] = field(default_factory=dict)
    states: Mapping[tuple[str, str], str] = field(default_factory=dict)

    @property
    def room(self) -> str:
        return self.truth.room

    def view(self, names: tuple[str, ...]) -> None:
        return None

    def is_near(self, name: str) -> bool:
        return False

    def place(self, name: str) -> str | None:
        return self.places[name] if name in self.places else self.truth.place(name)

    def state(self, name: str, pair: str) -> str | None:
        return self.states.get((name, pair)) or self.truth.state(name, pair)

    def is_broken(self, name: str) -> bool:
        return self.truth.is_broken(name)

    def is_seen(self, name: str) -> bool:
        return False

    def is_inspected(self, place: str) -> bool:
        return False

    def after(self, task: GroundTask, bindings: Bindings) -> Assumed:
        """The world once a task is done with the first of what its phrases mean."""
        things = [name for referent in task.objects for name in candidates(referent, bindings)]
        where = next(iter(candidates(task.target, bindings)), None) if task.target is not None else None
        if task.type == "taking":
            return self._moved(things, ROBOT)
        if task.type in ("placing", "bringing") and where is not None:
            return self._moved(things, self._place_at(where))
        if task.type == "following" and where is not None:
            return self._moved(things, self.domain.room_of(where) or where)
        if task.type == "change_state" and task.state is not None:
            pair = self.domain.kinds.pair_of(task.state)
            changed = {(name, pair): task.state for name in things}
            shut = (name for name in things if runs_shut(name, task.state, self.domain))
            changed |= dict.fromkeys(((name, "aperture") for name in shut), "closed")
            return replace(self, states={**self.states, **changed})
        return self

    def _moved(self, names: Sequence[str], place: str | None) -> Assumed:
        return replace(self, places={**self.places, **dict.fromkeys(names, place)})

    def _place_at(self, where: str) -> str | None:
        """Where a thing lies that was brought to a place, a room (its floor) or a thing (beside it)."""
        house = self.domain.house
        if where in house.rooms:
            return house.floor_of(where)
        return self.place(where) if where in house.things else where


class Omniscient(Evidence):
    """Evidence for one who has seen everything there is."""

    def __init__(self, domain: Domain, truth: Truth) -> None:
        super().__init__(domain, truth, Record(), BEFORE)

    def was_seen(self, name: str) -> bool:
        return name in self.domain.house.doorways or true_room(self.domain, self.truth, name) is not None

    def was_observed(self, name: str) -> bool:
        return self.was_seen(name)

    def was_inspected(self, where: str, *, for_person: bool = False) -> bool:
        return True
