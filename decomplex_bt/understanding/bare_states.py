"""Bare states: states that are said of something without a verb ("when *dark*, ...", "if still *wet*, ...")."""

from __future__ import annotations

from decomplex_bt.understanding.document import MARKS
from decomplex_bt.understanding.features import Observed

_BEFORE = frozenset("still not n't too very already really quite".split())


def bare_state(observed: Observed, opening: int) -> int | None:
    """The token of the state that stands alone between one that opens a case and a mark; None where there is none."""
    tokens, at = observed.document.tokens, opening + 1
    while at < len(tokens) and tokens[at].lower in _BEFORE:
        at += 1
    is_set_off = at < len(tokens) and (at + 1 == len(tokens) or tokens[at + 1].text in MARKS)
    is_state = is_set_off and (tokens[at].pos == "ADJ" or tokens[at].lower in observed.gazetteer.states)
    return at if is_state else None
