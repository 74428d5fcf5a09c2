"""Waits: what is not to be done until something else is so or done ("don't start it before the basket is full")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.rules.cases.suppositions import participle
from decomplex_bt.understanding.rules.orders.prohibitions import OMITTING, is_forbidden

AWAITING = frozenset(("before", "until", "till", "til"))
_HAVE = frozenset("has have 've ve".split())
_BE = frozenset("is are 's 're am 'm m s re".split())
BE_OR_HAVE = _HAVE | _BE
_JOINING = frozenset(("and", "but", "or", "so", "then"))
_ORDERED = frozenset(("you", "u"))
_OBJECTS = frozenset(("me", "him", "us", "them"))
_PRONOUNS = _OBJECTS | {"it", "her"}
_IDLE = frozenset("wait worry bother need want be have think know start begin stop get".split())
"""Verbs that name no order of their own behind a "don't", or one that was given before ("don't start until ...")."""
_NEAR = frozenset(("near", "anywhere"))
_NAMING = frozenset(("DET", "ADJ", "NOUN", "PROPN", "NUM"))
_TO_ANIMALS = {"feed": "change_state", "walk": "following"}


class Awaited(NamedTuple):
    """What a prohibition waits for: the verb that it forbids till then, and the tokens of who or what it is said of."""

    forbidden: int
    subject: range


def awaited(document: Document, tasks: Mapping[int, str]) -> dict[int, Awaited]:
    """The verbs of what is told behind a forbidden task and a "before", where no word up to the end of the clause is a
    task yet ("don't start it before the basket *is* full", "... before the timer *rings*"); with what they say."""
    found = dict[int, Awaited]()
    for forbidden, clause in _waits(document):
        verb = _told(document, clause)
        if verb is None or any(i in clause and i != verb for i in tasks):
            continue
        be = next((i for i in range(clause.start + 1, verb + 1) if document.tokens[i].lower in BE_OR_HAVE), verb)
        found[verb] = Awaited(forbidden, range(clause.start, be))
    return found


def postponed(observed: Observed, tasks: Mapping[int, str]) -> dict[int, str]:
    """The forbidden verbs, with task types, that are no tasks yet, and are to be done once something else is so or is
    done: "don't *leave* until you've shut the piano", "before it's dry, don't *paint* it"."""
    document = observed.document
    checks = awaited(document, tasks)
    return {
        forbidden: type_of(observed, forbidden)
        for forbidden, clause in _waits(document)
        if forbidden not in tasks
        and observed.senses[forbidden]
        and document.tokens[forbidden].lemma not in OMITTING | _IDLE
        and _NEAR.isdisjoint(token.lower for token in document.tokens[forbidden + 1 : forbidden + 2])
        and any(i in clause for i in (*tasks, *checks))
    }


def type_of(observed: Observed, verb: int) -> str:
    """The task type of a verb that has senses, by the first of them but for what is done to an animal."""
    return _TO_ANIMALS.get(observed.document.tokens[verb].lemma, observed.senses[verb][0])


def _waits(document: Document) -> Iterator[tuple[int, range]]:
    """For every "until" of a prohibition, behind it or ahead, the verb that is forbidden till then and the clause that
    says what is waited for."""
    tokens = document.tokens
    if AWAITING.isdisjoint(document.words):
        return
    for i, token in enumerate(tokens):
        if token.lower not in AWAITING:
            continue
        start = next((j + 1 for j in range(i - 1, -1, -1) if tokens[j].lower in MARKS | _JOINING), 0)
        stop = next((j for j in range(i + 1, len(tokens)) if tokens[j].lower in MARKS | _JOINING), len(tokens))
        forbidden = next((j for j in range(start, i) if is_forbidden(document, j)), None)
        if forbidden is not None:
            yield forbidden, range(i + 1, stop)
        elif start == i:
            same = document.sentences[i]
            end = next((j for j in range(i, len(tokens)) if document.sentences[j] != same), len(tokens))
            forbidden = next((j for j in range(i + 3, end) if is_forbidden(document, j)), None)
            if forbidden is not None and _is_next(document, stop, forbidden):
                yield forbidden, range(i + 1, min(stop, forbidden - 1))


def _is_next(document: Document, stop: int, forbidden: int) -> bool:
    """Whether the clause behind an "until" is followed by the one that forbids, with a comma between or none."""
    tokens = document.tokens
    if stop >= forbidden:
        return True
    between = tokens[stop:forbidden]
    return between[0].text == "," and all(t.pos not in ("VERB", "NOUN") for t in between[1:])


def _told(document: Document, clause: range) -> int | None:
    """The verb that says what is waited for; None where that is an order ("until *you*'ve locked up")."""
    tokens = document.tokens
    if len(clause) < 2 or tokens[clause.start].lower in _ORDERED | _OBJECTS:
        return None
    be = next((j for j in range(clause.start + 1, clause.stop) if tokens[j].lower in BE_OR_HAVE), None)
    if be is not None:
        return participle(document, be) if tokens[be].lower in _HAVE else be
    verb = next((j for j in range(clause.start + 1, clause.stop) if tokens[j].pos == "VERB"), None)
    if verb is not None:
        named = tokens[clause.start : verb]
        is_clause = all(t.pos in _NAMING or t.tag in ("PRP", "PRP$") for t in named)
        return verb if is_clause and tokens[verb].tag in ("VBZ", "VBP") else None
    first, last = tokens[clause.start], tokens[clause.stop - 1]  # "the timer rings" is two nouns to the tagger
    is_clause = len(clause) > 2 and first.tag in ("DT", "PRP$") and tokens[last.i - 1].tag == "NN" and last.tag == "NNS"
    return last.i if is_clause else None


def forgone(document: Document) -> frozenset[int]:
    """The tokens of what is not to be waited for: "don't wait until *it's full*, start it now"."""
    waits = (clause for forbidden, clause in _waits(document) if document.tokens[forbidden].lemma == "wait")
    return frozenset(i for clause in waits for i in clause)


def kept_from(document: Document, tasks: Mapping[int, str], verb: int) -> dict[str, range]:
    """What a verb that is forbidden till then is done to, or where somebody is not to go, right behind the verb;
    nothing for any other verb."""
    if not any(forbidden == verb for forbidden, _ in _waits(document)):
        return {}
    tokens, start = document.tokens, verb + 1
    start += start < len(tokens) and tokens[start].tag == "RP"
    is_led = start < len(tokens) and tokens[start].lower == "to" and tasks[verb] == "motion"
    thing = next((chunk for chunk in noun_chunks(document) if chunk.start == start + is_led), range(0))
    if not thing and start < len(tokens) and tokens[start].lower in _PRONOUNS:
        thing = range(start, start + 1)
    if not thing:
        return {}
    if tasks[verb] == "motion":
        return {"goal" if is_led else "source": range(start, thing.stop)}
    return {"recipient" if tasks[verb] == "informing" else "object": thing}
