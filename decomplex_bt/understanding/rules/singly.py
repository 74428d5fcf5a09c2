"""How many at a time something is done with: "one by one", "two at a time"."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import Document

_HANDLING = frozenset(("taking", "placing", "bringing", "change_state"))
_AT_A_TIME = ["at", "a", "time"]


def singly(document: Document) -> Iterator[range]:
    """Every phrase that says how many at a time, in text order."""
    words = [token.lower for token in document.tokens]
    for token in document.tokens[:-2]:
        i = token.i
        if token.tag != "CD" and token.lower != "one":
            continue
        if words[i + 1] == "by" and words[i + 2] == words[i]:
            yield range(i, i + 3)
        elif words[i + 1 : i + 4] == _AT_A_TIME:
            yield range(i, i + 4)


def with_singly(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with how many at a time as how the order is carried out, and as no thing: "hand me *the pegs*, *one
    by one*"."""
    kept = list(arguments)
    for phrase in singly(document):
        verb = max((i for i in tasks if i < phrase.start), default=None)
        if verb is None or tasks[verb] not in _HANDLING or document.sentences[verb] != document.sentences[phrase.start]:
            continue
        cut = [a for a in kept if not set(a.tokens) & set(phrase)]
        cut += [
            replace(a, tokens=range(a.tokens.start, phrase.start))
            for a in kept
            if a.tokens.start < phrase.start < a.tokens.stop
        ]
        kept = [a for a in cut if (a.owner, a.type) != (verb, "manner")]
        kept.append(FoundArgument("manner", verb, phrase, CERTAIN))
    return kept
