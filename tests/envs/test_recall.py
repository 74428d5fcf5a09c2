"""A judge that is recalled goes on as one that was made anew, and lets go of the episode that it was made in."""

from __future__ import annotations

import gc
import weakref

import numpy as np
import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs import recall
from decomplex_bt.envs.household import HouseholdEnv

DOMAIN = load_domain("household")
TEXT = "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) off."
ASK = read_markup(TEXT, DOMAIN.ontology, flow=[{"if": 1, "then": [2]}])


def tell(env: HouseholdEnv, seed: int) -> list[object]:
    """All that is told of an episode with somebody who does what comes to mind."""
    rng = np.random.default_rng(seed)
    _, info = env.reset(seed=seed)
    told: list[object] = [info]
    tv = env.entities.index("tv")
    for _ in range(40):
        action = {"drive": rng.uniform(-1, 1, 2), "interact": int(rng.integers(12)), "target": tv}
        _, reward, terminated, _, info = env.step(action)
        told.append((reward, terminated, info))
        if terminated:
            break
    return told


def test_a_judge_that_is_recalled_says_what_a_new_one_says():
    used = HouseholdEnv(ASK)
    for seed in range(30):
        assert tell(used, seed) == tell(HouseholdEnv(ASK), seed)
    judge = used._judge
    assert judge is not None
    assert judge._recall._count < 30, "some began alike"


def test_only_so_many_starts_are_remembered(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(recall, "MOST_STARTS", 2)
    env, other = HouseholdEnv(ASK), HouseholdEnv(ASK)
    for seed in range(20):
        assert env.reset(seed=seed)[1] == other.reset(seed=seed)[1]
    judge = env._judge
    assert judge is not None
    assert judge._recall._count <= 2


def test_what_is_remembered_holds_no_world():
    env = HouseholdEnv(ASK)
    env.reset(seed=0)
    world = weakref.ref(env.world)
    env.reset(seed=1)
    gc.collect()
    assert world() is None
