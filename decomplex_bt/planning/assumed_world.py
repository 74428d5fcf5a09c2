"""A symbolic world as it is assumed to be: it carries steps out at once and gives percepts, without a simulator."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import InputError
from decomplex_bt.planning.abilities import holds_things
from decomplex_bt.planning.belief import LOOKS, ROBOT, Belief
from decomplex_bt.planning.ground_task import GroundTask
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.plan_check import checked
from decomplex_bt.planning.planner import Planner
from decomplex_bt.planning.prior import Prior
from decomplex_bt.planning.problem import belief_problem
from decomplex_bt.planning.pursuit import Bindings, Pursuit, PursuitStatus, pursue
from decomplex_bt.planning.schemas import values_after

MAX_PLANS = 300
"""Plans for one task after which something is wrong with the planner or the domain."""
_LOOKING = ("inspect", "sense", "sense-place", "sense-held", "sense-given")


@dataclass
class AssumedWorld:
    """The world as it is assumed. `places`: thing to place, person to room; who is missing is nowhere in the house.

    `values`: (entity, state pair) to value; what is not given is as it usually is. `broken` devices do not switch on,
    `slippery` things slip from the hand, `refused` names actions that are not possible here.
    `supposed`: the things and people whose place, and the keys of `values` whose value, is but the usual one: nothing
    has told it or brought it about. The robot sees what is in its room, but for the insides of closed containers.
    """

    domain: Domain
    room: str
    places: dict[str, str]
    values: dict[tuple[str, str], str] = field(default_factory=dict)
    broken: frozenset[str] = frozenset()
    slippery: frozenset[str] = frozenset()
    refused: frozenset[str] = frozenset()
    at: str = ""
    held: str | None = None
    tray: list[str | None] = field(default_factory=lambda: [None] * 4)
    steps: list[GroundAction] = field(default_factory=list)
    supposed: set[str | tuple[str, str]] = field(default_factory=set)

    @classmethod
    def likely(cls, domain: Domain) -> AssumedWorld:
        """The world as it is most often: things at their likeliest places, everybody who tends to be at home there."""
        house, prior = domain.house, Prior.of(domain)
        places = {name: prior.places[name][0][0] for name in house.things if prior.places[name]}
        for name, person in house.people.items():
            if name == house.user or person.home >= 0.5:
                places[name] = max(person.rooms, key=lambda room: person.rooms[room])
        room = max(house.robot_start, key=lambda room: house.robot_start[room])
        return cls(domain, room, places, supposed=set(places))

    def copy(self) -> AssumedWorld:
        """A world that goes its own way from here."""
        return replace(
            self,
            places=dict(self.places),
            values=dict(self.values),
            tray=list(self.tray),
            steps=list(self.steps),
            supposed=set(self.supposed),
        )

    def __post_init__(self) -> None:
        usual = Prior.of(self.domain).values
        self.supposed |= usual.keys() - self.values.keys()
        self.values = {**usual, **self.values}
        self.at = self.at or self.domain.house.floor_of(self.room)

    def settle(self, name: str, pair: str, value: str) -> None:
        """Has a state be so, which from then on is more than supposed."""
        self.values[name, pair] = value
        self.supposed.discard((name, pair))

    def settle_place(self, name: str, place: str | None) -> None:
        """Has a thing or a person be at a place, or nowhere in the house (None), which is more than supposed then."""
        if place is None:
            self.places.pop(name, None)
        else:
            self.places[name] = place
        self.supposed.discard(name)

    def percept(self) -> Percept:
        """What the robot sees now."""
        house = self.domain.house
        seen = {name: place for name, place in self.places.items() if self._is_seen(place)}
        seen[house.user] = self.places[house.user]
        visible = [*seen, *(place for place in house.places() if self._room(place) == self.room)]
        doors = [name for name in house.doorways if self.room in house.doorways[name].rooms]
        states = {key: value for key, value in self.values.items() if key[0] in visible or key[0] in doors}
        inspected = frozenset(
            place
            for place in (self.at, house.floor_of(self.room))
            if holds_things(place, self.domain) and self._is_open(place)
        )
        return Percept(
            self.room,
            self.held,
            tuple(self.tray),
            seen,
            states,
            inspected,
            frozenset((self.at,)),
            seconds=float(len(self.steps)),
        )

    def apply(self, step: GroundAction) -> str:
        """Carries a step out; "ok", or why it did nothing."""
        reason = self._problem(step)
        if reason != "ok":
            return reason
        name, objects = step.name, step.objects
        if name == "move":  # from where it is; a plan begins at the floor of the room wherever it may be
            step = GroundAction(name, (self.at, *objects[1:]))
        if step.objects[:1] != objects[1:2]:  # else it is there already
            self.steps.append(step)
        if name == "move":
            self.at = objects[1]
        elif name == "pass":
            self.room = objects[2]
        elif name == "follow":
            self.room, self.at = objects[2], objects[0]
            self.settle_place(objects[0], objects[2])
        elif name in ("pick", "receive"):
            self.held = objects[0]
            self.settle_place(objects[0], ROBOT)
        elif name in ("place", "give"):
            self.held = None
            self.settle_place(*objects[:2])
        elif name in ("stow", "unstow"):
            slot = int(objects[1].rpartition("_")[2]) - 1
            self.tray[slot], self.held = (objects[0], None) if name == "stow" else (None, objects[0])
        for (entity, pair), value in values_after(step, self.domain).items():
            self.settle(entity, pair, value)
        return "ok"

    def run(
        self, task: GroundTask, belief: Belief, planner: Planner, bindings: Bindings, *, up_to_looks: bool = False
    ) -> Pursuit:
        """Pursues a task to its end as a leaf of a tree would, one step at a time.

        `up_to_looks`: a plan is carried out up to the look it ends in, though the answer came into view on the way.
        Raises `InputError` where plans bring nothing about: by actions that are not simulated here.
        """
        for _ in range(LOOKS):
            belief.update(self.percept())
        since = belief.tick
        for _ in range(MAX_PLANS):
            pursuit = pursue(task, belief, bindings, since=since)
            bindings = pursuit.bindings
            if pursuit.status is not PursuitStatus.ONGOING:
                return pursuit
            problem = belief_problem(belief, pursuit.goal_atoms, forbidden=task.forbidden)
            result = checked(planner.solve(problem), problem, self.domain)
            if not result.steps:
                reason = "it holds, and the task is not done" if result.is_solved else str(result)
                belief.give_up(pursuit.goal_atoms, reason, is_final=result.status.is_final)
                continue
            self._carry_out(result.steps, task, belief, bindings, since, pursuit, up_to_looks=up_to_looks)
        due = " ".join(map(str, pursuit.goal_atoms))
        raise InputError(
            f"{task.phrase!r} is not done after {MAX_PLANS} plans, the last of them for {due}; "
            "does the domain have an action that the robot has no skill for?"
        )

    def _carry_out(
        self,
        steps: tuple[GroundAction, ...],
        task: GroundTask,
        belief: Belief,
        bindings: Bindings,
        since: int,
        pursuit: Pursuit,
        *,
        up_to_looks: bool,
    ) -> None:
        """Carries a plan out until it fails or another goal is due; a look that is next in the plan is still taken."""
        for index, step in enumerate(steps, start=1):
            outcome = self.apply(step)
            for _ in range(LOOKS):
                belief.update(self.percept())
            if outcome != "ok":
                belief.failed(step, outcome)
                return
            belief.succeeded(step)
            ahead = steps[index:] if up_to_looks else steps[index : index + 1]
            looks = any(following.name in _LOOKING for following in ahead)
            if not looks and pursue(task, belief, bindings, since=since).goal_atoms != pursuit.goal_atoms:
                return

    def _problem(self, step: GroundAction) -> str:
        name, objects = step.name, step.objects
        if name in self.refused:
            return "not possible"
        if name == "pick" and objects[0] in self.slippery:
            return "slipped"
        if name in ("switch-on", "heat", "wash") and objects[-1] in self.broken:
            return "broken"
        if name == "switch-on" and self.values.get((objects[0], "aperture")) == "open":
            return "open"
        if name in ("pick", "place") and not self._is_open(objects[1]):
            return "closed"
        if name == "pick" and self.places.get(objects[0]) != objects[1]:
            return "not there"
        if name == "pass" and not self._is_open(objects[0]):
            return "closed"
        return "ok"

    def _is_open(self, place: str) -> bool:
        return self.values.get((place, "aperture"), "open") == "open"

    def _is_seen(self, place: str) -> bool:
        return place == ROBOT or (self._room(place) == self.room and (place in self.places or self._is_open(place)))

    def _room(self, place: str) -> str | None:
        house: Mapping[str, object] = self.domain.house.people
        return self.places.get(place) if place in house else self.domain.room_of(place)
