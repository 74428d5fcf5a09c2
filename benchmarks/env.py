"""What the environment costs beside the bare physics it runs, in one run and interleaved. Read the ratios.

    python benchmarks/env.py [ROUNDS]

`step`: `env.step` of a driving robot, observation and verdict included, to the ten `Space.step` calls in it. `reset`:
with the instruction known, to building the world's `Space` with everything in it. Each round measures all of them; the medians are printed.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from statistics import median
from time import perf_counter
from typing import Any

import gymnasium as gym
import numpy as np

import decomplex_bt  # noqa: F401 - registers the environments
from decomplex_bt.corpus import read_markup
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.stage import Stage
from decomplex_bt.envs.world import World

STEPS = 400
RESETS = 15


def main(rounds: int = 9) -> None:
    env = gym.make("decomplex_bt/Household-v0", instruction=_instruction()).unwrapped
    assert isinstance(env, HouseholdEnv)
    env.reset(seed=0)
    measures: dict[str, Callable[[], float]] = {
        "env.step": lambda: _steps(env),
        "ten bare steps": lambda: _bare_steps(env),
        "env.reset": lambda: _resets(env),
        "building the space": lambda: _builds(env),
    }
    times: dict[str, list[float]] = {name: [] for name in measures}
    for _ in range(rounds):
        for name, measure in measures.items():
            times[name].append(measure())
    for name, values in times.items():
        print(f"{name:20} {median(values) * 1e6:8.1f} µs")
    for over, under in (("env.step", "ten bare steps"), ("env.reset", "building the space")):
        ratio = median(a / b for a, b in zip(times[over], times[under], strict=True))
        print(f"{over} to {under}: {ratio:.2f}")


def _instruction() -> Any:
    from decomplex_bt.domain.loader import load_domain

    text = "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) off."
    return read_markup(text, load_domain("household").ontology, flow=[{"if": 1, "then": [2]}])


def _actions() -> list[dict[str, Any]]:
    drives = np.random.default_rng(0).uniform((0.2, -0.4), (1.0, 0.4), (STEPS, 2)).astype(np.float32)
    return [{"drive": drive, "interact": 0, "target": 0} for drive in drives]


def _steps(env: HouseholdEnv) -> float:
    env.reset(seed=0)
    actions = _actions()
    start = perf_counter()
    for action in actions:
        env.step(action)
    return (perf_counter() - start) / STEPS


def _bare_steps(env: HouseholdEnv) -> float:
    """The same drive, and nothing but what moves it: the velocities set and the space stepped ten times."""
    env.reset(seed=0)
    world = env.world
    drives = [action["drive"].tolist() for action in _actions()]
    step, substep = world.space.step, world.config.substep
    spent = 0.0
    for forward, turn in drives:
        world._push(forward, turn)
        start = perf_counter()
        for _ in range(world.config.substeps):
            step(substep)
        spent += perf_counter() - start
        world._read()
    return spent / STEPS


def _resets(env: HouseholdEnv) -> float:
    start = perf_counter()
    for seed in range(RESETS):
        env.reset(seed=seed)
    return (perf_counter() - start) / RESETS


def _builds(env: HouseholdEnv) -> float:
    env.reset(seed=0)
    world, fresh = env.world, World.__new__(World)
    fresh.__dict__.update(world.__dict__)
    start = perf_counter()
    for _ in range(RESETS):
        fresh._build(Stage(world.geometry))
    return (perf_counter() - start) / RESETS


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:2]))
