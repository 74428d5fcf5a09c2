"""Looks: searches that are told by a noun ("have *a look*", "give the shed *a quick scan*", "keep *an eye* on it"), and
calls ("give me *a shout*")."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS

_LOOKS = frozenset(
    "look peek glance gander peep rummage squint nosy nosey nose hunt squiz squizz shufti shufty dekko decko snoop "
    "recce".split()
)
_GENITIVE = frozenset(("butcher", "butchers"))
"""Rhyming slang, with or without its apostrophe: "have a butcher's"."""
_HASTY = frozenset(("scan", "search"))
"""What is a search only where it is a quick one, or is done or given: "a quick scan of the shelf"."""
_QUICK = frozenset("quick fast brief rapid thorough".split())
_HAVING = frozenset(("have", "take"))
_DOING = frozenset(("do", "give"))
_KEEPING = frozenset(("keep",))
_ONE = frozenset(("a", "an", "another", "one"))
_NAMING = frozenset(("NOUN", "ADJ", "PROPN"))
_GIVING = frozenset(("give", "gimme"))
_SHOUTS = frozenset("shout call ring bell buzz holler yell".split())
_THINGS = frozenset(("ring", "bell"))
"""Shouts that are things as well."""
_CASES = frozenset("if when once as and whenever before after then".split())
_MOST = 2
"""The most adjectives of a look: "a quick little look"."""


class Look(NamedTuple):
    """A search that is told by a noun: its verb, the words of the noun, and the place that it is given to, or empty."""

    verb: int
    words: range
    place: range


def looks(document: Document) -> Iterator[Look]:
    """The looks of a document, in text order, whoever has them; not what a person is given ("give Tom a peek")."""
    for token in document.tokens:
        if token.lemma not in _HAVING | _DOING | _KEEPING:
            continue
        place = _given(document, token.i) if token.lemma == "give" else range(token.i + 1, token.i + 1)
        if token.lemma == "give" and not place:
            continue
        if words := _words(document, place.stop, token.lemma):
            yield Look(token.i, words, place)


def sought_by(document: Document, look: Look) -> range:
    """What a look is "for", in its clause: "have a shufti in the larder *for jam*"; empty where that is not said."""
    tokens = document.tokens
    for i in range(look.words.stop, len(tokens) - 1):
        if tokens[i].text in MARKS or tokens[i].pos in ("VERB", "AUX", "CCONJ", "SCONJ"):
            break
        if tokens[i].lower == "for":
            return next((range(i, chunk.stop) for chunk in noun_chunks(document) if chunk.start == i + 1), range(0))
    return range(0)


def shouts(document: Document) -> Iterator[Look]:
    """The calls that somebody is to be given: "gimme *a shout*", "give Tom *a ring* when it's done", "give the vet *a
    bell*"; "gimme a ring from the box" is of a thing."""
    tokens = document.tokens
    for token in tokens[:-2]:
        if token.lower not in _GIVING:
            continue
        start = _behind_whom(document, token.i + 1) if token.lower != "gimme" else token.i + 1
        behind = tokens[start + 2].lower if start + 2 < len(tokens) else "."
        noun = tokens[start + 1].lower if start + 1 < len(tokens) and tokens[start].lower == "a" else ""
        if noun in _SHOUTS and (noun not in _THINGS or behind in MARKS | _CASES):
            yield Look(token.i, range(start, start + 2), range(0))


def _behind_whom(document: Document, start: int) -> int:
    """Where the words end that name who is given something: one, or a phrase with an article; not an animal."""
    tokens = document.tokens
    if tokens[start].tag not in ("DT", "PRP$") or tokens[start].lower in _ONE:
        return start + 1
    stop = start + 1
    while stop < len(tokens) and tokens[stop].pos in _NAMING:
        stop += 1
    return start + 1 if tokens[stop - 1].lemma in ANIMALS else stop


def _given(document: Document, verb: int) -> range:
    """The thing or place that is given something: "*the shed* a scan"."""
    tokens, stop = document.tokens, verb + 1
    if stop >= len(tokens) or tokens[stop].tag not in ("DT", "PRP$") or tokens[stop].lower in _ONE:
        return range(0)
    stop += 1
    while stop < len(tokens) and tokens[stop].pos in _NAMING:
        stop += 1
    is_person = tokens[stop - 1].lemma in PERSON_NOUNS
    return range(0) if is_person or stop - verb < 3 else range(verb + 1, stop)


def _words(document: Document, start: int, verb: str) -> range:
    """The "a quick look" that begins there; empty where none does."""
    tokens = document.tokens
    if start >= len(tokens) or tokens[start].lower not in _ONE:
        return range(0)
    for noun in range(start + 1, min(start + 2 + _MOST, len(tokens))):
        word = tokens[noun].lower
        is_hasty = verb in _DOING or any(token.lower in _QUICK for token in tokens[start + 1 : noun])
        is_watch = word == "eye" and verb in _KEEPING
        if (word in _LOOKS and verb not in _KEEPING) or (word in _HASTY and is_hasty) or is_watch:
            return range(start, noun + 1)
        if word in _GENITIVE and verb in _HAVING:
            is_marked = tokens[noun + 1 : noun + 2] != () and tokens[noun + 1].lower in ("'s", "'")
            stop = noun + 1 + is_marked
            is_whole = stop >= len(tokens) or tokens[stop].pos not in _NAMING  # not "a butcher's knife"
            return range(start, stop) if is_whole and (is_marked or word == "butchers") else range(0)
        if tokens[noun].pos not in ("ADJ", "ADV"):
            break
    return range(0)
