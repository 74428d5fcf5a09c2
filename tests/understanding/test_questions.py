"""Questions inside an order to find something out."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Check who is in the sauna.", {"object": "who", "location": "in the sauna"}),
        ("Look what is in the box.", {"object": "what", "location": "in the box"}),
        ("See how much milk is in the fridge.", {"object": "how much milk", "location": "in the fridge"}),
        ("See which of the rooms is empty.", {"object": "which of the rooms", "state": "empty"}),
        ("Go see who left the gate open.", {"object": "who left the gate open"}),
        ("Check if somebody is in the sauna.", {"object": "somebody", "location": "in the sauna"}),
    ],
)
def test_what_is_asked_for_is_what_is_found_out(text: str, found: dict[str, str]) -> None:
    instruction = Interpreter.load().interpret(text)
    assert {argument.type: argument.value for argument in instruction.tasks[-1].arguments} == found
    assert not instruction.missing


@pytest.mark.parametrize(
    ("text", "who"),
    [
        ("Go see who is in the pool and if it's Leo tell him dinner is ready.", "Leo"),
        ("Go see who it is and if it's the postman get the package from him.", "the postman"),
        ("Go see who left the gate open and if it was Finn tell him to close it.", "Finn"),
        ("Look who is knocking and if its grandma bring her the slippers.", "grandma"),
    ],
)
def test_who_it_is_is_a_condition_of_its_own(text: str, who: str) -> None:
    instruction = Interpreter.load().interpret(text)
    assert instruction.flow.to_json() == [1, {"if": 2, "then": [3]}]
    assert [(a.type, a.value) for a in instruction.tasks[1].arguments] == [("object", who)]
    assert who in [argument.value for argument in instruction.tasks[2].arguments]
    assert not instruction.missing


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Did you switch the pump off? If you did, switch it back on.", [{"if": 1, "then": [2]}]),
        ("Have you put the pie in the oven? If you have, take it out.", [{"if": [1, 2], "then": [3]}]),
        ("Have you watered the ferns? If not, please do.", [{"if": 1, "else": [2]}]),
        ("have you rinsed the jug? if not please do", [{"if": 1, "else": [2]}]),
        ("Should I water the ferns? If they're dry, water them.", [{"if": 1, "then": [2]}]),
        ("Have you got the rope?", [1]),
    ],
)
def test_a_question_what_was_or_should_be_done_orders_nothing(
    interpreter: Interpreter, text: str, expected: object
) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == expected


@pytest.mark.parametrize(
    ("text", "kind"), [("Have you got the rope?", "taking"), ("Did you lock the shed?", "check_state")]
)
def test_what_one_has_is_fetched_and_what_was_done_checked(interpreter: Interpreter, text: str, kind: str) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == [kind]


def test_a_please_do_is_an_order_to_do_what_was_asked(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Have you watered the ferns? If not, please do.")
    assert (found.tasks[1].type, found.tasks[1].value("object")) == ("change_state", "the ferns")
