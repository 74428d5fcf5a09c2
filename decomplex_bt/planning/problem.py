"""A planning problem as a value: only the objects that a goal can touch, rendered as sorted PDDL text."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property, lru_cache

from decomplex_bt.domain.house import House
from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.pddl import pddl_sections
from decomplex_bt.domain.sexpr import typed_list
from decomplex_bt.planning.abilities import tools_for
from decomplex_bt.planning.belief import ROBOT, Belief
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.symbolic import SymbolicState

_FACT_SEPARATOR = "__"
_DOMAIN = re.compile(r"\(\s*define\s+\(\s*domain\s+([^\s()]+)", re.IGNORECASE)


@dataclass(frozen=True)
class Problem:
    """What a planner is given. All parts are sorted, so that equal problems of one domain are equal texts.

    `objects`: (name, PDDL type). `forbidden`: steps that the plan must not contain.
    """

    domain_pddl: str = field(repr=False)
    objects: tuple[tuple[str, str], ...]
    init: tuple[Atom, ...]
    goal: tuple[Atom, ...]
    forbidden: tuple[GroundAction, ...] = ()

    @cached_property
    def names(self) -> frozenset[str]:
        """The objects that actions may be about, the constants of the domain among them."""
        return _constants(self.domain_pddl).union(name for name, _ in self.objects)

    @cached_property
    def text(self) -> str:
        """The problem as a PDDL file."""
        objects = "\n    ".join(f"{name} - {of}" for name, of in self.objects)
        init = "\n    ".join(map(str, self.init))
        goal = " ".join(map(str, self.goal))
        domain = _domain_name(self.domain_pddl)
        return (
            f"(define (problem task)\n  (:domain {domain})\n  (:objects\n    {objects})\n  (:init\n    {init})\n"
            f"  (:goal (and {goal})))\n"
        )


@lru_cache(maxsize=8)
def _constants(domain_pddl: str) -> frozenset[str]:
    sections = pddl_sections(domain_pddl).get(":constants", [])
    return frozenset(name for section in sections for name, _ in typed_list(section))


@lru_cache(maxsize=8)
def _domain_name(domain_pddl: str) -> str:
    match = _DOMAIN.search(domain_pddl)
    return match[1] if match is not None else "household"


def fact_name(pair: str, entity: str) -> str:
    """The PDDL object that stands for knowing the value of an entity's state pair."""
    return f"{pair}{_FACT_SEPARATOR}{entity}"


def fact_of(name: str) -> tuple[str, str]:
    """State pair and entity of a fact's name."""
    pair, _, entity = name.partition(_FACT_SEPARATOR)
    return pair, entity


def belief_problem(belief: Belief, goal: Iterable[Atom], *, forbidden: Iterable[GroundAction] = ()) -> Problem:
    """The problem of bringing about `goal` from what is believed; steps that failed for good are forbidden as well."""
    return make_problem(SymbolicState.of(belief), goal, forbidden=(*belief.blocked(), *forbidden))


def make_problem(state: SymbolicState, goal: Iterable[Atom], *, forbidden: Collection[GroundAction] = ()) -> Problem:
    """The problem of bringing about `goal` from a symbolic state, with only the objects that the goal can touch."""
    goal = tuple(sorted(set(goal)))
    scene = _Scene(state, goal)
    names = {name for name, _ in scene.objects}
    relevant = sorted({step for step in forbidden if names.issuperset(step.objects)} | set(scene.misplacements()))
    return Problem(
        state.belief.domain.domain_pddl, scene.objects, tuple(sorted(set(scene.atoms()))), goal, tuple(relevant)
    )


class _Scene:
    """The part of the house that a goal can touch."""

    def __init__(self, state: SymbolicState, goal: tuple[Atom, ...]) -> None:
        self.state, self.goal = state, goal
        self.domain: Domain = state.belief.domain
        self.house: House = self.domain.house
        self.facts = sorted({name for atom in goal if atom.predicate == "known" for name in atom.objects})
        named = [name for atom in goal for name in atom.objects if atom.predicate != "known"]
        named += [fact_of(fact)[1] for fact in self.facts]
        named += [tool for atom in goal for tool in self._tools(atom)]
        named += [place for name in named if (place := self._holder(name)) is not None]
        self.carried = [thing for thing in (state.held, *state.tray) if thing is not None]
        named += [state.held] if state.held else []
        self.things = self._of_type(named, "thing")
        floor = self.house.floor_of(state.room)
        self.at = self._position(named, floor)
        self.rooms, doorways = self._way(named)
        self.positions = sorted({*self._of_type(named, "position"), *doorways, self.at, floor})
        self.slots = self._slots()

    @property
    def objects(self) -> tuple[tuple[str, str], ...]:
        slots = [(f"slot_{index + 1}", "slot") for index in self.slots]
        facts = [(fact, "fact") for fact in self.facts]
        named = [(name, self.domain.pddl_type(name)) for name in (*self.rooms, *self.positions, *self.things)]
        return tuple(sorted([*named, *slots, *facts]))

    def atoms(self) -> Iterator[Atom]:
        """What holds at the start."""
        state = self.state
        yield Atom("in-room", (state.room,))
        yield Atom("at", (self.at,))
        for place in self.positions:
            yield from self._position_atoms(place)
        for thing in self.things:
            yield from self._thing_atoms(thing)
        for index in self.slots:
            if state.tray[index] is None:
                yield Atom("slot-free", (f"slot_{index + 1}",))
        if state.held is None:
            yield Atom("hand-free")
        for fact in self.facts:
            yield Atom("about", (fact, fact_of(fact)[1]))

    def misplacements(self) -> Iterator[GroundAction]:
        """Steps that would get rid of a thing the goal does not name: it is stowed, or put down where it can stay."""
        named = {name for atom in self.goal for name in atom.objects}
        has_slot = None in self.state.tray
        for thing in self.things:
            if thing in named or thing in {fact_of(fact)[1] for fact in self.facts}:
                continue
            for position in self.positions:
                if position in self.house.people:
                    yield GroundAction("give", (thing, position))
                elif position not in self.house.doorways and (has_slot or "fill" in self.domain.kind(position).states):
                    yield GroundAction("place", (thing, position))

    # -- what belongs to it -------------------------------------------------------------------------------------------

    def _of_type(self, names: Iterable[str], of: str) -> list[str]:
        return sorted({name for name in names if self.domain.has_type(name, of)})

    def _holder(self, name: str) -> str | None:
        """The place or person where a thing is."""
        if not self.domain.has_type(name, "thing"):
            return None
        place = self.state.place_of(name)
        return None if place == ROBOT else place

    def _tools(self, atom: Atom) -> Iterator[str]:
        """The devices and places, or the rag, that can bring about what holds of one thing or place."""
        if len(atom.objects) != 1:
            return
        name = atom.objects[0]
        tools = tools_for(name, atom.predicate, self.domain)
        if name in self.house.things:
            yield from tools
        else:
            yield from sorted(tools, key=lambda rag: self.state.place_of(rag) is None)[:1]

    def _position(self, named: Iterable[str], floor: str) -> str:
        """The position the robot is at: of those it is near, one that matters, else the floor it stands on."""
        at = self.state.at
        if at is not None and self._is_in_room(at):
            return at
        near = self.state.belief.near if at is None else ()
        return next((name for name in sorted(set(named)) if name in near and self._is_in_room(name)), floor)

    def _is_in_room(self, position: str) -> bool:
        doorway = self.house.doorways.get(position)
        return self.state.room in doorway.rooms if doorway else self.state.room_of(position) == self.state.room

    def _way(self, named: Iterable[str]) -> tuple[list[str], list[str]]:
        """The rooms of all that matters with the rooms and doorways on the shortest ways between them."""
        rooms, doorways = {self.state.room}, set[str]()
        wanted = {room for name in named if (room := self._room(name)) is not None}
        wanted |= {room for name in named if name in self.house.doorways for room in self.house.doorways[name].rooms}
        rooms |= wanted
        ends = sorted(rooms)
        for i, start in enumerate(ends):
            for room, doorway in _shortest_ways(self.house, start, ends[i + 1 :], self._is_blocked):
                rooms.add(room)
                doorways.add(doorway)
        return sorted(rooms), sorted(doorways)

    def _room(self, name: str) -> str | None:
        return None if name in self.house.doorways else self.state.room_of(name)

    def _is_blocked(self, doorway: str) -> bool:
        """Whether a doorway was given up: its door does not open, or nothing gets through."""
        return any(step.name in ("pass", "open-up") and doorway in step.objects for step in self.state.belief.blocked())

    def _slots(self) -> list[int]:
        """The tray's slots: those with something that matters, and as many free ones as can be needed."""
        tray = self.state.tray
        used = [index for index, thing in enumerate(tray) if thing in self.things]
        extra = len(self.things) - len(used) - (self.state.held is None)
        free = [index for index, thing in enumerate(tray) if thing is None][: max(0, extra)]
        return sorted([*used, *free])

    # -- what is so ---------------------------------------------------------------------------------------------------

    def _position_atoms(self, name: str) -> Iterator[Atom]:
        doorway = self.house.doorways.get(name)
        if doorway is not None:
            for a, b in (doorway.rooms, doorway.rooms[::-1]):
                if a in self.rooms and b in self.rooms:
                    yield Atom("connects", (name, a, b))
        rooms = doorway.rooms if doorway else (self.state.room_of(name),)
        for room in rooms:
            if room in self.rooms:
                yield Atom("within", (name, room))
        if name in self.house.people:
            return
        if doorway is not None and doorway.kind is None:
            yield Atom("open", (name,))
            return
        kind = self.domain.kind(name)
        states = tuple(self._states(name, kind.states))
        yield from states
        if kind.has_door:
            yield Atom("openable", (name,))
        else:
            yield Atom("open", (name,))
        if kind.is_device:
            yield Atom("switchable", (name,))
            if not kind.is_container or not kind.has_door or Atom("closed", (name,)) in states:
                yield Atom("ready", (name,))
        if "fill" in kind.states:
            yield Atom("drainable", (name,))
        for ability in ("heats", "cools", "washes", "rinses", "fills", "drains"):
            for thing in self.things:
                if set(getattr(kind, ability)) & set(self.domain.kind(thing).tags):
                    yield Atom(ability, (name, thing))
        for thing in self.things:
            if set(self.domain.kind(thing).wipes) & set(kind.tags):
                yield Atom("wipes", (thing, name))

    def _thing_atoms(self, thing: str) -> Iterator[Atom]:
        yield from self._states(thing, self.domain.kind(thing).states)
        state = self.state
        if thing == state.held:
            yield from (Atom("holding", (thing,)), Atom("carried", (thing,)))
            return
        if thing in state.tray:
            yield from (Atom("on-tray", (thing, f"slot_{state.tray.index(thing) + 1}")), Atom("carried", (thing,)))
            return
        place = state.place_of(thing)
        if place in self.house.people:
            yield Atom("has", (place, thing))
        elif place in self.positions:
            yield Atom("lies", (thing, place))

    def _states(self, name: str, pairs: Iterable[str]) -> Iterator[Atom]:
        """The state's fluents; what is not known is as it usually is, but what is wanted is yet to be done."""
        goals = self.domain.goals
        for pair in pairs:
            value = self.state.value(name, pair)
            if value is None:
                value = self.state.belief.likely_value(name, pair)
                for wanted in self.domain.kinds.state_pairs[pair].values:
                    if Atom(goals.fluent(wanted), (name,)) in self.goal:
                        value = self.domain.kinds.opposite(wanted)
            if value is not None:
                yield Atom(goals.fluent(value), (name,))


def _shortest_ways(
    house: House, start: str, ends: Iterable[str], is_blocked: Callable[[str], bool]
) -> Iterator[tuple[str, str]]:
    """The (room, doorway) pairs on a shortest way from `start` to each of `ends`, breadth first."""
    came: dict[str, tuple[str, str] | None] = {start: None}
    queue = deque([start])
    doorways = [(name, doorway.rooms) for name, doorway in house.doorways.items() if not is_blocked(name)]
    while queue:
        room = queue.popleft()
        for name, rooms in doorways:
            if room in rooms:
                other = rooms[0] if rooms[1] == room else rooms[1]
                if other not in came:
                    came[other] = (room, name)
                    queue.append(other)
    for end in ends:
        room = end
        while (step := came.get(room)) is not None:
            yield room, step[1]
            room = step[0]
