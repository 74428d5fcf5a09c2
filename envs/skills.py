"""The skills of the household robot: one for every PDDL action, in closed loop on observations alone.

A skill is written as a generator that yields actions and, when resumed, finds the next observation in `body.senses`.
Returning is success; `SkillError` is failure with a reason. To add one: write the generator, name it in `SKILLS`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterator
from typing import Any

import numpy as np

from decomplex_bt.behaviour.embodiment import Skill, SkillStatus, SkillTick
from decomplex_bt.envs.embodiment import Action, HouseholdEmbodiment
from decomplex_bt.envs.floorplan import Cells
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.navigation import steer_turn, wrap
from decomplex_bt.planning.pddl import GroundAction

Script = Generator[Action, None, None]

MAX_SLIPS = 6
"""A grasp that slips is tried again so often; one in twenty slips, so seven in a row are no accident."""
MAX_APPROACHES = 3
"""How often the robot comes nearer when something proves out of reach."""
LOOK_STEPS = 12
"""[control steps] How long one look at a place from one spot may take."""
MAX_SPOTS = 8
"""From how many spots a place is looked at before it counts as impossible to inspect."""
CONFIDENT_REACH = 0.12
"""[m] The robot stops this much nearer than its reach."""
CLEAR_OF_DOOR = 0.30
"""[m] So far from a doorway's line the robot's body is clear of the door in it."""
REACH_MARGIN = 0.07
"""[m] Where there is no better place to stand, the robot stops this much nearer than its reach."""
FOLLOW_SECONDS = 120.0
"""[s] How long a person is followed at most."""
FOLLOW_GAP = 0.9
"""[m] How near the robot comes up behind a person it follows."""
LOST_AFTER = 5
"""[control steps] A person out of sight for so long has to be looked for."""
SETTLED_SECONDS = 2.5
"""[s] A person who has stood still for so long has arrived where they wanted to go."""

WHY = {
    Result.OUT_OF_REACH: "{target} is out of reach",
    Result.NOT_POSSIBLE: "this cannot be done at {target}",
    Result.HAND_FULL: "the hand is full",
    Result.HAND_EMPTY: "the hand is empty",
    Result.CLOSED: "{target} is closed",
    Result.NO_ROOM: "there is no room at {target}",
    Result.BROKEN: "{target} is broken",
    Result.SLIPPED: "{target} slipped out of the hand",
    Result.ALREADY: "{target} is so already",
    Result.NOT_THERE: "{target} is not there",
}


class SkillError(Exception):
    """A skill has failed; the message says why, in words a user understands."""


class ScriptSkill:
    """A skill that follows a script. Implements `decomplex_bt.behaviour.embodiment.Skill`."""

    def __init__(self, body: HouseholdEmbodiment, script: Script) -> None:
        self._body = body
        self._script = script

    def tick(self, observation: Any) -> SkillTick:
        self._body.sense(observation)
        try:
            return SkillTick(SkillStatus.RUNNING, next(self._script))
        except StopIteration:
            return SkillTick(SkillStatus.SUCCESS, self._body.rest())
        except SkillError as error:
            return SkillTick(SkillStatus.FAILURE, self._body.rest(), str(error))

    def stop(self) -> Action:
        self._script.close()
        return self._body.rest()


def make_skill(body: HouseholdEmbodiment, step: GroundAction) -> Skill:
    """The skill for a plan step. Raises `KeyError` for an action that has none."""
    return ScriptSkill(body, SKILLS[step.name](body, *step.objects))


def say_name(name: str) -> str:
    """An entity's name as a person would say it: "the desk drawer"."""
    return "the " + name.replace("_", " ")


# -- getting there ----------------------------------------------------------------------------------------------------


def move(body: HouseholdEmbodiment, start: str, goal: str, room: str) -> Script:
    """Drives within a room to where `goal`, a place, a doorway or a person, is used from."""
    yield from _approach(body, goal, room)


def pass_doorway(body: HouseholdEmbodiment, doorway: str, start: str, end: str) -> Script:
    """Drives through a doorway until the robot stands clear of it in the room `end`."""
    senses = body.senses
    cells = body.floorplan.cells_at(doorway, room=end)

    def is_through() -> bool:
        return senses.room == end and senses.distance(doorway) >= 0.40

    yield from _drive(body, cells, is_through, towards=f"{say_name(end)} through {say_name(doorway)}")


def _approach(body: HouseholdEmbodiment, target: str, room: str | None = None, *, is_closer: bool = False) -> Script:
    """Drives to where `target` is within reach; `is_closer`: nearer than the last time."""
    senses, house = body.senses, body.house
    if target in house.people:
        yield from _approach_person(body, target)
    elif target in house.things:
        yield from _approach_thing(body, target)
    elif target in house.furniture or target in house.doorways:
        rooms = body.floorplan.rooms_of(target)
        use_from = senses.room if senses.room in rooms else room if room in rooms else rooms[0]
        assert use_from is not None
        cells = body.floorplan.cells_at(target, room=use_from)
        stop = body.config.reach - CONFIDENT_REACH

        def is_there() -> bool:
            near_enough = senses.room == use_from and senses.distance(target) <= stop
            return near_enough and not is_closer and _is_in_front(body, target, cells)

        anywhere = body.floorplan.cells_within(target, body.config.reach - REACH_MARGIN, room=use_from)
        yield from _drive(body, cells, is_there, towards=say_name(target), second_best=anywhere)
    elif target.removesuffix("_floor") not in house.rooms:
        raise SkillError(f"{say_name(target)} is nowhere to drive to")
    elif senses.room != target.removesuffix("_floor"):
        cells = body.floorplan.cells_at(target, room=target.removesuffix("_floor"))
        yield from _drive(body, cells, lambda: senses.room == target.removesuffix("_floor"), towards=say_name(target))


def _approach_person(body: HouseholdEmbodiment, person: str, *, within: float | None = None) -> Script:
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

        yield from _drive(body, cells, lambda: is_there() or has_moved(), towards=person, besides=person)
        if senses.distance(person) <= within and senses.room == senses.room_of_person(person):
            if not senses.is_seen(person):
                yield from _face(body, person)
            if senses.is_seen(person):
                return
            raise SkillError(f"{person} is not there any more")
    raise SkillError(f"{person} keeps walking away")


def _approach_thing(body: HouseholdEmbodiment, thing: str) -> Script:
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

    yield from _drive(body, cells, is_there, towards=say_name(thing), besides=thing)


def _drive(
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
        course = driver.steer(
            senses.pose, closed=senses.closed_doors(), obstacles=senses.obstacles(besides=besides)
        )
        if course.has_arrived:
            return
        if course.problem:
            raise SkillError(f"cannot get to {towards}: {course.problem}")
        yield body.drive(*course.drive)


def _is_in_front(body: HouseholdEmbodiment, place: str, cells: Cells) -> bool:
    """Whether the robot is as good as on one of the cells from which a place is used."""
    if not cells.size:
        return False
    plan, pose = body.floorplan, body.senses.pose
    gaps = (plan.cell_x[cells] - pose.x) ** 2 + (plan.cell_y[cells] - pose.y) ** 2
    nearest = int(cells[gaps.argmin()])
    if gaps.min() > 0.35**2:
        return False
    return plan.is_clear(pose.point, (float(plan.cell_x[nearest]), float(plan.cell_y[nearest])), plan.free)


def _face(body: HouseholdEmbodiment, target: str, *, within: float = 0.5) -> Script:
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


# -- doing something --------------------------------------------------------------------------------------------------


def _do(
    body: HouseholdEmbodiment,
    interaction: Interaction,
    target: str,
    *,
    near: str | None = None,
    done: tuple[Result, ...] = (Result.OK, Result.ALREADY),
) -> Script:
    """One interaction, with second tries where a second try makes sense.

    `near`: what to come nearer to where `target` is out of reach. `done`: the results that count as success.
    """
    slips = approaches = 0
    while True:
        yield body.interact(interaction, target)
        result = body.senses.result
        if result in done:
            return
        if result is Result.SLIPPED and slips < MAX_SLIPS:
            slips += 1
        elif result is Result.OUT_OF_REACH and approaches < MAX_APPROACHES:
            approaches += 1
            yield from _come_nearer(body, target, near, approaches)
        else:
            attempts = f" ({slips + 1} attempts)" if slips else ""
            raise SkillError(WHY.get(result, "nothing came of it").format(target=_say_target(target)) + attempts)


def _come_nearer(body: HouseholdEmbodiment, target: str, near: str | None, attempt: int) -> Script:
    """To where a place is used from; where that did not do, right up to the thing."""
    if near is not None and attempt == 1 and near not in body.house.rooms and not near.endswith("_floor"):
        yield from _approach(body, near, is_closer=True)
    elif target in body.house.people:
        yield from _approach_person(body, target, within=0.8)
    else:
        yield from _approach(body, target, is_closer=True)


def _say_target(target: str) -> str:
    return "the tray" if target == "robot" else say_name(target)


def pick(body: HouseholdEmbodiment, thing: str, place: str) -> Script:
    """Takes a thing from a place into the hand."""
    if place.endswith("_floor"):
        yield from _approach_thing(body, thing)
    yield from _do(body, Interaction.PICK, thing, near=place)
    _expect(body.senses.held == thing, f"{say_name(thing)} is not in the hand")


def place(body: HouseholdEmbodiment, thing: str, place: str) -> Script:
    """Puts the thing in the hand on or into a place."""
    yield from _do(body, Interaction.PLACE, place, near=place)


def stow(body: HouseholdEmbodiment, thing: str, slot: str) -> Script:
    """Puts the thing in the hand on the tray; which slot is the tray's affair."""
    yield from _do(body, Interaction.PLACE, "robot")


def unstow(body: HouseholdEmbodiment, thing: str, slot: str) -> Script:
    """Takes a thing from the tray into the hand."""
    yield from _do(body, Interaction.PICK, thing)


def receive(body: HouseholdEmbodiment, thing: str, person: str) -> Script:
    """Takes a thing that a person has."""
    yield from _do(body, Interaction.PICK, thing, near=person)


def give(body: HouseholdEmbodiment, thing: str, person: str) -> Script:
    """Hands the thing in the hand to a person."""
    yield from _do(body, Interaction.HAND_OVER, person, near=person)


def say(body: HouseholdEmbodiment, person: str) -> Script:
    """Speaks to a person within earshot."""
    yield from _do(body, Interaction.SAY, person, near=person)


def _at_place(interaction: Interaction, position: int) -> Callable[..., Script]:
    """A skill that is one interaction with a place, the action's `position`-th object."""

    def script(body: HouseholdEmbodiment, *objects: str) -> Script:
        yield from _do(body, interaction, objects[position], near=objects[position])

    return script


def close_up(body: HouseholdEmbodiment, place: str) -> Script:
    """Closes a place; for a door between rooms the robot first gets out of its way, and waits for others to."""
    senses = body.senses
    for _ in range(MAX_APPROACHES):
        if place in body.house.doorways and senses.distance(place) < CLEAR_OF_DOOR:
            cells = body.floorplan.cells_at(place, room=senses.room)
            yield from _drive(body, cells, lambda: senses.distance(place) >= CLEAR_OF_DOOR, towards=say_name(place))
        yield from _do(body, Interaction.CLOSE, place, near=place, done=(Result.OK, Result.ALREADY, Result.NO_ROOM))
        if senses.result is not Result.NO_ROOM:
            return
        yield from _stand(body)
    raise SkillError(f"something stands in {say_name(place)}")


def _run(body: HouseholdEmbodiment, thing: str, place: str) -> Script:
    """Switches a place on for the sake of a thing in it; one that is on already has done its work and does nothing."""
    yield from _do(body, Interaction.SWITCH_ON, place, near=place, done=(Result.OK,))


# -- finding out ------------------------------------------------------------------------------------------------------


def inspect(body: HouseholdEmbodiment, place: str) -> Script:
    """Looks around a place until all that lies on or in it was in view."""
    senses = body.senses
    for action in _looks(body, place):
        if place in senses.inspected:
            return
        yield action
    if place not in senses.inspected:
        raise SkillError(f"{say_name(place)} could not be looked at from anywhere")


def sense(body: HouseholdEmbodiment, fact: str, thing: str, place: str) -> Script:
    """Looks at a thing at a place until its states are seen."""
    senses = body.senses
    for action in _looks(body, place):
        if senses.is_seen(thing) and senses.places.get(thing) == place:
            return
        if place in senses.inspected:
            raise SkillError(f"{say_name(thing)} is not at {say_name(place)}")
        yield action
    if not senses.is_seen(thing):
        raise SkillError(f"{say_name(thing)} cannot be seen at {say_name(place)}")


def sense_carried(body: HouseholdEmbodiment, fact: str, thing: str) -> Script:
    """Looks at a thing in the hand or on the tray."""
    yield from _see(body, thing, "carried")


def sense_given(body: HouseholdEmbodiment, fact: str, thing: str, person: str) -> Script:
    """Looks at a thing that a person has."""
    yield from _face(body, person)
    yield from _see(body, thing, f"with {person}")


def _see(body: HouseholdEmbodiment, thing: str, where: str) -> Script:
    for _ in range(LOOK_STEPS):
        if body.senses.is_seen(thing):
            return
        yield body.rest()
    raise SkillError(f"{say_name(thing)} is not {where}")


def sense_place(body: HouseholdEmbodiment, fact: str, place: str) -> Script:
    """Looks at a place until its states are seen; for a doorway, whether its door is open."""
    senses = body.senses
    for action in _looks(body, place):
        if senses.is_seen(place):
            return
        yield action
    if not senses.is_seen(place):
        raise SkillError(f"{say_name(place)} cannot be seen")


def _looks(body: HouseholdEmbodiment, place: str) -> Iterator[Action]:
    """The actions of looking at a place from one spot after the other; ends when all spots are used up."""
    if place.endswith("_floor"):
        yield from _look_over_floor(body, place)
        return
    yield from _face(body, place)
    yield from _stand(body)
    for spot in _spots(body, place):
        yield from _drive(body, spot, lambda: False, towards=say_name(place))
        yield from _face(body, place, within=0.3)
        yield from _stand(body)


def _stand(body: HouseholdEmbodiment) -> Iterator[Action]:
    for _ in range(LOOK_STEPS):
        yield body.rest()


def _spots(body: HouseholdEmbodiment, place: str) -> Iterator[Cells]:
    """Single cells around a place to look at it from, spread out."""
    for room in body.floorplan.rooms_of(place):
        if room == body.senses.room:
            cells = body.floorplan.cells_at(place, room=room)
            for index in range(min(MAX_SPOTS, cells.size)):
                at = index * cells.size // MAX_SPOTS
                yield cells[at : at + 1]


def _look_over_floor(body: HouseholdEmbodiment, floor: str) -> Iterator[Action]:
    """Turns round at the middle of the room, then at spots all over it, nearest first."""
    room = floor.removesuffix("_floor")
    plan, senses = body.floorplan, body.senses
    yield from _turn_round(body)
    left, bottom, right, top = body.house.rooms[room].rect
    count = max(1, round((right - left) / 2.5)), max(1, round((top - bottom) / 2.5))
    spots = [
        (left + (i + 0.5) * (right - left) / count[0], bottom + (j + 0.5) * (top - bottom) / count[1])
        for i in range(count[0])
        for j in range(count[1])
    ]
    while spots:
        spots.sort(key=lambda spot: math.hypot(spot[0] - senses.pose.x, spot[1] - senses.pose.y))
        x, y = spots.pop(0)
        cells = plan.cells_around(x, y, nearest=0.0, farthest=0.6, room=room)
        if cells.size:
            yield from _drive(body, cells, lambda: False, towards=say_name(room))
            yield from _turn_round(body)


def _turn_round(body: HouseholdEmbodiment) -> Iterator[Action]:
    """Half a turn and a bit each time: with a field of view over 180° two headings see everything."""
    for _ in range(2):
        yield from _stand_briefly(body)
        target = body.senses.pose.heading + math.pi
        for _ in range(30):
            error = wrap(target - body.senses.pose.heading)
            if abs(error) < 0.2:
                break
            yield body.drive(0.0, steer_turn(error, body.config.limits))
    yield from _stand_briefly(body)


def _stand_briefly(body: HouseholdEmbodiment) -> Iterator[Action]:
    for _ in range(4):
        yield body.rest()


# -- people -----------------------------------------------------------------------------------------------------------


def follow(body: HouseholdEmbodiment, person: str, start: str, goal: str) -> Script:
    """Asks a person to lead the way to the room `goal` and keeps behind them until both are there."""
    senses = body.senses
    yield from _step_up_to(body, person)
    yield from _do(body, Interaction.SAY, body.house.floor_of(goal), near=person)

    def are_there() -> bool:
        return senses.room == goal and senses.room_of_person(person) == goal and senses.is_seen(person)

    yield from _keep_behind(body, person, are_there, goal=goal)


def tag_along(body: HouseholdEmbodiment, person: str) -> Script:
    """Asks a person to lead the way wherever they like and keeps behind them until they stay where they are."""
    senses = body.senses
    yield from _step_up_to(body, person)
    yield from _do(body, Interaction.SAY, "robot", near=person)
    stood_at, since = senses.position(person), senses.seconds

    def have_stayed() -> bool:
        nonlocal stood_at, since
        now = senses.position(person)
        if now is None or stood_at is None or math.dist(now, stood_at) > 0.1:
            stood_at, since = now, senses.seconds
        is_with = senses.distance(person) <= 1.2 and senses.room == senses.room_of_person(person)
        return is_with and senses.is_seen(person) and senses.seconds - since > SETTLED_SECONDS

    yield from _keep_behind(body, person, have_stayed)


def _step_up_to(body: HouseholdEmbodiment, person: str) -> Script:
    """Drives to where nobody else is as near as this person: who is asked to lead the way is the nearest."""
    senses, plan = body.senses, body.floorplan
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
    yield from _drive(body, cells[nearest] if nearest.any() else cells, is_nearest, towards=person, besides=person)


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
    """Goes where a person out of sight must be: on towards their goal, else to where they were last and beyond."""
    senses, plan = body.senses, body.floorplan
    position = senses.position(person)
    if goal is not None and senses.room != goal:
        yield from _drive_briefly(body, plan.cells_at(body.house.floor_of(goal), room=goal), person)
        return
    spots = [] if position is None else [plan.cells_around(*position, nearest=0.0, farthest=0.4, room=None)]
    if position is not None:
        doorways = body.house.doorways
        nearest = min(doorways, key=lambda name: (plan.distance_to(name, *position), name))
        spots += [plan.cells_at(nearest, room=room) for room in doorways[nearest].rooms]
    for spot in spots:
        if spot.size:
            yield from _drive(body, spot, lambda: senses.is_seen(person), towards=person, besides=person)
        for action in _turn_round(body):
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


def _expect(holds: bool, problem: str) -> None:
    if not holds:
        raise SkillError(problem)


SKILLS: dict[str, Callable[..., Script]] = {
    "move": move,
    "pass": pass_doorway,
    "open-up": _at_place(Interaction.OPEN, 0),
    "close-up": close_up,
    "pick": pick,
    "place": place,
    "stow": stow,
    "unstow": unstow,
    "receive": receive,
    "give": give,
    "switch-on": _at_place(Interaction.SWITCH_ON, 0),
    "switch-off": _at_place(Interaction.SWITCH_OFF, 0),
    "heat": _run,
    "wash": _run,
    "chill": _at_place(Interaction.CLOSE, 1),
    "rinse": _at_place(Interaction.CLEAN, 1),
    "fill": _at_place(Interaction.FILL, 1),
    "drain": _at_place(Interaction.EMPTY, 1),
    "drain-place": _at_place(Interaction.EMPTY, 0),
    "wipe": _at_place(Interaction.CLEAN, 0),
    "inspect": inspect,
    "sense": sense,
    "sense-held": sense_carried,
    "sense-given": sense_given,
    "sense-place": sense_place,
    "say": say,
    "follow": follow,
    "tag-along": tag_along,
}
"""By the name of the PDDL action; called with the body and the action's objects in order."""
