"""The household environment keeps the Gymnasium contract, to the letter."""

from __future__ import annotations

import gc
import pickle
import re
import shutil
import subprocess
import sys
import warnings

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env, data_equivalence

import decomplex_bt  # noqa: F401 - registers the environments
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.household import HouseholdConfig, HouseholdEnv
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.registration import HOUSEHOLD, HOUSEHOLD_FLAT, register_envs
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
    rng = np.random.default_rng(seed)
    for _ in range(steps):
        yield env.step(
            {
                "drive": rng.uniform(-1, 1, 2).astype(np.float32),
                "interact": int(rng.integers(12)),
                "target": int(rng.integers(len(env.entities))),
            }
        )


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


def test_a_replay_that_departs_says_where():
    env = HouseholdEnv(GO)
    env.reset(seed=4)
    list(rollout(env, 60))
    state = env.state_dict()
    HouseholdEnv().load_state_dict(state)
    state["checksums"] = (*state["checksums"][:-1], 0)
    with pytest.raises(InputError, match="step 50"):
        HouseholdEnv().load_state_dict(state)


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
        ({"placement": {"pan": "tv"}}, "nothing can lie"),
        ({"states": {"tv": "open"}}, "tv cannot be open"),
        ({"people": {"anna": "attic"}}, "attic"),
        ({"people": {"user": None}}, "always at home"),
        ({"broken": ["couch"]}, "couch"),
        ({"balance": 0.7}, "0.7"),
        ({"noise": "no"}, "True or False"),
        ({"reward": "gold"}, "success, progress"),
        ({"instruction": "  "}, "empty"),
        ({"instruction": "a" * 2001}, "2001"),
        ({"instruction": 7}, "int"),
    ],
    ids=str,
)
def test_options_that_cannot_be_used_are_refused(options, says):
    with pytest.raises(ValueError, match=says):
        HouseholdEnv(GO).reset(seed=0, options=options)


@pytest.mark.parametrize(
    "options",
    [{"house_seed": 1}, {"instruction": "Lovely weather today."}, {"instruction": TV, "placement": {"pan": "tv"}}],
    ids=str,
)
def test_a_refused_reset_changes_nothing(options):
    env, undisturbed = HouseholdEnv(GO), HouseholdEnv(GO)
    for each in (env, undisturbed):
        each.reset(seed=0)
    with pytest.raises(InputError):
        env.reset(options=options)
    assert env.instruction == GO.text
    for mine, yours in zip(rollout(env, 20), rollout(undisturbed, 20), strict=True):
        assert data_equivalence(mine, yours, exact=True)
    assert data_equivalence(env.reset(seed=1), undisturbed.reset(seed=1), exact=True)
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


def test_without_chance_all_seeds_have_the_same_house():
    env = HouseholdEnv(GO)
    places = []
    for seed in (1, 2):
        env.reset(seed=seed, options={"chance": False})
        places.append((env.world.place.tolist(), env.world.states.tolist()))
        assert env.world.grasp_slip == 0
    assert places[0] == places[1]


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
        {"drive": (0, 0), "interact": 99, "target": 0},
        {"drive": (0, 0), "interact": 0, "target": -1},
        {"drive": (float("nan"), 0), "interact": 0, "target": 0},
        {"drive": (0,), "interact": 0, "target": 0},
        {},
    ],
    ids=str,
)
def test_what_is_no_action_is_refused(bad):
    env = HouseholdEnv(GO)
    env.reset(seed=0)
    with pytest.raises(InputError, match="no action"):
        env.step(bad)


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
    with pytest.raises(InputError, match="list of 2"):
        envs.reset(options={"instructions": [GO]})
    for refused in ([TV, "Lovely weather today."], [TV, " "]):
        with pytest.raises(InputError):
            envs.reset(options={"instructions": refused})
        assert list(envs.reset(seed=2)[1]["instruction"]) == [GO.text, TV.text]
    envs.close()


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
