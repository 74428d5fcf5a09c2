"""Subjects: of what something is said, which is a thing as a whole with what it belongs to ("*the key to the cabin* is
lost", "*the heater for the tank*, is it on?")."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from decomplex_bt.understanding.document import FINITE, MARKS, Document
from decomplex_bt.understanding.references.chunks import is_numbered, noun_chunks

_BELONGING = frozenset("for to from with about of".split())
_OPENING = MARKS | frozenset("if unless when whether that because since as so once and but".split())
_TAKING_UP = frozenset("it they he she that".split())


@dataclass(frozen=True, slots=True)
class Subject:
    """The tokens of a thing with what it belongs to, and those of the thing alone. `is_topic`: it is named ahead of a
    clause that takes it up by a pronoun."""

    whole: range
    thing: range
    is_topic: bool

    def has_part(self, tokens: range) -> bool:
        """Whether a phrase is within it and leaves some of it out."""
        return self.whole.start <= tokens.start and tokens.stop <= self.whole.stop and tokens != self.whole


def subjects(document: Document) -> Iterator[Subject]:
    """All that clauses open with and that belongs to something else, in text order."""
    tokens = document.tokens
    if document.words.isdisjoint(_BELONGING):
        return
    chunks = {chunk.start: chunk for chunk in noun_chunks(document)}
    for chunk in chunks.values():
        other = chunks.get(chunk.stop + 1)
        is_opening = chunk.start == 0 or tokens[chunk.start - 1].lower in _OPENING
        if other is None or not is_opening or tokens[chunk.stop].lower not in _BELONGING:
            continue
        stop = other.stop + is_numbered(document, other)
        behind = [token.lower for token in tokens[stop : stop + 3]]
        is_topic = len(behind) == 3 and behind[0] == "," and behind[2] in _TAKING_UP and tokens[stop + 1].pos == "AUX"
        if is_topic or (behind and tokens[stop].tag in FINITE):
            yield Subject(range(chunk.start, stop), chunk, is_topic)
