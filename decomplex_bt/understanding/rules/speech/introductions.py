"""Introductions: words that say nothing and only open what is then said ("tell you what, ...", "the trouble is that
...", "what I need is ...", "oh, and ...")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import ENDS, FINITE
from decomplex_bt.understanding.rules.speech.edits import MARKS, Said

_WANTING = frozenset("want need like love".split())
_MATTERS = frozenset("thing trouble problem issue point snag fact truth".split())
_IS = frozenset("is 's".split())
_OPENING_ORDERS = frozenset("if when unless can could would please just go let".split())


def introductions(said: Said) -> Iterator[int]:
    """The tokens of every introduction."""
    for found in (_openers, _preambles, _clefts, _additions):
        for words in found(said):
            yield from words


def _openers(said: Said) -> Iterator[range]:
    """Every "(I'll) tell you what" that only opens what is then ordered: not "tell you what happened"."""
    words, tokens = said.words, said.document.tokens
    for i in range(len(words) - 3):
        if words[i : i + 3] != ["tell", "you", "what"]:
            continue
        start, stop = i, i + 3
        while start and words[start - 1] in ("i", "'ll", "will"):
            start -= 1
        is_marked = words[stop] in MARKS | {":", "."}
        while stop < len(words) and words[stop] in MARKS | {":", "."}:
            stop += 1
        if stop == len(words) or not said.may_begin(start):
            continue
        is_order = tokens[stop].pos == "VERB" and words[stop] == tokens[stop].lemma
        if is_marked or is_order or words[stop] in _OPENING_ORDERS:
            yield range(start, stop)


def _preambles(said: Said) -> Iterator[range]:
    """Every "the thing is" that begins a sentence and only opens what is then said: "*the trouble is that* the hatch is
    open, so close it", not "the trouble is the hatch"."""
    words, sentences = said.words, said.document.sentences
    for i in range(len(words) - 4):
        is_first = i == 0 or sentences[i - 1] != sentences[i]
        if not is_first or words[i] != "the" or words[i + 1] not in _MATTERS or words[i + 2] not in _IS:
            continue
        start = next(j for j in range(i + 3, len(words)) if words[j] not in (",", ":", "that") or j == len(words) - 1)
        stop = next((j for j in range(start, len(words)) if words[j] in MARKS | ENDS), len(words))
        if any(_is_finite(said, j) for j in range(start + 1, stop)):
            yield range(i, start)


def _clefts(said: Said) -> Iterator[tuple[int, int]]:
    """The two words that make a want of what is named behind it into a sentence of its own: "*what* I need *is* a rug",
    not "what I need is for you to stay"."""
    words, tokens, sentences = said.words, said.document.tokens, said.document.sentences
    for i in range(len(words) - 4):
        is_first = i == 0 or sentences[i - 1] != sentences[i] or words[i - 1] in MARKS
        if not is_first or words[i] not in ("what", "all") or words[i + 1] not in ("i", "we"):
            continue
        verb = next((j for j in range(i + 2, min(i + 5, len(words) - 2)) if words[j] in _WANTING), None)
        if (
            verb is not None
            and words[verb + 1] in _IS
            and tokens[verb + 2].pos in ("DET", "NOUN", "PROPN", "ADJ", "NUM")
        ):
            yield i, verb + 1


def _is_finite(said: Said, i: int) -> bool:
    """Whether a token is a finite verb, be it an "'s" that is taken for a possessive: "the hatch*'s* open"."""
    token, behind = said.document.tokens[i], said.document.tokens[i + 1 : i + 3]
    is_contracted = token.tag == "POS" and [t.pos for t in behind[:1]] in (["ADJ"], ["ADV"], ["VERB"])
    return token.tag in FINITE or (is_contracted and not any(t.pos == "NOUN" for t in behind[1:]))


def _additions(said: Said) -> Iterator[range]:
    """Every "oh," that begins a sentence that goes on with an "and" ("*Oh,* and the lamp, too, if it's on")."""
    words, sentences = said.words, said.document.sentences
    for i in range(len(words) - 2):
        is_first = i == 0 or sentences[i - 1] != sentences[i]
        if is_first and words[i : i + 3] == ["oh", ",", "and"]:
            yield range(i, i + 2)
