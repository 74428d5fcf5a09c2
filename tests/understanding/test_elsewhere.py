"""Where else something is said to be, which says to look there."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "wanted", "place"),
    [
        (
            "Look for my gloves in the hall. If you can't find them, there's another pair in the trunk.",
            [{"if": [1, 2], "else": [3]}],
            "in the trunk",
        ),
        (
            "Get me my watch from the bathroom. If it's not there, it might be in the kitchen.",
            [{"if": [1, 2], "else": [3]}],
            "in the kitchen",
        ),
        (
            "Find Rex. If he isn't in the yard, he's probably in the barn. Then lock the gate.",
            [{"if": [1, 2], "else": [3]}, 4],
            "in the barn",
        ),
        (
            "Get the map. If it's not in the car, it must be on the shelf.",
            [{"if": [1, 2], "else": [3]}],
            "on the shelf",
        ),
    ],
)
def test_where_else_it_is_said_to_be_is_looked_for(
    interpreter: Interpreter, text: str, wanted: Any, place: str
) -> None:
    assert flow(interpreter, text) == wanted
    assert interpreter.interpret(text).tasks[2].value("location") == place


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("If the lamp isn't on the desk, it must be in the hall. Bring it to me.", [1, 2]),
        ("If there's no jam in the fridge, there's some in the cellar, so bring me that.", [{"if": 1, "else": [2]}]),
        ("If the door isn't locked, it's a mess in there. Close it.", None),
    ],
)
def test_what_an_order_takes_up_is_no_search(interpreter: Interpreter, text: str, wanted: Any) -> None:
    found = interpreter.interpret(text)
    assert all(task.type != "searching" for task in found.tasks)
    assert wanted is None or flow(interpreter, text) == wanted
