"""Ones: which things "one" cannot be one of."""

from __future__ import annotations

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate

_INDEFINITE = frozenset(("a", "an", "another"))
_FINDING = frozenset(("searching", "check_state"))


def is_not_one(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a gap is a "one" that cannot mean a candidate."""
    return (
        _is_single(context, gap, candidate)
        or _is_known_beside_any(context, gap, candidate)
        or _is_second_choice(context, gap, candidate)
    )


def _is_single(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a single known thing, where a case asks of one of several that were named: "feed the
    rabbits and clean *their hutch*, and if *one*'s ill, ..."."""
    tokens = context.observed.document.tokens
    is_asked = gap.form == "one" and len(gap.tokens) == 1 and gap.is_certain and gap.task.type == "check_state"
    if not is_asked or tokens[candidate.head].tag != "NN" or tokens[candidate.tokens.start].tag not in ("DT", "PRP$"):
        return False
    is_known = tokens[candidate.tokens.start].lower not in ("a", "an")
    named = (c for c in context.pool if c.type == "object" and not c.mention and c.tokens.stop <= gap.position)
    return is_known and any(tokens[c.head].tag == "NNS" for c in named)


def _is_known_beside_any(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a known thing, where finding or having "one" is the case of an order that names any of a
    kind as well: "put *the flowers* in a vase if you can find *one*"."""
    document = context.observed.document
    is_any = gap.word == "one" and (len(gap.tokens) == 1 or document.tokens[gap.tokens.start].lower in _INDEFINITE)
    if not is_any or gap.task.type not in _FINDING or _is_indefinite(document, candidate):
        return False
    verb = document.indices(gap.task.span).start
    is_case = any(condition == gap.task.id for condition, _ in context.paths.get(candidate.owner, ()))
    if not is_case or candidate.tokens.stop > verb or gap.position < verb:  # "if *one* is full"
        return False
    named = (c for c in context.pool if c.owner == candidate.owner and c.tokens.stop <= verb)
    return any(_is_indefinite(document, c) for c in named)


def _is_indefinite(document: Document, candidate: Candidate) -> bool:
    return not candidate.mention and document.tokens[candidate.tokens.start].lower in _INDEFINITE


def _is_second_choice(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is only what is brought where the first cannot be, and "one" is meant in either case: "bring
    me a coffee, or *a tea* if there's none, and take *one* to Ann"."""
    number, path = candidate.owner, context.paths.get(candidate.owner, ())
    if gap.form != "one" or len(gap.tokens) != 1 or not path or max(number, path[-1][0]) >= gap.task.id:
        return False
    case, side = path[-1]
    if any(condition == case for condition, _ in context.paths.get(gap.task.id, ())):
        return False
    kind = candidate.type
    return any(
        other.id < min(number, case)
        and other.type == candidate.task_type
        and context.paths.get(other.id, ())[-1:] == ((case, "then" if side == "else" else "else"),)
        and any(not c.mention for c in context.arguments(other.id, kind))
        for other in context.tasks
    )
