"""Sensing: what the robot sees of the world, as the entity table of an observation.

It sees what is within `range` and its field of view, behind no wall and no closed door; furniture hides nothing but
what is in a closed container, and into an open one it looks from `inside_range`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, cos, radians, sin

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from decomplex_bt.envs.chance import APERTURE
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.interface import COLUMNS, STATE_PAIRS
from decomplex_bt.envs.wedges import in_sight
from decomplex_bt.envs.world import World

VISIBLE, X, Y, HEADING, PLACE, INSPECTED = range(6)
FIRST_STATE = COLUMNS.index(STATE_PAIRS[0])
INSET = 0.04  # [m] the sample points of furniture lie so far within its footprint
FLOOR_INSET = 0.1  # [m] the sample points of a floor lie so far within its room
FLOOR_SAMPLES = 1.2  # [m] at most between the sample points of a floor


@dataclass(frozen=True, slots=True)
class SensingConfig:
    """How the robot sees. `range`, `inside_range` in metres, `field_of_view` in degrees.

    `every`: control steps between two looks (between them the table stays; a change that the robot itself brings about
    is seen at once). `memory` [s]: a floor is inspected when each part of it was in view within this time, and what was
    seen there in that time is reported along. `looks`: looks in a row with a place in full view that make it inspected.
    """

    range: float = 5.0
    inside_range: float = 2.0
    field_of_view: float = 200.0
    every: int = 4
    memory: float = 15.0
    looks: int = 2


class Sensor:
    """The robot's eyes in one episode. `look` takes the world in; `table` and the masks hold what came of it.

    `visible`: `(rows,)` what is seen now, `inspected`: `(places,)` whose whole contents are in view.
    """

    def __init__(self, world: World, config: SensingConfig, rng: Generator) -> None:
        geometry = world.geometry
        self.world, self.config, self.rng = world, config, rng
        self.missed_detection = geometry.house.missed_detection
        self._samples = samples = _samples_of(geometry)
        self._places = geometry.place_count
        self._movable = slice(geometry.place_count, geometry.robot_row)
        count = geometry.robot_row - geometry.place_count
        self._points = np.concatenate([samples.points, np.zeros(count)])
        self._room = np.concatenate([samples.room, np.zeros(count, dtype=np.int64)])
        self._limit = np.full(len(self._points), config.range)
        self._full_range = np.where(samples.is_inside, config.inside_range, config.range)
        self._full_range[~world.prior.holds] = -1
        self._seen_floor = np.full(len(samples.points) - samples.floor_start, -np.inf)
        self._seen_when = np.full(count, -np.inf)
        self._full_looks = np.zeros(geometry.place_count, dtype=np.int64)
        self._tracked = np.zeros(count, dtype=bool)
        self._known = samples.known.copy()
        self._truth = samples.known.copy()
        self._truth[:, VISIBLE] = 1
        self._cosine = cos(radians(min(config.field_of_view, 360.0)) / 2)
        self._version = -1
        self._looked_at = -config.every
        self.table = self._known
        self.visible = np.zeros(len(geometry.names), dtype=bool)
        self.visible[geometry.robot_row] = True
        self.inspected = np.zeros(geometry.place_count, dtype=bool)

    def look(self) -> bool:
        """Looks if it is time to, or if something was changed; says whether it looked."""
        world = self.world
        if world.steps - self._looked_at < self.config.every and world.version == self._version:
            return False
        world.locate()
        if world.version != self._version:
            self._take_changes()
        self._version, self._looked_at = world.version, world.steps
        in_view, distance = self._in_view()
        count = len(self._samples.points)
        self._see_places(in_view[:count], distance)
        self._see_movable(in_view[count:])
        self._write()
        return True

    def _take_changes(self) -> None:
        """Takes in what changes only when something is done: states, and from how far each thing can be seen."""
        world, samples = self.world, self._samples
        self._truth[:, FIRST_STATE:] = world.states
        self._truth[:, PLACE] = world.place
        self._shut = world.prior.has_door & (world.states[: self._places, APERTURE] == 0)
        place = world.place[self._movable]
        self._at = np.where((place >= 0) & (place < self._places), place, self._places)
        limit = np.where(np.append(samples.is_inside, False)[self._at], self.config.inside_range, self.config.range)
        limit[np.append(self._shut, False)[self._at] | ~world.is_somewhere[self._movable]] = -1
        self._limit[len(samples.points) :] = limit

    # -- what is in view ----------------------------------------------------------------------------------------------

    def _in_view(self) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
        """For each sample point and each thing and person whether it is in view, and its distance."""
        world, geometry = self.world, self.world.geometry
        count = len(self._samples.points)
        self._points[count:] = world.position.view(np.complex128)[self._movable, 0]
        self._room[count:] = world.room[self._movable]
        eye, heading = complex(*world.robot), float(world.heading[geometry.robot_row])
        directions = self._points - eye
        distance = np.abs(directions)
        in_view = distance <= self._limit
        if self.config.field_of_view < 360:
            in_view &= (directions * complex(cos(heading), -sin(heading))).real >= self._cosine * distance
        room = int(world.room[geometry.robot_row])
        beyond = np.flatnonzero(in_view & (self._room != room))
        if beyond.size:
            leaves = world.closed_leaves()
            in_view[beyond] = in_sight(geometry, room, eye, leaves, self._room[beyond], directions[beyond])
        return in_view, distance

    def _see_places(self, in_view: NDArray[np.bool_], distance: NDArray[np.float64]) -> None:
        world, samples = self.world, self._samples
        seen = np.add.reduceat(in_view.view(np.uint8), samples.starts)
        np.greater(seen, 0, out=self.visible[: self._places])
        is_full = (seen == samples.counts) & ~self._shut
        farthest = np.maximum.reduceat(distance[: len(samples.points)], samples.starts)
        is_full &= farthest <= self._full_range
        self._full_looks += 1
        self._full_looks *= is_full
        self.inspected = self._full_looks >= self.config.looks
        self._seen_floor[in_view[samples.floor_start :]] = world.seconds
        oldest = np.minimum.reduceat(self._seen_floor, samples.floor_starts)
        self.inspected[samples.floors] = self._is_recent(oldest)

    def _see_movable(self, in_view: NDArray[np.bool_]) -> None:
        """Things and people: those in view, less what is missed; on inspected floors also those seen a while ago."""
        world, samples = self.world, self._samples
        if self.missed_detection > 0:
            self._miss(in_view)
        self._tracked = in_view
        self._seen_when[in_view] = world.seconds
        truth = self._truth[self._movable]
        np.copyto(truth[:, X : Y + 1], world.position[self._movable], where=in_view[:, None], casting="same_kind")
        if self.inspected[samples.floors].any():
            on_inspected = np.append(self.inspected & samples.is_floor, False)[self._at]
            in_view = in_view | (on_inspected & self._is_recent(self._seen_when))
        self.visible[self._movable] = in_view

    def _is_recent(self, when: NDArray[np.float64]) -> NDArray[np.bool_]:
        return when >= self.world.seconds - self.config.memory

    def _miss(self, in_view: NDArray[np.bool_]) -> None:
        """Takes out what this look misses; what was seen by the last look stays seen."""
        fresh = np.flatnonzero(in_view & ~self._tracked)
        if fresh.size:
            in_view[fresh] = self.rng.random(fresh.size) >= self.missed_detection

    # -- the table ----------------------------------------------------------------------------------------------------

    def _write(self) -> None:
        """Writes a new table: what is known for ever, and what is seen now."""
        world, truth = self.world, self._truth
        geometry, user = world.geometry, world.geometry.user_row
        truth[user:, HEADING] = world.heading[user:]
        truth[geometry.robot_row, X : Y + 1] = world.robot
        truth[: self._places, INSPECTED] = self.inspected
        self._known[user, X : Y + 1] = world.position[user]
        self._known[: self._places, INSPECTED] = self.inspected
        self.table = np.where(self.visible[:, None], truth, self._known)


class _Samples:
    """What sensing needs of a house, made once: points that stand for the fixed places, and an empty table.

    `points` `(n,)` complex, x + iy, and `room` `(n,)`; those of a place are `counts[place]` from
    `starts[place]`, the floors' last, from `floor_start`. `known` is the table of one who sees nothing.
    """

    def __init__(self, geometry: Geometry) -> None:
        points: list[complex] = []
        rooms: list[int] = []
        starts: list[int] = []
        for place, name in enumerate(geometry.names[: geometry.place_count]):
            starts.append(len(points))
            for room, point in _samples(geometry, place, name):
                rooms.append(room)
                points.append(complex(*point))
        self.points, self.room, self.starts = np.array(points), np.array(rooms), np.array(starts)
        self.counts = np.diff([*starts, len(points)]).astype(np.uint8)
        self.floors = slice(geometry.place_count - len(geometry.rooms), geometry.place_count)
        self.floor_start = starts[self.floors.start]
        self.floor_starts = self.starts[self.floors] - self.floor_start
        self.is_floor = np.isin(np.arange(geometry.place_count), geometry.floor_row)
        kinds = [geometry.house.kind(name, geometry.kinds) for name in geometry.names[: geometry.place_count]]
        self.is_inside = np.array([kind.inside for kind in kinds])
        self.known = np.zeros((len(geometry.names), len(COLUMNS)), dtype=np.float32)
        self.known[: geometry.place_count, X : Y + 1] = geometry.footprints.reshape(-1, 2, 2).mean(axis=1)
        self.known[:, PLACE] = self.known[:, FIRST_STATE:] = -1


@lru_cache(maxsize=8)
def _samples_of(geometry: Geometry) -> _Samples:
    return _Samples(geometry)


def _samples(geometry: Geometry, place: int, name: str) -> Iterator[tuple[int, tuple[float, float]]]:
    x0, y0, x1, y1 = geometry.footprints[place].tolist()
    room = int(geometry.place_room[place])
    if name in geometry.leaves:
        for side in geometry.house.doorways[name].rooms:
            yield geometry.room_index[side], ((x0 + x1) / 2, (y0 + y1) / 2)
        return
    if place in geometry.floor_row:
        columns, rows = (ceil((high - low) / FLOOR_SAMPLES) for low, high in ((x0, x1), (y0, y1)))
        # The corners of a grid, not its middles: what lies between points in view is then in view as well.
        for x in np.linspace(x0 + FLOOR_INSET, x1 - FLOOR_INSET, columns + 1).tolist():
            for y in np.linspace(y0 + FLOOR_INSET, y1 - FLOOR_INSET, rows + 1).tolist():
                yield room, (x, y)
        return
    for x in (x0 + INSET, x1 - INSET):
        for y in (y0 + INSET, y1 - INSET):
            yield room, (x, y)
