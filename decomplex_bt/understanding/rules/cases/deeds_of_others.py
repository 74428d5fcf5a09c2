"""Others: what somebody named does at some time is no order ("before *Lea cleans the hall*, ..."), and asked where it
is waited for ("once *Lea opens the shop*, ...")."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from decomplex_bt.understanding.document import MARKS, Document

_SINCE = frozenset("after once when whenever until till".split())
_MEANWHILE = frozenset(("before", "while", "whilst"))
_NAMING = frozenset("DT PRP$ NN NNP JJ JJR POS".split())
_NAMES = frozenset(("NN", "NNP", "JJR"))
"""How a name may be tagged: "the cleaner"."""
_DONE_TO = frozenset("DT PRP$ PRP NN NNS NNP".split())
_CASES = _SINCE | _MEANWHILE | frozenset(("if", "unless", "otherwise"))
_JOINING = frozenset(("and", "then", "please", "but"))
_NOT_FINITE = frozenset(("VBP", "VBD", "VBN"))
_LONGEST = 4
"""The most words of a subject."""


@dataclass(frozen=True, slots=True)
class Deed:
    """What somebody does: the verb, and the words that tell no task: all from the one that opens the clause, or, where
    it is waited for, those from a second verb on ("once Lea closes the shop *and turns off the lights*")."""

    verb: int
    idle: range


def deeds_of_others(document: Document) -> Iterator[Deed]:
    """What somebody named does to something, behind a word that tells when, in text order."""
    tokens = document.tokens
    for opener in tokens:
        if opener.lower not in _SINCE | _MEANWHILE:
            continue
        verb = opener.i + 1
        while verb < len(tokens) and tokens[verb].tag in _NAMING and verb - opener.i <= _LONGEST:
            verb += 1
        is_named = verb > opener.i + 1 and tokens[verb - 1].tag in _NAMES
        if is_named and verb + 1 < len(tokens) and _is_deed(document, verb):
            stop = _end(document, verb)
            second = next((j for j in range(verb + 1, stop) if tokens[j].tag == "VBZ"), stop)
            yield Deed(verb, range(second if opener.lower in _SINCE else opener.i, stop))


def _end(document: Document, verb: int) -> int:
    """Where the clause of a verb ends: at a mark, an order or a case, whatever joins that."""
    tokens = document.tokens
    end = (t.i for t in tokens[verb + 1 :] if t.lower in _CASES or _is_order(document, t.i))
    stop = next(end, len(tokens))
    while stop > verb + 1 and tokens[stop - 1].lower in _JOINING:
        stop -= 1
    return next((j for j in range(verb, stop) if tokens[j].text in MARKS), stop)


def _is_order(document: Document, at: int) -> bool:
    """Whether a verb is no deed of the one who is named: "... and *shut* the hatch" may be tagged as the past."""
    tag, before = document.tokens[at].tag, document.tokens[at - 1]
    return (tag == "VB" and before.tag not in ("TO", "MD")) or (tag in _NOT_FINITE and before.lower in _JOINING)


def _is_deed(document: Document, verb: int) -> bool:
    token, behind = document.tokens[verb], document.tokens[verb + 1]
    return (token.tag == "VBZ" or (token.tag == "NNS" and behind.tag in ("DT", "PRP$"))) and behind.tag in _DONE_TO
