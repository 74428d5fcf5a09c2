"""What the robot can do with its hand, and why it cannot."""

from __future__ import annotations

import pytest

from decomplex_bt.envs.chance import APERTURE, POWER, TEMPERATURE
from decomplex_bt.envs.hands import CLEANLINESS, FILL
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.world import NOTHING

AT_COUNTER = (2.9, 8.0)
AT_FRIDGE = (0.5, 7.9)
AT_TABLE = (2.2, 7.8)
AT_TRASH = (3.6, 6.15)
AT_DISHWASHER = (3.4, 6.85)


def hold(t, thing):
    t.world.lift(t.row[thing], t.world.geometry.robot_row)
    t.world.held = t.row[thing]


def test_pick_and_place(trial):
    t = trial(at=AT_TABLE, placement={"apple": "kitchen_table"})
    assert t.do(Interaction.PICK, "apple") is Result.OK
    assert t.place("apple") == "robot"
    assert t.do(Interaction.PLACE, "counter") is Result.OK
    assert t.place("apple") == "counter"
    assert t.world.held == NOTHING


def test_a_thing_is_put_where_nothing_else_lies(trial):
    t = trial(at=AT_TABLE, placement={"plate_1": "kitchen_table", "plate_2": "kitchen_table", "bread": None})
    hold(t, "bowl")
    assert t.do(Interaction.PLACE, "kitchen_table") is Result.OK
    rows = t.world.at(t.row["kitchen_table"])
    for one in rows:
        for other in rows:
            if one < other:
                gap = ((t.world.position[one] - t.world.position[other]) ** 2).sum() ** 0.5
                assert gap >= t.world.prior.radius[one] + t.world.prior.radius[other] - 1e-9


@pytest.mark.parametrize(
    ("interaction", "target", "result"),
    [
        (Interaction.PICK, "pen_1", Result.OUT_OF_REACH),
        (Interaction.PICK, "kitchen_table", Result.NOT_POSSIBLE),
        (Interaction.PLACE, "kitchen_table", Result.HAND_EMPTY),
        (Interaction.OPEN, "desk_drawer", Result.OUT_OF_REACH),
        (Interaction.OPEN, "kitchen_table", Result.NOT_POSSIBLE),
        (Interaction.SWITCH_ON, "tv", Result.OUT_OF_REACH),
        (Interaction.CLOSE, "microwave", Result.ALREADY),
        (Interaction.FILL, "sink", Result.HAND_EMPTY),
        (Interaction.CLEAN, "sink", Result.HAND_EMPTY),
        (Interaction.HAND_OVER, "user", Result.HAND_EMPTY),
        (Interaction.HAND_OVER, "sink", Result.NOT_POSSIBLE),
        (Interaction.SAY, "user", Result.OUT_OF_REACH),
        (Interaction.SAY, "anna", Result.OUT_OF_REACH),
    ],
    ids=lambda value: getattr(value, "name", value),
)
def test_an_impossible_interaction_says_why_and_changes_nothing(trial, interaction, target, result):
    t = trial(at=AT_COUNTER, placement={"pen_1": "desk"}, states={"microwave": "closed"})
    before = t.world.states.copy(), t.world.place.copy(), t.world.position.copy()
    assert t.do(interaction, target) is result
    for old, new in zip(before, (t.world.states, t.world.place, t.world.position), strict=True):
        assert (old == new).all() or ((old == new) | ((old != old) & (new != new))).all()


@pytest.mark.parametrize("place", ["fridge", "cupboard", None], ids=["behind a door", "elsewhere", "nowhere"])
def test_a_result_does_not_tell_where_an_unseen_thing_is(trial, place):
    t = trial(at=AT_FRIDGE, placement={"milk": place}, states={"fridge": "closed", "cupboard": "closed"})
    assert t.do(Interaction.PICK, "milk") is Result.OUT_OF_REACH


def test_the_gripper_holds_one_thing_and_the_tray_four(trial):
    things = ["apple", "banana", "orange", "fork", "spoon", "knife"]
    t = trial(at=AT_TABLE, placement=dict.fromkeys(things, "kitchen_table"))
    for thing in things[:4]:
        assert t.do(Interaction.PICK, thing) is Result.OK
        assert t.do(Interaction.PICK, "knife") is Result.HAND_FULL
        assert t.do(Interaction.PLACE, "robot") is Result.OK
    assert t.do(Interaction.PICK, "spoon") is Result.OK
    assert t.do(Interaction.PLACE, "robot") is Result.NO_ROOM
    assert t.do(Interaction.PLACE, "kitchen_table") is Result.OK
    assert t.do(Interaction.PICK, "banana") is Result.OK, "from the tray"
    assert NOTHING in t.world.tray


def test_a_closed_container_takes_nothing(trial):
    t = trial(at=AT_FRIDGE, states={"fridge": "closed"})
    hold(t, "milk")
    assert t.do(Interaction.PLACE, "fridge") is Result.CLOSED
    assert t.do(Interaction.OPEN, "fridge") is Result.OK
    assert t.do(Interaction.PLACE, "fridge") is Result.OK


def test_hot_in_the_closed_microwave_switched_on(trial):
    t = trial(at=AT_COUNTER, states={"microwave": ("open", "off"), "soup": "cold"})
    hold(t, "soup")
    t.do(Interaction.PLACE, "microwave")
    assert t.do(Interaction.SWITCH_ON, "microwave") is Result.OPEN
    assert t.state("microwave", POWER) == t.state("soup", TEMPERATURE) == 0, "not while it is open"
    t.do(Interaction.CLOSE, "microwave")
    assert t.do(Interaction.SWITCH_ON, "microwave") is Result.OK
    assert t.state("soup", TEMPERATURE) == 1


def test_cold_in_the_closed_fridge(trial):
    t = trial(at=AT_FRIDGE, states={"fridge": "open", "juice": "hot"})
    hold(t, "juice")
    t.do(Interaction.PLACE, "fridge")
    assert t.state("juice", TEMPERATURE) == 1
    t.do(Interaction.CLOSE, "fridge")
    assert t.state("juice", TEMPERATURE) == 0


def test_clean_in_the_dishwasher_and_at_the_sink(trial):
    t = trial(at=AT_DISHWASHER, states={"dishwasher": ("open", "off"), "plate_1": "dirty", "cup_1": "dirty"})
    hold(t, "plate_1")
    t.do(Interaction.PLACE, "dishwasher")
    t.do(Interaction.CLOSE, "dishwasher")
    t.do(Interaction.SWITCH_ON, "dishwasher")
    assert t.state("plate_1", CLEANLINESS) == 1
    t = trial(at=(1.7, 8.0), states={"cup_1": "dirty"})
    hold(t, "cup_1")
    assert t.do(Interaction.CLEAN, "sink") is Result.OK
    assert t.state("cup_1", CLEANLINESS) == 1


def test_a_rag_wipes_a_table(trial):
    t = trial(at=AT_TABLE, states={"kitchen_table": "dirty"})
    hold(t, "rag")
    assert t.do(Interaction.CLEAN, "kitchen_table") is Result.OK
    assert t.state("kitchen_table", CLEANLINESS) == 1


def test_full_at_the_coffee_machine_and_empty_at_the_trash_can(trial):
    t = trial(at=(2.4, 8.0), states={"mug_1": "empty"})
    hold(t, "mug_1")
    assert t.do(Interaction.FILL, "coffee_machine") is Result.OK
    assert t.state("mug_1", FILL) == 1
    t = trial(at=AT_TRASH, states={"mug_1": "full", "trash_can": "full"})
    hold(t, "mug_1")
    assert t.do(Interaction.EMPTY, "trash_can") is Result.OK
    assert t.state("mug_1", FILL) == 0
    assert t.state("trash_can", FILL) == 1
    t.do(Interaction.PLACE, "robot")
    assert t.do(Interaction.EMPTY, "trash_can") is Result.OK
    assert t.state("trash_can", FILL) == 0


def test_a_broken_device_refuses_to_be_switched_on(trial):
    t = trial(at=(11.2, 7.2), broken=["tv"])
    assert t.state("tv", POWER) == 0
    assert t.do(Interaction.SWITCH_ON, "tv") is Result.BROKEN
    assert t.state("tv", POWER) == 0


def test_a_grasp_slips_by_its_probability(trial):
    t = trial(at=AT_TABLE, placement={"apple": "kitchen_table"})
    t.world.grasp_slip = 1.0
    assert t.do(Interaction.PICK, "apple") is Result.SLIPPED
    assert t.place("apple") == "kitchen_table"


def test_handing_over_and_taking_back(trial):
    t = trial(at=(9.2, 8.2), people={"user": "living_room", "anna": None, "tom": None, "guest": None})
    user = t.world.position[t.row["user"]]
    t.world._robot.position = (float(user[0]) + 0.9, float(user[1]))
    t.drive(0.0)
    hold(t, "keys")
    assert t.do(Interaction.HAND_OVER, "user") is Result.OK
    assert t.place("keys") == "user"
    assert t.do(Interaction.PICK, "keys") is Result.OK
    assert t.place("keys") == "robot"
    assert t.do(Interaction.SAY, "user") is Result.OK
    assert t.world.event.person == "user"


def test_putting_on_the_floor_finds_a_free_spot_beside_the_robot(trial):
    t = trial(at=(2.2, 6.0), facing=(2.2, 9.0))
    hold(t, "ball")
    assert t.do(Interaction.PLACE, "kitchen_floor") is Result.OK
    assert t.place("ball") == "kitchen_floor"
    before = t.world.position[t.row["ball"]].copy()
    t.drive(0.0, steps=10)
    assert abs(t.world.position[t.row["ball"]] - before).max() < 0.01, "it does not spring away"


def test_opening_from_across_a_wall_is_out_of_reach(trial):
    t = trial(at=(4.0, 8.6), facing=(9.0, 8.6))
    hold(t, "ball")
    assert t.do(Interaction.PLACE, "basket") is Result.OUT_OF_REACH


AT_DOOR_FRAME = (3.70, 4.2)
"""In the hallway before the end of the wall beside the bedroom door, whose opening ends at x = 3.675."""


THROUGH_DOOR, THROUGH_FRAME = (3.60, 3.62), (3.70, 3.62)


@pytest.mark.parametrize(
    ("door", "beyond", "result"),
    [
        ("closed", THROUGH_DOOR, Result.OUT_OF_REACH),
        ("closed", THROUGH_FRAME, Result.OUT_OF_REACH),
        ("open", THROUGH_DOOR, Result.OK),
        ("open", THROUGH_FRAME, Result.OUT_OF_REACH),
    ],
)
def test_hand_and_voice_get_through_an_open_door_and_nowhere_else(trial, door, beyond, result):
    t = trial(at=AT_DOOR_FRAME, states={"bedroom_door": door}, people={"user": "study", "anna": "bedroom"})
    t.world.position[t.row["anna"]] = beyond
    t.world.shift(t.row["ball"], t.row["bedroom_floor"], beyond)
    assert t.do(Interaction.SAY, "anna") is result
    assert t.do(Interaction.PICK, "ball") is result
    hold(t, "ball")
    assert t.do(Interaction.HAND_OVER, "anna") is result


def test_a_door_opens_and_closes_from_both_sides(trial):
    for at in ((3.2, 3.3), (3.2, 4.5)):
        t = trial(at=at, states={"bedroom_door": "closed"})
        assert t.do(Interaction.OPEN, "bedroom_door") is Result.OK
        assert t.state("bedroom_door", APERTURE) == 1
        assert t.do(Interaction.CLOSE, "bedroom_door") is Result.OK
