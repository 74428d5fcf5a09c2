"""Legs: where somebody or something is to go next, or to whom, told without its verb ("go to the kitchen, *then to the
study*", "put it on the desk, *then on the couch*")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.rules.ellipses.fragments import Fragment
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS

_THEN = ((",", "then"), ("and", "then"), (",", "and", "then"), ("then",), (",", "and", "finally"), (",", "finally"))
_LONGEST = max(map(len, _THEN))
_LEADING_ON = frozenset(("then", "finally"))
_ON = frozenset("back on over straight up down across finally".split())
_TO = frozenset(("to", "into"))
_AT = frozenset("on in onto under behind beside".split())
_WAYS = {"motion": _TO, "bringing": _TO, "placing": _TO | _AT}
"""By the type of an order, what its further legs begin with."""
_SOMEBODY = frozenset("me us him her them".split())


def legs(document: Document, tasks: Mapping[int, str]) -> Iterator[Fragment]:
    """The further legs of orders, in text order, each carried by its preposition; `tasks` maps token indices to task
    types."""
    words = [token.lower for token in document.tokens]
    if _LEADING_ON.isdisjoint(words):
        return
    chunks = {chunk.start: chunk for chunk in noun_chunks(document)}
    verb, kind = 0, ""
    for i, word in enumerate(words):
        if kind and document.sentences[i] != document.sentences[verb]:
            kind = ""
        start = _joint(words, verb, i) if word in _WAYS.get(kind, ()) else 0
        is_pronoun = not _SOMEBODY.isdisjoint(words[i + 1 : i + 2])
        place = chunks.get(i + 1, range(i + 1, i + 1 + is_pronoun))
        if start and place and not _WAYS[kind].isdisjoint(words[verb:start]) and tasks.keys().isdisjoint(place):
            last = document.tokens[place.stop - 1]
            is_person = is_pronoun or last.tag == "NNP" or last.lemma in PERSON_NOUNS
            is_given = is_person and kind == "bringing" and word == "to"
            told = {"place": range(0), "recipient": place} if is_given else {"place": place}
            yield Fragment(range(start, place.stop), i, range(0), type=kind, **told)
        elif i in tasks:
            verb, kind = i, tasks[i]


def _joint(words: list[str], verb: int, to: int) -> int:
    """Where the "then" ahead of a preposition begins, with its mark; 0 where there is none."""
    i = to
    while i - 1 > verb and words[i - 1] in _ON:
        i -= 1
    fits = [i - n for n in range(_LONGEST, 0, -1) if i - n > verb and tuple(words[i - n : i]) in _THEN]
    return fits[0] if fits else 0
