"""What is to be forgotten or skipped, and what is not."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Hang the wreath on the nail. If it's stormy, forget the nail and bring it indoors.", "the wreath"),
        (
            "Take the clock to the shelf. If the shelf is wobbly, never mind the shelf and put it on the desk.",
            "the clock",
        ),
        ("Carry the chair to the balcony. If it's raining, skip the balcony and put it here.", "the chair"),
        # what is not left out
        ("Find the hat. Don't forget the umbrella, and put it in the car.", "the umbrella"),
        ("Bring the mop. If it's wet, forget the mop, take the broom and put it by the door.", "the broom"),
    ],
)
def test_what_is_forgotten_is_not_gone_on_about(text: str, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("object") == value
