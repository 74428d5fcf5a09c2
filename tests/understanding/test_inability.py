"""What somebody cannot do is a case and never ordered."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "If the hatch is stuck and you can't open it, call Kim.",
        "If the crate is heavy and you cannot lift it, fetch the trolley.",
        "If the lamp is on the ceiling and you can't reach it, get the steps.",
        "If the drawer is jammed and you don't manage to pull it open, tell Kim.",
    ],
)
def test_what_cannot_be_done_is_the_second_of_two_conditions(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 2, "else": [3]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If Kim isn't in and you can't open the hatch, call me.", [{"if": 1, "else": [{"if": 2, "else": [3]}]}]),
        (
            "If the hatch is locked or you can't open it, call me.",
            [{"if": 1, "then": [3], "else": [{"if": 2, "else": [{"same": [3]}]}]}],
        ),
        ("Fetch the crate and tell Kim if you can't carry it.", [{"if": [1, 3], "else": [2]}]),
        (
            "If the crate is full, lift it and call Kim if you can't lift it.",
            [{"if": 1, "then": [{"if": [2, 4], "else": [3]}]}],
        ),
        ("If the hatch is open and it rains, close it.", [{"if": 1, "then": [{"if": 2, "then": [3]}]}]),
    ],
)
def test_other_cases_with_it(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_what_is_done_where_it_cannot_is_ordered(interpreter: Interpreter) -> None:
    text = "if you can get the urn down bring it here if you cant fetch the steps from the shed"
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [3]}]
