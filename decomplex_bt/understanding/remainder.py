"""The remainder: what is left of a text without some of its tokens, with the way back to the whole text."""

from __future__ import annotations

from collections.abc import Collection, Container, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.hesitation import HESITATING, without_hesitation
from decomplex_bt.instruction import Argument, Instruction, Span
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.vocabulary import PREPOSITIONS

COMMA, STOP, QUESTION = -1, -2, -3
"""Marks that the text does not have, among tokens to be told."""
_MARKS = {COMMA: ",", STOP: ".", QUESTION: "?"}


@dataclass(frozen=True, slots=True)
class Told:
    """A token to be told, or a mark. `turn`: the token at which it comes up, where it is told for what is left unsaid
    there; `carrier`: the token that stands for it there, if it is a verb."""

    token: int
    turn: int | None = None
    carrier: int | None = None


@dataclass(frozen=True, slots=True)
class Remainder:
    """What is told of a text. `places`: where each of its characters stands in the text; `turns`: where its word comes
    up there, which is another place where a word is told again for one that is left unsaid."""

    text: str
    places: tuple[int, ...]
    turns: tuple[int, ...]


def without(document: Document, cut: Collection[int]) -> Remainder:
    """The document's text without these tokens, of which some are left."""
    return told(document, [Told(token.i) for token in document.tokens if token.i not in cut])


def told(document: Document, sequence: Sequence[Told]) -> Remainder:
    """The document's text as a sequence of tokens, of which the first is no mark."""
    tokens = document.tokens
    characters: list[str] = []
    places: list[int] = []
    turns: list[int] = []
    previous = COMMA
    for index, word in enumerate(sequence):
        if word.token in _MARKS:
            characters += _MARKS[word.token]
            places.append(places[-1])
            turns.append(turns[-1])
            continue
        token = tokens[word.token]
        turn = tokens[word.token if word.turn is None else word.turn].start
        is_next = previous + 1 == word.token
        if index:
            gap = document.text[tokens[previous].end : token.start] if is_next else " " * (token.text not in MARKS)
            characters += gap
            places += range(token.start - len(gap), token.start)
            turns += [turn] * len(gap)
        said = document.text[token.start : token.end]
        is_elsewhere = index > 0 and not is_next and token.pos != "PROPN" and token.lower != "i"
        characters += said.lower() if is_elsewhere and len(said.lower()) == len(said) else said
        if word.carrier is None:
            places += range(token.start, token.end)
        else:
            carrier = tokens[word.carrier]
            places += [carrier.start] * (len(said) - 1) + [carrier.end - 1]
        turns += [turn] * len(said)
        previous = word.token
    return Remainder("".join(characters), tuple(places), tuple(turns))


def restored(
    instruction: Instruction, text: str, places: Sequence[int], turns: Sequence[int], carriers: Container[int] = ()
) -> Instruction:
    """An instruction that was read from a remainder, with all spans as they stand in the whole text, and its tasks
    numbered as they come up there.

    Of a phrase that is put otherwise behind its preposition ("in the box, no, the bag") the last saying is meant. What
    is told for what is left unsaid has no words of its own, nor has what stands at one of the `carriers` of a verb.
    """

    def moved(span: Span) -> Span:
        return Span(places[span.start], places[span.end - 1] + 1)

    def with_place(argument: Argument) -> Argument:
        span = argument.span
        if span is None:
            return argument
        is_told_again = turns[span.start] != places[span.start]
        if is_told_again or any(place in carriers for place in places[span.start : span.end]):
            return replace(argument, span=None)
        first = instruction.text.find(" ", span.start, span.end) + 1  # of the word behind the first one
        between = text[places[first - 2] + 1 : places[first]].lower().replace(",", " ").split() if first > 0 else []
        is_apart = not HESITATING.issuperset(between)  # "on um the table" is put once
        if is_apart and instruction.text[span.start : first - 1].lower() in PREPOSITIONS:
            is_quoted = argument.value == without_hesitation(span.of(instruction.text))
            value = without_hesitation(instruction.text[first : span.end]) if is_quoted else argument.value
            return replace(argument, value=value, span=moved(Span(first, span.end)))
        return replace(argument, span=moved(span))

    order = sorted(instruction.tasks, key=lambda task: turns[task.span.start])
    numbers = {task.id: number for number, task in enumerate(order, start=1)}
    tasks = [
        replace(task, id=numbers[task.id], span=moved(task.span), arguments=tuple(map(with_place, task.arguments)))
        for task in order
    ]
    return replace(
        instruction,
        text=text,
        tasks=tuple(tasks),
        flow=instruction.flow.renumbered(numbers),
        missing=tuple(replace(missing, task=numbers[missing.task]) for missing in instruction.missing),
        alternatives=tuple(replace(a, flow=a.flow.renumbered(numbers)) for a in instruction.alternatives),
    )
