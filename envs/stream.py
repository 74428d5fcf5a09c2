"""A stream of random numbers: those of a generator, one at a time, drawn many at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Protocol

from numpy.random import Generator

from decomplex_bt.envs.geometry import Floats

BLOCK = 128
"""Numbers drawn at once; asking a generator for one takes ten times as long as having one ready."""


class Source(Protocol):
    """Whatever gives numbers in [0, 1): a `Stream`, or a generator itself."""

    @property
    def random(self) -> Callable[[], float]:
        """The next number."""


class Stream:
    """The numbers in [0, 1) that a generator gives: the same ones, in the same order, as if asked for one by one.

    The generator runs ahead of what was asked for, so nobody else may draw from it.
    """

    def __init__(self, rng: Generator) -> None:
        self._rng = rng
        self.random: Callable[[], float] = _numbers(rng).__next__

    def array(self, *shape: int) -> Floats:
        """The next numbers as an array; to be asked for before any single one."""
        return self._rng.random(shape)


def _numbers(rng: Generator) -> Iterator[float]:
    while True:
        yield from rng.random(BLOCK).tolist()
