"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from pathlib import Path
from typing import Annotated, TypeVar

import typer

from decomplex_bt.errors import InputError, check_jobs


class Format(StrEnum):
    """How a result is printed."""

    text = "text"
    json = "json"


Form = TypeVar("Form", bound=StrEnum)
FormatOption = Annotated[
    Format | None, typer.Option("--format", "-f", help="How the result is printed.", show_default="text")
]
JsonOption = Annotated[bool, typer.Option("--json", help="The same as --format json.")]


def _check_jobs(jobs: int) -> int:
    check_jobs(jobs, "--jobs")
    return jobs


def number_up_to(highest: float) -> Callable[[typer.CallbackParam, float | None], float | None]:
    """The callback of an option that takes a number from 0 to this one; its error names option and number."""

    def check(option: typer.CallbackParam, value: float | None) -> float | None:
        if value is not None and not 0.0 <= value <= highest:
            raise InputError(f"--{option.name} {value:g}: expected a number from 0 to {highest:g}")
        return value

    return check


JobsOption = Annotated[int, typer.Option("--jobs", "-j", callback=_check_jobs, help="Processes; -1: one a core.")]
SeedOption = Annotated[int, typer.Option("--seed", "-s", min=0, help="Seed of all chance.")]
DomainOption = Annotated[
    str, typer.Option("--domain", "-d", help="A domain by name, or the folder of one (a path with a slash in it).")
]
EncoderOption = Annotated[
    bool | None,
    typer.Option(
        "--encoder/--no-encoder", help="Read with the encoder, or with the CRFs alone.", show_default="where installed"
    ),
]
ThresholdOption = Annotated[
    float | None,
    typer.Option(
        "--threshold",
        min=0.0,
        max=1.0,
        help="On a terminal, ask back where the control flow is less certain than this; 0: never, 1: wherever there "
        "is another.",
        show_default="where it pays",
    ),
]
TextArgument = Annotated[str, typer.Argument(metavar="TEXT", help="What the robot is to do, in English.")]


def chosen(format: Form | None, json: bool, default: Form) -> Form:
    """The format that both options ask for together. Raises `InputError` where they contradict each other."""
    if not json:
        return format or default
    if format not in (None, "json"):
        raise InputError(f"--json and --format {format} contradict each other; give one of them")
    return type(default)("json")


def domain_of(name: str) -> str | Path:
    """A name of a shipped domain as it is, anything that looks like a path as a path."""
    return Path(name) if "/" in name or "\\" in name or name in (".", "..") else name
