"""The agent with planners that are not ours: what they give, and what they do not."""

from __future__ import annotations

from dataclasses import replace

import gymnasium as gym
import pytest
from py_trees.common import Status

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain("household")
OTHERWISE = read_markup(
    "[Turn](1:change_state) [on](1:state) [the tv](1:object); if you cannot, [go](2:motion) [to the bathroom](2:goal).",
    DOMAIN.ontology,
    flow=[{"if": 1, "else": [2]}],
)
BRING = read_markup("[Bring](1:bringing) [me](1:recipient) [the apple](1:object).", DOMAIN.ontology, flow=[1])


class Changed:
    """The default planner, its results changed; `predicate`: only those for goals that have it."""

    def __init__(self, change, predicate=""):
        self._change, self._predicate, self._planner = change, predicate, PyperplanPlanner()

    def solve(self, problem):
        result = self._planner.solve(problem)
        is_meant = any(atom.predicate.startswith(self._predicate) for atom in problem.goal)
        return self._change(result) if is_meant else result


def run(instruction, change, predicate="", **options):
    env = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
    options = {"noise": False, "broken": [], "instruction": instruction, **options}
    observation, info = env.reset(seed=0, options=options)
    agent = decomplex_bt.TreeAgent(env, flow=instruction, planner=Changed(change, predicate))
    agent.reset(observation, info)
    is_over = False
    while not is_over:
        observation, _, terminated, truncated, info = env.step(agent.act(observation))
        is_over = terminated or truncated
    return agent, info


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (PlanResult(PlanStatus.TIMEOUT, reason="slow"), "timeout: slow"),
        (PlanResult(PlanStatus.UNSUPPORTED), "unsupported"),
        (None, "unsupported: the planner gave None, no PlanResult"),
    ],
)
def test_a_planner_that_gives_up_has_not_shown_that_it_cannot_be_done(given, said):
    agent, info = run(OTHERWISE, lambda result: given, "powered-on", states={"tv": "off"})
    assert agent.status is Status.FAILURE
    assert agent.branches() == ((1, None, None),)
    assert [failure.observed for failure in agent.failures] == [f"the planner gave up on (powered-on tv): {said}"]
    assert info["violations"] == []


def test_a_planner_that_finds_that_there_is_no_plan_has():
    agent, _ = run(OTHERWISE, lambda result: PlanResult(PlanStatus.UNSOLVABLE), "powered-on", states={"tv": "off"})
    assert (agent.status, agent.branches(), agent.failures) == (Status.SUCCESS, ((1, False, "else"),), ())


def test_a_generator_of_steps_is_carried_out():
    agent, info = run(BRING, lambda result: replace(result, steps=(step for step in result.steps)))
    assert (agent.status, info["is_success"]) == (Status.SUCCESS, True)


@pytest.mark.parametrize(
    "change",
    [
        lambda result: replace(result, steps=tuple(map(str, result.steps))),
        lambda result: replace(result, steps=None),
        lambda result: replace(result, status="solved"),
        lambda result: replace(result, steps=tuple(GroundAction(s.name, s.objects[::-1]) for s in result.steps)),
    ],
)
def test_what_is_no_plan_is_a_failure_with_a_reason(change):
    agent, _ = run(BRING, change)
    assert agent.status is Status.FAILURE
    assert "unsupported: " in agent.failures[0].observed
