"""That there is none of what is to be fetched in a case is no other side of the case."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "If Kim is hungry, bring her a plum, and if there isn't any, bring her toast.",
        "If Kim is hungry, bring her a plum, and if we don't have any, bring her toast.",
        "If Kim's cold, fetch her a shawl. If there's none, bring her a coat.",
        "If the guests want crisps, bring them some, and if there aren't any, bring nuts.",
        "If Kim is hungry, bring her an apple, and if there are none left, tell her.",
    ],
)
def test_what_is_to_be_fetched_in_a_case_may_be_lacking(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 3, "then": [2], "else": [4]}]}]


def test_what_has_run_out_is_asked_ahead(interpreter: Interpreter) -> None:
    text = "If Kim is hungry, bring her an apple. If we're out of apples, bring her toast."
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 3, "then": [4], "else": [2]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If there's juice, bring it, and if there isn't any, tell me.", [{"if": [1, 3], "then": [2], "else": [4]}]),
        (
            "If Kim isn't hungry, bring her a book, and if she is, bring her toast.",
            [{"if": [1, 3], "then": [4], "else": [2]}],
        ),
    ],
)
def test_the_other_side_of_the_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected
