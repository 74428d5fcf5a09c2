"""Whereabouts: where things, people and places of a task may be, and where to look next."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from functools import lru_cache

from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.abilities import holds_things, is_fixed, stands_at
from decomplex_bt.planning.belief import ROBOT, Belief

HOP_COST = 1.0
"""What a doorway on the way weighs against likelihood: a place two doorways off must be three times as likely."""
DOOR_COST = 0.3
"""What opening a container weighs, in the same measure."""


def places_of(names: Iterable[str], belief: Belief, *, for_people: bool = False) -> tuple[str, ...]:
    """The places where things can lie that these names of places stand for now.

    A room stands for all its places, the floor included (for people: for its floor alone), a thing for the place it
    lies at, a person for themselves (for people: for the floor of their room), and what holds nothing for itself. A
    thing or person of whom it is not known where they are stands for all places where they may be.
    """
    return tuple(dict.fromkeys(p for name in names for p in _stands_for(name, belief, for_people)))


def _stands_for(name: str, belief: Belief, for_people: bool) -> Iterator[str]:
    domain, house = belief.domain, belief.domain.house
    if name in house.things:
        known = belief.place_of(name)
        yield from (place for place, _ in belief.likely_places(name)) if known is None else [known]
    elif name in house.people:
        is_at_hand = belief.place_of(name) is not None and not for_people
        yield from [name] if is_at_hand else (place for place, _ in belief.likely_places(name))
    elif for_people:
        yield from (house.floor_of(room) for room in [domain.room_of(name)] if room is not None)
    elif name in house.rooms:
        yield from places_in(name, domain)
    else:
        yield name


@lru_cache(maxsize=1024)
def places_in(room: str, domain: Domain) -> tuple[str, ...]:
    """The places of a room on or in which things lie, its floor included, in the order of the house."""
    places = domain.house.places()
    return tuple(place for place in places if domain.room_of(place) == room and holds_things(place, domain))


def is_at(name: str, places: Iterable[str], belief: Belief) -> bool:
    """Whether a thing is believed to lie at one of these places, or a person to be in the room of one; what is fixed is
    where the map has it."""
    if is_fixed(name, belief.domain):
        return any(stands_at(name, other, belief.domain) for other in places)
    place = belief.place_of(name)
    if place is None:
        return False
    if name in belief.domain.house.people:
        return any(belief.domain.room_of(other) == place for other in places)
    return place in places


def next_place(names: Iterable[str], belief: Belief, open_places: Iterable[str]) -> str | None:
    """Where to look next for any of these: of the places still open, likely ones first, near ones before far ones.

    None where no place is left. Places where nothing of it tends to be come last, in their order.
    """
    open_places = tuple(open_places)
    weights = dict.fromkeys(open_places, 0.0)
    for name in names:
        for place, weight in belief.likely_places(name):
            if place in weights:
                weights[place] += weight
    if not weights:
        return None
    return max(open_places, key=lambda place: (weights[place] + 1e-6) / (1 + _cost(place, belief)))


def likely_places(names: Iterable[str], belief: Belief) -> tuple[str, ...]:
    """All places where any of these may still be, likeliest of the first first."""
    found = (place for name in names for place, _ in belief.likely_places(name))
    return tuple(dict.fromkeys(place for place in found if place != ROBOT and place not in belief.domain.house.people))


def _cost(place: str, belief: Belief) -> float:
    room = belief.domain.room_of(place)
    hops = room_distances(belief.domain, belief.room).get(room or belief.room, 9)
    is_closed = holds_things(place, belief.domain) and belief.likely_value(place, "aperture") == "closed"
    return hops * HOP_COST + is_closed * DOOR_COST


@lru_cache(maxsize=1024)
def room_distances(domain: Domain, start: str) -> dict[str, int]:
    """How many doorways lie between a room and each other."""
    distances = {start: 0}
    queue = deque([start])
    while queue:
        room = queue.popleft()
        for doorway in domain.house.doorways.values():
            for other in doorway.rooms:
                if room in doorway.rooms and other not in distances:
                    distances[other] = distances[room] + 1
                    queue.append(other)
    return distances
