"""What something is done against, what is only needed, and what somebody is doing are no orders and no conditions."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Bring me a blanket in case I get cold.", [1]),
        ("Put a bucket under the pipe in case it leaks.", [1]),
        ("Bring a lantern in case it's dark in there.", [1]),
        ("Close the hatch in case it rains and then lock the gate.", [1, 2]),
        ("Put the phone on silent in case Kim is asleep.", [{"if": 2, "then": [1]}]),
        ("Take the rugs in in case they are dry.", [{"if": 2, "then": [1]}]),
        ("In case the gate is open, close it.", [{"if": 1, "then": [2]}]),
    ],
)
def test_what_an_order_is_to_guard_against_is_no_condition(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "I need my cape. If it is in the attic, bring it to me.",
        "I need my ladle. If it's in the larder, bring it here.",
        "We need the rugs. If they are in the attic, get them down.",
    ],
)
def test_what_is_needed_is_brought_as_the_next_sentence_says(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == [{"if": 1, "then": [2]}]
    assert "I" not in found.tasks[1].values("recipient")


@pytest.mark.parametrize(
    "text",
    [
        "I'd like a root beer. If it isn't cold, put some ice in it.",
        "I need a saw. If there is none, bring me the axe.",
    ],
)
def test_what_is_wanted_is_brought_where_nothing_else_says_so(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).tasks[0].type == "bringing"


@pytest.mark.parametrize("asked", ["Ask Lea if she'd prefer soup.", "Ask the guests if they would rather have tea."])
def test_what_somebody_is_asked_to_prefer_is_no_condition(interpreter: Interpreter, asked: str) -> None:
    assert [task.type for task in interpreter.interpret(asked).tasks] == ["informing"]


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("If Kim is mowing the meadow, bring him some water.", "mowing the meadow"),
        ("If Lea is still washing the van, bring her a rag.", "washing the van"),
        ("If Lea is ironing the cape, close the gate.", "ironing the cape"),
    ],
)
def test_what_somebody_is_doing_is_a_state(interpreter: Interpreter, text: str, state: str) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == [{"if": 1, "then": [2]}]
    assert found.tasks[0].value("state") == state


def test_to_bring_is_no_gerund(interpreter: Interpreter) -> None:
    text = "any batteries left in the drawer if there are bring me two"
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}]
