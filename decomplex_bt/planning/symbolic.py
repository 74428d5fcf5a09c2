"""The symbolic state that a plan starts from: what is believed, completed by what is assumed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from decomplex_bt.planning.belief import ROBOT, Belief


@dataclass(frozen=True)
class SymbolicState:
    """A belief, and what is assumed over it.

    `places` and `values` override the belief's; a place of None means nowhere. `at`: the position the robot is at, of
    those in the belief's `near` when None. Where neither says anything, a thing lies at its likeliest place.
    """

    belief: Belief
    room: str
    at: str | None = None
    held: str | None = None
    tray: tuple[str | None, ...] = ()
    places: Mapping[str, str | None] = field(default_factory=dict)
    values: Mapping[tuple[str, str], str] = field(default_factory=dict)

    @classmethod
    def of(cls, belief: Belief) -> SymbolicState:
        return cls(belief, belief.room, None, belief.held, belief.tray)

    def place_of(self, name: str) -> str | None:
        """Where a thing lies or who has it, ROBOT if carried, a person's room; assumed if need be, None if nowhere."""
        if name in self.places:
            return self.places[name]
        if name == self.held or name in self.tray:
            return ROBOT
        likely = self.belief.place_of(name)
        if likely is None:
            places = self.belief.likely_places(name)
            likely = places[0][0] if places else None
        if likely == ROBOT:
            return None
        return likely.removesuffix("_floor") if likely and name in self.belief.domain.house.people else likely

    def room_of(self, name: str) -> str | None:
        """The room of an entity, place or room; None if it is nowhere."""
        domain = self.belief.domain
        for _ in range(4):
            if name == ROBOT:
                return self.room
            room = domain.room_of(name)
            if room is not None:
                return room
            place = self.place_of(name)
            if place is None:
                return None
            name = place
        return None

    def value(self, name: str, pair: str) -> str | None:
        """The value of a state pair as assumed or seen; None where it is not known."""
        return self.values.get((name, pair)) or self.belief.state(name, pair)
