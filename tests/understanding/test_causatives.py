"""What is to be had done is ordered, each thing with its participle."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("Have the rug beaten and the curtains washed.", ["the rug", "the curtains"]),
        ("Have the crate sent up, and call Lea.", ["the crate", None]),
        ("Get the towels folded, the shelf dusted and the bath scrubbed.", ["the towels", "the shelf", "the bath"]),
        ("Could the yard be swept and the gate painted?", ["the yard", "the gate"]),
        ("Could the yard be swept and the gate be painted?", ["the yard", "the gate"]),
        ("Can the forks be washed and dried?", ["the forks", "the forks"]),
    ],
)
def test_what_is_had_done_to_several_things_is_several_orders(
    interpreter: Interpreter, text: str, things: list[str | None]
) -> None:
    assert flow(interpreter, text) == list(range(1, len(things) + 1))
    assert [task.value("object") for task in interpreter.interpret(text).tasks] == things


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Have the jars been emptied? If not, empty them.", ["check_state", "change_state"]),
        ("Have the girls eaten?", ["check_state"]),
        ("Get the hatch shut.", ["change_state"]),
        ("Get the boxes stacked by the door.", ["placing"]),
        ("Have a look at the towels.", ["searching"]),
    ],
)
def test_what_is_asked_or_tells_the_state_or_place_is_read_as_it_is(
    interpreter: Interpreter, text: str, types: list[str]
) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == types


def test_what_is_got_shut_is_got_so(interpreter: Interpreter) -> None:
    assert interpreter.interpret("Get the hatch shut.").tasks[0].value("state") == "shut"
