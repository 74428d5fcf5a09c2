from __future__ import annotations

import ast
from dataclasses import replace
from functools import partial
from pathlib import Path

import gymnasium as gym
import pytest
from joblib import parallel_config

import decomplex_bt.evaluation
from decomplex_bt.corpus import parse_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.blame import blame_run
from decomplex_bt.evaluation.monte_carlo import Setup, evaluate, evaluate_agents, plan_episodes, run_episode
from decomplex_bt.evaluation.summary import summarise
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain("household")
CORPUS = """
- id: light
  text: >-
    If [the kitchen light](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state)
    [it](2:object=the kitchen light) [off](2:state).
  flow: [{if: 1, then: [2]}]
- id: tea
  text: "[Tell](1:informing) [Anna](1:recipient) [that tea is ready](1:message)."
  flow: [1]
- id: dragon
  text: "[Feed](1:bringing) [the dragon](1:recipient) [a pen](1:object)."
  flow: [1]
"""
EXAMPLES = parse_corpus(CORPUS, DOMAIN.ontology)
SETUP = Setup(max_seconds=120.0)


@pytest.fixture(scope="module")
def rows():
    return evaluate(EXAMPLES, episodes=6, seed=3, reading="gold", setup=SETUP)


def test_every_episode_gives_a_row_in_the_order_planned(rows):
    assert [(row.example, row.seed) for row in rows] == [(e.id, 3 + k) for e in EXAMPLES for k in range(6)]
    assert {row.outcome for row in rows if row.example == "light"} == {"success"}
    assert {row.outcome for row in rows if row.example == "dragon"} == {"ungroundable"}
    assert all("dragon" in row.cause for row in rows if row.example == "dragon")


def test_a_row_says_whether_anything_was_left_to_do():
    turn_on = "- {id: tv, text: '[Turn](1:change_state) [the tv](1:object) [on](1:state).', flow: [1]}"
    rows = evaluate(parse_corpus(turn_on, DOMAIN.ontology), episodes=8, reading="gold", setup=SETUP)
    assert {row.met_at_start for row in rows} == {True, False}
    assert all(row.met_at_start == (row.steps == 1) for row in rows)
    assert all(row.spl == 1.0 and row.shortest_length == 0.0 for row in rows if row.met_at_start)


def test_a_row_says_how_short_the_way_was(rows):
    for row in rows:
        if row.outcome != "success":
            assert row.shortest_length is None
            assert row.spl == (0.0 if row.outcome == "failure" else None)
            continue
        assert row.shortest_length is not None
        assert row.shortest_length <= row.path_length
        driven = max(row.path_length, row.shortest_length)
        assert row.spl == pytest.approx(row.shortest_length / driven if driven else 1.0, abs=1e-2)
    assert any(0 < row.spl < 1 for row in rows if row.outcome == "success")


def test_infeasible_episodes_name_their_cause(rows):
    tea = {row.seed: row for row in evaluate([EXAMPLES[1]], episodes=20, agent="idle", setup=SETUP)}
    infeasible = [row for row in tea.values() if row.outcome == "infeasible"]
    assert 0 < len(infeasible) < 12
    assert {(row.stage, row.cause) for row in infeasible} == {("infeasible", "task 1: anna is out")}


def test_rows_are_the_same_for_any_number_of_jobs(rows):
    assert evaluate(EXAMPLES, episodes=6, seed=3, reading="gold", setup=SETUP, jobs=2) == rows


def test_rows_are_the_same_where_the_workers_are_threads(rows):
    with parallel_config("threading"):
        assert evaluate(EXAMPLES, episodes=6, seed=3, reading="gold", setup=SETUP, jobs=3) == rows


def test_progress_is_told_after_every_episode():
    told = []
    evaluate(
        EXAMPLES[:1], episodes=3, agent="idle", setup=SETUP, progress=lambda done, total: told.append((done, total))
    )
    assert told == [(1, 3), (2, 3), (3, 3)]


def test_several_agents_meet_the_same_worlds():
    rows = evaluate_agents(EXAMPLES[:2], ("tree", "idle"), episodes=4, reading="gold", setup=SETUP)
    tree, idle = ([row for row in rows if row.agent == agent] for agent in ("tree", "idle"))
    assert [(row.example, row.seed) for row in tree] == [(row.example, row.seed) for row in idle]
    assert [row.outcome == "infeasible" for row in tree] == [row.outcome == "infeasible" for row in idle]


def episode(**changes):
    (planned,) = plan_episodes(EXAMPLES[:1], episodes=1, seed=0, agent="tree", domain=DOMAIN, reading="gold")
    return replace(planned, source="own", **changes)


def test_a_wrong_reading_is_a_failure_of_understanding():
    negated = parse_corpus(CORPUS.replace("{if: 1, then: [2]}", "{if: 1, else: [2]}"), DOMAIN.ontology)[0]
    outcomes = [run_episode(episode(reading=negated.instruction, seed=seed), SETUP) for seed in range(4)]
    failed = [row for row in outcomes if row.outcome == "failure"]
    assert failed
    assert {row.stage for row in failed} == {"understanding"}
    assert "flow: [{'if': 1, 'else': [2]}] instead of" in failed[0].cause
    assert {row.understood for row in outcomes} == {False}
    assert summarise(outcomes)[0].lucky == sum(row.outcome == "success" for row in outcomes)


def test_a_reading_that_does_not_ground_where_the_gold_one_does_is_one_too():
    wrong = parse_corpus(CORPUS.replace("(1:object)", "(1:object=the dragon)"), DOMAIN.ontology)[0]
    assert run_episode(episode(reading=wrong.instruction), SETUP).stage == "understanding"


def test_readings_are_compared_in_the_house_of_the_episode():
    corpus = "- {id: a, text: '[Look](1:searching) [for five armchairs](1:object%s) now.', flow: [1]}"
    gold, wrong = (parse_corpus(corpus % referent, DOMAIN.ontology)[0] for referent in ("", "=the bed"))
    with pytest.raises(InputError, match="only one in this house"):
        ground(gold.instruction, DOMAIN)
    large = replace(SETUP, env_id="decomplex_bt/HouseholdLarge-v0", max_seconds=1.0)
    row = run_episode(episode(gold=gold.instruction, reading=wrong.instruction), large)
    assert (row.outcome, row.stage, row.understood) == ("failure", "understanding", False)


def test_a_text_that_could_not_be_read_is_one_too():
    row = run_episode(episode(reading=None, problem="too long"), SETUP)
    assert (row.outcome, row.stage, row.cause) == ("failure", "understanding", "too long")


def test_a_gold_reading_that_fails_is_blamed_on_the_run():
    failures = [{"stage": "planning", "task": 2, "reason": "no way"}]
    assert blame_run(failures, [], is_truncated=False) == ("planning", "task 2: no way")
    assert blame_run(failures, ["task 3 was brought about"], is_truncated=False)[0] == "execution"
    assert blame_run([], [], is_truncated=True) == ("execution", "the time was up")


def test_an_episode_that_breaks_off_is_a_row(monkeypatch):
    from decomplex_bt.behaviour.agent import TreeAgent

    def burst(self, observation):
        raise RuntimeError("burst")

    monkeypatch.setattr(TreeAgent, "act", burst)
    row = run_episode(episode(), SETUP)
    assert (row.outcome, row.stage) == ("failure", "execution")
    assert "RuntimeError: burst" in row.cause


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"agent": "clever"}, "no agent 'clever'; known: tree, oracle"),
        ({"episodes": 0}, "episodes is 0"),
        ({"seed": -1}, "seed is -1"),
        ({"reading": "both"}, "reading is 'both'; expected 'own' or 'gold'"),
        ({"examples": ()}, "holds no example"),
        ({"episodes": "x"}, "episodes is 'x'; expected at least one world"),
        ({"episodes": 1.5}, r"episodes is 1\.5"),
        ({"seed": None}, "seed is None; expected a whole number from 0"),
        ({"seed": 1.5}, r"seed is 1\.5"),
        ({"jobs": "x"}, "jobs is 'x'; expected at least one process"),
        ({"jobs": 1.5}, r"jobs is 1\.5"),
        ({"setup": "x"}, "setup is 'x'; expected a Setup"),
        (
            {"examples": [example.instruction for example in EXAMPLES]},
            r"holds a value of type Instruction.*Example\(id, instruction",
        ),
        ({"examples": "corpus.yaml"}, "examples is a str; expected corpus Examples"),
    ],
)
def test_bad_options_are_named(arguments, message):
    with pytest.raises(InputError, match=message):
        evaluate(**{"examples": EXAMPLES, "episodes": 1, "reading": "gold", **arguments})


def test_environments_are_reached_through_gymnasium_alone():
    folder = Path(decomplex_bt.evaluation.__file__).parent
    for path in folder.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            assert not any(name.startswith("decomplex_bt.envs") for name in names), path.name


OUT_OF_RANGE = [("grasp_slip", 3.0), ("missed_detection", float("nan")), ("meddling", -1)]


@pytest.mark.parametrize(("option", "value"), OUT_OF_RANGE)
def test_a_setup_refuses_what_no_reset_would_take(option: str, value: float):
    with pytest.raises(InputError, match=f"{option} is {value}; expected a number from 0 to"):
        Setup(**{option: value})


@pytest.mark.parametrize("noise", [0, "no", None])
def test_a_setup_has_noise_or_has_not(noise):
    with pytest.raises(InputError, match=r"noise is .* expected True or False"):
        Setup(noise=noise)


def burst(domain):
    raise RuntimeError("the house burnt down")


gym.register("tests/Burst-v0", entry_point=burst)
gym.register("tests/NoPolicy-v0", entry_point=lambda domain: gym.Env(), disable_env_checker=True)


@pytest.mark.parametrize(
    ("env_id", "message"),
    [
        ("decomplex_bt/Hosehold-v0", "no environment can be made: .*Did you mean: `Household`"),
        ("nowhere", "no environment can be made: .*expected an id like 'decomplex_bt/Household-v0'"),
        ("CartPole-v1", "no environment can be made: .*'domain'"),
        ("no_such_module:House-v0", "no environment can be made: No module named"),
        ("tests/Burst-v0", "no environment can be made: the house burnt down"),
        ("tests/NoPolicy-v0", "offers no policies"),
        ("decomplex_bt/HouseholdFlat-v0", "whose agent 'tree' cannot be had: .*make Household-v0"),
    ],
)
def test_an_environment_that_will_not_do_is_refused_before_any_episode(env_id, message):
    begun = []

    def mine(env):
        begun.append(env)
        return Finisher(env)

    with pytest.raises(InputError, match=f"^env_id is '{env_id}', .*{message}") as refused:
        evaluate_agents(EXAMPLES, (mine, "tree"), episodes=2, reading="gold", setup=replace(SETUP, env_id=env_id))
    assert "\n" not in str(refused.value)
    assert not begun


def test_a_setup_has_a_domain_and_an_environment():
    with pytest.raises(InputError, match="domain is 3; expected the name of a shipped one or a folder"):
        Setup(domain=3)
    with pytest.raises(InputError, match=r"env_id is 3; expected .*, as in 'decomplex_bt/Household-v0'"):
        Setup(env_id=3)
    with pytest.raises(InputError, match="domain is Domain") as refused:
        Setup(domain=DOMAIN)
    assert len(str(refused.value)) < 250, "not the whole of it"


def test_agents_are_named_once_each():
    with pytest.raises(InputError, match="named twice"):
        evaluate_agents(EXAMPLES, ("idle", "idle"), episodes=1, reading="gold")
    with pytest.raises(InputError, match="expected a sequence of names"):
        evaluate_agents(EXAMPLES, "tree", episodes=1, reading="gold")


class Finisher:
    """A policy of one's own, with no more than it must have."""

    def __init__(self, env):
        self._finish = env.get_wrapper_attr("embodiment")().finish

    def reset(self, observation, info):
        assert "instruction" in info

    def act(self, observation):
        return self._finish()


def test_a_policy_of_ones_own_is_evaluated_as_the_others_are():
    for jobs in (1, 2):
        rows = evaluate_agents(EXAMPLES[:1], (Finisher, "idle"), episodes=3, reading="gold", jobs=jobs)
        own, idle = rows[:3], rows[3:]
        assert {row.agent for row in own} == {"Finisher"}
        assert [row.outcome for row in own] == [row.outcome for row in idle]
    with pytest.raises(InputError, match="a function that makes one"):
        evaluate(EXAMPLES, agent="clever", episodes=1, reading="gold")


class Broken(Finisher):
    """A policy that breaks off in the hook of this name."""

    def __init__(self, env, hook):
        super().__init__(env)
        self._hook = hook
        self._burst_in("init")

    def reset(self, observation, info):
        self._burst_in("reset")

    def act(self, observation):
        self._burst_in("act")

    def _burst_in(self, hook):
        if hook == self._hook:
            raise RuntimeError(f"burst in {hook}")


def test_a_policy_of_ones_own_that_breaks_off_anywhere_is_a_row():
    agents = {hook: partial(Broken, hook=hook) for hook in ("init", "reset", "act")}
    rows = evaluate_agents(EXAMPLES[:1], {**agents, "well": Finisher}, episodes=1, reading="gold", setup=SETUP)
    assert [row.agent for row in rows] == ["init", "reset", "act", "well"]
    for hook, row in zip(agents, rows, strict=False):
        assert (row.outcome, row.stage) == ("failure", "execution")
        assert row.cause == f"broke off: RuntimeError: burst in {hook}"


def tree(env):
    return Finisher(env)


@pytest.mark.parametrize(
    ("agents", "message"),
    [
        ((partial(Broken, hook="a"), partial(Broken, hook="b")), "'partial' is named twice; .* in a mapping"),
        ((tree,), r"'tree' names an agent that is .*; give yours another, as in \{'mine'"),
        ({"oracle": Finisher}, "'oracle' names an agent that is"),
        ({"mine": "tree"}, "'mine' names an agent that is 'tree'"),
        ({3: Finisher}, "an agent is named 3; expected a text"),
        (3, "agents is 3; expected a sequence of names"),
    ],
)
def test_no_two_agents_share_a_name(agents, message):
    with pytest.raises(InputError, match=message):
        evaluate_agents(EXAMPLES[:1], agents, episodes=1, reading="gold", setup=SETUP)


def test_no_processes_are_refused_at_once():
    with pytest.raises(InputError, match="jobs is 0; expected at least one"):
        evaluate((), jobs=0)
