"""An annotation that comes from outside, held to the rules of the corpus; what all formats share."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

from decomplex_bt.corpus import check_tasks
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Instruction, Span, Task


def annotated(text: str, tasks: Sequence[Task], flow: Any, ontology: Ontology) -> Instruction:
    """The instruction of these tasks and this flow (JSON form).

    Raises `InputError` where a type is unknown, a span is empty, out of the text or overlaps another one, tasks are not
    numbered in order of appearance, or the flow does not hold every task once.
    """
    for task in tasks:
        if task.type not in ontology.task_types:
            raise InputError(f"unknown task type {task.type!r}; known types: {', '.join(ontology.task_types)}")
        for argument in task.arguments:
            if argument.type not in ontology.argument_types:
                known = ", ".join(ontology.argument_types)
                raise InputError(f"unknown argument type {argument.type!r}; known types: {known}")
    _check_spans(text, [task.span for task in tasks] + [a.span for t in tasks for a in t.arguments if a.span])
    check_tasks(tasks, text)
    return Instruction(text, tuple(tasks), Flow.from_json(flow, task_count=len(tasks)))


def with_implied(tasks: Sequence[Task], implied: Any) -> list[Task]:
    """The tasks with their implied arguments before the others; `implied` is read from JSON.

    Raises `InputError` where it is no mapping of task numbers to mappings of types to values, or a task does not exist.
    """
    if not isinstance(implied, Mapping):
        raise InputError(f"implied: expected an object of task numbers, got {implied!r}")
    added: dict[int, list[Argument]] = {}
    for key, values in implied.items():
        if not str(key).isdigit() or int(key) not in {task.id for task in tasks}:
            raise InputError(f"implied: there is no task {key!r}")
        if not isinstance(values, Mapping) or not all(isinstance(value, str) for value in values.values()):
            raise InputError(f"implied.{key}: expected an object of argument types and values, got {values!r}")
        added[int(key)] = [Argument(kind, value) for kind, value in values.items()]
    return [replace(task, arguments=(*added.get(task.id, ()), *task.arguments)) for task in tasks]


def implied_of(instruction: Instruction) -> dict[int, dict[str, str]]:
    """The arguments without words. Raises `InputError` for two of one type at one task, which only JSON Lines says."""
    implied: dict[int, dict[str, str]] = {}
    for task in instruction.tasks:
        for argument in task.arguments:
            if argument.span is None:
                values = implied.setdefault(task.id, {})
                if argument.type in values:
                    raise InputError(
                        f"task {task.id} has two implied arguments of type {argument.type}; only jsonl can say that"
                    )
                values[argument.type] = argument.value
    return implied


def check_dependency(instruction: Instruction, given: Mapping[int, str]) -> None:
    """Raises `InputError` where the label given for a task is not the one that follows from the flow."""
    labels = instruction.flow.dependencies()
    for number, label in given.items():
        if labels.get(number) != label:
            raise InputError(
                f"task {number} is said to be {label!r}, but by the flow it is {labels.get(number)!r}; mend either"
            )


def read_text(path: Path) -> str:
    """The text of a UTF-8 file, line ends as they are. Raises `DataFileError`."""
    try:
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise DataFileError(path, f"not valid UTF-8 at byte {error.start}; save the file as UTF-8") from None
    except OSError as error:
        raise DataFileError(path, f"cannot be read: {error.strerror}") from None


def from_json(value: str, name: str) -> Any:
    """A value from its JSON form. Raises `InputError` with `name`, also for half a character, which JSON can write and
    no file holds."""
    try:
        found = json.loads(value)
        json.dumps(found, ensure_ascii=False).encode("utf-8")
        return found
    except UnicodeEncodeError as error:
        half = error.object[error.start]
        raise InputError(
            f"{name} holds {half!r}, half of a character beyond U+FFFF without the other; write the whole character"
        ) from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"{name} is not valid JSON: {error}") from None


def to_json(value: Any) -> str:
    """A value as JSON on one line, whatever a reader takes for the end of a line."""
    text = json.dumps(value, ensure_ascii=False)
    return "".join(f"\\u{ord(c):04x}" if c in "\x7f\x85\u2028\u2029" else c for c in text)


def _check_spans(text: str, spans: Sequence[Span]) -> None:
    for span in spans:
        words = span.of(text)
        if not 0 <= span.start < span.end <= len(text):
            raise InputError(f"the span {span.start} to {span.end} is empty or not in the text of {len(text)}")
        if words != words.strip():
            raise InputError(f"the span {words!r} starts or ends with a space")
    for one, other in pairwise(sorted(spans)):
        if other.start < one.end:
            raise InputError(f"the spans {one.of(text)!r} and {other.of(text)!r} overlap; a word has one label")
