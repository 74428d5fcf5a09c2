"""Mishaps: what may happen to whoever carries an order out, which is a check and nothing to be done ("if you *break*
one, tell me", "if you *get* stuck, call me")."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from decomplex_bt.understanding.document import MARKS, Document

_OPENING = frozenset(("if", "unless", "should"))
_BETWEEN = frozenset("do happen to accidentally still ever 've have by accident somehow only just".split())
_HAVE = frozenset(("have", "'ve"))
_BREAKING = frozenset(
    "break smash crack chip drop spill lose wake damage scratch hurt tear trip fall slip burn need misplace".split()
)
_COMING_TO = {
    "get": "stuck lost confused tired tangled trapped wet",
    "run": "out low short",
    "make": "mess mistake noise",
    "have": "trouble trouble problem problems difficulty difficulties questions question doubt doubts hand",
    "knock": "over down",
}
"""What else may happen, by a verb and a word behind it within its clause."""
_COMING_TO_WORDS = {verb: frozenset(words.split()) for verb, words in _COMING_TO.items()}
_STATES = frozenset(_COMING_TO["get"].split())
_NEAR = 4
"""Within so many words behind its verb stands what it comes to [tokens]."""
_CANNOT = 2
"""The words of "can't" [tokens]."""
_THINGS = frozenset(("DT", "PRP$", "NN", "NNS", "NNP", "JJ", "CD", "PRP", "JJR"))


@dataclass(frozen=True, slots=True)
class Mishap:
    """`verb`: what carries it; `told`: its arguments by type."""

    verb: int
    told: dict[str, range]


def mishaps(document: Document) -> Iterator[Mishap]:
    """Every mishap that an "if you ..." asks about, from left to right."""
    if "you" not in document.words:
        return
    tokens = document.tokens
    for i, token in enumerate(tokens[:-2]):
        is_opened = token.lower in _OPENING or (token.lower == "case" and tokens[i - 1].lower == "in")
        if not is_opened or tokens[i + 1].lower != "you":
            continue
        if (reached := _reached(document, i + 2)) is not None:
            yield Mishap(reached, {"object": range(reached + 2, reached + 3)})
            continue
        verb = i + 2
        while verb < len(tokens) - 1 and tokens[verb].lower in _BETWEEN and not _is_having(document, verb):
            verb += 1
        stop = next((j for j in range(verb + 1, len(tokens)) if tokens[j].lower in MARKS | {"and", "or"}), len(tokens))
        behind = range(verb + 1, stop)
        if tokens[verb].lemma in _BREAKING and tokens[verb].tag[:2] == "VB":
            yield Mishap(verb, _told(document, behind))
            continue
        words = _COMING_TO_WORDS.get(tokens[verb].lemma, frozenset())
        end = next((j for j in behind[:_NEAR] if tokens[j].lower in words), None)
        if end is not None and tokens[end].lower in _STATES:
            yield Mishap(verb, {"object": range(i + 1, i + 2), "state": range(end, end + 1)})
        elif end is not None:
            yield Mishap(verb, _told(document, range(end, stop) if tokens[verb].lemma in ("run", "knock") else behind))


def _reached(document: Document, first: int) -> int | None:
    """The "get" of what cannot be reached where it is only pointed at: "if you can't *get* at it"."""
    words = [token.lower for token in document.tokens[first : first + _CANNOT + 3]]
    is_denied = words[0] in ("can", "ca", "could") and words[1:_CANNOT] in (["n't"], ["not"])
    is_at = is_denied and words[_CANNOT : _CANNOT + 2] == ["get", "at"] and words[-1] in ("it", "them", "that")
    return first + _CANNOT if is_at else None


def _is_having(document: Document, verb: int) -> bool:
    """Whether a "have" has a thing, and says not what has been done."""
    tokens = document.tokens
    return tokens[verb].lower in _HAVE and tokens[verb + 1].tag not in ("VBN", "VBD", "RB")


def _told(document: Document, behind: range) -> dict[str, range]:
    """The noun phrase or pronoun that begins among the words behind a verb, past a particle or preposition."""
    tokens = document.tokens
    start = next((j for j in behind if tokens[j].tag in _THINGS), None)
    if start is None:
        return {}
    stop = start + 1
    while stop < behind.stop and tokens[stop].tag in _THINGS - {"PRP", "DT", "PRP$"} and tokens[start].tag != "PRP":
        stop += 1
    return {"object": range(start, stop)}
