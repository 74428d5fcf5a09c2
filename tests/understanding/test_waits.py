"""What is not to be done until something is so is done behind it."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "tasks", "flow"),
    [
        ("Don't leave the shed before you've shut the hatch.", ["leave", "shut"], [2, 1]),
        ("Before you've shut the hatch, don't leave the shed.", ["shut", "leave"], [1, 2]),
        ("before you have shut the hatch don't leave the shed", ["shut", "leave"], [1, 2]),
        ("Until the kettle is full, don't start it.", ["is", "start"], [1, 2]),
        ("never leave the shed till you've shut the hatch", ["leave", "shut"], [2, 1]),
        ("you mustn't open the hutch until i'm home", ["open", "'m"], [2, 1]),
        ("Don't open the oven before the bell rings.", ["open", "rings"], [2, 1]),
        ("Before the neighbours are here, don't light the lanterns.", ["are", "light"], [1, 2]),
    ],
)
def test_what_is_waited_for_comes_first(interpreter: Interpreter, text: str, tasks: list[str], flow: list[int]) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(found.text) for task in found.tasks] == tasks
    assert found.flow.to_json() == flow


@pytest.mark.parametrize(
    ("text", "tasks"),
    [
        ("Don't wait until it's full, start the kettle now.", ["start"]),
        ("Before you go, don't forget to shut the hatch.", ["shut"]),
        ("Mop the hall, and don't start until you've swept it.", ["Mop", "swept"]),
        ("Lock the shed and don't go near it until the paint is dry.", ["Lock", "is"]),
    ],
)
def test_what_is_no_order_is_not_waited_with(interpreter: Interpreter, text: str, tasks: list[str]) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(found.text) for task in found.tasks] == tasks


def test_what_is_left_is_where_one_is_not_to_go_from(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Before you've shut the hatch, don't leave the shed.")
    assert found.tasks[1].value("source") == "the shed"
