"""Sources: where everything is taken from, where a goal says that first ("everything on the couch in the box")."""

from __future__ import annotations

from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import Argument, Task
from decomplex_bt.planning.phrases import read_phrases
from decomplex_bt.planning.prepositions import split_preposition


def with_source(task: Task, domain: Domain) -> Task:
    """The task with a source where "everything" is put and its goal or path says first where that is."""
    if task.type not in ("placing", "bringing") or task.argument("source", "location") is not None:
        return task
    if not any(value.lower() in domain.lexicon.all_words for value in task.values("object")):
        return task
    path, goal = task.argument("path"), task.argument("goal")
    if path is not None and goal is not None and split_preposition(path.value, domain)[0]:
        return replace(task, arguments=tuple(replace(a, type="source") if a is path else a for a in task.arguments))
    halves = _halves(goal.value, domain) if goal is not None else None
    if halves is None:
        return task
    others = tuple(argument for argument in task.arguments if argument is not goal)
    return replace(task, arguments=(*others, Argument("source", halves[0]), Argument("goal", halves[1])))


def _halves(words: str, domain: Domain) -> tuple[str, str] | None:
    """Two places one behind the other, of which the second is no room that may tell where the first is."""
    tokens = words.split()
    if split_preposition(words, domain)[0] == "":
        return None
    for i in range(2, len(tokens) - 1):
        first, second = " ".join(tokens[:i]), " ".join(tokens[i:])
        if split_preposition(second, domain)[0] and _names_place(first, domain) and _names_place(second, domain):
            return first, second
    return None


def _names_place(words: str, domain: Domain) -> bool:
    try:
        phrases = read_phrases(words, domain)
    except InputError:
        return False
    return all(domain.room_of(n) is not None and n not in domain.house.rooms for p in phrases for n in p.entities)
