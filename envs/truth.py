"""The true world as the judge reads it: the only window between the simulator and the monitor."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import Protocol

from decomplex_bt.domain.loader import Domain

ROBOT = "robot"
"""The place of what is in the gripper or on the tray."""


class Truth(Protocol):
    """The true world of this moment, in the house's names. Nothing here is for the agent."""

    @property
    def room(self) -> str:
        """The room the robot is in."""

    def view(self, names: tuple[str, ...]) -> Hashable:
        """A value that changes when one of these comes into view, is inspected, or the opposite, when anything is
        brought into another room, the robot too, and when anything is changed."""

    def is_near(self, name: str) -> bool:
        """Whether the robot is at a place or doorway (within 1 m) or with a person (within 1.5 m), in the same room."""

    def place(self, name: str) -> str | None:
        """What a thing lies on or in, who has it, or "robot"; a person's room; None for what is not in the house."""

    def state(self, name: str, pair: str) -> str | None:
        """The value of a state pair; None where the entity has no such state."""

    def is_broken(self, name: str) -> bool:
        """Whether a device refuses to be switched on."""

    def is_seen(self, name: str) -> bool:
        """Whether the robot sees an entity now."""

    def is_inspected(self, place: str) -> bool:
        """Whether the whole contents of a place are in the robot's view now."""


class Moment:
    """The true world as it goes on, but with the places and states of some entities as they are at this moment.

    A condition is judged by it: what the robot has found is what was there, not what it has put there itself.
    """

    def __init__(self, domain: Domain, truth: Truth, names: Iterable[str]) -> None:
        house = domain.house
        self._truth = truth
        self._places: dict[str, str | None] = {}
        self._states: dict[tuple[str, str], str | None] = {}
        for name in names:
            if name in house.things or name in house.people:
                self._places[name] = truth.place(name)
            if name in house.things or name in house.places():
                self._states.update({(name, pair): truth.state(name, pair) for pair in domain.kind(name).states})

    def of(self, truth: Truth) -> Moment:
        """The same places and states, in another world that goes on."""
        other = object.__new__(Moment)
        other._truth, other._places, other._states = truth, self._places.copy(), self._states.copy()
        return other

    def take_in(self, name: str) -> None:
        """Takes in that somebody else has moved a thing, or changed how a place is."""
        if name in self._places:
            self._places[name] = self._truth.place(name)
            return
        for key in self._states:
            if key[0] == name:
                self._states[key] = self._truth.state(*key)

    @property
    def room(self) -> str:
        return self._truth.room

    def view(self, names: tuple[str, ...]) -> Hashable:
        return self._truth.view(names)

    def is_near(self, name: str) -> bool:
        return self._truth.is_near(name)

    def place(self, name: str) -> str | None:
        return self._places[name] if name in self._places else self._truth.place(name)

    def state(self, name: str, pair: str) -> str | None:
        key = (name, pair)
        return self._states[key] if key in self._states else self._truth.state(name, pair)

    def is_broken(self, name: str) -> bool:
        return self._truth.is_broken(name)

    def is_seen(self, name: str) -> bool:
        return self._truth.is_seen(name)

    def is_inspected(self, place: str) -> bool:
        return self._truth.is_inspected(place)
