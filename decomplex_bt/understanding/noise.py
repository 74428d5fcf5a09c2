"""Changed copies of annotated instructions, without case or marks or with other words, spans carried along."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from decomplex_bt.instruction import Argument, Instruction, Span

Edit = Callable[[str, int], str]
"""Given a text and the position of a character: what the character becomes, maybe nothing."""

_MARKS = frozenset(',.;:!?-–—…()"“”')


def without_case(text: str, i: int) -> str:
    """Lower case."""
    lowered = text[i].lower()
    return lowered if len(lowered) == 1 else text[i]


def without_marks(text: str, i: int) -> str:
    """No punctuation but apostrophes, hyphens in words and what stands between digits."""
    if text[i] not in _MARKS:
        return text[i]
    is_inside = 0 < i < len(text) - 1 and text[i - 1].isalnum() and text[i + 1].isalnum()
    return text[i] if is_inside else ""


def without_punctuation(text: str, i: int) -> str:
    """Lower case, and no punctuation as in `without_marks`."""
    return without_marks(text, i) and without_case(text, i)


def without_apostrophes(text: str, i: int) -> str:
    """Lower case, contractions without their apostrophe ("dont", "its")."""
    return "" if text[i] in "'’" else without_case(text, i)


@dataclass(frozen=True, slots=True, order=True)
class Change:
    """A stretch of a text, `end` exclusive, that becomes another; an empty stretch is a place where words come in."""

    start: int
    end: int
    text: str


def edited(instruction: Instruction, edit: Edit) -> Instruction:
    """The instruction with every character edited and the spans moved along. Values that quote the text change with
    it."""

    text = instruction.text
    places = _Places(text, [Change(i, i + 1, edit(text, i)) for i in range(len(text))])
    return _carried(instruction, places, lambda a: "".join(edit(a.value, i) for i in range(len(a.value))))


def changed(instruction: Instruction, changes: Iterable[Change]) -> Instruction:
    """The instruction with these stretches changed and the spans moved along.

    What comes in where a span begins or ends stays outside it, and a span never begins or ends with a space. Values
    that quote the text change as the quoted place does: the argument's own words, else the nearest before them, else
    the nearest after. Raises `ValueError` for changes that overlap, straddle the border of a span, or leave nothing of
    one.
    """
    in_order = sorted(changes)
    if any(after.start < before.end for before, after in pairwise(in_order)):
        raise ValueError(f"changes of {instruction.text!r} overlap")
    inside = {i for change in in_order for i in range(change.start + 1, change.end)}
    if any(border in inside for span in spans_of(instruction) for border in (span.start, span.end)):
        raise ValueError(f"a change of {instruction.text!r} straddles the border of a span")
    places = _Places(instruction.text, in_order)

    def revalued(argument: Argument) -> str:
        quoted = _quoted(instruction.text, argument)
        if quoted is None or quoted.start in inside or quoted.end in inside:
            return argument.value
        return places.moved(quoted).of(places.text) or argument.value

    copy = _carried(instruction, places, revalued)
    if any(span.start >= span.end for span in spans_of(copy)):
        raise ValueError(f"the changes leave nothing of a span of {instruction.text!r}")
    return copy


def valued_as(copy: Instruction, instruction: Instruction) -> Instruction:
    """A changed copy with the values that the instruction has; where upper and lower case alone differ, its own."""
    tasks = (
        replace(
            task,
            arguments=tuple(
                a if a.value.lower() == b.value.lower() else replace(a, value=b.value)
                for a, b in zip(task.arguments, before.arguments, strict=True)
            ),
        )
        for task, before in zip(copy.tasks, instruction.tasks, strict=True)
    )
    return replace(copy, tasks=tuple(tasks))


def spans_of(instruction: Instruction) -> Iterator[Span]:
    """The spans of all tasks and arguments."""
    for task in instruction.tasks:
        yield task.span
        yield from (argument.span for argument in task.arguments if argument.span is not None)


class _Places:
    """Where the places of a text are after changes (in order, not overlapping); `text`: what it became."""

    def __init__(self, old: str, changes: Sequence[Change]) -> None:
        parts, position = [], 0
        replaced, inserted = [0] * (len(old) + 1), [0] * (len(old) + 1)
        for change in changes:
            parts += [old[position : change.start], change.text]
            position = change.end
            longer = replaced if change.end > change.start else inserted
            longer[change.end] += len(change.text) - (change.end - change.start)
        self.text = "".join([*parts, old[position:]])
        self._starts, self._ends, shift = [], [], 0
        for i in range(len(old) + 1):
            shift += replaced[i]
            self._ends.append(i + shift)
            shift += inserted[i]
            self._starts.append(i + shift)

    def moved(self, span: Span) -> Span:
        """Where the span lies now, without spaces at its ends; empty where nothing is left of it."""
        start, end = self._starts[span.start], self._ends[span.end]
        while start < end and self.text[start].isspace():
            start += 1
        while start < end and self.text[end - 1].isspace():
            end -= 1
        return Span(start, max(start, end))


def _carried(instruction: Instruction, places: _Places, revalued: Callable[[Argument], str]) -> Instruction:
    tasks = tuple(
        replace(
            task,
            span=places.moved(task.span),
            arguments=tuple(
                replace(a, span=places.moved(a.span) if a.span else None, value=revalued(a)) for a in task.arguments
            ),
        )
        for task in instruction.tasks
    )
    return replace(instruction, text=places.text, tasks=tasks)


def _quoted(text: str, argument: Argument) -> Span | None:
    """The words of the text that an argument's value repeats, in upper or lower case; None where there are none."""
    own = argument.span
    if own is not None and own.of(text) == argument.value:
        return own
    if not argument.value:
        return None
    pattern = rf"(?<!\w){re.escape(argument.value)}(?!\w)"
    found = [Span(*match.span()) for match in re.finditer(pattern, text, re.IGNORECASE)]
    before = [span for span in found if own is None or span.end <= own.start]
    return before[-1] if before else found[0] if found else None
