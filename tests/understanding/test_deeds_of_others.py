"""What somebody else does is never ordered, whatever it is timed by."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "wanted", "types"),
    [
        ("Before Katya mops the porch, carry my boots inside.", [1], ["bringing"]),
        ("Before the cleaner vacuums the rug, pick up the dice.", [1], ["taking"]),
        ("Bring the robes up before Katya scrubs the bath and shut the hatch.", [1, 2], ["bringing", "change_state"]),
        ("While Ben cooks the rice, lay the table.", [1], ["change_state"]),
        ("After Ben washes the van, put the pail away.", [1, 2], ["check_state", "placing"]),
        # what the listener does
        ("Before you mop the porch, carry my boots inside.", [2, 1], ["change_state", "bringing"]),
        ("After you wash the van, put the pail away.", [1, 2], ["change_state", "placing"]),
        ("Before supper, wash the plates.", [1], ["change_state"]),
    ],
)
def test_what_somebody_else_does_is_no_order(
    interpreter: Interpreter, text: str, wanted: list[Any], types: list[str]
) -> None:
    assert flow(interpreter, text) == wanted
    assert [task.type for task in interpreter.interpret(text).tasks] == types


def test_what_belongs_to_a_deed_of_others_is_nobody_elses(interpreter: Interpreter) -> None:
    task = interpreter.interpret("Before Ben cleans the oven, take out the trays.").task(1)
    assert [(a.type, a.value) for a in task.arguments] == [("object", "the trays")]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("Carry my boots inside before Katya mops the porch if they are dry.", [{"if": 2, "then": [1]}]),
        ("Lock the hatch before Ben walks the dog and if it's open tell me.", [1, {"if": 2, "then": [3]}]),
        ("Wait until the cleaner mops the porch and leaves the house, then lock up.", [1, 2]),
    ],
)
def test_what_stands_behind_a_deed_of_others_is_ordered(interpreter: Interpreter, text: str, wanted: list[Any]) -> None:
    assert flow(interpreter, text) == wanted


@pytest.mark.parametrize(
    "text",
    [
        "Don't open the door until Oscar has put his shoes on, then call him.",
        "Keep the lights on until Mum has put the baby down.",
    ],
)
def test_what_somebody_is_waited_for_to_do_is_asked(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).tasks[1].type == "check_state"


def test_what_is_waited_for_to_have_been_done_is_an_order(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Once the guest has been brought to his seat, dim the lamp.")

    assert found.tasks[0].type != "check_state"
