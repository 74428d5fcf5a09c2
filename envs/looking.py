"""Finding something out: the scripts of skills that look."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress

from decomplex_bt.envs.approach import Script, SkillError, drive_to, face, say_name
from decomplex_bt.envs.embodiment import Action, HouseholdEmbodiment
from decomplex_bt.envs.floorplan import Cells
from decomplex_bt.envs.navigation import steer_turn, wrap

LOOK_STEPS = 12
"""[control steps] How long one look at a place from one spot may take."""
LONG, LONGEST = 10.0, 20.0
"""[m] From which length on a room is driven along in one go, and from which that takes longer than is remembered."""
BROAD = 8.0
"""[m] From which breadth on a room is not seen from wall to wall by driving along it."""
FROM_END = 3.5
"""[m] How far from the ends of a long room it is looked round."""
MAX_SPOTS = 8
"""From how many spots a place is looked at before it counts as impossible to inspect."""


def inspect(body: HouseholdEmbodiment, place: str) -> Script:
    """Looks around a place until all that lies on or in it was in view."""
    senses = body.senses
    for action in _looks(body, place):
        if place in senses.inspected:
            return
        yield action
    if place not in senses.inspected:
        is_long = place.endswith("_floor") and max(_sides(body, place)) > LONGEST
        why = "is too long to be seen whole" if is_long else "could not be looked at from anywhere"
        raise SkillError(f"{say_name(place)} {why}")


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
    yield from face(body, person)
    yield from _see(body, thing, f"with {person}")


def _see(body: HouseholdEmbodiment, thing: str, where: str) -> Script:
    for _ in range(LOOK_STEPS):
        if body.senses.is_seen(thing):
            return
        yield body.rest()
    raise SkillError(f"{say_name(thing)} is not {where}")


def sense_place(body: HouseholdEmbodiment, fact: str, place: str) -> Script:
    """Looks at a place until its states are seen; for a doorway, whether its door is open."""
    yield from see_place(body, place)


def see_place(body: HouseholdEmbodiment, place: str) -> Script:
    """Looks at a place or a doorway until it is in view."""
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
    yield from face(body, place)
    yield from stand(body)
    for spot in _spots(body, place):
        yield from drive_to(body, spot, lambda: False, towards=say_name(place))
        yield from face(body, place, within=0.3)
        yield from stand(body)


def stand(body: HouseholdEmbodiment) -> Iterator[Action]:
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
    """Turns round where it stands, then at spots all over the room, nearest first, or as near as it gets to them."""
    room = floor.removesuffix("_floor")
    plan, senses = body.floorplan, body.senses
    yield from turn_round(body)
    breadth, length = sorted(_sides(body, floor))
    if length > LONG:
        yield from _sweep(body, room)
    if length > LONGEST and breadth < BROAD:
        return  # who or what is there was seen on the way
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
            with suppress(SkillError):  # people may stand in its way, and what is behind them be seen past them
                yield from drive_to(body, cells, lambda: False, towards=say_name(room))
            yield from turn_round(body)


def _sides(body: HouseholdEmbodiment, floor: str) -> tuple[float, float]:
    left, bottom, right, top = body.house.rooms[floor.removesuffix("_floor")].rect
    return right - left, top - bottom


def _sweep(body: HouseholdEmbodiment, room: str) -> Iterator[Action]:
    """Looks back near one end of a long room and drives to the other at once: spot by spot the first would be seen
    longer ago than is remembered."""
    left, bottom, right, top = body.house.rooms[room].rect
    x, y = (left + right) / 2, (bottom + top) / 2
    is_wide = right - left > top - bottom
    ends = [(left + FROM_END, y), (right - FROM_END, y)] if is_wide else [(x, bottom + FROM_END), (x, top - FROM_END)]
    pose = body.senses.pose
    ends.sort(key=lambda end: math.hypot(end[0] - pose.x, end[1] - pose.y))
    for end in ends:
        cells = body.floorplan.cells_around(*end, nearest=0.0, farthest=0.6, room=room)
        if cells.size:
            with suppress(SkillError):
                yield from drive_to(body, cells, lambda: False, towards=say_name(room))
            yield from turn_round(body)


def turn_round(body: HouseholdEmbodiment) -> Iterator[Action]:
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
