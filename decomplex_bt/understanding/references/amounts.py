"""Amounts: how many or how much of what was named, told without its noun ("if there are *fewer than six*", "freeze
*half*")."""

from __future__ import annotations

from decomplex_bt.understanding.document import Document

_LIMITS = frozenset(
    ((), ("fewer", "than"), ("less", "than"), ("more", "than"), ("at", "least"), ("at", "most"), ("only",), ("over",))
)
"""What stands ahead of a number that says how many there are, or are to be."""
_DOZEN = ("a", "dozen")


def is_count(document: Document, tokens: range) -> bool:
    """Whether words only tell how many: "*fewer than six*", "boil *ten*", "*a dozen*"; not "one"."""
    *ahead, last = (document.tokens[i] for i in tokens)
    words = tuple(token.lower for token in ahead)
    return (last.pos == "NUM" and last.lower != "one" and words in _LIMITS) or (*words, last.lower) == _DOZEN


def is_half(document: Document, tokens: range) -> bool:
    return [document.tokens[i].lower for i in tokens] == ["half"]
