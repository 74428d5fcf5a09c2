"""What every command does to print: JSON lines, progress and remarks on standard error."""

from __future__ import annotations

import io
import json
import os
import re
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from typing import Any, TextIO, TypeVar

Item = TypeVar("Item")
_LINE_ENDS = re.compile("[\x7f\x85\u2028\u2029]")


class Spared:
    """Standard error that nobody need read: what cannot be written there is lost, and is no reason to stop."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        with self._sparing():
            self._stream.write(text)
        return len(text)

    def flush(self) -> None:
        with self._sparing():
            self._stream.flush()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    @contextmanager
    def _sparing(self) -> Iterator[None]:
        try:
            yield
        except OSError:
            silence(self._stream)


def silence(stream: TextIO) -> None:
    """Lets a stream that cannot be written go nowhere, also what Python still holds of it and writes when it ends."""
    with open(os.devnull, "wb") as nowhere, suppress(io.UnsupportedOperation):  # of a stream that is no file
        os.dup2(nowhere.fileno(), stream.fileno())


def use_utf8() -> None:
    """Lets standard output and error take any text; letters a terminal cannot show are escaped."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace")


def print_json(value: Any) -> None:
    """One JSON object on a line of its own, also for readers that take other characters for the end of a line."""
    print(_LINE_ENDS.sub(lambda match: f"\\u{ord(match[0]):04x}", json.dumps(value, ensure_ascii=False)), flush=True)


def remark(message: str) -> None:
    """A line on standard error."""
    print(message, file=sys.stderr, flush=True)


def track(items: Iterable[Item], *, total: int | None, label: str) -> Iterator[Item]:
    """The items, with a progress bar on standard error where that is a terminal and standard output is none."""
    if not sys.stderr.isatty() or sys.stdout.isatty():
        yield from items
        return
    from rich.console import Console
    from rich.progress import track as bar

    yield from bar(items, description=label, total=total, console=Console(stderr=True), transient=True)
