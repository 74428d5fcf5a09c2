"""What is skipped or left out is no order."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "verbs", "expected"),
    [
        (
            "Skip the nursery if Milo is asleep. Otherwise hoover it.",
            ["is", "hoover"],
            [{"if": 1, "else": [2]}],
        ),
        ("Skip the cellar if it's flooded; otherwise sweep it.", ["'s", "sweep"], [{"if": 1, "else": [2]}]),
        ("Dust every room, but skip the den if Ruth is in it.", ["Dust"], [1]),
        ("Mop all the rooms, but leave out the hall.", ["Mop"], [1]),
        ("Leave out a towel for Ruth.", ["Leave"], [1]),
        ("Leave the butter out.", ["Leave"], [1]),
    ],
)
def test_what_is_skipped_is_no_order(interpreter: Interpreter, text: str, verbs: list[str], expected: Any) -> None:
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == verbs
    assert flow(interpreter, text) == expected


def test_what_is_left_out_may_be_done_otherwise(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Skip the nursery if Milo is asleep. Otherwise hoover it.")
    assert found.tasks[-1].value("object") == "the nursery"


@pytest.mark.parametrize(
    ("text", "is_warned"),
    [
        ("Dust every room, but skip the den if Ruth is in it.", True),
        ("Skip the nursery if Milo is asleep. Otherwise hoover it.", False),
    ],
)
def test_what_is_left_out_of_all_is_warned_of(interpreter: Interpreter, text: str, is_warned: bool) -> None:
    assert any("leaves something out" in warning for warning in interpreter.interpret(text).warnings) == is_warned


@pytest.mark.parametrize(
    ("text", "heeded"),
    [
        ("Dust every room, but skip the den.", "planning alone heeds it"),
        ("Dust every room, but skip the den if Ruth is in it.", "nothing heeds it"),
    ],
)
def test_the_warning_tells_what_heeds_it(interpreter: Interpreter, text: str, heeded: str) -> None:
    (warning,) = interpreter.interpret(text).warnings
    assert heeded in warning
