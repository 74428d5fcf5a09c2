"""What a task has come to, row by row as the contract has it: done or not, true or false as a condition.

Where a phrase has several candidates, any of them counts: a task may then have several outcomes, each with what its
phrases mean from there on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import product

from decomplex_bt.envs.bindings import Bindings, candidates, needed
from decomplex_bt.envs.evidence import Evidence, is_as_ordered
from decomplex_bt.envs.truth import ROBOT
from decomplex_bt.planning.abilities import is_fixed
from decomplex_bt.planning.ground_task import HERE, GroundTask, Referent


@dataclass(frozen=True, slots=True)
class Outcome:
    """One thing a task may count as: `truth` as a condition, `bindings` from here on.

    `is_final`: no other outcome can follow, so that this is not one reading among several.
    """

    truth: bool
    bindings: Bindings
    is_final: bool = True


def outcomes(task: GroundTask, bindings: Bindings, evidence: Evidence, *, is_condition: bool) -> tuple[Outcome, ...]:
    """What the task may count as by now; empty while it is still to be done or found out.

    A task that changes the world is never false here: whether it can be done at all is a question of feasibility.
    """
    return tuple(_ROWS.get(task.type, _by_template)(task, bindings, evidence, is_condition))


def goal_holds(task: GroundTask, bindings: Bindings, evidence: Evidence) -> bool:
    """Whether what the task is to bring about holds; for tasks that find out or say something always False."""
    if task.type in ("searching", "check_state", "informing"):
        return False
    if task.type == "taking":
        return _choose(task.objects, bindings, lambda name: evidence.truth.place(name) == ROBOT, task) is not None
    return any(outcome.truth for outcome in outcomes(task, bindings, evidence, is_condition=False))


# -- tasks that do something ------------------------------------------------------------------------------------------


def _motion(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    target = task.target
    if target is None:
        yield Outcome(True, bindings)
        return
    among = candidates(target, bindings)
    has_many = needed(target, among) > 1  # one cannot be at several places at once: each is to be visited

    def is_reached(name: str) -> bool:
        return _is_robot_at(evidence, name) or (has_many and evidence.was_visited(name.removesuffix("_floor")))

    yield from _done(_choose((target,), bindings, is_reached))


def _taking(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    yield from _done(_choose(task.objects, bindings, evidence.was_carried, task))


def _putting(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    """Placing and bringing: the things are at the goal, or with the recipient, and no longer on the robot."""
    target = task.target
    assert target is not None
    places = candidates(target, bindings)
    for place in places:

        def has_arrived(name: str, place: str = place) -> bool:
            return evidence.truth.place(name) != ROBOT and evidence.is_there(name, place)

        for outcome in _done(_choose(task.objects, {**bindings, target: (place,)}, has_arrived, task)):
            yield Outcome(True, outcome.bindings, outcome.is_final and len(places) == 1)


def _change_state(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    def is_so(name: str) -> bool:
        return is_as_ordered(evidence.domain, evidence.truth, name, task.state)

    yield from _done(_choose(task.objects, bindings, is_so, task))


def _following(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    """Robot and person are both at the goal; without one, where the person has led the robot."""
    if task.goal is not None:
        for goal in candidates(task.goal, bindings):
            if _is_robot_at(evidence, goal):
                bound, room = {**bindings, task.goal: (goal,)}, _room(evidence, goal)
                yield from _done(_choose(task.objects, bound, partial(evidence.is_there, where=room)))
        return

    def has_led(person: str) -> bool:
        goal = evidence.led_to(person)
        room = None if goal is None else _room(evidence, goal)
        return room is not None and _is_robot_at(evidence, room) and evidence.is_there(person, room)

    yield from _done(_choose(task.objects, bindings, has_led))


def _informing(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    yield from _done(_choose(task.recipients, bindings, evidence.was_told, task))


def _by_template(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    """A task type of a domain of one's own: done when the atoms of its goal template hold, for any candidates."""
    goals = (task.goal,) if task.goal is not None else ()
    named = {"object": task.objects, "goal": goals, "recipient": task.recipients}
    referents = {role: group[0] for role, group in named.items() if group}
    options = [candidates(referent, bindings) for referent in referents.values()]
    for choice in product(*options):
        roles = dict(zip(referents, choice, strict=True)) | ({"state": task.state} if task.state else {})
        atoms = evidence.domain.goals.fill(task.type, roles, evidence.domain.has_type)
        if all(_atom_holds(evidence, *atom) for atom in atoms):
            bound = {referent: (name,) for referent, name in zip(referents.values(), choice, strict=True)}
            yield Outcome(True, {**bindings, **bound}, all(len(option) == 1 for option in options))


def _atom_holds(evidence: Evidence, predicate: str, first: str = "", second: str = "") -> bool:
    """Whether a fluent of a goal holds, or came to be since the task became due."""
    if predicate in ("in-room", "at"):
        return _is_robot_at(evidence, first)
    if predicate == "lies":
        return evidence.truth.place(first) == second
    if predicate == "has":
        return evidence.truth.place(second) == first
    if predicate in ("carried", "holding"):
        return evidence.was_carried(first)
    if predicate == "told":
        return evidence.was_told(first)
    if predicate == "inspected":
        return evidence.was_inspected(first)
    if predicate == "followed":
        return _is_robot_at(evidence, second) and evidence.is_there(first, second)
    pairs = evidence.domain.kinds.state_pairs.values()
    values = {evidence.domain.goals.fluent(value): value for pair in pairs for value in pair.values}
    return predicate in values and state_holds(evidence, first, values[predicate])


# -- tasks that find something out ------------------------------------------------------------------------------------


def _searching(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    """Found, or looked for in vain wherever the task says: of two pens one may lie elsewhere in view, and the phrase
    still mean either."""
    if not task.objects:
        yield from _looked(task, bindings, evidence)
        return
    if is_condition and task.places:
        yield from _presence(task, bindings, evidence)
        return
    found = tuple(_done(_choose(task.objects, bindings, evidence.was_seen)))
    yield from found
    is_settled = any(outcome.is_final for outcome in found) or (found and _are_there(task, bindings, evidence))
    if task.places and not is_settled and _is_on_map(task, evidence):
        if not _are_there(task, bindings, evidence):
            yield Outcome(False, bindings)
    elif task.places and not is_settled:
        yield from (Outcome(False, outcome.bindings) for outcome in _looked(task, bindings, evidence))


def _check_state(task: GroundTask, bindings: Bindings, evidence: Evidence, is_condition: bool) -> Iterator[Outcome]:
    if task.state is not None and task.state != HERE:
        yield from _values(task, bindings, evidence)
        return
    if task.places:
        found = _presence(task, bindings, evidence)
    elif _is_on_map(task, evidence):
        found = _done(_choose(task.objects, bindings, lambda name: True))
    else:
        found = _done(_choose(task.objects, bindings, evidence.was_seen))
    for outcome in found:
        yield replace(outcome, truth=outcome.truth != task.is_denied)


def _looked(task: GroundTask, bindings: Bindings, evidence: Evidence) -> Iterator[Outcome]:
    """Whether each place the task names was looked into, at least one of what its phrase may mean."""
    is_looked_into = partial(evidence.was_inspected, for_person=_asks_people(task, evidence))
    yield from _done(_choose(task.places, bindings, is_looked_into))


def _are_there(task: GroundTask, bindings: Bindings, evidence: Evidence) -> bool:
    """Whether the objects truly are where the task says."""
    wheres = [where for place in task.places for where in candidates(place, bindings)]
    there = _choose(task.objects, bindings, lambda name: any(evidence.is_there(name, where) for where in wheres))
    return there is not None


def _presence(task: GroundTask, bindings: Bindings, evidence: Evidence) -> Iterator[Outcome]:
    """Whether the objects are where the task says: seen there, or all of it inspected (as a floor is by what was in
    view a moment ago, with who was seen on it then)."""
    wheres = [where for place in task.places for where in candidates(place, bindings)]

    def is_here(name: str) -> bool:
        return any(evidence.is_there(name, where) for where in wheres)

    is_on_map = _is_on_map(task, evidence)
    for_person = _asks_people(task, evidence)
    is_inspected = is_on_map or all(evidence.was_inspected(where, for_person=for_person) for where in wheres)
    is_known = is_on_map and task.type == "check_state"
    is_known |= for_person and is_inspected
    seen = _choose(task.objects, bindings, lambda name: is_here(name) and (is_known or evidence.was_seen(name)))
    truly = _choose(task.objects, bindings, is_here)
    if seen is not None and truly is not None:
        yield Outcome(True, _narrow_places(task, truly.bindings, evidence))
    if truly is None and is_inspected:
        yield Outcome(False, bindings)


def _is_on_map(task: GroundTask, evidence: Evidence) -> bool:
    """Whether the house's map answers where the objects are: neither they nor the places can be carried or walk."""
    names = [name for referent in (*task.objects, *task.places) for name in referent.candidates]
    return bool(names) and all(is_fixed(name, evidence.domain) for name in names)


def _narrow_places(task: GroundTask, bindings: Bindings, evidence: Evidence) -> Bindings:
    """Keeps of each place's candidates those where something was found."""
    things = [name for referent in task.objects for name in candidates(referent, bindings)]
    narrowed = dict(bindings)
    for referent in task.places:
        wheres = candidates(referent, bindings)
        found = tuple(where for where in wheres if any(evidence.is_there(name, where) for name in things))
        narrowed[referent] = found or wheres
    return narrowed


def _values(task: GroundTask, bindings: Bindings, evidence: Evidence) -> Iterator[Outcome]:
    """Whether the objects have the state: true or false of what was seen.

    "the mug" is the one that was looked at, so that of two mugs either answer may come; "a mug" is false only when all
    were looked at, "all the mugs" as soon as one is not so. Where the task says that they are somewhere and none is, it
    is false once that was looked at.
    """

    bindings = _narrow_to_places(task, bindings, evidence)

    def is_so(name: str) -> bool:
        return state_holds(evidence, name, task.state)

    if task.places and not all(_those_there(task, referent, bindings, evidence) for referent in task.objects):
        yield from _presence(task, bindings, evidence)
        return
    seen = _choose(task.objects, bindings, lambda name: evidence.was_observed(name) and is_so(name))
    if seen is not None:
        yield Outcome(True, seen.bindings, seen.is_final)
    for referent in task.objects:
        among = candidates(referent, bindings)
        looked_at = tuple(name for name in among if evidence.was_observed(name))
        failing = tuple(name for name in looked_at if not is_so(name))
        if referent.is_all or referent.is_any:
            spare = len(among) - needed(referent, among)
            if len(failing) > spare >= 0:
                yield Outcome(False, bindings)
                return
        elif failing:
            yield Outcome(False, {**bindings, referent: failing}, len(failing) == len(among))


def _narrow_to_places(task: GroundTask, bindings: Bindings, evidence: Evidence) -> Bindings:
    """Keeps of each object's candidates those that truly are where the task says, if there are as many as asked for."""
    there = {referent: _those_there(task, referent, bindings, evidence) for referent in task.objects}
    return {**bindings, **{referent: names for referent, names in there.items() if names}}


def _those_there(task: GroundTask, referent: Referent, bindings: Bindings, evidence: Evidence) -> tuple[str, ...]:
    """The candidates that truly are where the task says; none where they are fewer than asked for."""
    wheres = [where for place in task.places for where in candidates(place, bindings)]
    names = candidates(referent, bindings)
    there = tuple(name for name in names if any(evidence.is_there(name, where) for where in wheres))
    return there if len(there) >= needed(referent, there) else ()


# -- shared -----------------------------------------------------------------------------------------------------------


def state_holds(evidence: Evidence, name: str, value: str | None) -> bool:
    """Whether an entity truly has a state value."""
    assert value is not None
    try:
        pair = evidence.domain.kinds.pair_of(value)
    except KeyError:
        return False
    return evidence.truth.state(name, pair) == value


def _done(outcome: Outcome | None) -> Iterator[Outcome]:
    if outcome is not None:
        yield outcome


def _choose(
    referents: Iterable[Referent], bindings: Bindings, is_ok: Callable[[str], bool], task: GroundTask | None = None
) -> Outcome | None:
    """The outcome that binds every referent to those of its candidates that are ok; None where they do not suffice (for
    an order to handle them: `task`)."""
    bound, is_final = dict(bindings), True
    for referent in referents:
        among = candidates(referent, bindings)
        chosen = tuple(name for name in among if is_ok(name))
        if len(chosen) < needed(referent, among, task):
            return None
        bound[referent] = chosen
        is_final &= len(chosen) == len(among)
    return Outcome(True, bound, is_final)


def _is_robot_at(evidence: Evidence, name: str) -> bool:
    """Whether the robot is in a room, at a place, with a person, or at the place where a thing is."""
    house, truth = evidence.domain.house, evidence.truth
    room = name.removesuffix("_floor")
    if room in house.rooms:
        return truth.room == room
    if truth.is_near(name):
        return True
    place = truth.place(name) if name in house.things else None
    return place is not None and place != ROBOT and _is_robot_at(evidence, place)


def _room(evidence: Evidence, goal: str) -> str:
    """The room of a goal, where the goal is a place; people are led to rooms."""
    return evidence.domain.room_of(goal) or goal


def _asks_people(task: GroundTask, evidence: Evidence) -> bool:
    people = evidence.domain.house.people
    return bool(task.objects) and all(name in people for referent in task.objects for name in referent.candidates)


_ROWS: Mapping[str, Callable[[GroundTask, Bindings, Evidence, bool], Iterator[Outcome]]] = {
    "motion": _motion,
    "searching": _searching,
    "taking": _taking,
    "placing": _putting,
    "bringing": _putting,
    "change_state": _change_state,
    "check_state": _check_state,
    "following": _following,
    "informing": _informing,
}
JUDGED_BY_ROW = frozenset(_ROWS)
"""The task types that a row of the contract is about; all others are judged by their goal templates."""
