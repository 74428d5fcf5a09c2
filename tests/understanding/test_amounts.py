"""How many or how much of what was named, told without its noun."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "task", "value"),
    [
        ("Count the stools, and if there are fewer than eight, fetch the bench.", 2, "fewer than eight stools"),
        ("Count the pegs. If there are at least twenty, hang the towels out.", 2, "at least twenty pegs"),
        ("Look at the lemons; if there are more than ten, squeeze five.", 2, "more than ten lemons"),
        ("Look at the lemons; if there are more than ten, squeeze five.", 3, "five lemons"),
        ("Wash the plums and give me a dozen.", 2, "a dozen plums"),
        ("Slice the melon, freeze half and bring me a plate.", 2, "half of the melon"),
        ("Count the rolls. If there are under ten, thaw a loaf.", 2, "under ten rolls"),
        ("Wash the figs and give me half a dozen.", 2, "half a dozen figs"),
        ("Slice Anna's melon and freeze half.", 2, "half of Anna's melon"),
        # a name
        ("Wash the plates and open 12.", 2, "12"),
        # with its noun
        ("Count the stools, and if there are fewer than eight chairs, fetch the bench.", 2, "fewer than eight chairs"),
        ("Wash the plums and give me half a pear.", 2, "half a pear"),
    ],
)
def test_an_amount_alone_is_of_what_was_named(interpreter: Interpreter, text: str, task: int, value: str) -> None:
    assert interpreter.interpret(text).task(task).value("object") == value
