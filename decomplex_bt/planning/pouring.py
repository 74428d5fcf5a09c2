"""Pouring: where things are filled with what an instruction says ("with coffee": at the coffee machine)."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.instruction import Task
from decomplex_bt.planning.ground_task import Referent
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.phrases import read_phrases
from decomplex_bt.planning.prepositions import split_preposition


def wrong_fillings(task: Task, objects: Sequence[Referent], domain: Domain) -> tuple[GroundAction, ...]:
    """The steps that would fill a task's things with something else than it says; none where it does not say.

    Raises `ImpossibleGoalError` where nothing in the house fills them with that.
    """
    for argument in task.arguments:
        preposition, words = split_preposition(argument.value, domain)
        # what "with it" refers to is told without the "with"
        if argument.type == "manner" and preposition in ("with", "") and (names := _named(words, domain)):
            return _wrong(argument.value, names, objects, domain)
    return ()


def _named(words: str, domain: Domain) -> list[str]:
    try:
        return [name for phrase in read_phrases(words, domain) for name in phrase.entities]
    except (UnknownWordError, ImpossibleGoalError):
        return []  # "with care"


def _wrong(said: str, names: Sequence[str], objects: Sequence[Referent], domain: Domain) -> tuple[GroundAction, ...]:
    house = domain.house
    wanted = {house.things[name].kind for name in names if name in house.things}
    fillers = [place for place in house.places() if domain.kind(place).fills]
    right = [place for place in fillers if place in names or wanted & set(domain.kind(place).pours)]
    for referent in objects:
        tags = {tag for name in referent.candidates for tag in domain.kind(name).tags}
        if not any(tags & set(domain.kind(place).fills) for place in right):
            known = sorted({kind for place in fillers for kind in domain.kind(place).pours})
            only = f"; what there is here to fill things with: {', '.join(known)}" if known else ""
            raise ImpossibleGoalError(f"nothing here fills {referent.phrase!r} {said!r}{only}")
    things = [name for referent in objects for name in referent.candidates]
    return tuple(GroundAction("fill", (name, place)) for name in things for place in fillers if place not in right)
