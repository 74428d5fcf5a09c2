"""Spots: where in a house a small thing can lie, and where a person or the robot can stand."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import WALL_RADIUS, Floats, Geometry, Rect

LYING_PITCH = 0.05  # [m] between neighbouring spots on furniture
FLOOR_PITCH = 0.15  # [m] between neighbouring spots on a floor
FLOOR_GAP = 0.03  # [m] kept free between a thing on the floor and furniture or walls
DOORWAY_GAP = 0.7  # [m] nothing lies or stands so near to the middle of a doorway
PERSON_RADIUS = 0.25  # [m]
ROBOT_RADIUS = 0.22  # [m]
PASSAGE = ROBOT_RADIUS + 0.06  # [m] clearance of the robot's centre from what it passes
WAYS_KEPT = 4096  # answers of `leaves_way` that are remembered
APPROACH = 0.75  # [m] a place is used from where its footprint is so near to the robot's centre

Disc = tuple[float, float, float]
"""x, y, radius."""


class Spots:
    """The spots of one house; read only, shared by all its episodes."""

    def __init__(self, geometry: Geometry) -> None:
        self.geometry = geometry
        self._floors = frozenset(int(row) for row in geometry.floor_row)
        self._of_place: dict[int, Floats] = {}
        self._ways: dict[tuple[int, tuple[tuple[float, float], ...]], bool] = {}
        self._lying: dict[tuple[int, float], Floats] = {}

    def lying(self, place: int, radius: float, taken: Iterable[Disc] = ()) -> Floats:
        """`(n, 2)` spots at which a thing of this radius can lie on or in a place, none on another; may be empty."""
        key = (place, radius)
        if key not in self._lying:
            points = self._candidates(place)
            if place in self._floors:
                room = int(self.geometry.place_room[place])
                fits = self._floor_clearance[room] >= radius + FLOOR_GAP
            else:
                fits = self._fits(points, place, radius)
            self._lying[key] = points[fits]
        return _apart(self._lying[key], radius, taken)

    def standing(self, room: int, taken: Iterable[Disc] = ()) -> Floats:
        """`(n, 2)` spots where a person can stand in a room so that the robot still gets everywhere in it."""
        return _apart(self._person_spots[room], PERSON_RADIUS + 2 * PASSAGE, taken)

    def leaves_way(self, room: int, people: Iterable[tuple[float, float]]) -> bool:
        """Whether the robot still gets everywhere in a room with all these people standing in it."""
        key = room, tuple(people)
        if key not in self._ways:
            if len(self._ways) >= WAYS_KEPT:
                self._ways.clear()
            self._ways[key] = self._check_way(*key)
        return self._ways[key]

    def robot(self, room: int, taken: Iterable[Disc] = ()) -> Floats:
        """`(n, 2)` spots where the robot can stand in a room."""
        points = self._candidates(int(self.geometry.floor_row[room]))
        return _apart(points[self._floor_clearance[room] >= PASSAGE], PASSAGE, taken)

    def is_free(self, x: float, y: float, radius: float, taken: Iterable[Disc]) -> bool:
        """Whether a thing can be put down here on the floor: off furniture, walls and everything taken."""
        point = np.array([[x, y]])
        room = int(self.geometry.rooms_at(point)[0])
        return bool(self._clearance(point, room)[0] >= radius and len(_apart(point, radius, taken)))

    def _candidates(self, place: int) -> Floats:
        if place not in self._of_place:
            x0, y0, x1, y1 = self.geometry.footprints[place]
            pitch = FLOOR_PITCH if place in self._floors else LYING_PITCH
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
    def _person_spots(self) -> tuple[Floats, ...]:
        return tuple(self._spots_for_people(room) for room in range(len(self.geometry.rooms)))

    def _spots_for_people(self, room: int) -> Floats:
        """Where a person leaves the free space of the room in one piece that touches all that is used in it."""
        floor = int(self.geometry.floor_row[room])
        points = self._candidates(floor)[self._floor_clearance[room] >= PERSON_RADIUS + 0.02]
        x0, y0, x1, y1 = self.geometry.room_rects[room]
        cells = _grid((x0, y0, x1, y1), 0.1)
        if not len(points):
            return points
        shape = (len(np.unique(cells[:, 1])), len(np.unique(cells[:, 0])), -1)
        away = np.hypot(cells[:, :1] - points[:, 0], cells[:, 1:] - points[:, 1])
        # one bit per spot, so that the free space around all spots is flooded at once
        free = np.packbits(self._passable(cells, room)[:, None] & (away >= PERSON_RADIUS + PASSAGE), axis=1)
        marks = self._approaches(cells, room)
        seeds = np.where(marks[0][:, None], free, np.uint8(0))
        reached = _flood(free.reshape(shape), seeds.reshape(shape)).reshape(free.shape)
        touched = np.bitwise_and.reduce([np.bitwise_or.reduce(reached[mark], axis=0) for mark in marks])
        return points[np.unpackbits(touched, count=len(points)).astype(bool)]

    def _check_way(self, room: int, people: tuple[tuple[float, float], ...]) -> bool:
        cells = _grid((*self.geometry.room_rects[room].tolist(),), 0.1)
        shape = (len(np.unique(cells[:, 1])), len(np.unique(cells[:, 0])))
        free = self._passable(cells, room)
        for x, y in people:
            free &= np.hypot(cells[:, 0] - x, cells[:, 1] - y) >= PERSON_RADIUS + PASSAGE
        marks = self._approaches(cells, room)
        packed = free.astype(np.uint8)
        reached = _flood(packed.reshape(*shape, 1), (packed * marks[0]).reshape(*shape, 1)).ravel().astype(bool)
        return all((reached & mark).any() for mark in marks)

    def _passable(self, cells: Floats, room: int) -> NDArray[np.bool_]:
        """Which cells of a room the robot's centre can be at; those in its doorways can."""
        passable = self._clearance(cells, room) >= PASSAGE
        for portal in self.geometry.portals[room]:
            middle = (np.array(portal.left) + np.array(portal.right)) / 2
            passable |= np.hypot(*(cells - middle).T) <= 0.35
        return passable

    def _approaches(self, cells: Floats, room: int) -> list[NDArray[np.bool_]]:
        """For each doorway and each place of a room, the cells from which it is used; the doorways first."""
        marks = []
        for portal in self.geometry.portals[room]:
            middle = (np.array(portal.left) + np.array(portal.right)) / 2
            marks.append(np.hypot(*(cells - middle).T) <= 0.35)
        house, row = self.geometry.house, self.geometry.row
        for name, piece in house.furniture.items():
            if piece.room == self.geometry.rooms[room]:
                x0, y0, x1, y1 = self.geometry.footprints[row[name]]
                marks.append(_distances(cells, (x0, y0, x1, y1)) <= APPROACH)
        return marks or [np.ones(len(cells), dtype=bool)]


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
    if not others or not len(points):
        return points
    discs = np.array(others)
    gaps = np.hypot(points[:, :1] - discs[:, 0], points[:, 1:] - discs[:, 1])
    return points[(gaps >= discs[:, 2] + radius).all(axis=1)]


def _distances(points: Floats, rect: Rect) -> Floats:
    x0, y0, x1, y1 = rect
    x, y = points[:, 0], points[:, 1]
    return np.hypot(np.maximum(np.maximum(x0 - x, x - x1), 0.0), np.maximum(np.maximum(y0 - y, y - y1), 0.0))


def _flood(free: NDArray[np.uint8], seeds: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The free cells that hang together with the seeds, over edges: `(rows, columns, n)`, each bit a map of its own."""
    reached = seeds & free
    before = -1
    while before != (before := int(reached.sum(dtype=np.int64))):
        for _ in range(4):
            reached[1:] |= reached[:-1] & free[1:]
            reached[:-1] |= reached[1:] & free[:-1]
            reached[:, 1:] |= reached[:, :-1] & free[:, 1:]
            reached[:, :-1] |= reached[:, 1:] & free[:, :-1]
    return reached
