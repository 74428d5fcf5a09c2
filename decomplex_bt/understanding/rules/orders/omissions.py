"""Omissions: what is skipped or left out, which is no order: "*skip the bedroom* if Tom is asleep, otherwise vacuum
it", "*leave out the den*"."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from decomplex_bt.understanding.document import MARKS
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks

_SKIPPING = frozenset(("skip", "omit"))
_OPENING = MARKS | frozenset("and but then just please so or you can could may".split())
_ALL = frozenset("every all everywhere each".split())
_CASES = frozenset("if when unless".split())


class Omission(NamedTuple):
    """What is left out: the verb, and the words that name it."""

    verb: int
    thing: range


def omissions(observed: Observed) -> Iterator[Omission]:
    """Every order to skip something that is named, or to leave out a room; not "leave the milk out"."""
    document, tokens = observed.document, observed.document.tokens
    if document.words.isdisjoint(_SKIPPING | {"out"}):
        return
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    for i, token in enumerate(tokens[:-1]):
        is_led = i == 0 or tokens[i - 1].lower in _OPENING or document.sentences[i - 1] != document.sentences[i]
        is_left = token.lower == "leave" and tokens[i + 1].lower == "out"
        start = i + 1 + is_left
        stop = stops.get(start, 0)
        if not is_led or not stop or not (token.lower in _SKIPPING or is_left):
            continue
        if not is_left or observed.gazetteer.category(tokens[stop - 1].lemma) == "room":
            yield Omission(i, range(start, stop))


def of_all(observed: Observed) -> Iterator[tuple[range, bool]]:
    """The words by which a part of all that is to be done is left out, and whether that is so in a case alone: "dust
    every room, *but skip the attic*", "... skip the attic if it's locked"."""
    for omission in omissions(observed):
        if _is_of_part(observed, omission):
            yield range(omission.verb, omission.thing.stop), _is_in_case(observed, omission)


def omitted(observed: Observed) -> frozenset[int]:
    """The words of what is left out, in which nothing is a task, nor an argument of one; with the case in which it is,
    where an order stands ahead of it in its sentence that is of another thing: "dust every room, *but skip the attic if
    it's locked*"."""
    tokens = observed.document.tokens
    found: set[int] = set()
    for omission in omissions(observed):
        stop = omission.thing.stop
        if _is_of_part(observed, omission) and _is_in_case(observed, omission):
            stop = next((t.i for t in tokens[stop:] if t.lower in MARKS), len(tokens))
        found.update(range(omission.verb, stop))
    return frozenset(found)


def _is_in_case(observed: Observed, omission: Omission) -> bool:
    stop = omission.thing.stop
    return not _CASES.isdisjoint(token.lower for token in observed.document.tokens[stop : stop + 1])


def _is_of_part(observed: Observed, omission: Omission) -> bool:
    """Whether a part of all that an order ahead in the sentence is done to is left out."""
    document = observed.document
    tokens, sentences = document.tokens, document.sentences
    ahead = [t for t in tokens[: omission.verb] if sentences[t.i] == sentences[omission.verb]]
    head = tokens[omission.thing.stop - 1].lemma
    is_other = all(token.lemma != head for token in ahead)
    return is_other and any(token.lower in _ALL for token in ahead)
