"""An understood instruction: its tasks, their arguments and the control flow, as frozen values."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from decomplex_bt.errors import InputError, is_whole
from decomplex_bt.flow import Flow


@dataclass(frozen=True, slots=True, order=True)
class Span:
    """A stretch of the instruction's text in code points, `end` exclusive."""

    start: int
    end: int

    def of(self, text: str) -> str:
        return text[self.start : self.end]


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument of a task.

    `value` is the resolved text: the words themselves or, for a pronoun, "one", "there" or an ellipsis, the referent's
    noun phrase. `span` is None where the argument was inferred and has no words of its own. `confidence`: from 0 to 1.
    """

    type: str
    value: str
    span: Span | None = None
    confidence: float = 1.0


def in_text_order(arguments: Iterable[Argument]) -> tuple[Argument, ...]:
    """Arguments as a task has them: first those without words of their own, as they come, then the others as read."""
    return tuple(sorted(arguments, key=lambda a: -1 if a.span is None else a.span.start))


@dataclass(frozen=True, slots=True)
class Task:
    """One thing the robot is to do, check or find out.

    `id` numbers the tasks of an instruction from 1 in order of appearance; `span` is the one token that carries it.
    `confidence` is that of its type, `dependency_confidence` that of its place in the flow, both from 0 to 1.
    `repeats`: the number of the task whose verb it has, where it leaves its own unsaid ("bring me tea, or *coffee* if
    there is none"); else 0.
    """

    id: int
    type: str
    span: Span
    arguments: tuple[Argument, ...] = ()
    confidence: float = 1.0
    dependency_confidence: float = 1.0
    repeats: int = 0

    def values(self, argument_type: str) -> tuple[str, ...]:
        """The values of all arguments of this type, in order; empty if there is none."""
        return tuple(argument.value for argument in self.arguments if argument.type == argument_type)

    def value(self, argument_type: str) -> str | None:
        """The value of the first argument of this type, or None."""
        return next(iter(self.values(argument_type)), None)

    def argument(self, *types: str) -> Argument | None:
        """The first argument of the first of these types that there is, or None."""
        return next((argument for name in types for argument in self.arguments if argument.type == name), None)


@dataclass(frozen=True, slots=True)
class Missing:
    """A required argument that is nowhere to be found, with the question that asks for it."""

    task: int
    argument: str
    question: str


@dataclass(frozen=True, slots=True)
class Alternative:
    """Another control flow that the same tasks may have been meant with, and how likely that is (0 to 1)."""

    flow: Flow
    probability: float


@dataclass(frozen=True, slots=True)
class Choice:
    """One answer to a `Doubt`: its words, the flow that it means, and how likely that one was."""

    text: str
    flow: Flow
    probability: float


@dataclass(frozen=True, slots=True)
class Doubt:
    """A question that tells the likeliest flows of an instruction apart; it is about one task."""

    task: int
    question: str
    choices: tuple[Choice, ...]


@dataclass(frozen=True, slots=True)
class Instruction:
    """One instruction with all that was understood of it.

    `confidence`: how likely tasks and flow are right as a whole, from 0 to 1. `alternatives`: other flows of the same
    tasks, likeliest first.
    """

    text: str
    tasks: tuple[Task, ...] = ()
    flow: Flow = Flow()
    missing: tuple[Missing, ...] = ()
    warnings: tuple[str, ...] = ()
    confidence: float = 1.0
    alternatives: tuple[Alternative, ...] = ()

    def task(self, number: int) -> Task:
        """The task with this number. Raises `KeyError` if there is none."""
        for task in self.tasks:
            if task.id == number:
                return task
        raise KeyError(number)

    def verb_of(self, task: Task) -> Task:
        """The task that says this one's verb: itself, or the one whose verb it repeats without saying it."""
        return self.task(task.repeats) if task.repeats else task

    def surface(self, span: Span | None) -> str | None:
        return None if span is None else span.of(self.text)

    def phrase(self, number: int) -> str:
        """The task in a few words: its verb with its arguments' values, as in "find a pen on the table"."""
        from decomplex_bt.phrases import phrase_of

        return phrase_of(self, self.task(number))

    def to_json(self, *, alternatives: int | None = None) -> dict[str, Any]:
        """The object that `decomplex-bt parse --format json` prints; keys in that order.

        With `alternatives`, it also has how certain the flow and each task's place in it is, and at most that many
        other flows. Raises `InputError` for what is no number of flows.
        """
        if alternatives is not None and (not is_whole(alternatives) or alternatives < 0):
            raise InputError(f"alternatives is {alternatives!r}; expected a whole number from 0, or None")
        dependencies = self.flow.dependencies()
        tasks = [self._task_to_json(task, dependencies.get(task.id, "sequential")) for task in self.tasks]
        value = {
            "text": self.text,
            "tasks": tasks,
            "flow": self.flow.to_json(),
            "missing": [{"task": m.task, "argument": m.argument, "question": m.question} for m in self.missing],
            "warnings": list(self.warnings),
        }
        if alternatives is None:
            return value
        for told, task in zip(tasks, self.tasks, strict=True):
            told["dependency_confidence"] = round(task.dependency_confidence, 4)
        return value | {
            "confidence": round(self.confidence, 4),
            "alternatives": [
                {"flow": other.flow.to_json(), "probability": round(other.probability, 4)}
                for other in self.alternatives[:alternatives]
            ],
        }

    def describe(self, flow: Flow) -> str:
        """A control flow of these tasks in lines, each task with its type and its words."""
        return flow.describe({task.id: escaped(f"{task.type}: {self.phrase(task.id)}") for task in self.tasks})

    def __str__(self) -> str:
        return self.describe(self.flow)

    def _task_to_json(self, task: Task, dependency: str) -> dict[str, Any]:
        return {
            "id": task.id,
            "type": task.type,
            "start": task.span.start,
            "end": task.span.end,
            "surface": task.span.of(self.text),
            **({"repeats": task.repeats} if task.repeats else {}),
            "dependency": dependency,
            "confidence": round(task.confidence, 4),
            "arguments": [
                {
                    "type": argument.type,
                    "start": argument.span.start if argument.span else None,
                    "end": argument.span.end if argument.span else None,
                    "surface": self.surface(argument.span),
                    "value": argument.value,
                    "confidence": round(argument.confidence, 4),
                }
                for argument in task.arguments
            ],
        }


def escaped(text: str) -> str:
    """The text on one line, with line breaks and what no terminal should get raw written out, as in `\\n`."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in text)


def check_instruction(instruction: Instruction) -> Instruction:
    """The instruction, whoever made it. Raises `InputError` where its parts do not fit each other: tasks that are not
    numbered from 1, each once, words outside its text, a flow without one of the tasks or with others."""
    if not isinstance(instruction.text, str) or not isinstance(instruction.flow, Flow):
        raise InputError(
            f"no instruction: text {instruction.text!r}, flow {instruction.flow!r}; expected a str, a Flow"
        )
    numbers = [task.id for task in instruction.tasks]
    if sorted(numbers) != list(range(1, len(numbers) + 1)):
        raise InputError(f"the tasks have the numbers {numbers}; expected each from 1 to {len(numbers)} once")
    for task in instruction.tasks:
        for span in (task.span, *(argument.span for argument in task.arguments if argument.span is not None)):
            if not 0 <= span.start < span.end <= len(instruction.text):
                raise InputError(
                    f"task {task.id}: no words of the text at {span.start} to {span.end}; it has "
                    f"{len(instruction.text)} characters"
                )
        if task.repeats and task.repeats not in numbers:
            raise InputError(f"task {task.id} repeats the verb of task {task.repeats}, which there is not")
    if any(not node.tasks for node, _ in instruction.flow.walk()):
        raise InputError("flow: a node without a task; expected one or more task numbers")
    Flow.from_json(instruction.flow.to_json(), task_count=len(numbers))
    return instruction
