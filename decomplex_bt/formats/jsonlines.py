"""JSON Lines: an object for each instruction, with the content of `parse --format json` but for the confidences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from decomplex_bt.corpus import Example
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.formats.annotation import annotated, check_dependency, from_json, read_text, to_json
from decomplex_bt.instruction import Argument, Missing, Span, Task

Value = TypeVar("Value")


def read_jsonlines(path: Path, ontology: Ontology) -> tuple[Example, ...]:
    """The examples of a file. What `parse --json` prints reads as well: confidences are passed over, and an instruction
    without an `id` gets its line's number for one.

    Raises `DataFileError` at the first fault, with the line.
    """
    examples: dict[str, Example] = {}
    for number, line in enumerate(read_text(path).split("\n"), start=1):
        if not line.strip():
            continue
        try:
            example = _example(from_json(line, "the line"), f"line-{number}", path.stem, ontology)
        except InputError as error:
            raise DataFileError(path, str(error), line=number) from None
        if example.id in examples:
            raise DataFileError(path, f"example {example.id!r}: this id stands twice", line=number)
        examples[example.id] = example
    return tuple(examples.values())


def write_jsonlines(examples: Sequence[Example]) -> str:
    """The text of a file, which reads back as the same examples."""
    return "".join(f"{to_json(_object(example))}\n" for example in examples)


def _object(example: Example) -> dict[str, Any]:
    printed = example.instruction.to_json()
    for task in printed["tasks"]:
        for marked in (task, *task["arguments"]):
            del marked["confidence"]
    more = {key: value for key, value in (("source", example.source), ("note", example.note)) if value}
    return {"id": example.id, **printed, **more}


def _example(value: Any, default_id: str, voice: str, ontology: Ontology) -> Example:
    if not isinstance(value, Mapping):
        raise InputError(f"expected an object, got {type(value).__name__}")
    unknown = set(value) - {"id", "text", "tasks", "flow", "missing", "warnings", "source", "note"}
    if unknown:
        raise InputError(f"unknown key {min(unknown)!r}")
    text = _get(value, "text", str)
    raw_tasks = [_mapping(task, "a task") for task in _get(value, "tasks", list)]
    tasks = [_task(task, text) for task in raw_tasks]
    instruction = annotated(text, tasks, _get(value, "flow", list), ontology)
    check_dependency(instruction, {t["id"]: t["dependency"] for t in raw_tasks if "dependency" in t})
    instruction = replace(
        instruction,
        missing=tuple(_missing(_mapping(entry, "missing")) for entry in _get(value, "missing", list, [])),
        warnings=tuple(_checked(entry, "a warning", str) for entry in _get(value, "warnings", list, [])),
    )
    return Example(
        _get(value, "id", str, default_id),
        instruction,
        voice,
        _get(value, "source", str, ""),
        _get(value, "note", str, ""),
    )


def _task(value: Mapping[str, Any], text: str) -> Task:
    arguments = tuple(_argument(_mapping(a, "an argument"), text) for a in _get(value, "arguments", list, []))
    return Task(_get(value, "id", int), _get(value, "type", str), _span(value, text), arguments)


def _argument(value: Mapping[str, Any], text: str) -> Argument:
    span = None if value.get("start") is None else _span(value, text)
    return Argument(_get(value, "type", str), _get(value, "value", str, None if span is None else span.of(text)), span)


def _span(value: Mapping[str, Any], text: str) -> Span:
    span = Span(_get(value, "start", int), _get(value, "end", int))
    surface = value.get("surface", span.of(text))
    if span.of(text) != surface:
        raise InputError(f"the characters {span.start} to {span.end} are {span.of(text)!r}, not {surface!r}")
    return span


def _missing(value: Mapping[str, Any]) -> Missing:
    return Missing(_get(value, "task", int), _get(value, "argument", str), _get(value, "question", str))


def _mapping(value: Any, name: str) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise InputError(f"{name}: expected an object, got {value!r}")
    return value


def _get(value: Mapping[str, Any], key: str, kind: type[Value], default: Value | None = None) -> Value:
    if key not in value and default is None:
        raise InputError(f"the key {key!r} is missing")
    return _checked(value.get(key, default), key, kind)


def _checked(value: Any, name: str, kind: type[Value]) -> Value:
    if not isinstance(value, kind) or isinstance(value, bool):
        raise InputError(f"{name}: expected {kind.__name__}, got {value!r}")
    return value
