"""The clause around a verb, and what its small words say of a check whatever else is in it."""

from __future__ import annotations

import re
from collections.abc import Iterable

from decomplex_bt.instruction import Span

_MARKS = re.compile(r"[.,;:!?]")
_NOBODY = re.compile(r"\b(nobody|no[- ]?one)\b", re.IGNORECASE)
_THERE = re.compile(r"\bthere('s|\u2019s|s| is| are| be| was)\b", re.IGNORECASE)


def clause_around(text: str, verb: Span, verbs: Iterable[Span]) -> str:
    """The words around a verb, without it: from the mark or the last of the other `verbs` before it to the next one."""
    others = [other for other in verbs if other != verb]
    start = max([other.end for other in others if other.end <= verb.start], default=0)
    end = min([other.start for other in others if other.start >= verb.end], default=len(text))
    before, after = text[start : verb.start], text[verb.end : end]
    return f"{_MARKS.split(before)[-1]} {_MARKS.split(after)[0]}"


def is_of_nobody(clause: str) -> bool:
    """Whether it is of nobody's being there ("if nobody is in the kitchen"), so that it asks of anybody's."""
    return _NOBODY.search(clause) is not None


def asks_presence(clause: str) -> bool:
    """Whether it asks only if something is there ("see if there's any milk")."""
    return _THERE.search(clause) is not None
