"""Amounts: how many or how much of what was named, told without its noun ("if there are *fewer than six*", "freeze
*half*")."""

from __future__ import annotations

from decomplex_bt.understanding.document import Document

_LIMITS = frozenset(
    tuple(words.split())
    for words in (
        "fewer than", "less than", "more than", "no fewer than", "no less than", "no more than", "at least", "at most",
        "up to", "only", "just", "exactly", "about", "around", "over", "under",
    )
)  # fmt: skip
"""What stands ahead of a number that says how many there are, or are to be."""
_DOZENS = frozenset((("a", "dozen"), ("half", "a", "dozen")))


def is_amount(document: Document, tokens: range) -> bool:
    """Whether words only tell how many or how much: "*fewer than six*", "*a dozen*", "*half*"; not a number
    alone, which may as well be a name ("press *12*")."""
    return is_half(document, tokens) or _is_limited(document, tokens)


def _is_limited(document: Document, tokens: range) -> bool:
    """Whether words tell how many by a limit to a number, or by the dozen."""
    words = tuple(document.tokens[i].lower for i in tokens)
    return words in _DOZENS or (words[:-1] in _LIMITS and document.tokens[tokens.stop - 1].pos == "NUM")


def is_half(document: Document, tokens: range) -> bool:
    return [document.tokens[i].lower for i in tokens] == ["half"]
