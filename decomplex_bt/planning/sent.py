"""Places that follow from the tasks before: where somebody is sent to see whether there is something ("go to the
kitchen and check if there is milk"), and the room whose door was named ("if the bathroom door is open, go *in*")."""

from __future__ import annotations

import re
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.planning.phrases import named_by

_THERE_IS = re.compile(r"\b(?:if|whether|that)\s+there(?:['\u2019]?s|['\u2019]re|\s+is|\s+are)\b", re.IGNORECASE)
_SENTENCE_END = re.compile(r"[.!?;]\s")
_WHERE = ("location", "source", "state")
_IN = frozenset(("in", "inside"))
_ENTERING = frozenset(("enter", "come", "go", "walk", "step", "head", "pop"))
_DOOR_OF = re.compile(r"^(?:.*\b)?(?:door|doorway) (?:of|to) ")
_DOOR = re.compile(r"\s+(?:door|doorway)$")
_STANDING = ("object", "goal", "location", "recipient")
"""What may be a door or a room in front of which somebody is."""


def with_place_sent(instruction: Instruction, task: Task, domain: Domain) -> Task:
    """The task with the room to which the task right before it goes, where it asks whether there is something and says
    nothing of where or how that is."""
    before = next((t for t in instruction.tasks if t.id == task.id - 1), None)
    if task.type != "check_state" or task.argument(*_WHERE) is not None or before is None or before.type != "motion":
        return task
    goal, said = before.argument("goal"), [a.span.end for a in task.arguments if a.type == "object" and a.span]
    if goal is None or not said or (before.id, task.id) not in instruction.flow.neighbours():
        return task
    asked = instruction.text[before.span.end : max(said)]
    is_asked = _THERE_IS.search(asked) is not None and _SENTENCE_END.search(asked) is None
    if not is_asked or not _is_room(goal.value, domain):
        return task
    return replace(task, arguments=(*task.arguments, Argument("location", f"in {_bare(goal.value)}")))


def with_room_entered(instruction: Instruction, task: Task, domain: Domain) -> Task:
    """The task with the room as its goal whose door, or which itself, the tasks before it named last, where it only
    says to go in."""
    said = [a for a in task.arguments if a.type in ("goal", "direction")]
    verb = task.span.of(instruction.text).lower()
    is_in = len(said) == 1 and said[0].value.lower() in _IN and verb in _ENTERING
    if task.type != "motion" or not (is_in or (verb == "enter" and not said)):
        return task
    before = (t for t in reversed(instruction.tasks) if t.id < task.id)
    rooms = (room for t in before for a in t.arguments if a.type in _STANDING and (room := _behind(a.value, domain)))
    entered = next(rooms, None)
    if entered is None:
        return task
    return replace(task, arguments=(*(a for a in task.arguments if a not in said), Argument("goal", entered)))


def _behind(words: str, domain: Domain) -> str:
    """The room that words name, or whose door they name: "to the bathroom"; empty where they name neither."""
    room = _DOOR.sub("", _DOOR_OF.sub("", _bare(words.lower())))
    return f"to {room}" if _is_room(room, domain) else ""


def _is_room(words: str, domain: Domain) -> bool:
    names = named_by(words, domain)
    return bool(names) and domain.house.rooms.keys() >= {*names}


def _bare(words: str) -> str:
    """A place without what leads it: "to", "over to", "into"."""
    return re.sub(r"^(?:(?:on|at|in|out|over|up|down|to|into|inside|back)\s+)+", "", words, flags=re.IGNORECASE)
