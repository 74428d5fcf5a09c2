"""Pauses: the time that somebody or something is to be given, which asks only to wait ("give it another minute")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.vocabulary import TIME_UNITS

_GIVING = frozenset(("give", "gimme"))
_SPANS = TIME_UNITS | frozenset("sec min hr moment mo tick while bit".split())
_RECEIVING = frozenset("me us just it them him her".split())
_HOW_LONG = frozenset("a an one another more few couple of half quarter extra".split())


def pauses(document: Document) -> Iterator[range]:
    """The words of every pause, the verb first, from left to right: not "give me a second helping"."""
    if _GIVING.isdisjoint(document.words):
        return
    tokens = document.tokens
    for verb in (token.i for token in tokens if token.lower in _GIVING):
        start = verb + 1
        while start < len(tokens) and tokens[start].lower in _RECEIVING:
            start += 1
        span = start
        while span < len(tokens) and (tokens[span].tag == "CD" or tokens[span].lower in _HOW_LONG):
            span += 1
        if start < span < len(tokens) and tokens[span].lemma in _SPANS and not _goes_on(document, span + 1):
            yield range(verb, span + 1)


def _goes_on(document: Document, i: int) -> bool:
    """Whether the noun ahead of a token is but a part of what is given: "a second *helping*", "a bit *of* meat"."""
    token = document.tokens[i] if i < len(document) else None
    return token is not None and (token.pos in ("NOUN", "ADJ") or token.tag == "VBG" or token.lower == "of")
