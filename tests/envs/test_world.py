"""The world moves as bodies do, and nothing in it teleports."""

from __future__ import annotations

from math import cos, hypot, pi, sin

import numpy as np
import pytest

from decomplex_bt.envs.config import MAX_SPEED, MAX_SUBSTEP, WorldConfig
from decomplex_bt.envs.interface import Interaction, Result

SOUTH_OF_BEDROOM_DOOR = (3.2, 3.2)


def test_robot_reaches_its_top_speed_within_its_acceleration(trial):
    t = trial(at=(1.0, 4.6), facing=(9.0, 4.6))
    speeds = []
    for _ in range(20):
        t.drive(1.0)
        speeds.append(t.world.speed)
    assert speeds[0] == pytest.approx(0.15, abs=0.01)
    assert max(speeds) == pytest.approx(1.0, abs=0.01)
    assert np.diff([0.0, *speeds]).max() <= 0.15 + 1e-6


def test_two_seconds_at_half_speed_are_a_metre_less_the_start(trial):
    t = trial(at=(1.0, 4.6), facing=(9.0, 4.6))
    t.drive(0.5, steps=20)
    assert t.world.robot[0] - 1.0 == pytest.approx(0.5 * 2 - 0.5**2 / (2 * 1.5), abs=0.06)
    assert t.world.robot[1] == pytest.approx(4.6, abs=0.01)


@pytest.mark.parametrize(("state", "ends_in_hallway"), [("closed", False), ("open", True)])
def test_a_closed_door_blocks_and_an_open_one_lets_through(trial, state, ends_in_hallway):
    t = trial(at=SOUTH_OF_BEDROOM_DOOR, facing=(3.2, 4.6), states={"bedroom_door": state})
    t.drive(0.8, steps=30)
    assert (t.world.robot[1] > 4.2) is ends_in_hallway
    assert ends_in_hallway or t.world.robot[1] < 3.9 - 0.03 - 0.22 + 0.01


def test_opening_a_door_lets_the_robot_through(trial):
    t = trial(at=SOUTH_OF_BEDROOM_DOOR, facing=(3.2, 4.6), states={"bedroom_door": "closed"})
    assert t.do(Interaction.OPEN, "bedroom_door") is Result.OK
    t.drive(0.8, steps=30)
    assert t.world.robot[1] > 4.2


def test_a_door_does_not_close_on_the_robot(trial):
    t = trial(at=(3.2, 3.9), states={"bedroom_door": "open"})
    assert t.do(Interaction.CLOSE, "bedroom_door") is Result.NO_ROOM


def test_walls_and_furniture_stop_the_robot(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0))
    t.drive(1.0, steps=40)
    assert t.world.robot[1] < 6.7 - 0.22 + 0.02, "the kitchen table's south edge is at 6.7"


def test_things_on_the_floor_are_pushed_and_come_to_rest(trial):
    t = trial(at=(1.0, 4.6), facing=(9.0, 4.6), placement={"ball": "hallway_floor"})
    row = t.row["ball"]
    t.world._drop_body(row)
    t.world.lay(row, t.row["hallway_floor"], (2.0, 4.6))
    t.drive(1.0, steps=20)
    assert t.world.position[row, 0] > 2.2
    t.drive(0.0, steps=30)
    before = t.world.position[row].copy()
    t.drive(0.0, steps=10)
    assert np.allclose(before, t.world.position[row], atol=1e-4)
    assert t.place("ball") == "hallway_floor"


def test_a_thing_pushed_into_another_room_lies_on_its_floor(trial):
    t = trial(at=(6.0, 4.4), facing=(6.0, 9.0), placement={"ball": "hallway_floor"})
    row = t.row["ball"]
    t.world._drop_body(row)
    t.world.lay(row, t.row["hallway_floor"], (6.0, 5.0))
    t.drive(0.6, steps=25)
    assert t.place("ball") == "living_room_floor"


def test_things_on_furniture_are_no_obstacle_and_do_not_move(trial):
    t = trial(at=(6.5, 7.9), facing=(9.0, 7.9), placement={"laptop": "coffee_table"})
    before = t.world.position.copy()
    t.drive(0.3, steps=10)
    lying = list(t.world.geometry.thing_rows)
    assert np.array_equal(before[lying], t.world.position[lying], equal_nan=True)


def test_what_is_carried_goes_along(trial):
    t = trial(at=(9.2, 6.7), facing=(9.2, 7.3), placement={"remote": "coffee_table"})
    assert t.do(Interaction.PICK, "remote") is Result.OK
    t.drive(-0.5, 0.5, steps=10)
    assert hypot(*(t.world.position[t.row["remote"]] - t.world.robot)) < 1e-6


def test_nothing_moves_faster_than_the_robot_between_two_steps(trial):
    t = trial(at=(9.2, 6.7), facing=(9.2, 7.3))
    rng = np.random.default_rng(3)
    for _ in range(100):
        before = t.world.position.copy()
        t.drive(*rng.uniform(-1, 1, 2))
        moved = np.nan_to_num(np.abs(t.world.position - before)).max()
        assert moved < 0.15


@pytest.mark.parametrize("turn", [0.0, 1.0])
def test_without_a_drive_the_robot_stands_within_a_step_and_stays(trial, turn):
    t = trial(at=(1.0, 4.6), facing=(9.0, 4.6))
    t.drive(1.0, turn, steps=8)
    t.drive(0.0)
    assert (t.world.speed, t.world.turn_rate) == (0.0, 0.0)
    here = t.world.robot
    t.drive(0.0, steps=5)
    assert t.world.robot == here


def test_who_was_pushed_sideways_does_not_slide_on(trial):
    t = trial(at=(2.0, 4.6), facing=(2.0, 9.0))
    t.world._robot.velocity = 0.5, 0.0
    t.drive(0.0, steps=2)
    here = t.world.robot
    t.drive(0.0, steps=5)
    assert t.world.robot == here


EAST_WALL, STUDY_WALL, BEDROOM_DOOR = (11.6, 4.6, 0.0), (10.9, 4.2, -pi / 2), (3.2, 4.15, -pi / 2)


@pytest.mark.parametrize("spot", [EAST_WALL, STUDY_WALL, BEDROOM_DOOR], ids=["outer wall", "inner wall", "door"])
@pytest.mark.parametrize(
    "config",
    [
        WorldConfig(),
        WorldConfig(substep=0.04, substeps=3),
        WorldConfig(substep=MAX_SUBSTEP, substeps=2),
        WorldConfig(max_speed=MAX_SPEED, max_acceleration=20.0),
        WorldConfig(max_speed=MAX_SPEED, max_acceleration=20.0, substep=MAX_SUBSTEP, substeps=2),
    ],
    ids=["default", "0.04 s", "0.05 s", "2 m/s", "2 m/s, 0.05 s"],
)
def test_what_is_pushed_against_a_wall_at_full_speed_does_not_come_through(trial, config, spot):
    t = trial(at=(6.0, 4.6), states={"bedroom_door": "closed"}, config=config)
    world, rng = t.world, np.random.default_rng(0)
    x, y, heading = spot
    ahead = cos(heading), sin(heading)
    for thing in ("pen_1", "pencil", "keys", "apple"):
        row = t.row[thing]
        for _ in range(20):
            aside = rng.uniform(-0.06, 0.06)
            world.shift(row, t.row["hallway_floor"], (x - aside * ahead[1], y + aside * ahead[0]))
            set_going(world, (x - 0.6 * ahead[0], y - 0.6 * ahead[1]), heading + rng.uniform(-0.25, 0.25))
            for step in range(round(3.0 / config.step_seconds)):
                was = world.position[row].tolist()
                world.drive(1.0 if step % 20 < 17 else -0.5, rng.uniform(-0.3, 0.3))
                assert world.geometry.is_free_line(was, world.position[row].tolist(), world.closed_leaves)
                assert 0 <= world.position[row].min() <= world.position[row].max() <= 12
        world.shift(row, t.row["desk"], (11.3, 1.3))


def set_going(world, point, heading):
    """Puts the robot somewhere, at full speed."""
    body, speed = world._robot, world.config.max_speed
    body.position, body.angle = point, heading
    body.velocity, body.angular_velocity = (speed * cos(heading), speed * sin(heading)), 0.0
    world.space.reindex_shapes_for_body(body)
    world._read()


def test_same_start_and_actions_give_the_same_world_under_any_hash_seed(printed_under_hash_seeds):
    script = (
        "import numpy as np, decomplex_bt, gymnasium as gym, zlib\n"
        "from decomplex_bt.instruction import Instruction\n"
        "env = gym.make('decomplex_bt/Household-v0').unwrapped\n"
        "env.reset(seed=11)\n"
        "rng = np.random.default_rng(0); total = 0\n"
        "for k in range(150):\n"
        "    interact, target = int(rng.integers(12)), int(rng.integers(116))\n"
        "    action = {'drive': rng.uniform(-1, 1, 2), 'interact': interact, 'target': target}\n"
        "    o, r, te, tr, i = env.step(action)\n"
        "    for key in ('robot', 'entities', 'held'): total = zlib.crc32(o[key].tobytes(), total)\n"
        "print(total, i['instruction'])\n"
    )
    assert len(printed_under_hash_seeds(script)) == 1
