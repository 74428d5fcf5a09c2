"""A house as data: rooms, doorways, furniture, things and people, before any chance is drawn.

World frame: origin bottom left, x to the right, y up, metres; headings in radians, counter-clockwise from +x.
"""

from __future__ import annotations

import re
from typing import Annotated, Literal

from pydantic import AfterValidator, Field, model_validator

from decomplex_bt.domain.document import Format, Probability, Record, Weights, Word
from decomplex_bt.domain.kinds import STATE_VALUES, Kind, Kinds
from decomplex_bt.errors import among

ROBOT = "robot"
"""The robot's name, the last row of the entity table."""
USER = "user"
"""The kind that only the user may have."""
Rect = tuple[float, float, float, float]
Side = Literal["north", "east", "south", "west"]
_RESERVED = re.compile(rf"slot_\d+|(?:{'|'.join(STATE_VALUES)})__\w+")
"""What a planning problem calls the slots of the tray, and what there is to know of an entity."""
Length = Annotated[float, Field(gt=0)]


def _check_rect(rect: Rect) -> Rect:
    x0, y0, x1, y1 = rect
    if x0 >= x1 or y0 >= y1:
        raise ValueError("expected x0, y0, x1, y1 with x0 < x1 and y0 < y1")
    return rect


class Room(Record):
    """A rectangular room with a floor on which things can lie. `rect`: x0, y0, x1, y1."""

    kind: str
    rect: Annotated[Rect, AfterValidator(_check_rect)]


class Doorway(Record):
    """An opening in the wall between two rooms; with a `kind` (bedroom door, ...) it has a leaf that opens and
    closes."""

    rooms: tuple[str, str]
    centre: tuple[float, float]
    width: Length = 0.95
    kind: str | None = None


class Furniture(Record):
    """Something fixed in a room: furniture, device, container, or a fixture in a wall (front door, window, curtains).

    `centre` and `size` (along x, along y) are its footprint; `sides`: from where it is approached and used.
    `part_of`: it is built into that piece (a desk's drawer) and has no body of its own.
    """

    kind: str
    room: str
    centre: tuple[float, float]
    size: tuple[Length, Length]
    sides: tuple[Side, ...] = Field(min_length=1)
    part_of: str | None = None

    @property
    def footprint(self) -> Rect:
        (x, y), (width, depth) = self.centre, self.size
        return x - width / 2, y - depth / 2, x + width / 2, y + depth / 2


class Item(Record):
    """A small thing that can be carried. Of several of a kind the colour tells them apart."""

    kind: str
    colour: str | None = None
    places: Weights = {}
    """Overrides the kind's places: names or kinds of places to relative weight."""
    absent: Probability | None = None


class Person(Record):
    """Somebody who may be at home. `rooms`: room to relative weight; `home`: probability of being in the house."""

    kind: str
    words: tuple[Word, ...] = ()
    home: Probability = 1.0
    rooms: Weights = Field(min_length=1)


class House(Record):
    """`house.yaml`. Names are lower-case identifiers, unique over all sections, and serve as PDDL objects.

    The first of `people` is the user. `robot_start`: room to relative weight.
    """

    format: Format
    name: str
    rooms: dict[str, Room] = Field(min_length=1)
    doorways: dict[str, Doorway]
    furniture: dict[str, Furniture]
    things: dict[str, Item]
    people: dict[str, Person] = Field(min_length=1)
    robot_start: Weights = Field(min_length=1)
    grasp_slip: Probability = 0.0
    missed_detection: Probability = 0.0

    @model_validator(mode="after")
    def _check(self) -> House:
        floors = {self.floor_of(room): f"the floor of {room}" for room in self.rooms}
        taken = {ROBOT: "the robot", **floors}
        for section in ("rooms", "doorways", "furniture", "things", "people"):
            for name in getattr(self, section):
                key = f"{section}.{name}"
                if not name.isidentifier() or name != name.lower():
                    raise ValueError(
                        f"{key}: {name!r} is no lower-case identifier; expected letters, digits and underscores, "
                        "as in living_room"
                    )
                if _RESERVED.fullmatch(name):
                    raise ValueError(
                        f"{key}: the name {name!r} is taken by planning, as slot_1 is for a slot of the tray; give "
                        "another one"
                    )
                if name in taken:
                    raise ValueError(f"{key}: the name {name!r} stands twice, it is that of {taken[name]}")
                taken[name] = key
        for name, piece in self.furniture.items():
            if piece.room not in self.rooms:
                raise ValueError(f"furniture.{name}: unknown room {piece.room!r}{among(piece.room, self.rooms)}")
            if piece.part_of is not None and piece.part_of not in self.furniture:
                raise ValueError(
                    f"furniture.{name}: part_of names the unknown {piece.part_of!r}"
                    f"{among(piece.part_of, (other for other in self.furniture if other != name))}"
                )
        for name, doorway in self.doorways.items():
            for room in doorway.rooms:
                if room not in self.rooms:
                    raise ValueError(f"doorways.{name}: unknown room {room!r}{among(room, self.rooms)}")
        return self

    @staticmethod
    def floor_of(room: str) -> str:
        """The name of a room's floor, a place like any surface."""
        return f"{room}_floor"

    @property
    def user(self) -> str:
        return next(iter(self.people))

    def places(self) -> tuple[str, ...]:
        """Everything fixed that has a row in the entity table: furniture and fixtures, doors in doorways, floors."""
        doors = tuple(name for name, doorway in self.doorways.items() if doorway.kind is not None)
        return (*self.furniture, *doors, *(self.floor_of(room) for room in self.rooms))

    def places_by_name(self) -> dict[str, tuple[str, ...]]:
        """The places that a name means, be it one's own or that of a kind, in order."""
        named: dict[str, tuple[str, ...]] = {}
        for place in self.places():
            for name in dict.fromkeys((place, self.kind_of(place))):
                named[name] = (*named.get(name, ()), place)
        return named

    def entities(self) -> tuple[str, ...]:
        """The rows of the entity table in order: places, things, people (the user first), and "robot" last."""
        return (*self.places(), *self.things, *self.people, ROBOT)

    def kind_of(self, name: str) -> str:
        """The kind of an entity, room or doorway; "floor" for floors. Raises `KeyError` (also for plain openings)."""
        for section in (self.furniture, self.things, self.rooms, self.people):
            if name in section:
                return section[name].kind
        if name in self.doorways:
            kind = self.doorways[name].kind
            if kind is not None:
                return kind
        if name.removesuffix("_floor") in self.rooms:
            return "floor"
        raise KeyError(name)

    def kind(self, name: str, kinds: Kinds) -> Kind:
        return kinds.kinds[self.kind_of(name)]
