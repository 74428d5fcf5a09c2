"""Somebody else who moves things: from a seed apart, and never so that the instruction becomes impossible."""

from __future__ import annotations

import gymnasium as gym
import numpy as np
import pytest

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.envs.chance import APERTURE
from decomplex_bt.envs.doubles import DOMAIN, Episode, HandWorld, task
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.judge import Judge
from decomplex_bt.errors import InputError

assert decomplex_bt
ONTOLOGY = DOMAIN.ontology
REST = {"drive": np.zeros(2, dtype=np.float32), "interact": int(Interaction.NONE), "target": 0}
UNTIDY = ("shoes", "ball", "towel", "blanket", "shirt", "socks", "bag", "umbrella")
IN_THE_KITCHEN = (7, 9, 12, 15)
"""Seeds with which the robot starts there."""
FETCH = read_markup("[Bring](1:bringing) [me](1:recipient) [the towel](1:object).", ONTOLOGY, flow=[1])


@pytest.fixture(scope="module")
def env():
    return gym.make("decomplex_bt/Household-v0")


def rest(env, seed, steps=300, **options):
    """Where everything lies after a time in which the robot does nothing, with what was told of it."""
    _, info = env.reset(seed=seed, options={"instruction": FETCH, "noise": False, **options})
    start, told = env.unwrapped.world.place.copy(), []
    for _ in range(steps):
        _, _, terminated, truncated, info = env.step(REST)
        told += info["events"]
        assert not terminated
        assert not truncated
    return start, env.unwrapped.world, told, info


def test_things_are_moved_the_same_way_from_the_same_seed(env):
    start, world, told, info = rest(env, 3, meddling=20.0)
    assert 3 <= info["moved_by_others"] == len(told) <= 20
    assert all(line.startswith("someone moves ") for line in told)
    assert (world.place != start).any()
    assert any("towel" in line for line in told), "what the instruction is about is moved more often than others"
    again = rest(env, 3, meddling=20.0)
    assert again[2] == told
    assert rest(env, 3)[2] == []


def test_the_world_is_drawn_as_if_nobody_meddled(env):
    assert np.array_equal(rest(env, 5, steps=1)[0], rest(env, 5, steps=1, meddling=60.0)[0])


def test_things_stay_in_the_house_at_places_that_suit_them_and_the_instruction_possible(env):
    start, world, _, info = rest(env, 7, steps=600, meddling=60.0)
    prior = world.prior
    moved = [row for row in world.geometry.thing_rows if world.place[row] != start[row]]
    assert len(moved) > 10
    for row in moved:
        rows, weights = prior.places(row)
        assert weights[rows == world.place[row]].sum() > 0
        assert world.room[row] == world.geometry.place_room[world.place[row]]
    assert info["feasible"]


def test_what_somebody_else_does_out_of_view_is_not_observed():
    """Two episodes that differ in meddling alone look the same but for what was in view in one since it was moved."""
    envs = [gym.make("decomplex_bt/Household-v0").unwrapped for _ in range(2)]
    names = envs[0].entities
    options = {"instruction": FETCH, "noise": False, "placement": dict.fromkeys(UNTIDY, "kitchen_floor")}
    turn = {**REST, "drive": np.array([0.0, 1.0], dtype=np.float32)}
    remembered = 0
    for seed in IN_THE_KITCHEN:
        for env, rate in zip(envs, (0, 60), strict=True):
            env.reset(seed=seed, options={**options, "meddling": rate})
        moved, seen = set(), set()
        for step in range(200):
            (one, *_), (other, *_, info) = (env.step(turn if step < 30 or step >= 150 else REST) for env in envs)
            moved |= {event.split()[2] for event in info["events"]}
            seen |= {name for name in moved if any(is_in_view(env, name) for env in envs)}
            rows = np.flatnonzero((one["entities"] != other["entities"]).any(axis=1))
            assert {names[row] for row in rows} <= seen
            remembered += sum(bool(one["entities"][names.index(name), 0]) for name in moved - seen)
    assert remembered > 10, "something was moved while it was remembered"


def is_in_view(env, name):
    sensor = env._episode.sensor
    return bool(sensor._tracked[sensor.world.geometry.row[name] - sensor.world.geometry.place_count])


def test_an_episode_with_somebody_else_in_the_house_replays(env):
    rest(env, 4, steps=120, meddling=40.0)
    state, place = env.unwrapped.state_dict(), env.unwrapped.world.place.copy()
    other = gym.make("decomplex_bt/Household-v0").unwrapped
    other.load_state_dict(state)
    assert np.array_equal(other.world.place, place)


def test_a_rate_out_of_range_is_refused(env):
    with pytest.raises(InputError, match="meddling is -1"):
        env.reset(options={"instruction": FETCH, "meddling": -1})


def test_what_somebody_else_brings_about_is_no_fault_of_the_robot():
    flow = [{"if": 1, "then": [2]}]
    tasks = task(1, "check_state", "tv", state="on"), task(2, "placing", "pen_1", goal="desk")
    episode = Episode(HandWorld({"pen_1": "couch"}), flow, *tasks)
    episode.world.places["pen_1"] = "desk"
    episode.monitor.take_in("pen_1")
    episode.do(Interaction.OPEN, "window")
    assert not any("task 2" in violation.reason for violation in episode.verdict.violations)


def test_a_condition_is_judged_by_where_somebody_else_has_put_the_thing():
    flow = [{"if": 1, "then": [2]}]
    tasks = task(1, "searching", "pen_1", at=["desk"]), task(2, "bringing", "pen_1", recipient="user")
    episode = Episode(HandWorld({"pen_1": "desk"}), flow, *tasks)
    episode.world.places["pen_1"] = "couch"
    episode.monitor.take_in("pen_1")
    episode.inspect("desk")
    assert episode.truths == [(1, False, None)]


DOOR = ("bedroom_door", "aperture")
LATER_DOOR = task(1, "motion", goal="kitchen"), task(2, "change_state", "bedroom_door", state="open")


def test_what_has_come_about_since_the_robot_last_did_something_is_not_its_doing():
    episode = Episode(HandWorld({"ball": "hallway_floor"}), [1, 2], *LATER_DOOR)
    episode.world.states[DOOR] = "open"
    episode.monitor.brace()
    assert not episode.take("ball").is_over


def test_what_others_do_after_the_robot_in_the_same_step_is_not_its_doing():
    episode = Episode(HandWorld({"ball": "robot"}), [1, 2], *LATER_DOOR)
    episode.monitor.note_deed()
    episode.world.states[DOOR] = "open"
    assert not episode.put("ball", "hallway_floor").is_over


def test_what_the_robot_does_is_its_doing_whatever_others_do_after_it():
    tasks = task(1, "motion", goal="kitchen"), task(2, "change_state", "tv", state="on")
    episode = Episode(HandWorld(), [1, 2], *tasks)
    episode.monitor.brace()
    episode.world.states["tv", "power"] = "on"
    episode.monitor.note_deed()
    episode.world.states[DOOR] = "open"
    episode.monitor.take_in("bedroom_door")
    (violation,) = episode.do(Interaction.SWITCH_ON, "tv").violations
    assert violation.task == 2


def test_a_condition_is_judged_by_the_door_that_somebody_else_has_opened():
    flow = [{"if": 1, "then": [2], "else": [3]}]
    check = task(1, "check_state", "bedroom_door", state="closed")
    episode = Episode(HandWorld(), flow, check, task(2, "motion", goal="study"), task(3, "motion", goal="kitchen"))
    episode.world.states[DOOR] = "open"
    episode.monitor.take_in("bedroom_door")
    episode.see("bedroom_door")
    assert episode.truths == [(1, False, "else")]


LATER = read_markup(
    "[Go](1:motion) [to the kitchen](1:goal), then [open](2:change_state) [the bedroom door](2:object).",
    ONTOLOGY,
    flow=[1, 2],
)


@pytest.mark.parametrize("earlier", [0, 3])
def test_a_door_that_somebody_opens_on_their_way_is_not_the_robots_doing(env, monkeypatch, earlier):
    options = {"instruction": LATER, "noise": False, "states": {"bedroom_door": "closed"}, "people": {"user": "study"}}
    env.reset(seed=0, options=options)
    world = env.unwrapped.world
    ball, robot = world.geometry.row["ball"], world.geometry.robot_row
    world.lift(ball, robot)
    world.held = ball

    def opens(world):
        world.set_state(world.geometry.row["bedroom_door"], APERTURE, 1)
        return ["bedroom_door"]

    world.walks[world.geometry.user_row] = None  # somebody is on their way
    stow = {**REST, "interact": int(Interaction.PLACE), "target": robot}
    for action in [*[REST] * earlier, stow]:
        walk = opens if world.steps == 0 else lambda world: []
        monkeypatch.setattr("decomplex_bt.envs.episode.advance", walk)
        _, _, terminated, _, info = env.step(action)
    assert info["result"] == "ok"
    assert not terminated
    assert info["violations"] == []


def test_what_all_are_meant_of_by_where_they_lie_is_left_there():
    text = "[Bring](1:bringing) [me](1:recipient) [everything](1:object) [from the desk](1:source)."
    assert "towel" in Judge(read_markup(text, ONTOLOGY, flow=[1]), DOMAIN, judged_by="gold").settled
    assert not Judge(FETCH, DOMAIN, judged_by="gold").settled
