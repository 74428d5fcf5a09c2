"""The household environment keeps the Gymnasium contract, to the letter."""

from __future__ import annotations

import copy
import gc
import json
import pickle
import re
import shutil
import subprocess
import sys
import warnings
from functools import partial

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env, data_equivalence
from gymnasium.vector import AutoresetMode

import decomplex_bt  # noqa: F401 - registers the environments
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.config import WorldConfig
from decomplex_bt.envs.household import HouseholdConfig, HouseholdEnv
from decomplex_bt.envs.houses import generated_domain
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.registration import HOUSEHOLD, HOUSEHOLD_FLAT, register_envs
from decomplex_bt.envs.vector import HouseholdVectorEnv
from decomplex_bt.envs.wrappers import InstructionReset
from decomplex_bt.errors import DataFileError, InputError

ONTOLOGY = load_domain("household").ontology
GO = read_markup("[Go](1:motion) [to the kitchen](1:goal).", ONTOLOGY, flow=[1])
TV_SAID = "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) off."
TV = read_markup(TV_SAID, ONTOLOGY, flow=[{"if": 1, "then": [2]}])
REST = {"drive": np.zeros(2, dtype=np.float32), "interact": 0, "target": 0}


def action(env, interaction=Interaction.NONE, target="robot", drive=(0.0, 0.0)):
    row = env.entities.index(target)
    return {"drive": np.array(drive, dtype=np.float32), "interact": int(interaction), "target": row}


def rollout(env, steps, seed=1):
    """What random steps give, up to the episode's end: a drawn instruction may be as short as to leave a room."""
    rng = np.random.default_rng(seed)
    for _ in range(steps):
        chosen = {
            "drive": rng.uniform(-1, 1, 2).astype(np.float32),
            "interact": int(rng.integers(12)),
            "target": int(rng.integers(len(env.entities))),
        }
        _, _, terminated, truncated, _ = step = env.step(chosen)
        yield step
        if terminated or truncated:
            return


@pytest.mark.parametrize("identity", [HOUSEHOLD, HOUSEHOLD_FLAT])
def test_check_env_has_nothing_to_say(identity):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gym.make(identity).unwrapped, skip_render_check=True)


def test_registering_twice_warns_of_nothing():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        register_envs()


def test_seeds_and_actions_make_the_episode():
    one, other = HouseholdEnv(), HouseholdEnv()
    for seed in (0, 5):
        assert data_equivalence(one.reset(seed=seed)[0], other.reset(seed=seed)[0], exact=True)
        for mine, yours in zip(rollout(one, 80), rollout(other, 80), strict=True):
            assert data_equivalence(mine, yours, exact=True)


def test_two_at_once_do_not_disturb_each_other():
    alone, with_company, company = HouseholdEnv(GO), HouseholdEnv(GO), HouseholdEnv(TV)
    alone.reset(seed=3)
    with_company.reset(seed=3)
    company.reset(seed=9)
    disturbed = zip(rollout(with_company, 40), rollout(company, 40, seed=8), strict=True)
    for mine, (yours, _) in zip(rollout(alone, 40), disturbed, strict=True):
        assert data_equivalence(mine[0], yours[0], exact=True)


def test_observations_lie_in_their_space():
    env = HouseholdEnv(GO)
    assert env.reset(seed=0)[0] in env.observation_space
    for observation, *_ in rollout(env, 100):
        assert observation in env.observation_space


def test_a_pickled_environment_goes_on_where_it_was():
    env = HouseholdEnv(TV)
    env.reset(seed=4)
    list(rollout(env, 60))
    twin = pickle.loads(pickle.dumps(env))
    for mine, yours in zip(rollout(env, 30, seed=2), rollout(twin, 30, seed=2), strict=True):
        assert data_equivalence(mine, yours, exact=True)
    assert data_equivalence(env.reset()[0], twin.reset()[0], exact=True)


def test_a_fresh_environment_pickles():
    assert pickle.loads(pickle.dumps(HouseholdEnv(GO))).instruction == GO.text


# -- recordings -------------------------------------------------------------------------------------------------------


def recorded(steps=30, **arguments):
    env = HouseholdEnv(TV, **arguments)
    options = {"placement": {"apple": "fridge", "pan": None}, "states": {"pan": ("dirty", "full")}, "broken": ["tv"]}
    env.reset(seed=4, options=options)
    list(rollout(env, steps))
    return env


def test_a_recording_is_plain_and_read_back_exactly():
    env, twin = recorded(), HouseholdEnv(GO)
    state = env.state_dict()
    twin.load_state_dict(json.loads(json.dumps(state)))
    assert twin.state_dict() == state
    assert twin.instruction == GO.text
    for mine, yours in zip(rollout(env, 20, seed=2), rollout(twin, 20, seed=2), strict=True):
        assert data_equivalence(mine, yours, exact=True)
    assert data_equivalence(env.reset()[0]["entities"], twin.reset(instruction=TV)[0]["entities"], exact=True)


@pytest.mark.parametrize("identity", [HOUSEHOLD, HOUSEHOLD_FLAT])
@pytest.mark.parametrize("steps", [0, 1, 70])
def test_what_is_observed_now_is_what_was_returned(identity, steps):
    env, twin = gym.make(identity), gym.make(identity)
    env.action_space.seed(0)
    returned = env.reset(seed=4, instruction=TV, options={"meddling": 60, "states": {"tv": "on"}})
    for _ in range(steps):
        observation, _, terminated, _, info = env.step(env.action_space.sample())
        returned = observation, info
        if terminated:
            break
    twin.unwrapped.load_state_dict(env.unwrapped.state_dict())
    for each in (env.unwrapped, twin.unwrapped, copy.deepcopy(env.unwrapped)):
        assert data_equivalence((each.observe(), each.inform()), returned, exact=True)


def test_nothing_is_observed_before_the_first_reset():
    for ask in (HouseholdEnv().observe, HouseholdEnv().inform):
        with pytest.raises(gym.error.ResetNeeded):
            ask()


@pytest.mark.parametrize(("index", "step"), [(0, 0), (1, 50), (2, 60)])
def test_a_replay_that_departs_says_where(index, step):
    state = recorded(steps=60).state_dict()
    HouseholdEnv().load_state_dict(state)
    state["checksums"][index] += 1
    with pytest.raises(InputError, match=f"by step {step};"):
        HouseholdEnv().load_state_dict(state)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"config": HouseholdConfig(world=WorldConfig(max_speed=0.5))}, "config.world.max_speed 1.0.* has 0.5"),
        ({"config": HouseholdConfig(balance=0.1)}, "config.balance 0.3.* has 0.1"),
        ({"size": "small"}, "another house"),
    ],
    ids=str,
)
def test_a_recording_is_not_replayed_elsewhere(arguments, says):
    with pytest.raises(InputError, match=says):
        HouseholdEnv(**arguments).load_state_dict(recorded().state_dict())


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"format": 1}, "format 1; this version reads format 3"),
        ({"format": None}, "no recording"),
        ({"generator": None}, "generator: Field required"),
        ({"generator": {"state": 1}}, "generator: .*PCG64"),
        ({"generator": {"bit_generator": "MT19937", "state": {"key": [1], "pos": 0}}}, "generator: .*MT19937"),
        ({"checksums": [1]}, "1 checksums; expected 3 for 60 actions"),
        ({"actions": [[0.0, 0.0, 0]] * 60}, r"actions\.0\.3: Field required"),
        ({"actions": [[0.0, 0.0, 99, 0]] * 60}, "no action"),
        ({"actions": [[0.0, 0.0, int(Interaction.FINISH), 0]] * 60}, "by step 50"),
        ({"options": {"balanse": 1}}, "balanse"),
        ({"house": 1}, "house: .*"),
        ({"gold": {"text": 1}}, "gold.text"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_recording_that_cannot_be_loaded_leaves_the_environment_as_it_was(changes, says):
    state = recorded(steps=60).state_dict() | changes
    state = {key: value for key, value in state.items() if value is not None}
    env, undisturbed = HouseholdEnv(GO), HouseholdEnv(GO)
    for each in (env, undisturbed):
        each.reset(seed=0)
        list(rollout(each, 10))
    with pytest.raises(InputError, match=says):
        env.load_state_dict(state)
    for mine, yours in zip(rollout(env, 20, seed=2), rollout(undisturbed, 20, seed=2), strict=True):
        assert data_equivalence(mine, yours, exact=True)
    assert data_equivalence(env.reset(), undisturbed.reset(), exact=True)


def test_a_replay_is_filmed_like_what_was_recorded():
    env = recorded(render_mode="rgb_array")
    assert np.array_equal(pickle.loads(pickle.dumps(env)).render(), env.render())


class Robot(HouseholdEnv):
    """An environment of somebody's own, which takes other arguments."""

    def __init__(self, number):
        super().__init__(GO)
        self.number = number


@pytest.mark.parametrize("copied", [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))])
def test_a_copy_has_all_that_the_environment_has(copied):
    env = Robot(3)
    env.reset(seed=1)
    env.action_space.seed(5)
    env.mine = ["anything"]
    twin = copied(env)
    assert (twin.number, twin.mine, twin.np_random_seed) == (3, ["anything"], 1)
    assert [twin.action_space.sample()["target"] for _ in range(9)] == [
        env.action_space.sample()["target"] for _ in range(9)
    ]
    assert data_equivalence(env.step(REST), twin.step(REST), exact=True)
    assert data_equivalence(env.reset(), twin.reset(), exact=True)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))])
@pytest.mark.parametrize("seeds", [(None, 7), (7, 8), (7, None)], ids=str)
def test_a_copy_draws_the_houses_that_the_environment_draws(copied, seeds):
    own, given = seeds
    env = HouseholdEnv(GO, size="small", house_seed=own)
    env.reset(seed=0, options={"house_seed": given})
    twin = copied(env)
    houses = []
    for each in (env, twin):
        optioned = [None, {"house_seed": None}, None, None]
        houses.append([each.reset(options=options) and each.domain.house.name for options in optioned])
    assert houses[0] == houses[1]
    assert len(set(houses[0][1:])) == (3 if own is None else 1)


def test_a_shallow_copy_has_random_numbers_of_its_own():
    env, undisturbed = HouseholdEnv(GO), HouseholdEnv(GO)
    for each in (env, undisturbed):
        each.reset(seed=3)
        each.action_space.seed(0)
    twin = copy.copy(env)
    expected = undisturbed.action_space.sample(), undisturbed.reset()
    for each in (twin, env):
        assert data_equivalence((each.action_space.sample(), each.reset()), expected, exact=True)


def test_a_copy_lives_in_the_house_of_the_domain_that_was_given():
    env = HouseholdEnv(GO, domain=generated_domain(load_domain("household"), "small", 3))
    env.reset(seed=0)
    twin = copy.deepcopy(env)
    assert twin.domain.house == env.domain.house
    assert data_equivalence(env.step(REST), twin.step(REST), exact=True)


# -- the instruction --------------------------------------------------------------------------------------------------


def test_the_instruction_can_be_given_in_four_ways_and_stays():
    env = gym.make(HOUSEHOLD, instruction=GO)
    assert env.reset(seed=0)[1]["instruction"] == GO.text
    assert env.reset(seed=0, instruction=TV)[1]["instruction"] == TV.text
    assert env.reset()[1]["instruction"] == TV.text
    assert env.reset(options={"instruction": GO})[1]["instruction"] == GO.text
    env.unwrapped.instruction = TV
    assert env.reset()[1]["instruction"] == TV.text
    assert gym.make(HOUSEHOLD, instruction=GO).spec.kwargs == {"instruction": GO}


def test_on_top_of_wrappers_the_instruction_needs_one_more():
    env = InstructionReset(gym.wrappers.RecordEpisodeStatistics(gym.make(HOUSEHOLD)))
    assert env.reset(seed=0, instruction=TV)[1]["instruction"] == TV.text


def test_without_an_instruction_each_reset_draws_one():
    env = HouseholdEnv()
    texts = {env.reset(seed=seed)[1]["instruction"] for seed in range(6)}
    assert len(texts) > 3
    assert env.instruction is None


UNDONE = [
    lambda env: env.reset(seed=3, options={"instruction": None}),
    lambda env: setattr(env.unwrapped, "instruction", None),
]


@pytest.mark.parametrize("undo", UNDONE, ids=["option", "attribute"])
@pytest.mark.parametrize("made", [{}, {"instruction": GO}], ids=str)
def test_an_instruction_can_be_undone(undo, made):
    env, fresh = gym.make(HOUSEHOLD, **made), gym.make(HOUSEHOLD)
    env.reset(seed=0, instruction=TV)
    assert env.reset(instruction=None)[1]["instruction"] == TV.text
    undo(env)
    assert env.unwrapped.instruction is None
    for seed in (1, 2):
        assert env.reset(seed=seed)[1]["instruction"] == fresh.reset(seed=seed)[1]["instruction"]


def test_an_instruction_of_none_beside_another_one_is_none_to_undo():
    env = InstructionReset(HouseholdEnv(GO))
    assert env.reset(seed=0, instruction=TV, options={"instruction": None})[1]["instruction"] == TV.text
    assert env.reset(seed=0, options={"instruction": None, "gold": GO})[1]["instruction"] == GO.text


@pytest.mark.parametrize("standing", [None, TV], ids=["drawn", "given"])
def test_a_gold_reading_alone_is_of_its_episode_alone(standing):
    env, fresh = HouseholdEnv(standing), HouseholdEnv(standing)
    info = env.reset(seed=0, options={"gold": GO})[1]
    assert (info["instruction"], info["judged_by"]) == (GO.text if standing is None else TV.text, "gold")
    assert env.request == fresh.request
    for seed in (1, 2):
        assert env.reset(seed=seed)[1] == fresh.reset(seed=seed)[1]


def test_a_gold_reading_beside_an_instruction_stays_with_it():
    env = HouseholdEnv()
    env.reset(seed=0, options={"instruction": "Off to the kitchen!", "gold": GO})
    info = env.reset(seed=1)[1]
    assert (info["instruction"], info["judged_by"]) == ("Off to the kitchen!", "gold")


def test_where_what_undoes_an_instruction_is_refused_it_stays():
    env = HouseholdEnv(GO)
    with pytest.raises(InputError, match="attic"):
        env.reset(options={"instruction": None, "people": {"user": "attic"}})
    assert env.instruction == GO.text


def test_the_text_is_shown_in_latin_1_and_known_exactly():
    text = "Go to the kitchen – now, café?"
    observation, info = HouseholdEnv(text, gold=GO).reset(seed=0)
    assert info["instruction"] == text
    assert observation["instruction"] == "Go to the kitchen ? now, café?"
    assert bytes(observation["instruction_codes"]).rstrip(b"\0").decode("latin-1") == observation["instruction"]


def test_same_seed_same_world_whatever_instruction_apart_from_what_it_tests():
    one, other = HouseholdEnv(GO), HouseholdEnv(TV)
    one.reset(seed=3)
    other.reset(seed=3)
    assert np.array_equal(one.world.position, other.world.position, equal_nan=True)
    rows = [row for row, name in enumerate(one.entities) if name != "tv"]
    assert np.array_equal(one.world.states[rows], other.world.states[rows])


def test_a_seed_answers_each_question_anew_and_the_same_question_alike():
    env = HouseholdEnv()
    radio = read_markup(TV_SAID.replace("tv", "radio"), ONTOLOGY, flow=[{"if": 1, "then": [2]}])
    tell = read_markup(
        "If [the tv](1:object) [is](1:check_state) [on](1:state), [tell](2:informing) [me](2:recipient).",
        ONTOLOGY,
        flow=[{"if": 1, "then": [2]}],
    )

    def is_on(name, instruction):
        for seed in range(40):
            env.reset(seed=seed, instruction=instruction)
            yield env.truth().state(name, "power") == "on"

    tv, others = list(is_on("tv", TV)), list(is_on("radio", radio))
    assert 8 <= sum(one == other for one, other in zip(tv, others, strict=True)) <= 32
    assert list(is_on("tv", tell)) == tv


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"instructoin": "x"}, "instruction"),
        ({"placement": {"pan": "cupbord"}}, "cupboard"),
        ({"placement": {"pna": "cupboard"}}, "'pna' is no thing of this house; the nearest known: pan"),
        ({"placement": {"pan": "sofa"}}, "'sofa' is no place .*; the nearest known: couch"),
        ({"placement": {"pan": "kitchen"}}, "'kitchen' is no place .*nearest known: .*kitchen_floor"),
        ({"placement": {"pan": "tv"}}, r"placement\.pan: nothing can lie .*name a surface"),
        ({"states": {"tv": "open"}}, "tv cannot be open"),
        ({"states": {"tv": "onn"}}, r"states\.tv: 'onn' is no state; the nearest known: on"),
        ({"people": {"anna": "attic"}}, "'attic' is no room of this house; known: kitchen, .*, hallway$"),
        ({"people": {"bob": "kitchen"}}, "'bob' is no person of this house; known: user, anna"),
        ({"people": {"user": None}}, "always at home"),
        ({"broken": ["couch"]}, r"'couch' is no device .*known: coffee_machine.*\(16 in all\)"),
        ({"broken": ["TV"]}, "'TV' is no device .*; the nearest known: tv"),
        ({"zzz": 1}, r"'zzz'; known: house, house_seed.*\(16 in all\)"),
        ({"balance": 0.7}, "0.7"),
        ({"noise": "no"}, "True or False"),
        ({"reward": "gold"}, "success, progress"),
        ({"instruction": "  "}, "empty"),
        ({"instruction": "a" * 2001}, "2001"),
        ({"instruction": 7}, "int"),
        ({"instruction": {"text": "Go.", "tasks": [{"id": 1}]}}, "instruction.tasks.0.type: Field required"),
        ({"reward": np.array([1, 2])}, "success, progress"),
        ({"placement": {"pan": np.array(["desk", "stove"])}}, "placement.pan: array.* is no place"),
        ({"broken": {"tv": False}}, "broken is .*expected a list of devices"),
        ({"states": {"fridge": {"fill": "full"}}}, "states.fridge is .*expected a state"),
        ({"states": {"robot": "on"}}, "states: 'robot' is no place or thing of this house"),
        ({"broken": np.array("tv")}, "expected a list of devices"),
        ({"states": {"fridge": ("open", "closed")}}, "fridge cannot be both open and closed"),
        ({"states": {"tv": "on"}, "broken": ["tv"]}, "tv cannot be broken and on"),
        (["noise"], "expected a mapping"),
    ],
    ids=str,
)
def test_options_that_cannot_be_used_are_refused(options, says):
    with pytest.raises(ValueError, match=says):
        HouseholdEnv(GO).reset(seed=0, options=options)


def test_an_instruction_that_is_given_twice_is_given_once():
    for env in (HouseholdEnv(), InstructionReset(HouseholdEnv())):
        assert env.reset(seed=0, instruction=GO, options={"instruction": GO})[1]["instruction"] == GO.text
        with pytest.raises(InputError, match="two instructions"):
            env.reset(seed=0, instruction=GO, options={"instruction": TV})


def test_numpy_values_are_taken_for_what_they_are():
    plain = {"noise": False, "balance": 0.25, "max_seconds": 5, "states": {"tv": "on"}, "placement": {"pan": "stove"}}
    numpys = {
        "noise": np.bool_(False),
        "balance": np.float32(0.25),
        "max_seconds": np.int64(5),
        "states": {np.str_("tv"): np.array(["on"])},
        "placement": {"pan": np.str_("stove")},
    }
    one, other = HouseholdEnv(GO), HouseholdEnv(GO)
    assert data_equivalence(one.reset(seed=0, options=plain), other.reset(seed=0, options=numpys), exact=True)
    assert json.dumps(one.state_dict()) == json.dumps(other.state_dict())
    one.instruction = np.str_("Go to the kitchen.")
    assert type(one.instruction) is str


@pytest.mark.parametrize("seed", [None, 99])
@pytest.mark.parametrize(
    "options",
    [{"house_seed": 1}, {"instruction": "Lovely weather today."}, {"instruction": TV, "placement": {"pan": "tv"}}],
    ids=str,
)
def test_a_refused_reset_changes_nothing(options, seed):
    env, undisturbed = HouseholdEnv(GO), HouseholdEnv(GO)
    for each in (env, undisturbed):
        each.reset(seed=0)
    with pytest.raises(InputError):
        env.reset(seed=seed, options=options)
    assert env.instruction == GO.text
    for mine, yours in zip(rollout(env, 20), rollout(undisturbed, 20), strict=True):
        assert data_equivalence(mine, yours, exact=True)
    assert env.np_random_seed == undisturbed.np_random_seed
    assert data_equivalence(env.reset(), undisturbed.reset(), exact=True)
    fresh = HouseholdEnv()
    with pytest.raises(InputError):
        fresh.reset(options=options)
    assert fresh.instruction is None
    fresh.reset(seed=1)


def test_after_a_replay_the_judge_is_of_the_instruction_that_is_asked():
    env, other = HouseholdEnv(GO), HouseholdEnv(TV)
    other.reset(seed=0)
    env.load_state_dict(other.state_dict())
    assert data_equivalence(env.reset(seed=1)[1], HouseholdEnv(GO).reset(seed=1)[1], exact=True)


@pytest.mark.parametrize("identity", [HOUSEHOLD, HOUSEHOLD_FLAT])
@pytest.mark.parametrize(
    "arguments", [{"noise": False}, {"placement": {"pan": None}}, {"meddling": 2, "balance": 0.1}], ids=str
)
def test_reset_options_are_no_arguments(identity, arguments):
    with pytest.raises(InputError, match=re.escape(f"env.reset(options={arguments!r})")):
        gym.make(identity, **arguments)
    with pytest.raises(TypeError, match="'nonsense'"):
        gym.make(identity, nonsense=1, **arguments)


def test_options_set_what_they_name():
    env = HouseholdEnv(GO)
    placement = {"pan": "stove", "apple": None}
    env.reset(
        seed=0,
        options={
            "placement": placement,
            "states": {"fridge": "open", "pan": ("dirty", "full")},
            "broken": ["tv"],
            "people": {"anna": "study", "tom": None},
        },
    )
    world, row = env.world, env.entities.index
    assert world.place[row("pan")] == row("stove")
    assert world.place[row("apple")] == -1
    assert world.states[row("fridge"), 1] == 1
    assert world.states[row("pan")].tolist() == [-1, -1, -1, 0, 1]
    assert np.flatnonzero(world.broken).tolist() == [row("tv")]
    assert env.setting.geometry.rooms[world.room[row("anna")]] == "study"
    assert not world.home[row("tom")]


@pytest.mark.parametrize("options", [{}, {"placement": {"apple": "desk"}}, {"people": {"anna": "study"}}], ids=str)
def test_without_chance_all_seeds_have_the_same_house(options):
    env = HouseholdEnv(GO)
    starts = []
    for seed in (1, 2):
        env.reset(seed=seed, options={"chance": False, **options})
        starts.append((env.world.place, env.world.states, env.world.position, env.world.robot_heading))
        assert env.world.grasp_slip == 0
    assert all(np.array_equal(one, other, equal_nan=True) for one, other in zip(*starts, strict=True))


def test_without_chance_who_leads_wherever_they_like_goes_to_the_same_room():
    env = HouseholdEnv(read_markup("[Follow](1:following) [Tom](1:object).", ONTOLOGY, flow=[1]))
    goals = {}
    for chance in (True, False):
        goals[chance] = set()
        for seed in range(6):
            env.reset(seed=seed, options={"chance": chance, "people": {"user": "study"}})
            env.world._robot.position = tuple(env.world.position[env.entities.index("user")] + (0.5, 0.0))
            env.step(REST)
            env.step(action(env, Interaction.SAY, "robot"))
            goals[chance].add(env.world.event.goal)
    assert len(goals[True]) > 1
    assert len(goals[False]) == 1


def test_success_ends_the_episode_and_pays():
    env = HouseholdEnv(GO)
    env.reset(seed=0, options={"chance": False})
    assert env.step(REST)[1] == 0.0
    env.world._robot.position = (2.2, 6.0)
    _, reward, terminated, truncated, info = env.step(REST)
    assert (reward, terminated, truncated, info["is_success"]) == (1.0, True, False, True)


def test_finish_ends_the_episode_and_pays_nothing():
    env = HouseholdEnv(GO)
    env.reset(seed=0, options={"chance": False})
    _, reward, terminated, truncated, info = env.step(action(env, Interaction.FINISH))
    assert (reward, terminated, truncated, info["is_success"]) == (0.0, True, False, False)


def test_time_runs_out():
    env = HouseholdEnv(GO, config=HouseholdConfig(max_seconds=0.5))
    env.reset(seed=0, options={"chance": False})
    ends = [env.step(REST)[2:4] for _ in range(5)]
    assert ends == [(False, False)] * 4 + [(False, True)]


def test_a_result_is_in_the_next_observation():
    env = HouseholdEnv(GO)
    env.reset(seed=0)
    assert env.step(action(env, Interaction.PLACE, "bed"))[0]["result"] == Result.HAND_EMPTY
    assert env.step(REST)[0]["result"] == Result.NONE


@pytest.mark.parametrize(
    "bad",
    [
        {"interact": 99},
        {"target": -1},
        {"interact": 1.9},
        {"interact": float("inf")},
        {"interact": "1"},
        {"interact": None},
        {"interact": np.array([0])},
        {"drive": (float("nan"), 0)},
        {"drive": (0, float("inf"))},
        {"drive": (0,)},
        {"drive": np.zeros(3)},
        {"drive": np.zeros((2, 1))},
        {"drive": "12"},
        {"drive": {0.1, 0.5}},
        {"drive": np.zeros(2, dtype=complex)},
        {"drive": (np.complex128(0), 0)},
        {"drive": None},
    ],
    ids=str,
)
def test_what_is_no_action_is_refused_and_not_done(bad):
    env = HouseholdEnv(GO)
    env.reset(seed=0)
    with pytest.raises(InputError, match=r"(?s)no action: .* expected a mapping of drive"):
        env.step({"drive": (1.0, 0.0), "interact": 0, "target": 0} | bad)
    assert env.world.steps == 0


@pytest.mark.parametrize("bad", [None, 3, [0, 0, 0, 0], np.zeros(4), "drive", {}, {"drive": (0, 0)}], ids=str)
def test_what_is_not_even_a_mapping_of_an_action_is_refused(bad):
    env = HouseholdEnv(GO)
    env.reset(seed=0)
    with pytest.raises(InputError, match=r"(?s)no action: .* expected a mapping of drive"):
        env.step(bad)


def test_speeds_beyond_the_highest_are_the_highest():
    fast, faster = HouseholdEnv(GO), HouseholdEnv(GO)
    for env, speed in ((fast, 1), (faster, 7)):
        env.reset(seed=0)
        env.step({"drive": [speed, -speed], "interact": np.int64(0), "target": np.array(0)})
    assert fast.world.robot == faster.world.robot


@pytest.mark.parametrize(
    "bad",
    [
        [-1, 4, 0, 0],
        [9, 4, 0, 0],
        [4, 4, 99, 0],
        [4, 4, 0],
        [4.5, 4, 0, 0],
        [float("nan")] * 4,
        np.zeros(4),
        np.zeros((1, 4), dtype=np.int64),
        None,
        3,
        "abcd",
        REST,
    ],
    ids=str,
)
def test_what_is_no_flat_action_is_refused_and_not_done(bad):
    env = gym.make(HOUSEHOLD_FLAT, instruction=GO).unwrapped
    env.reset(seed=0)
    with pytest.raises(InputError, match=r"(?s)no action: .* expected 4 whole numbers"):
        env.step(bad)
    assert env.world.steps == 0


@pytest.mark.parametrize("how", ["finish", "time"])
def test_after_the_end_there_are_no_steps_until_a_reset(how):
    env = HouseholdEnv(GO)
    env.reset(seed=0, options={"max_seconds": 0.1} if how == "time" else None)
    _, _, terminated, truncated, _ = env.step(action(env, Interaction.FINISH) if how == "finish" else REST)
    assert (terminated, truncated) == (how == "finish", how == "time")
    with pytest.raises(gym.error.ResetNeeded, match="is over"):
        env.step(REST)
    assert env.world.steps == 1
    env.reset()
    env.step(REST)


def test_before_a_reset_there_is_no_world():
    with pytest.raises(gym.error.ResetNeeded):
        HouseholdEnv(GO).step(REST)


def test_closing_twice_is_fine():
    env = gym.make(HOUSEHOLD)
    env.close()
    env.close()


def test_vector_environments_take_an_instruction_each():
    envs = gym.make_vec(HOUSEHOLD, num_envs=2, vectorization_mode="vector_entry_point")
    observation, info = envs.reset(seed=1, options={"instructions": [GO, TV]})
    assert list(info["instruction"]) == [GO.text, TV.text]
    assert observation["entities"].shape[0] == 2
    envs.step(envs.action_space.sample())
    assert list(
        envs.reset(options={"instructions": np.array(["Go to the kitchen.", "Go to the study."])})[1]["seconds"]
    )
    assert [env.unwrapped.instruction for env in envs.envs] == ["Go to the kitchen.", "Go to the study."]
    envs.close()


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"instructions": [GO]}, "list of 2"),
        ({"instructions": 5}, "list of 2"),
        ({"instructions": "ab"}, "list of 2"),
        ({"instructions": np.array("ab")}, "list of 2"),
        ({"instructions": [TV, "Lovely weather today."]}, "asks for nothing"),
        ({"instructions": [TV, " "]}, "empty"),
        ({"instructions": [TV, GO], "placement": {"pan": "tv"}}, "nothing can lie"),
        ({"instructions": [TV, None], "instruction": GO}, "two instructions"),
        ("x", "options is 'x'; expected a mapping"),
        ({"placement": {None: "desk"}}, "placement: None is no thing of this house; known: pen_1, "),
    ],
    ids=str,
)
def test_a_refused_reset_of_several_resets_none(options, says):
    envs, undisturbed = (gym.make_vec(HOUSEHOLD, num_envs=2, instruction=GO) for _ in range(2))
    for each in (envs, undisturbed):
        each.reset(seed=0)
        each.action_space.seed(0)
    with pytest.raises(InputError, match=says):
        envs.reset(seed=5, options=options)
    actions = envs.action_space.sample() | {"interact": np.zeros(2, dtype=np.int64)}
    assert data_equivalence(envs.step(actions), undisturbed.step(actions), exact=True)
    assert data_equivalence(envs.reset(), undisturbed.reset(), exact=True)


def test_the_rehearsal_of_a_first_reset_without_a_seed_draws_what_the_reset_draws(monkeypatch):
    drawn = []
    prepare = HouseholdEnv._prepare

    def noted(self, seed, options, instruction):
        drawn.append((id(self), str(self.np_random.bit_generator.state) if seed is None else seed))
        return prepare(self, seed, options, instruction)

    monkeypatch.setattr(HouseholdEnv, "_prepare", noted)
    envs = gym.make_vec(
        HOUSEHOLD, num_envs=2, instruction="Go to the kitchen.", vectorization_mode="vector_entry_point"
    )
    envs.reset()
    assert len(drawn) == 4
    assert sorted(drawn[:2]) == sorted(drawn[2:])
    envs.close()


@pytest.mark.parametrize("cause", ["instruction", "full house"])
def test_a_reset_that_is_refused_without_options_resets_none(cause, monkeypatch):
    envs, undisturbed = (gym.make_vec(HOUSEHOLD, num_envs=2, instruction=GO) for _ in range(2))
    for each in (envs, undisturbed):
        each.reset(seed=0)
        each.action_space.seed(0)
    if cause == "instruction":
        envs.set_attr("instruction", [GO.text, "Bring me the elephant."])
    else:
        spots = envs.envs[0].unwrapped.setting.spots
        free = iter([spots.robot, lambda *_: ()])  # the first finds room, the second none
        monkeypatch.setattr(spots, "robot", lambda *around: next(free)(*around))
    with pytest.raises(InputError, match=r"elephant|finds no free spot"):
        envs.reset(seed=5)
    monkeypatch.undo()
    actions = envs.action_space.sample() | {"interact": np.zeros(2, dtype=np.int64)}
    assert data_equivalence(envs.step(actions), undisturbed.step(actions), exact=True)


def test_several_environments_undo_their_instructions_together():
    envs = gym.make_vec(HOUSEHOLD, num_envs=2, instruction=GO)
    envs.reset(seed=0, options={"instruction": None, "instructions": [TV, None]})
    assert [env.unwrapped.instruction for env in envs.envs] == [TV.text, None]
    with pytest.raises(InputError, match="attic"):
        envs.reset(seed=0, options={"instruction": None, "people": {"user": "attic"}})
    assert [env.unwrapped.instruction for env in envs.envs] == [TV.text, None]
    envs.reset(seed=0, options={"instruction": None})
    assert [env.unwrapped.instruction for env in envs.envs] == [None, None]
    envs.close()


@pytest.mark.parametrize("options", [None, {"instructions": [TV, GO]}])
def test_several_environments_need_as_many_seeds(options):
    envs = gym.make_vec(HOUSEHOLD, num_envs=2, instruction=GO)
    with pytest.raises(InputError, match=r"seed is \[1\]; expected a list of 2"):
        envs.reset(seed=[1], options=options)
    assert envs.reset(seed=[1, None], options=options)


def test_what_is_masked_keeps_its_instruction():
    made = partial(gym.make, HOUSEHOLD, instruction=GO)
    envs = HouseholdVectorEnv([made, made], autoreset_mode=AutoresetMode.DISABLED)
    envs.reset(seed=0)
    envs.reset(options={"reset_mask": np.array([True, False]), "instructions": [TV, "Lovely weather today."]})
    assert [env.unwrapped.instruction for env in envs.envs] == [TV.text, GO.text]
    envs.close()


def test_a_reset_can_be_checked_without_one():
    env, undisturbed = HouseholdEnv(GO, size="small"), HouseholdEnv(GO, size="small")
    for each in (env, undisturbed):
        each.reset(seed=0)
    env.check_reset(seed=5, options={"instruction": TV, "house_seed": 3})
    with pytest.raises(InputError, match="attic"):
        env.check_reset(options={"people": {"user": "attic"}})
    assert data_equivalence(env.step(REST), undisturbed.step(REST), exact=True)
    assert data_equivalence(env.reset(), undisturbed.reset(), exact=True)


def test_flat_spaces_hold_the_same():
    flat, full = gym.make(HOUSEHOLD_FLAT, instruction=GO).unwrapped, HouseholdEnv(GO)
    vector, observation = flat.reset(seed=2)[0], full.reset(seed=2)[0]
    for key, part in flat.parts.items():
        if key != "result":
            assert np.array_equal(vector[part], np.asarray(observation[key], dtype=np.float32).ravel())
    flat.step(np.array([8, 4, 0, 0]))
    full.step({"drive": (1.0, 0.0), "interact": 0, "target": 0})
    assert flat.world.robot == full.world.robot


def test_the_body_knows_the_map_and_not_the_world():
    body = HouseholdEnv(GO).embodiment()
    assert body.house == load_domain("household").house
    assert not any("world" in name for name in vars(body))


def test_resets_leave_nothing_behind():
    env = HouseholdEnv(TV)
    for seed in range(120):  # until what is remembered of the house has been asked for
        env.reset(seed=seed)
    gc.collect()
    before = len(gc.get_objects())
    for seed in range(120):
        env.reset(seed=seed)
    gc.collect()
    assert len(gc.get_objects()) - before < 60


# -- what is read when ------------------------------------------------------------------------------------------------


def test_making_one_reads_no_house_and_loads_nothing_for_it():
    code = (
        "import sys, gymnasium, decomplex_bt; env = gymnasium.make('decomplex_bt/Household-v0');"
        "heavy = {'yaml', 'pydantic', 'pymunk', 'scipy', 'networkx', 'PIL', 'rapidfuzz', 'spacy'} & set(sys.modules);"
        "assert not heavy, heavy; assert env.observation_space.sample(); assert 'yaml' in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_what_is_named_is_checked_at_once(tmp_path):
    broken = tmp_path / "house.yaml"
    broken.write_text("rooms: [")
    named = {"house": broken}, {"domain": tmp_path}, {"domain": "castle"}, {"size": "tiny"}, {"house_seed": 1}
    for arguments in named:
        with pytest.raises(InputError):
            gym.make(HOUSEHOLD, **arguments)


def test_an_action_without_a_skill_is_named_at_once(tmp_path):
    for path in load_domain("household").folder.glob("*.*"):
        shutil.copy(path, tmp_path)
    text = (tmp_path / "domain.pddl").read_text(encoding="utf-8")
    (tmp_path / "domain.pddl").write_text(text.replace("(:action stow", "(:action juggle"), encoding="utf-8")
    with pytest.raises(DataFileError, match=r"domain\.pddl: action juggle: the robot has no skill for it; it has move"):
        gym.make(HOUSEHOLD, domain=tmp_path)


def test_one_that_was_never_reset_survives_pickling():
    env = pickle.loads(pickle.dumps(HouseholdEnv(size="small", house_seed=3)))
    assert env.entities == HouseholdEnv(size="small", house_seed=3).entities
    assert pickle.loads(pickle.dumps(HouseholdEnv())).entities == HouseholdEnv().entities


# -- the configuration ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("config", "says"),
    [
        ({"reward": "sparse"}, "reward is 'sparse'; expected one of success, progress"),
        ({"max_seconds": float("nan")}, "max_seconds is nan"),
        ({"max_seconds": -1}, "max_seconds is -1"),
        ({"max_seconds": "x"}, "max_seconds is 'x'"),
        ({"balance": 5}, "balance is 5; expected a number from 0 to 0.5"),
        ({"balanse": 0.1}, "config: unknown 'balanse'; the nearest known: balance"),
        ({"world": {"substeps": 0}}, "substeps is 0; expected a whole number from 1"),
        ({"world": {"tray_slots": -1}}, "tray_slots is -1"),
        ({"world": {"max_speed": 0}}, "max_speed is 0; expected a number above 0"),
        ({"world": {"reach": float("inf")}}, "reach is inf"),
        ({"world": {"max_speed": 5.0}}, "max_speed is 5.0; expected a number above 0 to 2"),
        ({"world": {"substep": 0.5}}, "substep is 0.5; expected a number above 0 to 0.05"),
        ({"sensing": {"looks": 10**9}}, "looks is 1000000000; expected a whole number from 1 to 1000"),
        ({"world": 3}, "world is 3; expected a WorldConfig or a mapping"),
        ({"sensing": {"every": 1.5}}, "every is 1.5"),
        ({"sensing": {"field_of_view": 720}}, "above 0 to 360"),
        ("fast", "config is 'fast'"),
    ],
    ids=str,
)
def test_a_configuration_that_cannot_be_is_refused_at_once(config, says):
    with pytest.raises(InputError, match=says):
        gym.make(HOUSEHOLD, config=config)


def test_nothing_comes_through_a_wall_at_the_bounds_of_a_configuration():
    world = {"substep": 0.05, "max_speed": 2.0, "max_acceleration": 20.0, "max_turn_rate": 10.0}
    env = gym.make(HOUSEHOLD, instruction="Go to the kitchen.", config={"world": world})
    rng = np.random.default_rng(0)
    for seed in range(4):
        env.reset(seed=seed)
        for step in range(120):
            drive = rng.uniform(-1, 1, 2) if step % 40 == 0 else (1.0, rng.uniform(-0.2, 0.2))
            action = {"drive": np.array(drive, dtype=np.float32), "interact": 0, "target": 0}
            observation, _, terminated, truncated, _ = env.step(action)
            assert observation in env.observation_space
            if terminated or truncated:
                break


def test_what_a_config_holds_is_named_so_where_it_is_given_as_an_argument():
    with pytest.raises(InputError, match=r"reward: .* a field of its config; .*config=\{'reward': 'progress'\}"):
        gym.make(HOUSEHOLD, reward="progress")


def test_a_configuration_is_a_value_or_a_mapping_of_plain_values():
    config = HouseholdConfig(max_seconds=np.int64(5), reward="progress", world=WorldConfig(tray_slots=2))
    assert type(config.max_seconds) is float
    assert HouseholdEnv(config=config).config == config
    assert HouseholdEnv(config={"max_seconds": 5, "reward": "progress", "world": {"tray_slots": 2}}).config == config
