"""What is done in vain, behind which its case is told, is what an "if that doesn't help" is of."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "Shut the hatch if it's open. If you can't, call Kim.",
        "Scrub the pan if it's greasy. If that doesn't help, throw it away.",
        "Dust the shelf if it's dirty, and if that doesn't work, tell me.",
        "Open the hatch if it's hot. If that's not possible, call Kim.",
    ],
)
def test_the_order_fails_and_not_its_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [{"if": 1, "else": [3]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Switch on the fan if it's hot. If it doesn't work, open the hatch.",
        "Open the trunk if it's shut. If it won't open, bring it to me.",
    ],
)
def test_that_a_thing_does_not_do_it_is_of_the_order(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [{"if": [1, 3], "else": [4]}]}]


def test_what_cannot_be_found_beside_is_no_other_side_of_the_case(interpreter: Interpreter) -> None:
    text = "Lock the cupboard if it's open. If you can't find the key, call Kim."
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}, {"if": 3, "else": [4]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Shut the hatch if you can reach it. If you can't, call Kim.", [{"if": 2, "then": [1], "else": [3]}]),
        ("Bring me the soup if it's hot. If it isn't, heat it.", [{"if": [2, 3], "then": [1], "else": [4]}]),
        ("Call me if it snows. If it doesn't, come home.", [{"if": [2, 3], "then": [1], "else": [4]}]),
    ],
)
def test_the_other_side_of_a_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected
