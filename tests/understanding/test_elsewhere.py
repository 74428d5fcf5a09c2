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
            [{"if": 2, "then": [1], "else": [3]}],
            "in the kitchen",
        ),
        (
            "Find Rex. If he isn't in the yard, he's probably in the barn. Then lock the gate.",
            [{"if": [1, 2], "else": [3]}, 4],
            "in the barn",
        ),
        (
            "Get the map. If it's not in the car, it must be on the shelf.",
            [{"if": 2, "then": [1], "else": [3]}],
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


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("Find my cap. Start with the shed, and if it isn't there, try the attic.", "with the shed"),
        ("Try to find the pliers. Begin with the toolbox. If they're not there, look in the car.", "with the toolbox"),
        ("Look for the lantern. Start in the cellar. If it isn't in there, ask Lea.", "in the cellar"),
        ("Find my cap, start with the shed, and if it isn't there, try the attic.", "with the shed"),
    ],
)
def test_what_a_search_is_to_begin_with_is_searched(interpreter: Interpreter, text: str, place: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 2, 3], "else": [4]}]
    assert interpreter.interpret(text).tasks[1].value("location") == place


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Dust the study. Start with the shelf, then wipe the desk.", {"change_state"}),
        ("Find my cap and dust the hall, start to finish.", {"searching", "change_state"}),
        ("Peek in the drawers, starting with mine, and bring me the pen.", {"searching", "bringing"}),
    ],
)
def test_what_another_order_is_to_begin_with_is_no_search(interpreter: Interpreter, text: str, types: set[str]) -> None:
    assert {task.type for task in interpreter.interpret(text).tasks} == types


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Help me find the ring, I've checked the bed, so try the shelf or the box. If it's in neither, call Lea.",
         [{"if": [1, 2, 3], "else": [4]}]),
        ("Find the pen. Look on the desk or in the box. If it's in neither, call Lea.",
         [{"if": [1, 2, 3], "else": [4]}]),
        ("Find the pen, I've been through the car, so try the desk. If it isn't there, call Lea.",
         [{"if": [1, 2, 3], "else": [4]}]),
        ("Find the pen in the hall. Look in the box. If it's in neither, call Lea.", [1, {"if": [2, 3], "else": [4]}]),
        ("Can you find the pen? Try the desk. If it isn't there, call Lea.", [1, {"if": [2, 3], "else": [4]}]),
    ],
)  # fmt: skip
def test_where_to_look_for_what_is_to_be_found_is_the_same_search(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected
