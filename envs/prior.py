"""The prior: what a house and its kinds say about how an episode may begin, as arrays by row."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.domain.kinds import Kind
from decomplex_bt.envs.geometry import Floats, Geometry
from decomplex_bt.envs.interface import STATE_PAIRS

ABSENT = -1
"""In place of a row: nowhere in the house."""


class Prior:
    """Probabilities of the start of an episode; read only, shared by all episodes in a house.

    `chance`: `(rows, pairs)`, of a state pair's positive value, NaN where an entity has no such pair. `broken`:
    `(rows,)`. `holds`: `(places,)`, whether things lie on or in it. `home`, `rooms`: of people, `(people,)` and
    `(people, rooms)`, `homes` and `room_sums` (cumulated) the same as lists; `robot_rooms`: `(rooms,)`. `warm_things`:
    rows of what may be hot or cold, `tempering`: of the places that make something so. `floors`: the floor's row of
    each room. `nowhere`, `no_position`, `no_states`, `none_broken`: a start in which nothing is drawn yet, to copy.
    """

    def __init__(self, geometry: Geometry) -> None:
        self.geometry = geometry
        kinds = [self._kind(row) for row in range(geometry.robot_row)]
        self.kinds: tuple[Kind, ...] = tuple(kinds)
        self.chance = np.array([[_chance(kind, pair) for pair in STATE_PAIRS] for kind in kinds] + [[np.nan] * 5])
        self.has_state = ~np.isnan(self.chance)
        self.broken = np.array([kind.broken for kind in kinds] + [0.0])
        self.radius = tuple(kind.radius for kind in kinds)
        self.holds = np.array([kind.surface or kind.inside for kind in kinds[: geometry.place_count]])
        self.has_door = np.array([kind.inside and kind.has_door for kind in kinds[: geometry.place_count]])
        people = geometry.house.people.values()
        self.home = np.array([person.home for person in people])
        self.home[0] = 1.0
        self.rooms = np.array([self._shares(person.rooms) for person in people])
        self.homes: list[float] = self.home.tolist()
        self.room_sums: list[list[float]] = np.cumsum(self.rooms, axis=1).tolist()
        self.robot_rooms = self._shares(geometry.house.robot_start)
        self.robot_room_sums: list[float] = np.cumsum(self.robot_rooms).tolist()
        self.floors: list[int] = geometry.floor_row.tolist()
        rows = np.array(geometry.thing_rows, dtype=np.int64)
        self.warm_things: list[int] = rows[self.has_state[rows, STATE_PAIRS.index("temperature")]].tolist()
        self.tempering = frozenset(row for row in range(geometry.place_count) if kinds[row].cools or kinds[row].heats)
        count = len(geometry.names)
        self.nowhere, self.no_position = np.full(count, ABSENT), np.full((count, 2), np.nan)
        self.no_states, self.none_broken = np.full((count, len(STATE_PAIRS)), -1, dtype=np.int8), np.zeros(count, bool)
        self._named = geometry.house.places_by_name()
        self._of_thing = {row: self._places(row) for row in geometry.thing_rows}
        self._places_listed = [*range(geometry.place_count), ABSENT]
        sums = [np.cumsum(weights) for _, weights in self._of_thing.values()]
        self._place_sums = np.array(sums).reshape(-1, len(self._places_listed))
        self._place_sums[:, -1] = np.inf  # whatever rounding has made of the sum of all

    def draw_places(self, draws: Floats) -> list[int]:
        """Where each thing lies (rows, `ABSENT`), by as many numbers in [0, 1)."""
        columns = (self._place_sums <= draws[:, None]).argmin(axis=1).tolist()
        return [self._places_listed[column] for column in columns]

    def draw_place(self, thing: int, draw: float) -> int:
        """Where one thing lies (a row, or `ABSENT`), by a number in [0, 1)."""
        sums = self._place_sums[thing - self.geometry.thing_rows.start]
        return self._places_listed[bisect_right(sums, draw)]

    def mass(self, thing: int, places: Sequence[int]) -> float:
        """The probability that a thing lies at one of these different places (rows)."""
        _, weights = self._of_thing[thing]
        return float(weights[places].sum())  # a place's row is its index here

    def places(self, thing: int) -> tuple[NDArray[np.int64], Floats]:
        """Where a thing may lie (rows, `ABSENT` among them) with the probability of each; padded with zeros."""
        return self._of_thing[thing]

    def _kind(self, row: int) -> Kind:
        return self.geometry.house.kind(self.geometry.names[row], self.geometry.kinds)

    def _places(self, row: int) -> tuple[NDArray[np.int64], Floats]:
        """Places and probabilities of a thing, brought to one length for all things."""
        geometry, kind = self.geometry, self.kinds[row]
        item = geometry.house.things[geometry.names[row]]
        absent = kind.absent if item.absent is None else item.absent
        weights = np.zeros(geometry.place_count + 1)
        for name, weight in (item.places or kind.places).items():
            found = [geometry.row[place] for place in self._named.get(name, ())]
            for place in found:
                weights[place] += weight / len(found)
        total = weights.sum()
        weights = weights * (1 - absent) / total if total > 0 else weights
        weights[-1] = absent if total > 0 else 1.0
        return np.append(np.arange(geometry.place_count), ABSENT), weights

    def _shares(self, weights: Mapping[str, float]) -> Floats:
        shares = np.zeros(len(self.geometry.rooms))
        for room, weight in weights.items():
            shares[self.geometry.room_index[room]] = weight
        return shares / shares.sum()


def _chance(kind: Kind, pair: str) -> float:
    return kind.chance.get(pair, 0.5) if pair in kind.states else np.nan
