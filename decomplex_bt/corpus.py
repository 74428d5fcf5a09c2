"""Annotated instructions: reading and writing the inline YAML format, with errors that name file, line and example."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from pydantic import ConfigDict

from decomplex_bt.domain.document import Record, check_record, item_lines, load_yaml
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.errors import DataFileError, InputError, among
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Instruction, Span, Task

VOICES_FILE = "voices.yaml"
SECOND_ANNOTATION = "second_annotation"
"""Folder beside the voices with another annotator's reading of some of their instructions, under the same ids."""
Split = Literal["train", "development", "test"]


@dataclass(frozen=True, slots=True)
class Example:
    """One annotated instruction of a corpus; `voice` is the stem of its file."""

    id: str
    instruction: Instruction
    voice: str = ""
    source: str = ""
    note: str = ""


@dataclass(frozen=True, slots=True)
class Voice:
    """Whose words a file holds, and which split the whole file belongs to."""

    name: str
    description: str
    split: Split


class _RawExample(Record):
    model_config = ConfigDict(frozen=True, extra="forbid", strict=True)

    id: str
    text: str
    flow: list[Any]
    implied: dict[int, dict[str, str]] = {}
    source: str = ""
    note: str = ""


class _RawVoice(Record):
    description: str
    split: Split


class _RawVoices(Record):
    voices: dict[str, _RawVoice]


def read_corpus(path: str | Path, ontology: Ontology) -> tuple[Example, ...]:
    """All examples of a corpus file, or of every `*.yaml` in a folder (sorted by name, `voices.yaml` left out).

    Raises `DataFileError` at the first fault, naming file, line and example, and `InputError` for what is no path.
    """
    if not isinstance(path, str | Path):
        raise InputError(f"path is {path!r}; expected a corpus file, or a folder of them")
    path = Path(path)
    if path.is_dir():
        files = sorted(file for file in path.glob("*.yaml") if file.name != VOICES_FILE)
        if not files:
            raise DataFileError(path, "the folder holds no corpus file (*.yaml)")
        return tuple(example for file in files for example in read_corpus(file, ontology))
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise DataFileError(path, f"not valid UTF-8 at byte {error.start}; save the file as UTF-8") from None
    except OSError as error:
        raise DataFileError(path, f"cannot be read: {error.strerror}") from None
    return parse_corpus(text, ontology, path=path)


def parse_corpus(text: str, ontology: Ontology, *, path: str | Path = "<text>") -> tuple[Example, ...]:
    """As `read_corpus` for one file's text; `path` serves for messages and, by its stem, as the voice."""
    items = load_yaml(text, path)
    if items is None:
        raise DataFileError(path, "the file is empty; expected a list of examples, each with id, text and flow")
    if not isinstance(items, list):
        raise DataFileError(path, f"expected a list of examples, got {type(items).__name__}")
    examples: dict[str, Example] = {}
    for item, line in zip(items, item_lines(text), strict=True):
        raw = check_record(item, _RawExample, path, line=line)
        if raw.id in examples:
            raise DataFileError(path, f"example {raw.id!r}: this id stands twice", line=line)
        try:
            instruction = read_markup(raw.text, ontology, flow=raw.flow, implied=raw.implied)
        except InputError as error:
            raise DataFileError(path, f"example {raw.id!r}: {error}", line=line) from None
        examples[raw.id] = Example(raw.id, instruction, Path(path).stem, raw.source, raw.note)
    return tuple(examples.values())


def read_voices(folder: Path) -> dict[str, Voice]:
    """The voices of a corpus folder by file stem, from its `voices.yaml`. Raises `DataFileError`."""
    from decomplex_bt.domain.document import read_record

    raw = read_record(folder / VOICES_FILE, _RawVoices)
    for name in raw.voices:
        if not (folder / f"{name}.yaml").is_file():
            raise DataFileError(folder / VOICES_FILE, f"voices.{name}: there is no file {name}.yaml")
    return {name: Voice(name, voice.description, voice.split) for name, voice in raw.voices.items()}


def read_split(folder: Path, ontology: Ontology, *splits: Split) -> tuple[Example, ...]:
    """The examples of all voices of these splits, in the order of `voices.yaml`."""
    voices = read_voices(folder)
    names = [name for name, voice in voices.items() if voice.split in splits]
    return tuple(example for name in names for example in read_corpus(folder / f"{name}.yaml", ontology))


_MARK = re.compile(
    r"(?<!\\)\[(?P<surface>(?:\\.|[^\[\]\\])*)\]\((?P<task>\d+):(?P<label>[a-z_]+)(?:=(?P<referent>(?:\\.|[^)\\])+))?\)"
)
_ESCAPE = re.compile(r"\\([\[\]()\\])")


def read_markup(
    marked: str,
    ontology: Ontology,
    *,
    flow: Any,
    implied: Mapping[int, Mapping[str, str]] | None = None,
) -> Instruction:
    """The instruction that a marked text with its flow says (`[surface](TASK:LABEL=referent)`).

    Raises `InputError` where a mark, a label, a task number or the flow is wrong.
    """
    text, marks = _strip_marks(marked)
    if not text.strip():
        raise InputError("the text is empty; expected an instruction")
    tasks: dict[int, Task] = {}
    arguments: dict[int, list[Argument]] = defaultdict(list)
    for number, label, referent, span in marks:
        if label in ontology.task_types:
            if number in tasks:
                raise InputError(f"task {number} is marked twice, at {span.of(text)!r}; a task is one token")
            if referent is not None:
                raise InputError(f"task {number} ({span.of(text)!r}) has a referent; only an argument can")
            tasks[number] = Task(number, label, span)
        elif label in ontology.argument_types:
            arguments[number].append(Argument(label, referent if referent is not None else span.of(text), span))
        else:
            known = ", ".join([*ontology.task_types, *ontology.argument_types])
            raise InputError(f"unknown label {label!r} at {span.of(text)!r}; known labels: {known}")
    check_tasks(tasks.values(), text)
    implied = implied or {}
    for number in [*arguments, *implied]:
        if number not in tasks:
            raise InputError(f"an argument belongs to task {number}, but no token is marked as task {number}")
    complete = tuple(
        replace(task, arguments=(*_implied(implied.get(number, {}), ontology, number), *arguments[number]))
        for number, task in sorted(tasks.items())
    )
    return Instruction(text, complete, Flow.from_json(flow, task_count=len(complete)))


def write_markup(instruction: Instruction) -> str:
    """The inline form of an instruction's text: the inverse of `read_markup` for all that has a span."""
    marks: list[tuple[Span, str]] = []
    for task in instruction.tasks:
        marks.append((task.span, f"{task.id}:{task.type}"))
        for argument in task.arguments:
            if argument.span is None:
                continue
            is_referring = argument.value != argument.span.of(instruction.text)
            referent = "=" + argument.value.replace("\\", r"\\").replace(")", r"\)") if is_referring else ""
            marks.append((argument.span, f"{task.id}:{argument.type}{referent}"))
    parts, position = [], 0
    for span, label in sorted(marks):
        parts.append(_escape(instruction.text[position : span.start]))
        parts.append(f"[{_escape(span.of(instruction.text))}]({label})")
        position = span.end
    parts.append(_escape(instruction.text[position:]))
    return "".join(parts)


def _strip_marks(marked: str) -> tuple[str, list[tuple[int, str, str | None, Span]]]:
    """The plain text and, per mark: task number, label, referent, span in the plain text."""
    plain: list[str] = []
    length = position = 0
    marks: list[tuple[int, str, str | None, Span]] = []
    for match in _MARK.finditer(marked):
        length += _append(plain, _unmarked(marked[position : match.start()]))
        surface = _ESCAPE.sub(r"\1", match["surface"])
        if not surface or surface != surface.strip():
            raise InputError(f"the mark {match[0]!r} starts or ends with a space, or is empty")
        referent = _ESCAPE.sub(r"\1", match["referent"]) if match["referent"] else None
        marks.append((int(match["task"]), match["label"], referent, Span(length, length + len(surface))))
        length += _append(plain, surface)
        position = match.end()
    _append(plain, _unmarked(marked[position:]))
    return "".join(plain), marks


def _append(parts: list[str], text: str) -> int:
    parts.append(text)
    return len(text)


def _unmarked(text: str) -> str:
    stray = re.search(r"(?<!\\)[\[\]]", text)
    if stray:
        near = text[max(0, stray.start() - 10) : stray.start() + 20]
        raise InputError(f"stray {stray[0]!r} near {near!r}; write \\[ or \\] for a plain bracket")
    return _ESCAPE.sub(r"\1", text)


def _escape(text: str) -> str:
    return re.sub(r"([\[\]\\])", r"\\\1", text)


def check_tasks(tasks: Iterable[Task], text: str) -> None:
    """Raises `InputError` unless tasks are one token each and numbered from 1 in order of appearance."""
    in_order = sorted(tasks, key=lambda task: task.span)
    for expected, task in enumerate(in_order, start=1):
        if task.id != expected:
            raise InputError(
                f"tasks are numbered from 1 in order of appearance; {task.span.of(text)!r} is number {expected}, "
                f"not {task.id}"
            )
        if re.search(r"\s", task.span.of(text)):
            raise InputError(
                f"task {task.id} marks {task.span.of(text)!r}; a task is one token, the verb that carries it"
            )


def _implied(values: Mapping[str, str], ontology: Ontology, number: int) -> Iterator[Argument]:
    for argument_type, value in values.items():
        if argument_type not in ontology.argument_types:
            known = among(argument_type, ontology.argument_types)
            raise InputError(f"implied.{number}: unknown argument type {argument_type!r}{known}")
        yield Argument(argument_type, value)


_IMPERSONAL = re.compile(r"\bit(?:\s+also)?\W*\[|\bits\]|\]\s+(?:if\s+)?it\b", re.IGNORECASE)
"""The "it" of time and weather around a verb in brackets ("if it['s] raining"): it names nothing, is no argument."""
PRONOUNS = frozenset("it them one ones him her there that this these those they he she another".split())


def lint(examples: Sequence[Example], ontology: Ontology) -> Iterator[tuple[Example, str]]:
    """What is legal but deserves a second look: missing required arguments, and pronouns without a referent but for the
    "it" of a check."""
    defaults = {"bringing": {"recipient"}}
    for example in examples:
        instruction = example.instruction
        for task in instruction.tasks:
            for argument in task.arguments:
                is_impersonal = task.type == "check_state" and argument.value.lower() == "it"  # the weather, the day
                if argument.span and argument.value.lower() in PRONOUNS and not is_impersonal:
                    yield (
                        example,
                        f"task {task.id}: {argument.type} {argument.value!r} is a pronoun without a referent (=)",
                    )
            task_type = ontology.task_types[task.type]
            for argument in task.arguments:
                if argument.type not in task_type.arguments:
                    yield example, f"task {task.id} ({task.type}) rarely takes a {argument.type} ({argument.value!r})"
            has = {argument.type for argument in task.arguments} | defaults.get(task.type, set())
            if task.type in ("change_state", "check_state"):
                has |= {"state"}
            if task.type == "check_state" and _IMPERSONAL.search(_around(instruction.text, task.span)):
                has |= {"object"}
            for group in task_type.required:
                if not has & set(group):
                    yield (
                        example,
                        f"task {task.id} ({task.type}) has no {' or '.join(group)}, neither marked nor implied",
                    )


def _around(text: str, span: Span) -> str:
    """A span in brackets with what stands near it."""
    return f"{text[max(0, span.start - 12) : span.start]}[{span.of(text)}]{text[span.end : span.end + 12]}"
