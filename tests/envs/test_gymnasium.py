"""Every id keeps the Gymnasium contract through vectors, wrappers, specs and pickles, and keeps its instruction."""

from __future__ import annotations

import copy
import json
import pickle
import warnings

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env, data_equivalence
from gymnasium.vector import AutoresetMode
from py_trees.blackboard import Blackboard

import decomplex_bt
from decomplex_bt.corpus import Example, read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.config import HouseholdConfig, WorldConfig
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.registration import HOUSEHOLD, HOUSEHOLD_FLAT, HOUSEHOLD_SMALL
from decomplex_bt.errors import InputError, MissingArgumentError

IDS = [identity for identity in gym.registry if identity.startswith("decomplex_bt/")]
ONTOLOGY = load_domain("household").ontology
GO = read_markup("[Go](1:motion) [to the kitchen](1:goal).", ONTOLOGY, flow=[1])
TELL = read_markup("[Tell](1:informing) [me](1:recipient) [hello](1:message).", ONTOLOGY, flow=[1])
ASK = read_markup(
    "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) off.",
    ONTOLOGY,
    flow=[{"if": 1, "then": [2]}],
)
FINISH = {
    "drive": np.zeros((2, 2), dtype=np.float32),
    "interact": np.full(2, int(Interaction.FINISH)),
    "target": np.zeros(2, dtype=np.int64),
}
MODES = {
    "sync": {"vectorization_mode": "sync"},
    "async shared": {"vectorization_mode": "async", "vector_kwargs": {"shared_memory": True}},
    "async piped": {"vectorization_mode": "async", "vector_kwargs": {"shared_memory": False}},
}


def sample(env):
    """Any action but the last one."""
    action = env.action_space.sample()
    action["interact" if isinstance(action, dict) else 2] %= int(Interaction.FINISH)
    return action


def text_of(codes):
    return bytes(codes).rstrip(b"\0").decode("latin-1")


@pytest.fixture
def no_warnings():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


@pytest.mark.parametrize(
    ("identity", "render_mode"), [*((identity, None) for identity in IDS), (HOUSEHOLD, "rgb_array")]
)
def test_the_checker_has_nothing_to_say(identity, render_mode, no_warnings):
    env = gym.make(identity, render_mode=render_mode)
    check_env(env.unwrapped, skip_render_check=render_mode is None)
    env.close()
    env.close()


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("identity", [HOUSEHOLD, HOUSEHOLD_SMALL])
def test_vectors_hold_what_single_environments_hold(identity, mode, no_warnings):
    envs = gym.make_vec(identity, num_envs=2, instruction=TELL, **MODES[mode])
    singles = [gym.make(identity, instruction=TELL) for _ in range(2)]
    try:
        many, info = envs.reset(seed=5)
        ones = [env.reset(seed=5 + index)[0] for index, env in enumerate(singles)]
        envs.action_space.seed(0)
        for _ in range(3):
            for index, one in enumerate(ones):
                for key in ("robot", "entities", "held", "seconds", "instruction_codes"):
                    assert np.array_equal(many[key][index], one[key])
            assert [text_of(codes) for codes in many["instruction_codes"]] == [TELL.text] * 2
            actions = envs.action_space.sample()
            actions["interact"][:] = 0
            many = envs.step(actions)[0]
            ones = [
                env.step({key: value[index] for key, value in actions.items()})[0] for index, env in enumerate(singles)
            ]
        assert list(info["instruction"]) == [TELL.text] * 2
    finally:
        envs.close()


@pytest.mark.parametrize("autoreset", list(AutoresetMode), ids=str)
@pytest.mark.parametrize("mode", MODES)
def test_the_instruction_survives_every_autoreset(mode, autoreset):
    arguments = {**MODES[mode], "vector_kwargs": {**MODES[mode].get("vector_kwargs", {}), "autoreset_mode": autoreset}}
    envs = gym.make_vec(HOUSEHOLD, num_envs=2, instruction=TELL, **arguments)
    try:
        envs.reset(seed=0)
        _, _, terminated, _, info = envs.step(FINISH)
        assert terminated.all()
        if autoreset is AutoresetMode.DISABLED:
            observation, info = envs.reset(options={"reset_mask": np.array([True, True])})
        else:
            rest = {**FINISH, "interact": np.zeros(2, dtype=np.int64)}
            observation, _, terminated, _, info = envs.step(rest)
            assert not terminated.any()
        assert list(info["instruction"]) == [TELL.text] * 2
        assert [text_of(codes) for codes in observation["instruction_codes"]] == [TELL.text] * 2
        envs.step({**FINISH, "interact": np.zeros(2, dtype=np.int64)})
    finally:
        envs.close()


def test_a_gold_reading_is_of_the_instruction_that_each_of_a_vector_has():
    envs = gym.make_vec(HOUSEHOLD, num_envs=2, instruction=ASK)
    texts = ["Off to the kitchen!", "Quick, to the kitchen!"]
    for options, asked, met in (
        ({"gold": TELL}, [ASK.text] * 2, 1),
        ({}, [ASK.text] * 2, 2),
        ({"instructions": texts, "gold": TELL}, texts, 1),
        ({}, texts, 1),
    ):
        _, info = envs.reset(seed=1, options={**options, "states": {"tv": "on"}})
        assert list(info["instruction"]) == asked
        assert list(info["judged_by"]) == ["gold"] * 2
        assert list(info["goal_conditions_total"]) == [met] * 2
    envs.close()


@pytest.mark.parametrize("seed", [np.int64(3), [np.int64(3), np.uint8(4)], np.array([3, 4]), (3, 4)], ids=repr)
def test_seeds_may_be_whole_numbers_of_numpys(seed):
    envs = gym.make_vec(HOUSEHOLD, num_envs=2, instruction=GO)
    expected, _ = envs.reset(seed=[3, 4])
    observation, _ = envs.reset(seed=seed)
    assert data_equivalence(observation, expected, exact=True)
    json.dumps([env.unwrapped.state_dict() for env in envs.envs])
    envs.close()


def test_a_seed_of_one_environment_may_be_so_too():
    env = gym.make(HOUSEHOLD, instruction=GO)
    expected, _ = env.reset(seed=3)
    assert data_equivalence(env.reset(seed=np.int64(3))[0], expected, exact=True)


@pytest.mark.parametrize("seed", [3.5, "x", [1], [1, 2, 3]])
def test_what_are_no_seeds_of_a_vector_is_said_in_words(seed):
    envs = gym.make_vec(HOUSEHOLD, num_envs=2, instruction=GO)
    with pytest.raises(InputError, match="expected a list of 2, one for each, or one for all"):
        envs.reset(seed=seed)
    envs.close()


@pytest.mark.parametrize("kind", ["MT19937", "PCG64DXSM", "Philox", "SFC64"])
def test_an_episode_is_recorded_whatever_its_random_numbers_come_from(kind):
    env, other = (gym.make(HOUSEHOLD, instruction=TELL).unwrapped for _ in range(2))
    env.np_random = np.random.Generator(getattr(np.random, kind)(1))
    env.reset()
    env.step(env.action_space.sample() | {"interact": 0})
    other.load_state_dict(json.loads(json.dumps(env.state_dict())))
    twins = [other, pickle.loads(pickle.dumps(env)), copy.copy(env), copy.deepcopy(env)]
    begun = env.observe()
    assert all(data_equivalence(twin.observe(), begun, exact=True) for twin in twins)
    following, _ = env.reset()
    assert all(data_equivalence(twin.reset()[0], following, exact=True) for twin in twins)


def test_flat_vectors_and_their_actions():
    envs = gym.make_vec(HOUSEHOLD_FLAT, num_envs=3, instruction=GO, vectorization_mode="sync")
    observation, _ = envs.reset(seed=0)
    assert observation.shape == (3, *envs.single_observation_space.shape)
    assert observation in envs.observation_space
    envs.close()


@pytest.mark.parametrize("identity", IDS)
def test_a_spec_makes_the_environment_again(identity):
    env = gym.make(identity, instruction="Go to the kitchen.")
    spec = EnvSpec.from_json(env.spec.to_json())
    assert spec == env.spec
    again = gym.make(spec)
    assert again.unwrapped.instruction == "Go to the kitchen."
    assert (again.observation_space, again.action_space) == (env.observation_space, env.action_space)


@pytest.mark.parametrize(
    "arguments",
    [
        {"config": HouseholdConfig(reward="progress", world=WorldConfig(max_speed=0.5))},
        {"instruction": ASK},
        {"instruction": Example("1", ASK)},
        {"domain": load_domain("household").folder},
        {"size": "small", "house_seed": np.int64(3)},
        {"config": {"max_seconds": np.float32(60), "world": {"tray_slots": np.int64(2)}}},
    ],
    ids=lambda arguments: ", ".join(arguments),
)
def test_a_spec_goes_through_json_whatever_it_was_made_with(arguments):
    env = gym.make(HOUSEHOLD, **arguments)
    again = gym.make(EnvSpec.from_json(env.spec.to_json())).unwrapped
    assert (again.config, again.request) == (env.unwrapped.config, env.unwrapped.request)
    assert again.domain.house == env.unwrapped.domain.house


def test_wrapped_environments_have_specs_that_make_them_again():
    wrapped = gym.wrappers.FlattenObservation(gym.wrappers.TimeLimit(gym.make(HOUSEHOLD, instruction=GO), 3))
    again = gym.make(wrapped.spec)
    one, other = wrapped.reset(seed=1)[0], again.reset(seed=1)[0]
    assert np.array_equal(one, other)
    assert one in wrapped.observation_space


@pytest.mark.parametrize("identity", [HOUSEHOLD, HOUSEHOLD_SMALL, HOUSEHOLD_FLAT])
def test_pickles_go_on_where_they_were(identity):
    env = gym.make(identity, instruction=TELL)
    env.reset(seed=2)
    env.action_space.seed(0)
    actions = [sample(env) for _ in range(30)]
    for action in actions[:12]:
        env.step(action)
    twin = pickle.loads(pickle.dumps(env))
    assert twin.spec == env.spec
    for action in actions[12:]:
        assert data_equivalence(env.step(action)[0], twin.step(action)[0], exact=True)
    assert env.unwrapped.domain.house == twin.unwrapped.domain.house
    assert data_equivalence(env.reset()[0], twin.reset()[0], exact=True)
    assert twin.unwrapped.instruction == TELL.text


def test_statistics_are_of_the_episode():
    env = gym.wrappers.RecordEpisodeStatistics(gym.make(HOUSEHOLD, instruction=GO))
    env.reset(seed=0, options={"chance": False})
    rest = {"drive": np.zeros(2, dtype=np.float32), "interact": 0, "target": 0}
    env.step(rest)
    env.unwrapped.world._robot.position = 2.2, 6.0
    info = env.step(rest)[4]
    assert (info["episode"]["r"], info["episode"]["l"]) == (1.0, 2)


def test_videos_are_recorded(tmp_path):
    pytest.importorskip("moviepy", reason="RecordVideo needs moviepy")
    env = gym.wrappers.RecordVideo(gym.make(HOUSEHOLD, render_mode="rgb_array", instruction=GO), str(tmp_path))
    env.reset(seed=0)
    for _ in range(4):
        env.step({"drive": np.ones(2, dtype=np.float32), "interact": 0, "target": 0})
    env.close()
    assert list(tmp_path.glob("*.mp4"))


def test_frames_are_collected():
    env = gym.make(HOUSEHOLD, render_mode="rgb_array_list", instruction=GO)
    env.reset(seed=0)
    for _ in range(3):
        env.step({"drive": np.ones(2, dtype=np.float32), "interact": 0, "target": 0})
    frames = env.render()
    assert len(frames) == 4
    assert {frame.shape for frame in frames} == {(700, 800, 3)}
    env.close()


def test_environments_and_agents_share_nothing():
    def play(env, seed, company=None):
        observation, info = env.reset(seed=seed, options={"instruction": GO})
        agent = decomplex_bt.TreeAgent(env, flow=GO)
        agent.reset(observation, info)
        trace = []
        while not agent.done:
            observation, *_ = env.step(agent.act(observation))
            trace.append(observation["robot"].tolist())
            if company is not None:
                next(company, None)
        return trace

    def others():
        env = gym.make(HOUSEHOLD_SMALL)
        for seed in range(2):
            observation, info = env.reset(seed=seed, options={"instruction": TELL})
            agent = decomplex_bt.TreeAgent(env, flow=TELL)
            agent.reset(observation, info)
            while not agent.done:
                observation, *_ = env.step(agent.act(observation))
                yield

    alone = play(gym.make(HOUSEHOLD), 3)
    assert play(gym.make(HOUSEHOLD), 3, others()) == alone
    assert not Blackboard.storage


def test_a_vector_has_every_autoreset_mode_and_the_id_it_was_made_by():
    envs = gym.make_vec("decomplex_bt/HouseholdSmall-v0", num_envs=2, autoreset_mode=AutoresetMode.SAME_STEP)

    assert envs.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP
    assert {one.spec.id for one in envs.envs} == {envs.spec.id} == {"decomplex_bt/HouseholdSmall-v0"}


@pytest.mark.parametrize(
    ("text", "error", "says"),
    [
        ("Put the cup.", MissingArgumentError, "Where should I put it"),
        ("Take the cup to the moon.", InputError, "'the moon' names nothing"),
    ],
)
def test_a_generated_house_says_why_nothing_can_be_asked(text, error, says):
    with pytest.raises(error, match=says):
        gym.make("decomplex_bt/HouseholdSmall-v0").reset(seed=0, instruction=text)


@pytest.mark.filterwarnings("ignore")
def test_an_error_of_a_process_is_the_same_here():
    envs = gym.make_vec("decomplex_bt/Household-v0", num_envs=2, vectorization_mode="async")

    with pytest.raises(MissingArgumentError, match="Where should I put it"):
        envs.reset(seed=0, options={"instruction": "Put the cup."})
    envs.close(terminate=True)
