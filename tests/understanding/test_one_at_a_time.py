"""That several things are taken one at a time."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "thing", "manner"),
    [
        ("Go there, dear, and hand me the pegs one by one.", "the pegs", "one by one"),
        ("Hand me the tiles one at a time.", "the tiles", "one at a time"),
        ("If the bowls are greasy, wash them two at a time.", "the bowls", "two at a time"),
        ("Bring me the books one after the other.", "the books", "one after the other"),
        ("Carry the crates up one or two at a time.", "the crates", "one or two at a time"),
        # as before
        ("Bring me the jar by the window.", "the jar", None),
        ("Put the red one by one of the doors.", "the red one", None),
        ("Get the cups and bring me one at once.", "a cup", None),
    ],
)
def test_one_at_a_time_is_how_and_no_thing(interpreter: Interpreter, text: str, thing: str, manner: str | None) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.value("object"), task.value("manner")) == (thing, manner)


@pytest.mark.parametrize(
    ("text", "manners"),
    [
        ("Close the hatch. One by one, bring me the cups.", [None, "One by one"]),
        ("Lock the hatch and, one by one, bring the chairs in.", [None, "one by one"]),
        ("Lock the hatch and bring the chairs in one by one.", [None, "one by one"]),
    ],
)
def test_one_at_a_time_is_how_its_own_order_is_done(
    interpreter: Interpreter, text: str, manners: list[str | None]
) -> None:
    assert [task.value("manner") for task in interpreter.interpret(text).tasks] == manners
