"""What the environment costs beside the bare physics it runs, in one run and interleaved. Read the ratios.

    python benchmarks/env.py [ROUNDS] [PYTHON]

`step`: `env.step` of a driving robot, observation and verdict included, to the ten `Space.step` calls in it, each round
in another world. `reset`: with the instruction known, on seeds not used before, to building a `Space` with everything
in it anew by pymunk's own calls. Each round measures all of them; the medians are printed, with what importing and
making an environment costs beside importing what it stands on, and memory.

Steps a second, beside those of Gymnasium's CartPole (and of BabyAI's BossLevel and of PushT, where minigrid and
gym-pusht are installed), are of environments as `gym.make` makes them, resets not counted, and are given twice: with
random actions, of ours all but `FINISH`, and with one action (PushT: one goal; ours: random driving).

`PYTHON`: the interpreter of an environment with gym-pusht, which wants a pymunk older than ours.
"""

from __future__ import annotations

import gc
import resource
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from importlib.util import find_spec
from itertools import count, cycle
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import Any

import gymnasium as gym
import numpy as np
import pymunk

import decomplex_bt  # noqa: F401 - registers the environments
from decomplex_bt.corpus import read_markup
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.interface import Interaction

Sampler = Callable[[], Any]
OURS = "Household-v0"
STEPS = 400
RESETS = 15
SEEDS = count()
FILLS = 4
WARM_UP = 1000
"""Resets before anything is measured, as in any training: what is remembered of a house is there by then."""
PUSHT = f"""
import sys
from time import perf_counter
import gymnasium, gym_pusht, numpy
peer = gymnasium.make("gym_pusht/PushT-v0", obs_type="state")
peer.action_space.seed(0)
def steps(act):
    peer.reset(seed=0)
    spent = 0.0
    for _ in range({STEPS}):
        action = act()
        start = perf_counter()
        _, _, terminated, truncated, _ = peer.step(action)
        spent += perf_counter() - start
        if terminated or truncated:
            peer.reset()
    return spent / {STEPS}
goal = numpy.array([256.0, 256.0], dtype=numpy.float32)
for _ in sys.stdin:
    print(steps(peer.action_space.sample), steps(lambda: goal), flush=True)
"""
"""PushT's seconds a step, as `_seconds_a_step` counts them, in an interpreter of its own; once for each line it is
given."""


def main(rounds: int = 9, other_python: str = sys.executable) -> None:
    env = gym.make("decomplex_bt/Household-v0", instruction=_instruction()).unwrapped
    assert isinstance(env, HouseholdEnv)
    for _ in range(WARM_UP):
        env.reset(seed=next(SEEDS))
    measures: dict[str, Callable[[int], float]] = {
        "env.step": lambda world: _steps(env, world),
        "ten bare steps": lambda world: _bare_steps(env, world),
        "env.reset": lambda world: _resets(env),
        "building the space": lambda world: _builds(env, world),
    }
    times: dict[str, list[float]] = {name: [] for name in measures}
    for world in range(rounds):
        for name, measure in measures.items():
            times[name].append(measure(world))
    for name, values in times.items():
        print(f"{name:20} {median(values) * 1e6:8.1f} µs")
    rates = _peers(other_python)
    print(f"{'steps a second':20} {'random':>8} {'one action':>10}")
    for name, steps in rates.items():
        ratios = "  ours to these: {:.1f} {:.1f}".format(
            *(ours / s for ours, s in zip(rates[OURS], steps, strict=True))
        )
        print(f"{name:20} {steps[0]:8.0f} {steps[1]:10.0f}{'' if name == OURS else ratios}")
    for over, under in (("env.step", "ten bare steps"), ("env.reset", "building the space")):
        ratio = median(a / b for a, b in zip(times[over], times[under], strict=True))
        print(f"{over} to {under}: {ratio:.2f}")
    made, read = _imports()
    print(f"importing and making to importing the stack: {made:.2f}; with the house read: {read:.2f}")
    megabytes, objects = _memory(env)
    print(f"memory: {megabytes:.2f} MB for an environment more; {objects} objects gained over {FILLS},000 resets")


def _peers(other_python: str) -> dict[str, tuple[float, ...]]:
    """Steps a second of each environment, ours first, with random actions and with one; resets are not counted."""
    ours = gym.make("decomplex_bt/Household-v0", instruction=_instruction())
    sides: dict[str, tuple[gym.Env[Any, Any], Sampler, Sampler]] = {
        OURS: (ours, _act_at_random(ours), _drive_at_random())
    }
    identities = {"CartPole-v1": "CartPole-v1"}
    if find_spec("minigrid") is not None:
        import_module("minigrid")
        identities["BabyAI BossLevel"] = "BabyAI-BossLevel-v0"
    for name, identity in identities.items():
        peer = gym.make(identity)
        peer.action_space.seed(0)
        sides[name] = (peer, peer.action_space.sample, lambda: 0)
    spent: dict[str, tuple[list[float], ...]] = {name: ([], []) for name in (*sides, "PushT")}
    command = [other_python, "-c", PUSHT]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    with subprocess.Popen(command, text=True, **pipes) as pusht:
        assert pusht.stdin is not None
        assert pusht.stdout is not None
        for is_counted in (False, *[True] * 9):  # the first round is for whoever is still starting up
            seconds = {name: [_seconds_a_step(env, sample) for sample in both] for name, (env, *both) in sides.items()}
            with suppress(BrokenPipeError):  # that interpreter lacks it
                print(file=pusht.stdin, flush=True)
            seconds["PushT"] = [float(figure) for figure in pusht.stdout.readline().split()]
            for name, both in seconds.items() if is_counted else ():
                for times, figure in zip(spent[name], both, strict=False):
                    times.append(figure)
        with suppress(BrokenPipeError):
            pusht.stdin.close()
    return {name: tuple(1 / median(times) for times in both) for name, both in spent.items() if both[0]}


def _act_at_random(env: gym.Env[Any, Any]) -> Sampler:
    """Draws from the action space all but the action that ends the episode."""
    env.action_space.seed(0)

    def sample() -> Any:
        action = env.action_space.sample()
        return sample() if action["interact"] == Interaction.FINISH else action

    return sample


def _drive_at_random() -> Sampler:
    return cycle(_actions()).__next__


def _seconds_a_step(env: gym.Env[Any, Any], sample: Sampler) -> float:
    env.reset(seed=0)
    spent = 0.0
    for _ in range(STEPS):
        action = sample()
        start = perf_counter()
        _, _, terminated, truncated, _ = env.step(action)
        spent += perf_counter() - start
        if terminated or truncated:
            env.reset()
    return spent / STEPS


def _imports() -> tuple[float, float]:
    """What importing this package and making an environment costs, as a multiple of importing what it stands on.

    The second figure is with the house, which is read when it is first asked for.
    """
    base = "import gymnasium, pymunk, py_trees, pyperplan"
    ours = "import gymnasium, decomplex_bt; env = gymnasium.make('decomplex_bt/Household-v0')"
    house = f"{ours}; env.observation_space"
    times: dict[str, list[float]] = {base: [], ours: [], house: []}
    for _ in range(5):
        for code, spent in times.items():
            start = perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            spent.append(perf_counter() - start)
    return min(times[ours]) / min(times[base]), min(times[house]) / min(times[base])


def _memory(env: HouseholdEnv) -> tuple[float, int]:
    """Megabytes that an environment takes besides the first, and objects gained over `FILLS` thousand resets.

    What is remembered of a house fills up to its bound and begins again, so that the count goes up and down; a leak
    lifts its lowest points.
    """
    resident = Path("/proc/self/statm")
    pages = [0, 0]
    others: list[HouseholdEnv] = []
    for index in (0, 1):
        gc.collect()
        pages[index] = int(resident.read_text().split()[1]) if resident.exists() else 0
        if index == 0:
            others = [HouseholdEnv(_instruction()) for _ in range(20)]
            for other in others:
                other.reset(seed=0)
    counts = []
    for _ in range(2 * FILLS):
        for _ in range(1000):
            env.reset(seed=next(SEEDS))
        gc.collect()
        counts.append(len(gc.get_objects()))
    return (pages[1] - pages[0]) * resource.getpagesize() / 1e6 / len(others), max(
        0, min(counts[FILLS:]) - min(counts[:FILLS])
    )


def _instruction() -> Any:
    from decomplex_bt.domain.loader import load_domain

    text = "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) off."
    return read_markup(text, load_domain("household").ontology, flow=[{"if": 1, "then": [2]}])


def _actions() -> list[dict[str, Any]]:
    drives = np.random.default_rng(0).uniform((0.2, -0.4), (1.0, 0.4), (STEPS, 2)).astype(np.float32)
    return [{"drive": drive, "interact": 0, "target": 0} for drive in drives]


def _steps(env: HouseholdEnv, world: int) -> float:
    env.reset(seed=world)
    actions = _actions()
    start = perf_counter()
    for action in actions:
        if env.step(action)[2]:  # what is asked may come true by chance
            break
    return (perf_counter() - start) / env.world.steps


def _bare_steps(env: HouseholdEnv, seed: int) -> float:
    """The same drive, and nothing but what moves it: the velocities set and the space stepped ten times."""
    env.reset(seed=seed)
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
    seeds = [next(SEEDS) for _ in range(RESETS)]  # each once: starts that are remembered must not flatter
    start = perf_counter()
    for seed in seeds:
        env.reset(seed=seed)
    return (perf_counter() - start) / RESETS


def _builds(env: HouseholdEnv, world: int) -> float:
    """All that is in the space of an episode made anew, by pymunk's own calls and nothing else."""
    env.reset(seed=world)
    space = env.world.space
    bodies = [_body_of(body) for body in space.bodies]
    row = {body: index for index, body in enumerate(space.bodies)}
    shapes = [(*_shape_of(shape), row[shape.body], shape.friction, shape.filter) for shape in space.shapes]
    joints = [(*_joint_of(joint), row[joint.a], row[joint.b], joint.max_force) for joint in space.constraints]
    start = perf_counter()
    for _ in range(RESETS):
        fresh = pymunk.Space()
        fresh.sleep_time_threshold = space.sleep_time_threshold
        fresh.idle_speed_threshold = space.idle_speed_threshold
        fresh.collision_slop = space.collision_slop
        made: list[pymunk.Body] = []
        for arguments, position, angle in bodies:
            made.append(pymunk.Body(*arguments))
            if position is not None:
                made[-1].position, made[-1].angle = position, angle
        parts: list[pymunk.Shape | pymunk.Constraint] = []
        for kind, arguments, index, friction, category in shapes:
            shape = kind(made[index], *arguments)
            if friction:
                shape.friction, shape.filter = friction, category
            parts.append(shape)
        for kind, arguments, one, other, force in joints:
            joint = kind(made[one], made[other], *arguments)
            joint.max_bias, joint.max_force = 0, force
            parts.append(joint)
        fresh.add(*made, *parts)
    return (perf_counter() - start) / RESETS


def _body_of(body: pymunk.Body) -> tuple[tuple[Any, ...], tuple[float, float] | None, float]:
    if body.body_type == pymunk.Body.STATIC:
        return (0, 0, pymunk.Body.STATIC), None, 0.0
    return (body.mass, body.moment), tuple(body.position), body.angle


def _shape_of(shape: pymunk.Shape) -> tuple[type[pymunk.Shape], tuple[Any, ...]]:
    if isinstance(shape, pymunk.Circle):
        return pymunk.Circle, (shape.radius, tuple(shape.offset))
    if isinstance(shape, pymunk.Segment):
        return pymunk.Segment, (tuple(shape.a), tuple(shape.b), shape.radius)
    assert isinstance(shape, pymunk.Poly)
    return pymunk.Poly, ([tuple(corner) for corner in shape.get_vertices()],)


def _joint_of(joint: pymunk.Constraint) -> tuple[type[pymunk.Constraint], tuple[Any, ...]]:
    if isinstance(joint, pymunk.PivotJoint):
        return pymunk.PivotJoint, (joint.anchor_a, joint.anchor_b)
    assert isinstance(joint, pymunk.GearJoint)
    return pymunk.GearJoint, (joint.phase, joint.ratio)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:2]), *sys.argv[2:3])
