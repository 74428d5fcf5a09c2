"""Knocking and what comes of it, what is kept until something comes, what is left of something, what is told apart."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("text", ["Knock and go in.", "Knock before you go in.", "First knock, then go in."])
def test_to_knock_is_to_tell_somebody(interpreter: Interpreter, text: str) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == ["informing", "motion"]


def test_others_may_knock(interpreter: Interpreter) -> None:
    found = interpreter.interpret("The bell is broken, so visitors just knock. Go to the hall.")
    assert [task.type for task in found.tasks] == ["motion"]


@pytest.mark.parametrize(
    "text",
    [
        "If the gate is closed, ring the bell; if nobody answers, come back.",
        "If the gate is closed, knock first. If nobody answers, go in.",
    ],
)
def test_nobody_answers_where_somebody_knocked(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Keep the hatch open until the attic is cool.", [1, 2]),
        ("Until the plumber arrives, keep the gate closed.", [2, 1]),
        ("You will not leave the kitchen until the sink is empty.", [2, 1]),
    ],
)
def test_what_is_kept_is_so_before_something_comes(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("got any milk left? if not grab some", [{"if": 1, "else": [2]}]),
        ("got any bread if not get some", [{"if": 1, "else": [2]}]),
        ("got any eggs left? If so, bring me two.", [{"if": 1, "then": [2]}]),
    ],
)
def test_got_any_asks(interpreter: Interpreter, text: str, expected: Any) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == expected
    assert found.tasks[0].type == "check_state"


@pytest.mark.parametrize(
    "text",
    [
        "check the hatch in the attic if its open close it",
        "check the light in the attic if its on turn it off",
    ],
)
def test_what_is_checked_and_its_state_are_one(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 2], "then": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "Check both hatches. If the left hatch is open, close it. If the right hatch is open, tell me.",
        "Check the attic window and the cellar window. If the attic window is open, close it. If the cellar window is "
        "open, tell me.",
    ],
)
def test_two_things_of_a_kind_are_asked_after_each(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 2], "then": [3]}, {"if": 4, "then": [5]}]


def test_the_rest_is_what_no_case_spoke_of(interpreter: Interpreter) -> None:
    text = "If there's anything from the bank, put it on my desk. The rest can go in the box."
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}, 3]


def test_the_rest_of_one_thing_is_in_its_case(interpreter: Interpreter) -> None:
    text = "If the post has come, bring it in and give Kim his letters; the rest goes behind the clock."
    assert flow(interpreter, text) == [{"if": 1, "then": [2, 3, 4]}]


def test_another_place_is_used(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Put the toys in the box. If it's full, use the shelf.")
    assert (found.tasks[2].type, found.tasks[2].value("goal")) == ("placing", "the shelf")


@pytest.mark.parametrize(
    "text",
    [
        "Serve the soup as soon as it is hot and open the wine.",
        "Put the pie in the larder once it's cold and wash the pan.",
    ],
)
def test_what_is_waited_for_keeps_no_other_order(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}, 3]
