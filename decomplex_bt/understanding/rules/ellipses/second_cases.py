"""Second cases: a further thing and its state behind a condition, its "is" left out ("if the bin is full and *the lid
loose*, ...", "should the mat be soaked or *the basket full*, ..."), or that there is none of it ("if there's bread but
*no butter*, ...")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.rules.ellipses.fragments import Fragment
from decomplex_bt.understanding.states import OPPOSITES, SCALES

_OPENING = frozenset("if unless when whenever once should were".split())
_CASES = frozenset(("if", "when"))
_BE = frozenset("is are was were be 's 're s re".split())
_NO_STATES = frozenset(
    "upstairs downstairs inside outside home away in up down high low good bad big small old light early late".split()
)
"""What may end the name of a thing or a place as well: "the kitchen upstairs"."""
_KNOWN = OPPOSITES.keys() | {word for scale in SCALES for word in scale} | {"missing", "available", "set", "ready"}
_STATES = _KNOWN - _NO_STATES
_DESCRIBING = frozenset(("JJ", "JJR", "VBN", "VBG"))
_NO_NAMES = frozenset(("ADP", "AUX", "PRON", "CCONJ", "SCONJ", "PART", "PUNCT", "ADV"))
_LINKING = frozenset("feel look seem smell sound taste get become stay keep remain turn go appear".split())
"""Verbs that say of a thing how it is, which the tagger may take for nouns: "the casing *feels* hot"."""
_LONGEST = 4
"""The most words that name the thing."""


def second_cases(document: Document) -> Iterator[Fragment]:
    """The second cases of a document, each carried by its state, or by what there is none of."""
    tokens = document.tokens
    for joint, token in enumerate(tokens[:-2]):
        if token.lower in ("and", "but") and _is_some_before(document, joint) and (stop := _none(document, joint + 1)):
            yield Fragment(range(joint, stop), stop - 1, range(joint + 2, stop), range(0))
        if token.lower in ("and", "or") and _is_case_before(document, joint) and (state := _state(document, joint + 1)):
            yield Fragment(range(joint, state + 1), state, range(joint + 1, state), range(0))


def _is_some_before(document: Document, joint: int) -> bool:
    """Whether a case that there is something stands ahead of an "and" without a mark between: "if there's bread"."""
    tokens = document.tokens
    start = next((i + 1 for i in range(joint - 1, -1, -1) if tokens[i].text in MARKS), 0)
    words = [token.lower for token in tokens[start:joint]]
    opening = next((i for i, word in enumerate(words) if word in _CASES), len(words))
    behind = words[opening + 1 :]
    is_there = behind[:1] == ["there"] and behind[1:2] != [] and behind[1] in _BE
    return is_there and not any(token.pos in ("VERB", "SCONJ") for token in tokens[start + opening + 3 : joint])


def _none(document: Document, start: int) -> int:
    """Where the noun phrase behind a "no" at `start` ends, with which its clause does; 0 where none stands."""
    tokens = document.tokens
    stop = start + 1
    while stop < len(tokens) and tokens[stop].pos in ("NOUN", "ADJ", "PROPN"):
        stop += 1
    is_named = tokens[start].lower == "no" and stop > start + 1 and tokens[stop - 1].pos in ("NOUN", "PROPN")
    is_end = stop == len(tokens) or tokens[stop].text in MARKS or tokens[stop].lower == "then"
    return stop if is_named and is_end else 0


def _is_case_before(document: Document, joint: int) -> bool:
    """Whether a case stands ahead of an "and" without a mark between: a subject, a "be", and what is said of it."""
    tokens = document.tokens
    start = next((i + 1 for i in range(joint - 1, -1, -1) if tokens[i].text in MARKS), 0)
    opening = next((i for i in range(joint - 1, start - 1, -1) if tokens[i].lower in _OPENING), None)
    if opening is None or tokens[opening + 1].lower == "there":
        return False
    if opening and tokens[opening].lower in ("should", "were") and tokens[opening - 1].text not in MARKS:
        return False
    if tokens[opening].lower == "were":
        return any(token.lower in _STATES for token in tokens[opening + 2 : joint])
    be = next((i for i in range(opening + 2, joint - 1) if tokens[i].lower in _BE), None)
    return be is not None and not any(t.tag in ("VB", "VBP", "VBZ", "MD") and t.i != be for t in tokens[be:joint])


def _state(document: Document, start: int) -> int | None:
    """The state that ends a clause behind a thing that is named at `start`; or None."""
    tokens = document.tokens
    if tokens[start].tag not in ("DT", "PRP$"):
        return None
    for at in range(start + 2, min(start + 2 + _LONGEST, len(tokens))):
        if tokens[at - 1].pos in _NO_NAMES or tokens[at].text in MARKS or tokens[at - 1].lemma in _LINKING:
            return None
        is_described = tokens[at].tag in _DESCRIBING or tokens[at].tag == "VBD"
        if (tokens[at].lower in _STATES or is_described) and _is_end(document, at + 1):
            return at
    return None


def _is_end(document: Document, stop: int) -> bool:
    """Whether a clause ends before a token: at a mark, or where an order begins without one."""
    tokens = document.tokens
    if stop >= len(tokens) or tokens[stop].text in MARKS or tokens[stop].lower == "then":
        return True
    following = tokens[stop + 1 : stop + 2]
    is_led = bool(following) and following[0].tag in ("DT", "PRP", "PRP$", "RP", "IN")
    return tokens[stop].lower == tokens[stop].lemma and tokens[stop].pos == "VERB" and is_led
