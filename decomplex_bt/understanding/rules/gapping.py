"""Gapping: a second pair of phrases behind an "and", which has the verb of the first one ("take the ladder to the shed
and *the hose to the garden*")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import ENDS, Document, Token

CERTAIN = 0.9
"""The confidence of an argument that no model found."""
_JOINTS = frozenset((",", "and", "&", ";"))
_INSIDE = frozenset(("ADJ", "NUM", "NOUN", "PROPN"))
_NOUNS = frozenset(("NOUN", "PROPN"))
_PERSONS = frozenset("me us him her them it".split())
_PLACING = frozenset("to into in on onto under behind beside by inside over next near at underneath for".split())
_BETWEEN = frozenset(("to", "of", "top", "front"))
_PARTICLES = frozenset(("on", "off", "up", "down"))
_SHAPES = {"bringing": ("np", "nn"), "placing": ("np",), "change_state": ("ns",)}
"""For each type of task what its pairs may be made of: nouns (n), a place or who gets it (p), a particle (s)."""


@dataclass(frozen=True, slots=True)
class Pair:
    """A pair without a verb: the tokens of its phrases, their shape ("np": a noun and a place), the verb that it has,
    and the tokens of the phrases of that verb's own pair."""

    verb: int
    shape: str
    one: range
    other: range
    model: tuple[range, range]

    @property
    def tokens(self) -> range:
        return range(self.one.start, self.other.stop)


def gapped(document: Document, tasks: Mapping[int, str]) -> Iterator[Pair]:
    """All pairs that have the verb of a pair before them, in text order; `tasks`: types of tasks by their tokens."""
    tokens = document.tokens
    for verb, kind in sorted(tasks.items()):
        model: tuple[str, range, range] | None = None
        start = verb + 1
        while start < len(tokens):
            phrases = list(_phrases(document, start, tasks))
            stop = phrases[-1][1].stop if phrases else start
            shape = "".join(name for name, _ in phrases)
            if model is not None and shape == model[0] and _are_alike(tokens, model[2], phrases[1][1]):
                yield Pair(verb, shape, phrases[0][1], phrases[1][1], model[1:])
            elif model is not None or shape not in ("n", *_SHAPES.get(kind, ())):
                break
            elif shape != "n":
                model = shape, phrases[0][1], phrases[1][1]
            after = stop
            while after < len(tokens) and tokens[after].lower in _JOINTS and tokens[after].text not in ENDS:
                after += 1
            if after == stop:
                break
            start = after


def _are_alike(tokens: Sequence[Token], one: range, other: range) -> bool:
    """Whether two second phrases tell the same of a thing: by the same preposition, or by two of where it ends up."""
    first, second = tokens[one.start], tokens[other.start]
    if tokens[other.stop - 1].lemma == "time":
        return False  # "put them on the shelf, one at a time"
    if first.pos in _INSIDE | {"DET", "PRON"}:
        return True
    return first.lower == second.lower or {first.lower, second.lower} <= _PLACING - {"for"} | _PARTICLES


def _phrases(document: Document, start: int, tasks: Mapping[int, str]) -> Iterator[tuple[str, range]]:
    """The phrases in a row from a token on: nouns (n), places (p) and a particle (s); none where one is broken off."""
    tokens, at = document.tokens, start
    while at < len(tokens):
        noun = _noun(document, at, tasks)
        if noun is not None:
            yield "n", range(at, noun)
            at = noun
            continue
        lead = at
        while lead < len(tokens) and (tokens[lead].lower in _PLACING or (lead > at and tokens[lead].lower in _BETWEEN)):
            lead += 1
        noun = _noun(document, lead, tasks) if lead > at else None
        if noun is not None:
            yield "p", range(at, noun)
            at = noun
        elif tokens[at].lower in _PARTICLES:
            yield "s", range(at, at + 1)
            return
        else:
            return


def _noun(document: Document, start: int, tasks: Mapping[int, str]) -> int | None:
    """Where the noun phrase ends that begins at a token; None where none does."""
    tokens = document.tokens
    if start >= len(tokens) or (start in tasks and not _is_name(document, start)):
        return None
    if tokens[start].lower in _PERSONS and tokens[start].tag == "PRP":
        return start + 1
    at = start + (tokens[start].pos == "DET" or tokens[start].tag == "PRP$")
    first = at
    while at < len(tokens) and (tokens[at].pos in _INSIDE or tokens[at].tag == "POS" or _is_name(document, at)):
        if at in tasks and not _is_name(document, at):
            break
        at += 1
    is_named = at > first and any(
        t.pos in _NOUNS or t.lower == "one" or _is_name(document, t.i) for t in tokens[first:at]
    )
    return at if is_named else None


def _is_name(document: Document, at: int) -> bool:
    """Whether a word in a sentence has a capital: whose name the tagger may take for another word ("and *Lily*")."""
    return at > 0 and document.tokens[at].text.istitle() and document.sentences[at] == document.sentences[at - 1]


def with_gapped(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with those of pairs without a verb of their own, which the verb before them has."""
    kept = list(arguments)
    for pair in gapped(document, tasks):
        like = next((a for a in kept if a.owner == pair.verb and a.tokens == pair.model[1]), None)
        last = like.type if like is not None else {"p": "goal", "s": "state", "n": "object"}[pair.shape[1]]
        kinds = ("recipient", "object") if pair.shape == "nn" else ("object", last)
        for kind, tokens in zip(kinds, (pair.one, pair.other), strict=True):
            within = [a for a in kept if set(a.tokens) & set(tokens)]
            sure = max((a.confidence for a in within if a.tokens == tokens), default=CERTAIN)
            cut = [
                replace(a, tokens=range(a.tokens.start, pair.model[1].stop))
                for a in within
                if a.tokens.start in pair.model[1]
            ]
            kept = [a for a in kept if a not in within] + cut
            kept.append(FoundArgument(kind, pair.verb, tokens, sure))
    return kept
