"""People who lead the way: asked by the robot, they walk the shortest way to a goal and wait where it falls behind."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import pairwise
from math import atan2, dist, hypot
from typing import TYPE_CHECKING

import numpy as np
import pymunk

from decomplex_bt.envs.chance import APERTURE
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.interface import Result
from decomplex_bt.envs.spots import PERSON_RADIUS, ROBOT_RADIUS
from decomplex_bt.envs.world import NOTHING, World

if TYPE_CHECKING:
    from decomplex_bt.envs.floorplan import Floorplan

PACE = 0.8  # [m/s]
LEASH = 3.0  # [m] a walker waits while the robot is farther behind
ARRIVED = 0.12  # [m] so near to a corner of their way a walker turns to the next
THERE = 0.05  # [m] so near to its end they stand
DOOR_REACH = 0.7  # [m] from where a walker opens a closed door ahead
COURTESY = 0.25  # [m] gap to the robot ahead at which a walker stops
PATIENCE = 1.5  # [s] a walker waits for the robot to clear the way before they look for a way around it
RESOLUTION = 0.10  # [m] side of the cells that ways are planned on; at 0.06, as the robot's, it takes twice as long
MAX_SPOTS = 12  # spots near the goal tried for one that leaves the robot a way past everybody
SQUEEZE = 0.03  # [m] by which a walker is planned for slimmer than their body, so that two pass where a robot does
NEAR_GOAL = 1.2  # [m] a walker who goes to a place stops so near to it

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Lead:
    """What came of asking somebody to lead the way: who was asked, and where they go (a row)."""

    result: Result = Result.NONE
    person: int = NOTHING
    goal: int = NOTHING


@dataclass(slots=True)
class Walk:
    """A person on the way to `end`: `rest` are the corners ahead, `held_up` [s] how long the robot stood in the way."""

    person: int
    end: Point
    body: pymunk.Body
    rest: list[Point] = field(default_factory=list)
    held_up: float = 0.0
    shoves: bool = False


def ask_to_lead(world: World, goal: int) -> Lead:
    """Asks the nearest person within earshot to lead the way to a place; with the robot's row, wherever they like."""
    geometry = world.geometry
    near = [row for row in geometry.people_rows if is_near_person(world, row)]
    if not near:
        return Lead(Result.OUT_OF_REACH)
    x, y = world.robot
    person = min(near, key=lambda row: hypot(world.position[row, 0] - x, world.position[row, 1] - y))
    if goal == geometry.robot_row:
        others = [room for room in range(len(geometry.rooms)) if room != world.room[person]]
        goal = int(geometry.floor_row[others[int(world.whims() * len(others))]]) if others else goal
    if goal >= geometry.place_count:
        return Lead(Result.NOT_POSSIBLE, person)
    if _is_there(world, person, goal):
        return Lead(Result.ALREADY, person, goal)
    end = _destination(world, person, goal)
    way = _way(world, _point(world, person), end) if end is not None else None
    if end is None or way is None:
        return Lead(Result.NO_ROOM, person, goal)
    walk = world.walks.get(person) or Walk(person, end, world.start_walking(person))
    walk.end, walk.rest = end, way
    world.walks[person] = walk
    return Lead(Result.OK, person, goal)


def is_near_person(world: World, person: int) -> bool:
    """Whether a person is at home and close enough to speak with and hand over."""
    if not world.home[person]:
        return False
    x, y = world.position[person].tolist()
    away = hypot(x - world.robot[0], y - world.robot[1])
    return away <= world.config.speak_reach and world.geometry.is_free_line(world.robot, (x, y), world.closed_leaves)


def advance(world: World) -> list[str]:
    """Sets the pace of all who walk, for one control step; tells which doors they opened."""
    return [door for walk in list(world.walks.values()) for door in _advance(world, walk)]


def _advance(world: World, walk: Walk) -> list[str]:
    here = _point(world, walk.person)
    while walk.rest and dist(walk.rest[0], here) < (ARRIVED if len(walk.rest) > 1 else THERE):
        walk.rest.pop(0)
    if not walk.rest:
        del world.walks[walk.person]
        world.stop_walking(walk.person)
        return []
    target = walk.rest[0]
    dx, dy = target[0] - here[0], target[1] - here[1]
    away = hypot(dx, dy)
    opened = open_doors(world, [here, *walk.rest[:2]])
    if _must_wait(world, walk, here, (dx / away, dy / away)):
        walk.body.velocity = (0.0, 0.0)
        return opened
    pace = min(PACE, away / world.config.step_seconds)
    walk.body.velocity = (pace * dx / away, pace * dy / away)
    world.heading[walk.person] = atan2(dy, dx)
    return opened


def _must_wait(world: World, walk: Walk, here: Point, ahead: Point) -> bool:
    """Whether the robot is too far behind, or stands right ahead: then the walker goes around it or, in the end, on."""
    rx, ry = world.robot[0] - here[0], world.robot[1] - here[1]
    gap = hypot(rx, ry)
    if gap > LEASH:
        return True
    is_ahead = gap < PERSON_RADIUS + ROBOT_RADIUS + COURTESY and rx * ahead[0] + ry * ahead[1] > 0.5 * gap
    if not is_ahead:
        walk.held_up, walk.shoves = 0.0, False
        return False
    walk.held_up += world.config.step_seconds
    if walk.held_up > PATIENCE and not walk.shoves:
        around = _way(world, here, walk.end, avoids_robot=True)
        walk.rest, walk.shoves = around or walk.rest, True
        return around is None
    return not walk.shoves


def open_doors(world: World, way: Sequence[Point]) -> list[str]:
    """A walker opens the closed doors on the next stretches of their way, from where they are: a door may stand so
    close behind a corner that they would not get to the corner for it. Tells which."""
    x, y = way[0]
    opened = []
    for leaf in world.closed_leaves:
        ax, ay, bx, by = world.geometry.leaves[leaf]
        near = hypot((ax + bx) / 2 - x, (ay + by) / 2 - y) < DOOR_REACH
        if near and not all(world.geometry.is_free_line(*stretch, (leaf,)) for stretch in pairwise(way)):
            world.set_state(world.geometry.row[leaf], APERTURE, 1)
            opened.append(leaf)
    return opened


def _is_there(world: World, person: int, goal: int) -> bool:
    if world.room[person] != world.geometry.place_room[goal]:
        return False
    return world.is_floor(goal) or world.geometry.distance(*_point(world, person), goal) <= NEAR_GOAL


def _destination(world: World, person: int, goal: int) -> Point | None:
    """Where the person will stand: the spot in the goal's room nearest to the middle of the goal."""
    geometry = world.geometry
    taken = list(world.discs_at(int(geometry.floor_row[geometry.place_room[goal]])))
    spots = world.spots.standing(int(geometry.place_room[goal]), taken)
    if not len(spots):
        return None
    x0, y0, x1, y1 = geometry.footprints[goal]
    centre = ((x0 + x1) / 2, (y0 + y1) / 2)
    room = int(geometry.place_room[goal])
    company = [
        _point(world, row) for row in np.flatnonzero(world.home).tolist() if row != person and world.room[row] == room
    ]
    gaps = np.hypot(*(np.array(spots) - centre).T)
    nearest = [spots[index] for index in gaps.argsort(kind="stable")[:MAX_SPOTS].tolist()]
    ends = (spot for spot in nearest if not company or world.spots.leaves_way(room, [*company, spot]))
    return next(ends, nearest[0])


def _way(world: World, start: Point, end: Point, *, avoids_robot: bool = False) -> list[Point] | None:
    """The corners of the shortest way, through open and closed doors, around the people who stand."""
    from decomplex_bt.envs.floorplan import Disc

    plan = _floorplan(world.geometry)
    obstacles = [
        Disc(*_point(world, row), PERSON_RADIUS)
        for row in np.flatnonzero(world.home).tolist()
        if row not in world.walks and hypot(*(world.position[row] - start)) > 0.05
    ]
    if avoids_robot:
        obstacles.append(Disc(*world.robot, ROBOT_RADIUS))
    goal = plan.cells_around(*end, nearest=0.0, farthest=0.3, room=None)
    way = plan.way(start, goal, obstacles=obstacles)
    # To the very spot: others, even so near to it, need not leave the robot its way past.
    return None if way is None else [*way.points[1:], end]


def _point(world: World, person: int) -> Point:
    x, y = world.position[person].tolist()
    return x, y


@lru_cache(maxsize=4)
def _floorplan(geometry: Geometry) -> Floorplan:
    from decomplex_bt.envs.floorplan import Floorplan

    # People squeeze through: they need no more room than the plan's margin leaves a robot.
    return Floorplan(geometry, radius=PERSON_RADIUS - SQUEEZE, resolution=RESOLUTION)
