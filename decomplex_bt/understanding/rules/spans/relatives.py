"""Relatives: what only tells which thing is meant, or which is not, is no state to bring about, nor an argument."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.phrases import is_pronoun
from decomplex_bt.understanding.references.relatives import (
    ADVERBS,
    BE,
    WHATEVER,
    WHOLE,
    clauses,
    exclusions,
    free_relatives,
)

_MOVING = frozenset(("placing", "bringing", "taking"))
_STATES = frozenset(("state", "message", "manner"))
_PLACES = frozenset(("goal", "source", "location", "path"))
_RELATIVE = frozenset(("that", "which"))
_POSTURES = frozenset("lie stand hang sit lean rest".split())
_MAY = frozenset("should might must may could will".split())
_USUALLY = ADVERBS | frozenset("usually normally always probably still".split())
_PLACED = frozenset("kept left stored put placed parked".split())
_WHERE = frozenset("in on at by under behind beside inside into onto near over above below next".split())
_ENDING = frozenset("in on into onto inside".split())
_PARTS = frozenset("shelf drawer rack hook compartment tray step stair".split())
"""Furniture that other furniture has."""
_GROUND = frozenset(("floor", "ground"))
_NO_NOUNS = frozenset(("ADJ", "ADP", "ADV", "VERB"))


def told_apart(document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments without states that only tell which thing is meant; a "whichever cup is full" is an object as a
    whole."""
    free = list(free_relatives(document, tasks))
    telling = {i: words for words in (*clauses(document), *free) for i in words}
    found = []
    for argument in arguments:
        start = argument.tokens.start
        others = [a for a in arguments if (a.owner, a.type) == (argument.owner, "state") and a is not argument]
        kind = tasks[argument.owner]
        is_asked = kind == "informing" or (kind == "check_state" and all(a.tokens.start in telling for a in others))
        if argument.type in _STATES and start in telling and not is_asked:
            stop = telling[start].stop
            if not others and _is_state(document, stop):
                found.append(replace(argument, tokens=range(stop, stop + 1)))
            continue
        whole = next((words for words in free if start in words and argument.type == "object"), argument.tokens)
        said = replace(argument, tokens=whole) if argument.owner not in whole else argument
        if whole not in (a.tokens for a in found if (a.owner, a.type) == (said.owner, said.type)):
            found.append(said)  # "whichever of the lamp and the heater is on" is one, though two were found
    return found


def _is_state(document: Document, at: int) -> bool:
    """Whether a clause is left with a word of its own that tells a state: "leave the door that is open *open*"."""
    tokens = document.tokens
    is_last = at + 1 >= len(tokens) or tokens[at + 1].lower in MARKS | {"and", "then", "but"}
    return at < len(tokens) and tokens[at].pos in _NO_NOUNS and is_last


def with_relative_places(
    observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with the place by which a clause tells which thing is moved as no place where it ends up: "put the
    cup that is *on the floor* on the table", "put whatever's *on the floor* on the table"; what stands behind that says
    where it does. A place by which a clause tells which goal is meant is part of that: "in the box, which is *on the
    shelf*"."""
    document, kept = observed.document, list(arguments)
    for thing in arguments:
        kind = tasks[thing.owner]
        if thing.type == "goal" and kind in _MOVING:
            kept = _with_place_of_goal(document, kept, thing)
        at = _place_of(document, thing) if thing.type == "object" and kind in _MOVING else 0
        own = [a for a in kept if a.owner == thing.owner and a is not thing]
        place = next((a for a in own if a.type in _PLACES and a.tokens.start == at and len(a.tokens) > 1), None)
        if not at or place is None:
            continue
        goals = [a for a in own if a.type in ("goal", "recipient") and a is not place]
        second = 0 if goals or kind == "taking" else _second_place(document, place.tokens)
        is_right_behind = at == thing.tokens.stop
        if is_right_behind and not _is_free(document, thing) and not _may_hold(observed, place.tokens, second):
            continue
        if is_right_behind and place.type == "path":
            continue  # "whatever's *in the way*"
        kept.remove(place)
        is_told = kind == "placing" and place.type != "source"
        said = replace(place, type="location" if is_told else "source")
        if second:
            kept.append(replace(place, type="goal", tokens=range(second, place.tokens.stop)))
            said = replace(said, tokens=range(place.tokens.start, second))
        elif not goals and (behind := _goal_behind(document, tasks, place.tokens.stop)):
            kept.append(FoundArgument("goal", thing.owner, behind, CERTAIN))
        kept.append(said)
    return kept


def _with_place_of_goal(
    document: Document, arguments: Sequence[FoundArgument], goal: FoundArgument
) -> list[FoundArgument]:
    """The arguments with the place of a "that is on the table" right behind a goal as part of that."""
    at = _relative_place(document, goal.tokens.stop)
    place = next((a for a in arguments if a.owner == goal.owner and a.type in _PLACES and a.tokens.start == at), None)
    if not at or place is None or goal not in arguments:
        return list(arguments)
    whole = replace(goal, tokens=range(goal.tokens.start, place.tokens.stop))
    return [whole if a is goal else a for a in arguments if a is not place]


def _place_of(document: Document, thing: FoundArgument) -> int:
    """Where the place may begin by which it is told which thing is meant: in a clause behind it, or right behind what
    is no pronoun; 0 where none may."""
    stop = thing.tokens.stop
    if at := _relative_place(document, stop):
        return at
    is_told = stop < len(document) and document.tokens[stop].lower in _WHERE
    return stop if is_told and thing.tokens.start > thing.owner and not is_pronoun(document, thing.tokens) else 0


def _is_free(document: Document, thing: FoundArgument) -> bool:
    """Whether a thing is no more than a "whatever is", which a place must go with."""
    first, last = document.tokens[thing.tokens.start], document.tokens[thing.tokens.stop - 1]
    return first.lower in WHATEVER and last.lower in BE


def _may_hold(observed: Observed, places: range, second: int) -> bool:
    """Whether of two places the first holds what is moved to the second, as it is furniture that is never in or on
    that: "put the cups *on the table* in the dishwasher", but not "on the shelf in the fridge" nor "on the desk in the
    study"."""
    tokens = observed.document.tokens
    if not second or tokens[second].lower not in _ENDING:
        return False
    one, other = tokens[second - 1].lemma, tokens[places.stop - 1].lemma
    is_piece = (observed.gazetteer.category(one) == "furniture" and one not in _PARTS) or one in _GROUND
    return is_piece and one != other and observed.gazetteer.category(other) in ("furniture", "thing")


def _goal_behind(document: Document, tasks: Collection[int], at: int) -> range:
    """Where to a thing is put, said behind the comma that ends a clause about it: ", *in the wash*"; else empty."""
    tokens = document.tokens
    start = at + 1
    while start < len(tokens) and tokens[start].lower == "back":
        start += 1
    if start + 1 >= len(tokens) or tokens[at].text != "," or tokens[start].lower not in _ENDING | {"to"}:
        return range(0)
    stop = next((chunk.stop for chunk in noun_chunks(document) if chunk.start == start + 1), 0)
    return range(start, stop) if stop and not any(i in tasks for i in range(at, stop)) else range(0)


def _relative_place(document: Document, at: int) -> int:
    """Where the place of a "that is lying on the floor" begins whose first word is at a token, or behind a comma there;
    0 where none is."""
    tokens, end = document.tokens, len(document)
    at += at < end and tokens[at].text == ","
    if at + 2 >= end or tokens[at].lower not in _RELATIVE:
        return 0
    verb = at + 1
    while verb + 1 < end and (tokens[verb].lower in _MAY or (tokens[verb].lower in _USUALLY and verb > at + 1)):
        verb += 1
    if tokens[verb].lower in BE | {"be"}:
        verb += 1
        while verb < end and tokens[verb].lower in _USUALLY:
            verb += 1
        is_told = verb < end and (tokens[verb].lemma in _POSTURES or tokens[verb].lower in _PLACED)
        place = verb + is_told
    else:
        verb += tokens[verb].lower in _USUALLY
        place = verb + 1 if tokens[verb].lemma in _POSTURES else end
    return place if place < end and (tokens[place].pos == "ADP" or tokens[place].lower in _WHERE) else 0


def _second_place(document: Document, words: range) -> int:
    """Where the last of several places begins that follow one another; 0 where there is one."""
    tokens = document.tokens
    starts = [i for i in words[2:-1] if tokens[i].lower in _WHERE and tokens[i - 1].pos in ("NOUN", "PROPN")]
    return starts[-1] if starts else 0


def without_stated(document: Document, tasks: Sequence[Task]) -> tuple[Task, ...]:
    """The tasks, none of which is to bring about what a clause before it states: "the window's *open*, close it"."""
    return tuple(
        replace(task, arguments=tuple(a for a in task.arguments if not _is_stated(document, task, a))) for task in tasks
    )


def _is_stated(document: Document, task: Task, argument: Argument) -> bool:
    if task.type == "check_state" or argument.type != "state" or argument.span is None:
        return False
    tokens, before = document.tokens, document.indices(argument.span).start - 1
    while before > 0 and tokens[before].lower in ADVERBS:
        before -= 1
    return before > 0 and argument.span.end <= task.span.start and tokens[before].lower in BE - {"be"}


def _is_whole(document: Document, argument: FoundArgument) -> bool:
    """Whether something may be left out of what is named: any object, and of places all of a kind ("in every room")."""
    is_all = not WHOLE.isdisjoint(document.tokens[i].lower for i in argument.tokens)
    return argument.type == "object" or (argument.type in _PLACES and is_all)


def without_excluded(
    document: Document, tasks: Collection[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without what is left out: that is part of the object or the place that it stands right behind
    ("everything but the landing light", "everywhere but in the hall"), and else nobody's."""
    kept = list(arguments)
    for left_out in exclusions(document, tasks):
        words = left_out.tokens
        kept = [a for a in kept if a.tokens.start not in words]
        whole = next(
            (a for a in kept if _is_whole(document, a) and a.tokens.stop in range(words.start, words.stop + 1)), None
        )
        if whole is not None and left_out.is_part:
            kept[kept.index(whole)] = replace(whole, tokens=range(whole.tokens.start, words.stop))
    return kept
