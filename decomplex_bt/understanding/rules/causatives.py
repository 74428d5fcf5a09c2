"""Causatives: what is to be had done to things, ordered with participles ("*have the rug beaten* and *the curtains
washed*", "could the yard be swept and *the gate painted*?")."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.domain.verbs import lemmas
from decomplex_bt.understanding.document import ENDS, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import PARTICLES
from decomplex_bt.understanding.references.phrases import PERSON_NOUNS
from decomplex_bt.understanding.rules.fragments import Fragment

_CAUSING = frozenset(("have", "get"))
_JOINING = frozenset((",", "and"))
_MODALS = frozenset("can could would will might may".split())
_LEADING = MARKS | frozenset("and then please also so now just ok okay robot".split())
_PAST = frozenset(("VBN", "VBD"))
_NO_DEEDS = frozenset("been got had gone come left eaten done".split())
"""Participles of what somebody has done: "have the boys eaten?"."""
_NOMINAL = frozenset(("ADJ", "NOUN", "PROPN", "NUM"))
_BEHIND = MARKS | PARTICLES | frozenset("and then please too before by when once if for first again".split())
_HANDLING = frozenset("bringing taking placing change_state".split())


def causatives(observed: Observed) -> Iterator[Fragment]:
    """What is to be had done, each thing with its participle, which carries the order; of a passive request the things
    that "and" adds without an auxiliary of their own. Not what a question asks ("have the cups been washed?") nor what
    only tells which thing is meant ("get the cups stacked on the shelf")."""
    document = observed.document
    if document.words.isdisjoint(_CAUSING | _MODALS):
        return
    for i, token in enumerate(document.tokens):
        is_caused = token.lower in _CAUSING and _begins_order(document, i)
        if not is_caused and not (token.lower in _MODALS and _begins_clause(document, i)):
            continue
        first = _done_to(document, i + 1)
        is_passive = first is not None and document.tokens[first.stop - 2].lower == "be"
        if first is None or is_caused == is_passive:
            continue
        if token.lower == "get" and document.tokens[first.stop - 1].lower in observed.gazetteer.pairs:
            continue  # "get the gate shut" tells the state
        added = list(_added(document, first.stop))
        if is_caused or added:
            yield _fragment(observed, i, first)
        yield from (_fragment(observed, one.start, one) for one in added)


def _added(document: Document, stop: int) -> Iterator[range]:
    """The further things with their participles that follow one that ends there in a list, and what is to be done to
    the same thing as well ("washed *and dried*")."""
    tokens = document.tokens
    while stop < len(tokens) and tokens[stop].lower in PARTICLES:
        stop += 1
    start = stop
    while start < len(tokens) and tokens[start].lower in _JOINING:
        start += 1
    if start == stop or start >= len(tokens):
        return
    other = _done_to(document, start)
    if other is None and tokens[start - 1].lower == "and" and tokens[start].tag in _PAST:
        other = range(start, start + 1)
    if other is not None:
        yield other
        yield from _added(document, other.stop)


def _done_to(document: Document, start: int) -> range | None:
    """A thing named from a token on, up to the participle of what is done to it, with a "be" at most between."""
    tokens = document.tokens
    if start >= len(tokens) or not (tokens[start].tag in ("DT", "PRP$") or tokens[start].lower in ("all", "both")):
        return None
    at = start + 1
    while (
        at < len(tokens)
        and (tokens[at].pos in _NOMINAL or tokens[at].tag in ("DT", "POS"))
        and not _is_done(tokens, at)
    ):
        at += 1
    noun = at - 1
    at += at < len(tokens) and tokens[at].lower == "be"
    is_thing = noun > start and tokens[noun].pos in ("NOUN", "PROPN") and tokens[noun].lemma not in PERSON_NOUNS
    is_done = at < len(tokens) and tokens[at].tag in _PAST and tokens[at].lower not in _NO_DEEDS
    behind = tokens[at + 1].lower if at + 1 < len(tokens) else "."
    return range(start, at + 1) if is_thing and is_done and behind in _BEHIND | ENDS else None


def _is_done(tokens: Sequence[Token], at: int) -> bool:
    return tokens[at].tag in _PAST and tokens[at - 1].pos in ("NOUN", "PROPN")


def _fragment(observed: Observed, first: int, done_to: range) -> Fragment:
    verb = done_to.stop - 1
    stop = verb - (len(done_to) > 1 and observed.document.tokens[verb - 1].lower == "be")
    thing = range(done_to.start, stop)
    return Fragment(range(first, done_to.stop), verb, thing, range(0), type=_type(observed, verb))


def _type(observed: Observed, verb: int) -> str:
    """The task type of what is done to a thing, by the form of the participle."""
    verbs, particle = observed.gazetteer.verbs, observed.gazetteer.particle(observed.document, verb)
    forms = list(lemmas(observed.document.tokens[verb].lower))
    known = (kind for form in (*(f"{form} {particle}" for form in forms), *forms) for kind in verbs.get(form, ()))
    return next((kind for kind in known if kind in _HANDLING), "change_state")


def _begins_clause(document: Document, i: int) -> bool:
    is_first = i == 0 or document.sentences[i - 1] != document.sentences[i]
    return is_first or document.tokens[i - 1].lower in _LEADING


def _begins_order(document: Document, i: int) -> bool:
    """Whether a "have" or "get" orders: it begins a clause and no question, or stands behind a "could you"."""
    tokens = document.tokens
    end = next((token.lower for token in tokens[i:] if token.lower in ENDS), ".")
    is_asked = i > 1 and tokens[i - 1].lower == "you" and tokens[i - 2].lower in _MODALS
    return is_asked or (_begins_clause(document, i) and end != "?")
