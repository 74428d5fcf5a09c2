"""Grounding: an understood instruction becomes tasks over the entities of a house.

Conservative: a phrase that names nothing here, a goal that no state of the house can be, and an argument that nobody
gives are errors, each with the task's number; nothing is guessed from words that merely look alike.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError, InputError, UnknownWordError
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.planning.abilities import states_of
from decomplex_bt.planning.completion import Ask, Completion
from decomplex_bt.planning.devices import devices_named, steps_elsewhere, without_devices
from decomplex_bt.planning.distribution import distributed
from decomplex_bt.planning.exclusions import with_clauses, without_exclusion
from decomplex_bt.planning.ground_task import FINDING_OUT, HERE, GroundInstruction, GroundTask, Referent
from decomplex_bt.planning.objects import Objects
from decomplex_bt.planning.passing_on import passed_on
from decomplex_bt.planning.phrases import read_phrases
from decomplex_bt.planning.pouring import wrong_fillings
from decomplex_bt.planning.prepositions import split_preposition
from decomplex_bt.planning.questions import question_of
from decomplex_bt.planning.referents import Referents
from decomplex_bt.planning.sent import with_place_sent, with_room_entered
from decomplex_bt.planning.served import with_served
from decomplex_bt.planning.sources import with_source
from decomplex_bt.planning.state_words import read_state
from decomplex_bt.planning.states import States
from decomplex_bt.planning.told_by_place import with_places_told
from decomplex_bt.planning.wording import Wording

__all__ = ["Ask", "GroundInstruction", "GroundTask", "Referent", "ground"]

FILL, FULL, EMPTY = "fill", "full", "empty"
SOMEBODY, ANYTHING = "somebody", "anything"
GIVEN_AT = frozenset(("to", "into"))
"""Prepositions of where somebody gets a thing, unlike those of where it lies."""

_ASKED_FOR = frozenset(("who", "who is", "who's", "who\u2019s"))


def ground(instruction: Instruction, domain: Domain, *, ask: Ask | None = None) -> GroundInstruction:
    """The instruction's tasks with every phrase replaced by the entities it may mean.

    Raises `UnknownWordError`, `ImpossibleGoalError`, or `MissingArgumentError` where `ask` is None or has no answer;
    all are `InputError`s that carry the task's number. A later mention of a task is not executed, and raises nothing.
    """
    for task in instruction.tasks:
        if task.type not in domain.ontology.task_types:
            known = ", ".join(domain.ontology.task_types)
            raise InputError(f"task {task.id} has the type {task.type!r}; expected one of {known}")
    instruction = passed_on(distributed(instruction))
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
    """Grounds the tasks in the order of the text."""

    def __init__(self, instruction: Instruction, domain: Domain, ask: Ask | None) -> None:
        self.instruction, self.domain = instruction, domain
        self.house = domain.house
        self.mentions = {n.task: [instruction.task(i) for i in n.tasks[1:]] for n, _ in instruction.flow.walk()}
        self.wording, self.referents = (
            Wording(instruction, domain),
            Referents(instruction.text, instruction.flow, domain),
        )
        self.completion = Completion(instruction, domain, self.wording, self.mentions, ask)
        self.objects = Objects(domain, self.referents)
        self.states = States(instruction, domain, self.referents, self.objects)

    def ground(self, task: Task) -> GroundTask:
        """The grounded task. Raises `InputError`s without the task's number."""
        self.referents.others.begin(task.id)
        task, left_out = without_exclusion(self.instruction, with_clauses(self.instruction, task))
        task = self._with_verb_told(self._with_places(task))
        state = self._state_of_verb(task)
        task = self.completion.complete(task, state is not None)
        grounded = _BY_TYPE.get(task.type, _Grounder._other)(self, task, self._bare(task), state)
        self.objects.note(grounded)
        if left_out is None:
            return grounded
        try:
            return self.objects.less(grounded, task, left_out.words)
        except InputError:
            if not left_out.is_aside:
                raise
            return grounded

    def _with_places(self, task: Task) -> Task:
        """A task with the places that other words tell: those of things, of who is served, of where it is sent."""
        task = with_places_told(self.instruction, with_source(task, self.domain), self.domain)
        task = with_served(task, self.domain)
        task = with_place_sent(self.instruction, with_room_entered(self.instruction, task, self.domain), self.domain)
        # nothing is put onto itself: "pick up the ball and drop it" does not say where
        is_circle = [a.type == "goal" and a.span is None and a.value in task.values("object") for a in task.arguments]
        return replace(task, arguments=tuple(a for a, c in zip(task.arguments, is_circle, strict=True) if not c))

    def _with_verb_told(self, task: Task) -> Task:
        """A task with what its verb alone tells: a state, a goal, an object such as "nobody"."""
        if self._is_emptying(task):
            objects = tuple(argument for argument in task.arguments if argument.type == "object")
            task = replace(task, type="change_state", arguments=(*objects, Argument("state", EMPTY)))
        is_stateless = task.value("state") is None and self._state_of_verb(task) is None
        if task.type == "change_state" and is_stateless and self.wording.is_state(task):
            # a verbless order is marked on its state: "lamp off"
            task = replace(task, arguments=(*task.arguments, Argument("state", task.span.of(self.instruction.text))))
        sense = self.wording.sense(task)
        if sense is not None and sense.goal is not None and task.value("goal") is None:
            task = replace(task, arguments=(*task.arguments, Argument("goal", sense.goal)))
        if self.wording.is_of_nobody(task):
            others = tuple(argument for argument in task.arguments if argument.type != "object")
            return replace(task, arguments=(*others, Argument("object", self._nobody_of(task))))
        if self.wording.is_of_anything(task):
            return replace(task, arguments=(*task.arguments, Argument("object", ANYTHING)))
        return task

    def _state_of_verb(self, task: Task) -> str | None:
        """The state that the verb of a task implies: "open", "heat"."""
        sense = self.wording.sense(task)
        return sense.state if sense is not None and task.type == "change_state" else None

    def _nobody_of(self, task: Task) -> str:
        """Whom a check of nobody asks of: at a place that is said the one who speaks may be, too."""
        where, lexicon = task.value("location"), self.domain.lexicon
        is_at_place = where is not None and not self.wording.is_presence(where)
        is_with_me = where is not None and self._place_words(where) in (*lexicon.user_words, *lexicon.here_words)
        is_of_me = is_at_place and not is_with_me and not self.wording.is_of_nobody_else(task)
        return f"{SOMEBODY} or me" if is_of_me else SOMEBODY

    def mention(self, task: Task) -> GroundTask:
        """A task that speaks of another again and is not executed: without what it says where that is not enough for a
        task of its own ("if it doesn't work")."""
        ask, self.completion.ask = self.completion.ask, None
        try:
            return self.ground(task)
        except InputError:
            return self._bare(task)
        finally:
            self.completion.ask = ask

    def _bare(self, task: Task) -> GroundTask:
        return GroundTask(task.id, task.type, self.instruction.phrase(task.id), (task.span.start, task.span.end))

    # -- one function for each task type ------------------------------------------------------------------------------

    def _motion(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        place = task.argument("goal", "recipient", "path") or self._named_direction(task)
        if place is not None:
            goal = self.referents.place(place, people=True)
            return replace(bare, goal=goal, whereabouts=self._whereabouts(place))
        if (left := task.argument("source")) is not None:
            return replace(bare, goal=self.referents.elsewhere(left))
        raise ImpossibleGoalError(
            f"task {task.id} ({bare.phrase!r}) says how to move but no place to end up; say where to go"
        )

    def _named_direction(self, task: Task) -> Argument | None:
        """The direction, where it names a place ("towards the window")."""
        direction = task.argument("direction")
        try:
            return direction if direction is not None and read_phrases(direction.value, self.domain) else None
        except UnknownWordError:
            return None

    def _searching(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        places = self._places(task, "location", "source")
        # "see who is in the kitchen" is a look around there
        is_said = [a.type != "object" or a.value.lower() not in _ASKED_FOR for a in task.arguments]
        task = replace(task, arguments=tuple(a for a, said in zip(task.arguments, is_said, strict=True) if said))
        objects, inner = self.objects.find(task, lambda name: True, "be looked for")
        fixed = [r for r in objects if all(self.referents.is_fixed(name) for name in r.candidates)]
        if fixed and not places:
            return replace(bare, places=tuple(fixed), objects=tuple(r for r in objects if r not in fixed))
        if not all(is_said) and not objects:
            places = tuple(map(self._floors_of, places))  # nobody is in a cupboard
        if not objects and not places + inner:
            raise ImpossibleGoalError(
                f"task {task.id} ({bare.phrase!r}) says neither what to look for nor where; say one of them"
            )
        return replace(bare, objects=objects, places=places + inner)

    def _floors_of(self, place: Referent) -> Referent:
        rooms = self.domain.house.rooms
        floors = (self.domain.house.floor_of(name) if name in rooms else name for name in place.candidates)
        return replace(place, candidates=tuple(floors))

    def _taking(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        places = self._places(task, "source", "location")
        objects, inner = self.objects.find(task, self.referents.is_thing, "be carried")
        return replace(bare, objects=objects, places=places + inner, is_only_there=self._is_only_there(task))

    def _is_only_there(self, task: Task) -> bool:
        """Whether a later mention asks if the things are where the task takes them from ("if it isn't there"), or that
        is all that is said of them ("something from the fridge")."""
        sources = {self._place_words(a.value) for a in task.arguments if a.type in ("source", "location")}
        said = [phrase for words in task.values("object") for phrase in read_phrases(words, self.domain)]
        return bool(sources) and (
            any(map(self.objects.is_anything, said))
            or any(
                self._place_words(argument.value) in sources or self._is_there(argument)
                for mention in self.mentions.get(task.id, ())
                if mention.type in FINDING_OUT and (argument := mention.argument("location", "source")) is not None
            )
        )

    def _place_words(self, words: str) -> str:
        return split_preposition(words, self.domain)[1]

    def _is_there(self, argument: Argument) -> bool:
        """Whether a place is said as "there", which a reading may have taken for where the thing goes."""
        return argument.span is not None and argument.span.of(self.instruction.text).lower() == "there"

    def _placing(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        grounded = self._taking(task, bare, state)
        goal = task.argument("goal")
        assert goal is not None
        return replace(grounded, goal=self.referents.goal_place(goal))

    def _bringing(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        grounded = self._taking(task, bare, state)
        recipient, goal = task.argument("recipient"), task.argument("goal")
        people = self.referents.people(recipient, "get a thing") if recipient is not None else (self._user(),)
        if recipient is None and goal is not None:
            people = (self.referents.goal_place(goal),)
            if not all(map(self.referents.is_person, people[0].candidates)):
                return replace(grounded, goal=people[0])
        if len(people) > 1 or people[0].is_all or self._is_of_us(recipient):
            who = " and ".join(person.phrase for person in people)
            raise ImpossibleGoalError(f"only one person can have a thing, not {who!r}; say who, or what each gets")
        self.referents.others.give(grounded.objects)
        whereabouts = self._whereabouts(recipient or goal)
        if recipient is not None and goal is not None:
            whereabouts += self._given_at(people[0], goal)
        return replace(grounded, recipients=people, whereabouts=whereabouts)

    def _given_at(self, who: Referent, goal: Argument) -> tuple[tuple[Referent, Referent], ...]:
        """Where somebody is to be brought a thing: "bring us the soup to the kitchen"."""
        if split_preposition(goal.value, self.domain)[0] not in GIVEN_AT:
            return ()
        try:
            where = self.referents.goal_place(goal)
        except InputError:
            return ()
        return ((who, where),) if all(map(self.referents.is_fixed, where.candidates)) else ()

    def _whereabouts(self, argument: Argument | None) -> tuple[tuple[Referent, Referent], ...]:
        """Where the words for people say that they are ("Tom in the study"), not all of whom are meant."""
        found = []
        for phrase in self.referents.phrases(argument) if argument is not None else ():
            who = self.referents.person(phrase)
            if who is not None and phrase.place is not None:
                where = self.referents.where(phrase.place)
                found += [(who, where)] if all(map(self.referents.is_fixed, where.candidates)) else []
        return tuple(found)

    def _is_of_us(self, recipient: Argument | None) -> bool:
        """Whether more than the one who speaks is meant: "each of us"."""
        if recipient is None:
            return False
        return any(p.is_all and p.entities == (self.house.user,) for p in self.referents.phrases(recipient))

    def _change_state(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        places = self._places(task, "location", "source")
        words = task.value("state")
        objects, inner = self.states.find(task, places, words, state)
        pair, value = self.states.value_of(objects, words, state, task)
        objects = tuple(self.states.as_it_is(referent, pair) for referent in objects)
        fits = tuple(
            self.referents.narrowed(referent, lambda name: self.states.can_become(name, pair, value))
            for referent in objects
        )
        for referent, fit in zip(objects, fits, strict=True):
            if fit is None:
                raise ImpossibleGoalError(f"nothing here makes {referent.phrase!r} {value}")
        able = tuple(fit for fit in fits if fit is not None)
        named = devices_named(task, able, value, self.domain)
        sought = without_devices(places, able, named, self.domain)
        there = sought + inner if self.referents.may_move(objects) else ()
        forbidden = steps_elsewhere(task, able, value, self.domain)
        forbidden += wrong_fillings(task, able, self.domain) if value == FULL else ()
        return replace(bare, objects=able, places=there, state=value, forbidden=forbidden)

    def _check_state(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        words, where = task.value("state"), task.value("location")
        if where is not None and self.wording.is_presence(where):
            where, words = None, words or (None if self.wording.is_state(task) else where)
        if where is not None and self.wording.has_absence_verb(task) and self.wording.is_house(where):
            where = None
        if where is None and words is None and (particle := self.wording.absence_particle(task)):
            is_said = self.wording.is_absence(particle) or self._is_state_of_objects(task, particle)
            words = particle if is_said else None
        if words is not None and self.wording.has_possession_verb(task) and self._asks_who_has(task, words):
            raise ImpossibleGoalError(
                f"who has a thing cannot be asked here ({bare.phrase!r}); ask whether it is with them or somewhere"
            )
        is_bare = words is None and (where is None or self.wording.is_state(task))
        if is_bare and not self.wording.has_presence_verb(task):
            # a verbless condition is marked on its state: "oven on?", "heater on in the bathroom?"
            words = task.span.of(self.instruction.text)
        places = self._places(task, "location", "source") if where is not None else ()
        if self._asks_absence(task, words, where):
            objects, inner = self.objects.find(task, lambda name: True, "be looked for")
            left = places if where is not None and self.wording.is_left(where) else ()
            return self._absence(replace(bare, objects=objects, places=left + inner, state=HERE, is_denied=True), task)
        if words is None or (self.wording.is_presence(words) and not self._is_state_of_objects(task, words)):
            objects, inner = self.objects.find(task, lambda name: True, "be looked for")
            return self._presence(replace(bare, objects=objects, places=places + inner, state=HERE), task)
        objects, inner = self.states.find(task, places, words, state)
        _, value = self.states.value_of(objects, words, state, task)
        objects = tuple(self.states.as_it_is(referent) for referent in objects)
        there = places + inner if self.referents.may_move(objects) else ()
        return replace(bare, objects=objects, places=there, state=value)

    def _absence(self, grounded: GroundTask, task: Task) -> GroundTask:
        """A check of presence that is denied: all are out where not one is here."""
        anybody = self.domain.lexicon.anybody_words
        if any(referent.phrase in anybody for referent in grounded.objects):
            raise ImpossibleGoalError(
                f"whether {task.value('object')!r} of several is out is no question here; say who"
            )
        objects = tuple(replace(referent, is_all=False) for referent in grounded.objects)
        return self._presence(replace(grounded, objects=objects), task)

    def _asks_absence(self, task: Task, words: str | None, where: str | None) -> bool:
        """Whether a check asks whether somebody or something is not there; a light that is out is off, and who has
        gone somewhere is there."""
        verb = task.span.of(self.instruction.text)
        if self.wording.has_absence_verb(task) and words in (None, verb):
            may_go = self.wording.is_absence(verb) or all(map(self.referents.is_person, self._named(task)))
            return may_go and (where is None or self.wording.is_left(where))
        return words is not None and self.wording.is_absence(words) and not self._is_state_of_objects(task, words)

    def _asks_who_has(self, task: Task, words: str) -> bool:
        people = self._named(task)
        is_whereabouts = self.wording.is_presence(words) or self.wording.is_absence(words)
        return bool(people) and all(map(self.referents.is_person, people)) and not is_whereabouts

    def _is_state_of_objects(self, task: Task, words: str) -> bool:
        """Whether words that may say presence or absence are a state that an object can be in."""
        return any(read_state(words, states_of(name, self.domain), self.domain) for name in self._named(task))

    def _named(self, task: Task) -> list[str]:
        """What the words of its objects name as they stand."""
        return [n for said in task.values("object") for p in read_phrases(said, self.domain) for n in p.entities]

    def _presence(self, grounded: GroundTask, task: Task) -> GroundTask:
        for referent in grounded.objects:
            if all(name in self.house.rooms for name in referent.candidates):
                raise ImpossibleGoalError(
                    f"whether {referent.phrase!r} is there is no question; ask about a thing or a person"
                )
        return grounded

    def _following(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        goal = task.argument("goal", "path")
        objects, _ = self.objects.find(task, self.referents.is_person, "be followed")
        whereabouts = tuple(pair for a in task.arguments if a.type == "object" for pair in self._whereabouts(a))
        goal_place = self._whither(goal) if goal is not None else None
        return replace(bare, objects=objects, goal=goal_place, whereabouts=whereabouts)

    def _whither(self, argument: Argument) -> Referent:
        """Where somebody leads the way to: who leads knows rooms and furniture, not where things lie."""
        goal = self.referents.place(argument)
        fixed = tuple(name for name in goal.candidates if not self.referents.is_thing(name))
        if not fixed:
            what = repr(argument.value)
            raise ImpossibleGoalError(
                f"{what} may lie anywhere, so nobody can lead the way to it; say a room or a piece of furniture"
            )
        return replace(goal, candidates=fixed)

    def _informing(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        recipient = task.argument("recipient")
        people = self.referents.people(recipient, "be told") if recipient is not None else (self._user(),)
        there = self._where_all_are(recipient) if recipient is not None else ()
        question, message, whereabouts = self._question(task, bare), task.value("message"), self._whereabouts(recipient)
        return replace(
            bare, recipients=people, places=there, message=message, question=question, whereabouts=whereabouts
        )

    def _where_all_are(self, recipient: Argument) -> tuple[Referent, ...]:
        """The places of all who are somewhere ("everybody in the kitchen")."""
        said = [phrase.place for phrase in self.referents.phrases(recipient) if phrase.is_all]
        places = tuple(self.referents.where(place) for place in said if place is not None)
        for place in places:
            if not all(map(self.referents.is_fixed, place.candidates)):
                raise ImpossibleGoalError(f"who is where {place.phrase!r} is cannot be known here; say a room")
        return places

    def _question(self, task: Task, bare: GroundTask) -> GroundTask | None:
        """What is to be found out before it is said: where a message asks for what can be seen here; else None."""
        asked = question_of(task.value("message") or "")
        if asked is None:
            return None
        kind, arguments = asked
        check = replace(task, type=kind, arguments=arguments)
        try:
            if kind == "searching":
                return self._searching(check, replace(bare, type=kind), None)
            return self._check_state(check, replace(bare, type=kind), None)
        except InputError:
            return None

    def _other(self, task: Task, bare: GroundTask, state: str | None) -> GroundTask:
        """A task type of a domain of one's own: its goal template is all there is to it."""
        objects, places = self.objects.find(task, lambda name: True, f"be an object of {task.type}")
        recipient, goal = task.argument("recipient"), task.argument("goal")
        return replace(
            bare,
            objects=objects,
            places=places + self._places(task, "location", "source"),
            goal=self.referents.place(goal, people=True) if goal else None,
            recipients=self.referents.people(recipient, "be a recipient") if recipient else (),
            state=state,
            message=task.value("message"),
        )

    def _user(self) -> Referent:
        return Referent(self.house.user, (self.house.user,))

    # -- states -------------------------------------------------------------------------------------------------------

    def _is_emptying(self, task: Task) -> bool:
        """Whether a task would take out what stays but can be emptied ("take the trash out")."""
        if task.type not in ("taking", "bringing") or FILL not in self.domain.kinds.state_pairs:
            return False
        if not self.wording.says_out(task):
            return False
        names = self._named(task)
        return bool(names) and all(
            self.referents.is_fixed(name) and self.states.can_become(name, FILL, EMPTY) for name in names
        )

    def _places(self, task: Task, *names: str) -> tuple[Referent, ...]:
        """The referents of the places that these arguments name."""
        found: list[Referent] = []
        for name in names:
            for argument in task.arguments:
                if argument.type == name and not self.wording.is_presence(argument.value):
                    found.extend(map(self.referents.where, self.referents.phrases(argument)))
        return tuple(found)


_BY_TYPE: Mapping[str, Callable[[_Grounder, Task, GroundTask, str | None], GroundTask]] = {
    "motion": _Grounder._motion,
    "searching": _Grounder._searching,
    "taking": _Grounder._taking,
    "placing": _Grounder._placing,
    "bringing": _Grounder._bringing,
    "change_state": _Grounder._change_state,
    "check_state": _Grounder._check_state,
    "following": _Grounder._following,
    "informing": _Grounder._informing,
}
"""How a task of each type is grounded; any other is of a domain of one's own."""
