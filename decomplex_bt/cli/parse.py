"""`decomplex-bt parse`: instructions, one a line, to what was understood of them."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, BinaryIO

import typer

from decomplex_bt.cli.options import DomainOption, EncoderOption, Format, JobsOption, JsonOption, chosen, domain_of
from decomplex_bt.cli.output import print_json, remark, track, use_utf8
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import escaped

if TYPE_CHECKING:
    from decomplex_bt.instruction import Instruction

SourceArgument = Annotated[
    str, typer.Argument(metavar="[FILE|-]", help="A file with an instruction a line; - reads standard input.")
]
LONGEST_LINE = 4 * 2_000 + 4
"""Bytes after which a line cannot be an instruction any more: four to a character at most, and its end."""


def parse(
    source: SourceArgument = "-",
    format: Annotated[
        Format | None,
        typer.Option("--format", "-f", help="How the result is printed.", show_default="text on a terminal, else json"),
    ] = None,
    json: JsonOption = False,
    alternatives: Annotated[
        int | None,
        typer.Option(min=0, metavar="N", help="Also tell how certain the control flow is, and at most N others."),
    ] = None,
    domain: DomainOption = "household",
    encoder: EncoderOption = None,
    jobs: JobsOption = 1,
) -> int:
    """Understand instructions, one a line: tasks, arguments and control flow.

    A line that cannot be an instruction is named on standard error; the others come out all the same, and the exit
    status is 2. With several processes nothing is printed before all lines are there.
    """
    use_utf8()
    layout = chosen(format, json, Format.text if sys.stdout.isatty() else Format.json)
    from decomplex_bt.understanding.interpreter import Interpreter

    with _open(source) as stream:
        interpreter = Interpreter.load(domain_of(domain), encoder=encoder)
        lines = _Lines(stream)
        is_typed = stream.isatty()
        understood = map(interpreter.interpret, lines) if is_typed else interpreter.interpret_batch(lines, jobs=jobs)
        for number, instruction in enumerate(track(understood, total=None, label="parsing")):
            _print(instruction, layout, alternatives, is_first=number == 0)
    if lines.count == 0:
        remark("no instruction was given; write one a line")
    return 2 if lines.has_errors else 0


class _Lines:
    """The usable lines of a stream as texts; what is wrong with the others goes to standard error."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self.count = 0
        self.has_errors = False

    def __iter__(self) -> Iterator[str]:
        from decomplex_bt.understanding.interpreter import check_text

        for raw in _raw_lines(self._stream):
            self.count = number = self.count + 1
            try:
                text = _decode(raw, is_first=number == 1)
                check_text(text)
            except InputError as error:
                remark(f"line {number}: {error}")
                self.has_errors = True
            else:
                yield text


def _raw_lines(stream: BinaryIO) -> Iterator[bytes]:
    """Lines without their ends, each cut off where it is too long to be an instruction. Raises `InputError`."""
    while raw := _read(stream, LONGEST_LINE):
        rest = raw
        while not rest.endswith(b"\n") and (rest := _read(stream, 1 << 16)):
            pass  # the rest of an endless line is read past, not kept
        yield raw.removesuffix(b"\n").removesuffix(b"\r")


def _read(stream: BinaryIO, size: int) -> bytes:
    try:
        return stream.readline(size)
    except OSError as error:
        raise _unreadable(stream.name, error) from None


def _decode(raw: bytes, *, is_first: bool) -> str:
    if len(raw) > LONGEST_LINE - 4:
        raise InputError(
            f"the instruction has over {LONGEST_LINE // 4 - 1:,} characters; expected at most 2,000; split it"
        )
    try:
        return raw.decode("utf-8-sig" if is_first else "utf-8")
    except UnicodeDecodeError as error:
        raise InputError(
            f"not valid UTF-8: byte 0x{raw[error.start]:02x} at position {error.start}; save the text as UTF-8"
        ) from None


@contextmanager
def _open(source: str) -> Iterator[BinaryIO]:
    if source == "-":
        if sys.stdin is None:
            raise InputError("standard input is closed; give a file, or an instruction: echo TEXT | decomplex-bt parse")
        yield sys.stdin.buffer
        return
    if not source.strip():
        raise InputError(f"{source!r} names no file; give one, or - for standard input")
    try:
        stream = Path(source).open("rb")  # noqa: SIM115 - an error of whoever uses it is none of opening it
    except OSError as error:
        raise _unreadable(source, error) from None
    with stream:
        yield stream


def _unreadable(source: str, error: OSError) -> InputError:
    if " " in source and isinstance(error, FileNotFoundError):
        how = f"give an instruction on standard input: echo {shlex.quote(source)} | decomplex-bt parse"
    else:
        how = "give a file, or - for standard input"
    return InputError(f"{source}: cannot be read: {error.strerror}; {how}")


def _print(instruction: Instruction, format: Format, alternatives: int | None, *, is_first: bool) -> None:
    if format is Format.json:
        print_json(instruction.to_json(alternatives=alternatives))
        return
    lines = [] if is_first else [""]
    lines += [escaped(instruction.text), *(f"  {line}" for line in str(instruction).splitlines())]
    if alternatives is not None:
        lines += [f"  {line}" for line in _certainty(instruction, alternatives)]
    lines += [f"  missing: task {m.task} lacks its {m.argument}: {m.question}" for m in instruction.missing]
    lines += [f"  warning: {escaped(warning)}" for warning in instruction.warnings]
    print("\n".join(lines), flush=True)


def _certainty(instruction: Instruction, alternatives: int) -> Iterator[str]:
    """How certain the control flow is and each task's place in it, then the other flows with their probabilities."""
    places = ", ".join(f"[{task.id}] {task.dependency_confidence:.0%}" for task in instruction.tasks)
    yield f"confidence: {instruction.confidence:.0%}{f'; of the places of the tasks: {places}' if places else ''}"
    for other in instruction.alternatives[:alternatives]:
        yield f"or, with {other.probability:.0%}:"
        yield from (f"  {line}" for line in instruction.describe(other.flow).splitlines())
