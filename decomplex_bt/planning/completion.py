"""What a task leaves unsaid: taken from later mentions of it, asked for, or an error."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError, MissingArgumentError
from decomplex_bt.instruction import Argument, Instruction, Missing, Task
from decomplex_bt.planning.abilities import states_of
from decomplex_bt.planning.ground_task import FINDING_OUT
from decomplex_bt.planning.phrases import picked_words, read_phrases
from decomplex_bt.planning.wording import Wording

Ask = Callable[[Missing], str | None]
"""Answers a question about a missing argument, None if it has no answer."""


class Completion:
    """Completes the tasks of one instruction. `mentions`: of each task the later mentions of it; `ask` may be
    changed at any time, None: nobody is asked."""

    def __init__(
        self,
        instruction: Instruction,
        domain: Domain,
        wording: Wording,
        mentions: Mapping[int, Sequence[Task]],
        ask: Ask | None,
    ) -> None:
        self._instruction, self._domain, self._wording = instruction, domain, wording
        self._mentions, self.ask = mentions, ask

    def complete(self, task: Task, has_state: bool) -> Task:
        """The task with its missing arguments asked for; `has_state`: its verb tells a state.

        Raises `MissingArgumentError` where there is no answer, `ImpossibleGoalError` where none would help.
        """
        task_type = self._domain.ontology.task_types[task.type]
        missing = {m.argument for m in self._instruction.missing if m.task == task.id}
        task = replace(task, arguments=tuple(a for a in task.arguments if a.type not in missing))
        task = self._with_mentions(task)
        given = {argument.type for argument in task.arguments}
        if task.type in ("bringing", "informing"):
            given.add("recipient")
        if self._wording.is_of_weather(task):
            said = task.value("state") or task.span.of(self._instruction.text)
            raise ImpossibleGoalError(
                f"nothing here tells the weather, the day or what it is like somewhere ({said!r}); "
                "ask about a thing or a person"
            )
        self._check_working(task)
        if has_state or (task.type == "check_state" and self._wording.says_state(task)):
            given.add("state")
        for group in task_type.required:
            if not given & set(group):
                self._check_stateless(task, group[0])
                self._check_let(task, group[0])
                answer = self._answer(task, group[0], task_type.questions[group[0]])
                task = replace(task, arguments=(*task.arguments, Argument(group[0], answer)))
        return task

    def _check_stateless(self, task: Task, lacking: str) -> None:
        """Raises `ImpossibleGoalError` where an order lacks a state and what it is about has none to ask for."""
        if task.type != "change_state" or lacking != "state" or task.value("object") is None:
            return
        phrases = [phrase for said in task.values("object") for phrase in read_phrases(said, self._domain)]
        if any(states_of(name, self._domain) for p in phrases for name in (*p.entities, *p.plurals)):
            return
        done, what = task.span.of(self._instruction.text).lower(), task.value("object")
        raise ImpossibleGoalError(
            f"{done!r} says nothing that can be done with {what!r} here, which has no state to change; "
            "ask for something else"
        )

    def _check_let(self, task: Task, lacking: str) -> None:
        """Raises `ImpossibleGoalError` where somebody or something is let in or out, which is no place."""
        done, what = task.span.of(self._instruction.text).lower(), task.value("object")
        if task.type == "placing" and lacking == "goal" and done == "let":
            raise ImpossibleGoalError(
                f"nothing is let in or out of anything here, {what!r} neither; ask for something else"
            )

    def _check_working(self, task: Task) -> None:
        """Raises `ImpossibleGoalError` where a check asks whether a device works, which nobody sees: to try it is more
        than to look."""
        what = task.value("object")
        if what is None or not self._wording.is_of_working(task):
            return
        names = (name for phrase in read_phrases(what, self._domain) for name in (*phrase.entities, *phrase.plurals))
        fixed = [name for name in names if name in self._domain.house.furniture]
        if any(self._domain.kind(name).is_device for name in fixed):
            raise ImpossibleGoalError(
                f"whether {what!r} works or is broken is found out by trying alone; "
                f"say 'turn on {what}; if that fails, ...' with what to do then"
            )

    def _with_mentions(self, task: Task) -> Task:
        """A bare check with what later words say that it asks ("Check the window. If open, …", "… if any is …"), a
        search with where they say that it looks ("Open the drawer and look for the pen. If it is there, …")."""
        if task.type == "searching" and task.argument("location", "source") is None:
            where = self._mentioned_place(task)
            return task if where is None else replace(task, arguments=(*task.arguments, where))
        if task.type != "check_state" or not self._wording.is_bare_check(task):
            return task
        asked, said = task.argument("state"), task.argument("object")
        if asked is not None and said is not None and self._wording.is_of_any(asked):
            one_of = replace(said, value=f"any of {said.value}", span=None)
            task = replace(task, arguments=(*(a for a in task.arguments if a is not said), one_of))
        for mention in self._mentions.get(task.id, ()):
            word = mention.span.of(self._instruction.text)
            is_state = self._wording.is_state(mention)
            state = mention.argument("state") or (Argument("state", word) if is_state else None)
            if state is not None and task.argument("state", "location") is None:
                task = replace(task, arguments=(*task.arguments, state))
            said = mention.argument("object")
            if said is not None and self._picks_of(said, task.values("object")):
                task = replace(task, arguments=(*(a for a in task.arguments if a.type != "object"), said))
        return task

    def _picks_of(self, said: Argument, values: Sequence[str]) -> bool:
        """Whether a mention asks of one or some of what is checked: of the lamps, "if *one* (of them) is on"."""
        whole = said.value.lower().removeprefix("one of ")
        if [value.lower() for value in values] != [whole]:
            return False
        return whole != said.value.lower() or bool(picked_words(said, self._instruction.text, self._domain))

    def _mentioned_place(self, task: Task) -> Argument | None:
        """Where later mentions of a search say that it looks."""
        mentions = (m for m in self._mentions.get(task.id, ()) if m.type in FINDING_OUT)
        places = (place for m in mentions if (place := m.argument("location")) is not None)
        return next((place for place in places if not self._wording.is_presence(place.value)), None)

    def _answer(self, task: Task, argument: str, question: str) -> str:
        missing = next((m for m in self._instruction.missing if (m.task, m.argument) == (task.id, argument)), None)
        missing = missing or Missing(task.id, argument, question)
        answer = self.ask(missing) if self.ask is not None else None
        if not answer:
            raise MissingArgumentError(missing)
        return answer
