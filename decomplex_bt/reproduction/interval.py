"""What repeated splits say of a measure: the mean, with the interval that they leave open."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import fmean, stdev
from typing import Any

import numpy as np

from decomplex_bt.evaluation.proportion import CONFIDENCE, Proportion

RESAMPLES = 200
"""Bootstrap samples of a test part."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """The mean of a measure over `splits` splits, with its interval at 95 % (None where nothing says it)."""

    mean: float
    interval: tuple[float, float] | None
    splits: int

    def to_json(self) -> dict[str, Any]:
        interval = None if self.interval is None else [round(end, 4) for end in self.interval]
        return {"mean": round(self.mean, 4), "interval": interval, "splits": self.splits}

    def __str__(self) -> str:
        if self.interval is None:
            return f"{self.mean:.3f}"
        low, high = self.interval
        return f"{self.mean:.3f} [{low:.3f}, {high:.3f}]"


def estimate(
    values: Sequence[float],
    *,
    test_share: float,
    bounds: tuple[float, float] | None,
    within: tuple[float, float] | None = None,
) -> Estimate:
    """The corrected resampled t interval of Nadeau and Bengio (2003).

    Splits share their training data, so the variance of the mean is the splits' times 1/splits + n_test/n_train.
    `test_share`: n_test/n_train. `bounds`: what the measure cannot leave. `within`: the interval of a single split.
    """
    mean = fmean(values)
    if len(values) < 2:
        return Estimate(mean, within, len(values))
    from scipy.stats import t

    half = float(t.ppf(0.5 + CONFIDENCE / 2, len(values) - 1)) * stdev(values) * (1 / len(values) + test_share) ** 0.5
    low, high = mean - half, mean + half
    if bounds is not None:
        low, high = max(bounds[0], low), min(bounds[1], high)
    return Estimate(mean, (low, high), len(values))


def wilson(outcomes: Sequence[bool]) -> tuple[float, float] | None:
    """The interval of the share that is true; None for no outcomes."""
    return Proportion(sum(outcomes), len(outcomes)).interval


def bootstrap(measure: Callable[[list[int]], float], size: int, rng: np.random.Generator) -> tuple[float, float]:
    """The percentile interval of a measure over `size` test instructions, drawn again with replacement."""
    drawn = [measure([int(i) for i in rng.integers(size, size=size)]) for _ in range(RESAMPLES)]
    tail = (1 - CONFIDENCE) / 2
    return float(np.quantile(drawn, tail)), float(np.quantile(drawn, 1 - tail))
