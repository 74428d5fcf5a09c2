"""Doors: who is let in, and the door that is got for them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from decomplex_bt.understanding.document import MARKS, Document

_GET_THE_DOOR = ("get", "the", "door")
_NOT_LET = frozenset("not n't nt dont never to who will 'll".split())
_BEHIND_IN = frozenset("and then but if unless when once please first or".split())
_NAMED = frozenset(("DET", "ADJ", "NUM", "NOUN", "PROPN", "PRON"))
PEOPLE = frozenset(("me", "us", "him", "her", "them"))
LONGEST_NAMED = 5
"""The most words by which somebody is named."""


def admitted(document: Document, verb: int) -> range:
    """Who is let in, at a "let" with nothing but them between it and its "in": "let *the plumber* in and show him up";
    empty where the words say anything else ("let her in on it")."""
    tokens = document.tokens
    stop = verb + 1
    while (
        stop < len(tokens)
        and stop - verb <= LONGEST_NAMED
        and (tokens[stop].pos in _NAMED or tokens[stop].tag in ("PRP$", "POS") or tokens[stop].lower in PEOPLE)
    ):
        stop += 1
    behind = tokens[stop + 1] if stop + 1 < len(tokens) else None
    is_end = behind is None or behind.text in MARKS or behind.lower in _BEHIND_IN
    is_let = tokens[verb].lower in ("let", "lets") and stop > verb + 1 and stop < len(tokens)
    return range(verb + 1, stop) if is_let and tokens[stop].lower == "in" and is_end else range(0)


def is_answered(document: Document, verb: int) -> bool:
    """Whether the door is got, which is to open it for who is there: "*get* the door, would you?"."""
    words = [token.lower for token in document.tokens[verb : verb + 4]]
    is_end = len(words) < len(_GET_THE_DOOR) + 1 or words[-1] in MARKS | _BEHIND_IN | {"for"}
    return tuple(words[: len(_GET_THE_DOOR)]) == _GET_THE_DOOR and is_end


def admissions(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """Every order to let somebody in that no task is of: "if it's Aunt May *let* her in"."""
    tokens = document.tokens
    if "let" not in document.words:
        return
    for i, token in enumerate(tokens[:-2]):
        is_denied = any(t.lower in _NOT_LET for t in tokens[max(0, i - 2) : i])
        if token.lower == "let" and i not in tasks and not is_denied and admitted(document, i):
            yield i
