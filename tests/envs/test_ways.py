"""Whether the ways through a room stay open is found for whole rows of cells at once, and as cell by cell."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import label

from decomplex_bt.envs.ways import Ways

SHADOW = 0.5


def ways_of(rng):
    rows, columns = (int(count) for count in rng.integers(1, 30, size=2))
    cells = np.stack(np.meshgrid(0.1 * np.arange(columns), 0.1 * np.arange(rows)), axis=-1).reshape(-1, 2)
    passable = rng.random(len(cells)) < rng.uniform(0.5, 1)
    marks = rng.random((3, len(cells))) < 0.05
    return Ways(cells, passable, marks, SHADOW), cells, passable, marks, (rows, columns)


def flooded(cells, passable, marks, shape, people):
    free = passable.copy()
    for x, y in people:
        free &= (cells[:, 0] - x) ** 2 + (cells[:, 1] - y) ** 2 >= SHADOW**2
    labels, _ = label(free.reshape(shape))
    labels = labels.ravel()
    return np.isin(labels, labels[marks[0] & free]) & free


def test_what_is_reached_is_what_hangs_together_with_the_first_mark():
    rng = np.random.default_rng(0)
    open_ways = 0
    for _ in range(150):
        ways, *room = ways_of(rng)
        cells, _, marks, _ = room
        people = [tuple(at) for at in rng.uniform(0, cells[-1] + 0.1, size=(int(rng.integers(4)), 2)).tolist()]
        expected = flooded(*room, people)
        assert np.array_equal(ways.reached(people), expected)
        is_open = bool((marks & expected).any(axis=1).all())
        assert ways.are_free(people) == is_open
        open_ways += is_open
    assert 10 < open_ways < 140


def test_a_spot_that_is_kept_gives_the_same_answer():
    rng = np.random.default_rng(1)
    for _ in range(20):
        ways, cells, *_ = ways_of(rng)
        x, y = cells[int(rng.integers(len(cells)))].tolist()
        before = ways.reached([(x, y)]), ways.are_free([(x, y)])
        ways.keep(x, y)
        for _ in range(2):
            assert np.array_equal(ways.reached([(x, y)]), before[0])
            assert ways.are_free([(x, y)]) == before[1]
