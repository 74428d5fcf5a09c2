"""The remainder: what is left of a text without some of its tokens, with the way back to the whole text."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.instruction import Argument, Instruction, Span
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.phrases import PREPOSITIONS


@dataclass(frozen=True, slots=True)
class Remainder:
    """What is left of a text without some tokens. `places`: where each of its characters stood before."""

    text: str
    places: tuple[int, ...]


def without(document: Document, cut: Collection[int]) -> Remainder:
    """The document's text without these tokens, of which some are left."""
    characters: list[str] = []
    places: list[int] = []
    kept = [token for token in document.tokens if token.i not in cut]
    for before, token in zip((None, *kept), kept, strict=False):
        if before is not None:
            is_next = before.i + 1 == token.i
            gap = document.text[before.end : token.start] if is_next else " "
            characters += gap
            places += range(before.end, before.end + len(gap))
        characters += document.text[token.start : token.end]
        places += range(token.start, token.end)
    return Remainder("".join(characters), tuple(places))


def restored(instruction: Instruction, text: str, places: Sequence[int]) -> Instruction:
    """An instruction that was read from a remainder, with all spans as they stand in the whole text.

    Of a phrase that is put otherwise behind its preposition ("in the box, no, the bag") the last saying is meant.
    """

    def moved(span: Span) -> Span:
        return Span(places[span.start], places[span.end - 1] + 1)

    def with_place(argument: Argument) -> Argument:
        span = argument.span
        if span is None:
            return argument
        first = instruction.text.find(" ", span.start, span.end) + 1  # of the word behind the first one
        is_apart = first > 0 and places[first] - places[first - 2] > 2
        if is_apart and instruction.text[span.start : first - 1].lower() in PREPOSITIONS:
            value = (
                instruction.text[first : span.end] if argument.value == span.of(instruction.text) else argument.value
            )
            return replace(argument, value=value, span=moved(Span(first, span.end)))
        return replace(argument, span=moved(span))

    tasks = [
        replace(task, span=moved(task.span), arguments=tuple(map(with_place, task.arguments)))
        for task in instruction.tasks
    ]
    return replace(instruction, text=text, tasks=tuple(tasks))
