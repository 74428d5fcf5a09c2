"""Requests: what is asked for with thanks ahead, as a favour, or before something that is no task."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "I should be most obliged if you would find my shawl and bring it to me.",
        "It would help if you could find my shawl and bring it here.",
        "I'd be ever so grateful if you would find my shawl and bring it here.",
    ],
)
def test_what_is_thanked_for_hangs_on_nothing(interpreter: Interpreter, text: str) -> None:
    instruction = interpreter.interpret(text)
    assert [task.type for task in instruction.tasks] == ["searching", "bringing"]
    assert instruction.to_json()["flow"] == [1, 2]


def test_a_case_behind_the_thanks_is_one(interpreter: Interpreter) -> None:
    text = "It would be great if you could feed the hens, if they're hungry."
    assert interpreter.interpret(text).to_json()["flow"] == [{"if": 2, "then": [1]}]


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("Do me the favour of warming the stew, and carry it up.", ["warming", "carry"]),
        ("Bring me the shawl before my telephone call with Lea.", ["Bring"]),
        ("If the tank is empty, as I suspect it is, fill it.", ["is", "fill"]),
        ("If he's asleep, which I doubt, shut the hatch.", ["'s", "shut"]),
    ],
)
def test_what_is_said_around_a_request_is_no_task(interpreter: Interpreter, text: str, verbs: list[str]) -> None:
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == verbs


def test_what_covers_a_window_is_drawn_and_not_put_somewhere(interpreter: Interpreter) -> None:
    assert interpreter.interpret("Drop the blinds, please.").tasks[0].type == "change_state"
    assert interpreter.interpret("Drop the sack on the floor.").tasks[0].type == "placing"


@pytest.mark.parametrize(
    "text",
    [
        "mind if i ask you to rinse the jug",
        "Do you mind if I ask you to rinse the jug?",
        "Mind if I asked you to rinse the jug?",
    ],
)
def test_whether_one_minds_is_no_case(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == [1]
    assert found.tasks[0].value("object") == "the jug"
