"""A proportion with the interval that the data leave open."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class Proportion:
    """`count` of `total`, with the Wilson interval at 95 %. Without data, value and interval are None."""

    count: int
    total: int

    @property
    def value(self) -> float | None:
        return self.count / self.total if self.total else None

    @property
    def interval(self) -> tuple[float, float] | None:
        """Both ends, in [0, 1]."""
        if not self.total:
            return None
        from scipy.stats import binomtest  # takes most of a second to import

        found = binomtest(self.count, self.total).proportion_ci(CONFIDENCE, method="wilson")
        return float(found.low), float(found.high)

    def to_json(self) -> dict[str, Any]:
        interval = self.interval
        return {
            "count": self.count,
            "total": self.total,
            "value": None if self.value is None else round(self.value, 4),
            "interval": None if interval is None else [round(end, 4) for end in interval],
        }

    def __str__(self) -> str:
        if self.value is None or self.interval is None:
            return "no data"
        low, high = self.interval
        return f"{self.value:.1%} [{low:.1%}, {high:.1%}] ({self.count}/{self.total})"
