"""Telegraph style: orders without an article, whose verbs a tagger takes for nouns ("feed cat, *water plants*, brush
dog")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.orders.reports import within_reports

_ARTICLES = frozenset(("DT", "PRP$"))
_JOINING = frozenset("and then".split())
_PHRASE = frozenset(("NOUN", "PROPN", "ADJ", "NUM"))
_NAMING = frozenset(("NOUN", "PROPN"))
_LISTING = frozenset(("bringing", "taking", "placing", "searching"))
_LONGEST = 5
"""The most words of an order."""


def telegraphed(observed: Observed, tasks: Mapping[int, str]) -> dict[int, str]:
    """The verbs of clauses that are no more than a verb and what it is done to, where nothing in the text has an
    article and no word of the clause is a task or told somebody; with task types. `tasks`: tokens with types, of which
    there is one.

    What follows an order to fetch or put something may be a list of things ("bring cups, dust pans, brushes").
    """
    document, verbs = observed.document, observed.gazetteer.verbs
    if not tasks or any(token.tag in _ARTICLES for token in document.tokens):
        return {}
    told = within_reports(document, tasks)
    found: dict[int, str] = {}
    for clause in _clauses(document):
        first = document.tokens[clause.start]
        before = max((i for i in tasks if i < clause.start), default=None)
        is_free = (
            not any(i in tasks or i in told for i in clause) and before is not None and tasks[before] not in _LISTING
        )
        if is_free and first.lower in verbs and first.pos in _NAMING | {"VERB"} and named(document, clause.start):
            found[clause.start] = verbs[first.lower][0]
    return found


def named(document: Document, verb: int) -> range:
    """What stands right behind such a verb, up to its noun; empty where more stands between, or nothing."""
    clause = next((clause for clause in _clauses(document) if verb in clause), None)
    if clause is None:  # what was taken for a verb is a mark, or what joins
        return range(0)
    stop = verb + 1
    while stop < clause.stop and document.tokens[stop].pos in _PHRASE:
        stop += 1
    is_named = stop > verb + 1 and document.tokens[stop - 1].pos in _NAMING and len(clause) <= _LONGEST
    is_whole = stop == clause.stop or document.tokens[stop].pos == "ADP"
    return range(verb + 1, stop) if is_named and is_whole else range(0)


def _clauses(document: Document) -> Iterator[range]:
    """The stretches between marks, without what joins them."""
    start = 0
    for i in range(len(document) + 1):
        if i == len(document) or document.tokens[i].text in MARKS or document.tokens[i].lower in _JOINING:
            if i > start:
                yield range(start, i)
            start = i + 1
