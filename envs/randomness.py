"""The generators of an episode: one for each thing left to chance, so that none disturbs another."""

from __future__ import annotations

from collections.abc import Hashable
from functools import cached_property, lru_cache
from hashlib import blake2b
from typing import Any

import numpy as np
from numpy.random import PCG64, Generator
from numpy.random.bit_generator import ISeedSequence
from numpy.typing import NDArray

WORDS = 4
"""Of 64 bits, that a PCG64 begins with: two for its state, two for its increment."""
COUNT = 6
"""Of generators."""


class _Words(ISeedSequence):
    """A seed that needs no mixing, since it is random already: making a generator of it takes a tenth of the time."""

    def __init__(self, words: NDArray[np.uint64]) -> None:
        self._words = words

    def generate_state(self, n_words: int, dtype: Any = np.uint32) -> NDArray[Any]:
        assert (n_words, dtype) == (WORDS, np.uint64)  # as PCG64 asks
        return self._words


def _generator(number: int) -> cached_property[Generator]:
    """The generator of this number, as an attribute."""

    def make(generators: Generators) -> Generator:
        # numpy takes any ISeedSequence, which its type stubs do not know
        return Generator(PCG64(_Words(generators._words[number])))  # type: ignore[arg-type]

    return cached_property(make)


class Generators:
    """`base`: how the world begins. `changing`: what the options change of it. `asking`: which instruction. `noise`:
    slips and misses. `whims`: where people go who may go wherever they like. `meddling`: what somebody else moves. Each
    is made when it is first asked for: most episodes need three."""

    def __init__(self, words: NDArray[np.uint64]) -> None:
        self._words = words

    base = _generator(0)
    changing = _generator(1)
    asking = _generator(2)
    noise = _generator(3)
    whims = _generator(4)
    meddling = _generator(5)

    def mixing(self, tests: Hashable) -> Generator:
        """What the balance changes of it, by what a flow tests (values with a text of their own).

        By the seed alone, the first condition of every instruction would come out alike.
        """
        return Generator(PCG64(_Words(self._words[1] ^ _digest(tests))))  # type: ignore[arg-type]


def draw_generators(rng: Generator) -> Generators:
    """Those of the next episode of an environment, whose own generator `rng` is."""
    # what `integers` gives, six times as fast
    return Generators(rng.bit_generator.random_raw(COUNT * WORDS).reshape(COUNT, WORDS))


@lru_cache(maxsize=64)
def _digest(value: Hashable) -> NDArray[np.uint64]:
    """The words that a value's text comes to, in any process the same."""
    return np.frombuffer(blake2b(repr(value).encode(), digest_size=8 * WORDS).digest(), dtype="<u8").astype(np.uint64)
