"""Assistance: to give somebody a hand is nothing that is carried ("give Pia *a hand* with the crates")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.phrases import noun_chunks

_GIVING = frozenset(("give", "lend", "gimme"))
_WHOM = frozenset("me us him her them".split())
_HAND = (("a", "hand"), ("a", "helping", "hand"))


def helping_hands(document: Document) -> Iterator[range]:
    """The words of every order to give somebody a hand, the verb first, with what that is for: not "give her a hand
    towel"."""
    if "hand" not in document.words:
        return
    words = [token.lower for token in document.tokens]
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    for verb in (i for i, word in enumerate(words) if word in _GIVING):
        start = verb + 1 if words[verb] == "gimme" else stops.get(verb + 1, verb + 1)
        start = verb + 2 if words[verb + 1 : verb + 2] and words[verb + 1] in _WHOM else start
        for hand in _HAND:
            stop = start + len(hand)
            if tuple(words[start:stop]) == hand and not _goes_on(document, stop):
                yield range(verb, stops.get(stop + 1, stop) if words[stop : stop + 1] == ["with"] else stop)


def _goes_on(document: Document, i: int) -> bool:
    """Whether a hand is but part of what is given: "a hand *towel*", "a hand *of* bananas"."""
    token = document.tokens[i] if i < len(document) else None
    return token is not None and (token.tag in ("NN", "NNS") or token.lower == "of")
