"""Unsaid recipients: who is asked ("*ask* whether she is ill") or brought something ("bring me the mug. If it's dirty,
*bring* a glass") where it is not said."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.context import Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.vocabulary import ANYBODY

_SPEAKER = frozenset(("me", "us"))
_BESIDES = frozenset("too also instead well".split())
_WAYS = frozenset(
    "in out up down over back along round around through inside outside home here away off on together".split()
)
_QUESTIONS = frozenset("whether if what when how why which".split())


def asked(context: Context, gap: Gap) -> range:
    """The words of the one person whom the orders before were about, where it is only said what to ask: "if *the lady*
    rings, go up to her. If her door is ajar, ask whether she is ill". Open where somebody else was called or gone to
    right before, or where it is asked who or where somebody is."""
    document, before = context.observed.document, context.types.get(gap.task.id - 1)
    is_unsaid = gap.type == "recipient" and not gap.word and context.lemmas[gap.task.id] == "ask"
    messages = [document.indices(a.span) for a in gap.task.arguments if a.type == "message" and a.span]
    first = {document.tokens[message.start].lower for message in messages}
    if not is_unsaid or first.isdisjoint(_QUESTIONS) or before in ("informing", "motion"):
        return range(0)
    named = [
        c
        for c in context.pool
        if not c.mention and c.tokens.stop <= gap.position and kind_of(context, c) in ("person", "name")
    ]
    told = [c for c in named if c.owner and c.shape in ("whole", "long") and c.type in ("object", "recipient")]
    is_one = len({c.head for c in named}) == 1 and len(told) == 1
    if not is_one or document.tokens[told[0].tokens.start].lower in ANYBODY:
        return range(0)
    relation = context.relation(told[0].owner, gap.task.id)
    is_there = relation in ("same", "outer") or relation.startswith("condition.then")
    return told[0].tokens if is_there else range(0)


def with_speaker(document: Document, tasks: Sequence[Task]) -> tuple[Task, ...]:
    """The tasks, those for the speaker too that bring something behind what is brought to "me" or "us", by the same
    plain verb or "too", "as well" or "instead", and do not say where to."""
    found: list[Task] = []
    speaker = ""
    starts = [document.indices(task.span).start for task in tasks] + [len(document)]
    for task, start, end in zip(tasks, starts, starts[1:], strict=False):
        said = {argument.type for argument in task.arguments}
        if task.type == "bringing" and speaker and not said & {"recipient", "goal"}:
            stop = next((j for j in range(start, end) if document.tokens[j].text in MARKS), end)
            words = {token.lower for token in document.tokens[start + 1 : stop]}
            is_like = document.tokens[start].lemma == "bring" or not _BESIDES.isdisjoint(words)
            if is_like and _WAYS.isdisjoint(_loose(document, task, start + 1, stop)):
                task = replace(task, arguments=(Argument("recipient", speaker, None, task.confidence), *task.arguments))
        found.append(task)
        if task.type in ("informing", "motion", "following") or _is_of_other(task):
            speaker = ""  # "go to Gran and bring a biscuit"
        received = [value.lower().split()[-1] for value in task.values("recipient")]  # "me", "for me"
        received = received if task.type == "bringing" else []
        speaker = next((value for value in received if value in _SPEAKER), "" if received else speaker)
    return tuple(found)


def _is_of_other(task: Task) -> bool:
    """Whether a check is of somebody by name, or of "him" or "her": "if *Tom* is cold"."""
    what = task.value("object") or ""
    return task.type == "check_state" and (what[:1].isupper() or what.lower() in ("he", "she"))


def _loose(document: Document, task: Task, start: int, stop: int) -> set[str]:
    """The words from `start` to `stop` that are no part of an argument."""
    within = {j for a in task.arguments if a.span is not None for j in document.indices(a.span)}
    return {document.tokens[j].lower for j in range(start, stop) if j not in within}
