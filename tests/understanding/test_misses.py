"""What cannot be found was to be fetched or looked for, whatever else was asked of it in between."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow, unordered

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "Bring me the ladle. If it's greasy, wash it first. If you can't find it, bring me a spoon.",
        "Fetch my cap. If it's dusty, brush it first. If you can't find it, bring my scarf.",
    ],
)
def test_what_is_seen_to_first_is_asked_ahead_of_the_fetching(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [3]}, {"if": [1, 4], "else": [5]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Get the lantern from the shed. If the battery's flat, charge it. If you can't find it, borrow Kim's.",
            {"if": [1, 4], "then": [{"if": 2, "then": [3]}], "else": [5]},
        ),
        (
            "Bring my cape from the attic. If it's wet, hang it up to dry. If it's not there, look in the car.",
            {"if": 4, "then": [1, {"if": 2, "then": [3]}], "else": [5]},
        ),
    ],
)
def test_what_was_fetched_is_looked_over_only_where_it_was_found(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == [expected]


def test_what_is_not_so_is_no_failure_to_find(interpreter: Interpreter) -> None:
    text = "Look at the pie. If it's brown, take it out; if it's not, shut the oven."
    assert flow(interpreter, text) == [1, {"if": [2, 4], "then": [3], "else": [5]}]


@pytest.mark.parametrize(
    "text",
    [
        "If the lantern is empty, get one from the shed. If there is no lantern in the shed, tell me.",
        "If the jar is broken, get one from the larder. If there are no jars in the larder, tell me.",
    ],
)
def test_none_where_one_was_to_be_got_is_asked_only_then(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 3, "then": [2], "else": [4]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Check for flour and let me know, and if there isn't any, go to the shop.",
            [{"if": [1, 3], "then": [{"same": [2]}], "else": [2, 4]}],
        ),
        (
            "Check whether the hatch is locked and tell me. If it isn't, lock it.",
            [{"if": [1, 3], "then": [{"same": [2]}], "else": [2, 4]}],
        ),
        ("Find Lea and tell her. If she isn't there, call me.", [{"if": [1, 3], "then": [2], "else": [4]}]),
        ("Look for flour and tell me, otherwise go to the shop.", [{"if": 1, "then": [2], "else": [3]}]),
    ],
)
def test_what_was_found_out_is_told_in_either_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert unordered(flow(interpreter, text)) == unordered(expected)


@pytest.mark.parametrize(
    "text",
    [
        "Look for the urn in the attic. If it isn't there, look in the larder. If you find it, bring it to me.",
        "Look for the urn on the shelf. If it's not there, look in the larder. When you find it, bring it here.",
    ],
)
def test_what_is_found_in_either_place_is_brought(interpreter: Interpreter, text: str) -> None:
    (case,) = flow(interpreter, text)
    assert case == {"if": [1, 2], "then": [5], "else": [{"if": [3, 4], "then": [{"same": [5]}]}]}


def test_what_is_found_in_the_one_place_is_brought(interpreter: Interpreter) -> None:
    text = "Look for the urn in the attic. If you find it, bring it to me."
    assert flow(interpreter, text) == [{"if": [1, 2], "then": [3]}]
