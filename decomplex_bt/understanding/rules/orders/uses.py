"""Uses: what a thing is wanted for ("a cloth *to wipe the table with*"), which is part of its words and no order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS

_STRANDED = frozenset("with from into onto in on under over".split())
"""Prepositions that may stand behind all that they speak of."""
_WITH = frozenset(("with", "from"))
_PARTICLES = frozenset("in on over".split())
"""Of these, those that may belong to the verb: "the way to turn it *on*"."""
_UNNAMED = frozenset("something anything nothing one ones some".split())
_INDEFINITE = _UNNAMED | frozenset(("a", "an", "another"))
_CLOSING = MARKS | frozenset(
    "and but or then so please if unless when while before after once too now also otherwise first for quick".split()
)
_WAYS = frozenset("way reason chance time turn moment opportunity need attempt ability permission right".split())
_INSTRUCTING = frozenset("tell ask remind get help let want need order invite allow call".split())
_LEADING = frozenset("let bring get keep turn switch come go stay move take".split())
"""Verbs that a particle belongs to: "to let some air *in*"."""
_LONGEST = 8
"""The most words from the verb to its preposition."""


class Use(NamedTuple):
    """Where a use stands, from its "to" on, and its verb."""

    words: range
    verb: int


def uses(document: Document) -> Iterator[Use]:
    """Every use told right behind a thing by an infinitive that ends in a preposition without its noun."""
    tokens = document.tokens
    if "to" not in document.words or document.words.isdisjoint(_STRANDED):
        return
    for i, token in enumerate(tokens[1:-2], start=1):
        if token.lower != "to" or tokens[i + 1].tag not in ("VB", "VBP") or not _is_thing(document, i - 1):
            continue
        end = _stranded(document, i + 1)
        if end:
            yield Use(range(i, end + 1), i + 1)


def with_uses(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments, those that a use stands behind with it, without what was taken for an argument in it."""
    kept = list(arguments)
    for use in uses(document):
        things = [
            a for a in kept if a.type == "object" and use.words.start - 1 in a.tokens and a.owner < a.tokens.start
        ]
        if things:
            whole = replace(things[0], tokens=range(things[0].tokens.start, use.words.stop))
            kept = [whole if a is things[0] else a for a in kept if a is things[0] or a.tokens.start not in use.words]
    return kept


def _is_thing(document: Document, last: int) -> bool:
    """Whether a thing, nobody and no animal, is named up to a token."""
    token = document.tokens[last]
    if token.lower in _UNNAMED:
        return True
    return token.tag in ("NN", "NNS") and token.lemma not in PERSON_NOUNS | ANIMALS | _WAYS


def _stranded(document: Document, verb: int) -> int:
    """The preposition without a noun that ends the clause of an infinitive; 0 where there is none."""
    tokens = document.tokens
    for i in range(verb + 1, min(len(tokens), verb + _LONGEST + 1)):
        if tokens[i].lower in _CLOSING or tokens[i].tag in ("TO", "VB", "VBZ", "MD", "WDT"):
            return 0
        is_last = i + 1 == len(tokens) or tokens[i + 1].lower in _CLOSING
        is_last = is_last or (tokens[i].lower in _WITH and tokens[i + 1].tag == "IN")  # "to write with on the desk"
        if is_last and tokens[i].lower in _STRANDED:
            is_particle = tokens[i].lower in _PARTICLES and (
                tokens[verb].lemma in _LEADING or _is_instructed(document, verb)
            )
            return 0 if is_particle else i
    return 0


def _is_instructed(document: Document, verb: int) -> bool:
    """Whether the verb before an infinitive has somebody or something known do it: "get the lamp to come on"."""
    tokens = document.tokens
    before = next((t for t in reversed(tokens[: verb - 1]) if t.pos == "VERB"), None)
    if before is None or before.lemma not in _INSTRUCTING:
        return False
    return all(t.lower not in _INDEFINITE for t in tokens[before.i + 1 : verb - 1])
