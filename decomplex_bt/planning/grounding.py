"""Grounding: an understood instruction becomes tasks over the entities of a house.

Conservative: a phrase that names nothing here, a goal that no state of the house can be, and an argument that nobody
gives are errors, each with the task's number; nothing is guessed from words that merely look alike.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import replace

from decomplex_bt.domain.clauses import asks_presence, clause_around, is_of_nobody
from decomplex_bt.domain.lexicon import VerbSense
from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.verbs import lemmas, sense_of
from decomplex_bt.errors import ImpossibleGoalError, InputError, MissingArgumentError, UnknownWordError
from decomplex_bt.instruction import Argument, Instruction, Missing, Task
from decomplex_bt.planning.abilities import bringable_values, holds_things
from decomplex_bt.planning.ground_task import HERE, GroundInstruction, GroundTask, Referent
from decomplex_bt.planning.phrases import DEFINITE, NounPhrase, read_phrases, read_state, split_preposition

__all__ = ["Ask", "GroundInstruction", "GroundTask", "Referent", "ground"]

Ask = Callable[[Missing], str | None]
"""Answers a question about a missing argument, None if it has no answer."""

FILL, EMPTY = "fill", "empty"
SOMEBODY = "somebody"
_PARTICLES = re.compile(r"[a-z']+")


def ground(instruction: Instruction, domain: Domain, *, ask: Ask | None = None) -> GroundInstruction:
    """The instruction's tasks with every phrase replaced by the entities it may mean.

    Raises `UnknownWordError`, `ImpossibleGoalError`, or `MissingArgumentError` where `ask` is None or has no answer;
    all are `InputError`s that carry the task's number. A later mention of a task is not executed, and raises nothing.
    """
    grounder = _Grounder(instruction, domain, ask)
    mentions = instruction.flow.mentions()
    tasks = []
    for task in instruction.tasks:
        if task.id in mentions:
            tasks.append(grounder.mention(task))
            continue
        try:
            tasks.append(grounder.ground(task))
        except UnknownWordError as error:
            error.task = error.task if error.task is not None else task.id
            raise
        except ImpossibleGoalError as error:
            error.task = error.task if error.task is not None else task.id
            raise
    return GroundInstruction(instruction.text, tuple(tasks), instruction.flow)


class _Grounder:
    """Grounds the tasks in the order of the text; rooms named on the way tell ambiguous places apart."""

    def __init__(self, instruction: Instruction, domain: Domain, ask: Ask | None) -> None:
        self.instruction, self.domain, self.ask = instruction, domain, ask
        self.house = domain.house
        self.rooms: tuple[str, ...] = ()
        """The rooms in question: of the place named last, where its words leave no doubt."""
        self.mentioned: dict[tuple[tuple[str, ...], tuple[tuple[str, str], ...]], Referent] = {}

    def ground(self, task: Task) -> GroundTask:
        """The grounded task. Raises `InputError`s without the task's number."""
        if self._is_emptying(task):
            objects = tuple(argument for argument in task.arguments if argument.type == "object")
            task = replace(task, type="change_state", arguments=(*objects, Argument("state", EMPTY)))
        sense = self._sense(task)
        state = sense.state if sense is not None and task.type == "change_state" else None
        if sense is not None and sense.goal is not None and task.value("goal") is None:
            task = replace(task, arguments=(*task.arguments, Argument("goal", sense.goal)))
        if self._is_of_nobody(task):
            others = tuple(argument for argument in task.arguments if argument.type != "object")
            task = replace(task, arguments=(*others, Argument("object", SOMEBODY)))
        task = self._complete(task, state is not None)
        bare = self._bare(task)
        grounded: GroundTask = getattr(self, f"_{task.type}", self._other)(task, bare, state)
        return grounded

    def mention(self, task: Task) -> GroundTask:
        """A task that speaks of another again and is not executed: without what it says where that is not enough for a
        task of its own ("if it doesn't work")."""
        ask, self.ask = self.ask, None
        try:
            return self.ground(task)
        except InputError:
            return self._bare(task)
        finally:
            self.ask = ask

    def _bare(self, task: Task) -> GroundTask:
        return GroundTask(task.id, task.type, self.instruction.phrase(task.id), (task.span.start, task.span.end))

    # -- one function for each task type ------------------------------------------------------------------------------

    def _motion(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        words = task.value("goal") or task.value("recipient") or task.value("path") or self._named_direction(task)
        if words is not None:
            return replace(bare, goal=self._place(words, people=True))
        if (left := task.value("source")) is not None:
            return replace(bare, goal=self._elsewhere(left))
        raise ImpossibleGoalError(
            f"task {task.id} ({bare.phrase!r}) says how to move but no place to end up; say where to go"
        )

    def _named_direction(self, task: Task) -> str | None:
        """The direction, where it names a place ("towards the window")."""
        words = task.value("direction")
        try:
            return words if words is not None and read_phrases(words, self.domain) else None
        except UnknownWordError:
            return None

    def _searching(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        places = self._places(task, "location", "source")
        objects, inner = self._objects(task, lambda name: True, "be looked for")
        fixed = [r for r in objects if all(self._is_fixed(name) for name in r.candidates)]
        if fixed and not places:
            return replace(bare, places=tuple(fixed), objects=tuple(r for r in objects if r not in fixed))
        return replace(bare, objects=objects, places=places + inner)

    def _taking(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        places = self._places(task, "source", "location")
        objects, inner = self._objects(task, self._is_thing, "be carried")
        return replace(bare, objects=objects, places=places + inner)

    def _placing(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        grounded = self._taking(task, bare, state)
        return replace(grounded, goal=self._goal_place(task.value("goal") or ""))

    def _bringing(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        grounded = self._taking(task, bare, state)
        recipient, goal = task.value("recipient"), task.value("goal")
        if recipient is not None:
            return replace(grounded, recipient=self._person(recipient, "get a thing"))
        if goal is None:
            return replace(grounded, recipient=self._user())
        where = self._goal_place(goal)
        if all(name in self.house.people for name in where.candidates):
            return replace(grounded, recipient=where)
        return replace(grounded, goal=where)

    def _change_state(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        places = self._places(task, "location", "source")
        words = task.value("state")
        objects, inner = self._stateful(task, places, words, state)
        pair, value = self._value_of(objects, words, state, task)
        fits = tuple(self._narrowed(referent, lambda name: self._can_become(name, pair, value)) for referent in objects)
        for referent, fit in zip(objects, fits, strict=True):
            if fit is None:
                raise ImpossibleGoalError(f"nothing here makes {referent.phrase!r} {value}")
        there = tuple(
            place for place in places + inner if any(not self._is_fixed(n) for r in objects for n in r.candidates)
        )
        return replace(bare, objects=tuple(fit for fit in fits if fit is not None), places=there, state=value)

    def _check_state(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        words, where = task.value("state"), task.value("location")
        if where is not None and self._is_presence(where):
            where, words = None, words or where
        asks_presence = words is None or self._is_presence(words)
        if words is None and where is None and not self._has_presence_verb(task):
            # a verbless condition is marked on its state: "oven on?"
            words = task.span.of(self.instruction.text)
            asks_presence = self._is_presence(words)
        places = self._places(task, "location", "source") if where is not None else ()
        if asks_presence:
            objects, inner = self._objects(task, lambda name: True, "be looked for")
            return self._presence(replace(bare, objects=objects, places=places + inner, state=HERE), task)
        objects, inner = self._stateful(task, places, words, state)
        _, value = self._value_of(objects, words, state, task)
        there = tuple(
            place for place in places + inner if any(not self._is_fixed(n) for r in objects for n in r.candidates)
        )
        return replace(bare, objects=objects, places=there, state=value)

    def _presence(self, grounded: GroundTask, task: Task) -> GroundTask:
        for referent in grounded.objects:
            if all(name in self.house.rooms for name in referent.candidates):
                raise ImpossibleGoalError(
                    f"whether {referent.phrase!r} is there is no question; ask about a thing or a person"
                )
        return grounded

    def _following(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        goal = task.value("goal") or task.value("path")
        objects, _ = self._objects(task, self._is_person, "be followed")
        return replace(bare, objects=objects, goal=self._whither(goal) if goal is not None else None)

    def _whither(self, words: str) -> Referent:
        """Where somebody leads the way to: who leads knows rooms and furniture, not where things lie."""
        goal = self._place(words)
        fixed = tuple(name for name in goal.candidates if not self._is_thing(name))
        if not fixed:
            raise ImpossibleGoalError(
                f"{words!r} may lie anywhere, so nobody can lead the way to it; say a room or a piece of furniture"
            )
        return replace(goal, candidates=fixed)

    def _informing(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        recipient = task.value("recipient")
        person = self._person(recipient, "be told") if recipient is not None else self._user()
        return replace(bare, recipient=person, message=task.value("message"))

    def _other(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        """A task type of a domain of one's own: its goal template is all there is to it."""
        objects, places = self._objects(task, lambda name: True, f"be an object of {task.type}")
        recipient, goal = task.value("recipient"), task.value("goal")
        return replace(
            bare,
            objects=objects,
            places=places + self._places(task, "location", "source"),
            goal=self._place(goal, people=True) if goal else None,
            recipient=self._person(recipient, "be a recipient") if recipient else None,
            state=state,
            message=task.value("message"),
        )

    # -- what is not said ---------------------------------------------------------------------------------------------

    def _complete(self, task: Task, has_state: bool) -> Task:
        """The task with its missing arguments asked for. Raises `MissingArgumentError` where there is no answer."""
        task_type = self.domain.ontology.task_types[task.type]
        missing = {m.argument for m in self.instruction.missing if m.task == task.id}
        task = replace(task, arguments=tuple(a for a in task.arguments if a.type not in missing))
        given = {argument.type for argument in task.arguments}
        if task.type in ("bringing", "informing"):
            given.add("recipient")
        if has_state or (task.type == "check_state" and self._says_state(task)):
            given.add("state")
        for group in task_type.required:
            if not given & set(group):
                answer = self._answer(task, group[0], task_type.questions[group[0]])
                task = replace(task, arguments=(*task.arguments, Argument(group[0], answer)))
        return task

    def _answer(self, task: Task, argument: str, question: str) -> str:
        missing = next((m for m in self.instruction.missing if (m.task, m.argument) == (task.id, argument)), None)
        missing = missing or Missing(task.id, argument, question)
        answer = self.ask(missing) if self.ask is not None else None
        if not answer:
            raise MissingArgumentError(missing)
        return answer

    def _user(self) -> Referent:
        return Referent(self.house.user, (self.house.user,))

    # -- verbs and states ---------------------------------------------------------------------------------------------

    def _sense(self, task: Task) -> VerbSense | None:
        """What the verb, with its particle, implies ("turn … on", "heat", "throw … away"), as a verb of this type."""
        sense = sense_of(task.span.of(self.instruction.text), self._particles(task), self.domain.lexicon)
        return None if sense is None or task.type not in sense.tasks else sense

    def _is_emptying(self, task: Task) -> bool:
        """Whether a task would take out what stays but can be emptied ("take the trash out")."""
        if task.type not in ("taking", "bringing") or FILL not in self.domain.kinds.state_pairs:
            return False
        if "out" not in self._particles(task) and task.value("goal") not in ("out", "outside"):
            return False
        names = [n for words in task.values("object") for p in read_phrases(words, self.domain) for n in p.entities]
        return bool(names) and all(self._is_fixed(name) and self._can_become(name, FILL, EMPTY) for name in names)

    def _particles(self, task: Task) -> list[str]:
        """The words behind the verb, up to the next task or the end of the sentence, that are in no argument."""
        text = self.instruction.text
        stops = [other.span.start for other in self.instruction.tasks if other.span.start > task.span.start]
        end = min([*stops, len(text)])
        spans = [a.span for other in self.instruction.tasks for a in other.arguments if a.span is not None]
        free: list[str] = []
        for match in _PARTICLES.finditer(text.lower(), task.span.end, end):
            if any(mark in text[task.span.end : match.start()] for mark in ".;!?"):
                break
            if not any(span.start <= match.start() < span.end for span in spans):
                free.append(match[0])
        return free

    def _is_of_nobody(self, task: Task) -> bool:
        """Whether a check is of nobody's being there: of anybody's, with its branches changed over by the flow."""
        if task.type != "check_state" or task.value("object") not in (None, "one", "no one"):
            return False
        return is_of_nobody(self._clause(task))

    def _clause(self, task: Task) -> str:
        return clause_around(self.instruction.text, task.span, [other.span for other in self.instruction.tasks])

    def _has_presence_verb(self, task: Task) -> bool:
        """Whether a check asks only whether something is there: by its verb, or by what it asks ("if there is")."""
        form = task.span.of(self.instruction.text).lower()
        is_verb = any(lemma in self.domain.lexicon.presence_verbs for lemma in lemmas(form))
        return is_verb or asks_presence(self._clause(task))

    def _says_state(self, task: Task) -> bool:
        """Whether the word that carries a check says itself what is asked ("oven on?", "any soap left?")."""
        word = task.span.of(self.instruction.text)
        is_state = read_state(word, self.domain.kinds.state_pairs, self.domain) is not None
        return is_state or self._is_presence(word) or self._has_presence_verb(task)

    def _is_presence(self, words: str) -> bool:
        _, rest = split_preposition(words, self.domain)
        return words.lower().strip() in self.domain.lexicon.presence_words or rest in self.domain.lexicon.presence_words

    def _stateful(
        self, task: Task, places: tuple[Referent, ...], words: str | None, state: str | None
    ) -> tuple[tuple[Referent, ...], tuple[Referent, ...]]:
        """The objects of a task about a state: of what a phrase may name, what can be in that state."""
        pairs = self._pairs_meant(words, state)
        if words is not None and not pairs and state is None:
            known = sorted({value for pair in self.domain.kinds.state_pairs.values() for value in pair.values})
            raise ImpossibleGoalError(
                f"{words!r} is no state that anything here can be in; known states: {', '.join(known)}"
            )

        def has_state(name: str) -> bool:
            return name not in self.house.rooms and bool(pairs & set(self._states(name)))

        rooms = {room for place in places for name in place.candidates if (room := self._room(name)) is not None}
        label = f"be {state or words}"
        return self._objects(task, has_state, label, rooms=rooms)

    def _pairs_meant(self, words: str | None, state: str | None) -> set[str]:
        kinds = self.domain.kinds
        if words is not None:
            meant = {pair for pair in kinds.state_pairs if read_state(words, (pair,), self.domain) is not None}
            if meant or state is None:
                return meant
        return {kinds.pair_of(state)} if state is not None else set()

    def _value_of(
        self, objects: tuple[Referent, ...], words: str | None, state: str | None, task: Task
    ) -> tuple[str, str]:
        """State pair and value for these objects. Raises `ImpossibleGoalError` where they have no such state."""
        pairs = [
            pair
            for pair in self.domain.kinds.state_pairs
            if all(pair in self._states(r.candidates[0]) for r in objects)
        ]
        found = read_state(words, pairs, self.domain) if words is not None else None
        if found is None and state is not None and self.domain.kinds.pair_of(state) in pairs:
            found = (self.domain.kinds.pair_of(state), state)
        if found is None:
            raise ImpossibleGoalError(f"{words or state!r} is no state that {objects[0].phrase!r} can be in")
        return found

    def _states(self, name: str) -> tuple[str, ...]:
        if name in self.house.rooms or (name in self.house.doorways and self.house.doorways[name].kind is None):
            return ()
        return self.domain.kind(name).states

    def _can_become(self, name: str, pair: str, value: str) -> bool:
        return pair in self._states(name) and value in bringable_values(name, pair, self.domain)

    # -- things, places, people ---------------------------------------------------------------------------------------

    def _objects(
        self, task: Task, fits: Callable[[str], bool], ability: str, *, rooms: Iterable[str] = ()
    ) -> tuple[tuple[Referent, ...], tuple[Referent, ...]]:
        """The referents of the object arguments that fit, and of the places inside their phrases."""
        objects, inner = [], []
        for words in task.values("object"):
            for phrase in read_phrases(words, self.domain):
                objects.append(self._referent(phrase, fits, ability, rooms=frozenset(rooms), is_place=False))
                if phrase.place is not None and any(not self._is_fixed(name) for name in objects[-1].candidates):
                    inner.append(self._where(phrase.place))
        self._refuse_everything(task, objects, inner)
        return tuple(objects), tuple(inner)

    def _refuse_everything(self, task: Task, objects: list[Referent], inner: list[Referent]) -> None:
        for referent in objects:
            has_place = inner or task.value("source") or task.value("location")
            if referent.is_all and len(referent.candidates) == len(self.house.things) and not has_place:
                raise UnknownWordError(referent.phrase, expected="a thing, or everything at a place")

    def _places(self, task: Task, *arguments: str) -> tuple[Referent, ...]:
        """The referents of the places that these arguments name."""
        found: list[Referent] = []
        for argument in arguments:
            for words in task.values(argument):
                if not self._is_presence(words):
                    found.extend(self._where(phrase) for phrase in read_phrases(words, self.domain))
        return tuple(found)

    def _where(self, phrase: NounPhrase) -> Referent:
        """Where something is looked for: on or in a place, beside a thing or with a person."""
        referent = self._referent(phrase, lambda name: True, "be a place", is_place=True)
        if phrase.preposition in self.domain.lexicon.beside:
            near = [place for name in referent.candidates for place in (name, *self._beside(name))]
            return replace(referent, candidates=tuple(dict.fromkeys(place for place in near if self._can_hold(place))))
        if not all(self._is_thing(name) for name in referent.candidates) or phrase.preposition not in (
            "in",
            "inside",
            "into",
        ):
            return referent
        raise ImpossibleGoalError(f"nothing can lie in {phrase.text!r} here")

    def _goal_place(self, words: str) -> Referent:
        """Where a thing is put: on or in a place, in a room, beside a thing, or to a person."""
        phrase = read_phrases(words, self.domain)[0]
        referent = self._referent(phrase, lambda name: True, "be a place", is_place=True)
        is_beside = phrase.preposition in self.domain.lexicon.beside
        if is_beside:
            near = [place for name in referent.candidates for place in self._beside(name)]
            return replace(referent, candidates=tuple(dict.fromkeys(near)))
        fit = self._narrowed(referent, self._can_hold)
        if fit is None or all(self._is_thing(name) for name in fit.candidates):
            raise ImpossibleGoalError(f"nothing can be put {words!r}: it is neither a surface nor a container here")
        return fit

    def _place(self, words: str, *, people: bool = False) -> Referent:
        """Where the robot goes: a room, a place, a door, a person or what lies there."""
        phrase = read_phrases(words, self.domain)[0]
        return self._referent(phrase, lambda name: people or not self._is_person(name), "be gone to", is_place=True)

    def _elsewhere(self, words: str) -> Referent:
        """Anywhere but the room that is left, the rooms next to it first.

        What there is one of in every room ("the rug") is the likeliest of them.
        """
        places = self._place(words).candidates
        left = {self._room(name) for name in places}
        if left.issuperset(self.house.rooms):
            left = {self._room(places[0])}
        next_to = [room for d in self.house.doorways.values() if left & set(d.rooms) for room in d.rooms]
        rooms = tuple(room for room in dict.fromkeys([*next_to, *self.house.rooms]) if room not in left)
        return Referent(f"out of {split_preposition(words, self.domain)[1]}", rooms)

    def _person(self, words: str, ability: str) -> Referent:
        phrases = read_phrases(words, self.domain)
        referents = [self._referent(phrase, self._is_person, ability, is_place=False) for phrase in phrases]
        if len(referents) == 1:
            return referents[0]
        names = tuple(dict.fromkeys(name for referent in referents for name in referent.candidates))
        return Referent(" and ".join(referent.phrase for referent in referents), names, is_all=True)

    def _referent(
        self,
        phrase: NounPhrase,
        fits: Callable[[str], bool],
        ability: str,
        *,
        rooms: frozenset[str] = frozenset(),
        is_place: bool,
    ) -> Referent:
        """The referent of a noun phrase: of what it names, what fits. Raises `ImpossibleGoalError` if nothing does."""
        entities = tuple(name for name in phrase.entities if fits(name))
        is_plural = not entities
        names = entities or tuple(name for name in phrase.plurals if fits(name))
        if not names and phrase.is_all and phrase.plurals == tuple(self.house.things):
            names = tuple(name for name in self.house.places() if fits(name))  # "turn everything off"
        if not names:
            first = (*phrase.entities, *phrase.plurals)[0]
            raise ImpossibleGoalError(
                f"{phrase.text!r} cannot {ability} ({first.replace('_', ' ')} is what it names here)"
            )
        is_all = phrase.is_all or (is_plural and phrase.is_definite)
        names = self._in_context(names, rooms, is_all)
        if phrase.count > len(names):
            raise ImpossibleGoalError(f"{phrase.text!r}: there are only {len(names)} of them in this house")
        if is_place or all(self._is_fixed(name) for name in names):
            self._remember(names)
        text = split_preposition(phrase.text, self.domain)[1]
        # "the dirty shirt", where there is one shirt, is that shirt, whatever its state
        where = () if len(names) == 1 and text.split()[0] in DEFINITE else phrase.wanted
        referent = Referent(text, names, is_all and len(names) > 1, phrase.count, where)
        return self._same(referent) if phrase.is_definite else self._first(referent)

    def _first(self, referent: Referent) -> Referent:
        self.mentioned.setdefault(_key(referent), referent)
        return referent

    def _same(self, referent: Referent) -> Referent:
        """The referent that a definite phrase takes up again ("a pen ... the pen"), or itself."""
        first = self.mentioned.setdefault(_key(referent), referent)
        return first if first.is_all == referent.is_all else referent

    def _in_context(self, names: tuple[str, ...], rooms: frozenset[str], is_all: bool) -> tuple[str, ...]:
        """Of fixed candidates those in the rooms that are said, else in the room in question, if there are any."""
        if len(names) == 1 or not all(self._is_fixed(name) for name in names):
            return names
        for wanted in (rooms, () if is_all else self.rooms):
            there = tuple(name for name in names if set(wanted) & set(self._rooms(name)))
            if there:
                return there
        return names

    def _remember(self, names: tuple[str, ...]) -> None:
        rooms = tuple(sorted({room for name in names for room in self._rooms(name)}))
        if len(rooms) == 1:
            self.rooms = rooms

    def _rooms(self, name: str) -> tuple[str, ...]:
        doorway = self.house.doorways.get(name)
        if doorway is not None:
            return doorway.rooms
        room = self._room(name)
        return (room,) if room is not None else ()

    def _room(self, name: str) -> str | None:
        return self.domain.room_of(name)

    def _beside(self, name: str) -> tuple[str, ...]:
        """Where something lies that is beside, under or behind this: on what it is part of, else on the floor there."""
        if self._is_thing(name) or self._is_person(name) or name in self.house.rooms:
            return (name,)
        piece = self.house.furniture.get(name)
        if piece is not None and piece.part_of is not None and holds_things(piece.part_of, self.domain):
            return (piece.part_of,)
        return tuple(self.house.floor_of(room) for room in self._rooms(name))

    def _narrowed(self, referent: Referent, fits: Callable[[str], bool]) -> Referent | None:
        names = tuple(name for name in referent.candidates if fits(name))
        return replace(referent, candidates=names) if names else None

    def _can_hold(self, name: str) -> bool:
        return (
            name in self.house.rooms or self._is_person(name) or self._is_thing(name) or holds_things(name, self.domain)
        )

    def _is_thing(self, name: str) -> bool:
        return name in self.house.things

    def _is_person(self, name: str) -> bool:
        return name in self.house.people

    def _is_fixed(self, name: str) -> bool:
        return not self._is_thing(name) and not self._is_person(name)


def _key(referent: Referent) -> tuple[tuple[str, ...], tuple[tuple[str, str], ...]]:
    return referent.candidates, referent.where
