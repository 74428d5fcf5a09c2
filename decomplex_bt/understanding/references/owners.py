"""Owners and kinds: things that are told by whose they are ("mine", "Ann's"), or of what kind ("if there's white")."""

from __future__ import annotations

from decomplex_bt.understanding.references.agreement import OWN
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.vocabulary import QUANTIFIERS


def by_owner(context: Context, gap: Gap) -> range:
    """What is named by whose it is, in the same order, beside "mine" or "Ann's": "put *Kate's things* on the bed and
    *mine* on the chair"."""
    tokens = context.observed.document.tokens
    if gap.form != "own" or gap.type != "object":
        return range(0)
    named = [
        c
        for c in context.arguments(gap.task.id, "object")
        if not c.mention
        and c.tokens.stop <= gap.position
        and c.shape in ("whole", "short")
        and any(tokens[i].tag in ("PRP$", "POS") for i in c.tokens)
        and kind_of(context, c) not in ANIMATE
    ]
    return named[-1].tokens if named else range(0)


def kind_of_it(context: Context, gap: Gap) -> range:
    """What was asked for as any of it, where a case tells only of what kind there is some: "is there any *wine*? If
    there's *white*, open it"."""
    if gap.form != "kind":
        return range(0)
    tokens = context.observed.document.tokens
    asked = [
        c
        for c in context.pool
        if not c.mention
        and c.type == "object"
        and c.owner < gap.task.id
        and c.task_type in ("check_state", "searching")
        and c.shape in ("whole", "short")
        and (tokens[c.tokens.start].lower in QUANTIFIERS or c.tokens.start == c.head)
        and kind_of(context, c) not in ANIMATE
    ]
    return asked[-1].tokens if asked else range(0)


def asked_of(context: Context, gap: Gap) -> range:
    """What the case of an order is of, where that names it by whose or of what kind it is: "charge my phone and Ann's,
    and when *hers* is full, bring me *it*", "if there's *white*, open *it*"."""
    path = context.paths.get(gap.task.id, ())
    if gap.type != "object" or gap.word not in ("it", "them") or len(gap.tokens) != 1 or not path:
        return range(0)
    check = path[-1][0]
    if path[-1][1] != "then" or not check < gap.task.id or any(check < t.id < gap.task.id for t in context.tasks):
        return range(0)
    told = [c for c in context.arguments(check, "object") if c.mention]
    is_told = len(told) == 1 and told[0].mention in {*OWN, told[0].text.split()[0].lower()}
    return told[0].tokens if is_told else range(0)
