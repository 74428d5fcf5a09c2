"""What the phrases of an instruction may still mean, as its tasks are done one after the other."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.evidence import is_as_ordered, is_there
from decomplex_bt.envs.truth import Truth
from decomplex_bt.planning.ground_task import GroundTask, Referent

Bindings = Mapping[Referent, tuple[str, ...]]
"""What each phrase may still mean; all of its candidates where it is not named."""


def candidates(referent: Referent, bindings: Bindings) -> tuple[str, ...]:
    """What a referent may still mean."""
    return bindings.get(referent, referent.candidates)


def name_candidates(task: GroundTask, bindings: Bindings, domain: Domain, truth: Truth) -> Bindings:
    """The bindings when a task becomes due: phrases not met before mean what fits them now.

    That is what is in the house, is in the state by which it is told ("the clean mug") and, where all of a kind are
    meant or it is only to be taken from there, at the place that the task names; but for a search, which asks where
    they are. What fits may be nothing. Where one of several is to be changed, it is what is still to be changed.
    """
    named = dict(bindings)
    for referent in task.referents():
        is_only_there = task.is_only_there and referent in task.objects
        if referent not in bindings:
            named[referent] = tuple(
                name
                for name in _without_others(referent, bindings)
                if _is_somewhere(domain, truth, name)
                and all(truth.state(name, pair) in (value, None) for pair, value in referent.where)
            )
        is_of_place = referent.is_all and referent in task.objects and bool(task.places) and task.type != "searching"
        is_of_place |= referent in task.told_there()
        if is_only_there or (referent not in bindings and is_of_place):
            wheres = [where for place in task.places for where in candidates(place, bindings)]
            named[referent] = tuple(
                name for name in named[referent] if any(is_there(domain, truth, name, where) for where in wheres)
            )
        if referent not in bindings and task.seeks_change(referent):
            named[referent] = _to_change(task, named[referent], named, domain, truth)
    return named


def _to_change(
    task: GroundTask, names: tuple[str, ...], bindings: Bindings, domain: Domain, truth: Truth
) -> tuple[str, ...]:
    """Of what a phrase may mean, what is not as the task wants it; all of it where everything is, or what is where the
    task says."""
    wheres = [where for place in task.places for where in candidates(place, bindings)]
    there = tuple(name for name in names if any(is_there(domain, truth, name, where) for where in wheres))
    return tuple(name for name in there or names if not is_as_ordered(domain, truth, name, task.state)) or names


def given_up(task: GroundTask, bindings: Bindings) -> Bindings:
    """The bindings after a task that could not be done: what is not there may be meant elsewhere by a later one."""
    dropped = task.objects if task.is_only_there else ()
    return {referent: names for referent, names in bindings.items() if referent not in dropped}


def _without_others(referent: Referent, bindings: Bindings) -> tuple[str, ...]:
    """Its candidates for which those that it is other than leave enough of what they may still mean."""
    taken = [(bindings[other], other.count) for other in referent.others if other in bindings]
    return tuple(name for name in referent.candidates if _leaves_enough(name, taken))


def _leaves_enough(name: str, taken: list[tuple[tuple[str, ...], int]]) -> bool:
    """Whether each of these groups can still have as many as it needs, none of them in two groups."""
    if not taken:
        return True
    (names, count), *rest = taken
    left = [other for other in names if other != name]
    return any(
        _leaves_enough(name, [(tuple(n for n in group if n not in chosen), need) for group, need in rest])
        for chosen in combinations(left, min(count, len(names)))
    )


def _is_somewhere(domain: Domain, truth: Truth, name: str) -> bool:
    is_movable = name in domain.house.things or name in domain.house.people
    return not is_movable or truth.place(name) is not None


def needed(referent: Referent, among: tuple[str, ...], task: GroundTask | None = None) -> int:
    """How many candidates a referent asks for: all of these (at least one, unless the task has nothing to do then), or
    its count even where these are fewer."""
    least = 0 if task is not None and task.may_be_none(referent) else 1
    return max(least, len(among)) if referent.is_all else referent.count
