"""The balance: mixes a start towards an instruction, so that all outcomes of what it tests come up.

What a flow tests is handed over as plain values (`Test`), each a question whose answer the start of the episode holds.
Everything that no test names stays as it was drawn.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import prod

import numpy as np
from numpy.random import Generator

from decomplex_bt.envs.chance import POWER, Draw, choose
from decomplex_bt.envs.geometry import Floats
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.prior import ABSENT
from decomplex_bt.errors import InputError

LEAF_SHARE = 2 / 3
"""Each leaf of a chain of searches has at least this share of the balance: 0.2 for the default of 0.3."""


@dataclass(frozen=True, slots=True)
class StateTest:
    """Whether the entities have this value of a state pair ("temperature", "hot"); those of one test agree."""

    entities: tuple[str, ...]
    pair: str
    value: str


@dataclass(frozen=True, slots=True)
class PlaceTest:
    """Where the first of the things turns up that a chain of searches would find.

    `stages`: the places looked at, one tuple for each search; the leaves are "found at the first", "at the second", ...
    and "at none of them". A single empty stage asks whether any of the things is in the house at all. `where`: state
    pairs and values that what is found must have ("a dirty mug on the desk"). `is_said_there`: whether something is
    said to be there, and what is asked is how it is ("the mug on the desk is dirty"): all that is there agrees in it,
    and every other time that it is not so something is there.
    """

    things: tuple[str, ...]
    stages: tuple[tuple[str, ...], ...]
    where: tuple[tuple[str, str], ...] = ()
    is_said_there: bool = False


@dataclass(frozen=True, slots=True)
class PersonTest:
    """Whether any of the people is at home, or, with `rooms`, in one of these rooms."""

    people: tuple[str, ...]
    rooms: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class WorksTest:
    """Whether the devices work; those of one test agree."""

    devices: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Whereabouts:
    """That any of the people is in one of these rooms, which is said and no question."""

    people: tuple[str, ...]
    rooms: tuple[str, ...]


Test = StateTest | PlaceTest | PersonTest | WorksTest | Whereabouts


def mix(draw: Draw, tests: Sequence[Test], balance: float, rng: Generator) -> None:
    """Mixes a start towards the tests, in order; who is settled by one test is left alone by later ones.

    `balance`: each answer of a test has at least this probability, in [0, 0.5]; 0 leaves the prior as it is. What
    cannot be mixed, for being impossible in this house, is noted in the start's `exempt`.
    """
    if not 0 <= balance <= 0.5:
        raise InputError(f"balance is {balance!r}; expected a probability in [0, 0.5]")
    if balance == 0:
        return
    settled = Settled()
    for test in tests:
        if isinstance(test, StateTest):
            _mix_states(draw, test, balance, rng, settled)
        elif isinstance(test, PlaceTest):
            _mix_places(draw, test, balance * LEAF_SHARE if len(test.stages) > 1 else balance, rng, settled)
        elif isinstance(test, PersonTest):
            _mix_people(draw, test, balance, rng, settled)
        elif isinstance(test, Whereabouts):
            _stand_there(draw, test, rng, settled)
        else:
            _mix_works(draw, test, balance, rng, settled)


def at_least(shares: Floats, least: float) -> Floats:
    """Probabilities with none below `least` (or below an equal share), the others scaled down in proportion."""
    least = min(least, 1 / len(shares))
    mixed, low = np.array(shares, dtype=float), np.zeros(len(shares), dtype=bool)
    while (mixed[~low] < least - 1e-12).any():
        low |= mixed < least
        rest = shares[~low].sum()
        mixed = np.where(low, least, shares * (1 - least * low.sum()) / rest if rest > 0 else least)
    return mixed / mixed.sum()


class Settled:
    """Who is settled by earlier tests, by name and aspect, and how likely it was that devices came out as they did.

    What is broken is off, so that whether a device is on and whether it works cannot be drawn apart: where one is
    settled, the other is drawn by what that leaves.
    """

    def __init__(self) -> None:
        self._answers: dict[tuple[str, str], _Answer | None] = {}

    def __contains__(self, aspect: tuple[str, str]) -> bool:
        return aspect in self._answers

    def add(self, aspect: tuple[str, str]) -> None:
        self._answers.setdefault(aspect, None)

    def note(self, names: Sequence[str], aspect: str, share: float) -> None:
        """Takes down with what probability an aspect of these was to come out true, at one draw for all."""
        self._answers.update(dict.fromkeys(((name, aspect) for name in names), _Answer(share)))

    def likelihood(self, names: Sequence[str], aspect: str, *, is_true: bool) -> float:
        """The probability that an aspect of all of these that are settled in it came out so; 1 where none is."""
        found = dict.fromkeys(self._answers.get((name, aspect)) for name in names)
        return float(prod(answer.share if is_true else 1 - answer.share for answer in found if answer is not None))


@dataclass(frozen=True, slots=True, eq=False)
class _Answer:
    """One draw that settled something: the probability that it came out true."""

    share: float


def _mix_states(draw: Draw, test: StateTest, balance: float, rng: Generator, settled: Settled) -> None:
    column = STATE_PAIRS.index(test.pair)
    is_positive = draw.geometry.kinds.state_pairs[test.pair].values[0] == test.value
    rows = _rows(draw, test.entities, settled, test.pair, lambda row: bool(draw.prior.has_state[row, column]))
    if not rows:
        return
    chances = draw.prior.chance[rows, column]
    chance = float(chances[0] if len(rows) == 1 else chances.mean())
    share = _within(chance if is_positive else 1 - chance, balance)
    if column == POWER:
        on = _share_on(draw, rows, share if is_positive else 1 - share, balance, settled)
        share = on if is_positive else 1 - on
    holds = bool(rng.random() < share)
    draw.start.states[rows, column] = int(holds == is_positive)
    if column == POWER and draw.start.states[rows[0], POWER] == 1:  # and so are all of them
        draw.start.broken[rows] = False


def _mix_works(draw: Draw, test: WorksTest, balance: float, rng: Generator, settled: Settled) -> None:
    rows = _rows(draw, test.devices, settled, "works", lambda row: bool(draw.prior.has_state[row, POWER]))
    if not rows:
        return
    share = _within(1 - float(draw.prior.broken[rows].mean()), balance)
    works = bool(rng.random() < _share_working(draw, rows, share, balance, settled))
    draw.start.broken[rows] = not works
    if not works:
        draw.start.states[rows, POWER] = 0


def _share_on(draw: Draw, rows: Sequence[int], share: float, balance: float, settled: Settled) -> float:
    """The probability with which devices are to be on now, so that they are in this share of all worlds: in those in
    which an earlier test has one of them broken they cannot, and are so much the more often in the others."""
    names = [draw.geometry.names[row] for row in rows]
    work = settled.likelihood(names, "works", is_true=True)
    settled.note(names, "power", min(share, work))
    if work < min(share, balance):
        draw.start.exempt.append(f"{', '.join(names)}: on in {work:.0%} at most, for what is broken is off")
    is_one_broken = any((name, "works") in settled and draw.start.broken[draw.geometry.row[name]] for name in names)
    return 0.0 if is_one_broken else min(share / work, 1.0)


def _share_working(draw: Draw, rows: Sequence[int], share: float, balance: float, settled: Settled) -> float:
    """The probability with which devices are to work now, so that they do in this share of all worlds: where an earlier
    test has one of them on they all do, and are so much the more often broken where it has not."""
    names = [draw.geometry.names[row] for row in rows]
    off = settled.likelihood(names, "power", is_true=False)
    broken = min(1 - share, off)
    settled.note(names, "works", 1 - broken)
    if off < min(1 - share, balance):
        draw.start.exempt.append(f"{', '.join(names)}: broken in {off:.0%} at most, for what is on works")
    states = draw.start.states
    is_one_on = any((name, "power") in settled and states[draw.geometry.row[name], POWER] == 1 for name in names)
    return 1.0 if is_one_on else 1 - broken / off


def _mix_people(draw: Draw, test: PersonTest, balance: float, rng: Generator, settled: Settled) -> None:
    geometry, prior = draw.geometry, draw.prior
    first = geometry.people_rows[0]
    wanted = [geometry.room_index[room] for room in test.rooms] or list(range(len(geometry.rooms)))

    def can_vary(row: int) -> bool:
        return prior.home[row - first] > 0 and (row != geometry.user_row or bool(test.rooms))

    rows = _rows(draw, test.people, settled, "person", can_vary)
    if not rows:
        return
    inside = {row: float(prior.home[row - first] * prior.rooms[row - first, wanted].sum()) for row in rows}
    holds = _holds(1 - prod(1 - p for p in inside.values()), balance, rng)
    present = [row for row in rows if draw.start.home[row] and _room(draw, row) in wanted]
    if holds and not present:
        row = rows[choose(np.full(len(rows), 1 / len(rows)), rng)]
        draw.stand(row, _pick_room(prior.rooms[row - first], wanted, rng), rng)
    elif not holds:
        others = [room for room in range(len(geometry.rooms)) if room not in wanted]
        for row in present:
            stays = row == geometry.user_row or (bool(others) and rng.random() < prior.home[row - first])
            draw.stand(row, _pick_room(prior.rooms[row - first], others, rng) if stays else None, rng)


def _stand_there(draw: Draw, test: Whereabouts, rng: Generator, settled: Settled) -> None:
    """Stands somebody where they are said to be; who an earlier test has put out of the house stays out."""
    geometry = draw.geometry
    rooms = [geometry.room_index[room] for room in test.rooms]
    rows = [geometry.row[name] for name in test.people]
    if any(draw.start.home[row] and _room(draw, row) in rooms for row in rows):
        return
    free = [row for row in rows if draw.start.home[row] or (geometry.names[row], "person") not in settled]
    if free:
        row = free[choose(np.full(len(free), 1 / len(free)), rng)]
        draw.stand(row, _pick_room(draw.prior.rooms[row - geometry.people_rows[0]], rooms, rng), rng)


def _mix_places(draw: Draw, test: PlaceTest, least: float, rng: Generator, settled: Settled) -> None:
    geometry = draw.geometry
    things = _rows(draw, test.things, settled, "place", lambda row: row in geometry.thing_rows)
    if not things:
        return
    traits = Traits(draw, things, test.where, settled)
    stages = [_holding(draw, stage) for stage in test.stages]
    is_possible = np.array([*(bool(stage) for stage in stages), True])
    shares = at_least(_leaf_shares(draw, things, stages, traits)[is_possible], least)
    leaf = int(np.flatnonzero(is_possible)[choose(shares, rng)])
    for stage, places in zip(test.stages, stages, strict=True):
        if not places:
            draw.start.exempt.append(f"nothing lies at {', '.join(stage)}")
    forbidden = sorted({place for stage in stages[: leaf if leaf < len(stages) else None] for place in stage})
    wanted = [place for place in stages[leaf] if place not in forbidden] if leaf < len(stages) else []

    def lies_at(places: Sequence[int]) -> list[int]:
        return [thing for thing in things if int(draw.start.place[thing]) in places]

    def bring_one(places: Sequence[int], is_able: Callable[[int], bool]) -> int | None:
        there = lies_at(places)
        order = sorted(map(int, rng.permutation(things)), key=lambda thing: thing not in there)
        able = filter(is_able, order)
        return next((thing for thing in able if thing in there or _move_in(draw, thing, places, rng)), None)

    if test.is_said_there and not wanted and forbidden and rng.random() < 0.5:
        bring_one(forbidden, traits.can_be_lacked)
        for thing in filter(traits.can_be_lacked, lies_at(forbidden)):
            traits.take(thing)
    for thing in lies_at(forbidden):
        if traits.are_had(thing) and not _spoil(draw, thing, forbidden, traits, rng):
            _move_out(draw, thing, forbidden, rng)
    if wanted and not any(map(traits.are_had, lies_at(wanted))):
        found = bring_one(wanted, traits.can_be_had)
        if found is None:
            draw.start.exempt.append(f"no room for {', '.join(test.things)} at {', '.join(test.stages[leaf])}")
        else:
            traits.give(found)
    if test.is_said_there:
        for thing in filter(traits.can_be_had, lies_at(wanted)):
            traits.give(thing)


class Traits:
    """The states that what a test asks for must have, of things by row; what an earlier test has settled stays."""

    def __init__(self, draw: Draw, things: Sequence[int], where: Sequence[tuple[str, str]], settled: Settled) -> None:
        self._draw = draw
        self._values: dict[int, dict[int, int]] = {thing: {} for thing in things}
        self._free: dict[int, list[int]] = {thing: [] for thing in things}
        for pair, value in where:
            column = STATE_PAIRS.index(pair)
            wanted = int(draw.geometry.kinds.state_pairs[pair].values[0] == value)
            for thing in (thing for thing in things if draw.prior.has_state[thing, column]):
                self._values[thing][column] = wanted
                name = draw.geometry.names[thing]
                if (name, pair) in settled:
                    draw.start.exempt.append(f"{name}: its {pair} is settled by an earlier test")
                else:
                    settled.add((name, pair))
                    self._free[thing].append(column)

    def chance(self, thing: int) -> float:
        """The probability that a thing has them."""
        values, free = self._values[thing], self._free[thing]
        is_settled_so = all(self._has(thing, column) for column in values if column not in free)
        chances = [self._draw.prior.chance[thing, column] for column in free]
        so = [chance if values[column] == 1 else 1 - chance for column, chance in zip(free, chances, strict=True)]
        return float(np.prod(so)) * is_settled_so

    def are_had(self, thing: int) -> bool:
        return all(self._has(thing, column) for column in self._values[thing])

    def can_be_had(self, thing: int) -> bool:
        return all(column in self._free[thing] or self._has(thing, column) for column in self._values[thing])

    def can_be_lacked(self, thing: int) -> bool:
        return bool(self._free[thing])

    def give(self, thing: int) -> None:
        for column in self._free[thing]:
            self._draw.start.states[thing, column] = self._values[thing][column]

    def take(self, thing: int) -> None:
        """Lets a thing lack one of them."""
        column = self._free[thing][0]
        self._draw.start.states[thing, column] = 1 - self._values[thing][column]

    def _has(self, thing: int, column: int) -> bool:
        return int(self._draw.start.states[thing, column]) == self._values[thing][column]


def _leaf_shares(draw: Draw, things: Sequence[int], stages: Sequence[Sequence[int]], traits: Traits) -> Floats:
    """The prior probability of each leaf of a chain of searches: found at stage 0, 1, ..., at none."""
    none_yet, shares, seen = 1.0, [], set[int]()
    for stage in stages:
        seen |= set(stage)
        at = sorted(seen)
        none_now = float(np.prod([1 - draw.prior.mass(thing, at) * traits.chance(thing) for thing in things]))
        shares.append(none_yet - none_now)
        none_yet = none_now
    return np.array([*shares, none_yet]).clip(min=0)


def _spoil(draw: Draw, thing: int, forbidden: Sequence[int], traits: Traits, rng: Generator) -> bool:
    """Lets a thing lie where it lies, but not as it is asked for, as often as that is how it is not found; False, and
    nothing changed, where it is to lie elsewhere."""
    if not traits.can_be_lacked(thing):
        return False
    here, chance = draw.prior.mass(thing, forbidden), traits.chance(thing)
    stays, leaves = here * (1 - chance), 1 - here
    if rng.random() * (stays + leaves) >= stays:
        return False
    traits.take(thing)
    return True


def _move_out(draw: Draw, thing: int, forbidden: Sequence[int], rng: Generator) -> None:
    """Lays a thing elsewhere, by its prior; nowhere in the house if there is no elsewhere."""
    rows, weights = draw.prior.places(thing)
    weights = weights.copy()
    weights[forbidden] = 0
    while weights.sum() > 0:
        column = choose(weights / weights.sum(), rng)
        if draw.lay(thing, int(rows[column]), rng):
            return
        weights[column] = 0
    draw.lay(thing, ABSENT, rng)


def _move_in(draw: Draw, thing: int, wanted: Sequence[int], rng: Generator) -> bool:
    """Lays a thing at one of the wanted places, by its prior, or at any of them where the prior has none."""
    rows, weights = draw.prior.places(thing)
    preferred, fallback = np.zeros_like(weights), np.zeros_like(weights)
    preferred[wanted], fallback[wanted] = weights[wanted], 1
    for weights in (preferred, fallback):
        while weights.sum() > 0:
            column = choose(weights / weights.sum(), rng)
            if draw.lay(thing, int(rows[column]), rng):
                return True
            weights[column] = 0
    return False


def _holding(draw: Draw, stage: Sequence[str]) -> list[int]:
    """The places (rows) of a stage on or in which things can lie; all of the house for an empty stage."""
    geometry = draw.geometry
    rows = [geometry.row[place] for place in stage] if stage else range(geometry.place_count)
    return [row for row in rows if row < geometry.place_count and draw.prior.holds[row]]


def _rows(
    draw: Draw, names: Sequence[str], settled: Settled, aspect: str, can_vary: Callable[[int], bool]
) -> list[int]:
    """The rows a test may change, in order; notes the others as exempt and these as settled."""
    rows = []
    for name in names:
        row = draw.geometry.row[name]
        if (name, aspect) in settled:
            draw.start.exempt.append(f"{name}: its {aspect} is settled by an earlier test")
        elif not can_vary(row):
            draw.start.exempt.append(f"{name}: its {aspect} cannot vary")
        else:
            settled.add((name, aspect))
            rows.append(row)
    return rows


def _holds(prior: float, balance: float, rng: Generator) -> bool:
    return bool(rng.random() < _within(prior, balance))


def _within(prior: float, balance: float) -> float:
    """The probability nearest to the prior that leaves either answer the balance."""
    return min(max(prior, balance), 1 - balance)


def _room(draw: Draw, person: int) -> int:
    x, y = draw.start.position[person].tolist()
    return draw.geometry.room_at(x, y)


def _pick_room(weights: Floats, rooms: Sequence[int], rng: Generator) -> int:
    """One of these rooms by weight, by equal weights where none has any."""
    shares = weights[list(rooms)]
    shares = shares if shares.sum() > 0 else np.ones(len(rooms))
    return rooms[choose(shares / shares.sum(), rng)]
