"""The flat environment is one that reinforcement-learning libraries take as it is; runs where one is installed."""

from __future__ import annotations

import warnings

import gymnasium as gym
import numpy as np
import pytest

import decomplex_bt  # noqa: F401 - registers the environments
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.registration import HOUSEHOLD_FLAT

pytest.importorskip("stable_baselines3", reason="stable-baselines3 is not installed")
GO = read_markup(
    "[Go](1:motion) [to the kitchen](1:goal).", load_domain("household").ontology, flow=[1]
)  # needs no language model


def make_env():
    return gym.make(HOUSEHOLD_FLAT, instruction=GO)


def test_its_checker_has_nothing_to_say():
    from stable_baselines3.common.env_checker import check_env

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(make_env().unwrapped, warn=True)


def test_ppo_learns_on_it():
    from stable_baselines3 import PPO
    from stable_baselines3.common.env_util import make_vec_env

    envs = make_vec_env(make_env, n_envs=2, seed=0)
    model = PPO("MlpPolicy", envs, n_steps=64, batch_size=32, n_epochs=2, seed=0, device="cpu")
    before = [parameter.detach().numpy().copy() for parameter in model.policy.parameters()]
    model.learn(256)
    after = [parameter.detach().numpy() for parameter in model.policy.parameters()]
    assert model.num_timesteps == 256
    assert all(np.isfinite(values).all() for values in after)
    assert any(not np.array_equal(old, new) for old, new in zip(before, after, strict=True))
    action, _ = model.predict(envs.reset())
    assert all(chosen in make_env().action_space for chosen in action)
