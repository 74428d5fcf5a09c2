"""Grounded tasks: an instruction's tasks with every phrase replaced by the entities of the house it may mean."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from decomplex_bt.domain.loader import Domain
from decomplex_bt.flow import Flow
from decomplex_bt.planning.abilities import devices_for
from decomplex_bt.planning.pddl import GroundAction

HERE = "here"
"""The state of a check that asks only whether something is there ("is there milk in the fridge", "is Anna home")."""

HANDLING = frozenset(("taking", "placing", "bringing", "change_state"))
"""Types of tasks that do something with their objects."""

FINDING_OUT = frozenset(("searching", "check_state"))
"""Types of tasks that come out as true or false by where and how things are."""


@dataclass(frozen=True, slots=True)
class Referent:
    """What a phrase may mean, likeliest first: names of entities (for places also rooms).

    `is_all`: all candidates are meant ("the lights", "all the cups"), those that are in the house, and where the task
    names places, those that are there ("everything on the table"); otherwise `count` different ones of them. `is_any`:
    whichever they are ("a window", "the tv or the radio"): a check of them is false only when none of them will do,
    while that of a certain one ("the mug") is settled by the first one seen. `where`: state pairs and values by which
    one is told from another ("the clean mug"). `others`: referents none of which it is ("the other mug"): what they
    have turned out to mean is none of its candidates. `near`: of floors, what the robot puts things down beside ("next
    to the front door"), though anywhere on the floor will do. Equal referents of one instruction are one and the same:
    who binds one binds all.
    """

    phrase: str
    candidates: tuple[str, ...]
    is_all: bool = False
    count: int = 1
    where: tuple[tuple[str, str], ...] = ()
    is_any: bool = False
    others: tuple[Referent, ...] = ()
    near: tuple[str, ...] = ()

    @property
    def choice(self) -> str:
        """Which of what is meant, as in "2 of cup_1 | cup_2 | cup_3 (clean)"."""
        quantity = "all of " if self.is_all else f"{self.count} of " if self.count > 1 else ""
        told_by = f" ({', '.join(value for _, value in self.where)})" if self.where else ""
        but = f" other than {', '.join(repr(other.phrase) for other in self.others)}" if self.others else ""
        near = f" near {' | '.join(self.near)}" if self.near else ""
        return f"{quantity}{' | '.join(self.candidates)}{told_by}{but}{near}"

    def to_json(self) -> dict[str, Any]:
        """Plain values, keys in this order; "other_than" and "near" where there are any."""
        value = {
            "phrase": self.phrase,
            "candidates": list(self.candidates),
            "all": self.is_all,
            "count": self.count,
            "where": dict(self.where),
        }
        others = {"other_than": [other.phrase for other in self.others]} if self.others else {}
        return {**value, **others, **({"near": list(self.near)} if self.near else {})}

    def __str__(self) -> str:
        return f"{self.phrase!r}: {self.choice}"


@dataclass(frozen=True, slots=True)
class GroundTask:
    """One task of an instruction in the house's names.

    `objects`: what it is about, one referent for each coordinated phrase (empty: searching a place for nothing in
    particular, motion, informing). `places`: where the objects are looked for or taken from (source, location),
    each candidate a place, a room, a thing or a person beside which they are; empty: anywhere. `goal`: where it
    ends (place, room, person, or thing beside which it ends). `recipients`: who hears it, one referent for each
    coordinated phrase, or the one who gets it. `state`: the value
    wanted or checked ("on", "hot", ...), `HERE` for a check of presence, which `is_denied` where it asks whether they
    are *not* there ("if Anna is out"). `is_only_there`: whether the objects are to be taken from the places and from
    nowhere else, so that it cannot be done where they are not there. `message`: what is said; `question`: the check or
    search that answers it ("whether the lamp is on"), which the robot makes before it says it. `forbidden`: steps by
    which it is not to be done (filling at the sink, where it is to be "with coffee"; heating in the microwave, where
    it is to be "in the oven"). `whereabouts`: who of those it has to do with is said to be where ("bring it to Tom *in
    the study*"): people, and rooms or places. `span`: the verb in the text, code points, end exclusive.
    """

    number: int
    type: str
    phrase: str
    span: tuple[int, int] = (0, 0)
    objects: tuple[Referent, ...] = ()
    places: tuple[Referent, ...] = ()
    goal: Referent | None = None
    recipients: tuple[Referent, ...] = ()
    state: str | None = None
    is_denied: bool = False
    is_only_there: bool = False
    message: str | None = None
    question: GroundTask | None = None
    forbidden: tuple[GroundAction, ...] = ()
    whereabouts: tuple[tuple[Referent, Referent], ...] = ()

    @property
    def target(self) -> Referent | None:
        """Where a thing ends up: with the one who gets it, else at the goal."""
        return self.recipients[0] if self.recipients else self.goal

    def referents(self) -> tuple[Referent, ...]:
        """All its referents: objects, places, goal, recipients."""
        return (*self.objects, *self.places, *((self.goal,) if self.goal is not None else ()), *self.recipients)

    def told_there(self) -> tuple[Referent, ...]:
        """Those of its recipients who are all that are at its places ("everybody in the kitchen")."""
        is_there = self.type == "informing" and bool(self.places)
        return tuple(referent for referent in self.recipients if is_there and referent.is_all)

    def devices(self, thing: str, domain: Domain) -> tuple[str, ...]:
        """The places at which it may bring a thing into its state, in the order of the house."""
        barred = {step.objects for step in self.forbidden}
        return tuple(place for place in devices_for(thing, self.state or "", domain) if (thing, place) not in barred)

    def may_be_none(self, referent: Referent) -> bool:
        """Whether nothing is to be done where nothing is as a phrase tells it ("close all the open windows", "wash any
        cups"), or nobody where it says ("tell everybody in the kitchen")."""
        if referent in self.told_there():
            return True
        is_told = bool(referent.where) or referent.is_any
        return self.type in HANDLING and referent in self.objects and referent.is_all and is_told

    def seeks_change(self, referent: Referent) -> bool:
        """Whether of the several things that a phrase may mean one is meant that is not as the task wants it, as long
        as there is one ("close the window", of which one is shut)."""
        is_certain_one = not (referent.is_all or referent.is_any) and referent.count == 1
        is_of_several = is_certain_one and len(referent.candidates) > 1
        return self.type == "change_state" and is_of_several and referent in self.objects

    def arguments(self) -> dict[str, tuple[Referent, ...] | str]:
        """What it has of object, location (its places), goal, recipient, state ("not here" where denied), message."""
        named: dict[str, tuple[Referent, ...] | str] = {
            "object": self.objects,
            "location": self.places,
            "goal": (self.goal,) if self.goal else (),
            "recipient": self.recipients,
            "state": f"{'not ' if self.is_denied else ''}{self.state}" if self.state else "",
            "message": self.message or "",
        }
        return {name: value for name, value in named.items() if value}

    def __str__(self) -> str:
        parts = [f"{self.number} {self.type}"]
        parts += [f"object {referent}" for referent in self.objects]
        parts += [f"{'only ' if self.is_only_there else ''}at {referent}" for referent in self.places]
        parts += [f"goal {self.goal}"] if self.goal else []
        parts += [f"to {referent}" for referent in self.recipients]
        parts += [f"who is at {where}" for _, where in self.whereabouts]
        parts += [f"state {'not ' if self.is_denied else ''}{self.state}"] if self.state else []
        parts += [f"message {self.message!r}"] if self.message else []
        parts += [f"without {step}" for step in self.forbidden]
        parts += [f"after ({self.question})"] if self.question else []
        return "; ".join(parts)


@dataclass(frozen=True, slots=True)
class GroundInstruction:
    """All tasks of an instruction, grounded, with its control flow. `text` is the instruction's."""

    text: str
    tasks: tuple[GroundTask, ...]
    flow: Flow

    def task(self, number: int) -> GroundTask:
        """The task with this number. Raises `KeyError` if there is none."""
        for task in self.tasks:
            if task.number == number:
                return task
        raise KeyError(number)

    def named_places(self) -> dict[str, tuple[str, ...]]:
        """Of what tasks are about, the places and rooms that one of them names for it: where it may be, or is to be."""
        named: dict[str, dict[str, None]] = {}
        for task in self.tasks:
            places = (*task.places, *((task.goal,) if task.goal is not None else ()))
            for name in (name for referent in task.objects for name in referent.candidates):
                named.setdefault(name, {}).update(dict.fromkeys(p for place in places for p in place.candidates))
        return {name: tuple(places) for name, places in named.items()}

    def whereabouts(self) -> tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]:
        """Where people with whom it has to do are said to be: any one of these, in any of these rooms or places."""
        said = (pair for node, _ in self.flow.walk() for pair in self.task(node.task).whereabouts)
        return tuple(dict.fromkeys((who.candidates, where.candidates) for who, where in said))

    def __str__(self) -> str:
        return "\n".join(str(task) for task in self.tasks)
