"""Ordinals: which of two things "the former", "the latter" or "the first one" is."""

from __future__ import annotations

from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap

_PLACE_IN_ORDER = {
    ("the", "former"): 0,
    ("the", "latter"): 1,
    ("the", "first", "one"): 0,
    ("the", "second", "one"): 1,
}
_ORDINALS = frozenset(("first", "second", "other", "another"))
_JOINTS = frozenset(("and", "or", "&"))


def one_of_two(context: Context, gap: Gap) -> range:
    """The one that its place in the order of two things joined by an "and" or "or" tells: "the fan and *the lamp*; if
    *the latter* flickers". Empty where no two were joined last, or more of them ("the fan, the lamp and the radio")."""
    document = context.observed.document
    place = _PLACE_IN_ORDER.get(tuple(document.tokens[i].lower for i in gap.tokens))
    if place is None:
        return range(0)
    chunks = [chunk for chunk in noun_chunks(document) if chunk.stop <= gap.tokens.start]
    joined = [
        k
        for k in range(1, len(chunks))
        if chunks[k].start == chunks[k - 1].stop + 1 and document.tokens[chunks[k - 1].stop].lower in _JOINTS
    ]
    if not joined:
        return range(0)
    last = joined[-1]
    before = chunks[last - 1].start - 1
    if last - 1 in joined or (before >= 0 and document.tokens[before].text == "," and before == chunks[last - 2].stop):
        return range(0)
    named = chunks[last - 1 + place]
    if not _ORDINALS.isdisjoint(document.tokens[i].lower for i in chunks[last]):
        return range(0)  # "a car at the gate and *a second* car in the yard"
    return named if any(c.tokens == named for c in context.pool) else range(0)
