"""Sources: where things are taken from, where a goal says that first ("put everything on the couch in the box")."""

from __future__ import annotations

from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.instruction import Argument, Task
from decomplex_bt.planning.phrases import named_by
from decomplex_bt.planning.prepositions import split_preposition

_OFF_A_TOP = frozenset(("on", "off", "from"))
_WHITHER = frozenset(("in", "into", "on", "onto"))


def with_source(task: Task, domain: Domain) -> Task:
    """The task with a source where its goal or path says first where the things are.

    Of everything that may be any place; of other things only what they lie on, for "in the box on the couch" tells
    which box is meant.
    """
    if task.type not in ("placing", "bringing") or task.argument("source", "location") is not None:
        return task
    is_of_all = any(value.lower() in domain.lexicon.all_words for value in task.values("object"))
    path, goal = task.argument("path"), task.argument("goal")
    if is_of_all and path is not None and goal is not None and split_preposition(path.value, domain)[0]:
        return replace(task, arguments=tuple(replace(a, type="source") if a is path else a for a in task.arguments))
    halves = _halves(goal.value, domain) if goal is not None else None
    if halves is None or not (is_of_all or _leads_off(*halves, domain)):
        return task
    others = tuple(argument for argument in task.arguments if argument is not goal)
    return replace(task, arguments=(*others, Argument("source", halves[0]), Argument("goal", halves[1])))


def _leads_off(first: str, second: str, domain: Domain) -> bool:
    """Whether two places tell a way from the top of one to another: "on the counter in the sink"."""
    return split_preposition(first, domain)[0] in _OFF_A_TOP and split_preposition(second, domain)[0] in _WHITHER


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
    names = named_by(words, domain)
    return bool(names) and all(domain.room_of(n) is not None and n not in domain.house.rooms for n in names)
