"""Places: what "there" must be where a check names a place, or where something is left where it was."""

from __future__ import annotations

from decomplex_bt.instruction import Task
from decomplex_bt.understanding.document import MARKS
from decomplex_bt.understanding.references.chunks import head_of, stripped
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap

_BE = frozenset("is are be 's 're".split())
_GOING = frozenset(("placing", "bringing", "motion"))
_APERTURE = "aperture"
_REMAINING = frozenset(("rest", "other", "others", "remainder"))


def place_meant(context: Context, gap: Gap) -> range:
    """The words of the place that "there" must be; empty where English leaves it open."""
    if gap.word == "there" and gap.type in ("location", "goal") and (said := _said(context, gap)):
        return said
    if gap.word != "there" or gap.type != "goal" or gap.task.type not in _GOING:
        return range(0)
    found = _asked(context, gap) or _left(context, gap)
    return found if any(c.tokens == found for c in context.pool) else range(0)


def _said(context: Context, gap: Gap) -> range:
    """The place that a statement tells for which it is ordered: "it's probably *in the car*, so look there"."""
    document = context.observed.document
    tokens, verb = document.tokens, document.indices(gap.task.span).start
    so = next((i for i in range(verb - 1, max(-1, verb - 4), -1) if tokens[i].lower == "so"), None)
    if so is None or so < 1 or tokens[so - 1].text != ",":
        return range(0)
    start = next((i + 1 for i in range(so - 2, -1, -1) if tokens[i].text in MARKS), 0)
    is_statement = any(t.lower in _BE for t in tokens[start : so - 1]) and not any(
        i in context.verbs for i in range(start, so)
    )
    named = [c.tokens for c in context.pool if c.tokens.stop == so - 1 and c.tokens.start > start and not c.mention]
    is_place = bool(named) and tokens[max(named, key=len).start - 1].tag == "IN"
    return max(named, key=len) if is_statement and is_place else range(0)


def _asked(context: Context, gap: Gap) -> range:
    """The place that is asked of, not the one that only tells which it is: "if *the café* next to the station is open,
    take Rita *there*". A thing that is no place stands at it: "if the paint in *the hall* is dry"."""
    path = context.paths.get(gap.task.id, ())
    check = context.by_number.get(path[-1][0]) if path else None
    if check is None or check.type != "check_state":
        return range(0)
    document = context.observed.document
    said = {a.type: document.indices(a.span) for a in check.arguments if a.span is not None}
    if not {"object", "location", "state"} <= said.keys() or said["object"].stop != said["location"].start:
        return range(0)
    return stripped(document, said["object"]) if _is_place(context, said["object"], said["state"]) else range(0)


def _is_place(context: Context, thing: range, state: range) -> bool:
    """Whether a thing is a room or holds others, or can only be a place that is open: "the café"."""
    document, gazetteer = context.observed.document, context.observed.gazetteer
    noun = document.tokens[head_of(document, thing)].lemma
    category = gazetteer.category(noun)
    if category == "furniture":
        return noun in gazetteer.containers or "power" not in gazetteer.changeable.get(noun, ())
    return category == "room" or (not category and gazetteer.pairs.get(document.tokens[state[-1]].lower) == _APERTURE)


def _left(context: Context, gap: Gap) -> range:
    """Where the rest is left: where the things were taken from, not where some of them went ("take two apples from *the
    table* to the hall and leave the rest *there*")."""
    document = context.observed.document
    things = [document.indices(a.span) for a in gap.task.arguments if a.type == "object" and a.span is not None]
    is_rest = any(document.tokens[thing[-1]].lower in _REMAINING for thing in things)
    before = context.by_number.get(gap.task.id - 1)
    if context.lemmas[gap.task.id] != "leave" or not is_rest or before is None:
        return range(0)
    return _source(context, before)


def _source(context: Context, task: Task) -> range:
    document = context.observed.document
    spans = [a.span for a in task.arguments if a.type == "source" and a.span is not None]
    return stripped(document, document.indices(spans[0])) if len(spans) == 1 else range(0)
