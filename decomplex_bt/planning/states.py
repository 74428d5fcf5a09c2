"""States: which objects a task about a state is of, and which value of which pair of states its words mean."""

from __future__ import annotations

import re
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError
from decomplex_bt.instruction import Instruction, Task
from decomplex_bt.planning.abilities import bringable_values, states_of
from decomplex_bt.planning.ground_task import Referent
from decomplex_bt.planning.objects import Objects
from decomplex_bt.planning.phrases import rooms_of
from decomplex_bt.planning.referents import Referents
from decomplex_bt.planning.state_words import read_state

_JOINED = re.compile(r"(?<!\bnice )(?<!\bgood )(?<!\blovely )\b(?:and|or|but)\b")
"""What joins two states into words that are none: "clean and dry", not "nice and warm"."""


class States:
    """Reads the states that the tasks of an instruction speak of."""

    def __init__(self, instruction: Instruction, domain: Domain, referents: Referents, objects: Objects) -> None:
        self.instruction, self.domain, self.house = instruction, domain, domain.house
        self.referents, self.objects = referents, objects

    def find(
        self, task: Task, places: tuple[Referent, ...], words: str | None, state: str | None
    ) -> tuple[tuple[Referent, ...], tuple[Referent, ...]]:
        """The objects of a task about a state: of what a phrase may name, what can be in that state."""
        if words is not None and _JOINED.search(words):
            raise ImpossibleGoalError(f"{words!r} is more than one state; say each ('if it is open and it is dirty')")
        pairs = self._pairs_meant(words, state)
        if words is not None and not pairs and state is None:
            known = sorted({value for pair in self.domain.kinds.state_pairs.values() for value in pair.values})
            raise ImpossibleGoalError(
                f"{words!r} is no state that anything here can be in; known states: {', '.join(known)}"
            )

        def has_state(name: str) -> bool:
            return name not in self.house.rooms and bool(pairs & set(states_of(name, self.domain)))

        rooms = {room for place in places for name in place.candidates for room in rooms_of(name, self.domain)}
        values = " or ".join(value for pair in sorted(pairs) for value in self.domain.kinds.state_pairs[pair].values)
        verb = task.span.of(self.instruction.text).lower()
        is_said = words is not None or state is None or state in verb or verb in state
        label = f"be {state or words}{'' if is_said else f' (so {verb!r} is read)'}: being {values}"
        if words is not None and words.lower().split()[:1] in (["up"], ["down"]):
            label = f"be {words}: how far something is turned, raised or lowered"  # for want of what opens and closes
        label += " is not modelled for {}"
        objects, inner = self.objects.find(task, has_state, label, rooms=rooms)
        return tuple(one for referent in objects for one in self._each_in(referent, places)), inner

    def _each_in(self, referent: Referent, places: tuple[Referent, ...]) -> tuple[Referent, ...]:
        """One of several things of a kind for each of several places that "and" joins: "close the window in the kitchen
        and in the study"; the referent itself where a place has none of its own."""
        own = [
            tuple(n for n in referent.candidates if not rooms.isdisjoint(rooms_of(n, self.domain)))
            for place in places
            for rooms in [{room for name in place.candidates for room in rooms_of(name, self.domain)}]
        ]
        is_one_of_each = len(own) > 1 and all(own) and len({*sum(own, ())}) == sum(map(len, own))
        if referent.is_all or not is_one_of_each or not all(map(self.referents.is_fixed, referent.candidates)):
            return (referent,)
        return tuple(replace(referent, candidates=names) for names in own)

    def as_it_is(self, referent: Referent, *pairs: str) -> Referent:
        """A referent that is the only one of its kind, whatever its state (one of `pairs`, if given): "wash the dirty
        shirt", where there is one shirt, is done when that shirt is clean."""
        if len(referent.candidates) > 1 or referent.is_all or referent.is_any:
            return referent
        as_it_is = replace(referent, where=tuple(w for w in referent.where if pairs and w[0] not in pairs))
        self.referents.settle(referent, as_it_is)
        return as_it_is

    def _pairs_meant(self, words: str | None, state: str | None) -> set[str]:
        """The pairs of states that words may be of, else that of the state which the verb implies."""
        kinds = self.domain.kinds
        if words is not None:
            meant = {pair for pair in kinds.state_pairs if read_state(words, (pair,), self.domain) is not None}
            if meant or state is None:
                return meant
        return {kinds.pair_of(state)} if state is not None else set()

    def value_of(
        self, objects: tuple[Referent, ...], words: str | None, state: str | None, task: Task
    ) -> tuple[str, str]:
        """State pair and value for these objects. Raises `ImpossibleGoalError` where they have no such state."""
        pairs = [
            pair
            for pair in self.domain.kinds.state_pairs
            if all(pair in states_of(r.candidates[0], self.domain) for r in objects)
        ]
        found = read_state(words, pairs, self.domain) if words is not None else None
        if found is None and state is not None and self.domain.kinds.pair_of(state) in pairs:
            found = (self.domain.kinds.pair_of(state), state)
        if found is None:
            raise ImpossibleGoalError(f"{words or state!r} is no state that {objects[0].phrase!r} can be in")
        return found

    def can_become(self, name: str, pair: str, value: str) -> bool:
        """Whether something that is done here brings an entity into this state."""
        return pair in states_of(name, self.domain) and value in bringable_values(name, pair, self.domain)
