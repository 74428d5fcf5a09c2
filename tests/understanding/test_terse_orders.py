"""Terse orders and questions: states without a verb, amounts asked of what was looked at, kinds named behind a mark."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Radio off and lights out, please.", [1, 2]),
        ("If it's late, shutters down. If not, shutters up.", [{"if": 1, "then": [2], "else": [3]}]),
        ("Look at the dial. Below four degrees? Close both vents.", [1, {"if": 2, "then": [3]}]),
        ("Check the crate. Fewer than six? Tell Lea.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_what_is_said_without_a_verb(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("The front door is open. Close it.", "The front door"),
        ("The garage light is on. Turn it off.", "The garage light"),
        ("My radio's off. Turn it on.", "My radio"),
        ("The fridge door stays open. Close it.", "The fridge door"),
    ],
)
def test_a_state_that_is_told_is_no_order(interpreter: Interpreter, text: str, thing: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert [a.value for a in task.arguments if a.type == "object"] == [thing]


def test_a_verb_ahead_of_a_pointing_word_is_no_noun(interpreter: Interpreter) -> None:
    (task,) = interpreter.interpret("mate turn that box fan off").tasks
    assert task.span.of("mate turn that box fan off") == "turn"


def test_a_kind_behind_an_order_in_a_case_names_no_other_thing(interpreter: Interpreter) -> None:
    text = "If there are toys on the rug pick them up and put them in the crate, the big wooden one."
    assert flow(interpreter, text) == [{"if": 1, "then": [2, 3]}]
