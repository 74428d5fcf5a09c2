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


def furnished_ways_of(rng):
    """Of a room with some furniture, each piece of which is used from around it; the first mark is a doorway."""
    rows, columns = (int(count) for count in rng.integers(15, 40, size=2))
    x, y = np.meshgrid(0.1 * np.arange(columns), 0.1 * np.arange(rows))
    cells, passable, marks = np.stack((x, y), axis=-1).reshape(-1, 2), np.ones((rows, columns), dtype=bool), []
    marks.append((np.abs(x - rng.uniform(0, columns / 10)) < 0.35) & (y < 0.2))
    for _ in range(int(rng.integers(1, 7))):
        left, low = rng.uniform(0, columns / 10), rng.uniform(0.5, rows / 10)
        width, depth = rng.uniform(0.3, 2.0, size=2)
        outside = np.maximum.reduce([left - x, x - left - width, low - y, y - low - depth])
        passable &= outside > 0
        marks.append(outside < 0.75)
    flat = np.array(marks).reshape(len(marks), -1)
    return Ways(cells, passable.ravel(), flat, SHADOW), cells, passable.ravel(), flat, (rows, columns)


def test_people_at_spots_that_are_kept_give_the_same_answer():
    rng = np.random.default_rng(1)
    answers = {True: 0, False: 0}
    passed = 0
    for _ in range(60):
        ways, *room = furnished_ways_of(rng)
        cells, passable, marks, _ = room
        spots = [(x, y) for x, y in cells[passable][:: int(rng.integers(3, 9))].tolist() if ways.are_free([(x, y)])]
        for spot in spots:
            ways.keep(*spot)
        for _ in range(20 if len(spots) > 3 else 0):
            company = [spots[int(at)] for at in rng.integers(len(spots), size=int(rng.integers(1, 5)))]
            company += [tuple(at) for at in rng.uniform(0, cells[-1], size=(int(rng.integers(2)), 2)).tolist()]
            expected = flooded(*room, company)
            is_open = bool((marks & expected).any(axis=1).all())
            for _ in range(2):  # the second answer is remembered
                assert np.array_equal(ways.reached(company), expected)
                assert ways.are_free(company) == is_open
            answers[is_open] += 1
            passed += len(ways._unavoidable(company)) < len(company)
        assert np.array_equal(ways.reached([]), flooded(*room, []))
    assert min(answers.values()) > 100
    assert passed > 100, "who stands in nobody's way is left out"
