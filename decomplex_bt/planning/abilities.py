"""What can be done in a house at all: which states can be brought about, and what holds things."""

from __future__ import annotations

from functools import cache, lru_cache

from decomplex_bt.domain.abilities import ABILITIES
from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.schemas import read_schemas


@lru_cache(maxsize=4096)
def states_of(name: str, domain: Domain) -> tuple[str, ...]:
    """The state pairs of an entity of the house; a room and a doorway without a door have none."""
    doorway = domain.house.doorways.get(name)
    is_without = name in domain.house.rooms or (doorway is not None and doorway.kind is None)
    return () if is_without else domain.kind(name).states


@lru_cache(maxsize=4096)
def bringable_values(name: str, pair: str, domain: Domain) -> frozenset[str]:
    """The values of a state pair that the robot can bring about for an entity of the house."""
    values = domain.kinds.state_pairs[pair].values
    if pair in ("power", "aperture"):
        return frozenset(values)
    if name not in domain.house.things:
        tags = frozenset(domain.kind(name).tags)
        wiped = any(tags & set(domain.kind(thing).wipes) for thing in domain.house.things)
        return frozenset(("empty",) if pair == "fill" else ("clean",) if wiped and pair == "cleanliness" else ())
    return frozenset(value for value in values if devices_for(name, value, domain))


@lru_cache(maxsize=4096)
def devices_for(thing: str, value: str, domain: Domain) -> tuple[str, ...]:
    """The places of the house that can bring a thing into a state, in the order of the house."""
    tags = frozenset(domain.kind(thing).tags)
    places = domain.house.places()
    return tuple(
        place for place in places if any(tags & set(getattr(domain.kind(place), by)) for by in _at_places(value))
    )


@cache
def _at_places(value: str) -> tuple[str, ...]:
    """The abilities of places that bring a thing into a state."""
    return tuple(key for key, ability in ABILITIES.items() if ability.brings == value and "thing" in ability.on)


def steps_at(place: str, value: str, domain: Domain) -> tuple[str, ...]:
    """The names of the actions by which things are brought into a state at a place."""
    return tuple(ABILITIES[by].action for by in _at_places(value) if getattr(domain.kind(place), by))


@lru_cache(maxsize=4096)
def runs_shut(name: str, value: str | None, domain: Domain) -> bool:
    """Whether to bring something into a state is to have it run behind its door: "start the washing machine"."""
    pairs = states_of(name, domain)
    return value == "on" and "power" in pairs and "aperture" in pairs


@lru_cache(maxsize=4096)
def tools_for(name: str, fluent: str, domain: Domain) -> tuple[str, ...]:
    """The places at which an action makes a fluent true of a thing, or the things with which it does so of a place."""
    abilities = _abilities_for(fluent, domain.domain_pddl)
    if not abilities:
        return ()
    kind = domain.kind(name)
    tags, abilities = frozenset(kind.tags), tuple(by for by in abilities if kind.category in ABILITIES[by].on)
    tools = (*domain.house.places(), *domain.house.things)
    return tuple(tool for tool in tools if any(tags & set(getattr(domain.kind(tool), by)) for by in abilities))


@lru_cache(maxsize=256)
def _abilities_for(fluent: str, domain_pddl: str) -> tuple[str, ...]:
    """The abilities that an action asks for which makes a fluent true of what the tool works on, and of that alone."""
    return tuple(
        by
        for schema in read_schemas(domain_pddl).values()
        for by, objects in schema.preconditions
        if by in ABILITIES and (fluent, objects[1:]) in schema.adds
    )


@lru_cache(maxsize=4096)
def wipers_of(place: str, domain: Domain) -> tuple[str, ...]:
    """The things that wipe a place clean."""
    tags = frozenset(domain.kind(place).tags)
    return tuple(thing for thing in domain.house.things if tags & set(domain.kind(thing).wipes))


@lru_cache(maxsize=4096)
def holds_things(name: str, domain: Domain) -> bool:
    """Whether things lie on or in a place."""
    if domain.room_of(name) is None or name in domain.house.rooms:
        return False
    kind = domain.kind(name)
    return kind.surface or kind.inside


def is_fixed(name: str, domain: Domain) -> bool:
    """Whether something is where the map has it: a room, a door or furniture."""
    return name in domain.house.doorways or domain.room_of(name) is not None


@lru_cache(maxsize=4096)
def stands_at(name: str, where: str, domain: Domain) -> bool:
    """Whether what is fixed is in a room or part of a place, by the map; its own floor stands for a room."""
    doorway = domain.house.doorways.get(name)
    rooms = doorway.rooms if doorway is not None else (domain.room_of(name),)
    if where.removesuffix("_floor") in rooms:
        return True
    pieces = domain.house.furniture
    parts = ((name, where), (where, name))
    return name == where or any(one in pieces and pieces[one].part_of == other for one, other in parts)
