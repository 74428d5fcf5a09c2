"""Wrappers around the environments."""

from __future__ import annotations

from typing import Any

import gymnasium as gym
from gymnasium.utils import RecordConstructorArgs


class InstructionReset(gym.Wrapper, RecordConstructorArgs):
    """Lets `reset` take the instruction itself: `env.reset(seed=7, instruction="Bring me a pen.")`.

    The environments do so on their own; put this outermost where other wrappers are around them, for the standard ones
    refuse an unknown keyword.
    """

    def __init__(self, env: gym.Env[Any, Any]) -> None:
        RecordConstructorArgs.__init__(self)
        gym.Wrapper.__init__(self, env)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None, instruction: Any = None
    ) -> tuple[Any, dict[str, Any]]:
        """As the environment's, with `instruction` as the option of that name (see `HouseholdEnv`)."""
        from decomplex_bt.envs.options import with_instruction

        return self.env.reset(seed=seed, options=with_instruction(options, instruction))
