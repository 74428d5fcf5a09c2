"""Shares: what it is asked for that some of what lies somewhere may be: "see what's on the sofa, and if *any of it is
laundry*, fold it" asks for laundry on the sofa."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.relatives import BE, WHATEVER

_SHARES = frozenset("any some anything something one none".split())
_OF_WHAT = frozenset("it that this them those these".split())
_LYING = frozenset("lying sitting standing hanging left in on under at behind".split())
_WHERE = frozenset("in on under at behind inside beside".split())
_LONGEST = 4
"""Within so many words behind its "what" a clause says where something is [tokens]."""


def with_shares(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments; a check that asks if any of what was spoken of is of some kind asks for that kind, and where that
    is, if "what's on the sofa" told it. Of a state ("if any of it is wet") nothing changes."""
    kept = list(arguments)
    for check in (i for i, kind in tasks.items() if kind == "check_state"):
        own = {a.type: a for a in kept if a.owner == check}
        if "state" not in own or not own.keys() <= {"object", "state"} or not _is_of_share(document, check):
            continue
        kind = own["state"].tokens
        last = document.tokens[kind[-1]]
        where = _place(document, check - 3)
        if kind.start < check or not (last.is_noun or last.tag in ("NN", "NNS")) or not where:
            continue
        kept = [a for a in kept if a.owner != check]
        kept.append(FoundArgument("object", check, kind, CERTAIN))
        kept.append(FoundArgument("location", check, where, CERTAIN))
    return kept


def _is_of_share(document: Document, check: int) -> bool:
    """Whether it is asked if "any of it" *is* something."""
    words = [token.lower for token in document.tokens[max(0, check - 3) : check + 1]]
    is_part = len(words) > 3 and words[0] in _SHARES and words[1] == "of" and words[2] in _OF_WHAT
    return is_part and words[3] in BE


def _place(document: Document, stop: int) -> range:
    """The "on the sofa" of the last "what's lying on the sofa" before a token; empty where there is none."""
    tokens = document.tokens
    for i in range(stop - 1, -1, -1):
        if tokens[i].lower not in WHATEVER or i + 2 >= stop or tokens[i + 1].lower not in BE:
            continue
        if tokens[i + 2].lower not in _LYING:
            continue
        led = next((k for k in range(i + 2, min(stop, i + _LONGEST)) if tokens[k].lower in _WHERE), None)
        place = next((chunk for chunk in noun_chunks(document) if led is not None and chunk.start == led + 1), None)
        if led is not None and place is not None and place.stop <= stop:
            return range(led, place.stop)
    return range(0)
