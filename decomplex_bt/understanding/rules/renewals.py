"""Renewals: what is switched off and on again, which is two orders told by one verb ("turn it off *and back on*")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.rules.fragments import Fragment

_SWITCHING = frozenset("switch turn put flick power".split())
_OTHER = {"off": "on", "on": "off"}
_BETWEEN = frozenset(("and", "then", "back", "straight", "right", ","))
_BEHIND = MARKS | {"again", "and", "then", "if", "when", "after", "to", "please", "once", "in"}
_FARTHEST = 6
"""Within so many words behind its verb stands the first particle [tokens]."""


def renewals(document: Document) -> Iterator[Fragment]:
    """The second order of every renewal, carried by its particle."""
    tokens = document.tokens
    for verb in (token.i for token in tokens if token.lemma in _SWITCHING and token.tag in ("VB", "VBP")):
        nearest = tokens[verb + 1 : verb + 1 + _FARTHEST]
        first = next((token.i for token in nearest if token.lower in _OTHER), len(tokens))
        second = first + 1
        while second < len(tokens) and tokens[second].lower in _BETWEEN:
            second += 1
        is_joined = any(token.lower in ("and", "then") for token in tokens[first + 1 : second])
        if second >= len(tokens) or not is_joined or tokens[second].lower != _OTHER[tokens[first].lower]:
            continue
        if second + 1 == len(tokens) or tokens[second + 1].lower in _BEHIND:
            yield Fragment(
                range(first + 1, second + 1),
                second,
                range(0),
                range(0),
                type="change_state",
                state=range(second, second + 1),
            )
