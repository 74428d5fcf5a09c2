"""Where somebody or something is to go next, told without a verb."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "argument", "values"),
    [
        ("Go to the kitchen, then to the study.", "goal", ["to the kitchen", "the study"]),
        ("Go to the kitchen and then to the study and then back to the hall.", "goal", ["to the kitchen", "the study"]),
        ("Put the apple on the desk, then on the couch.", "goal", ["on the desk", "the couch"]),
        ("Bring the apple to Tom, then to Anna.", "recipient", ["to Tom", "Anna"]),
    ],
)
def test_each_leg_of_a_way_is_an_order(interpreter: Interpreter, text: str, argument: str, values: list[str]) -> None:
    found = interpreter.interpret(text)

    assert [task.value(argument) for task in found.tasks][:2] == values
    assert len({task.type for task in found.tasks}) == 1


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("Go to the hall and then bring the cup to the study.", 2),
        ("Go to the kitchen, then tell Tom to come to the study.", 2),
        ("Take the cup from the table to the sink.", 1),
    ],
)
def test_what_is_no_further_leg(interpreter: Interpreter, text: str, count: int) -> None:
    assert len(interpreter.interpret(text).tasks) == count
