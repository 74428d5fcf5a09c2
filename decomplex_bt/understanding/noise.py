"""Noised copies of annotated instructions: as typed in a hurry or heard by a recogniser, spans carried along."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from decomplex_bt.instruction import Instruction, Span

Edit = Callable[[str, int], str]
"""Given a text and the position of a character: what the character becomes, maybe nothing."""

_MARKS = frozenset(',.;:!?-–—…()"“”')


def without_case(text: str, i: int) -> str:
    """Lower case."""
    lowered = text[i].lower()
    return lowered if len(lowered) == 1 else text[i]


def without_punctuation(text: str, i: int) -> str:
    """Lower case, and no punctuation but apostrophes, hyphens in words and what stands between digits."""
    if text[i] in _MARKS:
        is_inside = 0 < i < len(text) - 1 and text[i - 1].isalnum() and text[i + 1].isalnum()
        return text[i] if is_inside else ""
    return without_case(text, i)


def without_apostrophes(text: str, i: int) -> str:
    """Lower case, contractions without their apostrophe ("dont", "its")."""
    return "" if text[i] in "'’" else without_case(text, i)


def edited(instruction: Instruction, edit: Edit) -> Instruction:
    """The instruction with every character edited and the spans moved along. Values that quote the text change with
    it."""
    parts = [edit(instruction.text, i) for i in range(len(instruction.text))]
    position, offsets = 0, []
    for part in parts:
        offsets.append(position)
        position += len(part)
    offsets.append(position)
    text = "".join(parts)

    def moved(span: Span) -> Span:
        return Span(offsets[span.start], offsets[span.end])

    def revalued(value: str) -> str:
        return "".join(edit(value, i) for i in range(len(value)))

    tasks = tuple(
        replace(
            task,
            span=moved(task.span),
            arguments=tuple(
                replace(a, span=moved(a.span) if a.span else None, value=revalued(a.value)) for a in task.arguments
            ),
        )
        for task in instruction.tasks
    )
    return replace(instruction, text=text, tasks=tasks)
