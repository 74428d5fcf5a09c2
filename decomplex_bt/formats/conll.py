"""CoNLL: a token a line with its task, its argument label in BIO, the argument's owner and the task's dependency.

Comment lines (`# key = JSON`) carry what columns cannot: id, text, flow, implied arguments, and the referents of
arguments by the number of their first token (from 1). A blank line ends an instruction. Tokens are stretches of
letters and digits or single other signs, cut where a span begins or ends; a task is always one token.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

from decomplex_bt.corpus import Example
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.errors import DataFileError, InputError
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

COLUMNS = ("TOKEN", "TASK", "ARGUMENT", "OWNER", "DEPENDENCY")
OUTSIDE, NONE = "O", "_"
_HEADER = f"# global.columns = {' '.join(COLUMNS)}"
_TOKEN = re.compile(r"\w+|[^\w\s]")
_KEYS = ("id", "text", "flow", "implied", "referents", "source", "note")


def read_conll(path: Path, ontology: Ontology) -> tuple[Example, ...]:
    """The examples of a file. Raises `DataFileError` at the first fault, with the line where the instruction begins."""
    examples: dict[str, Example] = {}
    for number, lines in _blocks(read_text(path)):
        try:
            example = _example(lines, path.stem, ontology)
        except InputError as error:
            raise DataFileError(path, str(error), line=number) from None
        if example.id in examples:
            raise DataFileError(path, f"example {example.id!r}: this id stands twice", line=number)
        examples[example.id] = example
    return tuple(examples.values())


def write_conll(examples: Sequence[Example]) -> str:
    """The text of a file, which reads back as the same examples. Raises `InputError` where CoNLL cannot say it."""
    return "\n".join([_HEADER, *("\n".join((*_lines(example), "")) for example in examples)])


def _lines(example: Example) -> Iterator[str]:
    instruction = example.instruction
    tokens = tokens_of(instruction)
    place = {token.start: number for number, token in enumerate(tokens, start=1)}
    referents = {
        place[argument.span.start]: argument.value
        for task in instruction.tasks
        for argument in task.arguments
        if argument.span is not None and argument.value != argument.span.of(instruction.text)
    }
    values: dict[str, Any] = {"id": example.id, "text": instruction.text, "flow": instruction.flow.to_json()}
    optional = {
        "implied": implied_of(instruction),
        "referents": referents,
        "source": example.source,
        "note": example.note,
    }
    values |= {key: value for key, value in optional.items() if value}
    for key, value in values.items():
        yield f"# {key} = {to_json(value)}"
    rows = {token: [token.of(instruction.text), OUTSIDE, OUTSIDE, NONE, NONE] for token in tokens}
    dependencies = instruction.flow.dependencies()
    for task in instruction.tasks:
        rows[task.span][1], rows[task.span][4] = task.type, dependencies[task.id]
        for argument in task.arguments:
            for token in tokens if argument.span else ():
                if argument.span and argument.span.start <= token.start < argument.span.end:
                    begins = "B" if token.start == argument.span.start else "I"
                    rows[token][2:4] = [f"{begins}-{argument.type}", str(task.id)]
    for token in tokens:
        yield "\t".join(rows[token])


def tokens_of(instruction: Instruction) -> tuple[Span, ...]:
    """The tokens, cut where a span begins or ends; a task's span is one of them."""
    text = instruction.text
    tasks = {task.span for task in instruction.tasks}
    spans = tasks | {a.span for task in instruction.tasks for a in task.arguments if a.span is not None}
    cuts = sorted({0, len(text), *(end for span in spans for end in (span.start, span.end))})
    tokens: list[Span] = []
    for start, end in pairwise(cuts):
        if Span(start, end) in tasks:
            tokens.append(Span(start, end))
        else:
            tokens.extend(Span(*match.span()) for match in _TOKEN.finditer(text, start, end))
    return tuple(tokens)


def _blocks(text: str) -> Iterator[tuple[int, list[str]]]:
    """The lines of every instruction with the number of the first one."""
    block: list[str] = []
    lines = [line.removesuffix("\r") for line in text.split("\n")]
    for number, line in enumerate((*lines, ""), start=1):
        if line and not line.startswith("# global."):
            block.append(line)
        elif not line and block:
            yield number - len(block), block
            block = []


def _example(lines: Sequence[str], voice: str, ontology: Ontology) -> Example:
    values: dict[str, Any] = {}
    rows: list[list[str]] = []
    for line in lines:
        if line.startswith("# "):
            key, _, value = line[2:].partition(" = ")
            if key not in _KEYS:
                raise InputError(f"unknown comment {key!r}; known: {', '.join(_KEYS)}")
            values[key] = from_json(value, key)
        else:
            rows.append(line.split("\t"))
            if len(rows[-1]) != len(COLUMNS):
                raise InputError(
                    f"expected {len(COLUMNS)} columns ({', '.join(COLUMNS)}) with tabs between, got {line!r}"
                )
    for key in ("id", "text"):
        if not isinstance(values.get(key), str):
            raise InputError(f"the comment '# {key} = \"...\"' is missing")
    text = values["text"]
    spans = _aligned(text, [row[0] for row in rows])
    tasks = _tasks(text, spans, rows, values.get("referents", {}))
    instruction = annotated(text, with_implied(tasks, values.get("implied", {})), values.get("flow", []), ontology)
    carriers = [row for row in rows if row[1] != OUTSIDE]
    check_dependency(instruction, {n: row[4] for n, row in enumerate(carriers, start=1) if row[4] != NONE})
    return Example(values["id"], instruction, voice, values.get("source", ""), values.get("note", ""))


def _aligned(text: str, tokens: Sequence[str]) -> list[Span]:
    spans, position = [], 0
    for token in tokens:
        start = text.find(token, position)
        if start < 0 or text[position:start].strip() or not token:
            raise InputError(f"the token {token!r} does not follow in the text after {text[:position][-20:]!r}")
        position = start + len(token)
        spans.append(Span(start, position))
    if text[position:].strip():
        raise InputError(f"no token covers {text[position:].strip()[:20]!r}")
    return spans


def _tasks(text: str, spans: Sequence[Span], rows: Sequence[Sequence[str]], referents: Any) -> list[Task]:
    carriers = [k for k, row in enumerate(rows) if row[1] != OUTSIDE]
    tasks = {n: Task(n, rows[k][1], spans[k]) for n, k in enumerate(carriers, start=1)}
    if not isinstance(referents, Mapping):
        raise InputError(f"referents: expected an object of token numbers, got {referents!r}")
    unused = dict(referents)
    for first, last, kind, owner in _chunks(rows):
        if not owner.isdigit() or int(owner) not in tasks:
            raise InputError(f"the owner {owner!r} of {rows[first][0]!r} is no task; the tasks are 1 to {len(tasks)}")
        span = Span(spans[first].start, spans[last].end)
        value = unused.pop(str(first + 1), span.of(text))
        if not isinstance(value, str):
            raise InputError(f"referents.{first + 1}: expected a string, got {value!r}")
        task = tasks[int(owner)]
        tasks[task.id] = replace(task, arguments=(*task.arguments, Argument(kind, value, span)))
    if unused:
        raise InputError(f"referents: no argument begins at token {min(unused)}")
    return list(tasks.values())


def _chunks(rows: Sequence[Sequence[str]]) -> Iterator[tuple[int, int, str, str]]:
    """First token, last token, type and owner of every argument. Raises `InputError` where an I follows nothing."""
    first = None
    for k, row in enumerate(rows):
        prefix, _, kind = row[2].partition("-")
        if prefix not in ("B", "I", "O") or (prefix == "O") != (not kind):
            raise InputError(f"the argument label {row[2]!r} of {row[0]!r} is none of O, B-TYPE and I-TYPE")
        if prefix == "I" and (first is None or rows[k - 1][2][2:] != kind or rows[k - 1][3] != row[3]):
            raise InputError(f"{row[2]!r} of {row[0]!r} continues no argument; an argument begins with B")
        if prefix == "B":
            first = k
        elif prefix == "O":
            first = None
        if first is not None and (k + 1 == len(rows) or not rows[k + 1][2].startswith("I")):
            yield first, k, kind, row[3]
