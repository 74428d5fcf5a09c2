"""The robot sees what is in range, in its field of view and in its line of sight, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from decomplex_bt.envs.config import SensingConfig
from decomplex_bt.envs.interface import COLUMNS, Interaction
from decomplex_bt.envs.sensing import FIRST_STATE, PLACE, Sensor, X, Y
from decomplex_bt.errors import InputError

INSPECTED = COLUMNS.index("inspected")


def inspected(t, place):
    return bool(t.sensor.table[t.row[place], INSPECTED])


def test_what_lies_on_a_table_in_front_is_seen_with_its_place_and_states(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0), placement={"apple": "kitchen_table"}, states={"apple": "hot"})
    row = t.sensor.table[t.row["apple"]]
    assert t.sees("apple")
    assert int(row[PLACE]) == t.row["kitchen_table"]
    assert row[FIRST_STATE:].tolist() == [-1, -1, 1, -1, -1]
    assert row[X : Y + 1] == pytest.approx(t.world.position[t.row["apple"]], abs=1e-5)


def test_what_is_behind_is_not_seen(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 5.0), placement={"apple": "kitchen_table"})
    assert not t.sees("apple")


def test_what_is_out_of_range_is_not_seen(trial):
    t = trial(at=(5.2, 5.8), facing=(11.8, 7.2), placement={"remote": "armchair", "phone": "couch"})
    assert t.sees("remote")
    assert not t.sees("tv"), "6.7 m away"


def test_walls_hide_and_doorways_show(trial):
    t = trial(at=(8.4, 4.6), facing=(8.4, 0.0), placement={"book_1": "bookshelf", "towel": "bathroom_shelf"})
    assert t.sees("bookshelf")
    assert t.sees("book_1")
    assert not t.sees("bathroom_shelf")
    assert not t.sees("towel")


@pytest.mark.parametrize("state", ["open", "closed"])
def test_a_closed_door_hides_the_room_behind_it(trial, state):
    t = trial(at=(3.2, 4.7), facing=(3.2, 0.0), states={"bedroom_door": state})
    assert t.sees("bedroom_window") is (state == "open")
    assert t.sees("bedroom_door")


@pytest.mark.parametrize("state", ["open", "closed"])
def test_contents_of_a_closed_container_are_hidden(trial, state):
    t = trial(at=(0.5, 7.8), facing=(0.5, 9.0), placement={"milk": "fridge"}, states={"fridge": state})
    t.drive(0.0, steps=9)
    assert t.sees("milk") is (state == "open")
    assert inspected(t, "fridge") is (state == "open")


def test_an_open_container_is_looked_into_from_nearby_only(trial):
    t = trial(at=(2.2, 5.7), facing=(0.5, 9.0), placement={"milk": "fridge"}, states={"fridge": "open"})
    t.drive(0.0, steps=9)
    assert t.sees("fridge")
    assert not t.sees("milk")
    assert not inspected(t, "fridge")


def test_opening_shows_at_once(trial):
    t = trial(at=(0.5, 7.8), facing=(0.5, 9.0), placement={"milk": "fridge"}, states={"fridge": "closed"})
    t.do(Interaction.OPEN, "fridge")
    t.drive(0.0)
    assert t.sees("milk")


def test_nothing_unseen_is_in_the_table(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0))
    t.drive(0.2, 0.3, steps=20)
    table = t.sensor.table
    hidden = np.flatnonzero(table[:, 0] == 0)
    assert (table[hidden][:, PLACE] == -1).all()
    assert (table[hidden][:, FIRST_STATE:] == -1).all()
    moving = [row for row in hidden if row >= t.world.geometry.place_count and row != t.row["user"]]
    assert (table[moving][:, X : FIRST_STATE - 2] == 0).all()


def test_fixed_places_and_the_user_are_always_known(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0))
    assert t.sensor.table[t.row["bed"], X : Y + 1].tolist() == pytest.approx([1.06, 1.5])
    assert t.sensor.table[t.row["user"], X : Y + 1] == pytest.approx(t.world.position[t.row["user"]], abs=1e-5)
    assert not t.sees("user")


def test_a_floor_is_inspected_by_turning_round_in_the_middle_of_its_room(trial):
    t = trial(at=(2.6, 2.0), facing=(9.0, 2.0), placement={"shoes": "bedroom_floor"}, states={"bedroom_door": "closed"})
    t.drive(0.0, steps=9)
    assert not inspected(t, "bedroom_floor")
    t.drive(0.0, 1.0, steps=30)
    assert inspected(t, "bedroom_floor")
    assert t.sees("shoes"), "seen a while ago counts while the floor is inspected"


def shoes_seen_and_moved(trial):
    """Two trials in which the robot has looked round and stopped with the shoes behind it; in the second they are then
    moved out of view."""
    both = []
    for is_moved in (False, True):
        t = trial(at=(3.6, 2.0), placement={"shoes": "bedroom_floor"}, states={"bedroom_door": "closed"})
        t.world.shift(t.row["shoes"], t.row["bedroom_floor"], (2.6, 2.9))
        t.drive(0.0, 1.0, steps=30)
        while t.sensor._tracked[t.row["shoes"] - t.world.geometry.place_count]:
            t.drive(0.0, 1.0)
        t.drive(0.0, steps=9)
        assert t.sees("shoes")
        if is_moved:
            t.world.shift(t.row["shoes"], t.row["desk"], (8.0, 0.5))
        both.append(t)
    return both


def test_what_was_seen_on_a_floor_is_reported_so_until_its_spot_is_in_view_again(trial):
    left, moved = shoes_seen_and_moved(trial)
    for _ in range(40):
        for t in (left, moved):
            t.drive(0.0)
        assert np.array_equal(left.sensor.table, moved.sensor.table)
    for t in (left, moved):
        t.drive(0.0, 1.0, steps=25)
    assert left.sees("shoes")
    assert not moved.sees("shoes")
    assert inspected(moved, "bedroom_floor")


def test_what_others_do_does_not_make_the_robot_look(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0), placement={"apple": "kitchen_table"})
    t.world.shift(t.row["apple"], t.row["desk"], (8.0, 0.5))
    t.world.drive(0.0, 0.0)
    assert not t.sensor.look()
    t.drive(0.0, steps=4)
    assert not t.sees("apple")


def test_a_missed_detection_is_made_up_for_by_the_next_look(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0), placement={"apple": "kitchen_table"})
    t.sensor.missed_detection = 1.0
    t.sensor._tracked[:] = False
    t.drive(0.0, steps=SensingConfig().every)
    assert not t.sees("apple")
    t.sensor.missed_detection = 0.5
    t.drive(0.0, steps=60)
    assert t.sees("apple")


def test_absent_people_and_things_are_nowhere(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0), placement={"apple": None})
    t.drive(0.0, 1.0, steps=30)
    assert not t.sees("apple")
    assert not t.sees("anna")


@pytest.mark.parametrize("looks", [1, 2, 3])
def test_a_place_is_inspected_by_so_many_looks_in_a_row_and_forgotten_by_one_away(trial, looks):
    t = trial(at=(0.5, 7.8), facing=(0.5, 9.0), states={"fridge": "open"})
    sensor = Sensor(t.world, SensingConfig(looks=looks, every=1))
    seen = []
    for _ in range(4):
        t.world.drive(0.0, 0.0)
        assert sensor.look()
        seen.append(bool(sensor.inspected[t.row["fridge"]]))
    assert seen == [k >= looks for k in range(1, 5)]
    while sensor.visible[t.row["fridge"]]:
        t.world.drive(0.0, 1.0)
        sensor.look()
    assert not sensor.inspected[t.row["fridge"]]


def test_who_walks_on_in_a_kept_scene_is_seen_where_they_are(trial):
    t = trial(at=(2.2, 6.2), facing=(2.2, 9.0), people={"user": "study", "anna": "kitchen", "tom": None, "guest": None})
    t.drive(0.0, steps=4)
    row, world = t.row["anna"], t.world
    behind, ahead = np.array([2.2, 5.2]), np.array([2.2, 7.0])
    for spot, is_seen in ((behind, False), (ahead, True), (behind, False)):
        world._position[row] = spot
        world.stirs += 1
        t.drive(0.0, steps=4)
        assert t.sees("anna") is is_seen


def test_a_sensor_that_never_looks_is_refused():
    with pytest.raises(InputError, match="looks is 0"):
        SensingConfig(looks=0)
