"""Spots: where in a house a small thing can lie, and where a person or the robot can stand."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.clearing import Bools, Clearing, Disc, Free, Point, are_apart
from decomplex_bt.envs.geometry import WALL_RADIUS, Floats, Geometry, Rect
from decomplex_bt.envs.stream import Source
from decomplex_bt.envs.ways import Ways

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
MOST_STANDING = 1000  # spots of one floor looked at so, for each costs time in proportion to the floor
APPROACH = 0.75  # [m] a place is used from where its footprint is so near to the robot's centre

MOST_COMPANIES = 8192
"""People standing together for whom it is remembered whether they leave the ways free."""
MOST_REACHED = 1024
"""People standing together for whom it is remembered, cell by cell, what the robot gets to past them."""
Company = tuple[int, frozenset[Point]]
"""The room that people are in, and where they stand in it, whoever stands where."""


class Spots:
    """The spots of one house; read only, shared by all its episodes.

    `listed`: of a place and a radius the spots of `lying` where nothing else lies there.
    """

    def __init__(self, geometry: Geometry) -> None:
        self.geometry = geometry
        self._floors = frozenset(int(row) for row in geometry.floor_row)
        self._of_place: dict[int, Floats] = {}
        self._standing: dict[int, Clearing] = {}
        self._leaves_way: dict[Company, bool] = {}
        self._gets_to: dict[Company, Bools] = {}
        self._lying: dict[tuple[int, float], Floats] = {}
        self.listed = _Listed(self)

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
        self, place: int, radius: float, taken: Collection[Disc], rng: Source, *, tries: int = TRIES
    ) -> Point | None:
        """One of the spots of `lying`, each as likely; None where there is none. Tries some before it looks at all."""
        spots = self.listed[place, radius]
        count = len(spots)
        for _ in range(tries if count else 0):
            spot = x, y = spots[int(rng.random() * count)]
            for ox, oy, other in taken:
                across, along, gap = x - ox, y - oy, radius + other
                if across * across + along * along < gap * gap:
                    break
            else:
                return spot
        left = Free(spots, are_apart(self.lying(place, radius), radius, tuple(taken)).nonzero()[0]) if spots else ()
        return left[int(rng.random() * len(left))] if left else None

    def is_floor(self, place: int) -> bool:
        return place in self._floors

    def standing(self, room: int, taken: Iterable[Disc] = ()) -> Sequence[Point]:
        """Spots at which a person can stand in a room so that the robot still gets everywhere in it."""
        if room not in self._standing:
            floor = int(self.geometry.floor_row[room])
            points = self._candidates(floor)[self._floor_clearance[room] >= PERSON_RADIUS + FLOOR_GAP]
            ways = self._ways[room]
            points = points[:: max(STANDING_STRIDE, -(-len(points) // MOST_STANDING))]
            free = [ways.are_free(((x, y),)) for x, y in points.tolist()]
            spots = points[np.array(free, dtype=bool)]
            for x, y in spots.tolist():
                ways.keep(x, y)
            self._standing[room] = Clearing(spots, PERSON_RADIUS + 2 * PASSAGE)
        return self._standing[room].free(self._near(room, taken))

    def leaves_way(self, room: int, people: Iterable[Point]) -> bool:
        """Whether the robot still gets everywhere in a room with all these people standing in it."""
        company = room, frozenset(people)
        leaves_way = self._leaves_way.get(company)
        if leaves_way is None:
            leaves_way = self._ways[room].are_free(company[1])
            _keep(self._leaves_way, company, leaves_way, MOST_COMPANIES)
        return leaves_way

    def robot(self, room: int, taken: Iterable[Disc] = (), people: Iterable[Point] = ()) -> Sequence[Point]:
        """Spots at which the robot can stand in a room and get everywhere in it, past the people there."""
        clearing, cells = self._robot_spots[room]
        company = room, frozenset(people)
        gets_to = self._gets_to.get(company)
        if gets_to is None:
            gets_to = self._ways[room].reached(company[1])[cells]
            _keep(self._gets_to, company, gets_to, MOST_REACHED)
        return clearing.free(self._near(room, taken), among=gets_to)

    def is_free(self, x: float, y: float, radius: float, taken: Iterable[Disc]) -> bool:
        """Whether a thing can be put down here on the floor: off furniture, walls and everything taken."""
        point = np.array([[x, y]])
        room = int(self.geometry.rooms_at(point)[0])
        return bool(self._clearance(point, room)[0] >= radius and len(_apart(point, radius, taken)))

    def _near(self, room: int, taken: Iterable[Disc]) -> list[Disc]:
        """Of what is taken, that which may be in the way of somebody in a room."""
        x0, y0, x1, y1 = self._surroundings[room]
        return [
            disc
            for disc in taken
            if x0 < disc[0] + disc[2] and disc[0] - disc[2] < x1 and y0 < disc[1] + disc[2] and disc[1] - disc[2] < y1
        ]

    @cached_property
    def _surroundings(self) -> list[Rect]:
        """Per room the rectangle around it out of which nobody in it stands in anybody's way."""
        gap = PERSON_RADIUS + 2 * PASSAGE
        return [(x0 - gap, y0 - gap, x1 + gap, y1 + gap) for x0, y0, x1, y1 in self.geometry.room_rects.tolist()]

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
    def _robot_spots(self) -> tuple[tuple[Clearing, NDArray[np.int64]], ...]:
        """Per room, where the robot can stand in it, and the cells of its ways that these spots are in."""
        spots = []
        for room, floor in enumerate(self.geometry.floor_row):
            points = self._candidates(int(floor))[self._floor_clearance[room] >= PASSAGE]
            spots.append((Clearing(points, PASSAGE), self._ways[room].cells_of(points)))
        return tuple(spots)

    @cached_property
    def _ways(self) -> tuple[Ways, ...]:
        return tuple(self._ways_of(room) for room in range(len(self.geometry.rooms)))

    def _ways_of(self, room: int) -> Ways:
        geometry = self.geometry
        x0, y0, x1, y1 = geometry.room_rects[room].tolist()
        cells = _grid((x0, y0, x1, y1), WAY_PITCH)
        middles = [(portal.middle.real, portal.middle.imag) for portal in geometry.portals[room]]
        doorways = [np.hypot(*(cells - middle).T) <= DOORWAY_REACH for middle in middles]
        passable = np.logical_or.reduce([self._clearance(cells, room) >= PASSAGE, *doorways])
        used = [
            _distances(cells, _rect(geometry, name)) <= APPROACH
            for name, piece in geometry.house.furniture.items()
            if piece.room == geometry.rooms[room]
        ]
        marks = np.array([*doorways, *used] or [np.ones(len(cells), dtype=bool)])
        return Ways(cells, passable, marks, PERSON_RADIUS + PASSAGE)


class _Listed(dict[tuple[int, float], list[Point]]):
    """Lists of spots by place and radius, each made when it is first asked for."""

    def __init__(self, spots: Spots) -> None:
        super().__init__()
        self._spots = spots

    def __missing__(self, key: tuple[int, float]) -> list[Point]:
        self[key] = spots = [(x, y) for x, y in self._spots.lying(*key).tolist()]
        return spots


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
    return points[are_apart(points, radius, others)] if others and len(points) else points


def _distances(points: Floats, rect: Rect) -> Floats:
    x0, y0, x1, y1 = rect
    x, y = points[:, 0], points[:, 1]
    return np.hypot(np.maximum(np.maximum(x0 - x, x - x1), 0.0), np.maximum(np.maximum(y0 - y, y - y1), 0.0))


def _rect(geometry: Geometry, place: str) -> Rect:
    x0, y0, x1, y1 = geometry.footprints[geometry.row[place]].tolist()
    return x0, y0, x1, y1


def _keep(memory: dict[Company, Any], company: Company, answer: Any, most: int) -> None:
    if len(memory) >= most:
        memory.clear()
    memory[company] = answer
