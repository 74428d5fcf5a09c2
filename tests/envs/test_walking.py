"""People lead the way when they are asked to."""

from __future__ import annotations

from math import dist, hypot

import pytest

from decomplex_bt.envs.floorplan import floorplan_of
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.navigation import Driver, Limits, Pose
from decomplex_bt.envs.walking import advance, open_doors

ANNA_ONLY = {"user": "study", "anna": "living_room", "tom": None, "guest": None}


@pytest.fixture
def beside_anna(trial):
    """The robot a metre from Anna, in the living room."""
    t = trial(at=(6.0, 5.8), people=ANNA_ONLY)
    x, y = t.world.position[t.row["anna"]].tolist()
    dx, dy = 6.0 - x, 5.8 - y
    away = hypot(dx, dy)
    t.world._robot.position = (x + dx / away, y + dy / away)
    t.drive(0.0)
    return t


def walk(t, steps, follow=True):
    """Steps in which the robot drives after Anna, if it follows."""
    plan = floorplan_of(t.world.geometry.house, t.world.geometry.kinds)
    anna, driver = t.row["anna"], None
    for step in range(steps):
        advance(t.world)
        forward = turn = 0.0
        if follow:
            x, y = t.world.position[anna].tolist()
            if step % 10 == 0:
                driver = Driver(plan, plan.cells_around(x, y, nearest=0.5, farthest=0.9, room=None), Limits())
            heading = float(t.world.heading[-1])
            forward, turn = driver.steer(Pose(*t.world.robot, heading, t.world.speed, t.world.turn_rate)).drive
        t.drive(forward, turn)


def test_a_person_walks_to_the_room_asked_for_and_stays(beside_anna):
    t = beside_anna
    assert t.do(Interaction.SAY, "kitchen_floor") is Result.OK
    assert (t.world.event.person, t.world.event.goal) == ("anna", "kitchen_floor")
    walk(t, 300)
    rooms = t.world.geometry.rooms
    t.world.locate()
    assert rooms[t.world.room[t.row["anna"]]] == "kitchen"
    assert not t.world.walks
    assert t.world.geometry.room_at(*t.world.robot) == rooms.index("kitchen")


def test_a_person_stands_where_the_robot_still_gets_past_them(beside_anna):
    t = beside_anna
    t.do(Interaction.SAY, "hallway_floor")
    end = t.world.walks[t.row["anna"]].end
    walk(t, 300)
    assert not t.world.walks
    assert dist(t.world.position[t.row["anna"]].tolist(), end) < 0.06


@pytest.mark.parametrize("seed", [0, 5, 14])
def test_the_robot_gets_to_a_place_past_who_led_it_into_the_room(seed):
    env = HouseholdEnv("Follow Anna to the front door and open it.")
    observation, info = env.reset(seed=seed)
    oracle = env.policy("oracle")
    oracle.reset(observation, info)
    terminated = truncated = False
    while not (terminated or truncated):
        observation, _, terminated, truncated, info = env.step(oracle.act(observation))
    assert info["feasible"]
    assert info["is_success"]


def test_a_person_waits_for_a_robot_that_stays_behind(beside_anna):
    t = beside_anna
    t.do(Interaction.SAY, "kitchen_floor")
    walk(t, 200, follow=False)
    away = hypot(*(t.world.position[t.row["anna"]] - t.world.robot))
    assert 2.5 < away < 3.3
    assert t.world.walks


def test_a_walker_keeps_a_pace_of_a_walker(beside_anna):
    t = beside_anna
    t.do(Interaction.SAY, "kitchen_floor")
    for _ in range(40):
        before = t.world.position[t.row["anna"]].copy()
        walk(t, 1)
        assert hypot(*(t.world.position[t.row["anna"]] - before)) <= 0.081


def test_a_walker_opens_doors(beside_anna):
    t = beside_anna
    t.world.set_state(t.row["bathroom_door"], 1, 0)
    assert t.do(Interaction.SAY, "bathroom_floor") is Result.OK
    walk(t, 300)
    assert t.state("bathroom_door", 1) == 1
    t.world.locate()
    assert t.world.geometry.rooms[t.world.room[t.row["anna"]]] == "bathroom"


@pytest.mark.parametrize("before", [0.05, 0.0])
def test_a_door_close_behind_a_corner_is_opened_before_the_corner_is_reached(trial, before):
    t = trial(at=(2.2, 6.0), people=ANNA_ONLY)
    t.world.set_state(t.row["bedroom_door"], 1, 0)
    ax, ay, bx, by = t.world.geometry.leaves["bedroom_door"]
    x, y = (ax + bx) / 2, (ay + by) / 2
    open_doors(t.world, [(x, y + 0.3), (x, y + before), (x, y - 1.0)])  # a person's body keeps them 0.25 m away
    assert t.state("bedroom_door", 1) == 1


def test_who_is_there_already_says_so(beside_anna):
    assert beside_anna.do(Interaction.SAY, "living_room_floor") is Result.ALREADY


def test_nobody_near_nobody_leads(trial):
    t = trial(at=(2.2, 6.0), people=ANNA_ONLY)
    assert t.do(Interaction.SAY, "study_floor") is Result.OUT_OF_REACH


def test_wherever_they_like_is_another_room(beside_anna):
    assert beside_anna.do(Interaction.SAY, "robot") is Result.OK
    assert beside_anna.world.event.goal not in (None, "living_room_floor", "robot")


def test_what_a_walker_has_goes_along(beside_anna):
    t = beside_anna
    t.world.lift(t.row["keys"], t.row["anna"])
    t.do(Interaction.SAY, "hallway_floor")
    walk(t, 60)
    assert hypot(*(t.world.position[t.row["keys"]] - t.world.position[t.row["anna"]])) < 1e-6
