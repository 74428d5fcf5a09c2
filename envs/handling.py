"""Doing something with hand, voice and switches: the scripts of skills that interact."""

from __future__ import annotations

from collections.abc import Callable

from decomplex_bt.envs.approach import Script, SkillError, approach, approach_person, approach_thing, drive_to, say_name
from decomplex_bt.envs.embodiment import HouseholdEmbodiment
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.looking import inspect, see_place, stand

MAX_SLIPS = 6
"""A grasp that slips is tried again so often; one in twenty slips, so seven in a row are no accident."""
MAX_APPROACHES = 3
"""How often the robot comes nearer when something proves out of reach."""
CLEAR_OF_DOOR = 0.30
"""[m] So far from a doorway's line the robot's body is clear of the door in it."""

WHY = {
    Result.OUT_OF_REACH: "{target} is out of reach",
    Result.NOT_POSSIBLE: "this cannot be done at {target}",
    Result.HAND_FULL: "the hand is full",
    Result.HAND_EMPTY: "the hand is empty",
    Result.CLOSED: "{target} is closed",
    Result.OPEN: "{target} is open",
    Result.NO_ROOM: "there is no room at {target}",
    Result.BROKEN: "{target} is broken",
    Result.SLIPPED: "{target} slipped out of the hand",
    Result.ALREADY: "{target} is so already",
    Result.NOT_THERE: "{target} is not there",
}


def perform(
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
    """To where a place is used from; where that did not do, right up to the thing.

    A thing that is not in view may have been taken away since it was: its place is looked over again.
    """
    if near in body.house.places() and target in body.house.things and not body.senses.is_seen(target):
        yield from inspect(body, near)
        if not body.senses.is_seen(target):
            raise SkillError(f"{say_name(target)} is not there any more")
    if near is not None and attempt == 1 and near not in body.house.rooms and not near.endswith("_floor"):
        yield from approach(body, near, is_closer=True)
    elif target in body.house.people:
        yield from approach_person(body, target, within=0.8)
    else:
        yield from approach(body, target, is_closer=True)


def _say_target(target: str) -> str:
    return "the tray" if target == "robot" else say_name(target)


def pick(body: HouseholdEmbodiment, thing: str, place: str) -> Script:
    """Takes a thing from a place into the hand."""
    if place.endswith("_floor"):
        yield from approach_thing(body, thing)
    yield from perform(body, Interaction.PICK, thing, near=place)
    _expect(body.senses.held == thing, f"{say_name(thing)} is not in the hand")


def place(body: HouseholdEmbodiment, thing: str, place: str) -> Script:
    """Puts the thing in the hand on or into a place."""
    yield from perform(body, Interaction.PLACE, place, near=place)


def stow(body: HouseholdEmbodiment, thing: str, slot: str) -> Script:
    """Puts the thing in the hand on the tray; which slot is the tray's affair."""
    yield from perform(body, Interaction.PLACE, "robot")


def unstow(body: HouseholdEmbodiment, thing: str, slot: str) -> Script:
    """Takes a thing from the tray into the hand."""
    yield from perform(body, Interaction.PICK, thing)


def receive(body: HouseholdEmbodiment, thing: str, person: str) -> Script:
    """Takes a thing that a person has."""
    yield from perform(body, Interaction.PICK, thing, near=person)


def give(body: HouseholdEmbodiment, thing: str, person: str) -> Script:
    """Hands the thing in the hand to a person."""
    yield from perform(body, Interaction.HAND_OVER, person, near=person)


def say(body: HouseholdEmbodiment, person: str) -> Script:
    """Speaks to a person within earshot."""
    yield from perform(body, Interaction.SAY, person, near=person)


def at_place(interaction: Interaction, position: int) -> Callable[..., Script]:
    """A skill that is one interaction with a place, the action's `position`-th object."""

    def script(body: HouseholdEmbodiment, *objects: str) -> Script:
        yield from perform(body, interaction, objects[position], near=objects[position])
        if interaction is Interaction.OPEN:
            body.senses.note_opened(objects[position])
        yield from _look_at_what_was_so(body, objects[position])

    return script


def _look_at_what_was_so(body: HouseholdEmbodiment, place: str) -> Script:
    """Looks at a place that was so already: to have seen it so is to know that nothing was changed there."""
    if body.senses.result is Result.ALREADY:
        yield from see_place(body, place)


def close_up(body: HouseholdEmbodiment, place: str) -> Script:
    """Closes a place; for a door between rooms the robot first gets out of its way, and waits for others to."""
    senses = body.senses
    for _ in range(MAX_APPROACHES):
        if place in body.house.doorways and senses.distance(place) < CLEAR_OF_DOOR:
            cells = body.floorplan.cells_at(place, room=senses.room)
            yield from drive_to(body, cells, lambda: senses.distance(place) >= CLEAR_OF_DOOR, towards=say_name(place))
        yield from perform(body, Interaction.CLOSE, place, near=place, done=(Result.OK, Result.ALREADY, Result.NO_ROOM))
        if senses.result is not Result.NO_ROOM:
            yield from _look_at_what_was_so(body, place)
            return
        yield from stand(body)
    raise SkillError(f"something stands in {say_name(place)}")


def set_running(body: HouseholdEmbodiment, thing: str, place: str) -> Script:
    """Switches a place on for the sake of a thing in it; one that is on already has done its work and does nothing."""
    yield from perform(body, Interaction.SWITCH_ON, place, near=place, done=(Result.OK,))


def _expect(holds: bool, problem: str) -> None:
    if not holds:
        raise SkillError(problem)
