"""Which of the things named belong where is said in passing."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load(encoder=True)


def _told(interpreter: Interpreter, text: str) -> list[tuple[str, str]]:
    return [(a.type, a.value) for a in interpreter.interpret(text).tasks[-1].arguments]


@pytest.mark.parametrize(
    "text",
    [
        "Stack the tins, the big ones at the front, on the shelf.",
        "Stack the tins, the chipped ones at the back, on the shelf.",
        "Stack the tins, the heavy ones first, on the shelf.",
    ],
)
def test_which_of_the_things_belong_where_is_said_in_passing(interpreter: Interpreter, text: str) -> None:
    assert _told(interpreter, text) == [("object", "the tins"), ("goal", "on the shelf")]


def test_which_things_are_meant_is_no_remark(interpreter: Interpreter) -> None:
    assert ("object", "the blue cups") in _told(interpreter, "Put the cups, the blue ones, on the tray.")
