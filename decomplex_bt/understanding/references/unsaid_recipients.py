"""Unsaid recipients: who is asked where it is only said what, "*ask* whether she is ill"."""

from __future__ import annotations

from decomplex_bt.understanding.references.context import Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import ANYBODY

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
