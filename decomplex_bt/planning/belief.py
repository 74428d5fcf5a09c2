"""What the robot believes of the house: fed by percepts and by the ends of its own steps, by nothing else."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.prior import UNEXPECTED, Prior
from decomplex_bt.planning.schemas import news_after, values_after

LOOKS = 2
"""Looks in a row that must agree before a thing that was not seen counts as not there: one look may miss it."""
MAX_ATTEMPTS = 4
"""Failures of one step after which it is not tried again."""
FINAL_REASONS = ("broken", "not possible", "too long to be seen")
"""Words in a step's reason of failure that make trying it again pointless."""
GONE_REASONS = ("not there any more", "have lost")
"""Words in a step's reason of failure that say that whoever it is about is not where they were."""
NEVER = -1
ROBOT = "robot"


class Belief:
    """The symbolic belief of one episode.

    `tick` counts percepts, `revision` grows when something has changed that could change a decision. `room`, `held`,
    `tray`, `near` are the last percept's. Places of things persist until a look disproves them.
    """

    def __init__(self, domain: Domain, *, prior: Prior | None = None) -> None:
        self.domain = domain
        self.prior = prior or Prior.of(domain)
        self.tick = 0
        self.revision = 0
        self.percept = Percept(room=next(iter(domain.house.robot_start)))
        self._place: dict[str, str] = {}
        self._seen: dict[str, int] = {}
        self._carried: dict[str, int] = {}
        self._misses: Counter[str] = Counter()
        self._state: dict[tuple[str, str], str] = {}
        self._state_seen: dict[tuple[str, str], int] = {}
        self._state_changed: dict[tuple[str, str], int] = {}
        self._visited: dict[str, int] = {}
        self._asked: set[str] = set()  # where somebody wanted to know whether the robot is, or was
        self._looks: Counter[str] = Counter()
        self._inspected: dict[str, int] = {}
        self._noted: dict[Atom, int] = {}
        self._attempts: Counter[GroundAction] = Counter()
        self._blocked: dict[GroundAction, str] = {}
        self._given_up: dict[tuple[Atom, ...], tuple[int, str, bool]] = {}
        self._floors = {room: domain.house.floor_of(room) for room in domain.house.rooms}
        self._is_settled = False
        self._is_doubting = False
        self._is_behind = False

    def copy(self) -> Belief:
        """A belief that goes its own way from here."""
        other = Belief(self.domain, prior=self.prior)
        for name, value in vars(self).items():
            setattr(other, name, value.copy() if isinstance(value, dict | set) else value)
        return other

    # -- what comes in ------------------------------------------------------------------------------------------------

    def update(self, percept: Percept) -> None:
        """Takes in one look at the world."""
        last = self.percept
        has_moved = percept.near is not last.near or percept.room != last.room
        is_nothing_new = self._is_settled and _shows_the_same(percept, last)
        if has_moved or not is_nothing_new:
            self._catch_up()
        self.tick += 1
        self.percept = percept
        has_moved = has_moved and (last.room != percept.room or last.near != percept.near)
        if is_nothing_new:
            # It shows what the last one did, which had left nothing open: only times go on.
            self._is_behind = True
            # A decision that never asked about the places that were come to or left is what it was.
            has_changed = last.room != percept.room or not self._asked.isdisjoint(last.near ^ percept.near)
            self.revision += has_moved and has_changed
            return
        for name in (percept.room, *percept.near):
            self._visited[name] = self.tick
        are_things_new = self._see_things(percept)
        changed = (
            are_things_new
            | self._see_states(percept.states)
            | self._see_contents(percept)
            | has_moved
            | (last.held != percept.held or last.tray != percept.tray)
            | (last.places.keys() != percept.places.keys() or self.tick == 1)
        )
        self.revision += changed
        is_looking = min(self._looks.values(), default=LOOKS) < LOOKS
        self._is_settled = not (are_things_new or self._is_doubting or is_looking)

    def _catch_up(self) -> None:
        """Notes when all was seen last that looks with nothing new have shown; put off until somebody asks."""
        if not self._is_behind:
            return
        self._is_behind = False
        percept, tick = self.percept, self.tick
        self._visited[percept.room] = tick
        self._visited.update(dict.fromkeys(percept.near, tick))
        self._seen.update((name, tick) for name in percept.places if name not in percept.unseen)
        for thing in (percept.held, *percept.tray):
            if thing is not None:
                self._seen[thing] = self._carried[thing] = tick
        self._state_seen.update(dict.fromkeys(percept.states, tick))
        self._inspected.update(dict.fromkeys(percept.inspected, tick))

    def succeeded(self, step: GroundAction) -> None:
        """Notes that a step was carried out, with those of its effects that cannot be seen afterwards."""
        self._is_settled = False
        self._attempts.pop(step, None)
        noted = {
            "say": lambda: [Atom("told", step.objects)],
            "follow": lambda: [
                Atom("followed", (step.objects[0], step.objects[-1])),
                Atom("accompanied", step.objects[:1]),
            ],
            "tag-along": lambda: [Atom("accompanied", step.objects)],
        }.get(step.name, list)()
        for atom in (*noted, *news_after(step, self.domain)):
            self._noted[atom] = self.tick
        if step.name in ("place", "give") and self._place.get(step.objects[0]) in (None, ROBOT):
            self._place[step.objects[0]] = step.objects[1]
        for key, value in values_after(step, self.domain).items():
            # What has been heated or washed lies behind a closed door: nobody sees it get hot or clean.
            if self._state.get(key) != value:
                self._state[key] = value
                self._state_changed[key] = self.tick
        self.revision += 1

    def failed(self, step: GroundAction, reason: str) -> None:
        """Notes that a step failed; tried too often, or failed for good, it is in no later plan.

        Where a person is who was not found there is not known any more. (Of a thing, looks at its place tell.)
        """
        if any(word in reason for word in GONE_REASONS):
            for person in self.domain.house.people.keys() & set(step.objects):
                self._place.pop(person, None)
        self._attempts[step] += 1
        if self._attempts[step] >= MAX_ATTEMPTS or any(word in reason for word in FINAL_REASONS):
            self._blocked[step] = reason
        self.revision += 1

    def give_up(self, goal_atoms: Iterable[Atom], reason: str, *, is_final: bool = True) -> None:
        """Notes that no plan brings this about any more; `is_final`: it is known, not only that none was found."""
        self._given_up[tuple(goal_atoms)] = (self.tick, reason, is_final)
        self.revision += 1

    # -- what is believed ---------------------------------------------------------------------------------------------

    @property
    def room(self) -> str:
        return self.percept.room

    @property
    def held(self) -> str | None:
        return self.percept.held

    @property
    def tray(self) -> tuple[str | None, ...]:
        return self.percept.tray

    @property
    def near(self) -> frozenset[str]:
        return self.percept.near

    def is_near(self, name: str | None) -> bool:
        """Whether the robot is at a place or person now; who asks is told by `revision` when that changes."""
        if name is not None:
            self._asked.add(name)
        return name in self.percept.near

    def place_of(self, name: str) -> str | None:
        """Where a thing is: a place, a person, or "robot"; a person's room; None where it is not known."""
        return self._place.get(name)

    def room_of(self, name: str) -> str | None:
        """The room of an entity, place or room; None where it is not known."""
        seen: set[str] = set()
        while name not in seen:
            seen.add(name)
            if name == ROBOT:
                return self.room
            room = self.domain.room_of(name)
            if room is not None:
                return room
            name = self._place.get(name, name)
        return None

    def state(self, name: str, pair: str) -> str | None:
        """The value of a state pair last seen; None where it was never seen."""
        return self._state.get((name, pair))

    def likely_value(self, name: str, pair: str) -> str | None:
        """The value seen, else the likelier one; None where the entity has no such state."""
        return self._state.get((name, pair)) or self.prior.values.get((name, pair))

    def seen(self, name: str) -> int:
        """The tick of the last sight of an entity, `NEVER` if there was none."""
        self._catch_up()
        return self._seen.get(name, NEVER)

    def state_seen(self, name: str, pair: str) -> int:
        """The tick at which a state was last seen, `NEVER` if it was not."""
        self._catch_up()
        return self._state_seen.get((name, pair), NEVER)

    def state_changed(self, name: str, pair: str) -> int:
        """The tick at which a state was first seen to be another than before, `NEVER` if it never was."""
        return self._state_changed.get((name, pair), NEVER)

    def visited(self, name: str) -> int:
        """The tick at which the robot was last in a room or at a position, `NEVER` if it was not."""
        self._catch_up()
        self._asked.add(name)
        return self._visited.get(name, NEVER)

    def inspected(self, place: str) -> int:
        """The tick at which the whole contents of a place were last in view, `NEVER` if they were not."""
        self._catch_up()
        return self._inspected.get(place, NEVER)

    def carried(self, thing: str) -> int:
        """The tick at which a thing was last in the hand or on the tray, `NEVER` if it was not."""
        self._catch_up()
        return self._carried.get(thing, NEVER)

    def noted(self, atom: Atom) -> int:
        """The tick at which a step brought about what cannot be seen (told, followed), `NEVER` if none did."""
        return self._noted.get(atom, NEVER)

    def likely_places(self, name: str) -> tuple[tuple[str, float], ...]:
        """Where a thing or person may be, with weights, likeliest first: where it is known to be, alone, or the prior's
        places that have not been inspected without finding it. Empty when nothing is left.

        Of what was seen and is there no longer, somebody has moved it since: looks before that sight say nothing. A
        person who was seen and has gone may be in any room.
        """
        known = self._place.get(name)
        if known is not None:
            place = self.domain.house.floor_of(known) if known in self.domain.house.rooms else known
            return ((place, 1.0),)
        seen = max(self.seen(name), 0)
        places = self.prior.places.get(name, ())
        if name in self.domain.house.people and self.seen(name) != NEVER:
            expected = {place for place, _ in places}
            places = (*places, *((floor, UNEXPECTED) for floor in self._floors.values() if floor not in expected))
        return tuple(e for e in places if self._inspected.get(e[0], NEVER) < seen)

    def blocked(self) -> Mapping[GroundAction, str]:
        """Steps that are not tried again, with the reason."""
        return self._blocked

    def given_up(self, goal_atoms: Iterable[Atom], *, since: int) -> str | None:
        """Why no plan was found for this goal at or after a tick; None if it was not given up then."""
        tick, reason, _ = self._given_up.get(tuple(goal_atoms), (NEVER, "", True))
        return reason if tick >= max(since, 0) else None

    def unanswered(self, goal_atoms: Iterable[Atom], *, since: int) -> str | None:
        """Why a goal was given up at or after a tick though it may be possible: no part of it is known not to be.

        None where it was not given up then, or for a reason that is final.
        """
        goal = tuple(goal_atoms)
        reason = self.given_up(goal, since=since)
        if reason is None:
            return None
        parts = (part for part, (tick, _, is_final) in self._given_up.items() if is_final and tick >= max(since, 0))
        return None if any(set(part) <= set(goal) for part in parts) else reason

    def last_reason(self, names: Iterable[str]) -> str | None:
        """What went wrong last for good with a step about one of these; None if nothing did."""
        wanted = frozenset(names)
        found = [f"{step}: {reason}" for step, reason in self._blocked.items() if wanted & set(step.objects)]
        return found[-1] if found else None

    def __str__(self) -> str:
        self._catch_up()
        rows = [f"robot in {self.room}, holding {self.held or 'nothing'}, tray {[t for t in self.tray if t]}"]
        house = self.domain.house
        for name in (*house.places(), *house.things, *house.people):
            states = [value for (entity, _), value in sorted(self._state.items()) if entity == name]
            where = self._place.get(name)
            if where is None and name in self.prior.places:
                guesses = self.likely_places(name)[:3]
                where = "? " + ", ".join(f"{place} {weight:.2f}" for place, weight in guesses) if guesses else "nowhere"
            inspected = f"inspected at {self._inspected[name]}" if name in self._inspected else ""
            if where or states or inspected:
                rows.append(f"{name:22} {where or '':44} {' '.join(states):18} {inspected}".rstrip())
        return "\n".join(rows)

    # -- how a look is taken in ---------------------------------------------------------------------------------------

    def _see_things(self, percept: Percept) -> bool:
        changed = False
        tick, known = self.tick, self._place
        for name, place in percept.places.items():
            if known.get(name) != place:
                known[name] = place
                changed = True
            if name not in percept.unseen:
                self._seen[name] = tick
            self._misses.pop(name, None)
        for thing in (percept.held, *percept.tray):
            if thing is not None:
                changed |= known.get(thing) != ROBOT
                known[thing] = ROBOT
                self._seen[thing] = self._carried[thing] = tick
        return changed

    def _see_states(self, states: Mapping[tuple[str, str], str]) -> bool:
        changed = False
        tick, known, seen = self.tick, self._state, self._state_seen
        for key, value in states.items():
            before = known.get(key)
            changed |= before != value or seen.get(key, NEVER) != tick - 1
            if before is not None and before != value:
                self._state_changed[key] = tick
            known[key] = value
            seen[key] = tick
        return changed

    def _see_contents(self, percept: Percept) -> bool:
        """Counts looks into places; enough of them make a place inspected and disprove what should have been there."""
        changed = False
        for place in [place for place in self._looks if place not in percept.inspected]:
            del self._looks[place]
        for place in sorted(percept.inspected):
            self._looks[place] += 1
            if self._looks[place] >= LOOKS:
                changed |= self._looks[place] == LOOKS
                self._inspected[place] = self.tick
        carried = (percept.held, *percept.tray)
        missed = [
            (name, place == ROBOT)
            for name, place in self._place.items()
            if name not in percept.places
            and (name not in carried if place == ROBOT else self._floors.get(place, place) in percept.inspected)
        ]
        self._is_doubting = False
        for name, was_carried in missed:
            self._misses[name] += 1
            if was_carried or self._misses[name] >= LOOKS:
                del self._place[name]
                changed = True
            else:
                self._is_doubting = True
        return changed


def _shows_the_same(percept: Percept, last: Percept) -> bool:
    """Whether a look shows just what the last one did, wherever the robot is; bodies hand the same mappings out where
    nothing has changed."""
    return (
        percept.places is last.places
        and percept.states is last.states
        and percept.inspected is last.inspected
        and percept.unseen is last.unseen
        and percept.held == last.held
        and percept.tray == last.tray
    )
