"""Fronting: orders whose object stands ahead of the verb, in contrast with that of the order before ("wash the cups;
*the glasses*, however, only *rinse* if they're dusty")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks

_CONTRASTING = tuple(tuple(p.split()) for p in ("however", "though", "on the other hand", "by contrast"))
_LIMITING = frozenset(("only", "just"))
_HANDLING = frozenset(("change_state", "taking", "placing", "bringing"))
_OPENING = MARKS | {"but", "and"}
_OBJECTS = frozenset(("DT", "PRP", "PRP$", "NN", "NNS", "NNP", "CD"))
_PLACING = frozenset(("in", "on", "under", "by", "from", "behind", "beside"))


@dataclass(frozen=True, slots=True)
class Fronted:
    """The token of the verb, its task type, and the tokens of its object, with where that is."""

    verb: int
    type: str
    object: range
    place: range


def fronted(observed: Observed) -> Iterator[Fronted]:
    """All orders whose object is fronted, in text order."""
    document = observed.document
    if document.words.isdisjoint(_LIMITING | {first for first, *_ in _CONTRASTING}):
        return
    chunks = {chunk.start: chunk for chunk in noun_chunks(document)}
    for token in document.tokens[2:]:
        kind = next((kind for kind in observed.senses[token.i] if kind in _HANDLING), None)
        subject_end = 0 if kind is None or token.lower != token.lemma else _end_before(observed, token.i)
        if kind is None or not subject_end or _has_object(observed, token.i):
            continue
        thing = next((c for c in chunks.values() if c.stop == subject_end), range(0))
        place = range(0)
        if thing and document.tokens[thing.start - 1].lower in _PLACING:
            place = range(thing.start - 1, thing.stop)
            thing = next((c for c in chunks.values() if c.stop == place.start), range(0))
        if thing and _opens(observed, thing.start):
            yield Fronted(token.i, kind, thing, place)


def with_fronted(
    observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments, with what is fronted as that of the verb behind it."""
    kept = list(arguments)
    for found in fronted(observed):
        if found.verb not in tasks:
            continue
        words = {*found.object, *found.place}
        kept = [a for a in kept if words.isdisjoint(a.tokens)]
        kept = [a for a in kept if (a.owner, a.type) != (found.verb, "object")]
        kept.append(FoundArgument("object", found.verb, found.object, CERTAIN))
        if found.place:
            kind = "source" if tasks[found.verb] in ("taking", "bringing") else "location"
            kept.append(FoundArgument(kind, found.verb, found.place, CERTAIN))
    return kept


def _end_before(observed: Observed, verb: int) -> int:
    """Where the phrase ahead of a verb ends, behind which "however" or "only" stands; 0 where neither does."""
    tokens, at, is_set_off = observed.document.tokens, verb, False
    if tokens[at - 1].lower in _LIMITING:
        at, is_set_off = at - 1, True
    start = at - 1 if tokens[at - 1].text == "," else at
    for phrase in _CONTRASTING:
        if tuple(token.lower for token in tokens[max(0, start - len(phrase)) : start]) == phrase:
            at, is_set_off = start - len(phrase), True
            return at - 1 if tokens[at - 1].text == "," else at
    return at if is_set_off else 0


def _has_object(observed: Observed, verb: int) -> bool:
    behind = observed.document.tokens[verb + 1 : verb + 2]
    return bool(behind) and behind[0].tag in _OBJECTS


def _opens(observed: Observed, at: int) -> bool:
    """Whether a definite phrase opens a clause behind another one."""
    tokens = observed.document.tokens
    return at > 0 and tokens[at].tag in ("DT", "PRP$") and tokens[at - 1].lower in _OPENING
