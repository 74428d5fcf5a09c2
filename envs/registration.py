"""The environment ids, registered with Gymnasium by `import decomplex_bt`."""

from __future__ import annotations

from gymnasium.envs.registration import register, registry

HOUSEHOLD = "decomplex_bt/Household-v0"
HOUSEHOLD_FLAT = "decomplex_bt/HouseholdFlat-v0"
HOUSEHOLD_SMALL = "decomplex_bt/HouseholdSmall-v0"
HOUSEHOLD_MEDIUM = "decomplex_bt/HouseholdMedium-v0"
HOUSEHOLD_LARGE = "decomplex_bt/HouseholdLarge-v0"
SIZES = {"small": HOUSEHOLD_SMALL, "medium": HOUSEHOLD_MEDIUM, "large": HOUSEHOLD_LARGE}
"""The ids whose houses are generated, by size."""


def register_envs() -> None:
    """Registers every id of this package; calling it again changes nothing.

    No wrappers are registered: the standard ones refuse `reset(instruction=...)`, and `gym.make_vec` refuses a
    `vector_entry_point` beside `additional_wrappers`. The environment itself refuses what comes in the wrong order
    or is no action. `wrappers.InstructionReset` brings the keyword back on top of any stack of wrappers.
    """
    for identity, entry_point, vector_entry_point, arguments in (
        (HOUSEHOLD, "household:HouseholdEnv", "vector:make_household_vector", {}),
        (HOUSEHOLD_FLAT, "flat:FlatHouseholdEnv", "vector:make_flat_vector", {}),
        *(
            (identity, "household:HouseholdEnv", "vector:make_household_vector", {"size": size})
            for size, identity in SIZES.items()
        ),
    ):
        if identity not in registry:
            register(
                identity,
                entry_point=f"decomplex_bt.envs.{entry_point}",
                vector_entry_point=f"decomplex_bt.envs.{vector_entry_point}",
                order_enforce=False,
                disable_env_checker=True,
                kwargs=arguments,
            )
