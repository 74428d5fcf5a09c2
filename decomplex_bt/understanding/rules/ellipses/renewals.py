"""Renewals: what is switched off and on again, which is two orders told by one verb ("turn it off *and back on*", "turn
it on for Gran *and off again* once she's gone")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.rules.ellipses.fragments import Fragment

_SWITCHING = frozenset("switch turn put flick power".split())
_OTHER = {"off": "on", "on": "off"}
_BETWEEN = frozenset(("and", "then", "back", "straight", "right", ","))
_BEHIND = MARKS | {"again", "and", "then", "if", "when", "after", "to", "please", "once", "in"}
_LATER = frozenset("again when once after as".split())
"""What stands behind a particle that what the first one is for parts from that."""
_NO_ADJUNCTS = MARKS | frozenset("and or but then if unless when once while until before after".split())
_FARTHEST = 6
"""Within so many words behind its verb stands the first particle, and behind that the second [tokens]."""


def renewals(document: Document) -> Iterator[Fragment]:
    """The second order of every renewal, carried by its particle."""
    tokens = document.tokens
    for verb in (token.i for token in tokens if token.lemma in _SWITCHING and token.tag in ("VB", "VBP")):
        nearest = tokens[verb + 1 : verb + 1 + _FARTHEST]
        first = next((token.i for token in nearest if token.lower in _OTHER), len(tokens))
        joint = _past_adjunct(document, first)
        second = joint
        while second < len(tokens) and tokens[second].lower in _BETWEEN:
            second += 1
        is_joined = any(token.lower in ("and", "then") for token in tokens[joint:second])
        if second >= len(tokens) or not is_joined or tokens[second].lower != _OTHER[tokens[first].lower]:
            continue
        is_next = joint == first + 1
        behind = next((token.lower for token in tokens[second + 1 : second + 2]), ".")
        if behind in (_BEHIND if is_next else _LATER):
            yield Fragment(
                range(joint, second + 1),
                second,
                range(0),
                range(0),
                type="change_state",
                state=range(second, second + 1),
            )


def _past_adjunct(document: Document, first: int) -> int:
    """The token behind a particle and what it is ordered for, or that it is so now: "on *for the guests* and ..."."""
    tokens = document.tokens
    for i in range(first + 1, min(len(tokens), first + 1 + _FARTHEST)):
        is_mark_first = tokens[i].text == "," and tokens[i + 1 : i + 2] and tokens[i + 1].lower in ("and", "then")
        if tokens[i].lower in ("and", "then") or is_mark_first:
            return i
        if tokens[i].lower in _NO_ADJUNCTS or tokens[i].pos in ("VERB", "AUX", "SCONJ"):
            break
    return first + 1
