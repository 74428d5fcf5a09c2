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
