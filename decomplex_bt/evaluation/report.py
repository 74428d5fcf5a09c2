"""The files of an evaluation: rows and summary, written whole or not at all."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.row import Row, row_lines
from decomplex_bt.evaluation.summary import summarise

ROWS_FILE = "rows.jsonl"
SUMMARY_FILE = "summary.json"
FAILURES_FILE = "failures.txt"
FORMAT = 1


def summary_json(rows: Sequence[Row], settings: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """The summary of all agents in the rows, with the settings it was made under."""
    return {
        "format": FORMAT,
        "settings": dict(settings or {}),
        "agents": [summary.to_json() for summary in summarise(rows)],
    }


def prepare_output(folder: Path) -> Path:
    """The folder, made if need be. Raises `InputError` where nothing can be written there."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder}: cannot write there: {error.strerror}; give another folder") from None
    if not os.access(folder, os.W_OK):
        raise InputError(f"{folder}: cannot write there: permission denied; give another folder")
    return folder


def failure_lines(rows: Iterable[Row]) -> Iterator[str]:
    """A line for each failed episode: which it was, and where and why it went wrong."""
    return (
        f"{row.agent}, {row.example}, seed {row.seed}: {row.stage}: {row.cause}"
        for row in rows
        if row.outcome == "failure"
    )


def write_results(folder: Path, rows: Sequence[Row], settings: Mapping[str, Any] | None = None) -> tuple[Path, ...]:
    """Writes `rows.jsonl`, `summary.json` and `failures.txt`; each appears only when complete. Raises `InputError`."""
    prepare_output(folder)
    rows_path = write_whole(folder / ROWS_FILE, "".join(row_lines(rows)))
    summary = json.dumps(summary_json(rows, settings), ensure_ascii=False, indent=2)
    failures = "".join(f"{line}\n" for line in failure_lines(rows))
    return (
        rows_path,
        write_whole(folder / SUMMARY_FILE, summary + "\n"),
        write_whole(folder / FAILURES_FILE, failures),
    )


def write_whole(path: Path, text: str) -> Path:
    """Writes a file beside its place and moves it there, so that a reader never finds half of it.

    What is no character, as in the name of a file that is not UTF-8, is escaped, as JSON would have it.
    """
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", errors="backslashreplace") as file:
            file.write(text)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return path
