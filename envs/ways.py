"""The ways through one room: whether all that is used in it hangs together when people stand in them.

The room is a grid of cells, and a set of cells is one whole number, a bit for each: what hangs together is then found
for whole rows of cells at once. A column of cells that are never free stands between the rows of the grid, so that
nothing spreads from the end of one row to the beginning of the next.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Floats

Bools = NDArray[np.bool_]
Point = tuple[float, float]
Steps = tuple[int, list[tuple[int, int]], list[tuple[int, int, int]]]
"""The free cells, and for each step along the rows and across them the cells from which it goes over free ones."""


class Ways:
    """The ways of a room. `cells`: `(n, 2)` middles of a grid, row by row. `passable`: those in which nothing stands.

    `marks`: `(m, n)` for each doorway and each place that is used the cells from where it is; the first are where one
    comes in. `shadow` [m]: no way leads so near past a person.
    """

    def __init__(self, cells: Floats, passable: Bools, marks: Bools, shadow: float) -> None:
        self._cells, self._shadow = cells, shadow
        self._shape = len(np.unique(cells[:, 1])), len(np.unique(cells[:, 0]))
        self._passable = self._bits(passable)
        self._marks = [self._bits(mark) for mark in marks]
        self._shadows: dict[Point, int] = {}
        self._rims: dict[Point, int] = {}
        self._reached: dict[tuple[Point, ...], int] = {}

    def are_free(self, people: Iterable[Point]) -> bool:
        """Whether the free cells that hang together with the first doorway touch every doorway and every place."""
        left = self._unavoidable(people)
        is_known = len(left) == 1 and left[0] in self._shadows
        return is_known or self._spread(left, self._marks) is None

    def keep(self, x: float, y: float) -> None:
        """Keeps where a person here stands in the way, for they may stand here often; alone they must leave the ways
        free."""
        self._shadows[x, y] = shadow = self._shadow_at(x, y)
        rim = self._rim(shadow)
        is_whole = _spread_in(self._steps(rim), rim & -rim) == rim
        if is_whole and all(mark & rim for mark in self._marks if mark & shadow):
            self._rims[x, y] = rim

    def _unavoidable(self, people: Iterable[Point]) -> list[Point]:
        """Of people, those who may stand in the way; of any, one at least. Nobody does the rim of whose shadow is free
        of others and hangs together: what leads through the shadow leads round it, and what is marked in it is so on
        its rim."""
        left = list(people)
        for person in tuple(left):
            rim = self._rims.get(person)
            others = [other for other in left if other != person]
            if others and rim is not None and not any(rim & self._shadows.get(other, rim) for other in others):
                left = others
        return left

    def _rim(self, shadow: int) -> int:
        """The passable cells around a shadow, at its corners as well."""
        row = self._shape[1] + 1
        wide = shadow | shadow << 1 | shadow >> 1
        return (wide | wide << row | wide >> row) & self._passable & ~shadow

    def cells_of(self, points: Floats) -> NDArray[np.int64]:
        """The cells that points lie in."""
        rows, columns = self._shape
        low, high = self._cells[0], self._cells[-1]
        steps = np.rint((points - low) / np.maximum(high - low, 1e-9) * (columns - 1, rows - 1)).astype(np.int64)
        return steps[:, 1] * columns + steps[:, 0]

    def reached(self, people: Iterable[Point]) -> Bools:
        """Which cells hang together with the first doorway, past the people."""
        company = list(people)
        reached = self._reached_past(self._unavoidable(company))
        for person in company:
            reached &= ~self._shadow_of(person)
        return self._cells_in(reached)

    def _reached_past(self, people: list[Point]) -> int:
        """The same as bits, remembered where nobody is, or one who may stand there often."""
        key = tuple(people)
        if key in self._reached:
            return self._reached[key]
        reached = self._spread(people, ())
        assert reached is not None
        if len(people) < 2 and self._shadows.keys() >= set(people):
            self._reached[key] = reached
        return reached

    def _cells_in(self, reached: int) -> Bools:
        rows, columns = self._shape
        count = rows * (columns + 1)
        packed = np.frombuffer(reached.to_bytes((count + 7) // 8, "little"), dtype=np.uint8)
        bits = np.unpackbits(packed, count=count, bitorder="little").reshape(rows, columns + 1)
        return bits[:, :columns].ravel().view(np.bool_)

    def _spread(self, people: Iterable[Point], marks: Sequence[int]) -> int | None:
        """The free cells that hang together with the first doorway, past the people; None once they touch all `marks`.

        Without marks all of them are found.
        """
        free = self._passable
        for person in people:
            free &= ~self._shadow_of(person)
        return _spread_in(self._steps(free), self._marks[0] & free, marks)

    def _steps(self, free: int) -> Steps:
        """How cells spread along their rows and columns to the next one that is not free, in steps twice as long each
        time, or at once where an addition's carry goes the same way."""
        rows, columns = self._shape
        along: list[tuple[int, int]] = []
        ahead = back = free
        step = 1
        while step < columns:
            along.append((step, back))
            back &= back >> step
            step *= 2
        across: list[tuple[int, int, int]] = []
        back = free
        step = columns + 1
        while step < rows * (columns + 1):
            across.append((step, ahead, back))
            ahead, back = ahead & ahead << step, back & back >> step
            step *= 2
        return free, along, across

    def _shadow_of(self, person: Point) -> int:
        shadow = self._shadows.get(person)
        return self._shadow_at(*person) if shadow is None else shadow

    def _shadow_at(self, x: float, y: float) -> int:
        """The cells that a person here stands in the way of."""
        return self._bits((self._cells[:, 0] - x) ** 2 + (self._cells[:, 1] - y) ** 2 < self._shadow**2)

    def _bits(self, cells: Bools) -> int:
        rows, columns = self._shape
        padded = np.zeros((rows, columns + 1), dtype=np.bool_)
        padded[:, :columns] = cells.reshape(rows, columns)
        return int.from_bytes(np.packbits(padded.ravel(), bitorder="little").tobytes(), "little")


def _spread_in(steps: Steps, reached: int, marks: Sequence[int] = ()) -> int | None:
    """The free cells that hang together with those reached; None once they touch all marks, if there are any."""
    free, along, across = steps
    left, before = list(marks), -1
    while reached != before:
        left = [mark for mark in left if not mark & reached]
        if marks and not left:
            return None
        before = reached
        reached |= free & ~(free + reached)  # the carry of a cell ends behind the last free one of its row
        for step, back in along:
            reached |= back & reached >> step
        for step, ahead, back in across:
            reached |= ahead & reached << step | back & reached >> step
    return reached
