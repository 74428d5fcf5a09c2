"""The agent's tree with decorators of py_trees put around its nodes."""

from __future__ import annotations

import gymnasium as gym
import pytest
from py_trees.behaviours import StatusQueue
from py_trees.common import Status
from py_trees.decorators import Inverter, PassThrough, Retry, Timeout

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain("household")
GO = read_markup("[Go](1:motion) [to the kitchen](1:goal).", DOMAIN.ontology, flow=[1])
IF_ON = read_markup(
    "If [the tv](1:object) [is](1:check_state) [on](1:state), [go](2:motion) [to the kitchen](2:goal), "
    "otherwise [go](3:motion) [to the study](3:goal).",
    DOMAIN.ontology,
    flow=[{"if": 1, "then": [2], "else": [3]}],
)


class Busy:
    """A planner that gives up on its first problem."""

    def __init__(self):
        self._planner, self._was_asked = PyperplanPlanner(), False

    def solve(self, problem):
        was_asked, self._was_asked = self._was_asked, True
        return self._planner.solve(problem) if was_asked else PlanResult(PlanStatus.TIMEOUT, reason="busy")


def start(instruction, *, planner=None, **options):
    env = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
    observation, info = env.reset(seed=1, options={"instruction": instruction, "noise": False, **options})
    agent = decomplex_bt.TreeAgent(env, flow=instruction, planner=planner)
    agent.reset(observation, info)
    return env, agent, observation


def run(env, agent, observation):
    is_over = False
    while not is_over:
        observation, _, terminated, truncated, info = env.step(agent.act(observation))
        is_over = terminated or truncated
    return info


def test_what_would_be_tried_again_has_failed_when_the_time_is_up():
    env, agent, observation = start(GO, max_seconds=0.3)
    leaf = agent.tree.root.children[0]
    agent.tree.root.replace_child(leaf, Retry("again", leaf, 3))
    run(env, agent, observation)
    assert agent.status is Status.FAILURE
    assert [failure.observed for failure in agent.failures] == ["the time was up"]


def test_what_a_decorator_has_cut_short_was_attempted_and_what_it_stood_before_was_not():
    instruction = read_markup(
        "[Go](1:motion) [to the kitchen](1:goal), [go](2:motion) [to the study](2:goal) and "
        "[go](3:motion) [to the bathroom](3:goal).",
        DOMAIN.ontology,
        flow=[1, 2, 3],
    )
    env, agent, observation = start(instruction)
    root = agent.tree.root
    first, second, _ = root.children
    root.replace_child(first, Timeout("at once", first, 0.0))
    root.replace_child(second, Retry("again", second, 3))
    run(env, agent, observation)
    assert agent.status is Status.FAILURE
    assert [failure.task for failure in agent.not_attempted] == [2, 3]


def test_a_task_that_failed_is_tried_again():
    env, agent, observation = start(GO, planner=Busy())
    leaf = agent.tree.root.children[0]
    agent.tree.root.replace_child(leaf, Retry("again", leaf, 3))
    action = agent.act(observation)
    assert action["interact"] == 0
    assert not action["drive"].any()
    assert (agent.status, len(agent.failures)) == (Status.RUNNING, 1)
    assert run(env, agent, env.step(action)[0])["is_success"]


@pytest.mark.parametrize(
    ("decorate", "value", "branch"),
    [
        (lambda c: Inverter("not", c), "on", (1, True, "else")),
        (lambda c: Inverter("not", c), "off", (1, False, "then")),
        (lambda c: PassThrough("same", c), "on", (1, True, "then")),
        (lambda c: Retry("again", Inverter("not", c), 2), "off", (1, False, "then")),
        (lambda c: Timeout("soon", c, 0.0), "on", (1, None, "else")),
        (lambda c: StatusQueue("asked", [Status.SUCCESS], eventually=Status.SUCCESS), "off", (1, True, "then")),
    ],
)
def test_branches_tell_what_the_task_came_to_and_what_the_tree_took(decorate, value, branch):
    env, agent, observation = start(IF_ON, states={"tv": value})
    node = agent.tree.root.children[0]
    node.replace_child(node.condition, decorate(node.condition))
    assert agent.branches() == ()
    run(env, agent, observation)
    assert agent.branches() == (branch,)
