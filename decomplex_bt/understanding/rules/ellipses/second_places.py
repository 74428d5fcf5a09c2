"""Second places, where something is or is looked for if not in the first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from decomplex_bt.understanding.document import MARKS, Document, Token
from decomplex_bt.understanding.rules.ellipses.sentence_parts import is_phrase
from decomplex_bt.understanding.vocabulary import PREPOSITIONS

_MOVING = frozenset(("placing", "bringing", "taking"))
_UNSURE = frozenset((("else",), ("perhaps",), ("maybe",), ("possibly",), ("failing", "that")))
"""What stands behind an "or" between two places of which the speaker does not know which it is."""


def other_places(document: Document, tasks: Mapping[int, str]) -> Iterator[tuple[int, range]]:
    """Of every second place where something is said to be or looked for, the "or" that joins it to the first, and its
    words: "it's in the hall or else *under the desk*". An order for another place says what to do where it fails."""
    tokens, words = document.tokens, [token.lower for token in document.tokens]
    for joint in (i for i, word in enumerate(words) if word == "or"):
        start = joint + 1 + (words[joint + 1 : joint + 2] == [","])
        unsure = next((u for u in _UNSURE if words[start : start + len(u)] == [*u]), ())
        start += len(unsure)
        start += words[start : start + 1] == [","]
        ends = (t.i for t in tokens[start:] if t.text in MARKS or t.tag == "CC" or t.i in tasks)
        place = range(start, next(ends, len(tokens)))
        if not unsure or len(place) < 2 or words[start] not in PREPOSITIONS or not is_phrase(document, place, tasks):
            continue
        before = [t for t in tokens[:joint] if document.sentences[t.i] == document.sentences[joint]]
        verb = next((t for t in reversed(before) if t.pos in ("VERB", "AUX") or t.i in tasks), None)
        is_there = verb is not None and (verb.lemma in ("be", "'s") or tasks.get(verb.i) == "searching")
        if is_there and not _is_of_order(before, tasks):
            yield joint, place


def _is_of_order(before: Sequence[Token], tasks: Mapping[int, str]) -> bool:
    """Whether a second place behind a condition takes the place of that in the order ahead of it: "put it in the box if
    there's room, or else *on the shelf*"; `before`: what its sentence says up to there."""
    opener = next((n for n, t in enumerate(before) if t.lower in ("if", "unless")), 0)
    ordered = next((n for n, t in enumerate(before[:opener]) if tasks.get(t.i, "check_state") in _MOVING), opener)
    return any(t.lower in PREPOSITIONS for t in before[ordered:opener])
