"""Going along with people: the scripts of skills that follow."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from decomplex_bt.envs.approach import Script, SkillError, drive_to
from decomplex_bt.envs.embodiment import Action, HouseholdEmbodiment
from decomplex_bt.envs.floorplan import Cells
from decomplex_bt.envs.handling import perform
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.looking import turn_round
from decomplex_bt.envs.navigation import steer_turn, wrap

FOLLOW_SECONDS = 120.0
"""[s] How long a person is followed at most."""
FOLLOW_GAP = 0.9
"""[m] How near the robot comes up behind a person it follows."""
LOST_AFTER = 5
"""[control steps] A person out of sight for so long has to be looked for."""
WAIT_SECONDS = 6.0
"""[s] How long somebody who walks is waited for until they stand, at most."""
MAX_ASKS = 3
"""How often somebody is asked to lead the way wherever they like."""
SETTLED_SECONDS = 2.5
"""[s] A person who has stood still for so long has arrived where they wanted to go."""


def follow(body: HouseholdEmbodiment, person: str, start: str, goal: str) -> Script:
    """Asks a person to lead the way to the room `goal` and keeps behind them until both are there."""
    senses = body.senses
    yield from _step_up_to(body, person)
    yield from perform(body, Interaction.SAY, body.house.floor_of(goal), near=person)

    def are_there() -> bool:
        return senses.room == goal and senses.room_of_person(person) == goal and senses.is_seen(person)

    yield from _keep_behind(body, person, are_there, goal=goal)


def tag_along(body: HouseholdEmbodiment, person: str) -> Script:
    """Asks a person to lead the way wherever they like and keeps behind them until they stay where they are.

    Who is still in the room they were asked in was not the one who felt asked: others may have stood nearer by then.
    """
    for _ in range(MAX_ASKS):
        yield from _step_up_to(body, person)
        asked_in = body.senses.room_of_person(person)
        yield from perform(body, Interaction.SAY, "robot", near=person)
        yield from _keep_behind(body, person, _stays(body, person))
        if body.senses.room_of_person(person) != asked_in:
            return
    raise SkillError(f"{person} does not lead the way")


def _stays(body: HouseholdEmbodiment, person: str) -> Callable[[], bool]:
    """Whether a person has stayed where they are for a while, the robot with them; to be asked at every step."""
    senses = body.senses
    stood_at, since = senses.position(person), senses.seconds

    def have_stayed() -> bool:
        nonlocal stood_at, since
        now = senses.position(person)
        if now is None or stood_at is None or math.dist(now, stood_at) > 0.1:
            stood_at, since = now, senses.seconds
        is_with = senses.distance(person) <= 1.2 and senses.room == senses.room_of_person(person)
        return is_with and senses.is_seen(person) and senses.seconds - since > SETTLED_SECONDS

    return have_stayed


def _step_up_to(body: HouseholdEmbodiment, person: str) -> Script:
    """Drives to where nobody else is as near as this person: who is asked to lead the way is the nearest.

    Who still walks is waited for, since it is only seen now and then where they are.
    """
    senses, plan = body.senses, body.floorplan
    since = senses.seconds
    while senses.has_walked(person) and senses.seconds - since < WAIT_SECONDS:
        yield _turn_to(body, person)
    others = [at for name in body.house.people if name != person and (at := senses.position(name)) is not None]

    def is_nearest() -> bool:
        gaps = [math.dist(at, senses.pose.point) for at in others]
        return senses.distance(person) <= min([1.3, *(gap - 0.1 for gap in gaps)])

    position = senses.position(person)
    if position is None:
        raise SkillError(f"I do not know where {person} is")
    cells = plan.cells_around(*position, nearest=0.5, farthest=1.2, room=senses.room_of_person(person))
    x, y = plan.cell_x[cells], plan.cell_y[cells]
    nearest = np.ones(cells.size, dtype=bool)
    for at in others:
        nearest &= np.hypot(x - position[0], y - position[1]) < np.hypot(x - at[0], y - at[1]) - 0.2
    yield from drive_to(body, cells[nearest] if nearest.any() else cells, is_nearest, towards=person, besides=person)


def _keep_behind(
    body: HouseholdEmbodiment, person: str, is_over: Callable[[], bool], *, goal: str | None = None
) -> Script:
    """Keeps behind a person who walks, to the room `goal` if they said so, until `is_over`."""
    senses = body.senses
    until = senses.seconds + FOLLOW_SECONDS
    unseen = 0
    while not is_over():
        if senses.seconds > until:
            raise SkillError(f"{person} did not get there in time")
        unseen = 0 if senses.is_seen(person) else unseen + 1
        if unseen > LOST_AFTER:
            yield from _look_for(body, person, goal)
        elif senses.distance(person) > FOLLOW_GAP or senses.room != senses.room_of_person(person):
            yield from _drive_briefly(body, _cells_behind(body, person), person)
        else:
            yield _turn_to(body, person)


def _cells_behind(body: HouseholdEmbodiment, person: str) -> Cells:
    """Where to follow to: near the person, and in their room, so that nobody stops in a doorway."""
    senses, plan = body.senses, body.floorplan
    position = senses.position(person)
    if position is None:
        raise SkillError(f"I have lost {person}")
    for room, farthest in ((senses.room_of_person(person), FOLLOW_GAP - 0.05), (senses.room_of_person(person), 1.4)):
        cells = plan.cells_around(*position, nearest=0.5, farthest=farthest, room=room)
        if cells.size:
            return cells
    return plan.cells_around(*position, nearest=0.5, farthest=1.4, room=None)


def _look_for(body: HouseholdEmbodiment, person: str, goal: str | None) -> Script:
    """Goes where a person out of sight must be: on towards their goal, else to where they were last, then through the
    doorways about, the nearest to there first."""
    senses, plan = body.senses, body.floorplan
    position = senses.position(person)
    if goal is not None and senses.room != goal:
        yield from _drive_briefly(body, plan.cells_at(body.house.floor_of(goal), room=goal), person)
        return
    spots = [] if position is None else [plan.cells_around(*position, nearest=0.0, farthest=0.4, room=None)]
    if position is not None:
        doorways, left_from = body.house.doorways, senses.room_of_person(person)
        by_distance = sorted(doorways, key=lambda name: (plan.distance_to(name, *position), name))
        spots += [plan.cells_at(by_distance[0], room=room) for room in doorways[by_distance[0]].rooms]
        others = [name for name in by_distance[1:] if left_from in doorways[name].rooms]
        spots += [
            plan.cells_at(name, room=room) for name in others for room in doorways[name].rooms if room != left_from
        ]
    for spot in spots:
        if spot.size:
            yield from drive_to(body, spot, lambda: senses.is_seen(person), towards=person, besides=person)
        for action in turn_round(body):
            if senses.is_seen(person):
                return
            yield action
    if not senses.is_seen(person):
        raise SkillError(f"I have lost {person}")


def _drive_briefly(body: HouseholdEmbodiment, cells: Cells, person: str) -> Script:
    """Drives towards some cells for half a second."""
    driver, senses = body.driver(cells), body.senses
    for _ in range(5):
        course = driver.steer(senses.pose, obstacles=senses.obstacles(besides=person))
        if course.has_arrived or course.problem:
            yield _turn_to(body, person)
            return
        yield body.drive(*course.drive)


def _turn_to(body: HouseholdEmbodiment, person: str) -> Action:
    """Stands and turns towards where a person was seen last."""
    position, pose = body.senses.position(person), body.senses.pose
    if position is None:
        return body.rest()
    error = wrap(math.atan2(position[1] - pose.y, position[0] - pose.x) - pose.heading)
    return body.drive(0.0, steer_turn(error, body.config.limits)) if abs(error) > 0.2 else body.rest()
