import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import decomplex_bt.domains.household as household
from decomplex_bt.domain.document import read_record
from decomplex_bt.domain.house import House
from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.envs.floorplan import Disc, floorplan_of
from decomplex_bt.envs.navigation import Driver, Limits, Pose, wrap

DATA = Path(household.__file__).parent
LIMITS = Limits()


@cache
def plan():
    return floorplan_of(read_record(DATA / "house.yaml", House), read_record(DATA / "kinds.yaml", Kinds))


class Unicycle:
    """The robot as the driver sees it: limited speeds and accelerations, nothing to bump into."""

    def __init__(self, x, y, heading=0.0):
        self.pose = Pose(x, y, heading)

    def drive(self, forward, turn):
        pose, step = self.pose, LIMITS.step
        change = LIMITS.acceleration * step
        speed = pose.speed + min(change, max(-change, forward * LIMITS.speed - pose.speed))
        change = LIMITS.turn_acceleration * step
        rate = pose.turn_rate + min(change, max(-change, turn * LIMITS.turn_rate - pose.turn_rate))
        heading = wrap(pose.heading + rate * step)
        x, y = pose.x + speed * step * math.cos(heading), pose.y + speed * step * math.sin(heading)
        self.pose = Pose(x, y, heading, speed, rate)


def run(robot, goal, *, max_steps=600, **options):
    """Drives; the steps it took, the smallest clearance on the way (m) and the last course."""
    driver, tightest = Driver(plan(), goal, LIMITS), math.inf
    for step in range(max_steps):
        course = driver.steer(robot.pose, **options)
        if course.has_arrived or course.problem:
            return step, tightest, course
        robot.drive(*course.drive)
        nearest = np.hypot(plan().cell_x - robot.pose.x, plan().cell_y - robot.pose.y).argmin()
        tightest = min(tightest, float(plan().clearance[nearest]))
    return max_steps, tightest, course


@pytest.mark.parametrize("place", sorted({"fridge", "radio", "computer", "bedroom_lamp", "couch", "laundry_basket"}))
def test_a_robot_in_the_hallway_gets_to_the_place_without_touching_anything(place):
    (room,) = plan().rooms_of(place)
    robot = Unicycle(1.0, 4.6, heading=math.pi)
    steps, tightest, course = run(robot, plan().cells_at(place, room=room))
    assert course.has_arrived
    assert plan().distance_to(place, *robot.pose.point) < 0.78
    assert tightest > 0.2
    assert steps < 180


@pytest.mark.parametrize("place", plan().house.places())
def test_every_place_can_be_used_from_its_room(place):
    for room in plan().rooms_of(place):
        cells = plan().cells_at(place, room=room)
        assert cells.size
        distance = min(plan().distance_to(place, plan().cell_x[c], plan().cell_y[c]) for c in cells)
        assert distance < 0.75
        assert plan().way((2.2, 4.6), cells) is not None


def test_a_closed_door_is_no_way():
    cells = plan().cells_at("bed", room="bedroom")
    assert plan().way((2.2, 4.6), cells) is not None
    assert plan().way((2.2, 4.6), cells, closed=frozenset({"bedroom_door"})) is None


def test_ways_keep_to_the_free_and_are_near_the_straight_line():
    way = plan().way((1.0, 4.6), plan().cells_around(11.0, 4.6, nearest=0.0, farthest=0.1, room=None))
    assert len(way.points) <= 4
    length = sum(math.dist(a, b) for a, b in zip(way.points, way.points[1:], strict=False))
    assert length < 10.2


def test_a_person_in_the_way_is_driven_around():
    person = Disc(8.0, 8.3, 0.25)
    robot = Unicycle(6.0, 8.6)
    driver = Driver(plan(), plan().cells_around(10.0, 8.6, nearest=0.0, farthest=0.2, room="living_room"), LIMITS)
    gap = math.inf
    for _ in range(200):
        seen = [person] if robot.pose.x > 6.5 else []
        course = driver.steer(robot.pose, obstacles=seen)
        if course.has_arrived:
            break
        robot.drive(*course.drive)
        gap = min(gap, math.dist(robot.pose.point, (person.x, person.y)))
    assert course.has_arrived
    assert gap > 0.25 + 0.22


def test_a_robot_that_cannot_move_says_so():
    driver = Driver(plan(), plan().cells_at("fridge", room="kitchen"), LIMITS)
    pose = Pose(1.0, 4.6, 0.0)
    for _ in range(300):
        course = driver.steer(pose)
        if course.problem:
            break
    assert "stuck" in course.problem


def test_no_way_is_a_problem_and_no_exception():
    course = Driver(plan(), np.empty(0, np.int32), LIMITS).steer(Pose(1.0, 4.6, 0.0))
    assert course.problem == "no way there"


def test_who_stands_too_close_to_a_wall_does_not_turn_back_to_set_out():
    # beside the bedroom's door, a little nearer to the wall than the plan's margin
    start, door = (3.67, 3.64), plan().cells_at("bedroom_door", room="hallway")
    assert not plan().free[plan().cells_around(*start, nearest=0.0, farthest=0.03, room=None)].size
    way = plan().way(start, door)
    assert way.points[0][0] < start[0] - 0.05
