"""Bounds: where the words for a check end before an order, and those for an order before another one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.rules.orders.prohibitions import NEGATIONS

_RELATIVE = frozenset("that which who to where".split())


def up_to_order(document: Document, tasks: Mapping[int, str], argument: FoundArgument) -> FoundArgument:
    """An argument of a check that runs on into an order behind it, up to that: "if no one is *in the study* close the
    window"."""
    if tasks.get(argument.owner) != "check_state" or argument.type not in ("object", "state", "location"):
        return argument
    inside = argument.tokens[2:]
    order = next((i for i in inside if tasks.get(i, "check_state") != "check_state"), None)
    is_order = order is not None and document.tokens[order].tag in ("VB", "VBP", "NN", "NNP", "JJ")
    is_own = order is not None and any(t.lower in _RELATIVE for t in document.tokens[argument.tokens.start : order])
    if order is None or not is_order or is_own or argument.owner > argument.tokens.start:
        return argument
    return replace(argument, tokens=range(argument.tokens.start, order))


def before_orders(tasks: Mapping[int, str], told: Mapping[str, range]) -> dict[str, range]:
    """What is told of a check, up to where an order begins: "if nobody's *in the cellar* turn off the light"."""
    orders = sorted(i for i, kind in tasks.items() if kind != "check_state")
    ends = {name: next((i for i in orders if i in words), words.stop) for name, words in told.items()}
    return {name: range(words.start, ends[name]) for name, words in told.items() if words.start < ends[name]}


def is_of_forbidden(document: Document, argument: FoundArgument) -> bool:
    """Whether a state is the particle of a verb ahead that is forbidden: "don't turn *on* the radio, just close it"."""
    at = argument.tokens.start
    is_ahead = argument.type == "state" and len(argument.tokens) == 1 and 1 < at < argument.owner
    is_denied = is_ahead and any(t.lower in NEGATIONS for t in document.tokens[max(0, at - 3) : at - 1])
    return is_denied and any(t.text in MARKS for t in document.tokens[at : argument.owner])
