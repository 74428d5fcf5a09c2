"""The setup of an evaluation: what all its episodes have in common."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from decomplex_bt.errors import InputError, quoted
from decomplex_bt.evaluation.planners import Planning, check_planner

HOUSEHOLD = "decomplex_bt/Household-v0"
"""The environment where none is named."""
_HIGHEST = {"balance": 0.5, "max_seconds": float("inf"), "grasp_slip": 1.0, "missed_detection": 1.0, "meddling": 60.0}
"""The highest value of each number of a `Setup`, as the reset options have it; the lowest is 0."""


@dataclass(frozen=True, slots=True)
class Setup:
    """What all episodes of an evaluation have in common.

    `env_id`: of an environment that takes a `domain` and offers the agents that are named by `policy(name, ...)`; each
    episode has its own. `domain`: name or folder. `balance` in [0, 0.5], `max_seconds` of simulated time: None as the
    environment has them.
    `noise`: slips and misses, as the house has them, or with the probabilities `grasp_slip` and `missed_detection`.
    `meddling`: things that somebody else moves in a minute of simulated time, on average, from 0 to 60.
    `planner`: of the agents that plan, or a function that makes one (None: pyperplan). Each process has its own, copied
    or made there, for all its episodes; so has each thread, where joblib runs threads, but for a planner that is given
    as it is: they share it. It counts for equality alone: one that cannot be hashed is a planner as well.
    Raises `InputError` for a number out of its range, and for what is none of these.
    """

    env_id: str = HOUSEHOLD
    domain: str | Path = "household"
    balance: float | None = None
    max_seconds: float | None = None
    noise: bool = True
    grasp_slip: float | None = None
    missed_detection: float | None = None
    meddling: float | None = None
    planner: Planning | None = field(default=None, hash=False)

    def __post_init__(self) -> None:
        if not isinstance(self.env_id, str):
            raise InputError(f"env_id is {self.env_id!r}; expected the id of an environment, as in {HOUSEHOLD!r}")
        if not isinstance(self.domain, str | Path):
            raise InputError(f"domain is {quoted(self.domain)}; expected the name of a shipped one or a folder")
        for name, highest in _HIGHEST.items():
            value = getattr(self, name)
            is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
            if value is not None and not (is_number and 0.0 <= value <= highest):
                raise InputError(f"{name} is {value!r}; expected a number from 0 to {highest:g}")
        if not isinstance(self.noise, bool):
            raise InputError(f"noise is {self.noise!r}; expected True or False")
        check_planner(self.planner)

    def options(self) -> dict[str, Any]:
        """The reset options that they come to."""
        options = {
            "balance": self.balance,
            "max_seconds": self.max_seconds,
            "noise": self.noise,
            "grasp_slip": self.grasp_slip,
            "missed_detection": self.missed_detection,
            "meddling": self.meddling,
        }
        return {key: value for key, value in options.items() if value is not None}
