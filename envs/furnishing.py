"""Furnishing: sets the furniture of a pattern room up in another room, so that all of it can be got at.

A group is a piece with what is built into it or stands on it. Groups against a wall are moved along the walls and
turned with them; the others stand free. In front of each side from which a group is used, and of each doorway, room is
left for the robot.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

from numpy.random import Generator

from decomplex_bt.domain.house import Furniture, House, Side

Rect = tuple[float, float, float, float]
Wall = Literal["north", "east", "south", "west"]

AISLE = 0.66  # [m] left free in front of a side from which something is used
DOOR_AISLE = 0.75  # [m] left free on either side of a doorway, and to its left and right
AT_WALL = 0.15  # [m] a piece so near to a wall, and used from the other side, stands against it
FREE_STANDING_GAP = 0.85  # [m] between what stands free and the walls
TRIES = 60
_TURNS = {"south": 0, "east": 1, "north": 2, "west": 3}
_SIDES: tuple[Side, ...] = ("south", "east", "north", "west")


@dataclass(frozen=True)
class Group:
    """A piece of the pattern and its parts, by name: with its back to the south wall (`is_at_wall`), or as it stands.

    Rects are relative to the middle of the piece's south edge. `width`, `depth`: of the piece, along the wall and away
    from it.
    """

    root: str
    pieces: dict[str, tuple[str, Rect, tuple[Side, ...], str | None]]
    width: float
    depth: float
    is_at_wall: bool
    is_thin: bool


def groups_of(house: House, room: str, fixtures: frozenset[str]) -> Iterator[Group]:
    """The groups of a room of the pattern, in its order; `fixtures`: kinds that are thin and take no room."""
    for name, piece in house.furniture.items():
        if piece.room == room and piece.part_of is None:
            yield _group(house, name, house.rooms[room].rect, fixtures)


def _group(house: House, root: str, room: Rect, fixtures: frozenset[str]) -> Group:
    piece = house.furniture[root]
    wall = _wall_of(piece, room)
    turn = _TURNS[wall or "south"]
    cx, cy = piece.centre
    members = {root: piece} | {name: part for name, part in house.furniture.items() if _stands_on(house, part, root)}
    rects = {name: _turned(_rect(part, cx, cy), -turn) for name, part in members.items()}
    x0, y0, x1, y1 = rects[root]
    pieces = {
        name: (
            part.kind,
            _moved(rects[name], -(x0 + x1) / 2, -y0),
            tuple(_SIDES[(_SIDES.index(side) - turn) % 4] for side in part.sides),
            part.part_of,
        )
        for name, part in members.items()
    }
    return Group(root, pieces, x1 - x0, y1 - y0, wall is not None, piece.kind in fixtures or min(piece.size) < 0.15)


def _stands_on(house: House, part: Furniture, root: str) -> bool:
    while part.part_of is not None:
        if part.part_of == root:
            return True
        part = house.furniture[part.part_of]
    return False


def _wall_of(piece: Furniture, room: Rect) -> Wall | None:
    """The wall that a piece stands against, if it is used from the side opposite."""
    (cx, cy), (width, depth) = piece.centre, piece.size
    gaps: dict[Wall, float] = {
        "south": cy - depth / 2 - room[1],
        "west": cx - width / 2 - room[0],
        "north": room[3] - cy - depth / 2,
        "east": room[2] - cx - width / 2,
    }
    opposite = {"south": "north", "north": "south", "east": "west", "west": "east"}
    return min(
        (wall for wall in gaps if gaps[wall] < AT_WALL and opposite[wall] in piece.sides),
        key=lambda wall: gaps[wall],
        default=None,
    )


@dataclass
class Furnished:
    """A room being furnished. `bodies`: what stands there; `aisles`: what is to be left free of bodies."""

    room: str
    rect: Rect
    bodies: list[Rect] = field(default_factory=list)
    aisles: list[Rect] = field(default_factory=list)
    furniture: dict[str, Furniture] = field(default_factory=dict)

    def keep_clear(self, doorway: Rect) -> None:
        """Leaves room before a doorway, given as the line it stands on."""
        ax, ay, bx, by = doorway
        self.aisles.append((ax - DOOR_AISLE, ay - DOOR_AISLE, bx + DOOR_AISLE, by + DOOR_AISLE))

    def add(self, group: Group, names: dict[str, str], rng: Generator) -> bool:
        """Sets a group up somewhere, under these names; False where it fits nowhere."""
        for _ in range(TRIES):
            placed = self._try(group, rng)
            if placed is not None:
                break
        else:
            return False
        for name, (kind, _, _, parent) in group.pieces.items():
            rect, sides = placed[name]
            x0, y0, x1, y1 = rect
            self.furniture[names[name]] = Furniture(
                kind=kind,
                room=self.room,
                centre=(round((x0 + x1) / 2, 3), round((y0 + y1) / 2, 3)),
                size=(round(x1 - x0, 3), round(y1 - y0, 3)),
                sides=sides,
                part_of=None if parent is None else names[parent],
            )
        return True

    def _try(self, group: Group, rng: Generator) -> dict[str, tuple[Rect, tuple[Side, ...]]] | None:
        spot = self._at_wall(group, rng) if group.is_at_wall else self._standing_free(group, rng)
        if spot is None:
            return None
        turn, dx, dy = spot
        placed = {
            name: (
                _moved(_turned(rect, turn), dx, dy),
                tuple(_SIDES[(_SIDES.index(side) + turn) % 4] for side in sides),
            )
            for name, (_, rect, sides, _) in group.pieces.items()
        }
        body, sides = placed[group.root]
        front = _SIDES[(turn + 2) % 4]
        used = [side for side in sides if side == front or not group.is_at_wall] or list(sides)
        aisles = [_before(body, side) for side in used]
        if not self._fits(body, aisles):
            return None
        # what is used from several sides need not be so from all, where it stands against a wall
        kept = tuple(side for side in sides if self._is_open(_before(body, side))) or sides
        placed = {name: (rect, own if name != group.root else kept) for name, (rect, own) in placed.items()}
        self.bodies.append(body)
        self.aisles.extend(aisles)
        return placed

    def _at_wall(self, group: Group, rng: Generator) -> tuple[int, float, float] | None:
        """A turn and a shift that bring the group's back to some wall."""
        wall = int(rng.integers(4))
        x0, y0, x1, y1 = self.rect
        along = (x1 - x0) if wall % 2 == 0 else (y1 - y0)
        gap = 0.0 if group.is_thin else 0.06
        slack = along - group.width - 2 * max(gap, 0.05)
        if slack < 0:
            return None
        at = (group.width / 2 + 0.05) + float(rng.random()) * slack
        point = ((x0 + at, y0 + gap), (x1 - gap, y0 + at), (x1 - at, y1 - gap), (x0 + gap, y1 - at))[wall]
        return wall, *point

    def _standing_free(self, group: Group, rng: Generator) -> tuple[int, float, float] | None:
        turn = int(rng.integers(4))
        width, depth = (group.width, group.depth) if turn % 2 == 0 else (group.depth, group.width)
        x0, y0, x1, y1 = self.rect
        low_x, high_x = x0 + FREE_STANDING_GAP + width / 2, x1 - FREE_STANDING_GAP - width / 2
        low_y, high_y = y0 + FREE_STANDING_GAP + depth / 2, y1 - FREE_STANDING_GAP - depth / 2
        if low_x > high_x or low_y > high_y:
            return None
        cx, cy = rng.uniform((low_x, low_y), (high_x, high_y)).tolist()
        back = ((cx, cy - depth / 2), (cx + width / 2, cy), (cx, cy + depth / 2), (cx - width / 2, cy))[turn]
        return turn, *back

    def _fits(self, body: Rect, aisles: Sequence[Rect]) -> bool:
        if any(_overlap(body, other) for other in (*self.bodies, *self.aisles)):
            return False
        return all(self._is_open(aisle) for aisle in aisles)

    def _is_open(self, aisle: Rect) -> bool:
        x0, y0, x1, y1 = self.rect
        is_inside = x0 <= aisle[0] and y0 <= aisle[1] and aisle[2] <= x1 and aisle[3] <= y1
        return is_inside and not any(_overlap(aisle, body) for body in self.bodies)


def _before(body: Rect, side: Side) -> Rect:
    """The aisle before a side of a piece."""
    x0, y0, x1, y1 = body
    widen = max(0.0, (0.6 - (x1 - x0 if side in ("north", "south") else y1 - y0)) / 2)
    if side == "north":
        return x0 - widen, y1, x1 + widen, y1 + AISLE
    if side == "south":
        return x0 - widen, y0 - AISLE, x1 + widen, y0
    if side == "east":
        return x1, y0 - widen, x1 + AISLE, y1 + widen
    return x0 - AISLE, y0 - widen, x0, y1 + widen


def _rect(piece: Furniture, cx: float, cy: float) -> Rect:
    (x, y), (width, depth) = piece.centre, piece.size
    return x - cx - width / 2, y - cy - depth / 2, x - cx + width / 2, y - cy + depth / 2


def _moved(rect: Rect, dx: float, dy: float) -> Rect:
    return rect[0] + dx, rect[1] + dy, rect[2] + dx, rect[3] + dy


def _turned(rect: Rect, turn: int) -> Rect:
    """Turned about the origin by so many quarters, counter-clockwise: what faced south faces east, then north."""
    x0, y0, x1, y1 = rect
    for _ in range(turn % 4):
        x0, y0, x1, y1 = -y1, x0, -y0, x1
    return x0, y0, x1, y1


def _overlap(one: Rect, other: Rect) -> bool:
    return (
        one[0] < other[2] - 1e-6 and other[0] < one[2] - 1e-6 and one[1] < other[3] - 1e-6 and other[1] < one[3] - 1e-6
    )
