"""Undoing: what is put right in a case is what that case is of ("wash the pan. If *the sink* is full, empty *it*")."""

from __future__ import annotations

from decomplex_bt.understanding.changes import change
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap

_TO_WHOLES = "water"
"""What is done to something for the state of its part: "the fern looks sad; if *the soil* is dry, water it"."""


def undone(context: Context, gap: Gap) -> range:
    """The words for what is in the state that a verb ends, right behind which it stands, where "it" names no thing;
    empty where there is none, or the order before is of the same verb."""
    if gap.type != "object" or gap.word not in ("it", "them") or gap.task.type != "change_state":
        return range(0)
    check = next((task for task in context.tasks if task.id == gap.task.id - 1), None)
    path = context.paths.get(gap.task.id, ())
    if check is None or check.type != "check_state" or not path or path[-1] != (check.id, "then"):
        return range(0)
    verb = context.lemmas[gap.task.id].split()[0]
    states = {a.value.lower().split()[-1] for a in check.arguments if a.type == "state"}
    if verb == _TO_WHOLES or states.isdisjoint(change(verb).ends):
        return range(0)
    document = context.observed.document
    tag = ("NN", "NNP") if gap.word == "it" else ("NNS",)
    named = [c for c in context.pool if (c.owner, c.type) == (check.id, "object") and not c.mention]
    named = [c for c in named if c.shape in ("whole", "long") and document.tokens[c.head].tag in tag]
    is_thing = len(named) == 1 and kind_of(context, named[0]) not in ANIMATE
    return named[0].tokens if is_thing else range(0)
