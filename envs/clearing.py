"""A clearing: the spots of one room where somebody can stand, and which of them are clear of what takes up room.

People and things are at spots of the same few grids in every episode: what each of them leaves free is remembered.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Floats

MOST_DISCS = 1024
"""Discs whose answer is kept at once, for each room."""

Disc = tuple[float, float, float]
"""x, y, radius."""
Point = tuple[float, float]
Bools = NDArray[np.bool_]


class Free(Sequence[Point]):
    """Those of a list of spots that are free, without a list of their own: few are ever looked at."""

    __slots__ = ("_rows", "_spots")

    def __init__(self, spots: Sequence[Point], rows: NDArray[np.int64]) -> None:
        self._spots, self._rows = spots, rows

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[Point]:
        return map(self._spots.__getitem__, self._rows.tolist())

    def __getitem__(self, index: Any) -> Any:
        return self._spots[self._rows[index]]


class Clearing:
    """The spots of a room, `(n, 2)`, each for somebody who wants `radius` [m] around it for themselves."""

    def __init__(self, points: Floats, radius: float) -> None:
        self.points = points
        self.spots: list[Point] = [(x, y) for x, y in points.tolist()]
        self._radius = radius
        self._apart: dict[Disc, Bools] = {}

    def free(self, taken: Sequence[Disc], among: Bools | None = None) -> Sequence[Point]:
        """The spots that touch none of the discs taken, in order; `among`: of these alone."""
        if not taken:
            return self.spots if among is None else Free(self.spots, among.nonzero()[0])
        first, *others = taken
        is_free = self._apart_from(first) if among is None else among & self._apart_from(first)
        for disc in others:
            is_free = is_free & self._apart_from(disc)
        return Free(self.spots, is_free.nonzero()[0])

    def _apart_from(self, disc: Disc) -> Bools:
        is_apart = self._apart.get(disc)
        if is_apart is None:
            if len(self._apart) >= MOST_DISCS:
                self._apart.clear()
            self._apart[disc] = is_apart = is_apart_from(self.points, self._radius, disc)
        return is_apart


def is_apart_from(points: Floats, radius: float, taken: Disc) -> Bools:
    """At which of `(n, 2)` points a disc does not touch another."""
    x, y, other = taken
    across, along, gap = x - points[:, 0], y - points[:, 1], other + radius
    return across * across + along * along >= gap * gap


def are_apart(points: Floats, radius: float, taken: Sequence[Disc]) -> Bools:
    """At which of `(n, 2)` points a disc touches none of those taken, at least one."""
    x, y, other = np.array(taken).T[:, :, None]
    across, along, gap = x - points[:, 0], y - points[:, 1], other + radius
    is_apart: Bools = (across * across + along * along >= gap * gap).all(axis=0)
    return is_apart
