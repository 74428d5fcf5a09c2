"""That an order failed may be said behind what is to be done then."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "Look for my ring. Wake Kim if you can't find it.",
        "Search the cellar for the drill and ask Kim if you don't find it.",
        "Look in the pantry for rice, then tell me if you haven't found any.",
        "Fetch the rug from the attic and text Kim if you don't see it.",
        "Shut the hatch and call Kim if you can't shut it.",
        "Unlock the trunk and call Kim if it won't unlock.",
        "Look in the bin for apples and get me a plum if there are none.",
        "See if there's rice and buy some if there isn't any left.",
        "See if Kim is in the garden and call me if she's not there.",
    ],
)
def test_what_is_said_behind_it_to_fail_is_the_other_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 3], "else": [2]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Look for my ring and bring it to me if you find it.", [{"if": [1, 3], "then": [2]}]),
        (
            "Look for my ring and call me if you can't find it, otherwise bring it here.",
            [{"if": [1, 3], "then": [4], "else": [2]}],
        ),
        (
            "Look for my ring. If you find it, bring it here. Call Kim if you can't find it.",
            [{"if": [1, 2, 5], "then": [3], "else": [4]}],
        ),
        (
            "Look for my ring. If you can't find it, call Kim. Bring it here if you find it.",
            [{"if": [1, 2, 5], "then": [4], "else": [3]}],
        ),
        (
            "Is Kim up? If she isn't, wake her, and bring her the tea if she is.",
            [{"if": [1, 2, 5], "then": [4], "else": [3]}],
        ),
        ("Shut the hatch and call Kim if you can't shut it, then come back.", [{"if": [1, 3], "else": [2]}, 4]),
    ],
)
def test_the_cases_of_one_order_are_told_apart(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Move the chest and call Kim if you can't manage.",
        "Push the trolley into the garage and ask Kim if you can't manage it.",
        "Draw the blinds and let me know if you can't.",
    ],
)
def test_a_bare_failure_is_of_the_order_before(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "else": [2]}]


@pytest.mark.parametrize(
    "text",
    [
        "If the hatch is locked, open it, or call Kim if you can't.",
        "If the hatch is locked, open it and call Kim if you can't.",
        "If the blind is up, lower it, and tell Kim if you can't.",
    ],
)
def test_a_failure_in_a_case_is_of_what_is_done_in_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 2, "else": [3]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "If Kim wants a cup, bring her one, or tell me if you can't find one.",
        "If the trunk is locked, unlock it, and call Kim if it won't unlock.",
        "If the hatch is shut, open it, or call Kim if you can't open it.",
    ],
)
def test_a_failure_told_in_full_in_a_case_is_of_what_is_done_in_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": [2, 4], "else": [3]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "If you can find the rake, bring it here, or call Kim if you can't.",
        "If you can find the rake, bring it here and call Kim if you can't.",
        "If it's dark, light the lamp and draw the blinds if not.",
    ],
)
def test_what_was_asked_first_is_what_fails(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [3]}]


def test_what_somebody_wants_to_know_is_told(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Tell me if you can't hear me.") == [1]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Take the tart to Kim and leave it on the step if she's not home.", [{"if": 3, "then": [1], "else": [2]}]),
        ("Bring Kim the paper and put it on her desk if she's out.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Carry the soup to Grandpa and put it on the stove if he's asleep.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Take the tart to Kim and text me if there's nobody home.", [{"if": 3, "then": [1], "else": [2]}]),
        ("Take the tart to Kim and wake her if she's asleep.", [{"if": 3, "then": [1, 2]}]),
        ("Take the rug to the yard and beat it if it's dusty.", [{"if": 3, "then": [1, 2]}]),
    ],
)
def test_a_thing_is_handed_over_where_nothing_keeps_from_it(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected
