"""Cases behind a verb of telling that only take up the one before."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter

INTERPRETER = Interpreter.load(encoder=False)


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Bring the post in if it's come and tell me if it hasn't.", [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Turn the fan on if it's off and let me know if it isn't.", [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Give Lea the cake if she's in and text me if she's not.", [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Open the window if you can and tell Max if you can't.", [{"if": 1, "else": [2]}]),
        ("Tell me if it's chipped.", [1]),
        ("Check the oven and tell me if it's on.", [1, 2]),
        ("Ask Max if he's hungry and tell me if he is.", [1, 2]),
    ],
)
def test_a_case_that_takes_up_the_one_before_is_no_message(text: str, flow: list[object]) -> None:
    assert INTERPRETER.interpret(text).flow.to_json() == flow


@pytest.mark.parametrize(
    "text", ["Shut the gate if you can and tell me if you can't.", "Bring it if it's dry and text us if it isn't."]
)
def test_what_is_told_is_not_the_case(text: str) -> None:
    instruction = INTERPRETER.interpret(text)
    telling = next(task for task in instruction.tasks if task.type == "informing")
    assert telling.value("message") is None


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Check if Ben has eaten. If he hasn't, warn him and text me when he has.",
         [{"if": [1, 2], "else": [3, {"if": 5, "then": [4]}]}]),
        ("If the oven isn't hot, turn it on and call me when it is.",
         [{"if": 1, "else": [2, {"if": 4, "then": [3]}]}]),
        ("If the shop isn't open, phone Ann when it is.", [{"if": 1, "else": [{"if": 3, "then": [2]}]}]),
        ("If the stove isn't hot, put the pan on when it is.", [{"if": 1, "else": [{"if": 3, "then": [2]}]}]),
        ("If the stove isn't hot, tell me when it is.", [{"if": 1, "else": [2]}]),
        ("See if the bin is full. When it is, empty it.", [{"if": [1, 2], "then": [3]}]),
        ("Text me when the van is here.", [1]),
    ],
)  # fmt: skip
def test_what_comes_to_be_so_is_waited_for_in_the_other_case(
    interpreter: Interpreter, text: str, expected: object
) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Shout if the milk boils over.", [{"if": 2, "then": [1]}]),
        ("Buzz me if the roofer arrives.", [{"if": 2, "then": [1]}]),
        ("Watch the milk and shout if it boils over.", [1, {"if": 3, "then": [2]}]),
        ("Walk Nan to the gate and holler if she slips.", [1, {"if": 3, "then": [2]}]),
        ("Let me know if the roofer arrives.", [1]),
        ("Tell me if the milk boils over.", [1]),
        ("Ring Ann and ask her if the bus stops there.", [1, 2]),
    ],
)
def test_what_somebody_is_called_for_is_a_case(interpreter: Interpreter, text: str, expected: object) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == expected
