"""Several households at once, each with an instruction of its own."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.vector import AutoresetMode, SyncVectorEnv

from decomplex_bt.envs.registration import HOUSEHOLD, HOUSEHOLD_FLAT, SIZES
from decomplex_bt.envs.values import plain
from decomplex_bt.errors import InputError

_AS_IT_WAS = object()
"""In place of an instruction: that of before stays."""


class HouseholdVectorEnv(SyncVectorEnv):
    """Synchronous environments; the reset option `instructions` gives one instruction to each (None: as it was, or
    drawn from the corpus where the option `instruction` is given as None).

    Where a reset is refused for one of them, none is reset, and each keeps the instruction that it had. So each reset
    is rehearsed, whatever is given: an instruction that was set as an attribute may suit no house, and a house be full.
    """

    def reset(
        self, *, seed: int | list[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """As `SyncVectorEnv.reset`; with a `reset_mask` the instructions of the others are passed over.

        Raises `InputError` where there are not as many instructions or seeds as environments, or one cannot be used.
        """
        from decomplex_bt.envs.options import asked_by

        if options is not None and not isinstance(options, Mapping):
            raise InputError(f"options is {options!r}; expected a mapping, as in {{'instructions': [...]}}")
        seed = plain(seed)
        if not (seed is None or isinstance(seed, int) or (isinstance(seed, list) and len(seed) == self.num_envs)):
            raise InputError(f"seed is {seed!r}; expected a list of {self.num_envs}, one for each, or one for all")
        options = dict(options or {})
        instructions = self._take_instructions(options)
        houses: list[Any] = [env.unwrapped for env in self.envs]
        former = [house.request for house in houses]
        mask = options.get("reset_mask", np.ones(self.num_envs, dtype=bool))
        try:
            if np.shape(mask) == (self.num_envs,):  # of another one, Gymnasium says what is wrong
                chosen = [index for index in range(self.num_envs) if mask[index]]
                self._rehearse(chosen, seed, options, instructions)
                for index in chosen:
                    if instructions[index] is not _AS_IT_WAS:
                        asked, _ = asked_by({**options, "instruction": instructions[index]}, None)
                        houses[index].instruction = asked
            return super().reset(seed=seed, options=options)
        except BaseException:
            for house, request in zip(houses, former, strict=True):
                if house.request is not request:
                    house.instruction = request
            raise

    def _take_instructions(self, options: dict[str, Any]) -> list[Any]:
        """What each is to be asked, taken out of the options: an `instruction` of None undoes that of each which is not
        given one of its own."""
        given = options.pop("instructions", None)
        others: Any = _AS_IT_WAS
        if "instruction" in options and options["instruction"] is None:
            others = options.pop("instruction")
        if given is None:
            return [others] * self.num_envs
        if isinstance(given, list | tuple | np.ndarray) and np.ndim(given) and len(given) == self.num_envs:
            return [others if instruction is None else instruction for instruction in given]
        raise InputError(f"instructions is {given!r}; expected a list of {self.num_envs}, one for each")

    def _rehearse(self, chosen: list[int], seed: Any, options: dict[str, Any], instructions: list[Any]) -> None:
        """Raises what the reset of any of them would raise, before the first is reset."""
        from decomplex_bt.envs.options import with_instruction

        common = {key: value for key, value in options.items() if key != "reset_mask"}
        seeds = [seed + index for index in range(self.num_envs)] if isinstance(seed, int) else seed
        for index in chosen:
            own = instructions[index]
            wanted = common if own is _AS_IT_WAS else with_instruction({"instruction": None, **common}, own)
            house: Any = self.envs[index].unwrapped
            _ = house.np_random  # where it was never seeded, the rehearsal would draw other numbers than the reset
            house.check_reset(seed=seeds[index] if seeds else None, options=wanted)


def make_household_vector(
    num_envs: int = 1, autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP, **arguments: Any
) -> HouseholdVectorEnv:
    """`gym.make_vec("decomplex_bt/Household-v0", num_envs=…)`; with a `size` the environments have its id."""
    identity = next((one for size, one in SIZES.items() if size == arguments.get("size")), HOUSEHOLD)
    if identity != HOUSEHOLD:
        del arguments["size"]
    return HouseholdVectorEnv([partial(gym.make, identity, **arguments)] * num_envs, autoreset_mode=autoreset_mode)


def make_flat_vector(
    num_envs: int = 1, autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP, **arguments: Any
) -> HouseholdVectorEnv:
    """As `make_household_vector`, with flat spaces."""
    made = partial(gym.make, HOUSEHOLD_FLAT, **arguments)
    return HouseholdVectorEnv([made] * num_envs, autoreset_mode=autoreset_mode)
