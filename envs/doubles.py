"""Doubles for the judge: a world kept by hand, and grounded instructions written down in short."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.envs.evidence import true_room
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.monitor import Monitor
from decomplex_bt.envs.verdict import Verdict
from decomplex_bt.envs.world import Event
from decomplex_bt.flow import Flow
from decomplex_bt.planning.ground_task import GroundInstruction, GroundTask, Referent

DOMAIN: Domain = load_domain("household")
Named = Referent | str


@dataclass
class HandWorld:
    """The truth as a test wants it. What is not said: things are nowhere, people out, states negative, nothing seen."""

    places: dict[str, str | None] = field(default_factory=dict)
    states: dict[tuple[str, str], str] = field(default_factory=dict)
    room: str = "hallway"
    near: set[str] = field(default_factory=set)
    seen: set[str] = field(default_factory=set)
    inspected: set[str] = field(default_factory=set)
    broken: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.places.setdefault("user", "living_room")

    def view(self, names: tuple[str, ...]) -> object:
        seen, inspected = self.seen & set(names), self.inspected & set(names)
        return self.room, frozenset(seen), frozenset(inspected), str(self.places), str(self.states)

    def is_near(self, name: str) -> bool:
        return name in self.near

    def place(self, name: str) -> str | None:
        return self.places.get(name)

    def state(self, name: str, pair: str) -> str | None:
        if pair not in DOMAIN.kind(name).states:
            return None
        return self.states.get((name, pair), DOMAIN.kinds.state_pairs[pair].values[1])

    def is_broken(self, name: str) -> bool:
        return name in self.broken

    def is_seen(self, name: str) -> bool:
        return name in self.seen

    def is_inspected(self, place: str) -> bool:
        return place in self.inspected


def referent(
    *candidates: str, phrase: str = "", is_all: bool = False, count: int = 1, is_any: bool = False
) -> Referent:
    return Referent(phrase or "the " + candidates[0], candidates, is_all, count, is_any=is_any)


def task(
    number: int,
    kind: str,
    *objects: Named,
    at: Iterable[Named] = (),
    goal: Named | None = None,
    recipient: Named | Iterable[Named] = (),
    state: str | None = None,
) -> GroundTask:
    """A grounded task; a plain name stands for a phrase that means this one thing, `at` are the places."""
    recipients = (recipient,) if isinstance(recipient, (Referent, str)) else recipient
    return GroundTask(
        number,
        kind,
        f"{kind} {number}",
        objects=tuple(_referent(name) for name in objects),
        places=tuple(_referent(name) for name in at),
        goal=None if goal is None else _referent(goal),
        recipients=tuple(_referent(name) for name in recipients),
        state=state,
    )


def _referent(value: Named) -> Referent:
    return referent(value) if isinstance(value, str) else value


def instruction(flow: list, *tasks: GroundTask) -> GroundInstruction:
    return GroundInstruction("", tasks, Flow.from_json(flow))


class Episode:
    """A monitor with its world; each method is a control step."""

    def __init__(self, world: HandWorld, flow: list, *tasks: GroundTask) -> None:
        self.world = world
        self.monitor = Monitor(instruction(flow, *tasks), DOMAIN, world)
        self.monitor.start()

    @property
    def verdict(self) -> Verdict:
        return self.monitor.verdict

    @property
    def truths(self) -> list[tuple[int, bool | None, str | None]]:
        return [(branch.task, branch.truth, branch.taken) for branch in self.verdict.branches]

    def step(self) -> Verdict:
        return self.monitor.update(None)

    def see(self, *names: str) -> Verdict:
        self.world.seen = set(names)
        return self.step()

    def inspect(self, *places: str) -> Verdict:
        self.world.inspected = set(places)
        return self.step()

    def go(self, room: str, *near: str) -> Verdict:
        self.world.room, self.world.near = room, set(near)
        return self.step()

    def do(
        self,
        interaction: Interaction,
        target: str,
        *,
        result: Result = Result.OK,
        thing: str | None = None,
        person: str | None = None,
        goal: str | None = None,
    ) -> Verdict:
        """An interaction with its effects on the world, as far as the judge cares."""
        world = self.world
        if result is Result.OK:
            if interaction is Interaction.PICK:
                thing = target
                world.places[target] = "robot"
            elif interaction in (Interaction.PLACE, Interaction.HAND_OVER):
                assert thing is not None
                world.places[thing] = target
            elif interaction in _STATES:
                pair, value, of_thing = _STATES[interaction]
                world.states[(thing if of_thing and thing else target, pair)] = value
        return self.monitor.update(Event(interaction, target, result, thing, person, goal))

    def take(self, thing: str) -> Verdict:
        return self.do(Interaction.PICK, thing)

    def put(self, thing: str, place: str) -> Verdict:
        return self.do(Interaction.PLACE, place, thing=thing)

    def give(self, thing: str, person: str) -> Verdict:
        return self.do(Interaction.HAND_OVER, person, thing=thing, person=person)

    def say(self, person: str) -> Verdict:
        return self.do(Interaction.SAY, person, person=person)

    def room_of(self, name: str) -> str | None:
        return true_room(DOMAIN, self.world, name)


_STATES = {
    Interaction.OPEN: ("aperture", "open", False),
    Interaction.CLOSE: ("aperture", "closed", False),
    Interaction.SWITCH_ON: ("power", "on", False),
    Interaction.SWITCH_OFF: ("power", "off", False),
    Interaction.CLEAN: ("cleanliness", "clean", True),
    Interaction.FILL: ("fill", "full", True),
    Interaction.EMPTY: ("fill", "empty", True),
}
