"""Corrections: what is certain of single phrases that were found: which words belong to them, of what type they are,
and of which task."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.certainty import INSTRUMENTS
from decomplex_bt.understanding.references.exclusions import CLEANING
from decomplex_bt.understanding.references.looks import looks, shouts, sought_by
from decomplex_bt.understanding.references.phrases import is_pronoun, nobody
from decomplex_bt.understanding.rules.ellipses.second_places import other_places
from decomplex_bt.understanding.rules.speech.asides import whereabouts
from decomplex_bt.understanding.vocabulary import ONES, PREPOSITIONS

_PLACES = frozenset(("source", "location"))
_TAKEN_UP = {"object": frozenset("it them one some any that those".split()), "recipient": frozenset(("me", "us"))}
"""By what the argument of a type is taken up that was said before its verb."""
_IT_IS = tuple([pronoun, be] for pronoun, be in (("it", "'s"), ("it", "is"), ("they", "'re"), ("they", "are")))
_ORDERED = frozenset(("change_state", "bringing", "taking"))
_MEALS = frozenset("yesterday breakfast lunch dinner supper tea".split())
_TIMES_OF_DAY = frozenset("night week morning month year weekend afternoon christmas".split())
_MOVING = frozenset(("bringing", "taking", "placing"))


def with_goal_of_somebody(document: Document, tasks: Mapping[int, str], argument: FoundArgument) -> FoundArgument:
    """The argument; where somebody is to whom something is brought is no source but the goal ("he's in the garden")."""
    if argument.type != "source" or tasks.get(argument.owner) != "bringing":
        return argument
    first = argument.tokens.start
    starts = range(max(0, first - 4), first)
    is_of_somebody = any(first in (whereabouts(document, at) or ()) for at in starts)
    return replace(argument, type="goal") if is_of_somebody else argument


def told_behind(
    document: Document, tasks: Mapping[int, str], argument: FoundArgument, others: Sequence[FoundArgument]
) -> FoundArgument:
    """The argument; the place that is told right behind a thing is of the order that names it: "open the new carton,
    it's *in the fridge*, and pour the old one away"."""
    first = argument.tokens.start
    words = [token.lower for token in document.tokens[max(0, first - 3) : first]]
    if argument.type not in _PLACES or words[:1] != [","] or words[1:] not in _IT_IS:
        return argument
    named = (a for a in others if a.type == "object" and a.tokens.stop == first - 3 and a.owner < a.tokens.start)
    order = next((a.owner for a in named), None)
    kind = tasks.get(argument.owner if order is None else order)
    if order is None or kind not in _ORDERED or argument.owner < order:
        return argument
    return replace(argument, owner=order, type="location" if kind == "change_state" else "source")


def entire(document: Document, argument: FoundArgument) -> FoundArgument:
    """An "upside" with the "down" behind it, who is spoken of without the verb ("if *Ann* can't"), and a back with
    whose it is ("if *my father's back* is aching")."""
    start, end = argument.tokens.start, argument.tokens.stop
    last, behind = document.tokens[end - 1], document.tokens[end : end + 1]
    if last.lower == "upside" and behind and behind[0].lower == "down":
        return replace(argument, tokens=range(start, end + 1))
    after = document.tokens[end + 1 : end + 2]
    is_back = last.tag == "POS" and behind and behind[0].lower == "back" and after and after[0].pos in ("AUX", "VERB")
    if is_back and argument.owner > end:
        return replace(argument, tokens=range(start, end + 1))
    is_verb = last.lower in ("ca", "wo") and len(argument.tokens) > 1 and argument.type != "message"
    return replace(argument, tokens=range(start, end - 1)) if is_verb else argument


def with_thing_asked_for(
    document: Document, tasks: Mapping[int, str], argument: FoundArgument, arguments: Sequence[FoundArgument]
) -> FoundArgument:
    """What is brought or put somewhere is no message: "bring him *what he asks for*"."""
    first = document.tokens[argument.tokens.start].lower
    is_moved = argument.type == "message" and tasks[argument.owner] in _MOVING and first in ("what", "whatever")
    is_said = any((a.owner, a.type) == (argument.owner, "object") for a in arguments)
    return replace(argument, type="object") if is_moved and not is_said else argument


def dated(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with the day or the meal that a thing is from as part of it: "*the soup from yesterday*"."""
    days = {first: stop for first in range(len(document)) if (stop := _day_behind(document, first)) > 0}
    ends = {a.tokens.stop for a in arguments if a.type == "object" and not is_pronoun(document, a.tokens)}
    ending = {first: days[first] for first in days.keys() & ends}
    rest = [replace(a, tokens=range(ending.get(a.tokens.start, a.tokens.start), a.tokens.stop)) for a in arguments]
    return [
        replace(a, tokens=range(a.tokens.start, ending[a.tokens.stop]))
        if a.type == "object" and a.tokens.stop in ending
        else a
        for a in rest
        if a.tokens
    ]


def _day_behind(document: Document, first: int) -> int:
    """Where a "from yesterday" or "from last night" ends; 0 where none begins."""
    words = [token.lower for token in document.tokens[first : first + 3]]
    if words[:1] != ["from"] or len(words) < 2:
        return 0
    if words[1] in _MEALS:
        return first + 2
    return first + 3 if words[1:] and words[1] in ("last", "this") and words[2:] and words[2] in _TIMES_OF_DAY else 0


def with_spill_cleaned_up(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments; where something is spilt is where it is cleaned up, not where what it is cleaned with is fetched
    from ("juice is *on the rug*, get a cloth and wipe it up")."""
    tokens, kept = document.tokens, list(arguments)
    for fetching, cleaning in pairwise(sorted(tasks)):
        if tasks[fetching] not in ("taking", "bringing") or tokens[cleaning].lemma not in CLEANING:
            continue
        said = {
            tokens[a.tokens.stop - 1].lemma for a in kept if a.owner == fetching < a.tokens.start and a.type == "object"
        }
        is_taken_up = any(a.owner == cleaning and a.type == "object" and is_pronoun(document, a.tokens) for a in kept)
        if not said & INSTRUMENTS or not is_taken_up or said & {token.lemma for token in tokens[:fetching]}:
            continue
        for i, a in enumerate(kept):
            if a.owner in (fetching, cleaning) and a.type in _PLACES and a.tokens.stop <= fetching:
                kept[i] = replace(a, type="location", owner=cleaning)
    return kept


def with_choices_as_one(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments, with two of one kind and task that no more than an "or" parts as one: "if *the radio or the fan*
    is on"."""
    kept: list[FoundArgument] = []
    for argument in sorted(arguments, key=lambda a: a.tokens.start):
        before = next((a for a in reversed(kept) if a.tokens.stop + 1 == argument.tokens.start), None)
        behind = document.tokens[argument.tokens.stop :][:1]
        is_clause = argument.tokens.stop > argument.owner and any(token.pos in ("AUX", "VERB") for token in behind)
        is_choice = document.tokens[argument.tokens.start - 1].lower == "or" and not is_clause
        if before is not None and is_choice and (before.type, before.owner) == (argument.type, argument.owner):
            whole = replace(before, tokens=range(before.tokens.start, argument.tokens.stop))
            kept[kept.index(before)] = whole
        else:
            kept.append(argument)
    return kept


def is_said_again(document: Document, argument: FoundArgument, others: Sequence[FoundArgument]) -> bool:
    """Whether what stands before the verb of its task is taken up behind it: "I need *the map*, can you fetch it",
    "*the book*, bring it here"."""
    if argument.tokens.start > argument.owner or argument.type not in _TAKEN_UP:
        return False
    said = [t.lower for t in document.tokens[argument.tokens.start : argument.tokens.stop]]
    if said[-1] in _TAKEN_UP[argument.type]:
        return False
    for other in others:
        if (other.owner, other.type) == (argument.owner, argument.type) and other.tokens.start > other.owner:
            words = [t.lower for t in document.tokens[other.tokens.start : other.tokens.stop]]
            if words == said or (len(words) == 1 and words[0] in _TAKEN_UP[argument.type]):
                return True
    return False


def without_looks(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without looks, which are no things, and with what is given one as its place: "give *the shed* a
    quick scan"."""
    kept = list(arguments)
    for look in (*looks(document), *shouts(document)):
        kept = [a for a in kept if a.tokens.start not in look.words]
        is_whole = tasks.get(look.verb) != "searching" or any(a.owner == look.verb and a.type == "object" for a in kept)
        if not is_whole and (sought := sought_by(document, look)):
            kept = [a for a in kept if set(a.tokens).isdisjoint(sought)]
            kept.append(FoundArgument("object", look.verb, sought, CERTAIN))
        if look.place and tasks.get(look.verb) == "searching":
            kept = [a for a in kept if set(a.tokens).isdisjoint(look.place)]
            kept.append(FoundArgument("location", look.verb, look.place, CERTAIN))
    return kept


def is_of_nobody(document: Document, argument: FoundArgument) -> bool:
    """Whether it is the "one" of "if no one is in": a negation names nothing."""
    return argument.type == "object" and set(argument.tokens) <= set(nobody(document, argument.owner))


def is_of_wish(tasks: Mapping[int, str], argument: FoundArgument) -> bool:
    """Whether it is who wishes for what is then only picked up: nobody is given what is taken."""
    is_ahead = argument.tokens.start < argument.owner
    return is_ahead and argument.type == "recipient" and tasks.get(argument.owner) == "taking"


def corrected(observed: Observed, arguments: Sequence[FoundArgument], phrase: range) -> list[FoundArgument]:
    """The arguments with a phrase in place of the last one before it that it may stand for; a "one" stands for no
    pronoun ("Lend *me* the fan. No, the small one.")."""
    tokens = observed.document.tokens
    others = [a for a in arguments if not set(a.tokens) & set(phrase)]
    before = [a for a in others if a.tokens.stop <= phrase.start and a.type not in ("state", "manner")]
    known = next((a for a in arguments if a.type == "object" and set(a.tokens) & set(phrase)), None)
    if known is not None and not any((a.owner, a.type) == (known.owner, known.type) for a in before):
        return list(arguments)  # found as it is, and what it corrects was not
    sentences = observed.document.sentences
    before.sort(key=lambda a: a.tokens.stop)
    is_new = bool(before) and sentences[phrase.start] != sentences[before[-1].tokens.start]
    is_led = tokens[phrase.start].pos == "ADP"
    is_one = tokens[phrase.stop - 1].lower in ONES
    if is_one and not is_led and before:
        owner = before[-1].owner
        before = [a for a in before if tokens[a.tokens.start].tag != "PRP"]
        if not before:
            return [*others, FoundArgument("object", owner, phrase, CERTAIN)]
    if is_led or is_new or is_one:
        before = [a for a in before if (tokens[a.tokens.start].pos == "ADP") == is_led] or before
    if not before:
        return list(arguments)
    wrong = before[-1]
    return [*(a for a in others if a is not wrong), replace(wrong, tokens=phrase)]


def is_bare_preposition(document: Document, argument: FoundArgument) -> bool:
    """Whether nobody is named by whom somebody is told something: "knock *on* the door"."""
    is_single = argument.type == "recipient" and len(argument.tokens) == 1
    return is_single and document.tokens[argument.tokens.start].lower in PREPOSITIONS - {"to", "for", "with"}


def is_one_who_asks(document: Document, tasks: Mapping[int, str], argument: FoundArgument) -> bool:
    """Whether it is the "I" that asks for an order: "if *I* asked you to go"."""
    is_single = len(argument.tokens) == 1 and argument.type == "object"
    is_speaker = is_single and document.tokens[argument.tokens.start].lower in ("i", "we")
    return is_speaker and tasks.get(argument.owner) not in (None, "check_state")


def with_either_place(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with the second of two places of which one is meant, as the first is one ("it's in the hall or else
    *under the desk*")."""
    kept = list(arguments)
    for joint, place in other_places(document, tasks):
        ends = (joint, joint - 1) if document.tokens[joint - 1].text == "," else (joint,)
        places = [a for a in kept if a.type in _PLACES]
        both = [a for a in places if a.tokens.start < ends[-1] and joint < a.tokens.stop]
        first = next(iter([*both, *(a for a in places if a.tokens.stop in ends)]), None)
        if first is not None:
            kept = [a for a in kept if set(a.tokens).isdisjoint(place) and a is not first]
            kept.append(replace(first, tokens=range(first.tokens.start, min(first.tokens.stop, ends[-1]))))
            kept.append(FoundArgument(first.type, first.owner, place, CERTAIN))
    return kept
