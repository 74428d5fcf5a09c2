"""Fragments: questions without a verb that ask whether something is somewhere ("any letters in the mailbox?")."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from decomplex_bt.understanding.document import Document

_STOPS = frozenset((".", "?", "!", ";", ":", "...", "…"))
_FILLERS = frozenset("and oh so hey ok okay well but , - then also still".split())
_SOME = frozenset("any some anyone anybody someone somebody anything something more another".split())
_NONE = frozenset("no nobody nothing".split())
_ALONE = frozenset("anyone anybody someone somebody anything something nobody nothing".split())
_WHERE = frozenset("in on at under behind inside by near beside outside".split())
_BEHIND = frozenset("then still yet today now already or not please robot , all again anymore there".split())
_IDLE = frozenset(
    "chance idea luck problem need time reason point doubt sign trace news way hope thoughts plan".split()
)
"""Nouns of which no place is asked: "any chance of a drink in the garden?"."""


@dataclass(frozen=True, slots=True)
class Fragment:
    """A question without a verb. Its preposition carries the check."""

    tokens: range
    carrier: int
    object: range
    """What is asked for; empty where it is nobody or nothing."""
    location: range
    """Where, without the preposition."""


def fragments(document: Document) -> Iterator[Fragment]:
    """The fragments of a document, in text order."""
    tokens = document.tokens
    start = 0
    for i, token in enumerate(tokens):
        if token.text in _STOPS:
            if token.text == "?":
                fragment = _fragment(document, start, i)
                if fragment is not None:
                    yield fragment
            start = i + 1


def _fragment(document: Document, start: int, stop: int) -> Fragment | None:
    """The fragment between two marks."""
    tokens = document.tokens
    first = start
    while first < stop and tokens[first].lower in _FILLERS:
        first += 1
    is_denied = first < stop and tokens[first].lower == "not"
    first += is_denied
    if first >= stop or tokens[first].lower not in _SOME | _NONE:
        return None
    if any(token.pos in ("AUX", "VERB") for token in tokens[first:stop]):
        return None
    carrier = next((j for j in range(first + 1, stop) if tokens[j].lower in _WHERE), stop)
    last = stop
    while last > carrier and tokens[last - 1].lower in _BEHIND:
        last -= 1
    is_named = tokens[first].lower in _ALONE or tokens[carrier - 1].pos in ("NOUN", "PROPN")
    is_place = last - carrier > 1 and tokens[last - 1].pos in ("NOUN", "PROPN", "PRON")
    if not is_named or not is_place or not _IDLE.isdisjoint(token.lemma for token in tokens[first:carrier]):
        return None
    begin = first + (tokens[first].lower in _NONE)
    return Fragment(range(start, stop), carrier, range(begin, carrier), range(carrier + 1, last))
