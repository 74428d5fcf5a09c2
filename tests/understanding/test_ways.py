"""Which way somebody comes is no place where they end up."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load(encoder=True)


@pytest.mark.parametrize(
    ("text", "kind", "way"),
    [
        (
            "If Max's door is locked, knock; if he doesn't answer, leave the post on his mat, and either way come "
            "straight back down.",
            "direction",
            "back down",
        ),
        ("Go quietly up the ladder and close the skylight, and if the cat stirs, come straight back down.", "direction",
         "back down"),
        ("Go up to the roof and come back down.", "direction", "back down"),
        ("Come back in the kitchen.", "goal", "in the kitchen"),
        ("Come back inside.", "goal", "inside"),
    ],
)  # fmt: skip
def test_which_way_somebody_comes_back_is_no_place(interpreter: Interpreter, text: str, kind: str, way: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value(kind) == way
