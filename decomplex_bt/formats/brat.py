"""BRAT standoff: a text file with an instruction a line, and an annotation file beside it.

`instruction` marks the whole of each instruction; a note on it holds, as JSON, id, flow, implied arguments, source and
remark. Tasks and arguments are spans named after their types, an argument's owner is the relation `owner`, its referent
a note with the referent as JSON, a task's dependency an attribute (it follows from the flow).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from decomplex_bt.corpus import Example
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.flow import DEPENDENCIES
from decomplex_bt.formats.annotation import (
    annotated,
    check_dependency,
    from_json,
    implied_of,
    read_text,
    to_json,
    with_implied,
)
from decomplex_bt.instruction import Argument, Instruction, Span, Task

INSTRUCTION = "instruction"
OWNER = "owner"
DEPENDENCY = "dependency"
NOTE = "AnnotatorNotes"
_SPANS = re.compile(r"\d+ \d+(;\d+ \d+)*")


def configuration(ontology: Ontology) -> str:
    """What BRAT reads as `annotation.conf` beside the files."""
    types = [INSTRUCTION, *ontology.task_types, *ontology.argument_types]
    tasks, arguments = "|".join(ontology.task_types), "|".join(ontology.argument_types)
    return "\n".join(
        [
            "[entities]", *types, "",
            "[relations]", f"{OWNER}\tArg1:{arguments}, Arg2:{tasks}",
            "<OVERLAP>\tArg1:<ENTITY>, Arg2:<ENTITY>, <OVL-TYPE>:<ANY>", "",
            "[events]", "",
            "[attributes]", f"{DEPENDENCY}\tArg:{tasks}, Value:{'|'.join(DEPENDENCIES)}", "",
        ]
    )  # fmt: skip


def read_brat(path: Path, ontology: Ontology) -> tuple[Example, ...]:
    """The examples of a document, by either of its two files. Raises `DataFileError` at the first fault."""
    document = read_text(path.with_suffix(".txt"))
    annotations = path.with_suffix(".ann")
    marks = _Marks()
    for number, line in enumerate(read_text(annotations).split("\n"), start=1):
        try:
            marks.add(line, document)
        except InputError as error:
            raise DataFileError(annotations, str(error), line=number) from None
    examples: dict[str, Example] = {}
    for key, whole in sorted(marks.spans.items(), key=lambda item: item[1].span):
        if whole.type == INSTRUCTION:
            try:
                example = _example(key, whole.span, marks, document, path.stem, ontology)
            except InputError as error:
                raise DataFileError(annotations, f"instruction {key}: {error}") from None
            if example.id in examples:
                raise DataFileError(annotations, f"instruction {key}: the id {example.id!r} stands twice")
            examples[example.id] = example
    stray = sorted(marks.spans.keys() - marks.used)
    if stray:
        raise DataFileError(annotations, f"{stray[0]} lies in no {INSTRUCTION}")
    return tuple(examples.values())


def write_brat(examples: Sequence[Example]) -> dict[str, str]:
    """The texts of both files by suffix, which read back as the same examples. Raises `InputError` where BRAT cannot
    say it."""
    texts: list[str] = []
    lines: list[str] = []
    counts = dict.fromkeys("TRA#", 0)

    def add(kind: str, rest: str) -> str:
        counts[kind] += 1
        lines.append(f"{kind}{counts[kind]}\t{rest}")
        return f"{kind}{counts[kind]}"

    position = 0
    for example in examples:
        text = example.instruction.text
        if not text or text != text.strip("\r\n\ufeff"):
            raise InputError(
                f"example {example.id!r} is empty, or begins or ends with a line break or a byte order mark; not so in "
                "BRAT"
            )
        key = add("T", f"{INSTRUCTION} {_fragments(text, position)}\t{_shown(text)}")
        add("#", f"{NOTE} {key}\t{to_json(_note(example))}")
        _write_tasks(example.instruction, position, add)
        texts.append(text)
        position += len(text) + 1
    return {".txt": "".join(f"{text}\n" for text in texts), ".ann": "".join(f"{line}\n" for line in lines)}


def _write_tasks(instruction: Instruction, position: int, add: Any) -> None:
    def mark(kind: str, span: Span) -> str:
        words = span.of(instruction.text)
        return str(add("T", f"{kind} {_fragments(words, position + span.start)}\t{_shown(words)}"))

    dependencies = instruction.flow.dependencies()
    for task in instruction.tasks:
        carrier = mark(task.type, task.span)
        add("A", f"{DEPENDENCY} {carrier} {dependencies[task.id]}")
        for argument in task.arguments:
            if argument.span is not None:
                key = mark(argument.type, argument.span)
                add("R", f"{OWNER} Arg1:{key} Arg2:{carrier}")
                if argument.value != argument.span.of(instruction.text):
                    add("#", f"{NOTE} {key}\t{to_json(argument.value)}")


def _note(example: Example) -> dict[str, Any]:
    optional = {"implied": implied_of(example.instruction), "source": example.source, "note": example.note}
    return {
        "id": example.id,
        "flow": example.instruction.flow.to_json(),
        **{key: value for key, value in optional.items() if value},
    }


def _fragments(words: str, start: int) -> str:
    """The offsets of a span; one that runs over line ends is discontinuous, a fragment a line."""
    parts = []
    for line in words.split("\n"):
        if line:
            parts.append(f"{start} {start + len(line)}")
        start += len(line) + 1
    return ";".join(parts)


def _shown(words: str) -> str:
    return " ".join(line for line in words.split("\n") if line)


@dataclass(frozen=True, slots=True)
class _Mark:
    type: str
    span: Span


@dataclass(slots=True)
class _Marks:
    """What an annotation file says, by key."""

    spans: dict[str, _Mark] = field(default_factory=dict)
    owners: dict[str, str] = field(default_factory=dict)
    notes: dict[str, Any] = field(default_factory=dict)
    dependencies: dict[str, str] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)

    def add(self, line: str, document: str) -> None:
        """Takes in a line. Raises `InputError`."""
        if not line.strip():
            return
        key, _, rest = line.removesuffix("\r").partition("\t")
        head, _, tail = rest.partition("\t")
        words = head.split(" ")
        if key.startswith("T"):
            self.spans[key] = _mark(head, tail, document)
        elif key.startswith("R") and len(words) == 3 and words[0] == OWNER:
            self.owners[_key(words[1], "Arg1:")] = _key(words[2], "Arg2:")
        elif key.startswith("A") and len(words) == 3 and words[0] == DEPENDENCY:
            self.dependencies[words[1]] = words[2]
        elif key.startswith("#") and len(words) == 2 and words[0] == NOTE:
            self.notes[words[1]] = from_json(tail, f"the note on {words[1]}")
        else:
            raise InputError(f"{line[:40]!r} is none of: T with type and offsets, R {OWNER}, A {DEPENDENCY}, # {NOTE}")


def _mark(head: str, shown: str, document: str) -> _Mark:
    kind, _, offsets = head.partition(" ")
    if not _SPANS.fullmatch(offsets):
        raise InputError(f"the offsets {offsets!r} of {kind!r} are not of the form START END or START END;START END")
    numbers = [int(number) for pair in offsets.split(";") for number in pair.split(" ")]
    span = Span(numbers[0], numbers[-1])
    if _shown(span.of(document)) != shown:
        raise InputError(f"the characters {span.start} to {span.end} are {_shown(span.of(document))!r}, not {shown!r}")
    return _Mark(kind, span)


def _key(word: str, prefix: str) -> str:
    if not word.startswith(prefix):
        raise InputError(f"expected {prefix}KEY, got {word!r}")
    return word.removeprefix(prefix)


def _example(key: str, whole: Span, marks: _Marks, document: str, voice: str, ontology: Ontology) -> Example:
    note = marks.notes.get(key)
    if not isinstance(note, Mapping) or not isinstance(note.get("id"), str):
        raise InputError("its note with id and flow is missing")
    text = whole.of(document)
    inside = {
        k: _Mark(m.type, Span(m.span.start - whole.start, m.span.end - whole.start))
        for k, m in sorted(marks.spans.items(), key=lambda item: item[1].span)
        if k != key and m.type != INSTRUCTION and whole.start <= m.span.start and m.span.end <= whole.end
    }
    marks.used |= {key, *inside}
    carriers = [k for k, mark in inside.items() if mark.type in ontology.task_types]
    tasks = {k: Task(n, inside[k].type, inside[k].span) for n, k in enumerate(carriers, start=1)}
    for k, argument in _arguments(inside, tasks, marks, text):
        tasks[k] = replace(tasks[k], arguments=(*tasks[k].arguments, argument))
    complete = with_implied(list(tasks.values()), note.get("implied", {}))
    instruction = annotated(text, complete, note.get("flow", []), ontology)
    check_dependency(instruction, {tasks[k].id: marks.dependencies[k] for k in tasks if k in marks.dependencies})
    return Example(note["id"], instruction, voice, str(note.get("source", "")), str(note.get("note", "")))


def _arguments(
    inside: Mapping[str, _Mark], tasks: Mapping[str, Task], marks: _Marks, text: str
) -> Iterator[tuple[str, Argument]]:
    for k, mark in inside.items():
        if k in tasks:
            continue
        owner = marks.owners.get(k)
        if owner is None or owner not in tasks:
            raise InputError(f"{k} ({mark.span.of(text)!r}) is owned by no task of the instruction")
        value = marks.notes.get(k, mark.span.of(text))
        if not isinstance(value, str):
            raise InputError(f"the note on {k}: expected the referent as a JSON string, got {value!r}")
        yield owner, Argument(mark.type, value, mark.span)
