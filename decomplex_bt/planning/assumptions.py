"""What a branch of a conditional plan assumes of the world: that a condition holds or not, that an order is due."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from decomplex_bt.planning.abilities import is_fixed
from decomplex_bt.planning.assumed_world import AssumedWorld
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.ground_task import HERE, GroundTask, Referent
from decomplex_bt.planning.whereabouts import places_of


def assume(world: AssumedWorld, belief: Belief, task: GroundTask, *, holds: bool) -> None:
    """Makes a condition true or false in an assumed world, as far as that is possible."""
    if task.type == "searching" or task.state == HERE or task.is_only_there:
        for referent in task.objects:
            _assume_presence(world, belief, task, referent, holds != task.is_denied)
    elif task.type == "check_state":
        pair = world.domain.kinds.pair_of(task.state or "")
        value = task.state if holds else world.domain.kinds.opposite(task.state or "")
        for name in (name for referent in task.objects for name in referent.candidates):
            world.settle(name, pair, value or "")
        for referent in task.objects if task.places else ():
            _assume_presence(world, belief, task, referent, True)
    elif not holds:
        _assume_impossible(world, task)


def assume_due(world: AssumedWorld, belief: Belief, task: GroundTask) -> None:
    """Has an order be yet to be done, as whoever gives it takes it: what is to be closed is open, what is to be put
    somewhere is elsewhere, at the place that the order names for it, and "the dirty plates" are dirty. Only what is
    but supposed of the world, and was not seen, is changed; a task whose things are gone or broken stays as it is."""
    for referent in task.objects:
        names = _meant(world, referent)
        _assume_told(world, belief, referent, names)
        if task.type == "change_state" and not (task.seeks_change(referent) and _is_undone(world, task, referent)):
            _assume_undone(world, belief, task, names)
        elif task.type != "change_state":
            _assume_elsewhere(world, belief, task, names)


def _meant(world: AssumedWorld, referent: Referent) -> list[str]:
    """So many of what a phrase may mean as it means, the likeliest; none that is not in the house."""
    present = list(_in_house(world, referent))
    return present if referent.is_all else present[: referent.count]


def _assume_told(world: AssumedWorld, belief: Belief, referent: Referent, names: Sequence[str]) -> None:
    """Has things be as the words tell one from another by, where none of them is: "the *dirty* plates"."""
    for pair, value in referent.where:
        if not any(world.values.get((name, pair)) == value for name in referent.candidates):
            _suppose_value(world, belief, names, pair, value)


def _is_undone(world: AssumedWorld, task: GroundTask, referent: Referent) -> bool:
    """Whether one of what a phrase may mean is not as the task wants it."""
    kinds = world.domain.kinds
    pair = kinds.pair_of(task.state or "")
    return any(world.values.get((n, pair)) == kinds.opposite(task.state or "") for n in _in_house(world, referent))


def _in_house(world: AssumedWorld, referent: Referent) -> Iterator[str]:
    return (name for name in referent.candidates if name in world.places or is_fixed(name, world.domain))


def _assume_undone(world: AssumedWorld, belief: Belief, task: GroundTask, names: Sequence[str]) -> None:
    kinds = world.domain.kinds
    wanted = task.state or ""
    pair = kinds.pair_of(wanted)
    undone = [name for name in names if world.values.get((name, pair)) == wanted]
    _suppose_value(world, belief, undone, pair, kinds.opposite(wanted))


def _assume_elsewhere(world: AssumedWorld, belief: Belief, task: GroundTask, names: Sequence[str]) -> None:
    """Has what is to be moved, or who is to be followed, be at a place that the task names for it, else where it
    likeliest is but for where the task would have it."""
    house = world.domain.house
    ends = task.target.candidates if task.target is not None else ()
    for name in names:
        is_person = name in house.people
        if name not in world.supposed or name == house.user or belief.place_of(name) is not None:
            continue
        told = [where for place in task.places for where in places_of(place.candidates, belief, for_people=is_person)]
        if not told and not _is_in(world, name, ends):
            continue
        likely = (place for place, _ in belief.likely_places(name) if not _is_among(world, name, place, ends))
        places = told or list(likely)
        if places and not (told and _is_in(world, name, told)):
            place = next((place for place, _ in belief.likely_places(name) if place in places), places[0])
            world.places[name] = (world.domain.room_of(place) if is_person else place) or world.room


def _suppose_value(world: AssumedWorld, belief: Belief, names: Sequence[str], pair: str, value: str) -> None:
    """Has a state of things be another one, where it is but supposed; it stays but supposed."""
    for name in names:
        if (name, pair) in world.supposed and belief.state(name, pair) is None:
            world.values[name, pair] = value


def _assume_presence(world: AssumedWorld, belief: Belief, task: GroundTask, referent: Referent, holds: bool) -> None:
    house = world.domain.house
    if all(is_fixed(name, world.domain) for name in referent.candidates):
        return  # it is where the map has it
    is_person = referent.candidates[0] in house.people
    wheres = [where for place in task.places for where in places_of(place.candidates, belief, for_people=is_person)]
    if holds:
        name = referent.candidates[0]
        likely = [place for place, _ in belief.likely_places(name)]
        place = next((place for place in likely if place in wheres or not wheres), wheres[0] if wheres else None)
        if name not in world.places or (wheres and not any(_is_in(world, n, wheres) for n in referent.candidates)):
            world.settle_place(name, (world.domain.room_of(place or "") if is_person else place) or world.room)
        return
    for name in referent.candidates:
        if name in world.places and name != house.user and (not wheres or _is_in(world, name, wheres)):
            elsewhere = [place for place, _ in belief.prior.places.get(name, ()) if place not in wheres]
            if wheres and elsewhere:
                there = (world.domain.room_of(elsewhere[0]) if is_person else elsewhere[0]) or world.room
                world.settle_place(name, there)
            else:
                world.settle_place(name, None)


def _is_in(world: AssumedWorld, name: str, wheres: Collection[str]) -> bool:
    """Whether a thing lies at one of these places, or a person is in the room of one."""
    place = world.places.get(name)
    return place is not None and _is_among(world, name, place, wheres)


def _is_among(world: AssumedWorld, name: str, place: str, wheres: Collection[str]) -> bool:
    is_person = name in world.domain.house.people
    return place in wheres or (is_person and world.domain.room_of(place) in map(world.domain.room_of, wheres))


def _assume_impossible(world: AssumedWorld, task: GroundTask) -> None:
    """Makes an action fail: its things are gone, its people out, its devices broken."""
    names = [name for referent in task.referents() for name in referent.candidates]
    for name in names:
        if name in world.places and name != world.domain.house.user:
            world.settle_place(name, None)
    world.broken = world.broken | {name for name in names if name not in world.places}
