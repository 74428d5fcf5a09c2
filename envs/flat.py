"""The household environment with flat spaces, for learners that take a vector and a few choices."""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from decomplex_bt.envs.household import HouseholdEnv, Observation
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.spaces import observation_space

SPEEDS = tuple(round(share / 4, 2) for share in range(-4, 5))
"""The nine speeds, as shares of the highest, that a flat action chooses from."""


KEPT = ("robot", "held", "entities", "result", "seconds", "instruction_codes")
"""The keys of the `Dict` observation in the order they stand in the vector."""
INDICATORS = np.eye(len(Result), dtype=np.float32)


class FlatHouseholdEnv(HouseholdEnv):
    """`HouseholdEnv` with a `MultiDiscrete` action and a `Box` observation.

    Action `MultiDiscrete([9, 9, 13, rows])`: forward and turning speed (indices of `SPEEDS`), interaction, target.
    Observation `Box(float32)`: robot (5), held (5), entity table row by row, result as 12 indicators, seconds, and the
    2,000 codes of the instruction; `parts` has the slice of each. All else is as in `HouseholdEnv`.
    """

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Does one action. Raises `InputError` for one that is none."""
        if isinstance(action, dict):
            return super().step(action)
        forward, turn, interact, target = (int(value) for value in action)
        drive = (SPEEDS[forward], SPEEDS[turn])
        return super().step({"drive": drive, "interact": interact, "target": target})

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
        return spaces.MultiDiscrete([len(SPEEDS), len(SPEEDS), len(Interaction), self._home.rows])

    def _make_observation_space(self) -> spaces.Space[Any]:
        lows, highs = [], []
        for _, space in self._kept():
            is_box = isinstance(space, spaces.Box)
            lows.append(space.low.ravel() if is_box else np.zeros(len(Result)))  # type: ignore[attr-defined]
            highs.append(space.high.ravel() if is_box else np.ones(len(Result)))  # type: ignore[attr-defined]
        return spaces.Box(np.concatenate(lows).astype(np.float32), np.concatenate(highs).astype(np.float32))

    def _observe(self) -> Observation | NDArray[np.float32]:  # type: ignore[override]
        seen = super()._observe()
        seen["result"] = INDICATORS[seen["result"]]
        return np.concatenate([seen[key].ravel() for key in KEPT], dtype=np.float32)
