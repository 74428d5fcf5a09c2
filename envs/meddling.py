"""Somebody else in the house: every now and then a thing that nobody holds is put to another place that suits it.

Nobody is seen doing it. Only the moment, the thing and the place are drawn, from a generator of its own, so that a
world is drawn as it would be if nobody meddled.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from numpy.random import Generator

from decomplex_bt.envs.prior import ABSENT
from decomplex_bt.envs.world import World

TRIES = 8
"""Moves drawn before nothing is moved this time."""
INTEREST = 0.5
"""Share of the moves that are of a thing that the instruction may mean: others seldom matter to it."""
Allows = Callable[[str, str], bool]
"""Whether a thing may be put to a place, by names."""


@dataclass(frozen=True, slots=True)
class Move:
    """A thing that was moved, by names."""

    thing: str
    origin: str
    place: str

    def __str__(self) -> str:
        return f"someone moves {self.thing} from {self.origin} to {self.place}"


class Meddler:
    """Moves things in one episode, on average `rate` times (> 0) in a minute of simulated time.

    `mentioned`: the things that the instruction may mean, of which every other move is one. `allows`: the judge's word
    on a move; one that would leave the instruction impossible is not made.
    """

    def __init__(self, world: World, rng: Generator, *, rate: float, mentioned: Sequence[str], allows: Allows) -> None:
        self.world, self.rng, self.allows = world, rng, allows
        self.moves = 0
        self._mentioned = tuple(world.geometry.row[name] for name in mentioned)
        self._pause = 60.0 / rate
        self._next = float(rng.exponential(self._pause))

    def act(self) -> Move | None:
        """Moves something if it is time to; call it once in every control step."""
        if self.world.seconds < self._next:
            return None
        self._next += float(self.rng.exponential(self._pause))
        move = next((move for _ in range(TRIES) if (move := self._try()) is not None), None)
        self.moves += move is not None
        return move

    def _try(self) -> Move | None:
        """One move, drawn and made; None where it is none."""
        thing = self._thing()
        place = None if thing is None else self._place(thing)
        if thing is None or place is None:
            return None
        world, names = self.world, self.world.geometry.names
        move = Move(names[thing], names[int(world.place[thing])], names[place])
        if not self.allows(move.thing, move.place):
            return None
        taken = tuple(world.discs_at(place))
        spot = world.spots.draw_lying(place, world.prior.radius[thing], taken, self.rng)
        if spot is None:
            return None
        world.shift(thing, place, spot)
        return move

    def _thing(self) -> int | None:
        of_interest = [row for row in self._mentioned if self._lies(row)]
        if not of_interest or self.rng.random() >= INTEREST:
            of_interest = [row for row in self.world.geometry.thing_rows if self._lies(row)]
        return of_interest[int(self.rng.random() * len(of_interest))] if of_interest else None

    def _lies(self, thing: int) -> bool:
        """Whether a thing is in the house, and neither the robot nor a person has it."""
        return 0 <= int(self.world.place[thing]) < self.world.geometry.place_count

    def _place(self, thing: int) -> int | None:
        """Another place where the thing may lie, as likely as at the start of an episode."""
        rows, weights = self.world.prior.places(thing)
        weights = weights * (rows != ABSENT) * (rows != self.world.place[thing])
        total = float(weights.sum())
        return int(self.rng.choice(rows, p=weights / total)) if total > 0 else None
