"""A stream gives what its generator would have given."""

from __future__ import annotations

import numpy as np

from decomplex_bt.envs.stream import BLOCK, Stream


def test_the_numbers_are_those_of_the_generator_one_by_one():
    stream, rng = Stream(np.random.default_rng(3)), np.random.default_rng(3)
    assert np.array_equal(stream.array(4, 5), rng.random((4, 5)))
    assert [stream.random() for _ in range(2 * BLOCK + 7)] == [rng.random() for _ in range(2 * BLOCK + 7)]
