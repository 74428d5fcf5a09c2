"""What somebody leaves free of a room is the same, remembered or not."""

from __future__ import annotations

import numpy as np

from decomplex_bt.envs import clearing as clearing_module
from decomplex_bt.envs.clearing import Clearing


def test_the_free_spots_are_those_that_touch_nothing(monkeypatch):
    monkeypatch.setattr(clearing_module, "MOST_DISCS", 5)
    rng = np.random.default_rng(0)
    points = rng.uniform(0, 4, (60, 2))
    clearing = Clearing(points, 0.3)
    discs = [(x, y, 0.25) for x, y in rng.uniform(0, 4, (9, 2)).tolist()]
    for count in range(9):
        for _ in range(3):
            taken = [discs[index] for index in rng.permutation(9)[:count]]
            among = rng.random(60) < 0.7
            expected = [
                (x, y)
                for x, y in points.tolist()
                if all((x - ox) ** 2 + (y - oy) ** 2 >= (0.3 + radius) ** 2 for ox, oy, radius in taken)
            ]
            assert list(clearing.free(taken)) == expected
            free = clearing.free(taken, among)
            assert list(free) == [
                spot for spot, is_among in zip(clearing.spots, among, strict=True) if is_among and spot in expected
            ]
            assert [free[index] for index in range(len(free))] == list(free)


def test_where_nothing_stands_all_spots_are_free():
    clearing = Clearing(np.array([(0.0, 1.0), (2.0, 3.0)]), 0.3)
    assert list(clearing.free(())) == [(0.0, 1.0), (2.0, 3.0)]
