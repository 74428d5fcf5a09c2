"""Calls: who is called is told something ("call *a locksmith*", "ring *the surgery*", "ring *for a
doctor*"), and what is called for is asked for ("shout *for help*")."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.chunks import noun_chunks

_CALLING = frozenset("call phone ring telephone".split())
_ASKING_FOR = _CALLING | {"shout", "yell", "holler"}
_INDEFINITE = frozenset(("a", "an"))


def is_sent_for(document: Document, verb: int) -> bool:
    """Whether somebody, or what somebody comes with, is sent for: "*call* a taxi", not "call the lift"."""
    behind = document.tokens[verb + 1 : verb + 2]
    is_called = document.tokens[verb].lemma in ("call", "phone", "telephone")
    return is_called and bool(behind) and behind[0].lower in _INDEFINITE


def with_called(document: Document, arguments: Sequence[FoundArgument], calling: int) -> list[FoundArgument]:
    """The arguments with who is called as who is told, and with what is called "for" where no more is told."""
    tokens, own = document.tokens, [a for a in arguments if a.owner == calling]
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    first = calling + 1
    if tokens[calling].lemma in _ASKING_FOR and tokens[first : first + 1] and tokens[first].lower == "for":
        stop = stops.get(first + 1, 0)
        is_whom = stop > 0 and tokens[first + 1].pos in ("DET", "PRON", "PROPN")
        told = FoundArgument("recipient" if is_whom else "message", calling, range(first, stop), CERTAIN)
        return [*arguments, told] if stop and not own else list(arguments)
    whom = range(first, stops.get(first, 0))
    is_told = any(a.type in ("recipient", "message") and a.tokens.start >= first for a in own)
    if tokens[calling].lemma not in _CALLING or not whom or is_told:
        return list(arguments)
    kept = [a for a in arguments if set(whom).isdisjoint(a.tokens) and (a not in own or a.type != "recipient")]
    return [*kept, FoundArgument("recipient", calling, whom, CERTAIN)]
