"""What is not to be done until something is so is done behind it."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

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


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If the grill isn't hot yet, wait. As soon as it is, put the beans on it.", [{"if": 1, "else": [2]}, 3]),
        ("If the floor isn't clean, wait. Once it's clean, put the mat back.", [{"if": 1, "else": [2]}, 3]),
        ("If the study is occupied, wait. When it's free, sweep it.", [{"if": 1, "then": [2]}, 3]),
        ("If the lift is busy, wait a minute. Then take the box up.", [1, 2]),
        ("If the study is dark, wait. Turn on the lamp.", [{"if": 1, "then": [2]}]),
        ("If Kim is home, great. Then give her the letter.", [{"if": 1, "then": [2]}]),
        (
            "If the stove isn't hot, turn it on. When it's hot, put the beans on it.",
            [{"if": 1, "else": [2]}, {"if": 3, "then": [4]}],
        ),
    ],
)
def test_what_follows_a_wait_is_done_in_both_cases(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Wait for Kim to finish, then sweep the yard.", [1, 2]),
        ("Wait for the pan to boil, then add the rice.", [1, 2]),
        ("Start the pump, wait for it to heat up and open the valve.", [1, 2, 3]),
        ("Wait for the paint to dry before you close the hatch.", [1, 2]),
        ("Wait for Kim in the yard.", [1]),
    ],
)
def test_what_somebody_is_waited_for_to_do_comes_first(interpreter: Interpreter, text: str, expected: object) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == expected


def test_who_is_waited_for(interpreter: Interpreter) -> None:
    task = interpreter.interpret("Wait for Kim to finish, then sweep the yard.").tasks[0]
    assert (task.type, task.value("object")) == ("check_state", "Kim")


def test_what_is_not_waited_for_is_no_task(interpreter: Interpreter) -> None:
    tasks = interpreter.interpret("Don't wait for Kim to finish, sweep the yard now.").tasks
    assert [task.type for task in tasks] == ["change_state"]
