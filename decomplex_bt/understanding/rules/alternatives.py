"""Alternatives: what is named without a verb as what to take instead ("otherwise *an apple*"): no task has it."""

from __future__ import annotations

from collections.abc import Container, Iterator

from decomplex_bt.understanding.features import Observed

_MARKS = frozenset((".", ",", ";", ":", "!", "?", "-", "–", "—"))
_ENDS = frozenset((".", ";", "!"))
_BEGINNING = frozenset(("DET", "NOUN", "PROPN", "ADJ", "NUM"))
_NAMING = frozenset(("NOUN", "PROPN"))
_ONE = frozenset(("one", "ones"))


def alternatives(observed: Observed, tasks: Container[int]) -> Iterator[range]:
    """The tokens of each, in text order; `tasks`: the tokens that are tasks.

    It stands at the end of a sentence, right behind an "otherwise" or the like, or behind a condition and a mark ("if
    there is none, a beer").
    """
    tokens = observed.document.tokens
    turns = {cue.first: cue.last for cue in observed.cues if cue.name in ("else", "fail")}
    openings = {cue.first for cue in observed.cues if cue.name in ("if", "unless")}
    first, is_conditional = 0, False
    for i, token in enumerate(tokens):
        if i in turns and i not in tasks:
            first, is_conditional = turns[i] + 1, True
        is_mark = token.text in _MARKS
        if not is_mark and i + 1 < len(tokens):
            continue
        stop = i if is_mark else i + 1
        words = tokens[first:stop]
        is_verbal = any(word.i in tasks or word.pos in ("VERB", "AUX") for word in words)
        is_last = not is_mark or token.text in _ENDS
        is_named = any(word.pos in _NAMING or word.lower in _ONE for word in words)
        if is_conditional and is_last and is_named and not is_verbal and words[0].pos in _BEGINNING:
            yield range(first, stop)
        is_condition = is_verbal and not openings.isdisjoint(range(first, stop))
        is_conditional = not is_last and (is_condition or (is_conditional and not words))
        first = i + 1
