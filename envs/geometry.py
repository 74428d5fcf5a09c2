"""The geometry of a house: walls, door leaves, footprints and portals between rooms, computed once.

World frame: origin bottom left, x to the right, y up, metres.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import hypot
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.domain.house import House, Rect
from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.errors import InputError

WALL_RADIUS = 0.05  # [m] half the thickness of a wall
LEAF_RADIUS = 0.03  # [m] half the thickness of a door leaf
EDGE_TOLERANCE = 0.02  # [m] how far a doorway's centre may lie off its rooms' common edge

Segment = tuple[float, float, float, float]
Floats = NDArray[np.float64]


class Portal(NamedTuple):
    """An opening as seen from inside a room: `beyond` is the other one, `right` and `left` its ends (x + iy), in
    counter-clockwise order; `leaf` is the door in it, if any; `middle` and `half` its width."""

    beyond: int
    right: complex
    left: complex
    leaf: str | None
    middle: complex
    half: float


class Geometry:
    """All of a house that never changes in an episode. Read only; shared by every episode in that house.

    `names` are the rows of the entity table and `row` their inverse; `rooms` the room names in order. `footprints`:
    `(places, 4)` x0, y0, x1, y1, a floor's being its room. `place_room`: room index of each place; `room_of_place` the
    same with -1 at its end, which is for nowhere.
    `walls`: centre lines of their bodies, which have round ends. `barriers`: the same walls as what no hand and no
    voice gets past, right up to the openings. `leaves`: door name to the line that its closed leaf stands on.
    `blocks`: footprints of furniture with a body.
    """

    def __init__(self, house: House, kinds: Kinds) -> None:
        self.house = house
        self.kinds = kinds
        self.names = house.entities()
        self.row = {name: row for row, name in enumerate(self.names)}
        self.rooms = tuple(house.rooms)
        self.room_index = {room: index for index, room in enumerate(self.rooms)}
        self.room_rects = np.array([house.rooms[room].rect for room in self.rooms], dtype=float)
        self.place_count = len(house.places())
        self.thing_rows = range(self.place_count, self.place_count + len(house.things))
        self.people_rows = range(self.thing_rows.stop, self.thing_rows.stop + len(house.people))
        self.robot_row = len(self.names) - 1
        self.user_row = self.people_rows[0]
        self.floor_row = np.array([self.row[house.floor_of(room)] for room in self.rooms])
        openings = {name: _opening(house, name) for name in house.doorways}
        self.openings = openings
        self.leaves = {name: line for name, line in openings.items() if house.doorways[name].kind is not None}
        self.footprints = self._footprints()
        self.place_room = np.array([self.room_index[self._room_of(name)] for name in self.names[: self.place_count]])
        self.room_of_place = np.append(self.place_room, -1)
        self.walls = tuple(_walls(house, openings.values(), recess=WALL_RADIUS))
        self.barriers = tuple(_walls(house, openings.values(), recess=0.0))
        self.wall_lines = np.array(self.walls)
        self.blocks = tuple(
            piece.footprint
            for name, piece in house.furniture.items()
            if piece.part_of is None and house.kind(name, kinds).category == "furniture"
        )
        self.portals = self._portals()

    @property
    def bounds(self) -> Rect:
        """The rectangle around all rooms."""
        low, high = self.room_rects[:, :2].min(axis=0), self.room_rects[:, 2:].max(axis=0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])

    def room_at(self, x: float, y: float, *, guess: int = 0) -> int:
        """Index of the room that a point lies in; the nearest one for a point outside all of them.

        `guess`: the room that is looked at first; it saves time and changes nothing.
        """
        x0, y0, x1, y1 = self._rects[guess]
        if x0 < x < x1 and y0 < y < y1:
            return guess
        for index, (x0, y0, x1, y1) in enumerate(self._rects):
            if x0 < x < x1 and y0 < y < y1:
                return index
        best, nearest = 0, float("inf")
        for index, rect in enumerate(self._rects):
            away = distance_to_rect(x, y, rect)
            if away == 0.0:
                return index
            if away < nearest:
                best, nearest = index, away
        return best

    def rooms_at(self, points: Floats) -> NDArray[np.int64]:
        """As `room_at`, for `(n, 2)` points."""
        x, y = points[:, :1], points[:, 1:]
        low_x, low_y, high_x, high_y = self.room_rects.T
        away = np.maximum(np.maximum(low_x - x, x - high_x), np.maximum(low_y - y, y - high_y))
        return np.argmin(np.maximum(away, 0.0), axis=1)

    def distance(self, x: float, y: float, place: int) -> float:
        """Distance from a point to the nearest point of a place's footprint; 0 inside."""
        return distance_to_rect(x, y, self._boxes[place])

    def nearest_point(self, x: float, y: float, place: int) -> tuple[float, float]:
        x0, y0, x1, y1 = self._boxes[place]
        return min(max(x, x0), x1), min(max(y, y0), y1)

    def is_free_line(self, start: tuple[float, float], end: tuple[float, float], leaves: Iterable[str]) -> bool:
        """Whether no wall and none of these closed `leaves` stands between two points.

        A wall and the leaf of a door meet in one point, and so do two walls: what touches one of them is not free.
        """
        stretch = (*start, *end)
        for wall in self.barriers:  # asked in many steps, where `any` takes half as long again
            if meets(stretch, wall):
                return False
        return not any(meets(stretch, self.leaves[leaf]) for leaf in leaves)

    def _footprints(self) -> Floats:
        rects: list[Rect] = [piece.footprint for piece in self.house.furniture.values()]
        for ax, ay, bx, by in self.leaves.values():
            pad_x, pad_y = (WALL_RADIUS, 0.0) if ax == bx else (0.0, WALL_RADIUS)
            rects.append((min(ax, bx) - pad_x, min(ay, by) - pad_y, max(ax, bx) + pad_x, max(ay, by) + pad_y))
        rects.extend(room.rect for room in self.house.rooms.values())
        self._boxes = tuple(rects)
        self._rects = tuple(room.rect for room in self.house.rooms.values())
        return np.array(rects)

    def _room_of(self, place: str) -> str:
        """The room of a place; of a door between two rooms, the first."""
        if place in self.house.furniture:
            return self.house.furniture[place].room
        if place in self.house.doorways:
            return self.house.doorways[place].rooms[0]
        return place.removesuffix("_floor")

    def _portals(self) -> tuple[tuple[Portal, ...], ...]:
        """For each room the openings in its walls."""
        of_room: list[list[Portal]] = [[] for _ in self.rooms]
        for name, (ax, ay, bx, by) in self.openings.items():
            for here, there in (self.house.doorways[name].rooms, self.house.doorways[name].rooms[::-1]):
                index = self.room_index[here]
                x0, y0, x1, y1 = self._rects[index]
                side = (bx - ax) * ((y0 + y1) / 2 - ay) - (by - ay) * ((x0 + x1) / 2 - ax)
                # to a viewer on the left of the line a -> b its start lies on the right
                first, last = complex(ax, ay), complex(bx, by)
                right, left = (first, last) if side > 0 else (last, first)
                leaf = name if name in self.leaves else None
                portal = Portal(self.room_index[there], right, left, leaf, (right + left) / 2, abs(left - right) / 2)
                of_room[index].append(portal)
        return tuple(tuple(portals) for portals in of_room)


def distance_to_rect(x: float, y: float, rect: Rect) -> float:
    x0, y0, x1, y1 = rect
    return hypot(max(x0 - x, 0.0, x - x1), max(y0 - y, 0.0, y - y1))


def meets(first: Segment, second: Segment) -> bool:
    """Whether two segments cross or touch. Two on one line do not, as for one who stands right in a doorway and the
    walls beside it."""
    ax, ay, bx, by = first
    cx, cy, dx, dy = second
    one = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    two = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax)
    if one * two > 0 or one == two == 0:
        return False
    three = (dx - cx) * (ay - cy) - (dy - cy) * (ax - cx)
    four = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx)
    return three * four <= 0


def _opening(house: House, name: str) -> Segment:
    """The line of a doorway, on the common edge of its rooms. Raises `InputError` where it lies on no such edge."""
    doorway = house.doorways[name]
    x, y = doorway.centre
    half = doorway.width / 2
    first, second = (house.rooms[room].rect for room in doorway.rooms)
    for axis, at, along in ((0, x, y), (1, y, x)):
        low = max(first[1 - axis], second[1 - axis])
        high = min(first[3 - axis], second[3 - axis])
        touches = min(abs(first[axis + 2] - second[axis]), abs(second[axis + 2] - first[axis])) < EDGE_TOLERANCE
        on_edge = min(abs(at - first[axis]), abs(at - first[axis + 2])) < EDGE_TOLERANCE
        if touches and on_edge and low <= along - half and along + half <= high:
            return (x, y - half, x, y + half) if axis == 0 else (x - half, y, x + half, y)
    raise InputError(
        f"doorways.{name}: ({x}, {y}) with width {doorway.width} does not lie on the common wall of "
        f"{doorway.rooms[0]} and {doorway.rooms[1]}; move its centre onto that wall"
    )


def _walls(house: House, openings: Iterable[Segment], *, recess: float) -> list[Segment]:
    """Centre lines of all walls: the edges of the rooms, each stretch once, without the openings.

    `recess` [m]: how far before an opening a line ends. A body's line ends early by its own radius, for its ends are
    round.
    """
    lines: dict[tuple[int, float], list[tuple[float, float]]] = {}
    for room in house.rooms.values():
        x0, y0, x1, y1 = room.rect
        for axis, at, low, high in ((0, x0, y0, y1), (0, x1, y0, y1), (1, y0, x0, x1), (1, y1, x0, x1)):
            lines.setdefault((axis, round(at, 6)), []).append((low, high))
    gaps: dict[tuple[int, float], list[tuple[float, float]]] = {}
    for ax, ay, bx, by in openings:
        axis = 0 if ax == bx else 1
        at, low, high = (ax, ay, by) if axis == 0 else (ay, ax, bx)
        gaps.setdefault((axis, round(at, 6)), []).append((low, high))
    walls: list[Segment] = []
    for (axis, at), stretches in sorted(lines.items()):
        for low, high in _without(_merged(stretches), sorted(gaps.get((axis, at), [])), recess):
            walls.append((at, low, at, high) if axis == 0 else (low, at, high, at))
    return walls


def _merged(stretches: list[tuple[float, float]]) -> list[tuple[float, float]]:
    merged: list[tuple[float, float]] = []
    for low, high in sorted(stretches):
        if merged and low <= merged[-1][1] + 1e-9:
            merged[-1] = (merged[-1][0], max(merged[-1][1], high))
        else:
            merged.append((low, high))
    return merged


def _without(
    stretches: list[tuple[float, float]], gaps: list[tuple[float, float]], recess: float
) -> list[tuple[float, float]]:
    """The stretches without the gaps, ending so far before them."""
    left: list[tuple[float, float]] = []
    for low, high in stretches:
        for start, end in gaps:
            if low <= start and end <= high:
                left.append((low, start - recess))
                low = end + recess
        left.append((low, high))
    return [(low, high) for low, high in left if high > low]
