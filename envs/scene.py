"""The scene: points that stand for what is in the rooms in sight, and which of them can be seen from where.

Everything is asked of all points at once: being within a distance, in the field of view, or in the wedge that a doorway
leaves, is a linear function of where a point is that is not below a threshold. The thresholds take in what does not
change with where the eye is: from how far a point can be seen and looked over, and in which room it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache, lru_cache
from math import ceil, cos, pi, sin
from struct import Struct
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
PLACE_X, PLACE_Y, ONE = range(3)
"""The coordinates of a point."""
NEARNESS, LEFTMOST, RIGHTMOST, RANGE, WEDGES = range(5)
"""What is asked of each point: near enough to be looked over, not left or right of the field of view, within range;
then, for each wedge, not right and not left of it. What lies in another room is in each wedge, as far as asked."""
MOST_LAYOUTS = 256
"""Layouts kept at once, for each house."""

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]
Rows = NDArray[np.int64]


class Block(NamedTuple):
    """Some places of one room: `rows`, the number of points of each (`sizes`), and of each point `points` `(3, n)`,
    `near` and `far`, the squares of the distances from which it can be looked over and seen [m²]."""

    rows: Rows
    sizes: Rows
    points: Floats
    near: Floats
    far: Floats


RoomSamples = tuple[Block, Block, Block]
"""The points of the fixed places of one room: of what nothing lies on or in, of what something may, of the floor."""


class Samples:
    """What sensing needs of a house, made once.

    `limit`: from how far what lies at each place can be seen, the last one for what lies at none; `is_floor` likewise.
    `place_at`: of each row the place, that last one for rows that are none.
    `floor_starts`: where each floor begins among all points of floors.
    `never_seen`: of points of floors or of rows the time at which it was seen, to be copied. `all_short`: `(places,)`,
    that none is in view with its whole contents; not to be changed.
    """

    def __init__(self, geometry: Geometry, reach: float, inside_reach: float) -> None:
        self.reach = reach
        kinds = [geometry.house.kind(name, geometry.kinds) for name in geometry.names[: geometry.place_count]]
        self.limit = np.array([*(inside_reach if kind.inside else reach for kind in kinds), reach])
        is_floor = np.isin(np.arange(geometry.place_count), geometry.floor_row)
        self.is_floor = np.append(is_floor, False)
        self.place_at = np.minimum(np.arange(len(geometry.names)), geometry.place_count)
        of_room: list[list[tuple[int, list[tuple[float, float]]]]] = [[] for _ in geometry.rooms]
        for place in range(geometry.place_count):
            for room, points in sample_points(geometry, place):
                of_room[room].append((place, points))
        full = [
            (inside_reach if kind.inside else reach) ** 2 if kind.surface or kind.inside else NEVER for kind in kinds
        ]
        self.rooms = tuple(self._lay_out(segments, np.array(full)) for segments in of_room)
        self._layouts: dict[tuple[int, ...], Layout] = {}
        sizes = [floor.points.shape[1] for *_, floor in self.rooms]
        self.floor_starts = np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.int64)
        self.floor_count = sum(sizes)
        self.floor_numbers = np.arange(self.floor_count)
        self.never_seen = np.full(max(self.floor_count, len(geometry.names)), -np.inf)
        self.all_short = np.ones(geometry.place_count, dtype=np.bool_)
        self.floors = [
            slice(start, start + size) for start, size in zip(self.floor_starts.tolist(), sizes, strict=True)
        ]

    def layout(self, ways: tuple[int, ...]) -> Layout:
        """The fixed places in sight from a room, the first of `ways`, with wedges into the others."""
        layout = self._layouts.get(ways)
        if layout is None:
            if len(self._layouts) >= MOST_LAYOUTS:
                self._layouts.clear()
            self._layouts[ways] = layout = self._together(ways)
        return layout

    def _together(self, ways: tuple[int, ...]) -> Layout:
        rooms = tuple(dict.fromkeys(ways))
        kinds = list(zip(*(self.rooms[room] for room in rooms), strict=True))
        blocks = [block for kind in kinds for block in kind]
        rows = np.concatenate([np.repeat(block.rows, block.sizes) for block in blocks])
        first_holding, first_floor = (
            sum(block.points.shape[1] for kind in kinds[:count] for block in kind) for count in (1, 2)
        )
        holding = slice(first_holding, first_floor)
        is_holding = np.zeros(len(self.is_floor) - 1, dtype=np.bool_)
        is_holding[rows[holding]] = True
        room_of = np.repeat(rooms * len(kinds), [block.points.shape[1] for block in blocks])
        thresholds = np.full((WEDGES + 2 * (len(ways) - 1), len(room_of)), SLACK)
        thresholds[NEARNESS] -= np.concatenate([block.near for block in blocks])
        thresholds[RANGE] -= np.concatenate([block.far for block in blocks])
        for wedge, room in enumerate(ways[1:]):
            right = WEDGES + 2 * wedge
            thresholds[right : right + 2] -= np.where(room_of == room, 0.0, ANYWAY)
        is_in_sight = np.zeros(len(self.rooms), dtype=np.bool_)
        is_in_sight[list(rooms)] = True
        leads_into = np.repeat(ways[1:], 2)[:, None] == np.arange(len(self.rooms))
        return Layout(
            rooms=rooms,
            is_in_sight=is_in_sight,
            wedge_thresholds=SLACK - np.where(leads_into, 0.0, ANYWAY),
            points=np.hstack([block.points for block in blocks]),
            thresholds=thresholds,
            rows=rows,
            is_holding=is_holding,
            holding_points=holding,
            holding_rows=rows[holding],
            floor_points=slice(first_floor, len(room_of)),
            floor_numbers=np.concatenate([self.floor_numbers[self.floors[room]] for room in rooms]),
        )

    def _lay_out(self, segments: Sequence[tuple[int, list[tuple[float, float]]]], full: Floats) -> RoomSamples:
        def block(segments: Sequence[tuple[int, list[tuple[float, float]]]]) -> Block:
            rows = np.array([place for place, _ in segments], dtype=np.int64)
            sizes = np.array([len(points) for _, points in segments], dtype=np.int64)
            points = np.ones((3, int(sizes.sum())))
            points[: PLACE_Y + 1] = np.array([point for _, points in segments for point in points]).reshape(-1, 2).T
            square = points[PLACE_X] ** 2 + points[PLACE_Y] ** 2
            return Block(rows, sizes, points, np.repeat(full[rows], sizes) - square, self.reach**2 - square)

        return (
            block([segment for segment in segments if full[segment[0]] < 0]),
            block([s for s in segments if full[s[0]] >= 0 and not self.is_floor[s[0]]]),
            block([segment for segment in segments if self.is_floor[segment[0]]]),
        )


class Layout(NamedTuple):
    """The fixed places of some rooms, the robot's own first. `is_in_sight`: `(rooms,)` of the house, which are among
    them. `wedge_thresholds` `(2 * wedges, rooms)`: what the answer of what is in a room must not be below for each edge
    of a wedge, far less where the wedge leads into another room. `points` `(3, n)` stand for the places `rows` `(n,)`:
    a place is seen where any of its points is in view, and looked over where all of them are from near enough.
    `thresholds`: of each question and each point what the answer must not be below. `is_holding`: `(places,)` which can
    be looked over, floors apart; they have the `holding_points`, which stand for `holding_rows`. `floor_points`: those
    of floors, `floor_numbers`: which of all floors' points they are."""

    rooms: tuple[int, ...]
    is_in_sight: Bools
    wedge_thresholds: Floats
    points: Floats
    thresholds: Floats
    rows: Rows
    is_holding: Bools
    holding_points: slice
    holding_rows: Rows
    floor_points: slice
    floor_numbers: Rows


class Scene:
    """What is in the rooms in sight: fixed places, then the things and people there now.

    `ways`: the robot's room, then the rooms that wedges lead into, one twice where two do. `layout` has the fixed
    places; `points` go on with the things and people (`movable`, their rows), a point each, in `room` of each; `limits`
    are the distances from which each can be seen [m], `half_angle` [rad] is half of the field of view, `is_open`
    `(places,)` which places are not shut. `in_view` is which of the points the last view took in. `moved_at` is the
    caller's note of when things and people were brought in line last.

    All that a view writes to is made once: it is asked for every few steps, and costs little more than its calls.
    """

    def __init__(
        self,
        samples: Samples,
        ways: tuple[int, ...],
        movable: Rows,
        room: Rows,
        limits: Floats,
        position: Floats,
        *,
        half_angle: float,
        is_open: Bools,
    ) -> None:
        self.moved_at = -1
        self.layout = layout = samples.layout(ways)
        self.movable, self._limits = movable, SLACK - limits * limits
        fixed, rows = layout.points.shape[1], len(position)
        count = fixed + len(movable)
        self.points = np.empty((3, count))
        self.points[:, :fixed] = layout.points
        self.points[ONE, fixed:] = 1.0
        self._thresholds = thresholds = np.empty((len(layout.thresholds), count))
        thresholds[:, :fixed] = layout.thresholds
        thresholds[:RANGE, fixed:] = SLACK  # nothing lies on or in what can be moved: its nearness is not asked for
        thresholds[WEDGES:, fixed:] = layout.wedge_thresholds.take(room, axis=1)
        self._moving, self._ranges = self.points[: PLACE_Y + 1, fixed:], thresholds[RANGE, fixed:]
        self._reach, self._half_angle = samples.reach, half_angle
        self._is_one_way = len(ways) == len(layout.rooms)
        self._asked = np.empty((len(thresholds), 3))
        self._questions = self._asked.data
        self._put_down = _packer(self._asked.size)
        self._answers = np.empty(thresholds.shape)
        self._is_within = np.empty(thresholds.shape, dtype=np.bool_)
        self._found = np.empty(count + len(layout.holding_rows), dtype=np.bool_)
        self.in_view, self._is_short = self._found[:count], self._found[count:]
        self._is_near = self._is_within[NEARNESS, layout.holding_points]
        self._holding_in_view = self.in_view[layout.holding_points]
        self._stands_for = np.concatenate((layout.rows, movable, rows + layout.holding_rows))
        self._unseen = np.zeros(rows + len(is_open), dtype=np.bool_)
        self._unseen[rows - 1] = True  # the robot knows of itself
        np.logical_not(layout.is_holding & is_open, out=self._unseen[rows:])
        self.move(position)

    def move(self, position: Floats) -> None:
        """Brings the points of things and people in line with all positions, `(rows, 2)`."""
        if self.movable.size:
            self._moving[...] = at = position[self.movable].T
            x, y = at
            np.add(self._limits, x * x + y * y, out=self._ranges)

    def view(self, eye: complex, heading: float, beyond: Sequence[tuple[int, Wedge]]) -> Bools:
        """What is seen, `(rows,)`, then, `(places,)`, what is not in view with its whole contents; one fresh array.

        `eye`: x + iy [m], `heading` [rad]; `beyond`: the wedges into the other rooms.
        """
        x, y = eye.real, eye.imag
        begin, end = heading - self._half_angle, heading + self._half_angle
        rx, ry, lx, ly = cos(begin), sin(begin), cos(end), sin(end)
        a, b, c = 2 * x, 2 * y, -x * x - y * y
        asked = [a, b, c, -ry, rx, ry * x - rx * y, ly, -lx, lx * y - ly * x, a, b, c]
        for _, (right, left) in beyond:
            rx, ry, lx, ly = right.real, right.imag, left.real, left.imag
            asked += (-ry, rx, ry * x - rx * y, ly, -lx, lx * y - ly * x)
        self._put_down(self._questions, 0, *asked)
        self._beyond = beyond
        np.greater_equal(self._asked.dot(self.points, self._answers), self._thresholds, self._is_within)
        self._all(self._is_within, self.in_view)
        np.logical_and(self._is_near, self._holding_in_view, self._is_short)
        np.logical_not(self._is_short, self._is_short)
        seen = self._unseen.copy()
        seen[self._stands_for[self._found]] = True
        return seen

    def shows(self, spots: Floats, room: Rows) -> Bools:
        """Which of some spots `(n, 2)` on the floors of these rooms the last view took in."""
        points = np.empty((3, len(spots)))
        points[: PLACE_Y + 1], points[ONE] = spots.T, 1.0
        thresholds = np.empty((len(self._thresholds), len(spots)))
        thresholds[:RANGE] = SLACK
        thresholds[RANGE] = SLACK + ((spots * spots).sum(axis=1) - self._reach**2)
        thresholds[WEDGES:] = self.layout.wedge_thresholds.take(room, axis=1)
        in_view = np.empty(len(spots), dtype=np.bool_)
        self._all(self._asked.dot(points) >= thresholds, in_view)
        return in_view & self.layout.is_in_sight[room]

    def _all(self, is_within: Bools, in_view: Bools) -> None:
        """Of answers to all that was asked of points, for each point whether it is `in_view`."""
        if self._half_angle >= pi:
            first = RANGE
        elif self._half_angle < pi / 2:
            first = LEFTMOST
        else:
            first = RIGHTMOST
            right = is_within[RIGHTMOST]
            np.logical_or(is_within[LEFTMOST], right, right)
        if self._is_one_way:
            np.logical_and.reduce(is_within[first:], out=in_view)
        else:
            through = self._through(is_within, self._beyond)
            np.logical_and.reduce([*is_within[first:WEDGES], *through], out=in_view)

    @staticmethod
    def _through(is_within: Bools, beyond: Sequence[tuple[int, Wedge]]) -> list[Bools]:
        """What must hold of a point in view, where more than one way leads into a room: any of its wedges will do."""
        ways: dict[int, list[Bools]] = {}
        for wedge, (room, _) in enumerate(beyond):
            right = WEDGES + 2 * wedge
            ways.setdefault(room, []).append(is_within[right] & is_within[right + 1])
        return [np.logical_or.reduce(through) for through in ways.values()]


@cache
def _packer(count: int) -> Callable[..., None]:
    """What writes so many numbers into a buffer."""
    return Struct(f"{count}d").pack_into


@lru_cache(maxsize=8)
def samples_of(geometry: Geometry, reach: float, inside_reach: float) -> Samples:
    """The samples of a house, for one who sees so far; shared by all episodes in it."""
    return Samples(geometry, reach, inside_reach)


def sample_points(geometry: Geometry, place: int) -> Iterator[tuple[int, list[tuple[float, float]]]]:
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
