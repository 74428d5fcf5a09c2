"""Repairs: what a speaker begins and then puts otherwise in the same breath ("if it's, uh, if it's not hot", "tell him,
no, switch it off"); an instruction is read without it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.instruction import Argument, Instruction, Span
from decomplex_bt.understanding.document import ENDS, Document

_MARKS = frozenset((",", "-", "–", "—", "...", "…"))
_HESITATING = frozenset("um uh er erm".split())
_FILLERS = _MARKS | _HESITATING | frozenset("ah hmm like well sorry wait no".split())
"""What may stand between something and its being said over again."""
_CLAUSE_OPENERS = _FILLERS | ENDS | frozenset(": and but or so then if unless when oh ok okay please just to".split())
LONGEST = 6
"""The most words that are said over again."""
_TURNING = _FILLERS | frozenset("actually nope nah okay ok oh hang hold on or rather i mean meant just".split())
"""What may stand between an order and the one in its place."""
_DENYING = frozenset(("no", "nope", "nah", "sorry"))
_MEANING = frozenset((("i", "mean"), ("i", "meant"), ("or", "rather")))
_AHEAD = frozenset("first before ahead until till".split())
_WITHDRAWING = frozenset("forget skip scratch scrap strike cancel ignore disregard hold hang wait make".split())
"""Verbs that take an order back and order nothing themselves: "no, forget the stairs", "no, make that five"."""
_BREAKS = _MARKS | ENDS | frozenset((":", "and", "but", "or", "then"))
_ASKING = frozenset("if whether unless when".split())
_TAKING_UP = frozenset("it them that those this these one ones there".split())
_SUBJECTS = frozenset(("nsubj", "nsubjpass", "expl"))


def repaired(document: Document) -> frozenset[int]:
    """The tokens that a speaker puts otherwise in the same sentence, with what stands between.

    Words that are said over again, a single one only behind an "um" or where it is a verb that begins a clause and a
    mark stands between (in "if it is open, open it" and "please please" nothing is); and an order that another one
    stands in place of, unless that speaks of what the first names.
    """
    words = [token.lower for token in document.tokens]
    cut: set[int] = set()
    last: dict[str, int] = {}
    for i, word in enumerate(words):
        first, last[word] = last.get(word), i
        if first is not None and word not in _FILLERS and _is_said_over(document, words, first, i):
            cut.update(range(first, i))
    for order in replaced_orders(document):
        if not takes_up(document, order):
            cut.update(order)
    return frozenset(cut)


def replaced_orders(document: Document) -> Iterator[range]:
    """The orders that another one behind a "no" stands in place of, with all that stands between; what is to be done
    *first* or *before* stands in place of none."""
    words = [token.lower for token in document.tokens]
    for i, word in enumerate(words):
        if word in _DENYING or tuple(words[max(0, i - 1) : i + 1]) in _MEANING:
            order = _replaced(document, words, i)
            if order:
                yield order


def takes_up(document: Document, order: range) -> bool:
    """Whether the order in place of another speaks of what that names: "close the window, no, leave it open"."""
    end = next((t.i for t in document.tokens[order.stop :] if t.text in _MARKS | ENDS), len(document))
    names = any(token.pos in ("NOUN", "PROPN") for token in document.tokens[order.start : order.stop])
    return names and any(token.lower in _TAKING_UP for token in document.tokens[order.stop : end])


def _is_said_over(document: Document, words: Sequence[str], first: int, again: int) -> bool:
    """Whether all words from `first` to `again`, but for fillers before that, are said again there."""
    stop = again
    while words[stop - 1] in _FILLERS:
        stop -= 1
    count = stop - first
    if count > LONGEST or document.sentences[first] != document.sentences[again]:
        return False
    is_opening = first == 0 or words[first - 1] in _CLAUSE_OPENERS
    is_begun = is_opening and stop < again and document.tokens[first].pos in ("VERB", "AUX")
    is_hesitant = not _HESITATING.isdisjoint(words[stop:again])
    return (count > 1 or is_begun or is_hesitant) and words[first:stop] == words[again : again + count]


def _replaced(document: Document, words: Sequence[str], denial: int) -> range:
    """The order ahead of a "no" that the one behind it stands in place of, up to that; empty where none does."""
    sentences = document.sentences
    start, stop = denial, denial + 1
    while start and words[start - 1] in _TURNING:
        start -= 1
    while stop < len(words) and words[stop] in _TURNING:
        stop += 1
    if stop == len(words) or words[start] not in _MARKS or sentences[max(0, start - 1)] != sentences[stop]:
        return range(0)
    end = next((i for i in range(stop, len(words)) if sentences[i] != sentences[stop]), len(words))
    is_other = _is_order(document, stop) and words[stop] not in _WITHDRAWING
    if not is_other or not _AHEAD.isdisjoint(words[start:end]):
        return range(0)
    i = start - 1
    while i and words[i - 1] not in _BREAKS and words[i] not in _ASKING:
        i -= 1
    while i < start and words[i] in _CLAUSE_OPENERS:
        i += 1
    return range(i, stop) if _is_order(document, i) and words[i] not in _ASKING else range(0)


def _is_order(document: Document, i: int) -> bool:
    """Whether a token is a verb in its bare form whose subject is none but "you"; the tagger takes that of "hoover the
    stairs" for a noun."""
    token, following = document.tokens[i], document.tokens[i + 1 : i + 2]
    subjects = {document.tokens[j].lower for j in document.children[i] if document.tokens[j].dep in _SUBJECTS}
    is_verb = token.pos == "VERB" or (token.tag == "NN" and bool(following) and following[0].tag in ("DT", "PRP$"))
    return is_verb and token.lower == token.lemma and subjects <= {"you"}


@dataclass(frozen=True, slots=True)
class Remainder:
    """What is left of a text without some tokens. `places`: where each of its characters stood before."""

    text: str
    places: tuple[int, ...]


def without(document: Document, cut: frozenset[int]) -> Remainder:
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
        characters += token.text
        places += range(token.start, token.end)
    return Remainder("".join(characters), tuple(places))


def restored(instruction: Instruction, text: str, places: Sequence[int]) -> Instruction:
    """An instruction that was read from a remainder, with all spans as they stand in the whole text."""

    def moved(span: Span) -> Span:
        return Span(places[span.start], places[span.end - 1] + 1)

    def with_place(argument: Argument) -> Argument:
        return argument if argument.span is None else replace(argument, span=moved(argument.span))

    tasks = [
        replace(task, span=moved(task.span), arguments=tuple(map(with_place, task.arguments)))
        for task in instruction.tasks
    ]
    return replace(instruction, text=text, tasks=tuple(tasks))
