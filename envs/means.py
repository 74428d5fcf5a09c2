"""What a robot may have to do for a task: deeds that are means to it are no fault, whatever else they bring about."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.bindings import Bindings, candidates
from decomplex_bt.envs.evidence import true_room
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.truth import ROBOT, Truth
from decomplex_bt.planning.ground_task import GroundTask, Referent

if TYPE_CHECKING:
    from decomplex_bt.envs.world import Event

HANDS_OFF = frozenset(("motion", "searching", "check_state", "following", "informing"))
"""Types of tasks for which nothing is taken into the hand."""
_WORKS_ON = ("heats", "cools", "washes", "rinses", "fills", "drains")
_AT_A_PLACE = frozenset((Interaction.FILL, Interaction.EMPTY, Interaction.CLEAN))


def is_means(event: Event, task: GroundTask, bindings: Bindings, domain: Domain) -> bool:
    """Whether an interaction can be part of doing the task, for a robot that has yet to find the things it is about."""
    things = {name for name in _names(task.objects, bindings) if name in domain.house.things}
    named = set(_names(task.referents(), bindings))
    tools = set(_tools(task, bindings, domain))
    target, does = event.target, event.interaction
    handles = task.type not in HANDS_OFF and (event.thing in things or event.thing in tools)
    if does is Interaction.OPEN:
        return target in named or target in domain.house.doorways or (bool(things) and domain.kind(target).is_container)
    if does in (Interaction.CLOSE, Interaction.SWITCH_ON, Interaction.SWITCH_OFF):
        return target in _names(task.objects, bindings) or (task.type == "change_state" and target in tools)
    if does is Interaction.PICK:
        return handles
    if does is Interaction.PLACE:
        return handles and (target == ROBOT or target in tools or _is_goal(target, task, bindings, domain))
    if does in _AT_A_PLACE:
        return task.type == "change_state" and (handles or target in named)
    if does is Interaction.HAND_OVER:
        return handles and target in named
    if does is Interaction.SAY:
        return task.type == "following" if event.goal is not None else task.type == "informing" and target in named
    return False


def is_on_the_way(room: str, start: str, task: GroundTask, bindings: Bindings, domain: Domain, truth: Truth) -> bool:
    """Whether being in a room can serve the task for a robot that was in `start` when it became due.

    Things and people have to be looked for, anywhere; to places, rooms and the user the robot knows the way, but it has
    yet to see which of several windows is still to be closed.
    """
    house = domain.house
    seen_to = {r: r.candidates for r in task.objects if task.seeks_change(r)}
    names = _names(task.referents(), {**bindings, **seen_to})
    if not names or any(name in house.things or (name in house.people and name != house.user) for name in names):
        return True
    ends = {end for name in names for end in _rooms(name, domain, truth)}
    return any(room in _between(domain, start, end) for end in sorted(ends))


def _rooms(name: str, domain: Domain, truth: Truth) -> tuple[str, ...]:
    if name in domain.house.doorways:
        return domain.house.doorways[name].rooms
    room = true_room(domain, truth, name)
    return (room,) if room is not None else ()


def _names(referents: Iterable[Referent], bindings: Bindings) -> tuple[str, ...]:
    """What the phrases may mean for the robot: where nothing in the house fits one, it has yet to find that out."""
    return tuple(n for referent in referents for n in candidates(referent, bindings) or referent.candidates)


def _is_goal(target: str, task: GroundTask, bindings: Bindings, domain: Domain) -> bool:
    """Whether a place is where the task wants its things: the goal, or a place in a room that is the goal."""
    goals = _names([*((task.goal,) if task.goal is not None else ()), *task.recipients], bindings)
    return any(goal == target or goal == domain.room_of(target) or goal in domain.house.things for goal in goals)


def _tools(task: GroundTask, bindings: Bindings, domain: Domain) -> Iterator[str]:
    """Places that change the states of the task's things, and things that wipe its places."""
    if task.type != "change_state":
        return
    for name in _names(task.objects, bindings):
        try:
            tags = set(domain.kind(name).tags)
        except KeyError:
            continue
        for tool in (*domain.house.places(), *domain.house.things):
            kind = domain.kind(tool)
            abilities = _WORKS_ON if name in domain.house.things else ("wipes",)
            if any(tags & set(getattr(kind, ability)) for ability in abilities):
                yield tool


@lru_cache(maxsize=1024)
def _between(domain: Domain, start: str, end: str) -> frozenset[str]:
    """The rooms on any way from one room to another that enters no room twice."""
    ways: list[tuple[str, ...]] = [(start,)]
    found = {start, end}
    while ways:
        way = ways.pop()
        if way[-1] == end:
            found.update(way)
            continue
        for doorway in domain.house.doorways.values():
            if way[-1] in doorway.rooms:
                other = doorway.rooms[0] if doorway.rooms[1] == way[-1] else doorway.rooms[1]
                if other not in way:
                    ways.append((*way, other))
    return frozenset(found)
