"""Turns: that several things are taken one at a time, which is how something is done and names none of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document

_AHEAD = MARKS | {"and", "then", "otherwise"}
"""Behind which the words of an order to come begin."""
_AT_A_TIME = ["at", "a", "time"]
_AFTER = (["after", "another"], ["after", "the", "other"])


def with_turns(document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with "one by one", "two at a time" or "one after the other" as how the order before it is carried
    out, and as part of no other: "hand me *the foils* one by one"."""
    kept = list(arguments)
    for turn in turns(document):
        sentences = document.sentences
        orders = [i for i in tasks if tasks[i] != "check_state" and sentences[i] == sentences[turn.start]]
        before = max((task for task in orders if task < turn.start), default=None)
        after = min((task for task in orders if task > turn.start), default=None)
        is_ahead = turn.start == 0 or document.tokens[turn.start - 1].lower in _AHEAD
        owner = after if before is None or (after is not None and is_ahead) else before
        if owner is not None and not any(a.type == "message" and turn.start in a.tokens for a in kept):
            kept = [cut for a in kept if (cut := _outside(a, turn)) is not None]
            kept.append(FoundArgument("manner", owner, turn, CERTAIN))
    return kept


def turns(document: Document) -> Iterator[range]:
    """The words of every "one by one", "one or two at a time" and "one after another", from left to right; not "the red
    *one by one* of the doors"."""
    if document.words.isdisjoint(("by", "time", "after")):
        return
    tokens = document.tokens
    words = [token.lower for token in tokens]
    for i, number in enumerate(tokens):
        is_noun = i > 0 and (tokens[i - 1].pos in ("DET", "ADJ") or words[i - 1] == "or")
        if (number.pos != "NUM" and number.lower != "one") or is_noun:
            continue
        last = i + 2 if words[i + 1 : i + 2] == ["or"] else i
        ends = (_AT_A_TIME, *_AFTER, ["by", number.lower])
        end = next((end for end in ends if words[last + 1 : last + 1 + len(end)] == end), [])
        stop = last + 1 + len(end)
        if end and words[stop : stop + 1] != ["of"]:
            yield range(i, stop)


def _outside(argument: FoundArgument, turn: range) -> FoundArgument | None:
    """An argument up to the words of a turn, or behind them where it begins with them; None where nothing is left."""
    if set(argument.tokens).isdisjoint(turn):
        return argument
    start, stop = argument.tokens.start, argument.tokens.stop
    rest = range(start, turn.start) if start < turn.start else range(turn.stop, stop)
    return replace(argument, tokens=rest) if rest else None
