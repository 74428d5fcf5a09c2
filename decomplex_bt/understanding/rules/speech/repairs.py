"""Repairs: what a speaker begins and then puts otherwise in the same breath ("if it's, uh, if it's not hot", "on the
table, no, on the shelf", "tell him, no, switch it off"); an instruction is read without it.

As in the literature on disfluency (E. Shriberg, Preliminaries to a theory of speech disfluencies, 1994), a repair has a
*reparandum*, which goes, an *interregnum* ("uh", "no, sorry", "I mean"), which goes as well, and what takes its place.
"""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.hesitation import HESITATING
from decomplex_bt.understanding.document import ENDS, Document
from decomplex_bt.understanding.rules.speech.courtesies import courtesies
from decomplex_bt.understanding.rules.speech.digressions import digressions
from decomplex_bt.understanding.rules.speech.edits import (
    EDITING,
    INTERJECTIONS,
    MARKS,
    STATING,
    UNFINISHED,
    Said,
    is_order_at,
)
from decomplex_bt.understanding.rules.speech.introductions import introductions
from decomplex_bt.understanding.rules.speech.remarks import bracketed, described, remarks
from decomplex_bt.understanding.rules.speech.replacements import order_before, put_otherwise, puts_right, takes_up
from decomplex_bt.understanding.rules.speech.restarts import said_over
from decomplex_bt.understanding.vocabulary import PREPOSITIONS

_TAGGING = frozenset("is are was were do does did has have had ai".split())
_NOTS = frozenset(("n't", "nt"))
_TAGGED = frozenset("it he she they there we you i that".split())
_BEHIND_PREPOSITIONS = frozenset(("DT", "PRP", "PRP$", "JJ", "CD", "NN", "NNS", "NNP", "NNPS", "VB"))
"""Tags of what a preposition, or the "to" of a verb, goes with."""
_WITHIN_NOUNS = frozenset(("det", "amod", "compound", "nummod", "poss"))


def repaired(document: Document) -> frozenset[int]:
    """The tokens that are put otherwise in the same sentence, with what stands between.

    Words that are said over again; phrases, clauses and orders that others stand in place of behind a "no, sorry" or
    the like; what breaks off at an article; what only opens what is then said; the tag of a question, whose "not"
    denies nothing. An order that is to be done *first* or *before* stands in place of none.
    """
    said = Said.of(document)
    cut = {i for stretch in said_over(said) for i in stretch}
    cut.update(introductions(said))
    cut.update(i for sound in _hesitations(said) for i in sound)
    cut.update(i for tag in _tags(said) for i in tag)
    cut.update(i for remark in remarks(said) for i in remark)
    cut.update(i for digression in digressions(said) for i in digression)
    cut.update(i for courtesy in courtesies(said) for i in courtesy)
    cut.update(described(said))
    cut.update(bracketed(said))
    for run in said.runs:
        cut.update(put_otherwise(said, run))
        cut.update(_dropped(said, run))
    return frozenset(cut)


def _hesitations(said: Said) -> Iterator[range]:
    """Every "um" that no mark sets off ("on the *uh* table", "if it's big *um* tell Dad"), with a "you know" beside it,
    and a "you know" right behind an article; it says nothing, and parts what belongs together. So does one with marks,
    if words go on behind it that the one before belongs to ("the*, um,* table", "my big *er,* coat")."""
    words, i = said.words, 0
    while i < len(words):
        stop = i
        while stop < len(words) and (length := _hesitation(said, i, stop)):
            stop += length
        first = i - 1 if words[max(0, i - 1)] in MARKS else i
        end = stop + 1 if words[min(stop, len(words) - 1)] in MARKS else stop
        is_unmarked = (first, end) == (i, stop) and stop - i < len(words)
        if stop > i and (is_unmarked or (first > 0 and end < len(words) and _goes_on(said, first - 1, end))):
            yield range(first, end)
        i = max(stop, i + 1)


def _goes_on(said: Said, before: int, behind: int) -> bool:
    """Whether the word before a hesitation belongs to words behind it: the article or the like of a noun, or what
    stands ahead of a phrase ("in, um, the shed")."""
    if not said.are_together(before, behind):
        return False
    tokens = said.document.tokens
    token = tokens[before]
    if token.tag in ("IN", "TO"):
        return _leads_to(said, before, behind)
    # The parser may take the "um" for a noun: "the uhm, table".
    if token.tag == "POS":
        return True
    is_within = token.tag in ("DT", "PRP$") or token.dep in _WITHIN_NOUNS
    is_of_verb = tokens[token.head].pos == "VERB" and said.words[before] not in UNFINISHED
    return is_within and token.head > before and not is_of_verb


def _leads_to(said: Said, before: int, behind: int) -> bool:
    """Whether a preposition, or the "to" of a verb, goes with the words behind; not an "on" that is a state ("if it's
    on, um, Dad is asleep") or a particle, with a clause behind it."""
    tokens = said.document.tokens
    following = tokens[behind]
    if said.words[before] not in PREPOSITIONS or following.tag not in _BEHIND_PREPOSITIONS:
        return False
    if following.tag == "VB":
        return said.words[before] == "to"
    named = following if following.pos in ("NOUN", "PROPN", "PRON") else tokens[following.head]
    return named.dep not in ("nsubj", "nsubjpass", "expl") and named.tag not in ("VB", "VBZ", "VBP")


def _hesitation(said: Said, start: int, at: int) -> int:
    """How many words of hesitation stand at a token, where those from `start` up to it are such."""
    words = said.words
    if _is_sound(said, at):
        return 1
    is_beside = at > start or (words[at - 1 : at] != [] and words[at - 1] in UNFINISHED)
    return 2 if is_beside and words[at : at + 2] == ["you", "know"] else 0


def _is_sound(said: Said, at: int) -> bool:
    """Whether a token is an "um", and no name ("Umm Khalid", "the ER")."""
    token = said.document.tokens[at]
    if said.words[at] not in HESITATING:
        return False
    if token.text.islower():
        return True
    following = said.document.tokens[at + 1 : at + 2]
    is_first = at == 0 or not said.are_together(at - 1, at)
    return is_first and token.text.istitle() and not any(other.text.istitle() for other in following)


def _tags(said: Said) -> Iterator[range]:
    """Every tag that asks for a yes with a "not" ("it's raining, *isn't it*? Close the windows")."""
    words = said.words
    for i in range(2, len(words) - 3):
        is_tag = words[i] in _TAGGING and words[i + 1] in _NOTS and words[i + 2] in _TAGGED
        if is_tag and words[i - 1] in MARKS and words[i + 3] in ENDS:
            yield range(i - 1, i + 3)


def replaced_orders(document: Document) -> Iterator[range]:
    """The orders that another one behind a "no" stands in place of, with all that stands between, though that speaks of
    what they name: "close the window, no, leave it open"."""
    said = Said.of(document)
    for run in said.runs:
        order = order_before(said, run) if puts_right(said, run) else range(0)
        if order and takes_up(said, order, run):
            yield order


def _dropped(said: Said, run: range) -> range:
    """A condition that is dropped with a reason before anything hangs on it, where another one follows: "If Dan's in,
    no, he's at work. If Eva's in, ..."."""
    words, document = said.words, said.document
    if run.stop >= len(words) or not said.states(run.stop) or not said.is_strong(run):
        return range(0)
    first = next((i for i in range(run.start, -1, -1) if i == 0 or not said.are_together(i - 1, run.start)), 0)
    end = next((i for i in range(run.stop, len(words)) if not said.are_together(i, run.start)), len(words))
    opening = next((i for i in range(first, run.start) if words[i] not in EDITING | INTERJECTIONS), run.start)
    is_condition = words[opening] in ("if", "when") and not any(is_order_at(document, i) for i in range(opening, end))
    is_again = words[end : end + 1] == [words[opening]] and not STATING.intersection(words[end + 1 : end + 2])
    return range(first, end) if is_condition and is_again else range(0)
