"""Stretches: words of annotated instructions that keep together, and texts that are put together of them anew."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Instruction, Span, Task
from decomplex_bt.understanding.document import Token
from decomplex_bt.understanding.features import Observed

Tree = list[Any]
"""A flow as its JSON, with a `Leaf` in place of each number."""


@dataclass(frozen=True, slots=True)
class Leaf:
    """A task of one of the instructions that a text is put together of: `source` tells them apart."""

    source: int
    number: int


@dataclass(frozen=True, slots=True)
class Stretch:
    """Words of an instruction. `base`: where its first verb is, if it is the first word and in its base form ("put"):
    then it may follow "before you". `tasks`: its tasks, in the order of the text."""

    instruction: Instruction
    source: int
    start: int
    end: int
    tasks: tuple[Task, ...]
    base: Span | None
    is_name: bool

    @property
    def text(self) -> str:
        return self.instruction.text[self.start : self.end]

    @property
    def leaves(self) -> frozenset[Leaf]:
        return frozenset(Leaf(self.source, task.id) for task in self.tasks)


@dataclass(frozen=True, slots=True)
class Gerund:
    """A stretch of one task whose verb takes its "-ing" form ("after *putting* the cup down")."""

    stretch: Stretch


Part = str | Stretch | Gerund


@dataclass(frozen=True, slots=True)
class Telling:
    """A text in parts, and the flow that it means."""

    parts: tuple[Part, ...]
    flow: Tree


def stretch_of(observed: Observed, instruction: Instruction, source: int, start: int, end: int) -> Stretch | None:
    """The words from `start` to `end` without marks, joining words and "could you" around; None where words of its
    tasks lie outside, or words of other tasks inside."""
    tokens = [t for t in observed.document.tokens if start <= t.start and t.end <= end]
    while tokens and (not _is_word(tokens[-1]) or tokens[-1].lower in _JOINING):
        tokens.pop()
    while tokens and not _is_word(tokens[0]):
        tokens.pop(0)
    if not tokens:
        return None
    first, last = tokens[0].start, tokens[-1].end
    own = tuple(task for task in instruction.tasks if start <= task.span.start < end)
    said = [span for task in own for span in _spans(task)]
    verb = next((t for t in tokens if own and t.start == own[0].span.start and t.tag in ("VB", "VBP")), None)
    if (
        verb is not None
        and not _SAYS.search(instruction.text[first : verb.start])
        and not any(first <= span.start < verb.start for span in said)
    ):
        first = verb.start
    others = [span for task in instruction.tasks if task not in own for span in _spans(task)]
    if any(not (first <= span.start and span.end <= last) for span in said):
        return None
    if any(span.start < last and first < span.end for span in others):
        return None
    opener = next(t for t in tokens if t.start == first)
    base = Span(opener.start, opener.end) if opener is verb else None
    return Stretch(instruction, source, first, last, own, base, _is_name(opener))


def composed(telling: Telling) -> Instruction | None:
    """The annotated text of a telling; None where a task of its flow is not told, or a gerund is not known."""
    text = ""
    placed: list[tuple[Span, Leaf, Task, Callable[[Span], Span]]] = []
    for part in telling.parts:
        if isinstance(part, str):
            text += part
            continue
        words, shifted = _told(part, len(text), begins=not text or text.rstrip()[-1:] in (".", "?", "!"))
        if words is None:
            return None
        stretch = part.stretch if isinstance(part, Gerund) else part
        placed += [(shifted(task.span), Leaf(stretch.source, task.id), task, shifted) for task in stretch.tasks]
        text += words
    placed.sort(key=lambda each: each[0])
    numbers = {leaf: k for k, (_, leaf, _, _) in enumerate(placed, start=1)}
    if set(numbers) != set(leaves_of(telling.flow)) or len(numbers) != len(placed):
        return None
    tasks = tuple(
        replace(
            task,
            id=numbers[leaf],
            span=span,
            arguments=tuple(replace(a, span=shifted(a.span) if a.span is not None else None) for a in task.arguments),
        )
        for span, leaf, task, shifted in placed
    )
    flow = Flow.from_json(_mapped(telling.flow, numbers.__getitem__), task_count=len(tasks))
    return Instruction(text[:1].upper() + text[1:], tasks, flow)


def leaves_of(tree: Tree) -> list[Any]:
    """The tasks of a tree, in order; those under `same` again."""
    found: list[Any] = []
    _mapped(tree, found.append)
    return found


def tree_of(flow: Flow, source: int) -> Tree:
    """A flow as a tree over leaves of this source."""
    return _mapped(flow.to_json(), lambda number: Leaf(source, number))


def _mapped(tree: Tree, name: Callable[[Any], Any]) -> Tree:
    found: Tree = []
    for node in tree:
        if not isinstance(node, dict):
            found.append(name(node))
        elif "same" in node:
            found.append({"same": [name(leaf) for leaf in node["same"]]})
        else:
            tested = node["if"]
            copy = {"if": [name(leaf) for leaf in tested] if isinstance(tested, list) else name(tested)}
            found.append(copy | {side: _mapped(node[side], name) for side in ("then", "else") if side in node})
    return found


def _told(part: Stretch | Gerund, at: int, *, begins: bool) -> tuple[str | None, Callable[[Span], Span]]:
    """The words of a stretch at a place of a text, and where spans of its instruction are then."""
    stretch = part.stretch if isinstance(part, Gerund) else part
    words, verb, longer = stretch.text, stretch.base, 0
    if isinstance(part, Gerund):
        gerund = _gerund(verb.of(stretch.instruction.text)) if verb is not None and len(stretch.tasks) == 1 else None
        if gerund is None or verb is None:
            return None, lambda span: span
        longer = len(gerund) - (verb.end - verb.start)
        words = gerund + words[verb.end - verb.start :]
    if begins:
        words = words[:1].upper() + words[1:]
    elif not stretch.is_name:
        words = words[:1].lower() + words[1:]
    shift = at - stretch.start

    def shifted(span: Span) -> Span:
        is_first = span.start == stretch.start
        return Span(span.start + shift + (0 if is_first else longer), span.end + shift + longer)

    return words, shifted


def _gerund(verb: str) -> str | None:
    """The "-ing" form of a verb that is spelt regularly."""
    if not re.fullmatch(r"[A-Za-z]+", verb):
        return None
    if re.search(r"[^aeiouy]e$|ue$", verb):
        return verb[:-1] + "ing"
    if re.fullmatch(r"[^aeiou]*[aeiou][bdgklmnprt]", verb, re.IGNORECASE):
        return verb + verb[-1] + "ing"
    return verb + "ing"


def _spans(task: Task) -> list[Span]:
    return [task.span, *(a.span for a in task.arguments if a.span is not None)]


def _is_word(token: Token) -> bool:
    return any(map(str.isalnum, token.text))


def _is_name(token: Token) -> bool:
    return token.tag in ("NNP", "NNPS") or token.text == "I" or token.text[1:2].isupper()


_JOINING = frozenset(("and", "but", "so", "or", "then"))
_SAYS = re.compile(r"\b(if|when|once|not|never|whether|who|what|which|until|as)\b|n['’]?t\b|[.!?;:]", re.IGNORECASE)
"""What must not be left out before a verb."""
