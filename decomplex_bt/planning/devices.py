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
    away = frozenset(domain.lexicon.beside) | (frozenset() if value == "full" else _FROM)
    named = {name for kind in _SAID for words in task.values(kind) for name in _named(words, away, domain)}
    things = [name for referent in objects for name in referent.candidates if name in domain.house.things]
    useful = {thing: devices_for(thing, value, domain) for thing in things}
    if not things or any(named.isdisjoint(devices) for devices in useful.values()):
        return ()
    return tuple(
        GroundAction(step, (thing, place))
        for thing, devices in useful.items()
        for place in devices
        if place not in named
        for step in steps_at(place, value, domain)
    )


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
