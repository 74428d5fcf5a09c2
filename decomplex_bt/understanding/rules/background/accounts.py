"""Accounts: sentences that only tell how things are, in which nothing is asked ("the oven is on and the kettle is off.
Turn the oven off.")."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import ENDS, Document

_BE = frozenset("am is are was were 's 're 'm".split())
_ASKING = frozenset(
    "if whether unless when whenever once until till while provided providing should long case suppose "
    "supposing assuming or either depending may might could can perhaps maybe who what which where how you make".split()
)
"""Words with which a sentence asks, or tells of what may be so or is to be brought about."""
_GUESSING = frozenset(("either", "or"))
_TAKING_UP = frozenset("true false case so not then otherwise else yes no both either neither event".split())
_WHERE = frozenset("in on at under behind inside beside near by upstairs downstairs outside".split())
_FIRST = 3
"""Within so many words at its beginning a sentence takes the one before it up as a case: "*in that case*"."""


def accounts(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The checks, by token, among the `tasks` (types by token) of sentences that only tell how things are, ahead of
    an order; none of a sentence that the next one takes up as a case ("... and nobody is in. *Then* ...")."""
    tokens = document.tokens
    found: set[int] = set()
    for sentence in _accounts(document):
        told = {i for i in sentence if i in tasks}
        is_idle = all(_tells(document, i, sentence.stop) for i in told)
        is_ordered = any(i >= sentence.stop and kind != "check_state" for i, kind in tasks.items())
        is_named = tokens[sentence.start].pos not in ("AUX", "VERB") and sentence.start not in told
        following = {token.lower for token in tokens[sentence.stop : sentence.stop + _FIRST]}
        if is_idle and is_ordered and is_named and _TAKING_UP.isdisjoint(following):
            found |= told
    return frozenset(found)


def without_accounts(
    document: Document, tasks: Container[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without what an account in which none of the `tasks` is tells of another thing than the one that a
    task names itself, and what stands behind that ("*the kettle* is *off*. Turn the oven off."), or of the one that
    a task takes up ("you can find *the screws* in the shed. Bring me five *of them*.")."""
    tokens = document.tokens
    left_out: set[int] = set()
    for sentence in _accounts(document):
        if any(i in tasks for i in sentence) or not any(_tells(document, i, sentence.stop) for i in sentence):
            continue
        for told in (a for a in arguments if a.type == "object" and a.tokens.start in sentence):
            of_task = [a for a in arguments if a.owner == told.owner]
            own = [a for a in of_task if a.type == "object" and a.tokens.start >= sentence.stop <= told.owner]
            is_taken_up = any(tokens[i].pos == "PRON" for a in own for i in a.tokens)
            behind = told.tokens if is_taken_up else range(told.tokens.start, sentence.stop)
            if own:
                left_out |= {id(a) for a in of_task if a.tokens.start in behind}
    return [a for a in arguments if id(a) not in left_out]


def _accounts(document: Document) -> Iterator[range]:
    """The sentences between full stops in which nothing is asked."""
    start, is_led = 0, False
    for i, token in enumerate(document.tokens):
        if token.text in ENDS | {":"}:
            if token.text in (".", "!") and not is_led and not _asks(document, range(start, i + 1)):
                yield range(start, i + 1)
            start, is_led = i + 1, token.text == ":"


def _asks(document: Document, sentence: range) -> bool:
    """Whether a sentence has a word with which something is asked, beside the "you can" of what only tells where
    something is, and the "either ... or" of two guesses at that ("*either* the mop is in here *or* it's outside")."""
    where = {i for i in sentence if _tells_where(document, i, sentence.stop)}
    asking = _ASKING - _GUESSING if document.tokens[sentence.start].lower == "either" else _ASKING
    return any(document.tokens[i].lower in asking and where.isdisjoint((i + 1, i + 2)) for i in sentence)


def _tells(document: Document, verb: int, stop: int) -> bool:
    """Whether a verb says how or where something is: "is", "you can *find* the screws in the shed"."""
    return document.tokens[verb].lower in _BE or _tells_where(document, verb, stop)


def _tells_where(document: Document, verb: int, stop: int) -> bool:
    tokens = document.tokens
    is_led = [token.lower for token in tokens[max(0, verb - 2) : verb]] == ["you", "can"]
    is_found = tokens[verb].lower == "find" and is_led
    return is_found and any(token.lower in _WHERE for token in tokens[verb + 1 : stop])
