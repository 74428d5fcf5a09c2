"""Cases of what is pointed at or of what the one spoken to is at, behind an order too, and failures in a word."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "Hand me another mug if that's broken.",
        "Put the jam back if you've finished with it.",
        "Hang the hammer up if you're done with it.",
        "Bring me some soup if you're making some.",
    ],
)
def test_what_is_pointed_at_or_done_with_is_asked(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}]


@pytest.mark.parametrize(
    "text", ["Switch the radio off if you're not listening to it.", "Give me the hammer if you aren't using it."]
)
def test_what_one_is_not_doing_is_asked(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "else": [1]}]


@pytest.mark.parametrize(
    "text",
    [
        "Bring me some soup if that's allowed.",
        "Bring me some soup if you're going to the kitchen.",
        "Tell me if you're not using the hammer.",
    ],
)
def test_what_is_said_for_politeness_or_told_is_not_asked(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1]


def test_who_is_pointed_at_is_what_the_case_is_of(interpreter: Interpreter) -> None:
    (_, check) = interpreter.interpret("Switch the radio off if you're not listening to it.").tasks
    assert (check.value("object"), check.value("state")) == ("you", "listening to it")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If you can't get at it, use the ladder.", [{"if": 1, "else": [2]}]),
        ("Look for the rake, and should you come up empty, tell me.", [{"if": 1, "else": [2]}]),
        ("Search the attic for the rake. Should you come up empty-handed, call me.", [{"if": [1, 2], "else": [3]}]),
    ],
)
def test_what_comes_to_nothing_fails(interpreter: Interpreter, text: str, expected: list[object]) -> None:
    assert flow(interpreter, text) == expected


def test_what_one_is_done_with_may_be_in_any_state(interpreter: Interpreter) -> None:
    text = "Hang the hammer up if you've finished with it. If it's broken, bring it to me."
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}, {"if": 3, "then": [4]}]
