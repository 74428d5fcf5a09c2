"""Wholes: what is carried where a condition asks of a part of it."""

from __future__ import annotations

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate

_PARTS = frozenset(
    "lid leg zip zipper handle spout tyre tire wheel strap clasp hinge sleeve hem seam rim brake pedal saddle".split()
)
"""What comes along with the thing that it is part of."""
_APART = frozenset("off missing gone lost dirty".split())
"""States of parts that are, or may be, handled by themselves."""
_CARRYING = frozenset(("bringing", "placing"))
_HANDLING = _CARRYING | {"taking", "change_state"}


def is_part(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is no part that a condition asked of, since that is put nowhere without the thing that was handled
    before: "move the chair, and if *a leg* is loose, leave it here". A part that is off, or goes back on, can be."""
    is_carried = gap.type == "object" and gap.word == "it" and gap.task.type in _CARRYING
    document, path = context.observed.document, context.paths.get(gap.task.id, ())
    noun = document.tokens[candidate.head].lemma
    if not is_carried or not path or noun not in _PARTS or candidate.mention or _is_fitted(document, gap):
        return False
    check = next((task for task in context.tasks if task.id == candidate.owner), gap.task)
    is_asked = candidate.type == "object" and context.first.get(check.id) == path[-1][0]
    states = {word for a in check.arguments if a.type == "state" for word in a.value.lower().split()}
    if not is_asked or check.type != "check_state" or not states.isdisjoint(_APART):
        return False
    before = [c for c in context.pool if 0 < c.owner < check.id and not c.mention]
    wholes = [c.text.lower() for c in before if _is_whole(document, c)]
    goals = [a.value.lower() for a in gap.task.arguments if a.type == "goal"]
    is_of_its_own = any(document.tokens[c.head].lemma == noun for c in before)
    return bool(wholes) and not is_of_its_own and not any(whole in goal for whole in wholes for goal in goals)


def _is_fitted(document: Document, gap: Gap) -> bool:
    """Whether something is put "back", "off" or "on": "put it back on", "leave it on"."""
    behind = [token.lower for token in document.tokens[gap.tokens.stop : gap.tokens.stop + 2]]
    return behind[:1] in (["back"], ["off"]) or (behind[:1] == ["on"] and {*behind[1:]} <= MARKS | {"and"})


def _is_whole(document: Document, candidate: Candidate) -> bool:
    """Whether a candidate is a single thing that was handled or looked at."""
    is_handled = candidate.task_type in _HANDLING and candidate.type == "object"
    is_looked_at = candidate.task_type == "searching" and candidate.type in ("object", "location")
    return (is_handled or is_looked_at) and document.tokens[candidate.head].tag in ("NN", "NNP")
