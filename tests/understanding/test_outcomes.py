"""Outcomes: whether a thing does what it was made to, and where to look for what is to be found."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Light the burner. If it lights, put the pot on it, if not, tell Lea.",
            [{"if": [1, 2], "then": [3], "else": [4]}],
        ),
        (
            "Start the pump. If it starts, great. If it doesn't, call Ravi.",
            [{"if": [1, 2, 3], "else": [4]}],
        ),
        ("Open the chest. If it opens, take the maps out.", [{"if": [1, 2], "then": [3]}]),
    ],
)
def test_whether_it_does_so_tells_how_the_order_went(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_what_is_so_before_is_no_outcome(interpreter: Interpreter) -> None:
    text = "If the radio is off, turn it on. If it's on, turn it off."
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}]


def test_where_to_look_is_the_same_search(interpreter: Interpreter) -> None:
    text = "Find my glasses. Check the sofa and the sill, and if you still can't find them, ask Lea."
    assert flow(interpreter, text) == [{"if": [1, 2, 3], "else": [4]}]


def test_a_search_for_something_else_is_another_one(interpreter: Interpreter) -> None:
    text = "Find Lea in the yard. Look for her dog, and if it's not there, tell me."
    assert flow(interpreter, text) == [1, {"if": [2, 3], "else": [4]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Find the hat and put it in my bag. If it won't fit, put it in the box instead.",
         [1, {"if": 3, "then": [2], "else": [4]}]),
        ("Find the jug with the blue lid and put it in the fridge. If it doesn't fit, put it in the cellar.",
         [1, {"if": 3, "then": [2], "else": [4]}]),
        ("Find the hat and put it in my bag. If you can't find it, bring me the cap instead.",
         [{"if": [1, 3], "then": [2], "else": [4]}]),
        ("Find the hat and put it in my bag. If it isn't in the hall, bring me the cap instead.",
         [{"if": [1, 3], "then": [2], "else": [4]}]),
    ],
)  # fmt: skip
def test_whether_a_thing_fits_is_no_outcome_of_the_search_for_it(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected
