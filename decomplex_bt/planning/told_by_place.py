"""Places that a clause tells by who or what is there: "the room where Tom is", "the room with the tv".

Where something fixed is, the map tells. Where people and things are, nobody knows beforehand: to them the robot can go,
and what else it is to do there is refused.
"""

from __future__ import annotations

import re
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError
from decomplex_bt.hesitation import without_hesitation
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.planning.abilities import is_fixed
from decomplex_bt.planning.phrases import named_by, rooms_of
from decomplex_bt.planning.prepositions import split_preposition

_IS = r"(?:\s+(?:is|are|am)|['\u2019](?:s|re|m))\b"
_NOT_ONE = r"(?!(?:and|or|if|then|when|while|as|before|after|there)\b)"
_WHERE = re.compile(rf"\s+(?:where|in which)\s+(?P<who>[^,.;:!?]+?){_IS}(?:\s+\w+ing\b)?", re.IGNORECASE)
_WITHIN = re.compile(rf"\s+(?:that\s+|which\s+)?(?P<who>{_NOT_ONE}\w+(?:\s+\w+){{0,2}}?){_IS}\s+in\b", re.IGNORECASE)
_HAVING = re.compile(
    rf"\s+(?:with|(?:that|which) has|where there{_IS})\s+(?P<who>(?:the|an?|my|our)\s+\w+)(?P<more>\s+\w+)?",
    re.IGNORECASE,
)
_SOMEHOW = re.compile(r"\s+where\b(?P<who>)[^,.;:!?]*", re.IGNORECASE)
_ALONE = re.compile(rf"(?:to\s+)?(?:where|wherever)\s+(?P<who>[^,.;:!?]+?){_IS}", re.IGNORECASE)
_CLAUSE = re.compile(r"\s+(?:where|in which|that|which|with)\b.*$", re.IGNORECASE)
_PLACES = frozenset(("goal", "path", "recipient", "location", "source"))


def with_places_told(instruction: Instruction, task: Task, domain: Domain) -> Task:
    """The task with the room that a clause tells in place of "the room", or with who is gone to.

    Raises `ImpossibleGoalError` where nobody can know beforehand which of several places the clause is of.
    """
    for argument in task.arguments:
        if argument.type not in _PLACES and (argument.type != "object" or task.type == "informing"):
            continue
        alone = _ALONE.fullmatch(argument.value)
        if alone is not None:
            if (value := _beside(task, alone["who"], domain)) is not None:
                task = _with_value(task, argument, value)
        elif argument.span is not None and argument.value == without_hesitation(argument.span.of(instruction.text)):
            task = _told(instruction, task, argument, domain)
    return task


def _told(instruction: Instruction, task: Task, argument: Argument, domain: Domain) -> Task:
    """The task with an argument as the clause in it or behind it tells it, without what was read in that clause."""
    assert argument.span is not None
    head = _CLAUSE.sub("", argument.value)
    start = argument.span.start + len(head)
    names = named_by(head, domain)
    if len(names) < 2 or not all(is_fixed(name, domain) for name in names):
        return task
    are_rooms = all(name in domain.house.rooms for name in names)
    clauses = (_HAVING, _WHERE, _WITHIN, _SOMEHOW) if are_rooms else (_WHERE,)
    clause = next((found for one in clauses if (found := one.match(instruction.text, start))), None)
    if clause is None or any(start < other.span.start < clause.end() for other in instruction.tasks):
        return task
    read = [a for a in task.arguments if a.span is not None and start < a.span.start < clause.end()]
    if any(a.type in ("message", "goal") for a in read):
        return task  # "put the lamp where the tv is"
    value = _value(task, head, clause, are_rooms, domain)
    if value is not None:
        task = replace(task, arguments=tuple(a for a in task.arguments if a not in read))
        return _with_value(task, argument, value)
    if clause[0].split()[0].lower() == "with" or (clause.re is _WITHIN and not _named(clause, domain)):
        return task
    said = instruction.text[argument.span.start : clause.end()]
    raise ImpossibleGoalError(f"which one {said!r} means cannot be known beforehand; say it by name")


def _value(task: Task, head: str, clause: re.Match[str], are_rooms: bool, domain: Domain) -> str | None:
    """What names the place that a clause tells: its room by the map, or who is gone to; None where nothing does."""
    who = _named(clause, domain)
    if not are_rooms or who is None:
        return None
    names = named_by(who, domain)
    rooms = {room for name in names for room in rooms_of(name, domain)}
    if all(is_fixed(name, domain) for name in names):
        preposition = split_preposition(head, domain)[0]
        return f"{preposition} the {rooms.pop().replace('_', ' ')}".strip() if len(rooms) == 1 else None
    return f"to {who}" if task.type == "motion" and clause.re is not _HAVING else None


def _named(clause: re.Match[str], domain: Domain) -> str | None:
    """Who or what a clause says is there, where its words name something."""
    groups = clause.groupdict("")
    longer = f"{groups['who']}{groups.get('more', '')}"
    return next((words for words in (longer, groups["who"]) if named_by(words, domain)), None)


def _beside(task: Task, who: str, domain: Domain) -> str | None:
    """What "where Tom is" alone is a word for: to him, or next to a thing; None where it names nothing."""
    names = named_by(who, domain)
    if not names:
        return None
    is_to = task.type != "placing" or any(name in domain.house.people for name in names)
    return f"to {who}" if is_to else f"next to {who}"


def _with_value(task: Task, argument: Argument, value: str) -> Task:
    return replace(task, arguments=tuple(replace(a, value=value) if a is argument else a for a in task.arguments))
