"""Certain cases: what phrases open that, unlike "if", open neither a question nor anything else ("in the event that the
lamp *is* on", "so long as nobody *sleeps*")."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from decomplex_bt.understanding.document import MARKS, Document

_CERTAIN = tuple(
    tuple(phrase.split())
    for phrase in (
        "in the case that", "in case that", "in the event that", "in the unlikely event that", "on the condition that",
        "on condition that", "on the off chance that", "provided that", "providing that", "assuming that",
        "supposing that", "provided", "providing", "assuming", "supposing", "so long as",
    )
)  # fmt: skip
"""What opens a case and, unlike "if", no question, longer phrases first."""
_FIRST_CERTAIN = frozenset(phrase[0] for phrase in _CERTAIN)
_ENDS = MARKS | {"and", "but", "then", "or"}
_SUBJECTS = frozenset(("DT", "EX", "NN", "NNS", "NNP", "NNPS", "PRP", "PRP$", "JJ", "CD", "PDT"))
_AUXILIARIES = frozenset("do does did wo will ca can could should would may might".split())
_BETWEEN = frozenset("not n't nt still already ever never really just".split())
_SPOKEN_TO = frozenset(("you", "u"))
_SPEAKERS = frozenset("am 'm m i we they be been".split())
_BE_OR_HAVE = frozenset("is are 's 're has have was were had".split())


class CertainCase(NamedTuple):
    """A case that more than an "if" opens: its `words` from the opening on, and the verb that carries it."""

    words: range
    verb: int


def certain_cases(document: Document) -> Iterator[CertainCase]:
    """The cases that phrases open which can open nothing else ("in the event that the lamp *is* on"), in text order."""
    if document.words.isdisjoint(_FIRST_CERTAIN):
        return
    tokens, words = document.tokens, [token.lower for token in document.tokens]
    for start, word in enumerate(words):
        if word not in _FIRST_CERTAIN:
            continue
        opener = next((phrase for phrase in _CERTAIN if tuple(words[start : start + len(phrase)]) == phrase), ())
        inside = start + len(opener)
        stop = next((i for i in range(inside, len(tokens)) if words[i] in _ENDS), len(tokens))
        if not opener or inside >= stop or tokens[inside].tag not in _SUBJECTS:
            continue
        if opener[0] == "so" and (words[inside] in _SPOKEN_TO or _is_allowed(document, start)):
            continue
        if len(opener) == 1 and _is_part(document, start):
            continue
        verb = next((i for i in range(inside + 1, stop) if _is_finite(document, i)), None)
        while verb is not None and verb + 1 < stop and words[verb] in _AUXILIARIES | _BETWEEN:
            verb += 1  # "in the event that you can not *lift* it"
        if verb is not None:
            yield CertainCase(range(start, stop), verb)


def _is_allowed(document: Document, start: int) -> bool:
    """Whether somebody is said ahead to do something or to be allowed to, which is no order: "she may *so long as*"."""
    tokens, sentences = document.tokens, document.sentences
    before = [t for t in tokens[:start] if sentences[t.i] == sentences[start]]
    return any(t.dep in ("nsubj", "nsubjpass") and t.lower not in _SPOKEN_TO for t in before)


def _is_part(document: Document, start: int) -> bool:
    """Whether a word like "provided" is told of a thing, or is somebody's doing: "the towels *provided*"."""
    before = document.tokens[start - 1] if start else None
    return before is not None and before.lower in _BE_OR_HAVE | _SPEAKERS


def _is_finite(document: Document, i: int) -> bool:
    token = document.tokens[i]
    if token.lower in _BE_OR_HAVE:
        return token.tag != "POS"
    return token.tag in ("VBZ", "MD") or (token.tag == "VBP" and token.pos in ("VERB", "AUX"))
