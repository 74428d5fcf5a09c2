"""Causatives: what is to be got done ("get the lawn *mown* and the hedge *trimmed*", "could the lawn be *mown* and the
hedge *trimmed*?"), and what somebody else is to be told to do ("have Tom *mow the lawn*")."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import PARTICLES
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.first_names import MEN, WOMEN
from decomplex_bt.understanding.rules.orders.deeds import done_to, joined, types_of
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS

_CAUSING = frozenset(("get", "have"))
_BIDDING = _CAUSING | {"let"}
_BEFORE_ORDERS = MARKS | frozenset("and then please just also so now ok okay robot".split())
_REQUESTING = frozenset("can could will would might may".split())
_JOINING = frozenset((",", "and", "then"))
_OTHERS = frozenset("him her them".split())
_PRONOUNS = _OTHERS | {"it", "this", "that"}
_OBJECTS = _PRONOUNS | {"me", "us"}
_BARE = frozenset(("VB", "VBP", "VBD", "VBN", "NN", "JJ"))
"""Tags of bare verbs, and those that a tagger gives them where they stand behind somebody."""
_ENDING = MARKS | frozenset(
    "and then please now too again first before after when while once if unless by for so or but".split()
)
_CLAUSE_ENDS = MARKS | frozenset("and then but or if unless when before after while until till once because".split())
_OF_LET = frozenset("know go be have hear cool".split())
"""What "let" makes one verb with."""
_DONE = ("VBN", "VBD")
_LIKE_PARTICIPLES = ("ed", "en", "wn")
_NO_DEEDS = frozenset("was were been being got had gone come left eaten done".split())
"""What is said of a thing, or is what somebody has done: "have the boys eaten?"."""


class Done(NamedTuple):
    """What is to be got done: the first word that says so, what it is done to, and the participles of what is done."""

    first: int
    thing: range
    deeds: tuple[int, ...]


class Bidding(NamedTuple):
    """Who is to do what: the verb, who, and what from the first word on to the end of its clause."""

    verb: int
    whom: range
    message: range


def got_done(observed: Observed) -> Iterator[Done]:
    """Every order to get something done that says with its last word what: "*get* the beds *changed*", "*have* it
    *hoovered* and *polished*", and what is to be done to each further thing in a list ("and *the hall swept*"); of a
    request in the passive only where it asks for several. Not "get the box *marked* fragile", nor what tells a state
    ("get the door *shut*")."""
    document, tokens = observed.document, observed.document.tokens
    for verb, thing in _orders(document, _CAUSING | _REQUESTING):
        done, is_request = _done(document, verb, thing), tokens[verb].lower in _REQUESTING
        if done is None or is_request != (tokens[done.deeds[0] - 1].lower == "be"):
            continue
        added = list(_added(document, done))
        if is_request and (_is_somebody(document, thing) or not (added or len(done.deeds) > 1)):
            continue
        if tokens[verb].lower != "get" or tokens[done.deeds[0]].lower not in observed.gazetteer.pairs:
            yield done
        yield from added


def biddings(document: Document) -> Iterator[Bidding]:
    """Every order to have somebody do something: "*have* Tom mow the lawn", "*get* her to sign it", "*let* him carry
    the box"; where somebody is let do what nothing is done to, nothing is asked for ("let the baby sleep")."""
    tokens = document.tokens
    for verb, whom in _orders(document, _BIDDING):
        start = whom.stop + (tokens[verb].lower == "get")
        if not _is_somebody(document, whom) or start >= len(tokens) or not _is_bare(document, start):
            continue
        if tokens[verb].lower == "get" and tokens[whom.stop].lower != "to":
            continue
        if tokens[verb].lower == "let" and (tokens[start].lower in _OF_LET or not _has_object(document, start)):
            continue
        stop = next((t.i for t in tokens[start:] if t.lower in _CLAUSE_ENDS), len(tokens))
        yield Bidding(verb, whom, range(whom.stop, stop))


def with_biddings(document: Document, arguments: Sequence[FoundArgument], verb: int) -> list[FoundArgument]:
    """The arguments with who is to do something as who is told to, and what as the message."""
    for bidding in biddings(document):
        if bidding.verb == verb:
            words = range(verb, bidding.message.stop)
            rest = [a for a in arguments if a.owner != verb and set(a.tokens).isdisjoint(words)]
            told = {"recipient": bidding.whom, "message": bidding.message}
            return rest + [FoundArgument(name, verb, said, CERTAIN) for name, said in told.items()]
    return list(arguments)


def with_done(observed: Observed, arguments: Sequence[FoundArgument], deed: int, kind: str) -> list[FoundArgument]:
    """The arguments with what is to be got done as what that is done to."""
    for done in got_done(observed):
        if deed in done.deeds:
            words = {*done.thing, *done.deeds}
            kept = [a for a in arguments if words.isdisjoint(a.tokens) or a.owner in {*done.deeds} - {deed}]
            return done_to(observed.document, kept, deed, kind, done.thing)
    return list(arguments)


def causative_types(observed: Observed) -> dict[int, str]:
    """The tokens of what is to be got done, and of who is to be told to do something, with task types."""
    document = observed.document
    found: dict[int, str] = {}
    if document.words.isdisjoint(_BIDDING | _REQUESTING):
        return found
    for done in got_done(observed):
        found |= types_of(observed, done.thing, done.deeds, ())
    return found | {bidding.verb: "informing" for bidding in biddings(document)}


def without_tasks(observed: Observed) -> frozenset[int]:
    """The words in which nothing is a task: what somebody else is to do, and what is to be got done up to the
    participles of that."""
    document = observed.document
    if document.words.isdisjoint(_BIDDING | _REQUESTING):
        return frozenset()
    messages = (bidding.message for bidding in biddings(document))
    got = (set(range(done.first, done.deeds[-1])) - {*done.deeds} for done in got_done(observed))
    return frozenset().union(*messages, *got)


def _orders(document: Document, verbs: Collection[str]) -> Iterator[tuple[int, range]]:
    """The verbs of orders and requests, with what is named right behind each."""
    if document.words.isdisjoint(verbs):
        return
    for token in document.tokens[:-2]:
        if token.lower in verbs and _is_order(document, token.i) and (named := _named(document, token.i + 1)):
            yield token.i, named


def _named(document: Document, start: int) -> range:
    """What is named from a token on; empty where nothing is."""
    if document.tokens[start].lower in _PRONOUNS:
        return range(start, start + 1)
    return next((chunk for chunk in noun_chunks(document) if chunk.start == start), range(0))


def _done(document: Document, first: int, thing: range) -> Done | None:
    """What is said right behind a thing to be done to it, with a "be" at most between, at the end of its clause."""
    tokens = document.tokens
    deed = thing.stop + (thing.stop < len(tokens) and tokens[thing.stop].lower == "be")
    if deed >= len(tokens) or not _is_done(document, deed):
        return None
    between = ("CC", ",", "RP", *_DONE)
    further = [i for i in joined(document, deed) if all(t.tag in between or t.lower == "then" for t in tokens[deed:i])]
    deeds = (deed, *further)
    behind = _behind(document, deeds[-1])
    is_ended = behind == len(tokens) or tokens[behind].lower in _ENDING
    return Done(first, thing, deeds) if is_ended else None


def _added(document: Document, done: Done) -> Iterator[Done]:
    """What is to be done to further things, named in a list: "the lawn mown and *the hedge trimmed*"."""
    tokens, behind = document.tokens, _behind(document, done.deeds[-1])
    start = next((token.i for token in tokens[behind:] if token.lower not in _JOINING), behind)
    thing = _named(document, start) if start > behind else range(0)
    added = _done(document, start, thing) if thing else None
    if added is not None:
        yield added
        yield from _added(document, added)


def _behind(document: Document, deed: int) -> int:
    """The first token behind a deed and its particle."""
    behind = (t.i for t in document.tokens[deed + 1 :] if t.tag != "RP" and t.lower not in PARTICLES)
    return next(behind, len(document))


def _is_done(document: Document, at: int) -> bool:
    """Whether a word is a participle, be it tagged as a noun or an adjective: "get the lawns *mown*"."""
    token = document.tokens[at]
    is_like = token.dep in ("ccomp", "advmod") and token.lower.endswith(_LIKE_PARTICIPLES)
    return (token.tag in _DONE or is_like) and token.lower not in _NO_DEEDS


def _is_order(document: Document, verb: int) -> bool:
    """Whether a verb begins what is ordered: a sentence or a clause, or a "could you"; or an auxiliary a request."""
    tokens, first = document.tokens, document.sentences.index(document.sentences[verb])
    end = next((token.text for token in tokens[verb:] if token.text in ENDS), ".")
    before = verb - 1
    if before > first and tokens[before].lower == "you" and tokens[before - 1].lower in _REQUESTING:
        return True
    is_said_so = end != "?" or tokens[verb].lower in _REQUESTING
    return is_said_so and (before < first or tokens[before].lower in _BEFORE_ORDERS)


def _is_somebody(document: Document, whom: range) -> bool:
    last = document.tokens[whom[-1]]
    is_name = last.lower in MEN | WOMEN or (last.tag == "NNP" and len(whom) == 1 and last.text[:1].isupper())
    return last.lower in _OTHERS or last.lemma in PERSON_NOUNS or is_name


def _is_bare(document: Document, at: int) -> bool:
    """Whether a word behind somebody or something is a verb in its bare form."""
    token = document.tokens[at]
    return token.lower == token.lemma and token.tag in _BARE and token.text.islower()


def _has_object(document: Document, verb: int) -> bool:
    """Whether something is done to a thing that is named right behind a verb."""
    behind = document.tokens[verb + 1 : verb + 2]
    return bool(behind) and (behind[0].tag in ("DT", "PRP$") or behind[0].lower in _OBJECTS)
