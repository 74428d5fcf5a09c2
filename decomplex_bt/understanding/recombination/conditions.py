"""Conditions: an "if" with what follows, told in other words, alone or joined to another one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.recombination.stretches import (
    Leaf,
    Part,
    Stretch,
    Telling,
    Tree,
    leaves_of,
    stretch_of,
    tree_of,
)


@dataclass(frozen=True, slots=True)
class Condition:
    """A condition in sentences of its own: its clause, what follows where it holds as stated, what follows otherwise
    (if anything), and on which side of its node the former stands. `ahead` and `behind`: what is told around it."""

    clause: Stretch
    follows: Stretch
    otherwise: Stretch | None
    test: Leaf
    side: str
    holds: Tree
    fails: Tree
    ahead: tuple[tuple[Part, ...], Tree]
    behind: tuple[tuple[Part, ...], Tree]

    @property
    def is_plain(self) -> bool:
        """Whether its clause is not negated, so that "unless" may come before it."""
        return _NEGATED.search(self.clause.text) is None

    def node(self, holds: Sequence[Any], fails: Sequence[Any] = ()) -> dict[str, Any]:
        """The node of the flow with these branches: where it holds as stated, and otherwise."""
        sides = {self.side: list(holds), "else" if self.side == "then" else "then": list(fails)}
        return {"if": self.test} | {side: branch for side, branch in sides.items() if branch}


_NEGATED = re.compile(r"n['’]?t\b|\b(not|no|nothing|nobody|none|never|neither)\b", re.IGNORECASE)


def rephrased(condition: Condition) -> Iterator[tuple[str, Telling]]:
    """Other ways to tell a condition, each with the name of its kind."""
    c, x, y = condition.clause, condition.follows, condition.otherwise
    holds, fails = condition.holds, condition.fails
    node = condition.node(holds, fails)

    def told(kind: str, *parts: Part, flow: dict[str, Any] = node) -> tuple[str, Telling]:
        (before, first), (after, last) = condition.ahead, condition.behind
        return kind, Telling((*before, *parts, *after), [*first, flow, *last])

    after = next((part for part in condition.behind[0] if isinstance(part, Stretch)), None)
    if after is not None and after.base is not None:
        rest: tuple[Part, ...] = ("; otherwise ", y) if y is not None else ()
        for words in ("Either way, ", "In any case, ", "Whatever happens, ", "Whichever it is, "):
            parts = (*condition.ahead[0], "If ", c, ", ", x, *rest, ". ", words, after, ".")
            yield "either way", Telling(parts, [*condition.ahead[1], node, *condition.behind[1]])
    is_one = len(x.tasks) == 1  # "sweep the hall and wash it if it is dirty": both, or the last one? nobody can tell
    if y is None:
        yield told("if", "If ", c, ", ", x, ".")
        yield told("if", c, "? ", x, ".")
        yield told("if", c, "? Then ", x, ".")
        if is_one:
            for words in (
                " if ",
                ", but only if ",
                " only if ",
                ", provided ",
                " as long as ",
                " provided that ",
                ", if ",
            ):
                yield told("if", x, words, c, ".")
        if x.base is not None:
            yield told("only", "Only ", x, " if ", c, ".")
            if is_one:
                yield told("only", "Don't ", x, " unless ", c, ".")
                yield told("only", "Don't ", x, " if ", c, ".", flow=condition.node([], holds))
        if condition.is_plain:
            flipped = condition.node([], holds)
            yield told("unless", "Unless ", c, ", ", x, ".", flow=flipped)
            if is_one:
                yield told("unless", x, " unless ", c, ".", flow=flipped)
                yield told("unless", x, ", unless ", c, ".", flow=flipped)
        return
    for words in ("; otherwise ", ". Otherwise, ", ". If not, ", ", if not ", ", or else ", "; else ", "; if not, "):
        yield told("else", "If ", c, ", ", x, words, y, ".")
        if is_one:
            yield told("else", x, " if ", c, words, y, ".")
    for words in (". If not, ", ". Otherwise ", "; if not, "):
        yield told("else", c, "? ", x, words, y, ".")
        if is_one:
            yield told("else", x, " as long as ", c, words, y, ".")
    if condition.is_plain:
        yield told("unless", "Unless ", c, ", ", y, "; if so, ", x, ".")
    if len(y.tasks) > 1:
        return
    for words in (". If ", ". But if ", ", but if ", "; if ", ". Only if "):
        yield told("instead", y, words, c, ", ", x, " instead.")
    if condition.is_plain:
        yield told("unless", y, ", unless ", c, ", in which case ", x, ".")
        yield told("unless", y, " unless ", c, ", in which case ", x, ".")
        yield told("unless", y, " unless ", c, "; if so, ", x, ".")


def joined(one: Condition, two: Condition) -> Iterator[tuple[str, Telling]]:
    """Ways to tell two conditions in one instruction: one within the other, both together, or one after the other."""
    c, x, y, d, u, v = one.clause, one.follows, one.otherwise, two.clause, two.follows, two.otherwise
    if y is not None:
        return
    inner = two.node(two.holds, two.fails)
    tail: tuple[Part, ...] = (". Otherwise, ", v) if v is not None else ()
    for words in (
        ". Otherwise, if ",
        "; otherwise, if ",
        ". If not, but ",
        ". If not, and ",
        ", else if ",
        "; if not, and ",
    ):
        yield "else if", Telling(("If ", c, ", ", x, words, d, ", ", u, *tail, "."), [one.node(one.holds, [inner])])
    within: tuple[Part, ...] = ("; otherwise ", v) if v is not None else ()
    for words in (", then if ", ", and then if ", ", see whether "):
        middle = ": if so, " if words.endswith("whether ") else ", "
        if middle == ", ":
            yield "within", Telling(("If ", c, words, d, middle, u, *within, "."), [one.node([inner])])
    flow = [one.node(one.holds), inner]
    for words in (". If ", "; if ", ". And if ", ", and if "):
        yield "after", Telling(("If ", c, ", ", x, words, d, ", ", u, *tail, "."), flow)
    if v is None:
        both = [one.node([two.node(two.holds)])]
        yield "both", Telling(("If ", c, " and ", d, ", ", u, "."), both)
        yield "both", Telling((u, ", but only if ", c, " and ", d, "."), both)
        if two.is_plain and len(x.tasks) == 1:
            yield "within", Telling(("If ", c, ", ", x, ", unless ", d, "."), [one.node([two.node([], one.holds)])])
        again: Tree = [{"same": [leaf]} for leaf in two.holds if isinstance(leaf, Leaf)]
        if len(again) == len(two.holds):
            either = one.node(two.holds, [two.node(again)])
            yield "either", Telling(("If ", c, " or ", d, ", ", u, "."), [either])
    else:
        again = [{"same": [leaf]} for leaf in two.fails if isinstance(leaf, Leaf)]
        if len(again) == len(two.fails):
            node = one.node([two.node(two.holds, two.fails)], again)
            for words in ("; otherwise ", ", otherwise ", ". If not, "):
                yield "both", Telling(("If ", c, " and ", d, ", ", u, words, v, "."), [node])


def condition_of(observed: Observed, instruction: Instruction, source: int) -> Condition | None:
    """The first condition of an instruction that stands in sentences of its own; None where there is none."""
    flow = tree_of(instruction.flow, source)
    numbers = [leaf.number for leaf in leaves_of(flow)]
    if _SPEAKS_OF_OTHERS.search(instruction.text) or sorted(numbers) != list(range(1, len(instruction.tasks) + 1)):
        return None
    for k, node in enumerate(flow):
        if not isinstance(node, dict) or not isinstance(node.get("if"), Leaf):
            continue
        own = [leaf.number for leaf in leaves_of([node])]
        if any(leaf.number > min(own) for leaf in leaves_of(flow[:k])):
            return None
        if any(leaf.number < max(own) for leaf in leaves_of(flow[k + 1 :])):
            return None
        condition = _condition_at(observed, instruction, source, flow, k)
        if condition is not None:
            return condition
    return None


def _condition_at(observed: Observed, instruction: Instruction, source: int, flow: Tree, k: int) -> Condition | None:
    """The condition that entry `k` of the flow is, where its sentences have a form that we know."""
    text, node = instruction.text, flow[k]
    spans = [instruction.tasks[leaf.number - 1].span for leaf in leaves_of([node])]
    first, last = min(spans).start, max(spans).end
    end = next((match.start() for match in _SENTENCE.finditer(text, last)), len(text))
    starts = [0, *(match.end() for match in _OPENING.finditer(text, 0, first))]
    start, found = next(((s, f) for s in reversed(starts) if (f := _split(text[s:end]))), (0, []))

    def stretch(begin: int, stop: int) -> Stretch | None:
        return stretch_of(observed, instruction, source, begin, stop)

    parts = [stretch(start + a, start + b) for a, b in found]
    if None in parts or len(parts) < 2:
        return None
    c, x, y = (*parts, None)[:3]
    assert c is not None
    assert x is not None
    if c.leaves != {node["if"]} or any(part is not None and _FORBIDS.match(part.text) for part in (x, y)):
        return None
    sides = {side: frozenset(leaves_of(node.get(side, []))) for side in ("then", "else")}
    side, other = ("then", "else") if sides["then"] == x.leaves else ("else", "then")
    if not x.leaves or sides[side] != x.leaves or sides[other] != (y.leaves if y is not None else frozenset()):
        return None
    before, after = flow[:k], flow[k + 1 :]
    ahead = stretch(0, start) if before else None
    behind = stretch(end, len(text)) if after else None
    if (ahead is None and before) or (behind is None and after):
        return None
    return Condition(
        clause=c,
        follows=x,
        otherwise=y,
        test=node["if"],
        side=side,
        holds=node[side],
        fails=node.get(other, []),
        ahead=((ahead, ". ") if ahead is not None else (), before),
        behind=((" ", behind, ".") if behind is not None else (), after),
    )


def stands_alone(condition: Condition) -> bool:
    """Whether its clause says itself what it is about, and so may stand in another instruction."""
    return _NAMES.match(condition.clause.text) is not None


def _split(core: str) -> list[tuple[int, int]]:
    """Where in its sentences the condition stands, what follows from it, and what follows otherwise."""
    for pattern in (_IF_ELSE, _IF, _THEN_IF):
        match = pattern.fullmatch(core)
        if match:
            return [match.span(name) for name in ("c", "x", "y") if name in pattern.groupindex]
    return []


_SENTENCE = re.compile(r"[.!?;] +|[.!?;]$")
_OPENING = re.compile(r"[.!?;] +|,? (?:and|but) (?=if )|, (?=if )")
_STATED = r"[Ii]f (?P<c>(?!so\b|not\b)[^,.;!?]+)"
_IF = re.compile(rf"{_STATED}, (?:then )?(?P<x>[^.;!?]+)")
_IF_ELSE = re.compile(
    rf"{_STATED}, (?:then )?(?P<x>[^.;!?]+?)[,;.] (?:[Oo]therwise|[Ii]f not|[Oo]r else),? (?P<y>[^.;!?]+)"
)
_THEN_IF = re.compile(rf"(?P<x>[^.;!?]+?)(?<!but)(?<!not)(?<!and)(?<!or)(?<!see)(?<!check),? {_STATED}")
_SPEAKS_OF_OTHERS = re.compile(
    r"\b(instead|unless|before|after|first|last|until|till|once|only|even|while|whether|in which case|that case|still|"
    r"too|either|anyway|regardless|also)\b|\bif\b.*\bif\b(?! not)",
    re.IGNORECASE | re.DOTALL,
)
_NAMES = re.compile(
    r"(?!(?:[Ii]t|[Hh]e|[Ss]he|[Tt]hat|[Tt]his|[Tt]hey|[Yy]ou|[Ww]e|[Ww]ho|[Ww]hat|[Oo]ne|I)\b)"
    r"(?:the|my|our|your|there|any|some|all|a|an|no|nobody|\w+'s|[A-Z]\w+)\b"
)
"""How a clause begins that names what it is about."""
_FORBIDS = re.compile(r"(?:do not|don['’]?t|never)\b", re.IGNORECASE)
