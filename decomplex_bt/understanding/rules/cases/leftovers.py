"""Whether there is any left: "*got* any bread?", "do we have some bread *left*?"."""

from __future__ import annotations

from decomplex_bt.understanding.document import ENDS, MARKS, Document

_SOME = frozenset("any some enough anything".split())


def asks_got(document: Document, at: int) -> bool:
    """Whether a "got" that begins a sentence asks if there is something: "*got* any bread left?"."""
    tokens = document.tokens
    is_first = at == 0 or tokens[at - 1].text in ENDS or document.sentences[at - 1] != document.sentences[at]
    return is_first and tokens[at].lower == "got" and at + 1 < len(tokens) and tokens[at + 1].lower in _SOME


def is_left_of(document: Document, check: int, at: int) -> bool:
    """Whether a "left" behind a check only says that there is still some of what is asked for: "got any bread *left*",
    "do we have some bread *left*"."""
    between = document.tokens[check + 1 : at]
    is_had = document.tokens[check].lower == "have" and any(token.lower in _SOME for token in between)
    is_left = document.tokens[at].lower == "left" and (is_had or asks_got(document, check))
    return is_left and all(token.text not in MARKS and not token.tag.startswith("V") for token in between)
