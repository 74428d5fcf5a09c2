"""The scene: points that stand for what is in the rooms in sight, and which of them can be seen from where.

Everything is asked of all points at once, as the signs of one product of matrices: being within a distance, in the
field of view, or in the wedge that a doorway leaves, is linear in the features of a point (its coordinates, the squared
distances from which it can be seen and looked over less its own from the origin, and which room it is not in).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from math import ceil, cos, pi, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.wedges import Wedge

INSET = 0.04  # [m] the sample points of furniture lie so far within its footprint
FLOOR_INSET = 0.1  # [m] the sample points of a floor lie so far within its room
FLOOR_SAMPLES = 1.2  # [m] at most between the sample points of a floor
NEVER = -1e6  # [m²] in place of a squared distance: not even from right there
ANYWAY = 1e6  # what lies elsewhere is in a wedge by, or nearly by, twice the area of a triangle in the house [m²]
SLACK = -1e-9
"""What counts as not negative: what the robot carries lies at its very eye, on the border of everything."""
PLACE_X, PLACE_Y, ONE, NEAR, FAR, ELSEWHERE = range(6)
"""The features of a point: x, y, one; from how far it can be looked over and seen, both squared and less its squared
distance from the origin; and from `ELSEWHERE` on, one for each room but the first of a scene, whether it lies in
another."""
NEARNESS, LEFTMOST, RIGHTMOST, RANGE = range(4)
"""What is asked of each point: near enough to be looked over, not left or right of the field of view, within range;
then, for each wedge, not right and not left of it. What lies in another room is in each wedge, as far as asked."""
VARYING = slice(PLACE_X, ONE + 1)  # the features whose part in a question changes with where the eye is
MOST_LAYOUTS = 256
"""Layouts kept at once, for each house."""

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]
Rows = NDArray[np.int64]


class RoomSamples(NamedTuple):
    """The points of the fixed places of one room. `features` `(5, n)`; segment `i` is the place `rows[i]`, its points
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
        self._layouts: dict[tuple[int, ...], Layout] = {}
        sizes = [room.floor.stop - room.floor.start for room in self.rooms]
        self.floor_starts = np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.int64)
        self.floor_count = sum(sizes)
        self.numbers = np.arange(sum(room.features.shape[1] for room in self.rooms) + len(geometry.names))
        self.floors = [
            slice(start, start + size) for start, size in zip(self.floor_starts.tolist(), sizes, strict=True)
        ]

    def layout(self, rooms: tuple[int, ...]) -> Layout:
        """The fixed places of these rooms."""
        layout = self._layouts.get(rooms)
        if layout is None:
            if len(self._layouts) >= MOST_LAYOUTS:
                self._layouts.clear()
            self._layouts[rooms] = layout = self._together(rooms)
        return layout

    def _together(self, rooms: tuple[int, ...]) -> Layout:
        of_rooms = [self.rooms[room] for room in rooms]
        points = np.cumsum([0, *(room.size for room in of_rooms)]).tolist()
        segments = np.cumsum([0, *(room.width for room in of_rooms)]).tolist()
        elsewhere = np.full((len(rooms) - 1, points[-1]), ANYWAY)
        twins: list[tuple[int, int]] = []
        floor_points, floor_numbers = [], []
        for index, (room, of_room) in enumerate(zip(rooms, of_rooms, strict=True)):
            if index:
                elsewhere[index - 1, points[index] : points[index + 1]] = 0.0
            later = rooms[index + 1 :]
            twins += [(segments[index] + segment, row) for segment, row, to in of_room.doors if to in later]
            floor_points.append(self.numbers[of_room.floor] + points[index])
            floor_numbers.append(self.numbers[self.floors[room]])
        rows = np.concatenate([room.rows for room in of_rooms])
        holding = np.concatenate([room.holding + first for room, first in zip(of_rooms, segments, strict=False)])
        return Layout(
            features=np.vstack((np.hstack([room.features for room in of_rooms]), elsewhere)),
            rows=rows,
            starts=np.concatenate([room.starts + first for room, first in zip(of_rooms, points, strict=False)]),
            twins=twins,
            holding=holding,
            holding_rows=rows[holding],
            floor_points=np.concatenate(floor_points),
            floor_numbers=np.concatenate(floor_numbers),
        )

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
        features[FAR] += self.reach**2
        features[NEAR] += np.repeat(full[rows], counts)
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


class Layout(NamedTuple):
    """The fixed places of some rooms, the robot's own first. `features` `(5 + rooms - 1, n)`. Segment `i` is the entity
    `rows[i]`, its points begin at `starts[i]`. `twins`: segments of what stands in two of the rooms, a door, besides
    its last one, with its row. `holding`: the segments of what can be looked over, `holding_rows` their rows.
    `floor_points`: which points are a floor's, `floor_numbers`: which of all floors' points they are."""

    features: Floats
    rows: Rows
    starts: Rows
    twins: list[tuple[int, int]]
    holding: Rows
    holding_rows: Rows
    floor_points: Rows
    floor_numbers: Rows


class Scene:
    """What is in some rooms, the first of which is the robot's: fixed places, then the things and people there now.

    `layout` has the fixed ones; `rows`, `starts` and `features` go on with the things and people, a point each. They
    are handed over for each room (`movable`, their rows), with the squares of the distances from which each can be
    seen. `moved_at` is the caller's note of when they were brought in line last.
    """

    def __init__(
        self, samples: Samples, rooms: tuple[int, ...], movable: Sequence[Rows], limits: Floats, position: Floats
    ) -> None:
        self.rooms = rooms
        self.moved_at = -1
        self.layout = layout = samples.layout(rooms)
        self.movable = np.concatenate(movable)
        self.rows = np.concatenate((layout.rows, self.movable))
        fixed, moving = layout.features.shape[1], len(self.movable)
        self.starts = np.concatenate((layout.starts, samples.numbers[fixed : fixed + moving]))
        self.features = features = np.empty((len(layout.features), fixed + moving))
        features[:, :fixed] = layout.features
        self._points = features[:, fixed:]
        self._points[ONE], self._points[NEAR], self._points[ELSEWHERE:] = 1.0, NEVER, ANYWAY
        begin = len(movable[0])
        for index, of_room in enumerate(movable[1:]):
            self._points[ELSEWHERE + index, begin : begin + len(of_room)] = 0.0
            begin += len(of_room)
        self._limits = limits
        self._questions: dict[tuple[int, ...], Floats] = {}
        self._by_room = self._ask(rooms[1:])
        self.move(position)

    def move(self, position: Floats) -> None:
        """Brings the points of things and people in line with all positions, `(rows, 2)`."""
        if self.movable.size:
            x, y = self._points[PLACE_X : PLACE_Y + 1] = position[self.movable].T
            np.subtract(self._limits, x * x + y * y, out=self._points[FAR])

    def view(
        self, eye: complex, heading: float, half_angle: float, beyond: Sequence[tuple[int, Wedge]]
    ) -> tuple[Bools, Bools]:
        """For each point whether it is in view, and whether it is so from near enough to be looked over.

        `half_angle` [rad]: half of the field of view. `beyond`: the wedges into the other rooms.
        """
        x, y = eye.real, eye.imag
        square = -x * x - y * y
        begin, end = heading - half_angle, heading + half_angle
        rx, ry, lx, ly = cos(begin), sin(begin), cos(end), sin(end)
        near = (2 * x, 2 * y, square)
        varying = [*near, -ry, rx, ry * x - rx * y, ly, -lx, lx * y - ly * x, *near]
        for _, (right, left) in beyond:
            rx, ry, lx, ly = right.real, right.imag, left.real, left.imag
            varying += (-ry, rx, ry * x - rx * y, ly, -lx, lx * y - ly * x)
        has_one_way = len(beyond) == len(self.rooms) - 1
        questions = self._by_room if has_one_way else self._ask(tuple([room for room, _ in beyond]))
        questions[:, VARYING] = np.array(varying).reshape(-1, 3)
        is_within = np.dot(questions, self.features) >= SLACK
        if half_angle >= pi:
            first = RANGE
        elif half_angle < pi / 2:
            first = LEFTMOST
        else:
            first = RIGHTMOST
            np.logical_or(is_within[LEFTMOST], is_within[RIGHTMOST], out=is_within[RIGHTMOST])
        asked = is_within[first:] if has_one_way else [*is_within[first:RANGE], *self._through(is_within, beyond)]
        in_view = np.logical_and.reduce(asked)
        return in_view, is_within[NEARNESS] & in_view

    def _through(self, is_within: Bools, beyond: Sequence[tuple[int, Wedge]]) -> list[Bools]:
        """What must hold of a point in view, where more than one way leads into a room: any of its wedges will do."""
        ways: dict[int, list[Bools]] = {}
        for wedge, (room, _) in enumerate(beyond):
            right = RANGE + 1 + 2 * wedge
            ways.setdefault(room, []).append(is_within[right] & is_within[right + 1])
        return [is_within[RANGE], *(np.logical_or.reduce(through) for through in ways.values())]

    def _ask(self, ways: tuple[int, ...]) -> Floats:
        """What is asked of each point with wedges into these rooms: `(4 + 2 * ways, features)`, to be filled in."""
        questions = self._questions.get(ways)
        if questions is None:
            self._questions[ways] = questions = np.zeros((RANGE + 1 + 2 * len(ways), len(self.features)))
            questions[NEARNESS, NEAR] = questions[RANGE, FAR] = 1.0
            for wedge, room in enumerate(ways):
                right = RANGE + 1 + 2 * wedge
                questions[right : right + 2, ELSEWHERE + self.rooms.index(room) - 1] = 1.0
        return questions


@lru_cache(maxsize=8)
def samples_of(geometry: Geometry, reach: float, inside_reach: float) -> Samples:
    """The samples of a house, for one who sees so far; shared by all episodes in it."""
    return Samples(geometry, reach, inside_reach)


def _features(points: Floats) -> Floats:
    """`(5, n)`, of `(n, 2)` points; the limits are still to be added."""
    features = np.zeros((ELSEWHERE, len(points)))
    x, y = features[PLACE_X : PLACE_Y + 1] = points.T
    features[ONE] = 1.0
    features[NEAR] = features[FAR] = -(x * x + y * y)
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
