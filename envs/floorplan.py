"""Where a round robot can go in a house, and the shortest ways through it: an occupancy grid made of the house map.

World frame as in the house file, metres. Everything here follows from the map alone, never from the true world.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from decomplex_bt.domain.house import House
from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.envs.geometry import WALL_RADIUS, Geometry

Point = tuple[float, float]
Rect = tuple[float, float, float, float]
Cells = NDArray[np.int32]
Mask = NDArray[np.bool_]
Window = tuple[slice, slice]
"""Rows and columns of the grid."""

RESOLUTION = 0.06
"""[m] Side of a grid cell, unless asked otherwise; the narrowest passage of the default house leaves six cells."""
MARGIN = 0.04
"""[m] Kept free around the robot besides its radius."""
COMFORT = 0.40
"""[m] Clearance below which a way counts as longer, so that paths keep off corners where there is room."""
DISCOMFORT = 1.5
"""Extra cost of a metre along an obstacle, relative to a metre in the open."""
REACHABLE = 0.78
"""[m] A place whose footprint the robot's centre cannot come nearer to than this is not used from there."""
THRESHOLD = 0.15
"""[m] So near to a room's border nobody stops: it would not be clear which room they are in."""
ENTRY = 0.6
"""[m] So far off a free cell the robot may be to drive from there."""
ENTRY_SLACK = 0.12
"""[m] Free cells that much farther off than the nearest are as good for setting out."""
_FARTHEST = 1e9
"""[m] Longer than any way, and shorter than an edge that is not free."""
_FIELDS_KEPT = 256
_TRIED_AT_ONCE = 16
"""Points that are tried together when a way is drawn tight."""
_COUNTED = np.arange(2000, dtype=float)


@dataclass(frozen=True, slots=True)
class Disc:
    """A round obstacle that is not on the map: a person, a thing on the floor. Metres.

    `gives_way`: it can be pushed aside where there is no way around it.
    """

    x: float
    y: float
    radius: float
    gives_way: bool = False


@dataclass(frozen=True)
class Way:
    """A drivable polyline; `free` is the grid mask it was planned on, and says what else is drivable."""

    points: tuple[Point, ...]
    free: Mask


class Floorplan:
    """The free space of a house for a disc of `radius`, with the cells from which each place is used.

    `resolution`: the side of a cell. Metres.
    """

    def __init__(self, geometry: Geometry, *, radius: float = 0.22, resolution: float = RESOLUTION) -> None:
        self.geometry = geometry
        self.resolution = resolution
        self.house = geometry.house
        self.inflation = radius + MARGIN
        self.x0, self.y0, right, top = geometry.bounds
        self.columns = math.ceil((right - self.x0) / self.resolution)
        self.rows = math.ceil((top - self.y0) / self.resolution)
        index = np.arange(self.rows * self.columns)
        self.cell_x = self.x0 + (index % self.columns + 0.5) * self.resolution
        self.cell_y = self.y0 + (index // self.columns + 0.5) * self.resolution
        self._x, self._y = self.cell_x[: self.columns], self.cell_y[:: self.columns]
        names = geometry.names[: geometry.place_count]
        self._footprints: dict[str, Rect] = {
            **{name: tuple(rect) for name, rect in zip(names, geometry.footprints.tolist(), strict=True)},
            **geometry.openings,
        }
        self.clearance = self._clearance()
        self.free: Mask = self.clearance >= self.inflation
        self._free = self.free.reshape(self.rows, self.columns)
        self._edges = self._make_edges()
        self._fields: OrderedDict[tuple[bytes, frozenset[str]], tuple[NDArray, NDArray]] = OrderedDict()
        self._doors = {name: self._near(self.footprint(name), self.inflation) for name in self.house.doorways}
        self._by_doorway = np.zeros_like(self._free)
        for name in self.house.doorways:
            window = self._window(self.footprint(name), 0.4)
            self._by_doorway[window] |= self._distances(self.footprint(name), window) < 0.4

    @cached_property
    def cell_rooms(self) -> NDArray[np.int64]:
        """The index of the room of every cell, or of the one nearest to it, in the order of the house's rooms."""
        return self.geometry.rooms_at(np.column_stack((self.cell_x, self.cell_y)))

    # -- where things are ---------------------------------------------------------------------------------------------

    def room_at(self, x: float, y: float) -> str | None:
        """The room a point lies in; None outside the house."""
        for name, room in self.house.rooms.items():
            left, bottom, right, top = room.rect
            if left <= x < right and bottom <= y < top:
                return name
        return None

    def footprint(self, place: str) -> Rect:
        """The rectangle of a piece of furniture, a floor (its room) or a doorway. Raises `KeyError`."""
        return self._footprints[place]

    def rooms_of(self, place: str) -> tuple[str, ...]:
        """The room of a place, or the two rooms that a doorway joins. Raises `KeyError`."""
        if place in self.house.furniture:
            return (self.house.furniture[place].room,)
        if place in self.house.doorways:
            return self.house.doorways[place].rooms
        return (place.removesuffix("_floor"),) if place.removesuffix("_floor") in self.house.rooms else ()

    def distance_to(self, place: str, x: float, y: float) -> float:
        """Metres from a point to the nearest point of a place's footprint; 0 inside."""
        return rect_distance(self.footprint(place), x, y)

    # -- goal regions -------------------------------------------------------------------------------------------------

    def cells_at(self, place: str, *, room: str) -> Cells:
        """The cells of `room` from which a place is used: in front of its sides, as near as the robot can stand.

        Empty where there is none. For a floor: the free cells of the room that are well inside it.
        """
        window = self._inside(room)
        inside = self._free[window]
        if place in self.house.doorways:
            return self._cells(window, inside & self._before_doorway(place, window))
        rect = self.footprint(place)
        if place not in self.house.furniture:
            return self._cells(window, inside & ~self._by_doorway[window])
        beside = np.zeros_like(inside)
        for side in self.house.furniture[place].sides:
            beside |= self._beside(rect, side, window)
        distance = self._distances(rect, window)
        for region in (inside & beside, inside):
            if region.any() and distance[region].min() < REACHABLE:
                return self._cells(window, region & (distance <= max(0.42, distance[region].min() + 0.06)))
        return np.empty(0, np.int32)

    def cells_within(self, place: str, reach: float, *, room: str) -> Cells:
        """All free cells of `room` within `reach` metres of a place's footprint, on whatever side."""
        window = self._inside(room)
        return self._cells(window, self._free[window] & (self._distances(self.footprint(place), window) <= reach))

    def cells_around(self, x: float, y: float, *, nearest: float, farthest: float, room: str | None) -> Cells:
        """The free cells of `room` (None: any) between two distances from a point."""
        window = self._window((x, y, x, y), farthest) if room is None else self._inside(room)
        rows, columns = window
        distance = np.hypot(self._x[columns] - x, self._y[rows, None] - y)
        return self._cells(window, self._free[window] & (distance >= nearest) & (distance <= farthest))

    def _inside(self, room: str) -> Window:
        """The window of a room, less its threshold: who stops near one of these cells is in the room for sure."""
        left, bottom, right, top = self.house.rooms[room].rect
        columns = np.searchsorted(self._x, (left + THRESHOLD, right - THRESHOLD)).tolist()
        rows = np.searchsorted(self._y, (bottom + THRESHOLD, top - THRESHOLD)).tolist()
        return slice(*rows), slice(*columns)

    def _window(self, rect: Rect, margin: float) -> Window:
        """The window of the cells within a margin around a rectangle, and some more."""
        margin += self.resolution
        x0, x1, y0, y1 = min(rect[0], rect[2]), max(rect[0], rect[2]), min(rect[1], rect[3]), max(rect[1], rect[3])
        columns = np.searchsorted(self._x, (x0 - margin, x1 + margin)).tolist()
        rows = np.searchsorted(self._y, (y0 - margin, y1 + margin)).tolist()
        return slice(*rows), slice(*columns)

    def _distances(self, rect: Rect, window: Window) -> NDArray[np.float64]:
        """Metres from each cell of a window to a rectangle."""
        rows, columns = window
        return _rect_distances(rect, self._x[columns], self._y[rows, None])

    def _near(self, rect: Rect, within: float) -> Cells:
        """The cells nearer to a rectangle than this."""
        window = self._window(rect, within)
        return self._cells(window, self._distances(rect, window) < within)

    def _cells(self, window: Window, mask: Mask) -> Cells:
        """The numbers of the cells of a window where the mask is set."""
        rows, columns = np.nonzero(mask)
        return ((rows + window[0].start) * self.columns + columns + window[1].start).astype(np.int32)

    def _beside(self, rect: Rect, side: str, window: Window) -> Mask:
        left, bottom, right, top = rect
        x, y = self._x[window[1]], self._y[window[0], None]
        slack = 0.1
        along_x = (x >= left - slack) & (x <= right + slack)
        along_y = (y >= bottom - slack) & (y <= top + slack)
        if side == "north":
            return along_x & (y > top)
        if side == "south":
            return along_x & (y < bottom)
        return along_y & (x > right if side == "east" else x < left)

    def _before_doorway(self, place: str, window: Window) -> Mask:
        doorway = self.house.doorways[place]
        x, y = doorway.centre
        across, along = abs(self._y[window[0], None] - y), abs(self._x[window[1]] - x)
        _, bottom, _, top = self.geometry.openings[place]
        if bottom != top:  # in a wall that runs along y
            across, along = along, across
        return (across >= 0.42) & (across <= 0.62) & (along <= doorway.width / 2)

    # -- ways ---------------------------------------------------------------------------------------------------------

    def way(
        self,
        start: Point,
        goal: Cells,
        *,
        closed: frozenset[str] = frozenset(),
        obstacles: Sequence[Disc] = (),
    ) -> Way | None:
        """The shortest comfortable way from `start` to the nearest of the `goal` cells; None if there is none.

        `closed`: doors that are not to be driven through. `obstacles`: discs to keep clear of.
        """
        mapped = self._mask(closed)
        goal = goal[mapped[goal]]
        if not goal.size:
            return None
        free = self._clear_of(obstacles, mapped)
        cells = self._cells_along(start, free, *self._field(goal, mapped, closed))
        if cells and not free[cells].all():  # if nothing stands on the way it is the shortest one past everything too
            goal = goal[free[goal]]
            cells = self._cells_along(start, free, *self._solve(goal, free)) if goal.size else []
        if not cells:
            return None
        corners = self._pull(self.cell_x[cells] + 1j * self.cell_y[cells], free)
        return Way(tuple((corner.real, corner.imag) for corner in corners), free)

    def _cells_along(self, start: Point, free: Mask, distance: NDArray, previous: NDArray) -> list[int]:
        """The cells of the shortest way in a field from where a way from `start` begins; none if none does."""
        cell = self._entry(start, free, distance)
        cells = []
        while cell is not None and cell >= 0:
            cells.append(cell)
            cell = int(previous[cell])
        return cells

    def is_clear(self, start: Point, end: Point, free: Mask) -> bool:
        """Whether the straight line between two points runs over free cells; the cell of `start` is not asked."""
        steps = _shares(self._count_samples(math.dist(start, end)))
        first = (start[0] - self.x0) / self.resolution, (start[1] - self.y0) / self.resolution
        columns = (first[0] + steps * ((end[0] - start[0]) / self.resolution)).astype(np.int32)
        rows = (first[1] + steps * ((end[1] - start[1]) / self.resolution)).astype(np.int32)
        cells = rows * self.columns + columns
        return b"\0" not in free.take(cells, mode="clip").tobytes()

    def _mask(self, closed: frozenset[str]) -> Mask:
        """What is free on the map with some doors closed."""
        if not closed:
            return self.free
        free = self.free.copy()
        for name in sorted(closed):
            free[self._doors[name]] = False
        return free

    def _clear_of(self, obstacles: Sequence[Disc], free: Mask) -> Mask:
        """What is free and clear of all obstacles."""
        if not obstacles:
            return free
        free = free.copy()
        plane = free.reshape(self.rows, self.columns)
        for disc in obstacles:
            within = disc.radius + self.inflation
            rows, columns = window = self._window((disc.x, disc.y, disc.x, disc.y), within)
            plane[window] &= np.hypot(self._x[columns] - disc.x, self._y[rows, None] - disc.y) >= within
        return free

    def _entry(self, start: Point, free: Mask, distance: NDArray) -> int | None:
        """The cell at which a way from `start` begins: a free one that leads to the goal, if near.

        Of those about as near as the nearest the one with the shortest way on: who stands a little too close to a wall
        does not turn back to set out.
        """
        rows, columns = window = self._window((*start, *start), ENTRY)
        off = np.hypot(self._x[columns] - start[0], self._y[rows, None] - start[1])
        shape = self.rows, self.columns
        left = distance.reshape(shape)[window]
        off[~(free.reshape(shape)[window] & np.isfinite(left))] = math.inf
        if not off.size or off.min() > ENTRY:
            return None
        nearest = off.min()
        if nearest > self.resolution:
            off = np.where(off <= nearest + ENTRY_SLACK, off + left, math.inf)
        row, column = divmod(int(off.argmin()), off.shape[1])
        return (row + rows.start) * self.columns + column + columns.start

    def _field(self, goal: Cells, free: Mask, closed: frozenset[str]) -> tuple[NDArray, NDArray]:
        key = (goal.tobytes(), closed)
        if key in self._fields:
            self._fields.move_to_end(key)
            return self._fields[key]
        self._fields[key] = self._solve(goal, free)
        if len(self._fields) > _FIELDS_KEPT:
            self._fields.popitem(last=False)
        return self._fields[key]

    def _solve(self, goal: Cells, free: Mask) -> tuple[NDArray, NDArray]:
        """Distance to the goal and the next cell on the way to it (-9999: none), for every cell."""
        graph = self._graph if free is self.free else self._graph_of(free)
        distance, previous, _ = dijkstra(graph, indices=goal, min_only=True, return_predecessors=True, limit=_FARTHEST)
        return distance.astype(np.float32), previous.astype(np.int32)

    @cached_property
    def _graph(self) -> csr_matrix:
        """Both ways along every edge: told that edges lead both ways, `dijkstra` would turn them around each time."""
        first, second, cost = self._edges
        size = self.rows * self.columns
        one_way = csr_matrix((cost, (first, second)), shape=(size, size))
        graph = (one_way + one_way.T).tocsr()
        graph.sort_indices()
        return graph

    def _graph_of(self, free: Mask) -> csr_matrix:
        """The graph with the edges to what is not free endless, so that no way leads there: to make one without them
        takes much longer."""
        graph = self._graph
        cost = np.where(free.take(graph.indices), graph.data, math.inf)
        return csr_matrix((cost, graph.indices, graph.indptr), shape=graph.shape)

    def _pull(self, points: NDArray[np.complex128], free: Mask) -> list[complex]:
        """The polyline drawn tight: corners only where the straight line is not free. Points are x + yi."""
        tight, anchor, index = [0], 0, 1
        while index < len(points):
            beyond = points[index + 1 : index + 1 + _TRIED_AT_ONCE]
            clear = self._count_clear(points[anchor], beyond, free)
            index += clear
            if clear < _TRIED_AT_ONCE:
                tight.append(index)
                anchor, index = index, index + 1
        return points[tight].tolist()

    def _count_clear(self, start: complex, ends: NDArray[np.complex128], free: Mask) -> int:
        """How many of some points `is_clear` says yes to before it says no."""
        if not len(ends):
            return 0
        lines = (ends - start) / self.resolution
        counts = np.minimum((2 * np.abs(lines)).astype(np.int32) + 1, len(_COUNTED) - 1)
        stops = counts.cumsum()
        shares = (np.arange(1, stops[-1] + 1) - (stops - counts).repeat(counts)) / counts.repeat(counts)
        cells = (start - complex(self.x0, self.y0)) / self.resolution + lines.repeat(counts) * shares
        numbers = cells.imag.astype(np.int32) * self.columns + cells.real.astype(np.int32)
        blocked = free.take(numbers, mode="clip").tobytes().find(b"\0")
        return len(ends) if blocked < 0 else int(stops.searchsorted(blocked, side="right"))

    def _count_samples(self, length: float) -> int:
        """On how many cells a straight line of so many metres is looked at."""
        return min(int(length / (self.resolution / 2)) + 1, len(_COUNTED) - 1)

    # -- the grid -----------------------------------------------------------------------------------------------------

    def _clearance(self) -> NDArray[np.float64]:
        """Metres from every cell's centre to the nearest wall or piece of furniture, as far as it matters; 0 inside."""
        clearance = np.full((self.rows, self.columns), math.inf)
        for left, bottom, right, top in self.geometry.walls:
            wall = min(left, right), min(bottom, top), max(left, right), max(bottom, top)
            window = self._window(wall, COMFORT + WALL_RADIUS)
            np.minimum(clearance[window], self._distances(wall, window) - WALL_RADIUS, out=clearance[window])
        for block in self.geometry.blocks:
            window = self._window(block, COMFORT)
            np.minimum(clearance[window], self._distances(block, window), out=clearance[window])
        return clearance.ravel()

    def _make_edges(self) -> tuple[NDArray, NDArray, NDArray]:
        grid = np.arange(self.rows * self.columns).reshape(self.rows, self.columns)
        pairs = [
            (grid[:, :-1], grid[:, 1:], 1.0),
            (grid[:-1], grid[1:], 1.0),
            (grid[:-1, :-1], grid[1:, 1:], math.sqrt(2)),
            (grid[1:, :-1], grid[:-1, 1:], math.sqrt(2)),
        ]
        tightness = np.clip(1 - self.clearance / COMFORT, 0, 1)
        firsts, seconds, costs = [], [], []
        for one, other, length in pairs:
            first, second = one.ravel(), other.ravel()
            keep = self.free[first] & self.free[second]
            first, second = first[keep], second[keep]
            cost = length * self.resolution * (1 + DISCOMFORT * (tightness[first] + tightness[second]) / 2)
            firsts.append(first)
            seconds.append(second)
            costs.append(cost)
        return np.concatenate(firsts), np.concatenate(seconds), np.concatenate(costs)


def floorplan_of(house: House, kinds: Kinds, *, radius: float = 0.22) -> Floorplan:
    """The floorplan of a house, made once per process for equal houses."""
    return _cached(house.model_dump_json(), kinds.model_dump_json(), radius)


@lru_cache(maxsize=8)
def _cached(house: str, kinds: str, radius: float) -> Floorplan:
    geometry = Geometry(House.model_validate_json(house), Kinds.model_validate_json(kinds))
    return Floorplan(geometry, radius=radius)


@lru_cache(maxsize=len(_COUNTED))
def _shares(count: int) -> NDArray[np.float64]:
    """1/count, 2/count, ... up to 1."""
    return _COUNTED[1 : count + 1] / count


def rect_distance(rect: Rect, x: float, y: float) -> float:
    """Metres from a point to a rectangle; 0 inside."""
    left, bottom, right, top = rect
    across = left - x if x < left else x - right if x > right else 0.0
    along = bottom - y if y < bottom else y - top if y > top else 0.0
    return math.hypot(across, along)


def _rect_distances(rect: Rect, x: NDArray, y: NDArray) -> NDArray:
    across = np.maximum(np.maximum(rect[0] - x, x - rect[2]), 0)
    along = np.maximum(np.maximum(rect[1] - y, y - rect[3]), 0)
    return np.hypot(across, along)
