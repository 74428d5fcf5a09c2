"""The scene: points that stand for what is in the rooms in sight, and which of them can be seen from where.

Everything is asked of all points at once, as the signs of one product of matrices: being within a distance, in the
field of view, or in the wedge that a doorway leaves, is linear in the features of a point (its coordinates, its squared
distance from the origin, and the squared distances from which it can be seen and looked over).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from math import ceil, cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.wedges import Wedge

INSET = 0.04  # [m] the sample points of furniture lie so far within its footprint
FLOOR_INSET = 0.1  # [m] the sample points of a floor lie so far within its room
FLOOR_SAMPLES = 1.2  # [m] at most between the sample points of a floor
NEVER = -1e6  # [m²] in place of a squared distance: not even from right there
SLACK = -1e-9
"""What counts as not negative: what the robot carries lies at its very eye, on the border of everything."""
SQUARE, PLACE_X, PLACE_Y, LIMIT, FULL_LIMIT, ONE = range(6)
"""The features of a point: minus its squared distance from the origin, x, y, and what else there is to a bound."""

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]
Rows = NDArray[np.int64]


class RoomSamples(NamedTuple):
    """The points of the fixed places of one room. `features` `(6, n)`; segment `i` is the place `rows[i]`, its points
    begin at `starts[i]`. `holding`: the segments of what can be looked over. `floor`: the points of the floor."""

    features: Floats
    rows: Rows
    starts: Rows
    holding: Rows
    floor: slice


class Samples:
    """What sensing needs of a house, made once. `floor_starts`: where each floor begins among all points of floors."""

    def __init__(self, geometry: Geometry, reach: float, inside_reach: float) -> None:
        self.reach = reach
        kinds = [geometry.house.kind(name, geometry.kinds) for name in geometry.names[: geometry.place_count]]
        self.is_inside = np.array([kind.inside for kind in kinds])
        self.is_floor = np.isin(np.arange(geometry.place_count), geometry.floor_row)
        of_room: list[list[tuple[int, list[tuple[float, float]]]]] = [[] for _ in geometry.rooms]
        for place in range(geometry.place_count):
            for room, points in _points(geometry, place):
                of_room[room].append((place, points))
        full = [
            (inside_reach if kind.inside else reach) ** 2 if kind.surface or kind.inside else NEVER for kind in kinds
        ]
        self.rooms = tuple(self._lay_out(segments, np.array(full)) for segments in of_room)
        sizes = [room.floor.stop - room.floor.start for room in self.rooms]
        self.floor_starts = np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.int64)
        self.floor_count = sum(sizes)
        self.floors = [
            slice(start, start + size) for start, size in zip(self.floor_starts.tolist(), sizes, strict=True)
        ]

    def _lay_out(self, segments: Sequence[tuple[int, list[tuple[float, float]]]], full: Floats) -> RoomSamples:
        rows = np.array([place for place, _ in segments])
        counts = [len(points) for _, points in segments]
        starts = np.concatenate(([0], np.cumsum(counts)[:-1])).astype(np.int64)
        features = _features(np.array([point for _, points in segments for point in points]))
        features[LIMIT] = self.reach**2
        features[FULL_LIMIT] = np.repeat(full[rows], counts)
        floor = int(np.flatnonzero(self.is_floor[rows])[0])
        return RoomSamples(
            features=features,
            rows=rows,
            starts=starts,
            holding=np.flatnonzero(full[rows] > 0),
            floor=slice(int(starts[floor]), int(starts[floor]) + counts[floor]),
        )


class Scene:
    """What is in some rooms, the first of which is the robot's: fixed places, and the things and people there now.

    Each room's points lie together (`spans`), those of its places first. Segment `i` is the entity `rows[i]`, its
    points begin at `starts[i]`. `twins`: segments of what stands in two of the rooms, a door, besides its last one,
    with its row. `holding`: the segments of what can be looked over, `holding_rows` their rows. `floors`: which points
    are a floor's, and which of all floors' points they are. `movable`: rows of the things and people, at the points
    `where`; `moved_at` is the caller's note of when they were brought in line last.
    """

    def __init__(self, samples: Samples, rooms: tuple[int, ...], movable: Sequence[Rows], limit: Floats) -> None:
        self.rooms = rooms
        self.moved_at = -1
        features, rows, starts, holding = [], [], [], []
        self.spans: dict[int, slice] = {}
        self.floors: list[tuple[slice, slice]] = []
        where: list[int] = []
        count = segments = 0
        for room, moving in zip(rooms, movable, strict=True):
            fixed = samples.rooms[room]
            size, mobile = fixed.features.shape[1], len(moving)
            points = np.zeros((6, mobile))
            points[LIMIT], points[FULL_LIMIT], points[ONE] = limit[moving] ** 2, NEVER, 1.0
            features += [fixed.features, points]
            rows += [fixed.rows, moving]
            starts += [fixed.starts + count, np.arange(count + size, count + size + mobile)]
            holding.append(fixed.holding + segments)
            where.extend(range(count + size, count + size + mobile))
            self.floors.append((slice(fixed.floor.start + count, fixed.floor.stop + count), samples.floors[room]))
            self.spans[room] = slice(count, count + size + mobile)
            count, segments = count + size + mobile, segments + len(fixed.rows) + mobile
        self.features = np.concatenate(features, axis=1)
        self.rows, self.starts = np.concatenate(rows), np.concatenate(starts)
        self.holding = np.concatenate(holding)
        self.holding_rows = self.rows[self.holding]
        self.movable, self.where = np.concatenate(movable), np.array(where, dtype=np.int64)
        listed = self.rows.tolist()
        last = {row: segment for segment, row in enumerate(listed)}
        self.twins = [(segment, row) for segment, row in enumerate(listed) if last[row] != segment]

    def move(self, position: Floats) -> None:
        """Brings the points of things and people in line with all positions, `(rows, 2)`."""
        if not self.movable.size:
            return
        at = position[self.movable]
        self.features[PLACE_X : PLACE_Y + 1, self.where] = at.T
        self.features[SQUARE, self.where] = -(at * at).sum(axis=1)

    def view(
        self, eye: complex, heading: float, half_angle: float, beyond: Sequence[tuple[int, Wedge]]
    ) -> tuple[Bools, Bools]:
        """For each point whether it is in view, and whether it is so from near enough to be looked over.

        `half_angle` [rad]: half of the field of view. `beyond`: the wedges into the other rooms.
        """
        x, y = eye.real, eye.imag
        square = -x * x - y * y
        bounds = [1.0, 2 * x, 2 * y, 1.0, 0.0, square, 1.0, 2 * x, 2 * y, 0.0, 1.0, square]
        for side in (-half_angle, half_angle):
            ux, uy = cos(heading + side), sin(heading + side)
            if side > 0:
                ux, uy = -ux, -uy
            bounds += (0.0, -uy, ux, 0.0, 0.0, uy * x - ux * y)
        for _, (right, left) in beyond:
            ux, uy = right.real, right.imag
            bounds += (0.0, -uy, ux, 0.0, 0.0, uy * x - ux * y)
            ux, uy = left.real, left.imag
            bounds += (0.0, uy, -ux, 0.0, 0.0, ux * y - uy * x)
        is_within = np.dot(np.array(bounds).reshape(-1, 6), self.features) >= SLACK
        in_view = is_within[0]
        if half_angle < np.pi / 2:
            in_view &= is_within[2]
            in_view &= is_within[3]
        elif half_angle < np.pi:
            in_view &= is_within[2] | is_within[3]
        self._cut(in_view, is_within, beyond)
        return in_view, is_within[1] & in_view

    def _cut(self, in_view: Bools, is_within: Bools, beyond: Sequence[tuple[int, Wedge]]) -> None:
        """Takes out of view what is in another room and in no wedge that leads there."""
        if len(beyond) == len(self.rooms) - 1:  # one way into each of them
            for index, (room, _) in enumerate(beyond):
                span = self.spans[room]
                seen = in_view[span]
                seen &= is_within[2 * index + 4, span]
                seen &= is_within[2 * index + 5, span]
            return
        for room in self.rooms[1:]:
            span = self.spans[room]
            ways = [index for index, (other, _) in enumerate(beyond) if other == room]
            through = [is_within[2 * index + 4, span] & is_within[2 * index + 5, span] for index in ways]
            in_view[span] &= np.logical_or.reduce(through)


@lru_cache(maxsize=8)
def samples_of(geometry: Geometry, reach: float, inside_reach: float) -> Samples:
    """The samples of a house, for one who sees so far; shared by all episodes in it."""
    return Samples(geometry, reach, inside_reach)


def _features(points: Floats) -> Floats:
    """`(6, n)`, of `(n, 2)` points."""
    features = np.zeros((6, len(points)))
    features[SQUARE] = -(points * points).sum(axis=1)
    features[PLACE_X : PLACE_Y + 1] = points.T
    features[ONE] = 1.0
    return features


def _points(geometry: Geometry, place: int) -> Iterator[tuple[int, list[tuple[float, float]]]]:
    """The rooms that a place is seen in, with the points that stand for it there."""
    name = geometry.names[place]
    x0, y0, x1, y1 = geometry.footprints[place].tolist()
    room = int(geometry.place_room[place])
    if name in geometry.leaves:
        for side in geometry.house.doorways[name].rooms:
            yield geometry.room_index[side], [((x0 + x1) / 2, (y0 + y1) / 2)]
    elif place in geometry.floor_row:
        columns, rows = (ceil((high - low) / FLOOR_SAMPLES) for low, high in ((x0, x1), (y0, y1)))
        # The corners of a grid, not its middles: what lies between points in view is then in view as well.
        across = np.linspace(x0 + FLOOR_INSET, x1 - FLOOR_INSET, columns + 1).tolist()
        along = np.linspace(y0 + FLOOR_INSET, y1 - FLOOR_INSET, rows + 1).tolist()
        yield room, [(x, y) for x in across for y in along]
    else:
        yield room, [(x, y) for x in (x0 + INSET, x1 - INSET) for y in (y0 + INSET, y1 - INSET)]
