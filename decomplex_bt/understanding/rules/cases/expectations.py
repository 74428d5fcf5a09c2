"""Expectations: what somebody or something is waited for to do ("wait *for Kim to finish*")."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from decomplex_bt.understanding.document import MARKS, Document

_AHEAD = frozenset("not n't nt never to you i we".split())
"""What tells that a "wait" is no order, or forbidden."""
_NAMING = frozenset(("DET", "ADJ", "NOUN", "PROPN", "PRON", "NUM"))
_LONGEST = 5
"""The most words by which somebody or something is named."""
_ANEW = frozenset("as once when".split())


class Expectation(NamedTuple):
    """Tokens: the "for" of a "wait for", `who` or what is waited for, the `verb` of what is to be done or so."""

    opening: int
    who: range
    verb: int


def expectations(document: Document) -> Iterator[Expectation]:
    """Every order to wait for somebody or something to do something; not where the next clause says it again ("wait for
    it to cool; once it's cold, ...")."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-4] if "wait" in document.words else ()):
        is_wait = token.lower == "wait" and tokens[i + 1].lower == "for"
        if not is_wait or any(t.lower in _AHEAD for t in tokens[max(0, i - 2) : i]):
            continue
        to = next((j for j in range(i + 3, min(len(tokens) - 1, i + 3 + _LONGEST)) if tokens[j].lower == "to"), i)
        is_named = to > i and all(t.pos in _NAMING or t.tag in ("PRP$", "POS") for t in tokens[i + 2 : to])
        is_done = is_named and tokens[to + 1].lower == tokens[to + 1].lemma and tokens[to + 1].pos != "DET"
        mark = next((j for j in range(to + 1, len(tokens) - 1) if tokens[j].text in MARKS), to)
        if is_done and tokens[mark + 1].lower not in _ANEW:
            yield Expectation(i + 1, range(i + 2, to), to + 1)
