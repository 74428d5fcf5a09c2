"""Where things and people tend to be, and what state things tend to be in, before anything was seen."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from decomplex_bt.domain.house import House
from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.abilities import holds_things

UNEXPECTED = 0.01
"""How likely something is where it tends not to be, though something says that it may."""
SAID = 100.0
"""How much likelier than all else it is that somebody is where they are said to be."""


@dataclass(frozen=True)
class Prior:
    """`places`: thing (or person) to (place, weight), likeliest first; a person's places are the floors of rooms.

    `values`: (entity, state pair) to the likelier value.
    """

    places: Mapping[str, tuple[tuple[str, float], ...]]
    values: Mapping[tuple[str, str], str]

    @classmethod
    def of(cls, domain: Domain) -> Prior:
        """What the kinds and the house say."""
        house, kinds = domain.house, domain.kinds
        named = _places_by_name(house)
        places: dict[str, tuple[tuple[str, float], ...]] = {}
        for name, item in house.things.items():
            places[name] = _spread(item.places or domain.kind(name).places, named)
        for name, person in house.people.items():
            floors = {house.floor_of(room): weight for room, weight in person.rooms.items()}
            places[name] = _spread(floors if person.home > 0 else {}, named)
        values = {
            (name, pair): kinds.state_pairs[pair].values[0 if kind.chance.get(pair, 0.5) > 0.5 else 1]
            for name in (*house.places(), *house.things)
            for kind in [domain.kind(name)]
            for pair in kind.states
        }
        return cls(places, values)

    def told(self, named: Mapping[str, Iterable[str]], domain: Domain) -> Prior:
        """With the places at which an instruction says that things and people may be, however unlikely they are.

        `named`: thing or person to places and rooms; of a room all its places count, of people its floor.
        """
        places = dict(self.places)
        for name, told in named.items():
            if name in places:
                expected = {place for place, _ in places[name]}
                held = dict.fromkeys(place for where in told for place in _held_at(name, where, domain))
                places[name] += tuple((place, UNEXPECTED) for place in held if place not in expected)
        return replace(self, places=places)

    def with_people(self, said: Iterable[tuple[Iterable[str], Iterable[str]]], domain: Domain) -> Prior:
        """With people where an instruction says that they are, ahead of where they tend to be.

        `said`: people, and the rooms or places where any of them is.
        """
        places = dict(self.places)
        for people, wheres in said:
            floors = dict.fromkeys(
                floor for where in wheres for name in people for floor in _held_at(name, where, domain)
            )
            for name in people:
                others = tuple((place, weight) for place, weight in places[name] if place not in floors)
                places[name] = (*((floor, SAID) for floor in floors), *others)
        return replace(self, places=places)


def _held_at(name: str, where: str, domain: Domain) -> Iterator[str]:
    """The places that hold a thing, or a person, which is somewhere."""
    house = domain.house
    if name in house.people:
        room = domain.room_of(where) if where not in house.rooms else where
        yield from () if room is None else (house.floor_of(room),)
    else:
        held = (place for place in house.places() if where in (place, domain.room_of(place)))
        yield from (place for place in held if holds_things(place, domain))


def _places_by_name(house: House) -> dict[str, list[str]]:
    """The places of the house by name and by kind."""
    named: dict[str, list[str]] = {}
    for place in house.places():
        for key in dict.fromkeys((place, house.kind_of(place))):
            named.setdefault(key, []).append(place)
    return named


def _spread(weights: Mapping[str, float], named: Mapping[str, list[str]]) -> tuple[tuple[str, float], ...]:
    """Weights of kinds shared out among their places, heaviest first; equal weights by name."""
    spread: dict[str, float] = {}
    for key, weight in weights.items():
        for place in named.get(key, ()):
            spread[place] = spread.get(place, 0.0) + weight / len(named[key])
    total = sum(spread.values())
    ranked = sorted(spread.items(), key=lambda pair: (-pair[1], pair[0]))
    return tuple((place, weight / total) for place, weight in ranked if weight > 0)
