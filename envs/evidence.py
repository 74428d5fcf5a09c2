"""What the robot has seen, held and said since a task became due, beside the true world: all that a judge goes by."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.truth import ROBOT, Truth
from decomplex_bt.planning.abilities import is_fixed, runs_shut, stands_at

if TYPE_CHECKING:
    from decomplex_bt.envs.world import Event

_OK = Result.OK  # asking an enum takes ten times as long
BEFORE = -1
"""The step before the first one: nothing was seen or done yet."""


def is_as_ordered(domain: Domain, truth: Truth, name: str, value: str | None) -> bool:
    """Whether an entity is as an order for a state wants it: of what runs only behind its door, shut as well."""
    assert value is not None
    try:
        pair = domain.kinds.pair_of(value)
    except KeyError:
        return False
    is_shut = not runs_shut(name, value, domain) or truth.state(name, "aperture") == "closed"
    return truth.state(name, pair) == value and is_shut


class Record:
    """Control steps at which things were last seen, carried, looked into, or done. Only what is looked at is kept."""

    def __init__(self) -> None:
        self.step = BEFORE
        self.seen: dict[str, int] = {}
        self.carried: dict[str, int] = {}
        self.inspected: dict[str, int] = {}
        self.told: dict[str, int] = {}
        self.led: dict[str, tuple[int, str | None]] = {}
        self.visited: dict[str, int] = {}

    def copy(self) -> Record:
        other = object.__new__(Record)
        other.step = self.step
        other.seen, other.carried, other.inspected = self.seen.copy(), self.carried.copy(), self.inspected.copy()
        other.told, other.led, other.visited = self.told.copy(), self.led.copy(), self.visited.copy()
        return other

    def begin(self, event: Event | None) -> None:
        """Begins a control step, with what was done in it."""
        self.step += 1
        if event is not None and event.result is _OK and event.interaction is Interaction.SAY:
            if event.goal is not None and event.person is not None:
                self.led[event.person] = (self.step, event.goal)
            else:
                self.told[event.target] = self.step

    def look(self, truth: Truth, watched: Iterable[str]) -> None:
        """Takes down how these entities stand at the end of the step."""
        self.visited[truth.room] = self.step
        for name in watched:
            if truth.is_seen(name):
                self.seen[name] = self.step
            if truth.is_inspected(name):
                self.inspected[name] = self.step
            if truth.is_near(name):
                self.visited[name] = self.step
            place = truth.place(name)
            if place == ROBOT:
                self.carried[name] = self.step
            elif place is not None and truth.is_inspected(place):
                self.inspected[name] = self.step  # where it was then: it may be moved


class Evidence:
    """A record and the true world as seen from one task that became due at step `since`."""

    def __init__(self, domain: Domain, truth: Truth, record: Record, since: int) -> None:
        self.domain = domain
        self.truth = truth
        self.record = record
        self.since = since

    def is_there(self, name: str, where: str) -> bool:
        """Whether a thing or person truly is at a place, in a room, beside a thing (a person in its room), or with a
        person."""
        return is_there(self.domain, self.truth, name, where)

    def was_seen(self, name: str) -> bool:
        """Whether an entity was found; a room is found by being in it."""
        return self.truth.room == name if name in self.domain.house.rooms else self.was_observed(name)

    def was_observed(self, name: str) -> bool:
        """Whether an entity was in view, so that an observation told how it is; to be at it tells nothing of that."""
        return self.record.seen.get(name, BEFORE) >= max(self.since, 0)

    def was_carried(self, name: str) -> bool:
        return self.record.carried.get(name, BEFORE) >= max(self.since, 0)

    def was_visited(self, name: str) -> bool:
        return self.record.visited.get(name, BEFORE) >= max(self.since, 0)

    def was_told(self, person: str) -> bool:
        """Whether the robot spoke to a person after the task became due; what was said for another does not count."""
        return self.record.told.get(person, BEFORE) > self.since

    def led_to(self, person: str) -> str | None:
        """Where a person leads the robot, asked to since the task became due; None if not asked."""
        step, goal = self.record.led.get(person, (BEFORE, None))
        return goal if step > self.since else None

    def was_inspected(self, where: str, *, for_person: bool = False) -> bool:
        """Whether all that a place can hold came into view.

        Of a room these are all its places; a person is in a room, of which the floor is to be seen ("on the sofa": in
        the room it is in); a thing stands for where it is.
        """
        house = self.domain.house
        room = where if where in house.rooms else self.domain.room_of(where)
        if for_person and room is not None:
            return self._inspected(house.floor_of(room))
        if where in house.rooms:
            return all(self._inspected(place) for place in places_in(self.domain, where))
        if where in house.things:
            place = self.truth.place(where)
            return self._inspected(where) or (place is not None and self._inspected(place))
        if where in house.people:
            return self.was_seen(where)
        return self._inspected(where) if holds_things(self.domain, where) else self.was_seen(where)

    def _inspected(self, place: str) -> bool:
        return self.record.inspected.get(place, BEFORE) >= max(self.since, 0)


def is_there(domain: Domain, truth: Truth, name: str, where: str) -> bool:
    """Whether a thing or person truly is at a place, in a room, with a person, or beside a thing (who: in its room)."""
    house = domain.house
    if is_fixed(name, domain):
        return stands_at(name, where, domain)
    place = truth.place(name)
    if place is None:
        return False
    if name in house.people and where not in house.things and where not in house.people:
        return place == (domain.room_of(where) or where)
    if where in house.rooms:
        return true_room(domain, truth, name) == where
    if where in house.things:
        return place == (true_room(domain, truth, where) if name in house.people else truth.place(where))
    if where in house.people:
        return place == where or (name in house.people and place == truth.place(where))
    return place == where


def true_room(domain: Domain, truth: Truth, name: str) -> str | None:
    """The room an entity is in; None for what is not in the house."""
    if name == ROBOT:
        return truth.room
    if name in domain.house.rooms:
        return name
    place: str | None = name
    if name in domain.house.things or name in domain.house.people:
        place = truth.place(name)
        if place is not None and place in domain.house.people:
            place = truth.place(place)
        if place == ROBOT:
            return truth.room
    return None if place is None else domain.room_of(place)


def holds_things(domain: Domain, place: str) -> bool:
    """Whether things lie on or in a place."""
    try:
        kind = domain.kind(place)
    except KeyError:
        return False
    return kind.surface or kind.inside


def places_in(domain: Domain, room: str) -> tuple[str, ...]:
    """The places of a room on or in which things lie, its floor included."""
    places = domain.house.places()
    return tuple(place for place in places if domain.room_of(place) == room and holds_things(domain, place))
