"""The shortest path: how far a robot that knew the world would have to drive for the branch that was taken.

It is measured on the free space of the house's map, with every door open and nobody and nothing in the way: the
shortest polyline from where the robot started through one stop after the other. A stop is all of the floor from which
something can be done:

- to take, put, switch, open, fill, ...: within reach of the place (of the spot, on a floor), in its room;
- to speak, to hand over, to fetch somebody who leads the way: within earshot of where the person stood at first;
- to be at a place: within 1 m of it; to be in a room: anywhere in it;
- to find something out: where it is in range and in line of sight, through open doors, whatever the heading. What
  stands fixed is seen where any corner of it is, a container too; only what is in it takes a nearer look. Of several
  that a phrase means as many are seen as it takes to know; what is not there is looked for wherever the task says.

Each task has its stops in the order of its phrases, things before where they go; of several candidates any will do.
Where all are meant there is a stop for each ("the kitchen and the study", "everybody"), from near to far. Whoever leads
the way is met where they stood, and followed to the goal or, where it is theirs to say, into the room they went to;
from then on they are in that room. What holds already needs no stop: what is as it is wanted, and what lies where it is
to go. The path is sought on a grid and then drawn
tight, so that a drive that cuts corners finer may come out some centimetres shorter, and so may one that takes up on
its way what falls due later; divide by the longer of the two, as SPL does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from math import dist, sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from decomplex_bt.envs.bindings import Bindings, candidates, needed
from decomplex_bt.envs.floorplan import RESOLUTION, Floorplan, floorplan_of
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.scene import sample_points
from decomplex_bt.envs.truth import ROBOT
from decomplex_bt.envs.wedges import wedges
from decomplex_bt.planning.abilities import is_fixed, runs_shut, stands_at, wipers_of
from decomplex_bt.planning.ground_task import FINDING_OUT, HERE, GroundTask, Referent

if TYPE_CHECKING:
    from decomplex_bt.domain.loader import Domain
    from decomplex_bt.envs.chance import Start
    from decomplex_bt.envs.geometry import Geometry

NEAR = 1.0  # [m] of a place's footprint the robot is at it
Mask = NDArray[np.bool_]
Point = tuple[float, float]


class ShortestPath:
    """The shortest path of one episode. `geometry` and `start`: the house, and how the episode began in it.

    `reach`, `earshot`, `sight` in metres: what the robot can; `sight` also into containers.
    """

    def __init__(
        self,
        domain: Domain,
        geometry: Geometry,
        start: Start,
        *,
        reach: float,
        earshot: float,
        sight: tuple[float, float],
    ) -> None:
        self._domain, self._geometry, self._start = domain, geometry, start
        self._reach, self._earshot = reach, earshot
        self._sight, self._sight_inside = sight[0], min(sight)
        self._plan = _plan_of(domain)
        self._places = {
            geometry.names[row]: geometry.names[int(start.place[row])] if start.place[row] >= 0 else None
            for row in geometry.thing_rows
        }
        self._values: dict[tuple[str, str], str] = {}
        self._led: Mapping[str, str] = {}
        self._room_of: dict[str, str] = {}

    def length(
        self, tasks: Sequence[tuple[GroundTask, bool]], bindings: Bindings, led: Mapping[str, str] | None = None
    ) -> float | None:
        """Metres, through the stops of all tasks in order; None where there is no path.

        `tasks`: those that were due, each with whether it was true; `bindings`: what the phrases turned out to mean;
        `led`: where people led the robot, by name.
        """
        self._led = led or {}
        stops: list[Mask] = []
        for task, truth in tasks:
            if truth or task.type in FINDING_OUT:
                stops.extend(stop for stop in self._stops(task, bindings, truth) if stop.any())
        x, y = self._start.position[self._geometry.robot_row].tolist()
        return _through(self._plan, (x, y), stops)

    # -- the stops of a task ------------------------------------------------------------------------------------------

    def _stops(self, task: GroundTask, bindings: Bindings, truth: bool) -> Iterator[Mask]:
        if task.type in FINDING_OUT:
            yield from self._finding_out(task, bindings, truth)
            return
        if task.type == "change_state":
            for name in _names(task.objects, bindings):
                yield from self._change(name, task)
            return
        if task.type == "following":
            yield from self._follow(task, bindings)
            return
        if task.type in ("placing", "bringing"):
            yield from self._bring(task, bindings)
            return
        for group in _groups(task.objects, bindings):
            yield from self._fetch(group, task.type)
        if task.type == "informing":
            yield from (self._any(group, self._use) for group in _groups(task.recipients, bindings))
        elif task.type == "motion" and task.target is not None:
            yield from self._in_turn([self._any(g, self._arrival) for g in _groups((task.target,), bindings)])
        elif task.target is not None and task.type != "taking":
            yield self._any(candidates(task.target, bindings), self._use)

    def _finding_out(self, task: GroundTask, bindings: Bindings, truth: bool) -> Iterator[Mask]:
        """To where the things are seen; where they are not, to where all places asked about are seen.

        That any one of several is in a state is known from that one, that none is from all of them; that all are from
        all, that not all are from one.
        """
        asks_value = task.state is not None and task.state != HERE
        asked = [name for referent in (*task.objects, *task.places) for name in referent.candidates]
        if task.type == "check_state" and not asks_value and all(is_fixed(name, self._domain) for name in asked):
            return  # the map has the answer
        found = [name for name in _names(task.objects, bindings) if self._point(name) is not None]
        if found and (not task.places or self._is_there(found[0], task.places, bindings)):
            for thing in task.objects:
                among = candidates(thing, bindings)
                are_all = needed(thing, among) >= len(among)
                groups = [among] if not asks_value or are_all != truth else [(name,) for name in among]
                yield from self._in_turn([self._any(group, self._view) for group in groups])
        elif task.type == "searching" and truth:
            yield from self._in_turn(self._search(task, bindings, is_found=bool(found)))
        else:
            yield from self._in_turn([self._look_into(name) for name in _names(task.places, bindings)])

    def _search(self, task: GroundTask, bindings: Bindings, *, is_found: bool) -> list[Mask]:
        """To where things are seen that are elsewhere than they are looked for, or to where one sees that they are not
        there: where no condition hangs on it, either is an end."""
        seen = [self._any(group, self._view) for group in _groups(task.objects, bindings)] if is_found else []
        looked = [self._any(group, self._look_into) for group in _groups(task.places, bindings)]
        return [seen[0] | looked[0]] if len(seen) == len(looked) == 1 else seen or looked

    def _in_turn(self, stops: Sequence[Mask]) -> list[Mask]:
        """Stops that may be made in any order, from near to far."""
        x, y = self._start.position[self._geometry.robot_row].tolist()
        gaps = np.hypot(self._plan.cell_x - x, self._plan.cell_y - y)
        return sorted((stop for stop in stops if stop.any()), key=lambda stop: float(gaps[stop].min()))

    def _change(self, name: str, task: GroundTask) -> Iterator[Mask]:
        """To the place whose state is changed; with a thing first to it, then to what changes it."""
        value = task.state or ""
        pair = self._domain.kinds.pair_of(value)
        is_ajar = runs_shut(name, value, self._domain) and self._state(name, "aperture") == "open"
        if self._state(name, pair) == value and not is_ajar:
            return
        self._values[name, pair] = value
        if name not in self._places:
            tools = wipers_of(name, self._domain) if value == "clean" else ()
            if tools:
                yield self._any(tools, self._use)
            yield self._use(name)
            return
        devices = task.devices(name, self._domain)
        if self._places[name] not in devices:
            yield from self._fetch((name,), "taking")
        yield self._any(devices, self._use)

    def _bring(self, task: GroundTask, bindings: Bindings) -> Iterator[Mask]:
        """To the things that are not yet where they are to go, and with them there."""
        target = task.target
        assert target is not None
        away = list(_groups(task.objects, bindings, lambda name: self._is_there(name, (target,), bindings)))
        for group in away:
            yield from self._fetch(group, task.type)
        if away:
            targets = candidates(target, bindings)
            yield self._any(targets, self._use)
            self._put({name for group in away for name in group}, targets[0])

    def _fetch(self, group: Sequence[str], kind: str) -> Iterator[Mask]:
        """To one of these things, if none is on the robot."""
        if any(self._places.get(name) == ROBOT for name in group):
            return
        yield self._any(group, self._use)
        if kind == "taking":
            for name in group[:1]:
                self._places[name] = ROBOT

    def _follow(self, task: GroundTask, bindings: Bindings) -> Iterator[Mask]:
        """To who leads the way, and with them to the goal, or into the room that they led to of their own."""
        goals = () if task.goal is None else candidates(task.goal, bindings)
        for group in _groups(task.objects, bindings):
            yield self._any(group, self._use)
            ends = goals[:1] or [self._led[name] for name in group if name in self._led]
            rooms = [self._domain.room_of(end) or end for end in ends]
            self._room_of.update(dict.fromkeys(group, rooms[0]) if rooms else {})
            if not goals and rooms:
                yield self._any(rooms, self._use)
        if goals:
            yield self._any(goals, self._use)

    def _put(self, things: Iterable[str], target: str) -> None:
        """Notes where the things are afterwards."""
        house = self._domain.house
        where = house.floor_of(target) if target in house.rooms else self._places.get(target, target)
        self._places.update(dict.fromkeys(things, where))

    # -- regions of the floor -----------------------------------------------------------------------------------------

    def _any(self, names: Sequence[str], region: Callable[[str], Mask]) -> Mask:
        masks = [region(name) for name in names]
        return np.logical_or.reduce(masks) if masks else np.zeros(len(self._plan.free), dtype=bool)

    def _arrival(self, name: str) -> Mask:
        """Where the robot is at a place, with a person or in a room."""
        return self._within(name, NEAR)

    def _use(self, name: str) -> Mask:
        """Where a place, thing or person is dealt with."""
        return self._within(name, self._reach)

    def _within(self, name: str, reach: float) -> Mask:
        house, plan = self._domain.house, self._plan
        room = name.removesuffix("_floor")
        if room in house.rooms:
            return plan.free & (self._plan.cell_rooms == self._geometry.room_index[room])
        if name in self._room_of:
            return self._within(self._room_of[name], reach)
        if name in house.people:
            return self._around(name, self._earshot)
        if name in self._places:
            place = self._places[name]
            if place is None or place == ROBOT:
                return np.zeros(len(plan.free), dtype=bool)
            at_place = self._within(place, reach) if place.removesuffix("_floor") not in house.rooms else None
            return self._around(name, reach) if at_place is None else at_place
        left, bottom, right, top = plan.footprint(name)
        across = np.maximum(np.maximum(left - plan.cell_x, plan.cell_x - right), 0)
        along = np.maximum(np.maximum(bottom - plan.cell_y, plan.cell_y - top), 0)
        near = np.hypot(across, along) <= reach
        rooms = [self._geometry.room_index[room] for room in plan.rooms_of(name)]
        return plan.free & near & np.isin(self._plan.cell_rooms, rooms)

    def _around(self, name: str, reach: float) -> Mask:
        """Within a distance of where a thing or person is, in the same room."""
        point = self._point(name)
        if point is None:
            return np.zeros(len(self._plan.free), dtype=bool)
        gap = np.hypot(self._plan.cell_x - point[0], self._plan.cell_y - point[1])
        return self._plan.free & (gap <= reach) & (self._plan.cell_rooms == self._geometry.room_at(*point))

    def _view(self, name: str) -> Mask:
        """Where something is in range and in line of sight with all doors open; a room, from within."""
        is_thing = name in self._places
        if is_thing and self._places[name] == ROBOT:
            return self._plan.free
        row = self._geometry.row.get(name)
        if row is not None and row < self._geometry.place_count and row not in self._geometry.floor_row:
            corners = sample_points(self._geometry, row)
            seen = [self._in_sight(point, room, self._sight) for room, points in corners for point in points]
            return self._plan.free & np.logical_or.reduce(seen)
        place = self._places[name] if is_thing else None
        return self._in_view(name, self._sight_inside if self._is_container(place) else self._sight)

    def _look_into(self, name: str) -> Mask:
        """Where one sees what is at a place; at a thing or person, where these are seen."""
        if self._is_container(name):
            return self._in_view(name, self._sight_inside)
        return self._view(name) if name in self._places else self._in_view(name, self._sight)

    def _is_container(self, place: str | None) -> bool:
        """Whether what is at a place is in it, so that it takes a nearer look."""
        return place is not None and place in self._domain.house.furniture and self._domain.kind(place).inside

    def _in_view(self, name: str, sight: float) -> Mask:
        """Where the point at which something is can be seen from so far; a room, from within."""
        house = self._domain.house
        if name.removesuffix("_floor") in house.rooms:
            return self._within(name, 0.0)
        if name in self._room_of:
            return self._within(self._room_of[name], 0.0)
        point = self._point(name)
        if point is None:
            return np.zeros(len(self._plan.free), dtype=bool)
        return self._plan.free & self._in_sight(point, self._geometry.room_at(*point), sight)

    def _in_sight(self, point: Point, room: int, sight: float) -> Mask:
        """The cells from which a point in a room is seen: those that are seen from it."""
        offsets = (self._plan.cell_x - point[0]) + 1j * (self._plan.cell_y - point[1])
        seen = self._plan.cell_rooms == room
        for beyond, (right, left) in wedges(self._geometry, room, complex(*point), (), reach=sight):
            inside = ((offsets * right.conjugate()).imag >= 0) & ((offsets * left.conjugate()).imag <= 0)
            seen |= inside & (self._plan.cell_rooms == beyond)
        return seen & (np.abs(offsets) <= sight)

    def _point(self, name: str) -> Point | None:
        """Where a thing or person was at first, or the middle of a place; None for what is nowhere."""
        row = self._geometry.row.get(name)
        if row is None:
            left, bottom, right, top = self._plan.footprint(name)
            return (left + right) / 2, (bottom + top) / 2
        if row < self._geometry.place_count:
            x0, y0, x1, y1 = self._geometry.footprints[row].tolist()
            return (x0 + x1) / 2, (y0 + y1) / 2
        place = self._places.get(name)
        if name in self._places and place is not None and place != self._first_place(row):
            return self._point(place) if place != ROBOT else None
        x, y = self._start.position[row].tolist()
        return None if np.isnan(x) else (x, y)

    def _first_place(self, row: int) -> str | None:
        at = int(self._start.place[row])
        return self._geometry.names[at] if at >= 0 else None

    def _is_there(self, name: str, places: Sequence[Referent], bindings: Bindings) -> bool:
        """Whether something or somebody is at one of the places asked about, as the judge has it: on the floor of a
        room is less than in it, but for people."""
        if is_fixed(name, self._domain):
            return any(stands_at(name, where, self._domain) for where in _names(places, bindings))
        point, is_thing = self._point(name), name in self._places
        room = self._room_of.get(name) or (self._geometry.rooms[self._geometry.room_at(*point)] if point else None)
        for mentioned in _names(places, bindings):
            where = self._places.get(mentioned) or mentioned  # beside a thing is where that is
            if is_thing and where not in self._domain.house.rooms:
                if self._places[name] == where:
                    return True
            elif room is not None and room == (self._domain.room_of(where) or where):
                return True
        return False

    def _state(self, name: str, pair: str) -> str | None:
        if (name, pair) in self._values:
            return self._values[name, pair]
        value = int(self._start.states[self._geometry.row[name], STATE_PAIRS.index(pair)])
        return None if value < 0 else self._domain.kinds.state_pairs[pair].values[0 if value else 1]


def _names(referents: Sequence[Referent], bindings: Bindings) -> list[str]:
    return [name for referent in referents for name in candidates(referent, bindings)]


def _groups(
    referents: Sequence[Referent], bindings: Bindings, is_settled: Callable[[str], bool] = lambda name: False
) -> Iterator[tuple[str, ...]]:
    """One group of candidates, of which any will do, for each thing that is asked for and not settled."""
    for referent in referents:
        among = candidates(referent, bindings)
        open_ones = tuple(name for name in among if not is_settled(name))
        short = needed(referent, among) - (len(among) - len(open_ones))
        if short >= len(open_ones):
            yield from ((name,) for name in open_ones)
        else:
            yield from [open_ones] * short


@lru_cache(maxsize=16)  # every episode that succeeds comes by: knowing the domain is quicker than comparing its house
def _plan_of(domain: Domain) -> Floorplan:
    return floorplan_of(domain.house, domain.kinds)


# -- the path ---------------------------------------------------------------------------------------------------------


def _through(plan: Floorplan, start: Point, stops: Sequence[Mask]) -> float | None:
    """The length of the shortest path from a point through regions of free cells, in order; None if there is none."""
    gaps = np.hypot(plan.cell_x - start[0], plan.cell_y - start[1])
    gaps[~plan.free] = np.inf
    first = int(gaps.argmin())
    sources, costs = np.array([first]), np.zeros(1)
    legs: list[NDArray[np.int32]] = []
    for stop in stops:
        distance, previous = _spread(_lengths(plan), sources, costs)
        legs.append(previous)
        sources = np.flatnonzero(stop & np.isfinite(distance))
        if not sources.size:
            return None
        costs = distance[sources]
    cell = int(sources[costs.argmin()])
    points: list[list[int]] = []
    for previous in reversed(legs):
        leg = [cell]
        while 0 <= previous[cell] < len(plan.free):
            cell = int(previous[cell])
            leg.append(cell)
        points.append(leg)
    return float(sum(_tight_length(plan, leg) for leg in points))


def _spread(graph: csr_matrix, sources: NDArray[np.int64], costs: NDArray[np.float64]) -> tuple[NDArray, NDArray]:
    """Distances from cells that lie at these costs, and the cell before each; by an extra node that leads to them."""
    size = graph.shape[0]
    data = np.concatenate((graph.data, costs + 1e-9))
    indices = np.concatenate((graph.indices, sources.astype(graph.indices.dtype)))
    indptr = np.append(graph.indptr, graph.indptr[-1] + len(sources))
    extended = csr_matrix((data, indices, indptr), shape=(size + 1, size + 1))
    distance, previous = dijkstra(extended, indices=size, return_predecessors=True)
    return distance[:size], previous[:size]


@lru_cache(maxsize=4)
def _lengths(plan: Floorplan) -> csr_matrix:
    """The graph of a floorplan's free cells and their eight neighbours, by plain length in metres."""
    grid = np.arange(plan.rows * plan.columns).reshape(plan.rows, plan.columns)
    pairs = (
        (grid[:, :-1], grid[:, 1:], 1.0),
        (grid[:-1], grid[1:], 1.0),
        (grid[:-1, :-1], grid[1:, 1:], sqrt(2)),
        (grid[1:, :-1], grid[:-1, 1:], sqrt(2)),
    )
    firsts, seconds, lengths = [], [], []
    for one, other, length in pairs:
        first, second = one.ravel(), other.ravel()
        keep = plan.free[first] & plan.free[second]
        first, second = first[keep], second[keep]
        firsts += [first, second]
        seconds += [second, first]
        lengths.append(np.full(2 * len(first), length * RESOLUTION))
    size = grid.size
    graph = csr_matrix((np.concatenate(lengths), (np.concatenate(firsts), np.concatenate(seconds))), shape=(size, size))
    graph.sort_indices()
    return graph


def _tight_length(plan: Floorplan, cells: Sequence[int]) -> float:
    """Metres along a leg after it was drawn tight."""
    points = [(float(plan.cell_x[cell]), float(plan.cell_y[cell])) for cell in cells]
    tight = [points[0]]
    index = 0
    while index < len(points) - 1:
        ahead = len(points) - 1
        step = index + 1
        low, high = index + 1, ahead
        while low <= high:  # the farthest point in a straight line; what is clear is so up to some point, nearly always
            middle = (low + high) // 2
            if plan.is_clear(points[index], points[middle], plan.free):
                step, low = middle, middle + 1
            else:
                high = middle - 1
        index = step
        tight.append(points[index])
    return sum(dist(one, other) for one, other in pairwise(tight))
