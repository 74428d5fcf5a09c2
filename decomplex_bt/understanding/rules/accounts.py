"""Accounts: sentences that only tell how things are, in which nothing is asked ("the oven is on and the kettle is off.
Turn the oven off.")."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import ENDS, Document

_BE = frozenset("am is are was were 's 're \u2019s \u2019re 'm \u2019m".split())
_ASKING = frozenset(
    "if whether unless when whenever once until till while provided providing should long case suppose "
    "supposing assuming or either depending may might could can perhaps maybe who what which where how you make".split()
)
"""Words with which a sentence asks, or tells of what may be so or is to be brought about."""
_TAKING_UP = frozenset("true false case so not then otherwise else yes no both either neither event".split())
_WHERE = frozenset("in on at under behind inside beside near by upstairs downstairs outside".split())
_FIRST = 3
"""Within so many words at its beginning a sentence takes the one before it up as a case: "*in that case*"."""


def accounts(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The checks, by token, among the `tasks` (types by token) of sentences that only tell how things are, ahead of
    an order; none of a sentence that the next one takes up as a case ("... and nobody is in. *Then* ...")."""
    tokens = document.tokens
    found: set[int] = set()
    for sentence in _sentences(document):
        told = {i for i in sentence if i in tasks}
        found_there = {i for i in told if tokens[i].lower == "find" and _tells_where(document, i, sentence.stop)}
        if not told or any(tasks[i] != "check_state" or tokens[i].lower not in _BE for i in told - found_there):
            continue
        is_ordered = any(i >= sentence.stop and kind != "check_state" for i, kind in tasks.items())
        words = _asking_words(document, sentence, found_there)
        next_words = {token.lower for token in tokens[sentence.stop : sentence.stop + _FIRST]}
        is_named = tokens[sentence.start].pos not in ("AUX", "VERB") and sentence.start not in told
        if is_ordered and is_named and _ASKING.isdisjoint(words) and _TAKING_UP.isdisjoint(next_words):
            found |= told
    return frozenset(found)


def _tells_where(document: Document, verb: int, stop: int) -> bool:
    """Whether a "find" only says where something is: "you can *find* the screws in the garage"."""
    tokens = document.tokens
    is_led = [token.lower for token in tokens[max(0, verb - 2) : verb]] == ["you", "can"]
    return is_led and any(token.lower in _WHERE for token in tokens[verb + 1 : stop])


def _asking_words(document: Document, sentence: range, found_there: Container[int]) -> set[str]:
    """The words of a sentence without the "you can" of every "find" that only says where something is."""
    return {document.tokens[i].lower for i in sentence if i + 1 not in found_there and i + 2 not in found_there}


def without_accounts(
    document: Document, tasks: Container[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without what an account in which none of the `tasks` is tells of another thing than the one that a
    task names itself, and what stands behind that: "*the kettle* is *off*. Turn the oven off."."""
    tokens = document.tokens
    left_out: set[int] = set()
    for sentence in _sentences(document):
        found_there = {i for i in sentence if tokens[i].lower == "find" and _tells_where(document, i, sentence.stop)}
        words = _asking_words(document, sentence, found_there)
        is_told = bool(found_there) or not _BE.isdisjoint(words)
        if not is_told or not _ASKING.isdisjoint(words) or any(i in tasks for i in sentence):
            continue
        for told in (a for a in arguments if a.type == "object" and a.tokens.start in sentence):
            own = [
                a
                for a in arguments
                if (a.type, a.owner) == ("object", told.owner) and a.tokens.start >= sentence.stop <= told.owner
            ]
            if not own:
                continue
            is_taken_up = any(tokens[i].pos == "PRON" for a in own for i in a.tokens)
            behind = told.tokens if is_taken_up else range(told.tokens.start, sentence.stop)
            left_out |= {id(a) for a in arguments if a.owner == told.owner and a.tokens.start in behind}
    return [a for a in arguments if id(a) not in left_out]


def _sentences(document: Document) -> Iterator[range]:
    """The sentences that end with a full stop, from the mark before them."""
    start, is_led = 0, False
    for i, token in enumerate(document.tokens):
        if token.text in ENDS | {":"}:
            if token.text in (".", "!") and not is_led:
                yield range(start, i + 1)
            start, is_led = i + 1, token.text == ":"
