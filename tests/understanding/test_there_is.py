"""What a statement says there is somewhere."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("There's a wasp in the bathroom. If it's on the mirror, open the window.", "a wasp"),
        ("There's a cat in the garden. If it's under the hedge, put some milk out.", "a cat"),
        ("There's a squirrel on the terrace. If it's gone, tell me.", "a squirrel"),
        # what is in, with or for it is part of what it is
        ("There's a box of cups on the stairs. If it's open, carry it down.", "a box of cups"),
        ("There's a note for Ann on the fridge. If it's wet, bring it to me.", "a note for Ann"),
        ("There's a man with a dog at the gate. If he's from the council, let him in.", "a man with a dog"),
    ],
)
def test_where_something_is_is_no_part_of_what_it_is(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).task(1).value("object") == value
