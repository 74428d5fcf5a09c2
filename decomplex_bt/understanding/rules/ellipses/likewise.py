"""Likewise: "do the same with the radio", "same for the door", "if the fan is on, do the same": an order before, said
of something else."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.vocabulary import PLACE_ADVERBS, PREPOSITIONS

_LEADS = (
    ("do", "exactly", "the", "same"),
    ("do", "just", "the", "same"),
    ("do", "the", "same"),
    ("the", "same"),
    ("same",),
)
"""What stands for the order."""
CARRIERS = frozenset(("do", "does", "same"))
"""The words that carry an order said again."""
_OF = frozenset(("with", "for", "to"))
"""What only leads to the other thing."""
_ENDS = MARKS | frozenset("if unless when once before after then so but because while until as or".split())
_CASES = frozenset(("if", "when"))
_BEFORE = MARKS | frozenset("and then please also but just".split())
_NOUNS = frozenset(("NOUN", "PROPN", "PRON"))
_POINTING = frozenset("one ones those these".split()) | PLACE_ADVERBS
_DO = {"do": ("NNS", "NNPS"), "does": ("NN", "NNP")}
"""What stands for a need, with the tags of the nouns that agree with it."""
_NAMED = frozenset(("DET", "ADJ", "NOUN", "PROPN"))
_GOING = frozenset(("thing", "goes"))


@dataclass(frozen=True, slots=True)
class Likewise:
    """`words`: those that stand for an order before, among them its `carrier`, "do" or "same"; `other`: what it is said
    of now, a thing or, with its preposition, a place: right behind, or what the case is of in which it is done."""

    words: range
    carrier: int
    other: range

    @property
    def is_bare(self) -> bool:
        """Whether nothing is named by it, but by its case: "if *the fan* is on, do the same"."""
        return self.other.start != self.words.stop


def likewise(document: Document) -> Iterator[Likewise]:
    """Every order that is said of something else by "the same", in text order."""
    yield from so_does(document)
    if "same" not in document.words:
        return
    said = [token.lower for token in document.tokens]
    end = 0
    for i in range(len(said)):
        lead = next((lead for lead in _LEADS if tuple(said[i : i + len(lead)]) == lead), None)
        is_order = i >= end and (not i or said[i - 1] in _BEFORE or document.sentences[i - 1] != document.sentences[i])
        if lead is None or not is_order:
            continue
        start = i + len(lead)
        start += said[start : start + 1] in ([word] for word in _GOING)
        if lead[0] == "do" and (start == len(said) or said[start] in _ENDS | {"and"}) and (case := _case(document, i)):
            yield Likewise(range(i, start), i, case)
            end = start
            continue
        if said[start : start + 1] == [] or said[start] not in PREPOSITIONS | _OF | PLACE_ADVERBS:
            continue
        start += said[start] in _OF
        end = _end(document, start)
        if any(document.tokens[j].pos in _NOUNS or said[j] in _POINTING for j in range(start, end)):
            yield Likewise(range(i, start), i if said[i] == "do" else said.index("same", i), range(start, end))


def _case(document: Document, do: int) -> range:
    """What the "if" of its sentence that stands ahead of a "do the same", or right behind it, is about, where that is
    named; else empty."""
    tokens, sentences = document.tokens, document.sentences
    ahead = [t.i for t in tokens[:do] if t.lower in _CASES and sentences[t.i] == sentences[do]]
    behind = [t.i for t in tokens[do + 3 : do + 5] if t.lower in _CASES and sentences[t.i] == sentences[do]]
    opening = next(reversed(ahead), next(iter(behind), None))
    chunks = [] if opening is None else [chunk for chunk in noun_chunks(document) if chunk.start == opening + 1]
    return chunks[0] if chunks and tokens[chunks[0].stop - 1].tag not in ("PRP", "EX") else range(0)


def so_does(document: Document) -> Iterator[Likewise]:
    """What a need is said of as well, at the beginning of a sentence or behind "and": "the sink needs cleaning, and *so
    does the tub*"; by the number of its noun no order ("so do the kitchen")."""
    tokens, sentences = document.tokens, document.sentences
    for i in range(1, len(tokens) - 2 if "so" in document.words else 0):
        is_led = tokens[i - 1].lower == "and" or sentences[i - 1] != sentences[i]
        if tokens[i].lower != "so" or tokens[i + 1].lower not in _DO or not is_led:
            continue
        end = next((t.i for t in tokens[i + 2 :] if t.lower in MARKS), len(tokens))
        other = tokens[i + 2 : end]
        is_named = (
            all(t.pos in _NAMED or t.tag in ("PRP$", "POS") for t in other) and bool(other) and other[0].pos != "NUM"
        )
        if is_named and other[-1].tag.startswith(_DO[tokens[i + 1].lower]) and len(other) > 1:
            yield Likewise(range(i, i + 2), i + 1, range(i + 2, end))


def _end(document: Document, start: int) -> int:
    """Where the phrase ends that begins at a token: at a mark, a word that opens a clause, or an "and" with no noun
    behind it."""
    tokens = document.tokens
    for i in range(start, len(tokens)):
        is_verb_next = tokens[i].tag == "CC" and i + 1 < len(tokens) and tokens[i + 1].pos in ("VERB", "ADV", "AUX")
        if tokens[i].lower in _ENDS or is_verb_next or document.sentences[i] != document.sentences[start]:
            return i
    return len(tokens)
