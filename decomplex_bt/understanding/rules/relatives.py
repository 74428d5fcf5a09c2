"""Relatives: what only tells which thing is meant, or which is not, is no state to bring about, nor an argument."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.relatives import ADVERBS, BE, clauses, exclusions, free_relatives

_MOVING = frozenset(("placing", "bringing", "taking"))
_STATES = frozenset(("state", "message", "manner"))
_PLACES = frozenset(("goal", "source", "location", "path"))
_RELATIVE = frozenset(("that", "which"))
_POSTURES = frozenset("lie stand hang sit lean rest".split())
_PLACED = frozenset("kept left stored put placed parked".split())
_WHERE = frozenset("in on at by under behind beside inside into onto near over above below next".split())
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
        found.append(replace(argument, tokens=whole) if argument.owner not in whole else argument)
    return found


def _is_state(document: Document, at: int) -> bool:
    """Whether a clause is left with a word of its own that tells a state: "leave the door that is open *open*"."""
    tokens = document.tokens
    is_last = at + 1 >= len(tokens) or tokens[at + 1].lower in MARKS | {"and", "then", "but"}
    return at < len(tokens) and tokens[at].pos in _NO_NOUNS and is_last


def with_relative_places(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with the place by which a clause tells which thing is moved as no place where it ends up: "put the
    cup that is *on the floor* on the table"; what stands behind that says where it does."""
    kept = list(arguments)
    for thing in arguments:
        kind = tasks[thing.owner]
        at = _relative_place(document, thing.tokens.stop) if thing.type == "object" and kind in _MOVING else 0
        own = [a for a in kept if a.owner == thing.owner and a is not thing]
        place = next((a for a in own if a.type in _PLACES and a.tokens.start == at and len(a.tokens) > 1), None)
        if not at or place is None:
            continue
        goals = [a for a in own if a.type in ("goal", "recipient") and a is not place]
        second = 0 if goals or kind == "taking" else _second_place(document, place.tokens)
        kept.remove(place)
        said = replace(place, type="location" if kind == "placing" else "source")
        if second:
            kept.append(replace(place, type="goal", tokens=range(second, place.tokens.stop)))
            said = replace(said, tokens=range(place.tokens.start, second))
        kept.append(said)
    return kept


def _relative_place(document: Document, at: int) -> int:
    """Where the place of a "that is lying on the floor" begins whose first word is at a token; 0 where none is."""
    tokens, end = document.tokens, len(document)
    if at + 2 >= end or tokens[at].lower not in _RELATIVE:
        return 0
    verb = at + 1
    if tokens[verb].lower in BE:
        verb += 1
        while verb < end and tokens[verb].lower in ADVERBS:
            verb += 1
        is_told = verb < end and (tokens[verb].lemma in _POSTURES or tokens[verb].lower in _PLACED)
        place = verb + is_told
    else:
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


def without_excluded(
    document: Document, tasks: Collection[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without what is left out: that is part of the object that it stands right behind ("everything but
    the landing light"), and else nobody's."""
    kept = list(arguments)
    for left_out in exclusions(document, tasks):
        words = left_out.tokens
        kept = [a for a in kept if a.tokens.start not in words]
        whole = next(
            (a for a in kept if a.type == "object" and a.tokens.stop in range(words.start, words.stop + 1)), None
        )
        if whole is not None and left_out.is_part:
            kept[kept.index(whole)] = replace(whole, tokens=range(whole.tokens.start, words.stop))
    return kept
