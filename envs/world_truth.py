"""The simulator's world read as the truth the judge goes by."""

from __future__ import annotations

from functools import lru_cache
from math import hypot

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.prior import ABSENT
from decomplex_bt.envs.sensing import Sensor
from decomplex_bt.envs.walking import is_near_person
from decomplex_bt.envs.world import World

NEAR = 1.0
"""[m] Within this distance of its footprint, and in its room, the robot is at a place."""
_PAIRS = {pair: column for column, pair in enumerate(STATE_PAIRS)}


class WorldTruth:
    """Implements `decomplex_bt.envs.truth.Truth` for one episode. It reads the world, and never changes it."""

    def __init__(self, world: World, sensor: Sensor) -> None:
        self.world = world
        self.sensor = sensor
        self.geometry = world.geometry
        self._row = world.geometry.row
        self._names = world.geometry.names
        self._viewed: tuple[str, ...] | None = None
        self._changes = -1

    @property
    def room(self) -> str:
        return self.geometry.rooms[self.world.robot_room]

    def view(self, names: tuple[str, ...]) -> tuple[int, int, tuple[bytes, bytes]]:
        world, sensor = self.world, self.sensor
        if names is not self._viewed:
            self._viewed, self._changes = names, -1
            self._view_rows, self._view_places = _rows_of(self.geometry, names)
        if sensor.changes != self._changes:
            self._changes = sensor.changes
            seen, inspected = sensor.visible.take(self._view_rows), sensor.inspected.take(self._view_places)
            self._view = seen.tobytes(), inspected.tobytes()
        return world.version, world.arrangement, self._view

    def is_near(self, name: str) -> bool:
        geometry, world = self.geometry, self.world
        x, y = world.robot
        if name in geometry.openings:
            if self.room not in geometry.house.doorways[name].rooms:
                return False
            ax, ay, bx, by = geometry.openings[name]
            nearest = min(max(x, min(ax, bx)), max(ax, bx)), min(max(y, min(ay, by)), max(ay, by))
            return hypot(nearest[0] - x, nearest[1] - y) <= NEAR
        row = self._row.get(name)
        if row is None:
            return False
        if row in geometry.people_rows:
            return is_near_person(world, row)
        if row in geometry.thing_rows:
            place = int(world.place[row])
            away = hypot(*(world.position[row] - (x, y))) if place != ABSENT else float("inf")
            return bool(away <= NEAR) and int(world.room[row]) == world.robot_room
        return geometry.distance(x, y, row) <= NEAR and int(geometry.place_room[row]) == world.robot_room

    def place(self, name: str) -> str | None:
        row = self._row[name]
        if row in self.geometry.people_rows:
            return self.geometry.rooms[int(self.world.room[row])] if self.world.home[row] else None
        at = int(self.world.place[row])
        return None if at == ABSENT else self._names[at]

    def state(self, name: str, pair: str) -> str | None:
        row = self._row.get(name)
        value = -1 if row is None else int(self.world.states[row, _PAIRS[pair]])
        return None if value < 0 else self.geometry.kinds.state_pairs[pair].values[0 if value == 1 else 1]

    def is_broken(self, name: str) -> bool:
        return bool(self.world.broken[self._row[name]])

    def is_seen(self, name: str) -> bool:
        row = self._row.get(name)
        return row is not None and bool(self.sensor.visible[row])

    def is_inspected(self, place: str) -> bool:
        row = self._row.get(place)
        return row is not None and row < self.geometry.place_count and bool(self.sensor.inspected[row])


@lru_cache(maxsize=16)
def _rows_of(geometry: Geometry, names: tuple[str, ...]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The rows that names stand for, and those of them that are places; each episode asks for the same few."""
    rows = np.array([geometry.row[name] for name in names if name in geometry.row], dtype=np.int64)
    return rows, rows[rows < geometry.place_count]
