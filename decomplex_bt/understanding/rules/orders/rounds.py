"""Rounds: of a search of one place after another, every place ("look under the bed, then *behind the sofa*")."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.vocabulary import PREPOSITIONS

_NEXT = frozenset(
    "and then finally lastly next after that afterwards also maybe perhaps otherwise failing this or else".split()
)
_TURNING = frozenset("and then finally lastly next afterwards otherwise failing else".split())


def with_rounds(
    document: Document, tasks: Mapping[int, str], found: Sequence[FoundArgument], search: int
) -> list[FoundArgument]:
    """The arguments with the places that a search goes on to, each behind its last one and words like "and then", as
    far as they are nobody else's."""
    kept = list(found)
    chunks = {chunk.start: chunk for chunk in noun_chunks(document)}
    end = max((a.tokens.stop for a in kept if _is_place_behind(a, search) and not _is_further(document, a)), default=0)
    while end and (place := _next_place(document, chunks, end)) is not None:
        further = FoundArgument("location", search, place, CERTAIN)
        kept = [a for a in kept if (a.owner, a.type, a.tokens.start) != (search, "location", place.start)]
        if not tasks.keys().isdisjoint(place) or any(not set(a.tokens).isdisjoint(place) for a in kept):
            return list(found)
        kept.append(further)
        end = place.stop
    return kept


def _is_place_behind(argument: FoundArgument, search: int) -> bool:
    return (argument.owner, argument.type) == (search, "location") and argument.tokens.start > search


def _is_further(document: Document, argument: FoundArgument) -> bool:
    """Whether a place comes behind another one."""
    return document.tokens[argument.tokens.start - 1].lower in _NEXT


def _next_place(document: Document, chunks: Mapping[int, range], end: int) -> range | None:
    """A preposition and its noun phrase that go on from a token with "then" or the like; None where none does."""
    tokens, start = document.tokens, end
    while start < len(tokens) and (tokens[start].lower in _NEXT or tokens[start].text == ","):
        start += 1
    words = {token.lower for token in tokens[end:start]}
    if _TURNING.isdisjoint(words) or start + 1 >= len(tokens) or tokens[start].lower not in PREPOSITIONS:
        return None
    chunk = chunks.get(start + 1)
    is_same = document.sentences[start] == document.sentences[end - 1]
    is_whole = chunk is not None and (
        chunk.stop == len(tokens) or tokens[chunk.stop].lower in MARKS | _NEXT | {"if", "or", "but"}
    )
    return range(start, chunk.stop) if chunk is not None and is_same and is_whole else None
