"""What an error says of a name that nobody knows."""

from __future__ import annotations

import pytest

from decomplex_bt.errors import FEW, among

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
