"""A house as data: rooms, doorways, furniture, things and people, before any chance is drawn.

World frame: origin bottom left, x to the right, y up, metres; headings in radians, counter-clockwise from +x.
"""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from decomplex_bt.domain.document import Format, Probability, Record, Weights
from decomplex_bt.domain.kinds import Kind, Kinds

Side = Literal["north", "east", "south", "west"]


class Room(Record):
    """A rectangular room with a floor on which things can lie. `rect`: x0, y0, x1, y1."""

    kind: str
    rect: tuple[float, float, float, float]


class Doorway(Record):
    """An opening in the wall between two rooms; with a `kind` (bedroom door, ...) it has a leaf that opens and
    closes."""

    rooms: tuple[str, str]
    centre: tuple[float, float]
    width: float = Field(0.95, gt=0)
    kind: str | None = None


class Furniture(Record):
    """Something fixed in a room: furniture, device, container, or a fixture in a wall (front door, window, curtains).

    `centre` and `size` (along x, along y) are its footprint; `sides`: from where it is approached and used.
    `part_of`: it is built into that piece (a desk's drawer) and has no body of its own.
    """

    kind: str
    room: str
    centre: tuple[float, float]
    size: tuple[float, float]
    sides: tuple[Side, ...] = Field(min_length=1)
    part_of: str | None = None


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
    words: tuple[str, ...] = ()
    home: Probability = 1.0
    rooms: Weights = Field(min_length=1)


class House(Record):
    """`house.yaml`. Names are lower-case identifiers, unique over all sections, and serve as PDDL objects.

    The first of `people` is the user. `robot_start`: room to relative weight.
    """

    format: Format
    name: str
    rooms: dict[str, Room]
    doorways: dict[str, Doorway]
    furniture: dict[str, Furniture]
    things: dict[str, Item]
    people: dict[str, Person]
    robot_start: Weights = Field(min_length=1)
    grasp_slip: Probability = 0.0
    missed_detection: Probability = 0.0

    @model_validator(mode="after")
    def _check(self) -> House:
        names = [*self.rooms, *self.doorways, *self.furniture, *self.things, *self.people]
        for name in names:
            if not name.isidentifier() or name != name.lower():
                raise ValueError(f"{name!r} is no lower-case identifier")
        if len(set(names)) != len(names):
            twice = next(name for name in names if names.count(name) > 1)
            raise ValueError(f"the name {twice!r} stands twice")
        for name, piece in self.furniture.items():
            if piece.room not in self.rooms:
                raise ValueError(f"furniture.{name}: unknown room {piece.room!r}")
            if piece.part_of is not None and piece.part_of not in self.furniture:
                raise ValueError(f"furniture.{name}: part_of names the unknown {piece.part_of!r}")
        for name, doorway in self.doorways.items():
            for room in doorway.rooms:
                if room not in self.rooms:
                    raise ValueError(f"doorways.{name}: unknown room {room!r}")
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

    def entities(self) -> tuple[str, ...]:
        """The rows of the entity table in order: places, things, people (the user first), and "robot" last."""
        return (*self.places(), *self.things, *self.people, "robot")

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

    def check_kinds(self, kinds: Kinds) -> None:
        """Raises `ValueError` where a kind is unknown."""
        for name in (*self.places(), *self.things, *self.rooms, *self.people):
            if self.kind_of(name) not in kinds.kinds:
                raise ValueError(f"{name}: unknown kind {self.kind_of(name)!r}")

    def kind(self, name: str, kinds: Kinds) -> Kind:
        return kinds.kinds[self.kind_of(name)]
