"""Asides: words between the orders that ask nothing and order nothing: tag questions, musings, reasons."""

from __future__ import annotations

from collections.abc import Collection

from decomplex_bt.understanding.cues import normal_form
from decomplex_bt.understanding.document import Document

_TAGS = frozenset("is has have does do did can will would".split())
_TAGGED = frozenset("he she it they you there we".split())
_MUSING = frozenset("think see remember recall guess".split())
_REASONS = frozenset(("since", "because", "cause", "cos", "cuz"))
_CONDITIONS = frozenset(("if", "unless", "when", "whether", "once"))
_ENDS = frozenset((".", "?", "!", ";", ",", ":", "and", "or", "but", "so"))


def asides(document: Document, tasks: Collection[int]) -> frozenset[int]:
    """The tokens of all asides in which no token is among the `tasks`."""
    found: set[int] = set()
    for i in range(len(document)):
        for words in (tag_question(document, i), musing(document, i), reason(document, i)):
            if words is not None and not any(j in tasks for j in words):
                found.update(words)
    return frozenset(found)


def tag_question(document: Document, at: int) -> range | None:
    """The words of the tag question in which token `at` is the verb ("he's asleep, is he?", "it's on, isn't it?"), or
    None."""
    said = [normal_form(token.lower) for token in document.tokens[max(0, at - 1) : at + 4]]
    words = [word for word in said if word != "not"]
    is_tag = at > 0 and len(words) >= 4 and words[0] == "," and words[1] in _TAGS and words[2] in _TAGGED
    return range(at, at + said.index("?") - 1) if is_tag and words[3] == "?" else None


def musing(document: Document, at: int) -> range | None:
    """The words in which somebody thinks aloud, from token `at` on: "let me think", "let me see, ..."; or None."""
    said = [token.lower for token in document.tokens[at : at + 4]]
    if len(said) < 3 or said[0] != "let" or said[1] not in ("me", "us") or said[2] not in _MUSING:
        return None
    return range(at, at + 3) if said[3:] == [] or not said[3].isalpha() else None


def reason(document: Document, at: int) -> range | None:
    """The clause that token `at` is in, where it only tells why ("since the fan is broken"); or None."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[at].lower in _ENDS:
        return None
    start = stop = at
    while start and sentences[start - 1] == sentences[at] and tokens[start - 1].lower not in _ENDS:
        if tokens[start].lower in _REASONS:
            break
        start -= 1
    while stop < len(tokens) and sentences[stop] == sentences[at] and tokens[stop].lower not in _ENDS:
        stop += 1
    said = [token.lower for token in tokens[start:stop]]
    return range(start, stop) if said[0] in _REASONS and _CONDITIONS.isdisjoint(said) else None
