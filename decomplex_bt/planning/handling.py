"""Handling: tasks that bring something about for things, places and people."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial

from decomplex_bt.domain.nouns import be
from decomplex_bt.planning.abilities import runs_shut, wipers_of
from decomplex_bt.planning.belief import ROBOT
from decomplex_bt.planning.ground_task import HANDLING, HERE, Referent
from decomplex_bt.planning.looking import Looking
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.standing import NothingLeftError, Pursuit
from decomplex_bt.planning.whereabouts import next_place, places_in


class Handling(Looking):
    """How a task stands that handles things or has to do with people, and what to bring about next."""

    def settle_all(self) -> None:
        """Binds "everything on the table", once the places were looked at, to what is there then; a check of what is
        there ("if there are dirty plates in the sink") finds out whether anything is."""
        is_check = self.task.type == "check_state" and self.task.state == HERE
        handles = self.task.type in HANDLING
        if not (handles or is_check) or not self.wheres:
            return
        if not self._is_on_map() and any(self._is_open(place) for place in self.wheres):
            return
        for referent in self.task.objects:
            if referent.is_all and referent not in self.bindings:
                there = [
                    name
                    for name in self._fitting(referent)
                    if self._is_there(name) or (handles and self.belief.place_of(name) == ROBOT)  # picked up meanwhile
                ]
                if not there and is_check:
                    continue
                if not there and not self.task.may_be_none(referent):
                    raise NothingLeftError(self._why(f"{referent.phrase!r}: nothing of it is there", self.wheres))
                self.bindings = {**self.bindings, referent: tuple(there)}

    def _look_there(self) -> Pursuit | None:
        """A look for what is only to be taken from where the task says; None once it is bound to what is there."""
        for referent in self.task.objects if self.task.is_only_there else ():
            names = self._fitting(referent)
            there = [name for name in names if self._is_there(name) or self.belief.carried(name) >= self.since]
            if len(there) < (1 if referent.is_all else referent.count):
                place = next_place(names, self.belief, [place for place in self.wheres if self._is_open(place)])
                if place is not None:
                    return self._inspect(place, referent.phrase)
                raise NothingLeftError(self._why(f"{referent.phrase!r} is not there", self.wheres))
            if not referent.is_all:
                self.bindings = self._bind({referent: there[: referent.count]})
        return None

    def _atoms(self, task_type: str, roles: Mapping[str, str]) -> tuple[Atom, ...]:
        """The goal of a task; that a device which is on with its door open runs is also that it is shut."""
        atoms = super()._atoms(task_type, roles)
        is_to_shut = task_type == "change_state" and "object" in roles and self._is_ajar(roles["object"])
        return (*atoms, Atom("closed", (roles["object"],))) if is_to_shut else atoms

    def _is_ajar(self, name: str) -> bool:
        """Whether the task wants something to run behind its door, and it is on already and known to be open."""
        is_on = self.belief.state(name, "power") == "on" and self.belief.state(name, "aperture") == "open"
        return is_on and runs_shut(name, self.task.state, self.domain)

    # -- handling things ----------------------------------------------------------------------------------------------

    def _put(self, task_type: str) -> Pursuit:
        """Placing and bringing: the things end up at the goal, or with the recipient."""
        if (search := self._look_there()) is not None:
            return search
        target = self.task.target
        assert target is not None
        role = "recipient" if self.task.recipients else "goal"
        people = [name for name in self._meant(target) if name in self.house.people]
        names = self._usual_first([name for name in self._meant(target) if name not in people])
        landings = {place: name for name in reversed(names) for place in reversed(self._landing(name))}

        def has_arrived(name: str, ends: Sequence[str] = self._meant(target)) -> bool:
            place = self.belief.place_of(name)
            return place is not None and place != ROBOT and any(self._is_end(end, place) for end in ends)

        for end in self._meant(target):
            if (found := self._found(partial(has_arrived, ends=(end,)))) is not None:
                return self._done({**found, target: [end]})
        lost = [name for name in self._meant(target) if not self._is_located(name)]
        ends = [name for name in (*people, *reversed(landings)) if name not in lost and name not in self.house.things]
        if all(name in self._floors() for name in ends):
            ends.sort(key=self._distance)  # one floor is as good as another
        if not ends and lost:
            return self._fetch(has_arrived) or self._look_for_people(target, lost)
        if not ends:
            raise NothingLeftError(self._why(f"there is no way to {target.phrase!r}", target.candidates))
        if (way := self._go_beside(target, has_arrived)) is not None:
            return way
        arrivals = {end: partial(has_arrived, ends=(landings.get(end, end),)) for end in ends}
        return self._put_at_one(task_type, arrivals, {end: role if end in people else "goal" for end in ends})

    def _put_at_one(
        self, task_type: str, arrivals: Mapping[str, Callable[[str], bool]], roles: Mapping[str, str]
    ) -> Pursuit:
        """All the things end up at one and the same of several ends, the first that can be: of several things at the
        one where most are already. `arrivals`: by end, whether a thing is there; `roles`: what the end is to the task.
        """
        ends, problem = list(arrivals), None
        if sum(map(self._needed, self.task.objects)) > 1:
            things = [name for referent in self.task.objects for name in self._fitting(referent)]
            ends.sort(key=lambda end: -sum(map(arrivals[end], things)))
        for end in ends:
            try:
                return self._handle(task_type, arrivals[end], {roles[end]: end})
            except NothingLeftError as error:
                problem = error
        assert problem is not None
        raise problem

    def _fetch(self, has_arrived: Callable[[str], bool]) -> Pursuit | None:
        """The things are had first while it is not known where they are to go: who turns up meanwhile is gone to once.
        None once they are carried, or as many as the robot can take."""

        def is_settled(name: str) -> bool:
            return has_arrived(name) or self.belief.place_of(name) == ROBOT

        has_room = self.belief.held is None or None in self.belief.tray
        return self._handle("taking", is_settled, {}) if has_room and self._found(is_settled) is None else None

    def _go_beside(self, target: Referent, has_arrived: Callable[[str], bool]) -> Pursuit | None:
        """The things are had, and then what they are put down beside is gone to; None where the robot is there with
        them, or cannot get there: anywhere on the floor will do."""
        places = [name for name in target.near if self._is_possible((Atom("at", (name,)),))]
        if not places:
            return None
        if (fetch := self._fetch(has_arrived)) is not None:
            return fetch
        if any(map(self.belief.is_near, places)):
            return None
        places.sort(key=self._distance)
        return self._ongoing((Atom("at", (places[0],)),), f"going to {target.phrase}")

    def _floors(self) -> frozenset[str]:
        return frozenset(self.house.floor_of(room) for room in self.house.rooms)

    def _is_end(self, name: str, place: str) -> bool:
        """Whether what lies at a place is at a goal: the place itself, a room it is in, a thing that lies there too."""
        if name in self.house.rooms:
            return self.domain.room_of(place) == name
        return place in (name, self.belief.place_of(name) if name in self.house.things else None)

    def _landing(self, name: str) -> list[str]:
        """Where a thing is put for a goal: a place itself, in a room a surface that suits, beside a thing its place."""
        if name in self.house.things:
            place = self.belief.place_of(name)
            return [place] if place is not None and place != ROBOT else []
        if name not in self.house.rooms:
            return [name]
        surfaces = [place for place in places_in(name, self.domain) if not self.domain.kind(place).has_door]
        return self._usual_first(surfaces)

    def _usual_first(self, places: Iterable[str]) -> list[str]:
        """Places where the things tend to lie first ("the shelf" of a book is the bookshelf), else in their order."""
        things = [thing for referent in self.task.objects for thing in self._fitting(referent)]
        weights = [dict(self.belief.prior.places.get(thing, ())) for thing in things]
        return sorted(places, key=lambda place: -sum(weight.get(place, 0.0) for weight in weights))

    def _handle(
        self, task_type: str, is_done: Callable[[str], bool], roles: Mapping[str, str], *, batch: int = 2
    ) -> Pursuit:
        """Brings something about for the objects: finds them all first, then plans for a few at a time."""
        found = self._found(is_done)
        if found is not None:
            return self._done(found)
        chosen: list[str] = []
        for referent in self.task.objects:
            picked, unknown = self._choose(referent, is_done, task_type, roles)
            if len(picked) < self._needed(referent) and unknown:
                place = self._next_for(unknown)
                if place is not None:
                    return self._inspect(place, referent.phrase)
            if not self._is_enough(referent, picked):
                raise NothingLeftError(self._why_not(referent, roles))
            chosen += [name for name in picked if not is_done(name)]
        goals = [self._atoms(task_type, {**roles, "object": name}) for name in chosen]
        joint = tuple(sorted({atom for goal in goals[:batch] for atom in goal}))
        goal = self._first_open([joint, *goals])
        if goal is None:
            raise NothingLeftError(self._why(f"no way was found to do it with {self._objects_phrase()}", chosen))
        return self._ongoing(goal, self.task.phrase)

    def _find_tool(self, is_done: Callable[[str], bool]) -> Pursuit | None:
        """A search for something to wipe with, where a place is to be cleaned and none is known; else None."""
        names = [name for referent in self.task.objects for name in self._fitting(referent) if not is_done(name)]
        wiped = [name for name in names if name not in self.house.things]
        tools = wipers_of(wiped[0], self.domain) if wiped and self.task.state == "clean" else ()
        if not tools or any(self._is_located(tool) for tool in tools):
            return None
        place = next_place(tools, self.belief, self._open_for(tools))
        what = self.domain.kind(tools[0]).words[0]
        if place is None:
            raise NothingLeftError(f"there is no {what} to be found to clean {self._objects_phrase()} with")
        return self._inspect(place, f"a {what}")

    def _choose(
        self, referent: Referent, is_done: Callable[[str], bool], task_type: str, roles: Mapping[str, str]
    ) -> tuple[list[str], list[str]]:
        """Of a referent's candidates those that will do and are located, best first, and those that may turn up."""

        def is_possible(name: str) -> bool:
            return is_done(name) or self._is_possible(self._atoms(task_type, {**roles, "object": name}))

        able = [name for name in self._fitting(referent) if is_possible(name)]
        located = [name for name in able if self._is_located(name)]
        if self.wheres and referent not in self.bindings:
            there = [
                name for name in located if is_done(name) or self._is_there(name) or self.belief.place_of(name) == ROBOT
            ]
            is_enough = len(there) >= max(1, self._needed(referent))
            if referent.is_all or is_enough or any(self._is_open(place) for place in self.wheres):
                located = there
        unknown = [name for name in able if not self._is_located(name)]
        if self.wheres and not unknown and len(located) < self._needed(referent):
            unknown = able
        located.sort(key=lambda name: (not is_done(name), self.belief.place_of(name) != ROBOT, self._distance(name)))
        if referent.is_all:
            return located, unknown
        return located[: self._needed(referent)], unknown

    def _next_for(self, unknown: Sequence[str]) -> str | None:
        """Where to look next for things: at the places the task names, then wherever they may be."""
        place = next_place(unknown, self.belief, [place for place in self.wheres if self._is_open(place)])
        if place is not None or (self.wheres and any(r.is_all for r in self.task.objects)):
            return place
        return next_place(unknown, self.belief, self._open_for(unknown))

    def _is_enough(self, referent: Referent, picked: Sequence[str]) -> bool:
        """Of "all" those will do that there are."""
        return bool(picked) if referent.is_all else len(picked) >= self._needed(referent) > 0

    # -- people and places to go to -----------------------------------------------------------------------------------

    def _go(self, target: Referent, names: Sequence[str]) -> Pursuit:
        located = [name for name in names if self._is_located(name)]
        ends = [end for name in located if (end := self._standing_for(name)) is not None]
        goals = [self._atoms("motion", {"goal": end}) for end in ends]
        goal = self._first_open(goals)
        if goal is not None:
            here = target.phrase in self.domain.lexicon.here_words
            return self._ongoing(goal, f"going {'' if here else 'to '}{target.phrase}")
        lost = [name for name in names if name not in located]
        if lost:
            return self._look_for_people(target, lost)
        raise NothingLeftError(self._why(f"there is no way to {target.phrase!r}", target.candidates))

    def _standing_for(self, name: str) -> str | None:
        """The room or position one goes to for a name: of a thing its place, of a floor its room; None if not known."""
        if name in self.house.things:
            place = self.belief.place_of(name)
            return self.belief.room if place == ROBOT else place
        return name.removesuffix("_floor") if name.removesuffix("_floor") in self.house.rooms else name

    def _was_at(self, name: str) -> bool:
        place = self._standing_for(name)
        return place is not None and self.belief.visited(place) >= self.since

    def _is_at(self, name: str) -> bool:
        """Whether the robot is at a place or person now."""
        return self.belief.is_near(self._standing_for(name))

    def _with_people(
        self, referents: Sequence[Referent], goal_of: Callable[[str], tuple[Atom, ...]], is_done: Callable[[str], bool]
    ) -> Pursuit:
        """Does something with people, one after the other, looking for those whose whereabouts are not known."""
        for referent in referents:
            done = [name for name in self._meant(referent) if is_done(name)]
            if len(done) >= self._needed(referent):
                continue
            left = [name for name in self._meant(referent) if name not in done]
            located = sorted((name for name in left if self._is_located(name)), key=self._distance)
            goal = self._first_open([goal_of(name) for name in located])
            if goal is not None:
                return self._ongoing(goal, self.task.phrase)
            lost = [name for name in left if name not in located]
            if lost and self._next_for(lost) is not None:
                return self._look_for_people(referent, lost)
            if not (done and referent.is_all):
                raise NothingLeftError(
                    self._why(
                        f"{referent.phrase!r} {be(referent.phrase)} not to be found or reached", referent.candidates
                    )
                )
        return self._done(
            {referent: [name for name in self._meant(referent) if is_done(name)] for referent in referents}
        )

    def _look_for_people(self, referent: Referent, lost: Sequence[str]) -> Pursuit:
        place = next_place(lost, self.belief, self._open_for(lost))
        if place is None:
            raise NothingLeftError(self._why(f"{referent.phrase!r} {be(referent.phrase)} nowhere to be found", lost))
        return self._inspect(place, referent.phrase)
