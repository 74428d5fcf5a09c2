"""What an error says of a name that nobody knows."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from pathlib import Path

import pytest

from decomplex_bt.errors import (
    FEW,
    DataFileError,
    DecomplexError,
    ImpossibleGoalError,
    InputError,
    MissingArgumentError,
    UnknownWordError,
    among,
)
from decomplex_bt.instruction import Missing
from decomplex_bt.understanding.damage import ModelError

ROOMS = ("kitchen", "living_room", "study")


@pytest.mark.parametrize(
    ("name", "known", "says"),
    [
        ("kitchn", ROOMS, "; the nearest known: kitchen"),
        ("Living Room", ROOMS, "; the nearest known: living_room"),
        ("garage", ROOMS, "; known: kitchen, living_room, study"),
        (7, ROOMS, "; known: kitchen, living_room, study"),
        ("garage", (), ""),
    ],
)
def test_it_names_the_nearest_or_all(name: object, known: tuple[str, ...], says: str) -> None:
    assert among(name, known) == says


def test_of_many_it_gives_the_first_and_their_number() -> None:
    many = [f"{number:03}" for number in range(FEW + 1)]
    assert among("garage", many) == f"; known: {', '.join(many[: FEW - 1])}, ... ({FEW + 1} in all)"


@pytest.mark.parametrize(
    "error",
    [
        InputError("no instruction"),
        DataFileError("house.yaml", "no rooms", line=3),
        ModelError(Path("models/tasks.crf"), "damaged"),
        UnknownWordError("the unicorn", ["the union"], task=2),
        ImpossibleGoalError("the pen cannot be opened", task=1),
        MissingArgumentError(Missing(1, "goal", "Where should I put it?")),
    ],
)
def test_an_error_of_another_process_is_raised_anew_as_it_was(error: DecomplexError) -> None:
    sent = pickle.loads(pickle.dumps(error))
    kind: Callable[[object], DecomplexError] = type(error)

    for again in (sent, copy.copy(error), kind(sent)):
        assert type(again) is type(error)
        assert (str(again), vars(again)) == (str(error), vars(error))
