"""Elsewhere: where something else, or the thing itself, is said to be where it is not where it was looked for, which
says to look there ("if they're not on the desk, *they might be in the study*", "..., *there's another pair in the
car*"), and where to look first ("find my cap. *Start with the attic*")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.rules.ellipses.fragments import Fragment

_SUBJECTS = frozenset("it they he she".split())
_MODALS = frozenset("must will 'll might may should could would".split())
_BE = frozenset("be is are 's 're".split())
_BETWEEN = frozenset("probably likely surely maybe perhaps still also usually always then just".split())
_DENYING = frozenset("not n't nt no none".split())
_OPENING = frozenset(("if", "otherwise"))
_CASES = frozenset(("if", "unless"))
_FINDING = frozenset(("searching", "check_state"))
_BEFORE_CASES = frozenset("and but so or well then".split())
_ONE_MORE = frozenset("another one more some spare extra others".split())
_NAMED = frozenset(("DET", "ADJ", "NOUN", "NUM", "PROPN", "PRON"))
_TURNING = frozenset(("otherwise", "else"))
_WHERE = frozenset("in on under behind inside by near beside at".split())
_BEGINNING = frozenset(("start", "begin"))
_TAKING_UP = frozenset("it them him her there that those one".split())


def elsewhere(document: Document) -> Iterator[Fragment]:
    """Every such statement that ends its sentence, where no order in the next one takes it up, carried by its "be"."""
    if document.words.isdisjoint(_OPENING):
        return
    tokens = document.tokens
    for first in range(1, len(tokens) - 2):
        if tokens[first].lower not in _SUBJECTS | {"there"} or not _is_behind_case(document, first):
            continue
        be = first + 1
        while be < len(tokens) and tokens[be].lower in _MODALS | _BETWEEN:
            be += 1
        stop = next((i for i in range(first, len(tokens)) if tokens[i].text in MARKS), len(tokens))
        if be >= stop or tokens[be].lower not in _BE or not _is_last(document, stop):
            continue
        place = be + 1
        while place < stop and (tokens[place].pos in _NAMED or tokens[place].lower in _BETWEEN):
            place += 1
        named = [i for i in range(be + 1, place) if tokens[i].lower not in _BETWEEN]
        is_there = tokens[first].lower == "there"
        is_place = place < stop - 1 and tokens[place].tag == "IN" and tokens[stop - 1].pos in ("NOUN", "PROPN")
        is_more = any(tokens[i].lower in _ONE_MORE for i in named)
        if is_place and (is_more if is_there else not named) and not _has_verb(document, range(place, stop)):
            thing = range(named[0], place) if is_there else range(first, first + 1)
            yield Fragment(range(first, stop), be, thing, range(place, stop), "searching")


def other_searches(document: Document, tasks: Mapping[int, str]) -> Iterator[Fragment]:
    """Every further place behind an "otherwise" right after a search, which is searched where that fails: "look in the
    drawer, *otherwise on the desk*"; carried by its preposition. `tasks`: tokens with types."""
    tokens = document.tokens
    if document.words.isdisjoint(_TURNING):
        return
    for i, token in enumerate(tokens[:-2]):
        start = i + 1 + (token.lower == "or" and tokens[i + 1].lower == "else")
        if (token.lower != "otherwise" and start == i + 1) or i == 0 or tokens[i - 1].text not in MARKS:
            continue
        before = max((j for j in tasks if j < i), default=None)
        is_next = before is not None and document.sentences[before] == document.sentences[i]
        place = next((chunk for chunk in noun_chunks(document) if chunk.start == start + 1), None)
        if not is_next or before is None or tasks[before] != "searching" or place is None or tokens[start].tag != "IN":
            continue
        if _is_case_of_order(document, before, tasks):
            continue
        behind = tokens[place.stop] if place.stop < len(tokens) else None
        if (behind is None or behind.text in MARKS) and tokens[start].lower in _WHERE:
            yield Fragment(range(start, place.stop), start, range(0), range(start, place.stop), "searching")


def _is_case_of_order(document: Document, search: int, tasks: Mapping[int, str]) -> bool:
    """Whether finding something is the case of an order ahead of it in its sentence, so that what is said behind an
    "otherwise" is of the order: "put it on a trivet if you *find* one, otherwise on the tiles"."""
    begin = document.sentences.index(document.sentences[search])
    opener = next((i for i in range(search, begin, -1) if document.tokens[i].lower in _CASES), begin)
    is_case = not any(i in tasks for i in range(opener + 1, search))  # "if it's empty, *look* for more in the attic"
    return is_case and any(tasks.get(i, "searching") not in _FINDING for i in range(begin, opener))


def first_searches(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Fragment]:
    """Every place that a search right ahead is to begin with, which is searched: "find my cap. *Start with the attic*";
    carried by its verb; not "with" a thing that the domain knows. `tasks`: tokens with types."""
    document = observed.document
    tokens, sentences = document.tokens, document.sentences
    for i, token in enumerate(tokens[:-2]):
        is_led = i > 0 and (tokens[i - 1].text in MARKS or tokens[i - 1].lower in ("and", "please"))
        if token.lower not in _BEGINNING or not is_led or tokens[i + 1].lower not in _WHERE | {"with"}:
            continue
        search = max((j for j in tasks if j < i), default=None)
        if search is None or tasks[search] != "searching" or sentences[i] - sentences[search] > 1:
            continue
        place = next((chunk for chunk in noun_chunks(document) if chunk.start == i + 2), None)
        if place is None:
            continue
        if tokens[i + 1].lower == "with" and observed.gazetteer.category(tokens[place[-1]].lemma) == "thing":
            continue
        if place.stop == len(tokens) or tokens[place.stop].text in MARKS:
            yield Fragment(range(i, place.stop), i, range(0), range(i + 1, place.stop), "searching")


def _is_behind_case(document: Document, first: int) -> bool:
    """Whether a comma right ahead ends the case that something is not there: "if it isn't in the drawer, ..."."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[first - 1].text != "," or sentences[first - 1] != sentences[first]:
        return False
    start = first - 1
    while start and sentences[start - 1] == sentences[first] and tokens[start - 1].text not in MARKS:
        start -= 1
    words = [token.lower for token in tokens[start : first - 1]]
    while words and words[0] in _BEFORE_CASES:
        words = words[1:]
    return words == ["otherwise"] or (words[:1] == ["if"] and not _DENYING.isdisjoint(words))


def _is_last(document: Document, stop: int) -> bool:
    """Whether a sentence ends before a token, and no word of the next one takes up what it says."""
    tokens, sentences = document.tokens, document.sentences
    if stop < len(tokens) and tokens[stop].text not in ENDS:
        return False
    behind = [t.lower for t in tokens[stop + 1 :] if sentences[t.i] == sentences[min(stop + 1, len(tokens) - 1)]]
    return _TAKING_UP.isdisjoint(behind)


def _has_verb(document: Document, words: range) -> bool:
    return any(document.tokens[i].pos in ("VERB", "AUX", "CCONJ") for i in words)
