"""Spots: where in a house a small thing can lie, and where a person or the robot can stand."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import WALL_RADIUS, Floats, Geometry, Rect

LYING_PITCH = 0.05  # [m] between neighbouring spots on furniture
FLOOR_PITCH = 0.15  # [m] between neighbouring spots on a floor
FLOOR_GAP = 0.03  # [m] kept free between a thing on the floor and furniture or walls
DOORWAY_GAP = 0.7  # [m] nothing lies or stands so near to the middle of a doorway
PERSON_RADIUS = 0.25  # [m]
ROBOT_RADIUS = 0.22  # [m]
PASSAGE = ROBOT_RADIUS + 0.06  # [m] clearance of the robot's centre from what it passes
DOORWAY_REACH = 0.35  # [m] so near to its middle the robot is in a doorway
WAY_PITCH = 0.1  # [m] of the grid on which ways are looked for
TRIES = 12  # spots tried at random before all are looked at
STANDING_STRIDE = 5  # of the spots on a floor, one in so many is looked at as one where a person can stand
APPROACH = 0.75  # [m] a place is used from where its footprint is so near to the robot's centre

Disc = tuple[float, float, float]
"""x, y, radius."""


class Spots:
    """The spots of one house; read only, shared by all its episodes."""

    def __init__(self, geometry: Geometry) -> None:
        self.geometry = geometry
        self._floors = frozenset(int(row) for row in geometry.floor_row)
        self._of_place: dict[int, Floats] = {}
        self._person_spots: dict[int, Floats] = {}
        self._lying: dict[tuple[int, float], Floats] = {}
        self._listed: dict[tuple[int, float], list[list[float]]] = {}

    def lying(self, place: int, radius: float, taken: Iterable[Disc] = ()) -> Floats:
        """`(n, 2)` spots at which a thing of this radius can lie on or in a place, none on another; may be empty."""
        key = (place, radius)
        if key not in self._lying:
            points = self._candidates(place)
            if self.is_floor(place):
                room = int(self.geometry.place_room[place])
                fits = self._floor_clearance[room] >= radius + FLOOR_GAP
            else:
                fits = self._fits(points, place, radius)
            self._lying[key] = points[fits]
        return _apart(self._lying[key], radius, taken)

    def draw_lying(
        self, place: int, radius: float, taken: Collection[Disc], rng: Generator
    ) -> tuple[float, float] | None:
        """One of the spots of `lying`, each as likely; None where there is none. Tries some before it looks at all."""
        key = (place, radius)
        if key not in self._listed:
            self._listed[key] = self.lying(place, radius).tolist()
        spots = self._listed[key]
        count, draw = len(spots), rng.random
        for _ in range(TRIES if spots else 0):
            x, y = spots[int(draw() * count)]
            for ox, oy, other in taken:
                if (x - ox) ** 2 + (y - oy) ** 2 < (radius + other) ** 2:
                    break
            else:
                return x, y
        left = self.lying(place, radius, taken).tolist()
        return tuple(left[int(rng.random() * len(left))]) if left else None

    def is_floor(self, place: int) -> bool:
        return place in self._floors

    def standing(self, room: int, taken: Iterable[Disc] = ()) -> Floats:
        """`(n, 2)` spots where a person can stand in a room so that the robot still gets everywhere in it."""
        if room not in self._person_spots:
            floor = int(self.geometry.floor_row[room])
            points = self._candidates(floor)[self._floor_clearance[room] >= PERSON_RADIUS + FLOOR_GAP]
            free = [self._ways[room].leaves_way_past(x, y) for x, y in points[::STANDING_STRIDE].tolist()]
            self._person_spots[room] = points[::STANDING_STRIDE][np.array(free, dtype=bool)]
        return _apart(self._person_spots[room], PERSON_RADIUS + 2 * PASSAGE, taken)

    def leaves_way(self, room: int, people: Iterable[tuple[float, float]]) -> bool:
        """Whether the robot still gets everywhere in a room with all these people standing in it."""
        return self._ways[room].are_free(people)

    def robot(self, room: int, taken: Iterable[Disc] = (), people: Iterable[tuple[float, float]] = ()) -> Floats:
        """`(n, 2)` spots where the robot can stand in a room and get everywhere in it, past the people there."""
        points, cells = self._robot_spots[room]
        is_free = self._ways[room].reached(people)[cells]
        discs = tuple(taken)
        return points[is_free & _are_apart(points, PASSAGE, discs)] if discs else points[is_free]

    def is_free(self, x: float, y: float, radius: float, taken: Iterable[Disc]) -> bool:
        """Whether a thing can be put down here on the floor: off furniture, walls and everything taken."""
        point = np.array([[x, y]])
        room = int(self.geometry.rooms_at(point)[0])
        return bool(self._clearance(point, room)[0] >= radius and len(_apart(point, radius, taken)))

    def _candidates(self, place: int) -> Floats:
        if place not in self._of_place:
            x0, y0, x1, y1 = self.geometry.footprints[place]
            pitch = FLOOR_PITCH if self.is_floor(place) else LYING_PITCH
            self._of_place[place] = _grid((x0, y0, x1, y1), pitch)
        return self._of_place[place]

    def _fits(self, points: Floats, place: int, radius: float) -> NDArray[np.bool_]:
        """Which points keep the thing within the footprint (where it is too small: at its middle) and off its parts."""
        x0, y0, x1, y1 = self.geometry.footprints[place]
        fits = np.ones(len(points), dtype=bool)
        for axis, low, high in ((0, x0, x1), (1, y0, y1)):
            slack = max((high - low) / 2 - radius, LYING_PITCH)
            fits &= np.abs(points[:, axis] - (low + high) / 2) <= slack
        for part in self._parts.get(place, ()):
            fits &= _distances(points, part) > radius / 2
        return fits

    @cached_property
    def _parts(self) -> dict[int, list[Rect]]:
        geometry = self.geometry
        parts: dict[int, list[Rect]] = {}
        for name, piece in geometry.house.furniture.items():
            if piece.part_of is not None:
                x0, y0, x1, y1 = geometry.footprints[geometry.row[name]]
                parts.setdefault(geometry.row[piece.part_of], []).append((x0, y0, x1, y1))
        return parts

    @cached_property
    def _floor_clearance(self) -> tuple[Floats, ...]:
        """Per room, the clearance of each of its floor's candidates from furniture and walls, 0 near doorways."""
        return tuple(
            self._clearance(self._candidates(int(floor)), room) * self._off_doorways(self._candidates(int(floor)))
            for room, floor in enumerate(self.geometry.floor_row)
        )

    def _clearance(self, points: Floats, room: int) -> Floats:
        x0, y0, x1, y1 = self.geometry.room_rects[room]
        clearance = (
            np.minimum.reduce([points[:, 0] - x0, x1 - points[:, 0], points[:, 1] - y0, y1 - points[:, 1]])
            - WALL_RADIUS
        )
        for block in self.geometry.blocks:
            np.minimum(clearance, _distances(points, block), out=clearance)
        return clearance

    def _off_doorways(self, points: Floats) -> NDArray[np.bool_]:
        off = np.ones(len(points), dtype=bool)
        for ax, ay, bx, by in self.geometry.openings.values():
            off &= np.hypot(points[:, 0] - (ax + bx) / 2, points[:, 1] - (ay + by) / 2) >= DOORWAY_GAP
        return off

    @cached_property
    def _robot_spots(self) -> tuple[tuple[Floats, NDArray[np.int64]], ...]:
        """Per room, where the robot can stand in it, and the cells of its ways that these spots are in."""
        spots = []
        for room, floor in enumerate(self.geometry.floor_row):
            points = self._candidates(int(floor))[self._floor_clearance[room] >= PASSAGE]
            spots.append((points, self._ways[room].cells_of(points)))
        return tuple(spots)

    @cached_property
    def _ways(self) -> tuple[_Ways, ...]:
        return tuple(_Ways(self, room) for room in range(len(self.geometry.rooms)))


class _Ways:
    """The ways through one room: whether all that is used in it hangs together when people stand in them."""

    def __init__(self, spots: Spots, room: int) -> None:
        geometry = spots.geometry
        x0, y0, x1, y1 = geometry.room_rects[room].tolist()
        self._cells = cells = _grid((x0, y0, x1, y1), WAY_PITCH)
        self._shape = len(np.unique(cells[:, 1])), len(np.unique(cells[:, 0]))
        middles = [(portal.middle.real, portal.middle.imag) for portal in geometry.portals[room]]
        doorways = [np.hypot(*(cells - middle).T) <= DOORWAY_REACH for middle in middles]
        self._passable = np.logical_or.reduce([spots._clearance(cells, room) >= PASSAGE, *doorways])
        used = [
            _distances(cells, _rect(geometry, name)) <= APPROACH
            for name, piece in geometry.house.furniture.items()
            if piece.room == geometry.rooms[room]
        ]
        self._past_one: dict[frozenset[tuple[float, float]], NDArray[np.uint8]] = {}
        self._last: tuple[frozenset[tuple[float, float]], NDArray[np.bool_]] = frozenset(), self._passable
        self._marks = np.array([*doorways, *used] or [np.ones(len(cells), dtype=bool)])

    def are_free(self, people: Iterable[tuple[float, float]]) -> bool:
        """Whether the free cells that hang together with the first doorway touch every doorway and every place."""
        return bool((self._marks & self.reached(people)).any(axis=1).all())

    def cells_of(self, points: Floats) -> NDArray[np.int64]:
        """The cells that points lie in."""
        rows, columns = self._shape
        low, high = self._cells[0], self._cells[-1]
        steps = np.rint((points - low) / np.maximum(high - low, 1e-9) * (columns - 1, rows - 1)).astype(np.int64)
        return steps[:, 1] * columns + steps[:, 0]

    def reached(self, people: Iterable[tuple[float, float]]) -> NDArray[np.bool_]:
        """Which cells hang together with the first doorway, past the people; answers that come again are kept."""
        standing = frozenset(people)
        if not standing:
            return self._reached_alone
        if len(standing) == 1 and standing in self._past_one:
            return np.unpackbits(self._past_one[standing], count=len(self._passable)).view(np.bool_)
        last = self._last
        if last[0] != standing:
            self._last = last = standing, self._flooded(standing)
        return last[1]

    @cached_property
    def _reached_alone(self) -> NDArray[np.bool_]:
        return self._flooded(())

    def leaves_way_past(self, x: float, y: float) -> bool:
        """Whether a person standing here leaves all ways free; the answer is kept, for they may stand here again."""
        standing = frozenset(((x, y),))
        self._past_one[standing] = np.packbits(self._flooded(standing))
        return self.are_free(standing)

    def _flooded(self, people: Iterable[tuple[float, float]]) -> NDArray[np.bool_]:
        free = self._passable.copy()
        for x, y in sorted(people):
            free &= (self._cells[:, 0] - x) ** 2 + (self._cells[:, 1] - y) ** 2 >= (PERSON_RADIUS + PASSAGE) ** 2
        return _flood(free.reshape(self._shape), self._marks[0].reshape(self._shape)).ravel()


def _grid(rect: Rect, pitch: float) -> Floats:
    """`(n, 2)` points at the middles of a grid's cells, of at most this pitch, row by row."""
    x0, y0, x1, y1 = rect
    columns, rows = (max(1, int(np.ceil((high - low) / pitch - 1e-9))) for low, high in ((x0, x1), (y0, y1)))
    x = x0 + (np.arange(columns) + 0.5) * (x1 - x0) / columns
    y = y0 + (np.arange(rows) + 0.5) * (y1 - y0) / rows
    return np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)


def _apart(points: Floats, radius: float, taken: Iterable[Disc]) -> Floats:
    """The points at which a disc touches none of those taken."""
    others: Sequence[Disc] = tuple(taken)
    return points[_are_apart(points, radius, others)] if others and len(points) else points


def _are_apart(points: Floats, radius: float, taken: Sequence[Disc]) -> NDArray[np.bool_]:
    discs = np.array(taken)
    gaps = np.hypot(points[:, :1] - discs[:, 0], points[:, 1:] - discs[:, 1])
    return (gaps >= discs[:, 2] + radius).all(axis=1)


def _distances(points: Floats, rect: Rect) -> Floats:
    x0, y0, x1, y1 = rect
    x, y = points[:, 0], points[:, 1]
    return np.hypot(np.maximum(np.maximum(x0 - x, x - x1), 0.0), np.maximum(np.maximum(y0 - y, y - y1), 0.0))


def _flood(free: NDArray[np.bool_], seeds: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """The free cells that hang together with the seeds, over edges."""
    # Only here: it takes longer to import than a house takes to be read.
    from scipy.ndimage import label

    labels, count = label(free)
    is_hit = np.zeros(count + 1, dtype=bool)
    is_hit[labels[seeds]] = True
    is_hit[0] = False  # what is not free
    reached: NDArray[np.bool_] = is_hit[labels]
    return reached


def _rect(geometry: Geometry, place: str) -> Rect:
    x0, y0, x1, y1 = geometry.footprints[geometry.row[place]].tolist()
    return x0, y0, x1, y1
