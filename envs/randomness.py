"""The generators of an episode: one for each thing left to chance, so that none disturbs another."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.random import PCG64, Generator
from numpy.random.bit_generator import ISeedSequence
from numpy.typing import NDArray

WORDS = 4
"""Of 64 bits, that a PCG64 begins with: two for its state, two for its increment."""


class Generators:
    """The generators of one episode, none of which knows of another; few episodes need them all.

    Each is made of a row of `words`, `(6, 4)`, when it is first asked for.
    """

    def __init__(self, words: NDArray[np.uint64]) -> None:
        self._words = words

    @cached_property
    def base(self) -> Generator:
        """How the world begins."""
        return self._make(0)

    @cached_property
    def mixing(self) -> Generator:
        """What the balance and the options change of it."""
        return self._make(1)

    @cached_property
    def asking(self) -> Generator:
        """Which instruction."""
        return self._make(2)

    @cached_property
    def noise(self) -> Generator:
        """Slips and misses."""
        return self._make(3)

    @cached_property
    def whims(self) -> Generator:
        """Where people go who may go wherever they like."""
        return self._make(4)

    @cached_property
    def meddling(self) -> Generator:
        """What somebody else moves."""
        return self._make(5)

    def _make(self, row: int) -> Generator:
        # numpy takes any ISeedSequence, which its type stubs do not know
        return Generator(PCG64(_Words(self._words[row])))  # type: ignore[arg-type]


class _Words(ISeedSequence):
    """A seed that needs no mixing, since it is random already: making a generator of it takes a tenth of the time."""

    def __init__(self, words: NDArray[np.uint64]) -> None:
        self._words = words

    def generate_state(self, n_words: int, dtype: Any = np.uint32) -> NDArray[Any]:
        assert (n_words, dtype) == (WORDS, np.uint64)  # as PCG64 asks
        return self._words


def draw_generators(rng: Generator) -> Generators:
    """Those of the next episode of an environment, whose own generator `rng` is."""
    return Generators(rng.bit_generator.random_raw(6 * WORDS).reshape(6, WORDS))
