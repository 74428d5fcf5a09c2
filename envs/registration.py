"""The environment ids, registered with Gymnasium by `import decomplex_bt`."""

from __future__ import annotations

from gymnasium.envs.registration import WrapperSpec, register, registry

HOUSEHOLD = "decomplex_bt/Household-v0"
HOUSEHOLD_FLAT = "decomplex_bt/HouseholdFlat-v0"


def register_envs() -> None:
    """Registers every id of this package; calling it again changes nothing."""
    takes_instruction = WrapperSpec(
        name="InstructionReset", entry_point="decomplex_bt.envs.wrappers:InstructionReset", kwargs={}
    )
    for identity, entry_point, vector_entry_point in (
        (HOUSEHOLD, "household:HouseholdEnv", "vector:make_household_vector"),
        (HOUSEHOLD_FLAT, "flat:FlatHouseholdEnv", "vector:make_flat_vector"),
    ):
        if identity not in registry:
            register(
                identity,
                entry_point=f"decomplex_bt.envs.{entry_point}",
                vector_entry_point=f"decomplex_bt.envs.{vector_entry_point}",
                additional_wrappers=(takes_instruction,),
            )
