"""Devices: at which of them an instruction says that a thing is brought into a state ("heat it *in the oven*")."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.instruction import Task
from decomplex_bt.planning.abilities import devices_for, steps_at
from decomplex_bt.planning.ground_task import Referent
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.phrases import read_phrases
from decomplex_bt.planning.prepositions import split_preposition

_SAID = ("location", "source", "goal", "manner")
_FROM = frozenset(("from", "out of", "off", "off of", "away from", "back from"))
"""Prepositions of where a thing has been; things are filled "from the tap", too."""


def steps_elsewhere(task: Task, objects: Sequence[Referent], value: str, domain: Domain) -> tuple[GroundAction, ...]:
    """The steps that would bring things into a state at another device than the one that a task names; none where it
    names none that can."""
    named = devices_named(task, objects, value, domain)
    return tuple(
        GroundAction(step, (thing, place))
        for thing in (_things(objects, domain) if named else ())
        for place in devices_for(thing, value, domain)
        if place not in named
        for step in steps_at(place, value, domain)
    )


def devices_named(task: Task, objects: Sequence[Referent], value: str, domain: Domain) -> frozenset[str]:
    """What a task names, where each of the things can be brought into the state by some of it; else nothing."""
    away = frozenset(domain.lexicon.beside) | (frozenset() if value == "full" else _FROM)
    named = frozenset(name for kind in _SAID for words in task.values(kind) for name in _named(words, away, domain))
    things = _things(objects, domain)
    is_useful = things and not any(named.isdisjoint(devices_for(thing, value, domain)) for thing in things)
    return named if is_useful else frozenset()


def without_devices(
    places: Sequence[Referent], objects: Sequence[Referent], named: frozenset[str], domain: Domain
) -> tuple[Referent, ...]:
    """Where things are sought: not at the device that is `named`, where all of them are meant wherever they are ("wash
    the mugs in the sink"), but for "everything in the sink"."""
    are_all = any(referent.is_all and referent.phrase not in domain.lexicon.all_words for referent in objects)
    return tuple(place for place in places if not (are_all and named.issuperset(place.candidates)))


def _things(objects: Sequence[Referent], domain: Domain) -> list[str]:
    return [name for referent in objects for name in referent.candidates if name in domain.house.things]


def _named(words: str, away: frozenset[str], domain: Domain) -> list[str]:
    """What words name, unless they begin with a preposition that says where a thing is not brought."""
    preposition, place = split_preposition(words.lower().removeprefix("using "), domain)
    if preposition in away:
        return []
    try:
        phrases = read_phrases(place, domain)
    except (UnknownWordError, ImpossibleGoalError):
        return []  # "with care"
    return [name for phrase in phrases for name in phrase.entities]
