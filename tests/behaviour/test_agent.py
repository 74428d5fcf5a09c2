"""The agent in the household: it does what an annotated instruction says, and goes by nothing but what it may know."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace
from pathlib import Path

import gymnasium as gym
import numpy as np
import pytest
from py_trees.behaviours import StatusQueue
from py_trees.common import Status
from py_trees.composites import Selector

import decomplex_bt
from decomplex_bt.corpus import read_corpus, read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.errors import InputError, UnknownWordError
from decomplex_bt.instruction import Instruction
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain("household")
EXAMPLES = {e.id: e for e in read_corpus(Path(__file__).parent / "instructions.yaml", DOMAIN.ontology)}


class Sealed:
    """Lets an agent have the body and nothing else of an environment, and that only once."""

    def __init__(self, env):
        self._body = env.get_wrapper_attr("embodiment")()

    def get_wrapper_attr(self, name):
        assert name == "embodiment", f"the agent asks for {name}"
        body, self._body = self._body, None
        assert body is not None, "the agent asks for a second body"
        return lambda: body


def make_env():
    return gym.make("decomplex_bt/Household-v0", disable_env_checker=True)


def run(env, instruction, seed, *, agent=None, **options):
    """One episode; the agent, the last info and the actions."""
    observation, info = env.reset(seed=seed, options={"instruction": instruction, **options})
    agent = agent or decomplex_bt.TreeAgent(env, flow=instruction)
    agent.reset(observation, {"instruction": info["instruction"]})
    actions = []
    while True:
        actions.append(agent.act(observation))
        observation, _, terminated, truncated, info = env.step(actions[-1])
        if terminated or truncated:
            return agent, info, actions


@pytest.mark.parametrize("room", ["study", "bedroom"])
def test_somebody_is_found_where_they_are_said_to_be_and_elsewhere(room):
    text = "[Tell](1:informing) [Tom in the study](1:recipient) [that it is late](1:message)."
    instruction = read_markup(text, DOMAIN.ontology, flow=[1])
    agent, info, _ = run(make_env(), instruction, 0, noise=False, people={"tom": room})
    assert (info["is_success"], agent.status) == (True, Status.SUCCESS)
    assert agent.session.belief.prior.places["tom"][0][0] == "study_floor"


def test_before_a_reset_an_agent_has_no_status():
    agent = decomplex_bt.TreeAgent(make_env())
    assert (agent.status, agent.done) == (Status.INVALID, False)


def markup(text, flow):
    return read_markup(text, DOMAIN.ontology, flow=flow)


def assert_done(instruction, seeds):
    env = make_env()
    for seed in seeds:
        agent, info, _ = run(env, instruction, seed)
        assert info["is_success"] or not info["feasible"], (seed, [str(failure) for failure in agent.failures], info)


@pytest.mark.parametrize("name", EXAMPLES)
def test_it_does_what_is_asked_wherever_that_is_possible(name):
    assert_done(EXAMPLES[name].instruction, range(2))


@pytest.mark.slow
@pytest.mark.parametrize("name", EXAMPLES)
def test_it_does_so_in_many_worlds(name):
    assert_done(EXAMPLES[name].instruction, range(100, 130))


def test_it_knows_nothing_but_observations_and_the_instruction():
    env = make_env()
    instruction = EXAMPLES["milk-in-fridge"].instruction
    sealed = decomplex_bt.TreeAgent(Sealed(env), flow=instruction)
    _, info, actions = run(env, instruction, 3, agent=sealed)
    assert info["is_success"]
    assert len(actions) == len(run(env, instruction, 3)[2])


@pytest.mark.parametrize("name", sorted(EXAMPLES)[::4])
def test_it_ticks_as_it_does_while_every_node_is_watched(name):
    env, outcomes = make_env(), []
    for is_watched in (False, True):
        agent = decomplex_bt.TreeAgent(env, flow=EXAMPLES[name].instruction)
        shown = []
        reset, act = agent.reset, agent.act

        def note(observation, agent=agent, act=act, shown=shown):
            action = act(observation)
            shown.append([(node.name, node.status, node.feedback_message) for node in agent.tree.root.iterate()])
            return action

        def begin(observation, info, agent=agent, reset=reset, is_watched=is_watched):
            reset(observation, info)
            if is_watched:
                agent.record()

        agent.reset, agent.act = begin, note
        _, _, actions = run(env, EXAMPLES[name].instruction, 5, agent=agent)
        outcomes.append((repr(actions), shown, agent.tree.count, agent.branches()))
    assert outcomes[0] == outcomes[1]


def test_two_agents_in_one_process_share_nothing():
    instruction = EXAMPLES["heat"].instruction
    alone = [len(run(make_env(), instruction, seed)[2]) for seed in (1, 2)]
    envs = [make_env(), make_env()]
    agents, observations, counts = [], [], [0, 0]
    for env, seed in zip(envs, (1, 2), strict=True):
        observation, info = env.reset(seed=seed, options={"instruction": instruction})
        agents.append(decomplex_bt.TreeAgent(env, flow=instruction))
        agents[-1].reset(observation, info)
        observations.append(observation)
    running = {0, 1}
    while running:
        for index in sorted(running):
            observations[index], _, terminated, truncated, _ = envs[index].step(agents[index].act(observations[index]))
            counts[index] += 1
            if terminated or truncated:
                running.remove(index)
    assert counts == alone


def test_the_last_action_ends_the_episode_and_says_why():
    instruction = markup("[Turn](1:change_state) [on](1:state) [the tv](1:object).", [1])
    agent, info, actions = run(make_env(), instruction, 1, chance=False, broken=["tv"], states={"tv": "off"})
    assert not info["is_success"]
    assert agent.done
    assert agent.status == Status.FAILURE
    (failure,) = agent.failures
    assert (failure.stage, failure.task, failure.words) == ("execution", 1, (0, 4))
    assert str(failure.action) == "(switch-on tv)"
    assert "broken" in failure.reason
    assert actions[-1]["interact"] == agent.act(None)["interact"]


@pytest.mark.parametrize(
    ("flow", "later"),
    [
        ([1, 2, 3, 4], [2, 3, 4]),
        ([1, {"if": 2, "then": [3]}, 4], [2, 4]),  # whether task 3 was due nobody knows
        ([{"if": 2, "then": [4], "else": [3, 1]}], []),
        ([{"if": 2, "else": [4, 1, 3]}], [3]),
        ([2, 3, 4, 1], []),
    ],
)
def test_what_was_to_come_behind_a_failed_task_is_reported_as_not_attempted(flow, later):
    instruction = markup(
        "[Turn](1:change_state) [on](1:state) [the tv](1:object), [is](2:check_state) [the heater](2:object) "
        "[on](2:state), [turn](3:change_state) [off](3:state) [the tv](3:object), [go](4:motion) [to the "
        "hallway](4:goal).",
        flow,
    )
    states = {"tv": "off", "heater": "off"}
    agent, info, _ = run(make_env(), instruction, 1, chance=False, broken=["tv"], states=states)
    assert not info["is_success"]
    assert [failure.task for failure in agent.failures] == [1]
    assert [failure.task for failure in agent.not_attempted] == later
    for failure in agent.not_attempted:
        words = agent.instruction.tasks[failure.task - 1].span
        assert failure.to_json() == {
            "stage": "execution", "task": failure.task, "words": [words.start, words.end], "action": None,
            "reason": "not attempted", "attempts": 0,
        }  # fmt: skip


def test_a_false_condition_is_no_failure_and_the_branch_is_told():
    instruction = markup(
        "If [the tv](1:object) [is](1:check_state) [on](1:state), [go](2:motion) [to the kitchen](2:goal).",
        [{"if": 1, "then": [2]}],
    )
    agent, info, _ = run(make_env(), instruction, 1, chance=False, states={"tv": "off"})
    assert info["is_success"]
    assert agent.failures == ()
    assert info["branches"] == [{"task": 1, "truth": False, "taken": None}]


def test_a_place_named_in_a_question_that_is_not_asked_is_searched_all_the_same():
    asked = markup(
        "If [the heater](1:object) [is](1:check_state) [on](1:state) or [the remote](2:object) [is](2:check_state) "
        "[in the fridge](2:location), [fetch](3:bringing) [me](3:recipient) [the remote](3:object).",
        [{"if": 1, "then": [3], "else": [{"if": 2, "then": [{"same": [3]}]}]}],
    )
    held = {"placement": {"remote": "fridge"}, "states": {"heater": "on"}, "noise": False, "broken": []}
    agent, info, _ = run(make_env(), asked, seed=3, **held)
    assert info["is_success"], agent.failures
    assert info["branches"] == [{"task": 1, "truth": True, "taken": "then"}]


def test_an_instruction_without_a_task_or_with_an_unknown_thing_is_bad_input():
    env = make_env()
    for instruction, error in (
        (Instruction("Good morning."), InputError),
        (markup("[Bring](1:bringing) [me](1:recipient) [the unicorn](1:object).", [1]), UnknownWordError),
    ):
        agent = decomplex_bt.TreeAgent(env, flow=instruction)
        with pytest.raises(error):
            agent.reset({}, {"instruction": instruction.text})


def test_an_example_is_gone_by_as_its_instruction_is():
    env, example = make_env(), EXAMPLES["heat"]
    agent = decomplex_bt.TreeAgent(env, flow=example)
    agent.reset(*env.reset(seed=1, options={"instruction": example}))
    assert agent.instruction == example.instruction
    with pytest.raises(InputError, match="flow is a Flow; expected an annotated Instruction"):
        decomplex_bt.TreeAgent(env, flow=example.instruction.flow)


def test_what_is_no_observation_is_refused_in_words():
    env = make_env()
    agent = decomplex_bt.TreeAgent(env, flow=EXAMPLES["heat"].instruction)
    observation, info = env.reset(seed=1, options={"instruction": EXAMPLES["heat"].instruction})
    agent.reset(observation, info)
    batch = {key: np.stack([value, value]) for key, value in observation.items() if key != "instruction"}
    for wrong, says in (({}, "lacks robot, held"), (None, "NoneType"), (batch, "vector environment")):
        with pytest.raises(InputError, match=says):
            agent.act(wrong)
    assert agent.act(observation) in env.action_space
    with pytest.raises(InputError, match="no instruction"):
        decomplex_bt.TreeAgent(env).reset(observation, {})


MALFORMED = [
    ("entities", lambda table: table[:3]),
    ("entities", lambda table: table[:, :4]),
    ("entities", lambda table: table.tolist()),
    ("entities", lambda table: table + 500),
    ("entities", lambda table: table * np.nan),
    ("entities", lambda table: np.where(np.arange(table.shape[1]) == table.shape[1] - 1, np.float32(3), table)),
    ("result", lambda result: 77),
    ("result", lambda result: -2),
    ("result", lambda result: "ok"),
    ("seconds", lambda seconds: None),
    ("seconds", lambda seconds: seconds * np.nan),
    ("robot", lambda robot: robot[:2]),
    ("robot", lambda robot: robot * np.nan),
    ("held", lambda held: held + 500),
    ("held", lambda held: held - 5),
    ("held", lambda held: held[:0]),
]


@pytest.mark.parametrize(("part", "changed"), MALFORMED)
def test_an_agent_goes_on_after_a_refused_observation_as_if_it_had_not_been(part, changed):
    shown = []
    for is_disturbed in (False, True):
        env = make_env()
        observation, info = env.reset(seed=1, options={"instruction": EXAMPLES["heat"].instruction, "noise": False})
        agent = decomplex_bt.TreeAgent(env, flow=EXAMPLES["heat"])
        agent.reset(observation, info)
        actions = []
        for _ in range(12):
            if is_disturbed:
                with pytest.raises(InputError, match=rf"the observation's '{part}'"):
                    agent.act({**observation, part: changed(observation[part])})
            actions.append(agent.act(observation))
            observation, *_ = env.step(actions[-1])
        shown.append((repr(actions), agent.tree.count, agent.plans, agent.session.belief.tick))
    assert shown[0] == shown[1]


@pytest.mark.parametrize(("part", "changed"), MALFORMED)
def test_a_part_of_an_observation_that_is_none_is_named(part, changed):
    env, example = make_env(), EXAMPLES["heat"]
    agent = decomplex_bt.TreeAgent(env, flow=example)
    observation, info = env.reset(seed=1, options={"instruction": example})
    wrong = {**observation, part: changed(observation[part])}
    with pytest.raises(InputError, match=rf"the observation's '{part}' .* give what reset or step"):
        agent.reset(wrong, info)
    agent.reset(observation, info)
    agent.act(observation)
    with pytest.raises(InputError, match=rf"the observation's '{part}' .* give what reset or step"):
        agent.act(wrong)


@pytest.mark.parametrize("name", ["instruction", "grounded", "compiled", "tree", "session", "failures"])
def test_before_a_reset_there_is_nothing_to_look_at(name):
    with pytest.raises(RuntimeError, match=r"call reset\(observation, info\) first"):
        getattr(decomplex_bt.TreeAgent(make_env()), name)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, pickle.dumps])
def test_an_agent_cannot_be_copied_and_says_so(copied):
    env = make_env()
    agent = decomplex_bt.TreeAgent(env, flow=EXAMPLES["heat"])
    observation, info = env.reset(seed=1, options={"instruction": EXAMPLES["heat"]})
    agent.reset(observation, info)
    agent.act(observation)
    with pytest.raises(TypeError, match=r"cannot be copied or pickled.* TreeAgent\(env\)"):
        copied(agent)


@pytest.mark.parametrize("is_on", [False, True])
def test_what_has_a_door_runs_behind_it(is_on):
    washing = markup(
        "[Put](1:placing) [the shirt](1:object) [in the washing machine](1:goal), [start](2:change_state) "
        "[it](2:object=the washing machine) and [close](3:change_state) [it](3:object=the washing machine).",
        [1, 2, 3],
    )
    states = {"washing_machine": ["open", "on" if is_on else "off"], "shirt": "dirty"}
    env = make_env()
    _, info, _ = run(env, washing, 1, noise=False, states=states, placement={"shirt": "bed"}, broken=[])
    assert info["is_success"]
    assert info["violations"] == []
    truth = env.unwrapped.truth()
    assert (truth.state("washing_machine", "aperture"), truth.state("washing_machine", "power")) == ("closed", "on")
    assert truth.state("shirt", "cleanliness") == "clean"


@pytest.mark.parametrize(("thing", "landmark"), [("shoes", "front_door"), ("bag", "tv"), ("jacket", "bed")])
def test_what_is_put_next_to_something_lies_near_it(thing, landmark):
    said = landmark.replace("_", " ")
    put = markup(f"[Put](1:placing) [the {thing}](1:object) [next to the {said}](1:goal).", [1])
    env = make_env()
    _, info, _ = run(env, put, 1, noise=False, placement={thing: "wardrobe"})
    assert info["is_success"]
    world = env.unwrapped.world
    row = world.geometry.row[thing]
    assert world.geometry.distance(*world.position[row], world.geometry.row[landmark]) < 1.2


@pytest.mark.parametrize("light", ["kitchen light", "bathroom light"])
def test_what_holds_nothing_has_nothing_and_the_judge_knows_it(light):
    look = markup(
        f"[Look](1:searching) [in the {light}](1:location) [for the phone](1:object). If [it](2:object=the phone) "
        f"[is](2:check_state) [there](2:location=in the {light}), [close](3:change_state) [the fridge](3:object).",
        [{"if": [1, 2], "then": [3]}],
    )
    agent, info, _ = run(make_env(), look, 1, noise=False)
    assert info["is_success"]
    assert info["branches"] == [{"task": 1, "truth": False, "taken": None}]
    assert agent.failures == ()


def test_an_environment_without_a_body_is_refused_in_words():
    with pytest.raises(InputError, match=r"CartPole-v1 has no embodiment\(\).* decomplex_bt/Household-v0"):
        decomplex_bt.TreeAgent(gym.make("CartPole-v1"))
    with pytest.raises(InputError, match="object has no embodiment"):
        decomplex_bt.TreeAgent(object())


def test_an_agent_that_refuses_an_instruction_stays_as_it_was():
    env = make_env()
    observation, info = env.reset(seed=0, options={"instruction": "Close the fridge."})
    agent = decomplex_bt.TreeAgent(env)
    agent.reset(observation, info)
    with pytest.raises(UnknownWordError):
        agent.reset(observation, {"instruction": "Bring me the unicorn."})
    assert agent.instruction.text == agent.grounded.text == "Close the fridge."


def test_a_recorder_writes_down_what_changes():
    env = make_env()
    instruction = EXAMPLES["go"].instruction
    observation, info = env.reset(seed=1, options={"instruction": instruction})
    agent = decomplex_bt.TreeAgent(env, flow=instruction)
    agent.reset(observation, info)
    recorder = agent.record()
    for _ in range(30):
        observation, *_ = env.step(agent.act(observation))
    assert recorder.entries[0]["node"] == "0"
    assert recorder.entries[0]["event"] == "started"
    assert recorder.entries[0]["feedback"].startswith("(move ")
    assert len(recorder.entries) < 15


def test_a_guard_put_above_a_running_tree_is_ticked():
    env = make_env()
    instruction = markup("[Go](1:motion) [to the study](1:goal).", [1])
    observation, info = env.reset(seed=0, options={"instruction": instruction})
    agent = decomplex_bt.TreeAgent(env, flow=instruction)
    agent.reset(observation, info)
    for _ in range(5):
        observation, *_ = env.step(agent.act(observation))
    guard = StatusQueue("guard", [Status.FAILURE], eventually=Status.FAILURE)
    agent.tree.root = Selector("safe", memory=False, children=[guard, agent.tree.root])
    for _ in range(5):
        observation, *_ = env.step(agent.act(observation))
        assert guard.status is Status.FAILURE
        assert agent.status is Status.RUNNING


def test_an_agent_whose_episode_has_ended_begins_nothing_anew():
    env = make_env()
    instruction = markup("[Say](1:informing) [hello](1:message) [to me](1:recipient).", [1])
    agent, _, actions = run(env, instruction, 1)
    assert agent.done
    status = agent.status
    again = agent.act(None)
    assert again["interact"] == Interaction.FINISH
    assert agent.status is status
    assert actions


def test_a_refused_observation_leaves_the_agent_as_it_was():
    env = make_env()
    first = markup("[Go](1:motion) [to the study](1:goal).", [1])
    observation, info = env.reset(seed=0, options={"instruction": first})
    agent = decomplex_bt.TreeAgent(env, flow=first)
    agent.reset(observation, info)
    compiled, instruction = agent.compiled, agent.instruction
    with pytest.raises(InputError):
        agent.reset({"x": 1}, info)
    assert agent.compiled is compiled
    assert agent.instruction is instruction


@pytest.mark.parametrize(
    "odd", [{"threshold": 7}, {"threshold": "x"}, {"threshold": float("nan")}, {"planner": "fd"}, {"ask": 5}]
)
def test_what_no_agent_can_use_is_refused_at_once(odd):
    with pytest.raises(InputError, match=next(iter(odd))):
        decomplex_bt.TreeAgent(make_env(), **odd)


def test_before_a_reset_there_are_neither_failures_nor_branches():
    agent = decomplex_bt.TreeAgent(make_env())
    for ask in (lambda: agent.failures, lambda: agent.not_attempted, agent.branches):
        with pytest.raises(RuntimeError, match="reset"):
            ask()


class Shouting:
    """A planner that names its actions as other planners do."""

    def solve(self, problem):
        result = PyperplanPlanner().solve(problem)
        return replace(result, steps=tuple(replace(step, name=step.name.upper()) for step in result.steps))


def test_actions_that_the_domain_lacks_are_a_failure_with_a_reason():
    env = make_env()
    instruction = markup("[Go](1:motion) [to the study](1:goal).", [1])
    agent = decomplex_bt.TreeAgent(env, flow=instruction, planner=Shouting())
    agent, _, _ = run(env, instruction, 0, agent=agent)
    assert "no action of this domain" in str(agent.failures[0])
