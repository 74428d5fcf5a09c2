"""Sequels: to what an order is done next, in a list that names no verb again ("mop the bath, *then the hall*, and
finally *the porch*")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.vocabulary import ANIMALS, ONES, PERSON_NOUNS

_ACTING = frozenset(("placing", "bringing", "taking", "change_state", "searching", "motion"))
_LEADS = tuple(
    tuple(words.split()) for words in ("and then", "and finally", "and lastly", "and last", "then", "finally", "lastly")
)
_BEHIND = MARKS | frozenset("and then please too as finally lastly".split())
_NAMING = frozenset(("NOUN", "PROPN"))
_NOMINAL = _NAMING | {"ADJ", "NUM", "DET"}
_OPENING = frozenset("if only_if unless when else fail before after until while so".split())
_SEEKING = {"searching": "location", "motion": "goal"}
"""What is told anew of an order that goes somewhere."""
_JOINTS = frozenset((",", "and"))


@dataclass(frozen=True, slots=True)
class Sequel:
    """What an order is done to next: its `words`, behind the `lead`; `owner`: the token of the order."""

    owner: int
    lead: range
    words: range


def sequels(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Sequel]:
    """The sequels of all orders, in text order; a noun in them is no task."""
    document = observed.document
    opening = {cue.first for cue in observed.cues if cue.name in _OPENING}
    for owner, kind in sorted(tasks.items()):
        if kind not in _ACTING:
            continue
        at = owner + 1
        while at < len(document) and document.tokens[at].text not in ENDS and at not in opening:
            found = _sequel(document, owner, at) if at > owner + 1 else None
            if found is not None:
                yield found
                at = found.words.stop
            elif at in tasks:
                break
            else:
                at += 1


def _sequel(document: Document, owner: int, at: int) -> Sequel | None:
    """The sequel whose lead begins at a token."""
    tokens = document.tokens
    start = at + (tokens[at].text in (",", ":"))
    said = tuple(token.lower for token in tokens[start : start + 2])
    leads = _LEADS if tokens[at].text != ":" else (("first",),)  # "sweep the house: first the hall, then ..."
    lead = next((words for words in leads if said[: len(words)] == words), ())
    first = start + len(lead)
    stop = _named(document, first) if lead else first
    while stop > first and stop + 1 < len(tokens) and tokens[stop].lower == "and":
        further = _named(document, stop + 1)
        if further == stop + 1:
            break
        stop = further
    is_whole = stop == len(tokens) or tokens[stop].lower in _BEHIND
    return Sequel(owner, range(at, first), range(first, stop)) if stop > first and is_whole else None


def _named(document: Document, first: int) -> int:
    """Where a phrase with its article ends that begins at a token, and names something; that token where none does."""
    tokens = document.tokens
    if first >= len(tokens) or tokens[first].tag not in ("DT", "PRP$"):
        return first
    stop = first + 1
    while stop < len(tokens) and (tokens[stop].pos in _NOMINAL or tokens[stop].lower in ONES):
        if tokens[stop].tag == "DT":
            break
        stop += 1
    head = tokens[stop - 1]
    is_named = stop > first + 1 and (head.pos in _NAMING or head.lower in ONES)
    return stop if is_named else first


def with_sequels(
    observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with those of sequels, whose words no other has."""
    document, kept = observed.document, list(arguments)
    for sequel in sequels(observed, tasks):
        words, owner = sequel.words, sequel.owner
        own = [a for a in kept if a.owner == owner and a.tokens.start < sequel.lead.start]
        kind = _kind(document, tasks[owner], words, {a.type for a in own})
        if kind not in {a.type for a in own}:
            continue
        kept = [_until(document, a, sequel.lead.start) for a in kept if a.tokens.start not in words]
        kept.append(FoundArgument(kind, owner, words, CERTAIN))
    return kept


def _kind(document: Document, task: str, words: range, own: set[str]) -> str:
    """The type of the argument beside which a sequel stands: who gets it, where to go or look, else the thing."""
    head = document.tokens[words.stop - 1]
    if "recipient" in own and (head.lemma in PERSON_NOUNS | ANIMALS or head.pos == "PROPN"):
        return "recipient"
    return _SEEKING.get(task, "object")


def _until(document: Document, argument: FoundArgument, stop: int) -> FoundArgument:
    """An argument that begins ahead of a token, as far as it stands before that."""
    if argument.tokens.start >= stop:
        return argument
    last = min(argument.tokens.stop, stop)
    while last > argument.tokens.start + 1 and document.tokens[last - 1].lower in _JOINTS:
        last -= 1
    return replace(argument, tokens=range(argument.tokens.start, last))
