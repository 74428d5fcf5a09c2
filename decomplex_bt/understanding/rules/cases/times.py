"""Times: when, or for how long, something is to be done, which is no part of a flow ("in ten minutes", "tonight")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.vocabulary import TIME_UNITS

_DAYS = frozenset("tonight tomorrow later".split())
_LEADING = frozenset(("in", "for", "after"))
_OPENING = frozenset("if when whenever once unless after before until".split())
_UNITS = TIME_UNITS | {"sec", "min", "hr"}
_COUNTING = frozenset("a an half few couple of another the quarter next".split())
_HOURS = frozenset("noon midnight half quarter".split())
_BEHIND_HOURS = frozenset("o'clock am pm a.m. p.m. sharp past to exactly".split())


def times(document: Document) -> Iterator[range]:
    """The words of every time at which an order is to be carried out, or a condition asked, from left to right; none
    of what is merely told ("*my bus leaves* in ten minutes, so ...")."""
    i = 0
    while i < len(document):
        stop = _day(document, i) or _span(document, i) or _hour(document, i)
        if stop and not _is_told(document, i):
            yield range(i, stop)
        i = max(stop, i + 1)


def _is_told(document: Document, i: int) -> bool:
    """Whether the verb that a time goes with has a subject of its own, and no word ahead that makes it a condition."""
    tokens = document.tokens
    verb = i
    while tokens[verb].pos not in ("VERB", "AUX") and tokens[verb].head != verb:
        verb = tokens[verb].head
    parts = {tokens[j].dep: tokens[j].lower for j in document.children[verb] if j != i}
    is_case = parts.get("mark") in _OPENING or parts.get("advmod") in _OPENING
    is_order = parts.get("nsubj", "you") in ("you", "i") or tokens[verb].tag == "VB"
    return not (is_order or is_case)


def _day(document: Document, i: int) -> int:
    """Where a "tonight" ends, or a "later" with a mark beside it; 0 where none stands."""
    word = document.tokens[i].lower
    around = [token.text for token in (*document.tokens[max(0, i - 1) : i], *document.tokens[i + 1 : i + 2])]
    is_said = word in _DAYS and (word != "later" or i == 0 or not MARKS.isdisjoint(around))
    return i + 1 if is_said else 0


def _span(document: Document, i: int) -> int:
    """Where an "in ten minutes" or "for an hour" ends; 0 where none stands."""
    if document.tokens[i].lower not in _LEADING:
        return 0
    j = i + 1
    while j < len(document) and (document.tokens[j].lower in _COUNTING or document.tokens[j].pos == "NUM"):
        j += 1
    is_time = i + 1 < j < len(document) and document.tokens[j].lemma in _UNITS
    return j + 1 if is_time else 0


def _hour(document: Document, i: int) -> int:
    """Where an "at noon", "at half past six" or "at 6 pm" ends; 0 where none stands ("at 6 degrees")."""
    tokens = document.tokens
    if tokens[i].lower != "at" or i + 1 == len(tokens):
        return 0
    j = i + 1
    while j < len(tokens) and (tokens[j].pos == "NUM" or tokens[j].lower in _HOURS | _BEHIND_HOURS):
        j += 1
    is_alone = j == len(tokens) or tokens[j].pos not in ("NOUN", "PROPN") or tokens[j - 1].pos != "NUM"
    return j if j > i + 1 and tokens[i + 1].lower not in _BEHIND_HOURS and is_alone else 0
