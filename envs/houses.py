"""Houses: made up from a seed after the pattern of a domain's own house, in any size from two rooms to forty.

Rooms of the pattern's kinds lie along hallways, the hallways of larger houses along another; small houses are a row of
rooms. Each room is furnished as the pattern's room of its kind, differently each time. What comes out is an ordinary
`House`: every room, doorway and place of it is within the robot's reach, and every type of task can be done in it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.random import Generator

from decomplex_bt.domain.document import check_record, load_yaml, read_text
from decomplex_bt.domain.house import Doorway, Furniture, House, Item, Person, Room
from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.nouns import Nouns
from decomplex_bt.domain.survey import check_house
from decomplex_bt.envs.furnishing import Furnished, Group, Rect, groups_of
from decomplex_bt.envs.reach import check_access, is_reachable
from decomplex_bt.errors import DataFileError, InputError

LEAST_ROOMS, MOST_ROOMS = 2, 40
ROW_ROOMS = 4
"""Houses of up to so many rooms are a row of rooms without a hallway."""
WING_ROOMS = 11
"""Rooms along one hallway at most, the hallway included."""
HALL = 1.4  # [m] width of a hallway
WIDER = (0.98, 1.25)
"""A room is between so many times as wide as the pattern's."""
OPENING = 1.1  # [m] width of a doorway without a door
SIDE_DOOR_CHANCE = 0.3
"""Of a doorway between two neighbouring rooms, besides those to the hallway."""
CORNER = 0.35  # [m] a doorway's edge is so far from the room's corner
ATTEMPTS = 30


@dataclass(frozen=True, slots=True)
class HouseSize:
    """A class of houses. `rooms`: from, to. `rows` of the entity table and `bounds` [m] hold them all; `seconds` of
    simulated time are enough to look everywhere in one."""

    rooms: tuple[int, int]
    rows: int
    bounds: float
    seconds: float = 600.0

    def draw(self, domain: Domain, seed: int) -> House:
        """The house of this seed."""
        low, high = self.rooms
        rooms = int(np.random.default_rng(seed).integers(low, high + 1))
        return generate_house(domain, rooms, seed)


SIZES = {
    "small": HouseSize((2, 4), rows=128, bounds=32.0),
    "medium": HouseSize((6, 10), rows=192, bounds=48.0),
    "large": HouseSize((20, 40), rows=640, bounds=96.0, seconds=1800.0),
}
"""The sizes that environments come in."""


def generate_house(domain: Domain, rooms: int, seed: int) -> House:
    """A house with this number of rooms, hallways included; the same for the same domain, number and seed.

    Raises `InputError` for a number that is out of range, or where the pattern's furniture fits in no such house.
    """
    if not LEAST_ROOMS <= rooms <= MOST_ROOMS:
        raise InputError(f"rooms is {rooms}; a house has {LEAST_ROOMS} to {MOST_ROOMS}")
    pattern = _pattern_of(domain)
    for attempt in range(ATTEMPTS):
        rng = np.random.default_rng((seed, rooms, attempt))
        house = _Builder(pattern, rooms, rng).build(f"{rooms} rooms, seed {seed}")
        usable = _without_what_is_out_of_reach(domain, house)
        if usable is not None and _lacks(domain, usable) is None:
            return usable
    raise InputError(f"no house of {rooms} rooms came out of seed {seed}; the pattern's furniture takes too much room")


def with_house(domain: Domain, house: House) -> Domain:
    """The domain with another house in it. Raises `ValueError` for a house that does not fit it, or together."""
    check_house(house, domain.kinds, domain.lexicon.colours)
    return replace(domain, house=house, nouns=Nouns.of(house, domain.kinds))


@lru_cache(maxsize=16)
def generated_domain(domain: Domain, size: str, seed: int) -> Domain:
    """The domain with the generated house of this size and seed. Raises `InputError` for an unknown size."""
    if size not in SIZES:
        raise InputError(f"there is no size {size!r}; expected one of {', '.join(SIZES)}")
    return with_house(domain, SIZES[size].draw(domain, seed))


def domain_with_file(domain: Domain, path: str) -> Domain:
    """The domain with the house of this file, as it is now. Raises `DataFileError` for a broken one or a misfit."""
    return _domain_with(domain, path, read_text(Path(path)))


@lru_cache(maxsize=16)
def _domain_with(domain: Domain, path: str, text: str) -> Domain:
    house = check_record(load_yaml(text, path), House, path)
    try:
        found = with_house(domain, house)
    except ValueError as error:
        raise DataFileError(path, str(error)) from None
    check_access(found, path)
    return found


# -- the pattern ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Pattern:
    """What generated houses are made of. By kind of room: its groups, width and depth, and the kind of its door."""

    house: House
    groups: dict[str, list[Group]]
    widths: dict[str, float]
    depths: dict[str, float]
    doors: dict[str, str | None]
    hall: str
    kinds: Kinds


@lru_cache(maxsize=4)
def _pattern_of(domain: Domain) -> _Pattern:
    house = domain.house
    fixtures = frozenset(name for name, kind in domain.kinds.kinds.items() if kind.category == "fixture")
    doorways = Counter(room for doorway in house.doorways.values() for room in doorway.rooms)
    hall = house.rooms[max(house.rooms, key=lambda room: doorways[room])].kind
    groups: dict[str, list[Group]] = {}
    widths, depths, doors = {}, {}, {}
    for name, room in house.rooms.items():
        x0, y0, x1, y1 = room.rect
        groups.setdefault(room.kind, []).extend(groups_of(house, name, fixtures))
        widths[room.kind], depths[room.kind] = x1 - x0, y1 - y0
        kinds = [doorway.kind for doorway in house.doorways.values() if name in doorway.rooms]
        doors[room.kind] = kinds[0] if room.kind != hall and kinds else None
    return _Pattern(house, groups, widths, depths, doors, hall, domain.kinds)


# -- building ---------------------------------------------------------------------------------------------------------


class _Builder:
    def __init__(self, pattern: _Pattern, count: int, rng: Generator) -> None:
        self.pattern, self.count, self.rng = pattern, count, rng
        self.rooms: dict[str, Room] = {}
        self.doorways: dict[str, Doorway] = {}
        self._numbers: Counter[str] = Counter()

    def build(self, name: str) -> House:
        if self.count <= ROW_ROOMS:
            self._lay_out_row()
        else:
            self._lay_out_wings()
        furniture = self._furnish()
        kinds_of_places = {piece.kind for piece in furniture.values()} | {"floor"}
        pattern = self.pattern.house
        lying = {thing: self._lying(item, kinds_of_places) for thing, item in pattern.things.items()}
        return House(
            format=pattern.format,
            name=name,
            rooms=self.rooms,
            doorways=self.doorways,
            furniture=furniture,
            things={thing: item for thing, item in lying.items() if item is not None},
            people={who: self._at_home(person) for who, person in pattern.people.items()},
            robot_start=self._by_kind(pattern.robot_start),
            grasp_slip=pattern.grasp_slip,
            missed_detection=pattern.missed_detection,
        )

    def _kinds(self, count: int) -> list[str]:
        """Kinds of rooms: one of each as far as they go, then such as come with little furniture rather than much."""
        known = [kind for kind in self.pattern.groups if kind != self.pattern.hall]
        kinds = known[:count]
        shares = np.array([1 / (1 + len(self.pattern.groups[kind])) for kind in known])
        more = self.rng.choice(len(known), size=max(0, count - len(kinds)), p=shares / shares.sum())
        kinds += [known[int(index)] for index in more]
        return [kinds[int(index)] for index in self.rng.permutation(len(kinds))]

    def _add_room(self, kind: str, rect: Rect) -> str:
        self._numbers[kind] += 1
        number = self._numbers[kind]
        name = kind.replace(" ", "_") + (f"_{number}" if number > 1 else "")
        x0, y0, x1, y1 = (round(value, 3) for value in rect)
        self.rooms[name] = Room(kind=kind, rect=(x0, y0, x1, y1))
        return name

    def _width(self, kind: str) -> float:
        return round(self.pattern.widths[kind] * float(self.rng.uniform(*WIDER)), 2)

    def _depth(self, kinds: Sequence[str]) -> float:
        return round(max(self.pattern.depths[kind] for kind in kinds) + float(self.rng.uniform(0, 0.5)), 2)

    def _lay_out_row(self) -> None:
        kinds = self._kinds(self.count)
        depth, x = self._depth(kinds), 0.0
        row = []
        for kind in kinds:
            width = self._width(kind)
            row.append(self._add_room(kind, (x, 0.0, x + width, depth)))
            x += width
        for one, other in pairwise(row):
            self._add_side_door(one, other)

    def _lay_out_wings(self) -> None:
        """Wings one above the other, each a hallway with rooms on both sides; from two on a hallway links them."""
        wings = 1 if self.count <= WING_ROOMS else -(-(self.count - 1) // WING_ROOMS)
        links = int(wings > 1)
        kinds = self._kinds(self.count - wings - links)
        ends = np.linspace(0, len(kinds), wings + 1).round().astype(int).tolist()
        halls, y = [], 0.0
        for start, end in pairwise(ends):
            hall, y = self._lay_out_wing(kinds[start:end], HALL * links, y)
            halls.append(hall)
        if links:
            low, high = self.rooms[halls[0]].rect[1], self.rooms[halls[-1]].rect[3]
            link = self._add_room(self.pattern.hall, (0.0, low, HALL, high))
            for hall in halls:
                _, y0, _, y1 = self.rooms[hall].rect
                self._add_doorway(link, hall, (HALL, (y0 + y1) / 2), None)

    def _lay_out_wing(self, kinds: Sequence[str], left: float, bottom: float) -> tuple[str, float]:
        """A hallway with rooms below and above it; returns its name and where the wing ends."""
        rows: tuple[list[tuple[str, float]], list[tuple[str, float]]] = ([], [])
        for kind in kinds:
            row = min(rows, key=lambda row: sum(width for _, width in row))
            row.append((kind, self._width(kind)))
        depths = [self._depth([kind for kind, _ in row]) if row else 0.0 for row in rows]
        length = max(sum(width for _, width in row) for row in rows)
        y = bottom + depths[0]
        hall = self._add_room(self.pattern.hall, (left, y, left + length, y + HALL))
        for row, low, high, wall in ((rows[0], bottom, y, y), (rows[1], y + HALL, y + HALL + depths[1], y + HALL)):
            x, before = left, None
            for kind, width in row:
                name = self._add_room(kind, (x, low, x + width, high))
                self._add_doorway(hall, name, (x + self._along(width), wall), self.pattern.doors[kind])
                if before is not None and self.rng.random() < SIDE_DOOR_CHANCE:
                    self._add_side_door(before, name)
                x, before = x + width, name
        return hall, y + HALL + depths[1]

    def _along(self, length: float) -> float:
        margin = OPENING / 2 + CORNER
        return float(self.rng.uniform(margin, max(margin, length - margin)))

    def _add_side_door(self, one: str, other: str) -> None:
        """A doorway in the wall to the right of one room, to its neighbour."""
        _, y0, x, y1 = self.rooms[one].rect
        self._add_doorway(one, other, (x, y0 + self._along(y1 - y0)), None)

    def _add_doorway(self, one: str, other: str, centre: tuple[float, float], kind: str | None) -> None:
        name = f"{other}_door" if kind is not None else f"{one}_to_{other}"
        width = 0.95 if kind is not None else OPENING
        x, y = (round(value, 3) for value in centre)
        self.doorways[name] = Doorway(rooms=(one, other), centre=(x, y), width=width, kind=kind)

    # -- what is in it ------------------------------------------------------------------------------------------------

    def _furnish(self) -> dict[str, Furniture]:
        furniture: dict[str, Furniture] = {}
        taken: set[str] = {*self.rooms, *self.doorways, *self.pattern.house.things, *self.pattern.house.people}
        has_hall = any(room.kind == self.pattern.hall for room in self.rooms.values())
        for index, (name, room) in enumerate(self.rooms.items()):
            furnished = Furnished(name, room.rect)
            for doorway in self.doorways.values():
                if name in doorway.rooms:
                    furnished.keep_clear(_line(doorway, self.rooms[doorway.rooms[0]], self.rooms[doorway.rooms[1]]))
            groups = list(self.pattern.groups[room.kind])
            if index == 0 and not has_hall:
                groups += self.pattern.groups[self.pattern.hall]
            for group in sorted(groups, key=lambda group: (group.is_thin, -group.width * group.depth)):
                names = {piece: _free_name(piece, name, taken) for piece in group.pieces}
                if furnished.add(group, names, self.rng):
                    taken.update(names.values())
            furniture |= furnished.furniture
        return furniture

    def _lying(self, item: Item, kinds: set[str]) -> Item | None:
        """The thing as it can lie among these kinds of places; None where it suits none of them.

        Where the pattern names single places their kinds stand for them.
        """
        house = self.pattern.house
        places: dict[str, float] = {}
        for place, weight in (item.places or self.pattern.kinds.kinds[item.kind].places).items():
            kind = house.kind_of(place) if place in house.places() else place
            if kind in kinds:
                places[kind] = places.get(kind, 0.0) + weight
        return item.model_copy(update={"places": places}) if places else None

    def _at_home(self, person: Person) -> Person:
        return person.model_copy(update={"rooms": self._by_kind(person.rooms)})

    def _by_kind(self, weights: dict[str, float]) -> dict[str, float]:
        """Weights of the pattern's rooms for the rooms of the same kinds; equal ones where there are none."""
        by_kind = {self.pattern.house.rooms[room].kind: weight for room, weight in weights.items()}
        count = Counter(room.kind for room in self.rooms.values())
        found = {
            name: by_kind[room.kind] / count[room.kind] for name, room in self.rooms.items() if room.kind in by_kind
        }
        return found or dict.fromkeys(self.rooms, 1.0)


def _free_name(piece: str, room: str, taken: set[str]) -> str:
    """A name for a piece: the pattern's, or with the room's number, or with one of its own."""
    if piece not in taken:
        return piece
    number = 2
    while f"{piece}_{number}" in taken:
        number += 1
    return f"{piece}_{number}"


def _line(doorway: Doorway, one: Room, other: Room) -> Rect:
    (x, y), half = doorway.centre, doorway.width / 2
    is_upright = abs(one.rect[2] - other.rect[0]) < 1e-6 or abs(other.rect[2] - one.rect[0]) < 1e-6
    return (x, y - half, x, y + half) if is_upright else (x - half, y, x + half, y)


# -- checking ---------------------------------------------------------------------------------------------------------


def _without_what_is_out_of_reach(domain: Domain, house: House) -> House | None:
    """The house without the pieces that the robot cannot get to; None where it cannot get to all rooms and doorways."""
    for _ in range(len(house.furniture)):
        trial = with_house(domain, house)
        missing = [name for name in (*house.furniture, *house.doorways, *house.rooms) if not is_reachable(trial, name)]
        if any(name not in house.furniture for name in missing):
            return None
        if not missing:
            return house
        left = {name: piece for name, piece in house.furniture.items() if name not in missing}
        while orphans := [name for name, piece in left.items() if piece.part_of not in (None, *left)]:
            left = {name: piece for name, piece in left.items() if name not in orphans}
        house = _with_furniture(house, left)
    return None


def _with_furniture(house: House, furniture: dict[str, Furniture]) -> House:
    """The house with this furniture alone, and the things that can still lie somewhere."""
    kinds = {piece.kind for piece in furniture.values()} | {"floor"}
    things: dict[str, Item] = {}
    for name, item in house.things.items():
        places = {place: weight for place, weight in item.places.items() if place in kinds}
        if places:
            things[name] = item.model_copy(update={"places": places})
    return house.model_copy(update={"furniture": furniture, "things": things})


def _lacks(domain: Domain, house: House) -> str | None:
    """What a house lacks for every type of task to be possible in it; None if nothing.

    It needs things to carry and places to put them, a container and a device, somebody besides the user, and for each
    value of a state that can be brought about in the pattern's first room something that does so.
    """
    kinds = [domain.kinds.kinds[piece.kind] for piece in house.furniture.values()]
    if sum(kind.surface for kind in kinds) < 2 or not any(kind.inside and kind.has_door for kind in kinds):
        return "places"
    if not any(kind.is_device for kind in kinds):
        return "a device"
    first = next(iter(domain.house.rooms))
    needed = [domain.kinds.kinds[piece.kind] for piece in domain.house.furniture.values() if piece.room == first]
    for ability in ("heats", "cools", "rinses", "fills", "drains"):
        if any(getattr(kind, ability) for kind in needed) and not any(getattr(kind, ability) for kind in kinds):
            return ability
    if not any(person.home > 0 for person in list(house.people.values())[1:]):
        return "company"
    return None if house.things else "things"
