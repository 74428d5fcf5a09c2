"""What a running tick of the tree costs beside a step of the environment, measured in one run, interleaved.

    python benchmarks/behaviour.py [EPISODES]

Prints the median of a tick without planning, the median of env.step, their ratio, the share of ticks that plan and what
they cost. Read the ratio: the figures are the machine's.
"""

from __future__ import annotations

import json
import statistics
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import gymnasium as gym

import decomplex_bt
from decomplex_bt.corpus import Example, read_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError

SENTENCES = Path(__file__).parent / "class_sentences.yaml"


def main(episodes: int = 20) -> None:
    examples = read_corpus(SENTENCES, load_domain("household").ontology)
    ticks: list[float] = []
    plans: list[float] = []
    steps: list[float] = []
    whole_tick = whole_step = 0.0
    env = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
    for index in range(episodes):
        for tick, step, has_planned in _episode(env, examples[index % len(examples)], seed=index):
            (plans if has_planned else ticks).append(tick)
            steps.append(step)
            whole_tick += tick
            whole_step += step
    report = {
        "episodes": episodes,
        "steps": len(steps),
        "tick_us": round(statistics.median(ticks) * 1e6, 1),
        "step_us": round(statistics.median(steps) * 1e6, 1),
        "ratio": round(statistics.median(ticks) / statistics.median(steps), 3),
        "ratio_of_totals_with_planning": round(whole_tick / whole_step, 3),
        "planning_ticks": round(len(plans) / len(steps), 4),
        "planning_tick_ms": round(statistics.fmean(plans) * 1e3, 2) if plans else 0.0,
    }
    print(json.dumps(report, indent=2))


def _episode(env: gym.Env, example: Example, seed: int) -> Iterator[tuple[float, float, bool]]:
    """Seconds of each tick and of the step after it, and whether the tick planned."""
    observation, info = env.reset(seed=seed, options={"instruction": example})
    agent = decomplex_bt.TreeAgent(env, flow=example.instruction)
    try:
        agent.reset(observation, info)
    except InputError:
        return
    clock = time.perf_counter
    while True:
        plans = agent.session.plans
        start = clock()
        action = agent.act(observation)
        middle = clock()
        observation, _, terminated, truncated, _ = env.step(action)
        yield middle - start, clock() - middle, agent.session.plans != plans
        if terminated or truncated:
            return


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:]))
