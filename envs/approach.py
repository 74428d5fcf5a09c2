"""Getting to where something can be done: the scripts of skills that drive.

A script is a generator that yields actions and, when resumed, finds the next observation in `body.senses`. Returning is
success; `SkillError` is failure with a reason.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator

from decomplex_bt.envs.embodiment import Action, HouseholdEmbodiment
from decomplex_bt.envs.floorplan import Cells, rect_distance
from decomplex_bt.envs.navigation import ARRIVED, steer_turn, wrap

Script = Generator[Action, None, None]

CONFIDENT_REACH = 0.12
"""[m] The robot stops this much nearer than its reach."""
REACH_MARGIN = ARRIVED + 0.01
"""[m] Where there is no better place to stand, the robot stands this much nearer than its reach, however far from that
spot it counts as being there."""


class SkillError(Exception):
    """A skill has failed; the message says why, in words a user understands."""


def say_name(name: str) -> str:
    """An entity's name as a person would say it: "the desk drawer"."""
    return "the " + name.replace("_", " ")


def move(body: HouseholdEmbodiment, start: str, goal: str, room: str) -> Script:
    """Drives within a room to where `goal`, a place, a doorway or a person, is used from."""
    yield from approach(body, goal, room)


def pass_doorway(body: HouseholdEmbodiment, doorway: str, start: str, end: str) -> Script:
    """Drives through a doorway until the robot stands clear of it in the room `end`."""
    senses = body.senses
    cells = body.floorplan.cells_at(doorway, room=end)

    def is_through() -> bool:
        return senses.room == end and senses.distance(doorway) >= 0.40

    yield from drive_to(body, cells, is_through, towards=f"{say_name(end)} through {say_name(doorway)}")


def approach(body: HouseholdEmbodiment, target: str, room: str | None = None, *, is_closer: bool = False) -> Script:
    """Drives to where `target` is within reach; `is_closer`: nearer than the last time."""
    senses, house = body.senses, body.house
    if target in house.people:
        yield from approach_person(body, target)
    elif target in house.things:
        yield from approach_thing(body, target)
    elif target in house.furniture or target in house.doorways:
        rooms = body.floorplan.rooms_of(target)
        use_from = senses.room if senses.room in rooms else room if room in rooms else rooms[0]
        assert use_from is not None
        cells = body.floorplan.cells_at(target, room=use_from)
        footprint, stop = body.floorplan.footprint(target), body.config.reach - CONFIDENT_REACH

        def is_there() -> bool:
            near_enough = senses.room == use_from and rect_distance(footprint, *senses.pose.point) <= stop
            return near_enough and not is_closer and _is_in_front(body, cells)

        anywhere = body.floorplan.cells_within(target, body.config.reach - REACH_MARGIN, room=use_from)
        yield from drive_to(body, cells, is_there, towards=say_name(target), second_best=anywhere)
    elif target.removesuffix("_floor") not in house.rooms:
        raise SkillError(f"{say_name(target)} is nowhere to drive to")
    elif senses.room != target.removesuffix("_floor"):
        cells = body.floorplan.cells_at(target, room=target.removesuffix("_floor"))
        yield from drive_to(body, cells, lambda: senses.room == target.removesuffix("_floor"), towards=say_name(target))


def approach_person(body: HouseholdEmbodiment, person: str, *, within: float | None = None) -> Script:
    """Drives up to a person, who may walk, until they are within reach to speak with them and hand over."""
    senses = body.senses
    within = body.config.reach_person - 0.25 if within is None else within
    for _ in range(12):
        position = senses.position(person)
        if position is None:
            raise SkillError(f"I do not know where {person} is")
        room = senses.room_of_person(person)
        cells = body.floorplan.cells_around(*position, nearest=0.55, farthest=max(0.75, within - 0.15), room=room)

        def has_moved(x: float = position[0], y: float = position[1]) -> bool:
            now = senses.position(person)
            return now is not None and math.hypot(now[0] - x, now[1] - y) > 0.4

        def is_there(room: str | None = room) -> bool:
            return senses.distance(person) <= within and senses.room == room and senses.is_seen(person)

        yield from drive_to(body, cells, lambda: is_there() or has_moved(), towards=person, besides=person)
        if senses.distance(person) <= within and senses.room == senses.room_of_person(person):
            if not senses.is_seen(person):
                yield from face(body, person)
            if senses.is_seen(person):
                return
            raise SkillError(f"{person} is not there any more")
    raise SkillError(f"{person} keeps walking away")


def approach_thing(body: HouseholdEmbodiment, thing: str) -> Script:
    """Drives up to where a thing was seen last."""
    position = body.senses.position(thing)
    if position is None:
        raise SkillError(f"I do not know where {say_name(thing)} is")
    room = body.floorplan.room_at(*position)
    for nearest, farthest in ((0.32, 0.55), (0.28, 0.72)):
        cells = body.floorplan.cells_around(*position, nearest=nearest, farthest=farthest, room=room)
        if cells.size:
            break

    def is_there() -> bool:
        return body.senses.distance(thing) <= 0.6 and body.senses.room == room

    yield from drive_to(body, cells, is_there, towards=say_name(thing), besides=thing)


def drive_to(
    body: HouseholdEmbodiment,
    cells: Cells,
    is_there: Callable[[], bool],
    *,
    towards: str,
    besides: str | None = None,
    second_best: Cells | None = None,
) -> Script:
    """Drives to the nearest of some cells, or until `is_there`.

    `besides`: what is no obstacle now. `second_best`: cells that will do where people keep the robot from the others.
    """
    if is_there():
        return
    if not cells.size:
        raise SkillError(f"there is nowhere to stand at {towards}")
    driver = body.driver(cells, second_best=second_best)
    senses = body.senses
    while not is_there():
        course = driver.steer(senses.pose, closed=senses.closed_doors(), obstacles=senses.obstacles(besides=besides))
        if course.has_arrived:
            return
        if course.problem:
            raise SkillError(f"cannot get to {towards}: {course.problem}")
        yield body.drive(*course.drive)


def _is_in_front(body: HouseholdEmbodiment, cells: Cells) -> bool:
    """Whether the robot is as good as on one of the cells from which a place is used."""
    if not cells.size:
        return False
    plan, pose = body.floorplan, body.senses.pose
    gaps = (plan.cell_x[cells] - pose.x) ** 2 + (plan.cell_y[cells] - pose.y) ** 2
    nearest = int(cells[gaps.argmin()])
    if gaps.min() > 0.35**2:
        return False
    return plan.is_clear(pose.point, (float(plan.cell_x[nearest]), float(plan.cell_y[nearest])), plan.free)


def face(body: HouseholdEmbodiment, target: str, *, within: float = 0.5) -> Script:
    """Turns towards a place's nearest point, or a thing or person as last seen."""
    senses = body.senses
    for _ in range(25):
        point = _nearest_point(body, target)
        if point is None:
            return
        pose = senses.pose
        error = wrap(math.atan2(point[1] - pose.y, point[0] - pose.x) - pose.heading)
        if abs(error) <= within:
            return
        yield body.drive(0.0, steer_turn(error, body.config.limits))


def _nearest_point(body: HouseholdEmbodiment, target: str) -> tuple[float, float] | None:
    if target not in body.house.furniture and target not in body.house.doorways:
        return body.senses.position(target)
    left, bottom, right, top = body.floorplan.footprint(target)
    pose = body.senses.pose
    return min(max(pose.x, left), right), min(max(pose.y, bottom), top)
