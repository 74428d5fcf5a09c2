"""The scene: points that stand for what is in the rooms in sight, and which of them can be seen from where.

Everything is asked of all points at once, as the signs of one product of matrices: being within a distance, in the
field of view, or in the wedge that a doorway leaves, is linear in the features of a point (its coordinates, its squared
distance from the origin, and the squared distances from which it can be seen and looked over).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
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
    begin at `starts[i]`. `holding`: the segments of what can be looked over. `floor`: the points of the floor. `doors`:
    of each segment that is a door it and its row, and the room that it leads to. `size`, `width`: how many points and
    segments."""

    features: Floats
    rows: Rows
    starts: Rows
    holding: Rows
    floor: slice
    doors: tuple[tuple[int, int, int], ...]
    size: int
    width: int


class Samples:
    """What sensing needs of a house, made once.

    `limit`: from how far what lies at each place can be seen, the last one for what lies at none; `is_floor` likewise.
    `place_at`: of each row the place, that last one for rows that are none.
    `floor_starts`: where each floor begins among all points of floors. `numbers`: as many as there may be points.
    """

    def __init__(self, geometry: Geometry, reach: float, inside_reach: float) -> None:
        self.reach = reach
        kinds = [geometry.house.kind(name, geometry.kinds) for name in geometry.names[: geometry.place_count]]
        self.limit = np.array([*(inside_reach if kind.inside else reach for kind in kinds), reach])
        is_floor = np.isin(np.arange(geometry.place_count), geometry.floor_row)
        self.is_floor = np.append(is_floor, False)
        self.place_at = np.minimum(np.arange(len(geometry.names)), geometry.place_count)
        sides = {geometry.row[leaf]: geometry.house.doorways[leaf].rooms for leaf in geometry.leaves}
        leads = {row: [geometry.room_index[room] for room in rooms] for row, rooms in sides.items()}
        of_room: list[list[tuple[int, list[tuple[float, float]]]]] = [[] for _ in geometry.rooms]
        for place in range(geometry.place_count):
            for room, points in _points(geometry, place):
                of_room[room].append((place, points))
        full = [
            (inside_reach if kind.inside else reach) ** 2 if kind.surface or kind.inside else NEVER for kind in kinds
        ]
        self.rooms = tuple(
            self._lay_out(room, segments, np.array(full), leads) for room, segments in enumerate(of_room)
        )
        sizes = [room.floor.stop - room.floor.start for room in self.rooms]
        self.floor_starts = np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.int64)
        self.floor_count = sum(sizes)
        self.numbers = np.arange(sum(room.features.shape[1] for room in self.rooms) + len(geometry.names))
        self.floors = [
            slice(start, start + size) for start, size in zip(self.floor_starts.tolist(), sizes, strict=True)
        ]

    def _lay_out(
        self,
        room: int,
        segments: Sequence[tuple[int, list[tuple[float, float]]]],
        full: Floats,
        leads: Mapping[int, Sequence[int]],
    ) -> RoomSamples:
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
            doors=tuple(
                (segment, row, sum(leads[row]) - room) for segment, (row, _) in enumerate(segments) if row in leads
            ),
            size=sum(counts),
            width=len(rows),
        )


class Scene:
    """What is in some rooms, the first of which is the robot's: fixed places, and the things and people there now.

    Each room's points lie together (`spans`), those of its places first. Segment `i` is the entity `rows[i]`, its
    points begin at `starts[i]`. `twins`: segments of what stands in two of the rooms, a door, besides its last one,
    with its row. `holding`: the segments of what can be looked over, `holding_rows` their rows. `floors`: which points
    are a floor's, and which of all floors' points they are. `movable`: rows of the things and people, at the points
    `where` (handed over for each room, with their features); `moved_at` is the caller's note of when they were brought
    in line last.
    """

    def __init__(
        self, samples: Samples, rooms: tuple[int, ...], movable: Sequence[tuple[Rows, Floats]], *, moved_at: int = -1
    ) -> None:
        self.rooms = rooms
        self.moved_at = moved_at
        fixed = [samples.rooms[room] for room in rooms]
        counts = [len(moving) for moving, _ in movable]
        mobile = sum(counts)
        size, width = sum([room.size for room in fixed]) + mobile, sum([room.width for room in fixed]) + mobile
        features = self.features = np.empty((6, size))
        rows, starts = self.rows, self.starts = np.empty(width, np.int64), np.empty(width, np.int64)
        self.spans: dict[int, slice] = {}
        self.floors: list[tuple[slice, slice]] = []
        self.twins: list[tuple[int, int]] = []
        holding, where = [], []
        count = segments = 0
        for index, (room, of_room, (moving, points), mobile) in enumerate(
            zip(rooms, fixed, movable, counts, strict=True)
        ):
            first, begin, floor = count, segments, of_room.floor
            count, segments = count + of_room.size, segments + of_room.width
            features[:, first:count] = of_room.features
            rows[begin:segments] = of_room.rows
            np.add(of_room.starts, first, out=starts[begin:segments])
            holding.append(of_room.holding + begin)
            self.twins += [(begin + segment, row) for segment, row, to in of_room.doors if to in rooms[index + 1 :]]
            self.floors.append((slice(floor.start + first, floor.stop + first), samples.floors[room]))
            if mobile:
                features[:, count : count + mobile] = points
                rows[segments : segments + mobile] = moving
                starts[segments : segments + mobile] = at = samples.numbers[count : count + mobile]
                where.append(at)
                count, segments = count + mobile, segments + mobile
            self.spans[room] = slice(first, count)
        self.holding = np.concatenate(holding)
        self.holding_rows = rows[self.holding]
        self.where = np.concatenate(where) if where else samples.numbers[:0]
        self.movable = np.concatenate([moving for moving, _ in movable])

    def move(self, position: Floats) -> None:
        """Brings the points of things and people in line with all positions, `(rows, 2)`."""
        if not self.movable.size:
            return
        at = position[self.movable]
        x, y = self.features[PLACE_X : PLACE_Y + 1, self.where] = at.T
        self.features[SQUARE, self.where] = -(x * x + y * y)

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
            rx, ry, lx, ly = right.real, right.imag, left.real, left.imag
            bounds += (0.0, -ry, rx, 0.0, 0.0, ry * x - rx * y, 0.0, ly, -lx, 0.0, 0.0, lx * y - ly * x)
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


def movable_features(limit: Floats, points: Floats) -> Floats:
    """`(6, n)`, of what moves, can be seen from so far and is at these `(n, 2)` points now."""
    features = _features(points)
    features[LIMIT], features[FULL_LIMIT] = limit**2, NEVER
    return features


def _features(points: Floats) -> Floats:
    """`(6, n)`, of `(n, 2)` points."""
    features = np.zeros((6, len(points)))
    x, y = features[PLACE_X : PLACE_Y + 1] = points.T
    features[SQUARE] = -(x * x + y * y)
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
