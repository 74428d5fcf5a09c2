"""Chance: how an episode begins, drawn from a generator."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from math import nan, pi

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Floats
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.prior import ABSENT, Prior
from decomplex_bt.envs.spots import PERSON_RADIUS, Disc, Point, Spots
from decomplex_bt.envs.spots import TRIES as SPOT_TRIES
from decomplex_bt.envs.stream import Source, Stream
from decomplex_bt.errors import InputError

TRIES = 12
"""Places tried before a thing is laid anywhere else, and spots before people stand in each other's way."""
NOWHERE: Point = (nan, nan)
POWER, APERTURE, TEMPERATURE = (STATE_PAIRS.index(pair) for pair in ("power", "aperture", "temperature"))


@dataclass(slots=True)
class Start:
    """How an episode begins, by row of the entity table.

    `place`: `(rows,)` row of the place a thing lies at, `ABSENT` where it is nowhere (and for places, people, robot).
    `position`: `(rows, 2)` metres, NaN where absent. `states`: `(rows, pairs)` 1, 0, or -1 where there is no such pair.
    `broken`: `(rows,)`. `home`: `(rows,)`, of people. `heading`: the robot's. `exempt`: what the balance could not mix.
    """

    place: NDArray[np.int64]
    position: Floats
    states: NDArray[np.int8]
    broken: NDArray[np.bool_]
    home: NDArray[np.bool_]
    heading: float = 0.0
    exempt: list[str] = field(default_factory=list)


class Draw:
    """One draw of a start, step by step: `everything` first, then what a balance or a caller wants otherwise."""

    def __init__(self, prior: Prior, spots: Spots) -> None:
        self.prior = prior
        self.spots = spots
        self.geometry = prior.geometry
        self.start = Start(
            place=prior.nowhere.copy(),
            position=prior.no_position.copy(),
            states=prior.no_states.copy(),
            broken=prior.none_broken.copy(),
            home=np.zeros(len(self.geometry.names), dtype=bool),
        )
        self._discs: dict[int, dict[int, Disc]] = {}
        self._people: dict[int, Disc] = {}
        self._rooms: dict[int, int] = {}

    def everything(self, rng: Stream) -> None:
        """Draws all of it from the prior, in a fixed order. Raises `InputError` where something finds no spot."""
        prior, start = self.prior, self.start
        start.broken = rng.array(len(prior.broken)) < prior.broken
        is_positive = rng.array(*prior.chance.shape) < prior.chance
        start.states = np.where(prior.has_state, is_positive.view(np.int8), prior.no_states)
        power = start.states[:, POWER]
        power[start.broken & (power >= 0)] = 0
        self._things(rng)
        self._everybody(rng)
        self._settle()

    def likeliest(self) -> None:
        """The start without chance: everything as it is most often, nothing broken, always at the same spots."""
        prior, start, rng = self.prior, self.start, without_chance()
        start.states = np.where(prior.has_state, prior.chance >= 0.5, -1).astype(np.int8)
        for row in self.geometry.thing_rows:
            rows, weights = prior.places(row)
            # Where it may lie at many places, being nowhere is likelier than each, and still not what is likely.
            weights = np.where((rows == ABSENT) & (weights < 0.5), 0.0, weights)
            by_weight = rows[np.argsort(-weights, kind="stable")].tolist()
            next(place for place in by_weight if self.lay(row, place, rng))
        for index, row in enumerate(self.geometry.people_rows):
            if prior.home[index] >= 0.5:
                self.stand(row, int(np.argmax(prior.rooms[index])), rng)
        self._settle()

    def robot(self, rng: Source | None) -> None:
        """Where the robot stands; drawn last, so that it stands clear of everything on the floor. None: no chance."""
        row = self.geometry.robot_row
        rooms = self.prior.robot_rooms
        room = int(np.argmax(rooms)) if rng is None else _pick_index(self.prior.robot_room_sums, rng)
        rng = rng or without_chance()
        spots = self.spots.robot(room, self._taken_in(room), self._company_in(room))
        self.start.position[row] = _pick(spots, rng, "the robot", self.geometry.rooms[room])
        self.start.heading = -pi + 2 * pi * rng.random()

    def lay(self, thing: int, place: int, rng: Source) -> bool:
        """Lays a thing at a place (`ABSENT`: nowhere), at a free spot; False, and nothing changed, where it is full."""
        start = self.start
        if place == ABSENT:
            self._take_up(thing)
            return True
        spot = self._free_spot(thing, place, rng)
        if spot is None:
            return False
        self._take_up(thing)
        start.place[thing], start.position[thing] = place, spot
        self._discs.setdefault(place, {})[thing] = (*spot, self.prior.radius[thing])
        return True

    def stand(self, person: int, room: int | None, rng: Source) -> None:
        """Stands a person in a room (None: out of the house), so that the robot still gets everywhere.

        Where the room is too crowded for that they stand in another. Raises `InputError` where there is no spot at all.
        """
        start = self.start
        if person in self._people:
            start.home[person] = False
            start.position[person] = np.nan
            del self._people[person], self._rooms[person]
        if room is None:
            return
        at = self._spot_in_company(room, rng)
        if at is None:
            others = (other for other in range(len(self.geometry.rooms)) if other != room)
            elsewhere = ((other, spot) for other in others if (spot := self._spot_in_company(other, rng)) is not None)
            room, at = next(elsewhere, (room, None))
        if at is None:
            spots = self.spots.standing(room, self._taken_in(room))
            at = _pick(spots, rng, self.geometry.names[person], self.geometry.rooms[room])
        start.position[person] = at
        start.home[person] = True
        self._people[person] = (*at, PERSON_RADIUS)
        self._rooms[person] = room

    def _spot_in_company(self, room: int, rng: Source) -> Point | None:
        """A spot that leaves the robot its ways through a room, past those who stand there already; None if none."""
        spots = self.spots.standing(room, self._taken_in(room))
        company = self._company_in(room)
        for _ in range(TRIES if len(spots) else 0):
            spot = spots[int(rng.random() * len(spots))]
            if not company or self.spots.leaves_way(room, [*company, spot]):
                return spot
        # in large company few spots are left: look at them all
        good = [spot for spot in spots if self.spots.leaves_way(room, [*company, spot])]
        return good[int(rng.random() * len(good))] if good else None

    def _company_in(self, room: int) -> list[Point]:
        """Where people stand in a room."""
        return [self._people[person][:2] for person, where in self._rooms.items() if where == room]

    def _taken_in(self, room: int) -> list[Disc]:
        """What takes up room on a room's floor: the people in the house, and the things that lie there."""
        return [*self._standing(), *self._lying_at(self.prior.floors[room])]

    def _things(self, rng: Stream) -> None:
        prior, discs, start, random = self.prior, self._discs, self.start, rng.random
        listed, draw_lying = self.spots.listed, self.spots.draw_lying
        things = slice(self.geometry.thing_rows.start, self.geometry.thing_rows.stop)
        first = prior.draw_places(rng.array(len(self.geometry.thing_rows)))
        places: list[int] = []
        at: list[float] = []
        for thing, radius, place in zip(self.geometry.thing_rows, prior.radius[things], first, strict=True):
            spot = NOWHERE
            tries = 0
            while place != ABSENT:
                there = discs.get(place)
                lying = there.values() if there else ()
                found: Point | None = None
                spots = listed[place, radius]
                if spots:  # the first try, of which `draw_lying` makes the others: most often there are none
                    x, y = found = spots[int(random() * len(spots))]
                    for ox, oy, other in lying:
                        across, along, gap = x - ox, y - oy, radius + other
                        if across * across + along * along < gap * gap:
                            found = draw_lying(place, radius, lying, rng, tries=SPOT_TRIES - 1)
                            break
                if found is None and tries == TRIES:
                    place, found = self._anywhere(thing, rng)
                    there = discs.get(place)
                if found is not None:
                    spot = found
                    if there is None:
                        there = discs[place] = {}
                    there[thing] = (*found, radius)
                    break
                tries += 1
                place = prior.draw_place(thing, rng.random())
            places.append(place)
            at += spot
        start.place[things], start.position[things] = places, np.array(at).reshape(-1, 2)

    def _anywhere(self, thing: int, rng: Source) -> tuple[int, tuple[float, float]]:
        """Some place with a free spot: where the places of a thing are all full, it lies elsewhere."""
        for place in np.flatnonzero(self.prior.holds).tolist():
            spot = self._free_spot(thing, place, rng)
            if spot is not None:
                return place, spot
        raise InputError(
            f"{self.geometry.names[thing]} finds no free spot in the whole house; give it more places, or fewer things"
        )

    def _everybody(self, rng: Source) -> None:
        for row, home, rooms in zip(self.geometry.people_rows, self.prior.homes, self.prior.room_sums, strict=True):
            is_home = rng.random() < home
            room = _pick_index(rooms, rng)
            self.stand(row, room if is_home else None, rng)

    def _settle(self) -> None:
        """What has stood long enough in a closed fridge is cold, in a closed oven that is on hot."""
        states, places, kinds = self.start.states, self.start.place.tolist(), self.prior.kinds
        for row in self.prior.warm_things:
            at = places[row]
            if at not in self.prior.tempering or states[at, APERTURE] != 0:
                continue
            tags = kinds[row].tags
            if any(tag in tags for tag in kinds[at].cools):
                states[row, TEMPERATURE] = 0
            elif states[at, POWER] == 1 and any(tag in tags for tag in kinds[at].heats):
                states[row, TEMPERATURE] = 1

    def _take_up(self, thing: int) -> None:
        """Takes a thing away from where it lies."""
        at = int(self.start.place[thing])
        if at != ABSENT:
            del self._discs[at][thing]
            self.start.place[thing], self.start.position[thing] = ABSENT, np.nan

    def _free_spot(self, thing: int, place: int, rng: Source) -> tuple[float, float] | None:
        discs = self._discs.get(place, {})
        taken: Collection[Disc] = discs.values()
        if thing in discs:
            taken = [disc for row, disc in discs.items() if row != thing]
        if self._people and self.spots.is_floor(place):
            taken = [*taken, *self._standing()]
        return self.spots.draw_lying(place, self.prior.radius[thing], taken, rng)

    def _lying_at(self, place: int) -> Iterable[Disc]:
        return self._discs.get(place, {}).values()

    def _standing(self) -> list[Disc]:
        """Where people stand, in order of rows."""
        return [disc for _, disc in sorted(self._people.items())]


def without_chance() -> Generator:
    """What spots are drawn from where nothing is left to chance: the same numbers every time."""
    return np.random.default_rng(0)


def choose(weights: Floats, rng: Source) -> int:
    """An index drawn by weight; the weights sum to one."""
    return _pick_index(np.cumsum(weights).tolist(), rng)


def _pick_index(sums: Sequence[float], rng: Source) -> int:
    """An index drawn by the sums of the weights up to each."""
    return bisect_right(sums, rng.random(), 0, len(sums) - 1)


def _pick(spots: Sequence[Point], rng: Source, who: str, room: str) -> Point:
    if not len(spots):
        raise InputError(f"{who} finds no free spot to stand in {room}; make the room larger or emptier")
    return spots[int(rng.random() * len(spots))]
