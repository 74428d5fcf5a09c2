"""Several households at once, each with an instruction of its own."""

from __future__ import annotations

from functools import partial
from typing import Any

import gymnasium as gym
from gymnasium.vector import SyncVectorEnv

from decomplex_bt.errors import InputError


class HouseholdVectorEnv(SyncVectorEnv):
    """Synchronous environments; the reset option `instructions` gives one instruction to each (None: as it was).

    Where it is refused, each keeps the instruction that it had.
    """

    def reset(
        self, *, seed: int | list[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """As `SyncVectorEnv.reset`. Raises `InputError` where there are not as many instructions as environments."""
        options = dict(options or {})
        instructions = options.pop("instructions", None)
        if instructions is not None and (isinstance(instructions, str) or len(instructions) != self.num_envs):
            raise InputError(f"instructions is {instructions!r}; expected a list of {self.num_envs}, one for each")
        houses: list[Any] = [env.unwrapped for env in self.envs]
        former = [house.request for house in houses]
        try:
            for house, instruction in zip(houses, instructions or [None] * self.num_envs, strict=True):
                if instruction is not None:
                    house.instruction = instruction
            return super().reset(seed=seed, options=options)
        except Exception:
            for house, request in zip(houses, former, strict=True):
                house.instruction = request
            raise


def make_household_vector(num_envs: int = 1, **arguments: Any) -> HouseholdVectorEnv:
    """`gym.make_vec("decomplex_bt/Household-v0", num_envs=…, vectorization_mode="vector_entry_point")`."""
    return _make("decomplex_bt/Household-v0", num_envs, arguments)


def make_flat_vector(num_envs: int = 1, **arguments: Any) -> HouseholdVectorEnv:
    """As `make_household_vector`, with flat spaces."""
    return _make("decomplex_bt/HouseholdFlat-v0", num_envs, arguments)


def _make(identity: str, num_envs: int, arguments: dict[str, Any]) -> HouseholdVectorEnv:
    return HouseholdVectorEnv([partial(gym.make, identity, **arguments)] * num_envs)
