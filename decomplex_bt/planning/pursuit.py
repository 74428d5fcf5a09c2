"""The pursuit of one task at run time: what to bring about next, or that it is done or past hope.

How the leaf of a behaviour tree uses it (`bindings` is shared by all leaves of an instruction, `since` is the belief's
tick when the task became due):

    belief.update(percept)                               # every tick
    pursuit = pursue(task, belief, bindings, since=since)
    bindings = pursuit.bindings
    if pursuit.status is ONGOING:                        # keep the running plan while pursuit.goal_atoms stay the same
        problem = belief_problem(belief, pursuit.goal_atoms)     # planning/problem.py
        result = planner.solve(problem)                          # planning/planner.py
        if result.status is not SOLVED:                              # and pursue again
            belief.give_up(pursuit.goal_atoms, result.reason, is_final=result.status.is_final)
        else run the skills of result.steps in order; a skill's end is reported by
            belief.succeeded(step)   or   belief.failed(step, reason)                        # and pursue again

`pursue` is a pure function of its arguments and cheap; calling it whenever `belief.revision` has changed lets the leaf
see at once that a thing has turned up on the way, or that the goal holds already.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.ground_task import HERE, GroundTask
from decomplex_bt.planning.handling import Handling
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.problem import belief_problem
from decomplex_bt.planning.standing import Bindings, NothingLeftError, Pursuit, PursuitStatus
from decomplex_bt.planning.whereabouts import next_place

__all__ = ["Bindings", "Pursuit", "PursuitStatus", "pursue"]


def pursue(task: GroundTask, belief: Belief, bindings: Bindings, *, since: int) -> Pursuit:
    """How the task stands, by what the robot has perceived since `belief.tick` was `since`."""
    pursuer = _Pursuer(task, belief, bindings, since)
    try:
        pursuer.settle_all()
        return _BY_TYPE.get(task.type, _Pursuer._other)(pursuer)
    except NothingLeftError as error:
        return replace(pursuer.nothing_left(error), bindings=bindings)


class _Pursuer(Handling):
    """Each method named for a task type says how a task of the type stands (docs/grounding.md)."""

    # -- one for each task type ---------------------------------------------------------------------------------------

    def _motion(self) -> Pursuit:
        target = self.task.target
        assert target is not None
        reached = [name for name in self._meant(target) if self._was_at(name)]
        if len(reached) >= self._needed(target):
            return self._done({target: reached})
        return self._go(target, [name for name in self._meant(target) if name not in reached])

    def _searching(self) -> Pursuit:
        if not self.task.objects:
            return self._look_at_places()
        found = self._found(lambda name: self._was_seen(name) and self._is_there(name))
        if found is not None:
            return self._done(found)
        if self.task.places and self._is_on_map():
            return self._look_at_fixed()
        if not self.task.places:
            return self._look_for(self._missing(lambda name: self.belief.seen(name) >= self.since))
        return self._look_through(may_be_partial=True)

    def _check_state(self) -> Pursuit:
        if self.task.state != HERE:
            return self._check_value()
        presence = self._check_presence()
        if self.task.is_denied and presence.status is PursuitStatus.DONE and presence.truth is not None:
            return replace(presence, truth=not presence.truth)
        return presence

    def _check_presence(self) -> Pursuit:
        if self._is_on_map():
            there = self._found(self._is_there)
            return self._done(there) if there is not None else self._not_there()
        found = self._found(lambda name: self._was_seen(name) and self._is_there(name))
        if found is None and self.task.places and not any(self._is_open(place) for place in self.wheres):
            # A floor is looked over by what was in view a moment ago; who was seen there then is there as well.
            found = self._found(self._is_there)
        if found is not None:
            return self._done(found)
        if self.task.places:
            return self._look_through(may_be_partial=False)
        try:
            return self._look_for(self._missing(self._was_seen))
        except NothingLeftError as error:
            if self._unanswered():
                raise
            # All was looked at in vain: that is an answer.
            return Pursuit(PursuitStatus.DONE, truth=False, reason=str(error), bindings=self.bindings)

    def _taking(self) -> Pursuit:
        if (search := self._look_there()) is not None:
            return search
        return self._handle("taking", lambda name: self.belief.carried(name) >= self.since, {})

    def _placing(self) -> Pursuit:
        return self._put("placing")

    def _bringing(self) -> Pursuit:
        return self._put("bringing")

    def _change_state(self) -> Pursuit:
        value = self.task.state or ""
        pair = self.domain.kinds.pair_of(value)

        def has_become(name: str) -> bool:
            if self.belief.state(name, pair) != value or self._is_ajar(name):
                return False
            was_asked = any(pair == other for r in self.task.objects if name in r.candidates for other, _ in r.where)
            return not was_asked or self.belief.state_changed(name, pair) >= self.since

        if self._found(has_become) is None and (search := self._find_tool(has_become)) is not None:
            return search
        return self._handle("change_state", has_become, {"state": value}, batch=1)

    def _following(self) -> Pursuit:
        rooms = [self.domain.room_of(name) or name for name in self._meant(self.task.goal)] if self.task.goal else []

        def has_come(person: str) -> bool:
            if rooms:
                is_there = self.belief.room in rooms and self.belief.place_of(person) == self.belief.room
                return is_there or any(self._was_noted("followed", person, room) for room in rooms)
            return self._was_noted("accompanied", person)

        found = self._found(has_come)
        if found is not None:
            goals = self._meant(self.task.goal) if self.task.goal else []
            if goals and not any(name in rooms or self._is_at(name) for name in goals):
                assert self.task.goal is not None
                return self._go(self.task.goal, goals)  # people are led to rooms; the robot goes on to the place in it
            return self._done(found)
        roles = {"goal": rooms[0]} if rooms else {}
        return self._with_people(self.task.objects, lambda who: self._goal({"object": who, **roles}), has_come)

    def _informing(self) -> Pursuit:
        def was_told(person: str) -> bool:
            return self._was_noted("told", person)

        if self.task.question is not None:
            looking = pursue(self.task.question, self.belief, self.bindings, since=0)  # what was seen is known
            if looking.status is PursuitStatus.ONGOING:
                return looking
            self.bindings = looking.bindings
        if (search := self._look_who_is_there()) is not None:
            return search
        return self._with_people(self.task.recipients, lambda who: self._goal({"recipient": who}), was_told)

    def _look_who_is_there(self) -> Pursuit | None:
        """A look for all who are at the places that the task says; None once they are bound to who is there."""
        for referent in self.task.told_there():
            if referent in self.bindings:
                continue
            place = next_place(referent.candidates, self.belief, [p for p in self.wheres if self._is_open(p)])
            if place is not None:
                return self._inspect(place, referent.phrase)
            if not all(map(self._was_inspected, self.wheres)):
                raise NothingLeftError(self._why(f"who is {referent.phrase!r} could not be seen", self.wheres))
            there = tuple(name for name in referent.candidates if self._is_there(name))
            self.bindings = {**self.bindings, referent: there}
        return None

    def _other(self) -> Pursuit:
        """A task type of a domain of one's own: its goal template, with the first candidate of every phrase."""
        roles = {"object": self.task.objects[0]} if self.task.objects else {}
        roles |= {"goal": self.task.goal} if self.task.goal is not None else {}
        roles |= {"recipient": self.task.recipients[0]} if self.task.recipients else {}
        goal = self._goal({role: self._meant(referent)[0] for role, referent in roles.items()})
        if all(self.belief.noted(atom) > self.since or self._is_so((atom,)) for atom in goal):
            return self._done({})
        return self._bring_about([goal], self.task.phrase)

    def _is_so(self, goal: tuple[Atom, ...]) -> bool:
        """Whether a goal holds by what is believed; of states none that is only assumed."""
        pairs = {value: pair for pair, both in self.domain.kinds.state_pairs.items() for value in both.values}
        is_known = all(
            self.belief.state(atom.objects[0], pairs[atom.predicate]) == atom.predicate
            for atom in goal
            if atom.predicate in pairs
        )
        return is_known and set(goal) <= set(belief_problem(self.belief, goal).init)


_BY_TYPE: Mapping[str, Callable[[_Pursuer], Pursuit]] = {
    "motion": _Pursuer._motion,
    "searching": _Pursuer._searching,
    "taking": _Pursuer._taking,
    "placing": _Pursuer._placing,
    "bringing": _Pursuer._bringing,
    "change_state": _Pursuer._change_state,
    "check_state": _Pursuer._check_state,
    "following": _Pursuer._following,
    "informing": _Pursuer._informing,
}
"""How a task of each type is pursued; any other is of a domain of one's own."""
