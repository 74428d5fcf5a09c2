"""Agents and planners of one's own in an evaluation: their rows are as those of ours."""

from __future__ import annotations

import threading
from dataclasses import replace
from functools import partial, wraps

import pytest
from joblib import parallel_config

import decomplex_bt
from decomplex_bt.corpus import parse_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.monte_carlo import AGENTS, Setup, evaluate, evaluate_agents
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain("household")
CORPUS = """
- id: go
  text: "[Go](1:motion) [to the kitchen](1:goal)."
  flow: [1]
- id: misread
  text: "[Bring](1:bringing) [me](1:recipient) [the apple](1:object=the bread)."
  flow: [1]
- id: refused
  text: "[Fetch](1:bringing) [me](1:recipient) [the griffin](1:object=the bread)."
  flow: [1]
- id: nothing
  text: "[Xyzzy](1:motion) [plugh](1:goal=the kitchen)."
  flow: [1]
"""
EXAMPLES = parse_corpus(CORPUS, DOMAIN.ontology)
GO = EXAMPLES[:1]
SETUP = Setup(max_seconds=120.0)


class GivesUp:
    """A planner that finds nothing."""

    def solve(self, problem):
        return PlanResult(PlanStatus.TIMEOUT, reason="slow")


def unaided(env):
    return decomplex_bt.TreeAgent(env, planner=PyperplanPlanner())


def handed(env, flow):
    return decomplex_bt.TreeAgent(env, flow=flow)


def with_planner(env, *, planner, flow=None):
    return decomplex_bt.TreeAgent(env, flow=flow, planner=planner)


def with_planner_or_not(env, flow=None, planner=None):
    return decomplex_bt.TreeAgent(env, flow=flow, planner=planner)


def stubborn(env, planner=PyperplanPlanner()):
    return decomplex_bt.TreeAgent(env, planner=planner)


MAKERS = {"unaided": unaided, "handed": handed, "with_planner": with_planner, "class": decomplex_bt.TreeAgent}


@pytest.fixture(scope="module")
def own_rows():
    rows = evaluate_agents(EXAMPLES, {**MAKERS, "tree": "tree"}, episodes=2, reading="own", setup=SETUP)
    return {name: [row for row in rows if row.agent == name] for name in (*MAKERS, "tree")}


def test_the_examples_are_misread_in_every_way(own_rows):
    assert {(row.example, row.reading, row.understood, row.stage) for row in own_rows["tree"]} == {
        ("go", "own", True, None),
        ("misread", "own", False, "understanding"),
        ("refused", "own", False, "understanding"),
        ("nothing", "own", False, "understanding"),
    }
    assert all(row.plans > 0 for row in own_rows["tree"] if row.example in ("go", "misread"))


@pytest.mark.parametrize("name", MAKERS)
def test_rows_of_a_tree_agent_are_those_of_the_tree_whoever_made_it(own_rows, name):
    assert [replace(row, agent="tree") for row in own_rows[name]] == own_rows["tree"]


def test_a_maker_that_takes_a_flow_is_given_the_gold_one():
    agents = {"handed": handed, "unaided": unaided, "bound": partial(decomplex_bt.TreeAgent, flow=EXAMPLES[1])}
    rows = evaluate_agents(EXAMPLES[1:2], agents, episodes=1, reading="gold", setup=SETUP)
    assert [(row.reading, row.understood) for row in rows] == [("gold", True), ("own", False), ("gold", True)]
    assert [row.outcome == "success" for row in rows] == [True, False, True]


def test_a_maker_keeps_a_flow_of_its_own():
    def bound(env, flow=EXAMPLES[1].instruction):
        return decomplex_bt.TreeAgent(env, flow=flow)

    for reading in ("own", "gold"):
        (row,) = evaluate(EXAMPLES[1:2], agent=bound, episodes=1, reading=reading, setup=SETUP)
        assert (row.outcome, row.reading, row.understood) == ("success", "gold", True)
        (row,) = evaluate(GO, agent=bound, episodes=1, reading=reading, setup=SETUP)
        assert (row.reading, row.understood) == ("own", False)


def by_position(maker):
    @wraps(maker)
    def decorated(*arguments):
        return maker(*arguments)

    return decorated


def passed_on(maker):
    @wraps(maker)
    def decorated(*arguments, **named):
        return maker(*arguments, **named)

    return decorated


@pytest.mark.parametrize(
    ("maker", "reading", "understood"),
    [
        (by_position(with_planner_or_not), "own", False),
        (passed_on(with_planner_or_not), "gold", True),
        (passed_on(handed), "gold", True),
        (partial(passed_on(handed)), "gold", True),
    ],
)
def test_a_decorated_maker_is_handed_what_its_decorator_takes(maker, reading, understood):
    (row,) = evaluate_agents(EXAMPLES[1:2], {"mine": maker}, episodes=1, reading="gold", setup=SETUP)
    assert (row.reading, row.understood) == (reading, understood)
    assert "broke off" not in (row.cause or "")


class Follower:
    """A policy that understands by itself, and tells nobody what."""

    def __init__(self, env, flow):
        self._agent, self._flow = decomplex_bt.TreeAgent(env, flow=flow), flow

    def reset(self, observation, info):
        self._agent.reset(observation, info)

    def act(self, observation):
        return self._agent.act(observation)


def reads_itself(env, flow=None):
    return Follower(env, flow or GO[0].instruction)


def test_a_maker_that_can_do_without_a_flow_is_run_where_we_cannot_read_the_text():
    instruction = GO[0].instruction
    garbled = replace(GO[0], instruction=replace(instruction, text=instruction.text + "\ud800"))
    agents = {**MAKERS, "tree": "tree", "reads_itself": reads_itself}
    *others, itself = evaluate_agents([garbled], agents, episodes=1, reading="own", setup=SETUP)
    assert {(row.outcome, row.reading, row.stage, row.understood) for row in others} == {
        ("failure", "own", "understanding", False)
    }
    assert all("half of a surrogate pair" in row.cause for row in others)
    assert (itself.outcome, itself.reading, itself.stage, itself.understood) == ("success", "own", None, None)


@pytest.mark.parametrize("given", [GivesUp(), GivesUp, lambda: GivesUp()])
def test_a_planner_is_that_of_all_that_plan(given):
    agents = {"tree": "tree", "oracle": "oracle", "with_planner": with_planner, "class": decomplex_bt.TreeAgent}
    rows = evaluate_agents(GO, agents, episodes=1, reading="gold", planner=given)
    assert [(row.stage, row.cause) for row in rows] == [
        ("planning", "task 1: the planner gave up on (in-room kitchen): timeout: slow (expected: (in-room kitchen))")
    ] * 4
    (row,) = evaluate(GO, episodes=1, reading="gold", setup=Setup(planner=given))
    assert row.stage == "planning"


def test_a_maker_keeps_a_planner_of_its_own_where_nobody_asks_for_another():
    bound = partial(decomplex_bt.TreeAgent, planner=GivesUp())
    rows = evaluate_agents(GO, {"stubborn": stubborn, "bound": bound}, episodes=1, reading="own")
    assert [row.outcome for row in rows] == ["success", "failure"]
    rows = evaluate_agents(GO, {"stubborn": stubborn, "bound": bound}, episodes=1, planner=PyperplanPlanner())
    assert [row.outcome for row in rows] == ["success", "failure"]
    (row,) = evaluate(GO, agent=stubborn, episodes=1, planner=GivesUp())
    assert row.outcome == "failure"


class Unhashable(PyperplanPlanner):
    """A planner that equals another by its values."""

    def __eq__(self, other):
        return isinstance(other, Unhashable)


def test_a_setup_can_be_hashed_whatever_its_planner():
    assert {Setup(planner=Unhashable()): "mine"}[Setup(planner=Unhashable())] == "mine"
    assert Setup(planner=Unhashable()) != Setup()


def test_the_names_of_the_environments_own_are_offered_where_agents_are_evaluated():
    assert AGENTS == ("tree", "oracle", "random", "idle")


class Numbered(PyperplanPlanner):
    """Counts how many were made in this process."""

    made = 0

    def __init__(self):
        super().__init__()
        Numbered.made += 1


def test_one_planner_is_made_for_all_episodes_of_a_process():
    Numbered.made = 0
    evaluate_agents(GO, ("tree", "oracle"), episodes=3, reading="gold", planner=Numbered)
    assert Numbered.made == 1


class OfOneThread(PyperplanPlanner):
    """A planner that does not bear to be asked by another thread than the one that made it."""

    def __init__(self):
        super().__init__()
        self.thread = threading.get_ident()

    def solve(self, problem):
        assert threading.get_ident() == self.thread
        return super().solve(problem)


def test_a_planner_is_made_for_each_thread():
    with parallel_config("threading"):
        rows = evaluate(GO, episodes=12, reading="gold", planner=OfOneThread, jobs=2)
    assert {row.outcome for row in rows} == {"success"}


def test_a_planner_goes_along_to_other_processes():
    alone = evaluate(GO, episodes=7, reading="gold", planner=PyperplanPlanner(max_evaluations=500))
    for planner in (PyperplanPlanner(max_evaluations=500), partial(PyperplanPlanner, max_evaluations=500)):
        assert evaluate(GO, episodes=7, reading="gold", planner=planner, jobs=2) == alone


class Locked(PyperplanPlanner):
    """A planner that stays where it is."""

    def __init__(self):
        super().__init__()
        self.lock = threading.Lock()


def test_what_other_processes_cannot_be_given_is_named():
    with pytest.raises(InputError, match=r"planner is .*Locked.*: cannot pickle .*; give a function of a module"):
        evaluate(GO, episodes=2, reading="gold", planner=Locked(), jobs=2)
    agents = {"mine": partial(decomplex_bt.TreeAgent, planner=Locked())}
    with pytest.raises(InputError, match=r"the agent 'mine' is .*: cannot pickle .*; give a function of a module"):
        evaluate_agents(GO, agents, episodes=2, reading="gold", jobs=2)
    assert evaluate(GO, episodes=2, reading="gold", planner=Locked)[0].outcome == "success"


@pytest.mark.parametrize("take", [lambda planner: Setup(planner=planner), partial(evaluate, GO, episodes=1)])
def test_what_is_no_planner_is_refused(take):
    with pytest.raises(InputError, match=r"planner is 'fd'; expected something with a method solve\(problem\)"):
        take(planner="fd")


def test_what_makes_no_planner_is_refused():
    with pytest.raises(InputError, match=r"made 3; expected a planner, with a method solve\(problem\)"):
        evaluate(GO, episodes=1, reading="gold", planner=lambda: 3)
