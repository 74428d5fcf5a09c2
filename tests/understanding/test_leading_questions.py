"""What is asked as "it's on isn't it?" or "isn't it on?" is whether it is."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("the hatch is open isn't it? shut it", [{"if": 1, "then": [2]}]),
        ("the fan's on isn't it? switch it off", [{"if": 1, "then": [2]}]),
        ("there's juice isn't there? bring me some", [{"if": 1, "then": [2]}]),
        ("you watered the ferns didn't you? if not water them", [{"if": 1, "else": [2]}]),
        ("Kim's asleep, isn't she? Cover her up.", [{"if": 1, "then": [2]}]),
        ("she isn't asleep is she? wake her up", [{"if": 1, "then": [2]}]),
    ],
)
def test_a_tag_denies_nothing(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("isn't the hatch open? if so shut it", [{"if": 1, "then": [2]}]),
        ("didn't we have some rice left, if so heat it up", [{"if": 1, "then": [2]}]),
        ("hasn't the tea brewed? if so pour me a cup", [{"if": 1, "then": [2]}]),
        ("isn't the hatch locked? if not lock it", [{"if": 1, "else": [2]}]),
        ("Isn't the fan on? If it isn't, switch it on.", [{"if": [1, 2], "else": [3]}]),
    ],
)
def test_what_an_answer_takes_up_is_whether_it_is_so(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("Isn't the fan on? Switch it off.", "then"),
        ("Isn't the fan on? Switch it on.", "else"),
        ("The hatch isn't shut, is it? Shut it.", "else"),
        ("Is the hatch open? Shut it.", "then"),
        ("Is the fan on? Switch it on if not.", "else"),
        ("Is the fan on? Switch it off if so.", "then"),
    ],
)
def test_what_is_seen_to_is_what_is_not_yet_so(interpreter: Interpreter, text: str, side: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, side: [2]}]


def test_dry_weather_is_the_other_answer(interpreter: Interpreter) -> None:
    text = "it isn't raining is it? if it's dry out hang up the towels"
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}]
