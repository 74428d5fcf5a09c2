"""The ways through one room: whether all that is used in it hangs together when people stand in them.

The room is a grid of cells, and a set of cells is one whole number, a bit for each: what hangs together is then found
for whole rows of cells at once. A column of cells that are never free stands between the rows of the grid, so that
nothing spreads from the end of one row to the beginning of the next.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Floats

Bools = NDArray[np.bool_]
Point = tuple[float, float]


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

    def are_free(self, people: Iterable[Point]) -> bool:
        """Whether the free cells that hang together with the first doorway touch every doorway and every place."""
        return self._spread(people, self._marks) is None

    def keep(self, x: float, y: float) -> None:
        """Keeps where a person here stands in the way, for they may stand here often."""
        self._shadows[x, y] = self._shadow_at(x, y)

    def cells_of(self, points: Floats) -> NDArray[np.int64]:
        """The cells that points lie in."""
        rows, columns = self._shape
        low, high = self._cells[0], self._cells[-1]
        steps = np.rint((points - low) / np.maximum(high - low, 1e-9) * (columns - 1, rows - 1)).astype(np.int64)
        return steps[:, 1] * columns + steps[:, 0]

    def reached(self, people: Iterable[Point]) -> Bools:
        """Which cells hang together with the first doorway, past the people."""
        reached = self._spread(people, ())
        assert reached is not None
        return self._cells_in(reached)

    def _cells_in(self, reached: int) -> Bools:
        rows, columns = self._shape
        count = rows * (columns + 1)
        packed = np.frombuffer(reached.to_bytes((count + 7) // 8, "little"), dtype=np.uint8)
        bits = np.unpackbits(packed, count=count, bitorder="little").reshape(rows, columns + 1)
        return bits[:, :columns].ravel().view(np.bool_)

    def _spread(self, people: Iterable[Point], marks: Iterable[int]) -> int | None:
        """The free cells that hang together with the first doorway, past the people; None once they touch all `marks`.

        Without marks all of them are found. Cells spread along their rows and columns to the next one that is not
        free, in steps twice as long each time, or at once where an addition's carry goes the same way; that is repeated
        until nothing is added.
        """
        free = self._passable
        for person in people:
            shadow = self._shadows.get(person)
            free &= ~(self._shadow_at(*person) if shadow is None else shadow)
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
        left = list(marks)
        has_marks = bool(left)
        reached, before = self._marks[0] & free, -1
        while reached != before:
            left = [mark for mark in left if not mark & reached]
            if has_marks and not left:
                return None
            before = reached
            reached |= free & ~(free + reached)  # the carry of a cell ends behind the last free one of its row
            for step, back in along:
                reached |= back & reached >> step
            for step, ahead, back in across:
                reached |= ahead & reached << step | back & reached >> step
        return reached

    def _shadow_at(self, x: float, y: float) -> int:
        """The cells that a person here stands in the way of."""
        return self._bits((self._cells[:, 0] - x) ** 2 + (self._cells[:, 1] - y) ** 2 < self._shadow**2)

    def _bits(self, cells: Bools) -> int:
        rows, columns = self._shape
        padded = np.zeros((rows, columns + 1), dtype=np.bool_)
        padded[:, :columns] = cells.reshape(rows, columns)
        return int.from_bytes(np.packbits(padded.ravel(), bitorder="little").tobytes(), "little")
