"""Statements: where something is said to be, which tells nothing of another thing ("Mum is *in the kitchen*. Bring me
my jacket.")."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import ENDS, FINITE, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.certainty import INSTRUMENTS
from decomplex_bt.understanding.references.phrases import is_pronoun
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS

BELONGING = frozenset(("belong", "belongs"))
"""What is said of the place that a thing has."""
_BEING = frozenset(("be", "'s"))
_TO_BE = BELONGING | frozenset("due expected wanted needed awaited required".split())
"""What is said of things that are to be somewhere."""
_BEING_SO = frozenset(("JJ", "VBN", "VBG"))
"""How somebody is somewhere: stuck, asleep, sitting."""
_NOUNS = frozenset(("NOUN", "PROPN"))
_NAMING = frozenset(("NN", "NNS", "NNP", "NNPS"))
_OWNED = frozenset("his her its their 's '".split())
"""What may make a thing that of somebody who was spoken of, and is then with them: "take *its* leash off"."""
_PLACES = frozenset(("source", "location"))
_FETCHING = frozenset(("bringing", "taking", "placing"))
_TAKING = frozenset(("bringing", "taking", "searching", "motion"))  # "see if you can *reach it*"
_IT = frozenset(("it", "them", "'em", "em", "those", "that"))
_SAME = frozenset("one ones other others its their it them".split())
_PESTS = frozenset("spider wasp bee fly ant beetle bug moth mosquito snail slug frog snake squirrel fox".split())


@dataclass(frozen=True, slots=True)
class _Stated:
    """A source with the noun of which a statement tells it, and all nouns of that phrase."""

    source: FoundArgument
    subject: int
    nouns: frozenset[str]


def without_places_of_others(
    observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without a source that a statement tells of something else: of somebody or an animal where a thing
    is fetched, or of one thing where another statement tells it of what is fetched ("the forks are *in the drawer* and
    the plates are on the rack, bring me a plate"), or where there is something to be cleaned, or which one is spoken of
    where the order has a place of its own; nor one where something is only to be, or that a condition asks to be at
    another. "The tools are in the shed, get the hammer" stays open."""
    document = observed.document
    stated = [found for a in arguments if a.type == "source" and (found := _stated(document, tasks, a)) is not None]
    strange = {id(found.source) for found in stated if _is_strange(observed, found, stated, arguments)}
    strange |= {id(a) for a in arguments if a.type in _PLACES and _is_of_mess(document, arguments, a)}
    strange |= {id(a) for a in arguments if a.type in _PLACES and _is_of_subject(document, tasks, arguments, a)}
    strange |= {id(a) for a in arguments if a.type == "source" and _is_to_be_there(document, tasks, a)}
    strange |= {id(a) for a in arguments if a.type in _PLACES and _is_asked_otherwise(document, tasks, arguments, a)}
    return [a for a in arguments if id(a) not in strange]


def _is_asked_otherwise(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument], place: FoundArgument
) -> bool:
    """Whether a sentence before tells a place of what a condition asks to be at another: "there's a lamp *in the
    study*. If it's on the desk, bring it"."""
    owner, of = place.owner, document.sentences
    is_before = place.tokens.stop <= owner and any(t.text in ENDS for t in document.tokens[place.tokens.stop : owner])
    if tasks[owner] != "check_state" or not is_before or any(of[i] == of[place.tokens.start] for i in tasks):
        return False
    return any((a.owner, a.type) == (owner, "location") and a.tokens.start > owner for a in arguments)


def _is_of_subject(
    document: Document, tasks: Container[int], arguments: Sequence[FoundArgument], place: FoundArgument
) -> bool:
    """Whether a place only tells which thing a statement is about, ahead of an order that fetches or looks for another
    thing somewhere else: "the alarm *in the hall* is bleeping, get a battery from the drawer"."""
    tokens, owner = document.tokens, place.owner
    subject = tokens[place.tokens.start].head
    of = [a for a in arguments if a.owner == owner and a.tokens.start > owner]
    things = [a.tokens for a in of if a.type == "object" and not is_pronoun(document, a.tokens)]
    stop = place.tokens.stop
    if not things or not any(a.type in _PLACES for a in of) or subject != place.tokens.start - 1 or stop >= owner:
        return False
    is_stated = tokens[subject].dep in ("nsubj", "nsubjpass") and tokens[stop].tag in FINITE
    nouns = frozenset[str]().union(*(_nouns(document, thing) for thing in things))
    is_apart = stop <= tokens[subject].head < owner and tokens[subject].head not in tasks and stop not in tasks
    return is_stated and is_apart and tokens[subject].lemma.lower() not in nouns


def _is_to_be_there(document: Document, tasks: Container[int], source: FoundArgument) -> bool:
    """Whether a statement tells that something is to be at a place, where it is not yet: "the cake is due *in the
    hall*. Take it off the shelf and ..."."""
    tokens, first = document.tokens, source.tokens.start
    if first == 0 or source.owner < first or tokens[first - 1].lower not in _TO_BE or first - 1 in tasks:
        return False
    return tokens[first - 1].lower in BELONGING or (first > 1 and tokens[first - 2].lemma in _BEING)


def _is_of_mess(document: Document, arguments: Sequence[FoundArgument], place: FoundArgument) -> bool:
    """Whether a place is where something is to be cleaned up with what is fetched, as a clause of its own tells: "I
    spilled my coke *on the table*, bring me a sponge"."""
    tokens = document.tokens
    things = [
        a.tokens for a in arguments if (a.owner, a.type) == (place.owner, "object") and a.tokens.start > place.owner
    ]
    between = tokens[place.tokens.stop : place.owner]
    if not things or not any(token.text in MARKS | ENDS for token in between):
        return False
    fetched = {tokens[thing.stop - 1].lemma for thing in things}
    said = {
        t.lemma
        for t in tokens[: place.tokens.start]
        if document.sentences[t.i] == document.sentences[place.tokens.start]
    }
    is_clause = any(t.tag in ("VBD", "VBZ", "VBP", "VBN") for t in tokens[: place.tokens.start])
    return fetched <= INSTRUMENTS and is_clause and fetched.isdisjoint(said)


def with_nearer_places(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with the place that a statement tells as that of the first order behind it that takes the thing up:
    "my scarf's *on the piano*. Fetch it, and if you can't, bring me a shawl". Where that has a place of its own, it is
    of nothing else that is fetched later."""
    kept = list(arguments)
    for place in arguments:
        if place.type not in _PLACES or tasks[place.owner] not in _FETCHING:
            continue
        taker = _taker(document, tasks, arguments, place)
        if taker is None:
            continue
        kind = "location" if tasks[taker] == "searching" else "source"
        if not any(a.owner == taker and a.type in _PLACES for a in kept):
            kept[kept.index(place)] = replace(place, owner=taker, type=kind)
        elif _is_of_something_else(document, arguments, place):
            kept.remove(place)
    return kept


def _taker(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument], place: FoundArgument
) -> int | None:
    """The first order between a statement of a place and the task that has it that takes up what is said to be there;
    None where another thing was named before, or there is no such order."""
    of, stop = document.sentences, place.tokens.stop
    if of[stop - 1] == of[place.owner] or any(of[i] == of[stop - 1] for i in tasks):
        return None
    for task in sorted(i for i in tasks if stop <= i < place.owner):
        objects = [a.tokens for a in arguments if a.owner == task and a.type in ("object", "goal")]
        is_of_it = any(len(o) == 1 and document.tokens[o.start].lower in _IT for o in objects)
        if is_of_it and tasks[task] in _TAKING:
            return task
        if tasks[task] == "searching" and not any(a.owner == task and a.type == "object" for a in arguments):
            return task
        if any(a.owner == task and a.type == "object" and not is_pronoun(document, a.tokens) for a in arguments):
            return None
    return None


def _is_of_something_else(document: Document, arguments: Sequence[FoundArgument], place: FoundArgument) -> bool:
    """Whether what is fetched is named, and not by any noun of the statement of a place."""
    sentence = document.sentences[place.tokens.start]
    said = _nouns(document, [t.i for t in document.tokens if document.sentences[t.i] == sentence])
    things = [a.tokens for a in arguments if (a.owner, a.type) == (place.owner, "object")]
    words = {document.tokens[i].lower for thing in things for i in thing}
    nouns = frozenset[str]().union(*(_nouns(document, thing) for thing in things))
    return bool(nouns) and nouns.isdisjoint(said) and words.isdisjoint(_SAME)


def _stated(document: Document, tasks: Container[int], source: FoundArgument) -> _Stated | None:
    """A source that a clause with "be" of its own tells, which is no task and no relative clause; else None."""
    tokens = document.tokens
    verb = tokens[source.tokens.start].head
    if tokens[verb].dep == "attr":  # "there's *a wasp on the window*"
        verb = tokens[verb].head
    if tokens[verb].dep == "acomp":  # "the dog is asleep *on the rug*"
        verb = tokens[verb].head
    parts = {tokens[i].dep: i for i in document.children[verb]}
    # of "the cat's stuck *on the roof*" the tagger may make somebody's
    owner = parts.get("poss") if tokens[verb].tag in _BEING_SO else None
    inner = (*document.children[verb], *(document.children[owner] if owner is not None else ()))
    is_being = tokens[verb].tag in _BEING_SO and any(tokens[i].lemma in _BEING for i in inner)
    if verb in tasks or not (is_being or tokens[verb].lemma in _BEING):
        return None
    is_there = "expl" in parts
    subject = parts.get("attr") if is_there else parts.get("nsubj", parts.get("nsubjpass", owner))
    if subject is None or tokens[subject].tag not in _NAMING:
        return None
    words = range(min((subject, *document.children[subject])), subject + 1)
    return _Stated(source, subject, _nouns(document, words))


def _is_strange(
    observed: Observed, found: _Stated, stated: Sequence[_Stated], arguments: Sequence[FoundArgument]
) -> bool:
    """Whether what is fetched is not what a statement tells of."""
    document, owner = observed.document, found.source.owner
    things = [a.tokens for a in arguments if (a.owner, a.type) == (owner, "object")]
    if not things or any(is_pronoun(document, thing) for thing in things):
        return False
    fetched = frozenset[str]().union(*(_nouns(document, thing) for thing in things))
    if not fetched or fetched & found.nouns:
        return False
    others = [other for other in stated if other.source.owner == owner and other is not found]
    if any(other.nouns & fetched for other in others):
        # "the key is in the box and the box is *in the hall*"
        return not any(found.nouns & _nouns(document, other.source.tokens) for other in others)
    is_owned = any(document.tokens[i].lower in _OWNED for thing in things for i in thing)
    is_of_being = _is_animate(observed, found.subject)
    return is_of_being and not is_owned and not any(_is_animate(observed, i) for thing in things for i in thing)


def _nouns(document: Document, words: Sequence[int]) -> frozenset[str]:
    return frozenset(document.tokens[i].lemma.lower() for i in words if document.tokens[i].pos in _NOUNS)


def _is_animate(observed: Observed, i: int) -> bool:
    """Whether a noun names somebody or an animal."""
    token = observed.document.tokens[i]
    category = observed.gazetteer.category(token.lemma)
    is_name = token.tag in ("NNP", "NNPS") and not category and token.text[:1].isupper()
    return category == "person" or is_name or token.lemma.lower() in PERSON_NOUNS | ANIMALS | _PESTS
