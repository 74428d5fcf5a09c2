"""Who it is that calls, and somebody else who may be called in somebody's place."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If my aunt phones, tell her I'm asleep. If it's the dentist, bring me the phone.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        (
            "If the gardener rings, let him in, and if it's the courier, take the parcel.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        (
            "When the doorbell rings, go to the door. If it's Lea, let her in.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        (
            "If somebody knocks, open the hatch. If it's the milkman, give him the crate.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        (
            "If the gardener rings, let him in. If it's Friday, water the cactus.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
    ],
)
def test_who_it_is_is_asked_where_somebody_calls_or_somebody_else_does(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Ring the vet, or the shelter if she's on holiday.",
        "Phone Bea, or her mother if she's not answering.",
        "Wake Lea, or Tom if she's already up.",
    ],
)
def test_a_case_behind_somebody_else_is_no_message(interpreter: Interpreter, text: str) -> None:
    instruction = interpreter.interpret(text)
    assert [task.type for task in instruction.tasks][2] == "check_state"
    assert instruction.flow.walk()
    assert "message" not in {argument.type for task in instruction.tasks for argument in task.arguments}


def test_what_somebody_is_to_tell_stays_a_message(interpreter: Interpreter) -> None:
    (task,) = interpreter.interpret("Tell me or Lea if the stew is hot.").tasks
    assert task.value("message") == "if the stew is hot"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the phone rings, answer it. It might be my sister. If it is, bring me the phone.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        (
            "If the doorbell rings, go to the hall. It could be Kim. If it is, let her in. If it isn't, come back.",
            [{"if": 1, "then": [2, {"if": [3, 5], "then": [4], "else": [6]}]}],
        ),
        (
            "If somebody knocks, open the gate. It may be Kim. If it's not, shut it again.",
            [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}],
        ),
        (
            "If it's the dog, come back, but if there's a stranger, call me.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        (
            "If it's the plumber, let him in, but if there's a salesman, shut the gate.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        (
            "If it's the dog, come back, but if it's raining, bring him in.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
    ],
)
def test_who_it_is_is_asked_where_somebody_rings_or_is_there(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected
