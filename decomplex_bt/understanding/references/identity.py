"""Identity: conditions that ask who or what something is, "if it's *the plumber*", "if that was *the last one*",
"should it be *the plumber*"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.vocabulary import ANYBODY, ONES, PERSON_NOUNS

_OPENING = frozenset("if unless when case should".split())
_POINTING = frozenset("it that this those these they".split())
_BE = frozenset("is was are were 's 're".split())
_BETWEEN = frozenset("only just really indeed actually still even merely n't not".split())
_DEFINITE = frozenset("the my your his her our their".split())
_INDEFINITE = frozenset(("a", "an"))
_POINTING_AT = frozenset("that this those these the".split())
_PARTS = frozenset(("ADJ", "NUM", "NOUN", "PROPN"))
_NAMES = frozenset(("NOUN", "PROPN"))
_NO_NAMES = WEATHER | frozenset("case turn time morning afternoon evening night".split())
_ORDINAL = frozenset("last only first final wrong right".split())
_DONE_TO = frozenset(("it", "them", "him"))
"""What only verbs have right behind them: no "me" or "her", as in "if it's *the one her* aunt sent"."""
_BOTH = frozenset("open shut clean dry warm cool empty".split())
"""What is a state and an order, both of changing it."""


@dataclass(frozen=True, slots=True)
class Identity:
    """A condition of who or what something is: the verb, the tokens of what is spoken of and of what that may be."""

    be: int
    subject: range
    name: range

    def is_pronoun(self, document: Document) -> bool:
        """Whether it speaks of "it" or "that" alone."""
        return len(self.subject) == 1 and document.tokens[self.subject.start].lower in _POINTING

    def is_of_person(self, document: Document) -> bool:
        """Whether it names somebody: "the plumber", "the gas man", "my cousin"."""
        last = document.tokens[self.name.stop - 1]
        is_anybody = document.tokens[self.name.start].lower in ANYBODY
        return is_anybody or last.lemma in PERSON_NOUNS or last.lemma.endswith(("man", "woman"))

    def is_of_order(self, document: Document) -> bool:
        """Whether it asks which one of several it is: "the last one", "your only key"."""
        return any(document.tokens[i].lower in _ORDINAL for i in self.name)


def identities(document: Document) -> Iterator[Identity]:
    """All conditions of who or what something is, as far as a definite phrase or "a neighbour"
    tells it, in text order."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        if token.lower not in _OPENING or i + 3 >= len(tokens):
            continue
        be = _be(document, i + 1)
        if be is None:
            continue
        start = be + 1
        while start < len(tokens) and tokens[start].lower in _BETWEEN:
            start += 1
        stop = _end(document, start)
        if stop > start:
            yield Identity(be, range(i + 1, be), range(start, stop))


def identity_of(document: Document, check: int) -> Identity | None:
    """The identity that a verb asks, or None where it asks something else."""
    return next((identity for identity in identities(document) if identity.be == check), None)


def order_behind(document: Document, identity: Identity) -> int | None:
    """The verb right behind who somebody is that might be a state of theirs: "if it is the plumber *open* for him"."""
    at = identity.name.stop
    if at + 1 >= len(document) or not identity.is_of_person(document):
        return None
    is_order = document.tokens[at].lower in _BOTH and document.tokens[at + 1].lower not in MARKS
    return at if is_order else None


def _be(document: Document, start: int) -> int | None:
    """The "is" behind "it" or a phrase such as "that noise", the "be" behind "should it"."""
    tokens = document.tokens
    at = start + 1
    if tokens[start - 1].lower == "should":
        return at if tokens[start].lower in _POINTING and tokens[at].lower == "be" else None
    if tokens[start].lower in _POINTING_AT and tokens[at].lower not in _BE:
        while at < len(tokens) and tokens[at].tag in ("NN", "NNS", "JJ", "VBG"):
            at += 1
    elif tokens[start].lower not in _POINTING:
        return None
    return at if at < len(tokens) and tokens[at].lower in _BE else None


def _end(document: Document, start: int) -> int:
    """Where a definite phrase ends; its start where none begins there, or what it names goes on ("the lid of")."""
    tokens = document.tokens
    if start + 1 < len(tokens) and tokens[start].lower in ANYBODY:
        return start + 2 if tokens[start + 1].lower == "else" else start
    is_some = start < len(tokens) and tokens[start].lower in _INDEFINITE
    if start >= len(tokens) or not (is_some or tokens[start].lower in _DEFINITE):
        return start
    stop = start + 1
    while stop < len(tokens) and (tokens[stop].pos in _PARTS or tokens[stop].tag in ("POS", "VBG")):
        stop += 1
    if stop < len(tokens) and tokens[stop].lower in _DONE_TO and stop > start + 2:
        stop -= 1  # "if it's the oven *turn* it off", where the tagger takes the verb for a noun
    heads = [i for i in range(start + 1, stop) if tokens[i].pos in _NAMES or tokens[i].lower in ONES]
    is_verbal = stop < len(tokens) and tokens[stop + 1 : stop + 2] != () and tokens[stop + 1].lower in _DONE_TO
    is_marked = is_verbal or stop == len(tokens) or tokens[stop].lower in MARKS
    end = heads[-1] + 1 if heads else stop if is_marked else start
    is_more = end < len(tokens) and tokens[end].lower == "of"
    is_no_person = is_some and tokens[end - 1].lemma not in PERSON_NOUNS  # "if it's a bit cold"
    return start if is_more or is_no_person or tokens[end - 1].lower in _NO_NAMES else end
