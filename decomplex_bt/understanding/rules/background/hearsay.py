"""Hearsay: what one has heard that the one spoken to can do ("I heard you can follow people"), which is no order."""

from __future__ import annotations

from decomplex_bt.understanding.document import MARKS, Document

_ABLE = (("can",), ("could",), ("know", "how", "to"), ("'re", "able", "to"), ("are", "able", "to"))
_ABILITIES = frozenset(("can", "could", "know", "able"))
_ENDS = frozenset(("so", "and", "but"))
_HEARING = frozenset(("hear", "read", "learn"))
_SAYING = frozenset(("say", "tell"))
_TOLD = frozenset(("me", "us"))
_YOU = frozenset(("you", "u", "ya"))


def is_hearsay(document: Document, at: int) -> bool:
    """Whether the verb at token `at` is of what one has heard or read that the one spoken to can do, or of what others
    say so where it is of no certain thing: "Tom says you can *open* windows", not "... you can open the window"."""
    return _hearing(document, at) is not None


def hearsays(document: Document) -> frozenset[int]:
    """The tokens of all that one has heard so, from the hearing on to the end of the clause: they are no argument."""
    found: set[int] = set()
    for at in range(3, len(document)) if not document.words.isdisjoint(_ABILITIES) else ():
        if document.tokens[at].pos == "VERB" and (start := _hearing(document, at)) is not None:
            ends = (t.i for t in document.tokens[at:] if t.lower in MARKS | _ENDS)
            found.update(range(start, next(ends, len(document))))
    return frozenset(found)


def _hearing(document: Document, at: int) -> int | None:
    """The verb of hearing or saying ahead of one that is hearsay; else None."""
    tokens = document.tokens
    said = [token.lower for token in tokens[:at]]
    able = next((words for words in _ABLE if tuple(said[-len(words) :]) == words), None)
    if able is None or len(said) <= len(able) + 1 or said[-len(able) - 1] not in _YOU:
        return None
    verb = at - len(able) - 2
    verb -= said[verb] == "that"
    verb -= verb > 0 and said[verb] in _TOLD
    if verb < 0:
        return None
    is_told = tokens[verb].lemma in _SAYING and _is_of_any(document, at)
    return verb if tokens[verb].lemma in _HEARING or is_told else None


def _is_of_any(document: Document, at: int) -> bool:
    """Whether the verb's object is no certain thing: things or people in general."""
    things = [document.tokens[i] for i in document.children[at] if document.tokens[i].dep in ("dobj", "obj")]
    return bool(things) and all(
        thing.tag == "NNS" and not any(document.tokens[i].dep in ("det", "poss") for i in document.children[thing.i])
        for thing in things
    )
