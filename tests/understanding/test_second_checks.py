"""A second check is a condition of its own, a mention of the first or none of both, by what it says."""

from __future__ import annotations

from typing import Any

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household")


def flow(interpreter: Interpreter, text: str) -> Any:
    return interpreter.interpret(text).to_json()["flow"]


@pytest.mark.parametrize(
    "text",
    [
        "If it is dark, turn on the lantern, and if it is raining, close the hatch.",
        "If it's sunny, put the washing out, and if it's windy, close the hatch.",
        "Close the blinds if the sun is shining and turn on the fan if it is hot.",
    ],
)
def test_two_sorts_of_weather_are_two_conditions(interpreter: Interpreter, text: str) -> None:
    one, other = flow(interpreter, text)
    assert len(one["then"]) == len(other["then"]) == 1


def test_one_sort_of_weather_instead_of_another(interpreter: Interpreter) -> None:
    text = "If it is raining, close the hatch, but if it is snowing, make tea."
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Feed the hens, and if nobody is in the attic, close the hatch.",
        "Bring me the axe, and if nobody is using the iron, close the hatch.",
    ],
)
def test_nobody_elsewhere_keeps_nothing_from_the_order_before(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": 2, "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "If the dog has been out, feed him, and if he hasn't been out yet, open the gate.",
        "If Lea has called, tell me, and if she hasn't called yet, ring her.",
    ],
)
def test_what_is_denied_of_the_same_one_is_the_other_side(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}]


def test_fewer_than_was_said_is_the_other_side(interpreter: Interpreter) -> None:
    text = "Check if there are six plates in the larder. If there are fewer, tell me."
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "If Kim is home, ask him whether he has eaten. If he hasn't, heat the soup.",
        "If Lea is awake, ask her if she has slept. If she hasn't, close the blinds.",
    ],
)
def test_a_has_answers_what_was_asked_in_a_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}]


def test_if_so_goes_by_what_was_asked_last(interpreter: Interpreter) -> None:
    text = "If Kim is home, ask him if he wants tea, and if so, make some."
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 2, "then": [3]}]}]


def test_either_tells_of_the_one_asked_last(interpreter: Interpreter) -> None:
    text = "Call Tom. If he doesn't answer, call Anna. If she doesn't answer either, tell me."
    assert flow(interpreter, text) == [1, {"if": 2, "else": [3, {"if": 4, "else": [5]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Close the hatch if it's open and see if the fan is on.",
        "shut the gate if it's open and check that the hatch is locked",
    ],
)
def test_what_is_to_be_checked_besides_is_no_part_of_the_condition(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}, 3]


@pytest.mark.parametrize(
    "text", ["run the washer if its full if not just leave it", "Water the ferns if they're dry and if not leave them."]
)
def test_what_is_left_if_not_is_done_if_so(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}]
