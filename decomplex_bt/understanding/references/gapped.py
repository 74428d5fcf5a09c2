"""Gapped orders: what two things, people or places of one that leaves its verb out the second time are together."""

from __future__ import annotations

from collections.abc import Container, Sequence
from itertools import takewhile

from decomplex_bt.instruction import Task
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate

_SEVERAL = frozenset("them they both these those".split())
_OPENING = frozenset("close shut open lock unlock".split())
"""What is done to that into which something was put, or from which it was taken."""
_THING, _PERSON, _PLACES = "object", "recipient", ("goal", "source")
_NAMING = (_THING, _PERSON, *_PLACES)


def gapped_pair(context: Context, gap: Gap) -> Candidate | None:
    """What a plural means together after "take the tea to Mum and the coffee to Dad": Mum and Dad where somebody is
    meant, the tea and the coffee where things are; None where no such order went right before."""
    words = {context.observed.document.tokens[i].lower for i in gap.tokens}
    if words.isdisjoint(_SEVERAL) or not words <= _SEVERAL | {"each", "all"}:
        return None
    rows = _rows(context, gap)
    kind = _kind_meant(context, gap, rows)
    if kind not in rows:
        return None
    *others, last = rows[kind]
    text = f"{', '.join(other.text for other in others)} and {last.text}"
    return Candidate(text, last.tokens, last.head, last.owner, kind, last.task_type, "pair")


def is_torn(context: Context, candidate: Candidate) -> bool:
    """Whether a list is none, since its parts lie in two halves of a gapped order: "*the tea and Dad*" of "bring Mum
    the tea and Dad the coffee"."""
    if candidate.shape != "in.across.list":
        return False
    owner = context.by_number.get(candidate.owner)
    return owner is not None and len(_several(owner)) > 1


def _rows(context: Context, gap: Gap) -> dict[str, list[Candidate]]:
    """By type what stands twice or more in the last task before a gap that names anything, if it is a gapped order."""
    named = [c for c in context.pool if not c.mention and c.shape in ("whole", "long", "unnamed") and c.owner]
    for task in reversed(list(takewhile(lambda task: task.id != gap.task.id, context.tasks))):
        own = [c for c in named if c.owner == task.id and c.type in _NAMING]
        if own:
            rows = {kind: [c for c in own if c.type == kind] for kind in _several(task)}
            return {kind: row for kind, row in rows.items() if len(row) > 1} if len(rows) > 1 else {}
    return {}


def _several(task: Task) -> Sequence[str]:
    """The types of which a task has two arguments or more."""
    types = [argument.type for argument in task.arguments if argument.span is not None]
    return [kind for kind in dict.fromkeys(types) if types.count(kind) > 1]


def _kind_meant(context: Context, gap: Gap, rows: Container[str]) -> str:
    """The type of what a plural means by its place; "" where it may be several."""
    if gap.type == "recipient" or (gap.type == "object" and gap.task.type == "following"):
        return _PERSON
    if gap.type != "object" or (gap.task.type == "check_state" and _PERSON in rows):
        return ""  # "if they're ready" may be said of people or things
    if gap.task.type == "change_state" and context.lemmas[gap.task.id] in _OPENING:
        return next((kind for kind in _PLACES if kind in rows), "")
    return _THING
