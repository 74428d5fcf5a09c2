"""What an instruction's flow tests: the questions whose answers decide its branches, for the balance of the draw."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import takewhile

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.balance import PersonTest, PlaceTest, StateTest, Test, Whereabouts, WorksTest
from decomplex_bt.envs.evidence import holds_things, places_in
from decomplex_bt.flow import If, Node
from decomplex_bt.planning.ground_task import HERE, GroundInstruction, GroundTask, Referent


def tests_of(instruction: GroundInstruction, domain: Domain) -> tuple[Test, ...]:
    """The tests of all conditions in the order of the flow, each once, and then where people are said to be, but for
    those about whom that is asked.

    A chain of searches for one thing ("look on the table; if it is not there, in the drawer; ...") is one test with a
    stage for each. Of merged mentions the first is tested, since it is the one that is carried out.
    """
    tests = dict.fromkeys(_of_sequence(instruction.flow.nodes, instruction, domain))
    asked = {name for test in tests if isinstance(test, PersonTest) and test.rooms for name in test.people}
    return (*tests, *(said for said in _said(instruction, domain) if asked.isdisjoint(said.people)))


def _said(instruction: GroundInstruction, domain: Domain) -> Iterator[Whereabouts]:
    """Where people are said to be, first of all."""
    said: set[str] = set()
    for people, wheres in instruction.whereabouts():
        if not said.isdisjoint(people):
            continue
        said.update(people)
        rooms = dict.fromkeys(where if where in domain.house.rooms else domain.room_of(where) for where in wheres)
        yield Whereabouts(people, tuple(room for room in rooms if room is not None))


def _of_sequence(nodes: Sequence[Node], instruction: GroundInstruction, domain: Domain) -> Iterator[Test]:
    for node in nodes:
        if isinstance(node, If):
            yield from _of_condition(node, instruction, domain)


def _of_condition(node: If, instruction: GroundInstruction, domain: Domain) -> Iterator[Test]:
    chain = _chain(node, instruction)
    task = instruction.task(node.task)
    if _is_search(task):
        for referent in task.objects:
            yield from _presence(referent, [instruction.task(link.task) for link in chain], domain)
    elif task.type == "check_state":
        yield from _states(task, domain)
    else:
        yield from _possibility(task, domain)
    for link in chain:
        yield from _of_sequence(link.then, instruction, domain)
        rest = [other for other in link.orelse if not (len(chain) > 1 and other in chain)]
        yield from _of_sequence(rest, instruction, domain)


def _chain(node: If, instruction: GroundInstruction) -> list[If]:
    """The searches for one and the same that follow each other where each fails, beginning with this condition."""
    chain = [node]
    task = instruction.task(node.task)
    if not (_is_search(task) and task.places and task.objects):
        return chain
    for other in chain[-1].orelse:
        if isinstance(other, If):
            following = instruction.task(other.task)
            asks_the_same = following.objects == task.objects and _value(following) == _value(task)
            if _is_search(following) and following.places and asks_the_same:
                return [*chain, *_chain(other, instruction)]
    return chain


def _is_search(task: GroundTask) -> bool:
    """Whether a condition asks for where something is."""
    if task.type == "searching":
        return True
    return task.type == "check_state" and (task.state == HERE or task.state is None or bool(task.places))


def _value(task: GroundTask) -> str | None:
    """The value of a state that a check asks for, None where it asks for none."""
    return task.state if task.type == "check_state" and task.state != HERE else None


def _where(referent: Referent, task: GroundTask, domain: Domain) -> tuple[tuple[str, str], ...]:
    """The states in which a check or search asks for what a phrase means."""
    value = _value(task)
    asked = [(pair, value) for pair, both in domain.kinds.state_pairs.items() if value in both.values]
    return tuple(dict.fromkeys((*referent.where, *asked)))


def _presence(referent: Referent, searches: Sequence[GroundTask], domain: Domain) -> Iterator[Test]:
    """Where the things or people of a phrase turn up along a chain of searches, as they are asked for.

    The chain ends before a search beside something that may be anywhere. What is fixed cannot turn up elsewhere; it is
    named all the same, so that the draw can say so.
    """
    house = domain.house
    things = tuple(name for name in referent.candidates if name in house.things)
    people = tuple(name for name in referent.candidates if name in house.people)
    fixed = tuple(name for name in referent.candidates if name in house.places())
    pairs = ((task, _stage(task, domain)) for task in searches)
    stages = tuple(stage for _, stage in takewhile(lambda pair: pair[1] or not pair[0].places, pairs))
    where = _where(referent, searches[0], domain)
    if not stages:
        yield from (StateTest(referent.candidates, pair, value) for pair, value in where)
        return
    if things:
        is_said_there = _value(searches[0]) is not None and not referent.is_any
        yield PlaceTest(things, stages, where, is_said_there)
    elif fixed and where:
        asked = {domain.room_of(place) for stage in stages for place in stage}
        there = tuple(name for name in fixed if domain.room_of(name) in asked)
        yield from (StateTest(there or fixed, pair, value) for pair, value in where)
    elif fixed:
        yield PlaceTest(fixed, stages)
    if people:
        rooms = [room for stage in stages for place in stage if (room := domain.room_of(place)) is not None]
        yield PersonTest(people, tuple(dict.fromkeys(rooms)))


def _stage(task: GroundTask, domain: Domain) -> tuple[str, ...]:
    """The places that a search looks at; empty for anywhere, and where they depend on where something else is."""
    places: dict[str, None] = {}
    for referent in task.places:
        for name in referent.candidates:
            if name in domain.house.rooms:
                places.update(dict.fromkeys(places_in(domain, name)))
            elif holds_things(domain, name):
                places[name] = None
    return tuple(places)


def _states(task: GroundTask, domain: Domain) -> Iterator[Test]:
    """The state that is checked; all that a phrase may mean agree in it, so that whichever is looked at decides."""
    assert task.state is not None
    try:
        pair = domain.kinds.pair_of(task.state)
    except KeyError:
        return
    for referent in task.objects:
        yield StateTest(referent.candidates, pair, task.state)


def _possibility(task: GroundTask, domain: Domain) -> Iterator[Test]:
    """What an action as a condition hangs on: things that are there, people at home, devices that work."""
    house = domain.house
    for referent in task.objects:
        if task.is_only_there:
            yield from _presence(referent, [task], domain)
            continue
        things = tuple(name for name in referent.candidates if name in house.things)
        people = tuple(name for name in referent.candidates if name in house.people)
        if things:
            yield PlaceTest(things, ((),), referent.where)
        if people:
            yield PersonTest(people)
    for target in (*task.recipients, task.goal):
        if target is not None and (people := tuple(name for name in target.candidates if name in house.people)):
            yield PersonTest(people)
    if task.type == "change_state":
        yield from (WorksTest(devices) for referent in task.objects if (devices := _devices(referent, task, domain)))


def _devices(referent: Referent, task: GroundTask, domain: Domain) -> tuple[str, ...]:
    """The devices that must work for a change of state: the things themselves, or what heats, washes or fills them."""
    fixed = tuple(name for name in referent.candidates if name not in domain.house.things)
    if fixed:
        return fixed
    able = {name: task.devices(name, domain) for name in referent.candidates}
    shared = tuple(dict.fromkeys(place for places in able.values() for place in places))
    return shared if all(domain.kind(place).is_device for place in shared) else ()
