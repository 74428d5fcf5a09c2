"""The household environment with flat spaces, for learners that take a vector and a few choices."""

from __future__ import annotations

from operator import index
from typing import TYPE_CHECKING, Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from decomplex_bt.envs.household import HouseholdEnv, Observation
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.spaces import observation_space
from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.envs.episode import Episode

SPEEDS = tuple(round(share / 4, 2) for share in range(-4, 5))
"""The nine speeds, as shares of the highest, that a flat action chooses from."""


KEPT = ("robot", "held", "entities", "result", "seconds", "instruction_codes")
"""The keys of the `Dict` observation in the order they stand in the vector."""
INDICATORS = np.eye(len(Result), dtype=np.float32)


class FlatHouseholdEnv(HouseholdEnv):
    """`HouseholdEnv` with a `MultiDiscrete` action and a `Box` observation.

    Action `MultiDiscrete([9, 9, 13, rows])`: forward and turning speed (indices of `SPEEDS`), interaction, target.
    Observation `Box(float32)`: robot (5), held (5), entity table row by row, result as 13 indicators, seconds, and the
    2,000 codes of the instruction; `parts` has the slice of each. All else is as in `HouseholdEnv`.
    """

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Does one action. Raises `InputError` for one that is none."""
        forward, turn, interact, target = self._read(action)
        drive = (SPEEDS[forward], SPEEDS[turn])
        return super().step({"drive": drive, "interact": interact, "target": target})

    def _read(self, action: Any) -> list[int]:
        counts = self._counts
        try:
            choices = [index(choice) for choice in action]
        except TypeError:  # nothing to go through, or something in it is no whole number
            choices = []
        if len(choices) == len(counts) and all(0 <= choice < n for choice, n in zip(choices, counts, strict=True)):
            return choices
        raise InputError(
            f"no action: {action!r}; expected {len(counts)} whole numbers from 0, below {', '.join(map(str, counts))}"
        )

    @property
    def _counts(self) -> list[int]:
        """How many choices each number of an action has."""
        return [len(SPEEDS), len(SPEEDS), len(Interaction), self._home.rows]

    @property
    def parts(self) -> dict[str, slice]:
        """Where each key of the `Dict` observation stands in the vector."""
        sizes = {key: int(np.prod(space.shape or (len(Result),))) for key, space in self._kept()}
        ends = np.cumsum(list(sizes.values())).tolist()
        return {key: slice(end - size, end) for (key, size), end in zip(sizes.items(), ends, strict=True)}

    def _kept(self) -> list[tuple[str, spaces.Space[Any]]]:
        inner = observation_space(self._home.rows, self._home.bounds, self.config.world.tray_slots)
        return [(key, inner[key]) for key in KEPT]

    def _make_action_space(self) -> spaces.Space[Any]:
        return spaces.MultiDiscrete(self._counts)

    def _make_observation_space(self) -> spaces.Space[Any]:
        lows, highs = [], []
        for _, space in self._kept():
            is_box = isinstance(space, spaces.Box)
            lows.append(space.low.ravel() if is_box else np.zeros(len(Result)))  # type: ignore[attr-defined]
            highs.append(space.high.ravel() if is_box else np.ones(len(Result)))  # type: ignore[attr-defined]
        return spaces.Box(np.concatenate(lows).astype(np.float32), np.concatenate(highs).astype(np.float32))

    def _observe(self, episode: Episode) -> Observation | NDArray[np.float32]:  # type: ignore[override]
        seen = episode.observe()
        seen["result"] = INDICATORS[seen["result"]]
        return np.concatenate([seen[key].ravel() for key in KEPT], dtype=np.float32)
