"""The generators of an episode: one for each thing left to chance, so that none disturbs another."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.random import PCG64, Generator
from numpy.random.bit_generator import ISeedSequence
from numpy.typing import NDArray

WORDS = 4
"""Of 64 bits, that a PCG64 begins with: two for its state, two for its increment."""


class Generators(NamedTuple):
    """`base`: how the world begins. `mixing`: what the balance and the options change of it. `asking`: which
    instruction. `noise`: slips and misses. `whims`: where people go who may go wherever they like. `meddling`: what
    somebody else moves."""

    base: Generator
    mixing: Generator
    asking: Generator
    noise: Generator
    whims: Generator
    meddling: Generator


class _Words(ISeedSequence):
    """A seed that needs no mixing, since it is random already: making a generator of it takes a tenth of the time."""

    def __init__(self, words: NDArray[np.uint64]) -> None:
        self._words = words

    def generate_state(self, n_words: int, dtype: Any = np.uint32) -> NDArray[Any]:
        assert (n_words, dtype) == (WORDS, np.uint64)  # as PCG64 asks
        return self._words


def draw_generators(rng: Generator) -> Generators:
    """Those of the next episode of an environment, whose own generator `rng` is."""
    count = len(Generators._fields)
    words = rng.bit_generator.random_raw(count * WORDS).reshape(
        count, WORDS
    )  # what `integers` gives, six times as fast
    # numpy takes any ISeedSequence, which its type stubs do not know
    return Generators(*(Generator(PCG64(_Words(row))) for row in words))  # type: ignore[arg-type]
