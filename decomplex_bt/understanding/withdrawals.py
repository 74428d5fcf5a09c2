"""Withdrawals: the orders that are taken back ("put it in the oven, no, scratch that"), which are no tasks whatever a
model says of them."""

from __future__ import annotations

from decomplex_bt.understanding.features import Observed

_MARKS = tuple(
    tuple(phrase.split())
    for phrase in (
        "scratch that", "scrap that", "strike that", "cancel that", "forget that", "forget i said that",
        "forget i said anything", "never mind that", "no , leave that", "no , leave it", "actually no , do n't ,",
        "no , do n't ,", "no , do n't .", "no do n't ,", "nevermind that", "ignore that", "disregard that",
    )
)  # fmt: skip
"""What takes back the order before it."""
_THINGS = (("never", "mind", "the"), ("nevermind", "the"), ("forget", "the"), ("never", "mind", "my"), ("forget", "my"))
"""What takes back the orders before it that are about the thing named next."""
_CONDITIONAL = frozenset("if only_if unless when fail so instead until depending whether".split())
_ELSE = frozenset(("otherwise", "else", "alternatively"))
_OPENERS = frozenset(
    "actually oh no wait well ok okay hang hold on sorry um uh er ah hmm but and so you know what".split()
)
"""What says nothing ahead of a mark."""


def withdrawn(observed: Observed) -> frozenset[int]:
    """The tokens of what is taken back.

    "Scratch that" and the like take back what their sentence says before them or, where they begin it, the sentence
    before; "never mind the shirt" takes back the earlier clauses that name the shirt. Behind a condition in their
    sentence they are said of one case alone, which is for the flow to say.
    """
    document = observed.document
    words = [token.lower for token in document.tokens]
    sentences = document.sentences
    opening = [cue.first for cue in observed.cues if cue.name in _CONDITIONAL]
    opening += [i for i, word in enumerate(words) if word in _ELSE]
    conditional = {sentences[i] for i in opening}
    found: set[int] = set()
    for at in range(len(words)):
        if any(i < at and sentences[i] == sentences[at] for i in opening):
            continue
        for mark in (mark for mark in _MARKS if tuple(words[at : at + len(mark)]) == mark):
            said = [i for i in range(at) if sentences[i] == sentences[at]]
            if all(not words[i].isalpha() or words[i] in _OPENERS for i in said):
                said = [i for i in range(at) if sentences[i] == sentences[at] - 1]
            found.update(i for i in said if sentences[i] not in conditional)
            found.update(range(at, at + len(mark)))
        for mark in _THINGS:
            if tuple(words[at : at + len(mark)]) == mark:
                found.update(_about(observed, at, at + len(mark), conditional))
    return frozenset(found)


def _about(observed: Observed, at: int, noun: int, conditional: set[int]) -> list[int]:
    """The tokens of the clauses before `at` that name the noun phrase which begins at `noun`."""
    document = observed.document
    tokens, sentences = document.tokens, document.sentences
    stop = noun
    while stop < len(tokens) and tokens[stop].pos in ("NOUN", "PROPN", "ADJ"):
        stop += 1
    if stop == noun:
        return []
    lemma = tokens[stop - 1].lemma
    found: list[int] = []
    clause: list[int] = []
    for i in range(at + 1):
        if i == at or tokens[i].lower in _BREAKS:
            if any(tokens[j].lemma == lemma for j in clause) and sentences[clause[0]] not in conditional:
                found += clause
            clause = []
        else:
            clause.append(i)
    return found


_BREAKS = frozenset((".", "?", "!", ";", ",", ":", "and", "but", "then", "or"))
