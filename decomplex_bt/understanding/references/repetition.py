"""Repetition: a verb that is said again without its object is of what it was of before: "mop the hall if nobody is
there; else give Ned his paper, and *mop* afterwards"."""

from __future__ import annotations

from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap

_ADDING = frozenset(("too", "also", "well", "likewise"))
"""What says that something else is meant: "if the fern is dry, water *as well*"."""
_NEAR = 3
"""Within so many words behind a verb it is said when, or with what, it is done again [tokens]."""


def done_before(context: Context, gap: Gap) -> range:
    """The words for what an order did before that is given again without an object; empty where there is none."""
    if gap.type != "object" or gap.word or gap.task.type != "change_state":
        return range(0)
    tokens = context.observed.document.tokens
    behind = {token.lower for token in tokens[gap.position + 1 : gap.position + 1 + _NEAR]}
    if not behind.isdisjoint(_ADDING):
        return range(0)
    lemma = context.lemmas[gap.task.id]
    same = [t.id for t in context.tasks if t.id < gap.task.id and t.type == gap.task.type]
    same = [number for number in same if context.lemmas[number] == lemma]
    objects = context.arguments(same[-1], "object") if same else []
    said = [c for c in objects if c.shape in ("whole", "long") or c.mention]
    return max((c.tokens for c in said), key=len, default=range(0))
