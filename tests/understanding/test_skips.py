"""Orders that need not be carried out in a case which names them: "if it's clean already, skip the washing"."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Peel the carrots and put them in the pot. If they're peeled already, skip the peeling.",
            [{"if": 3, "else": [1]}, 2],
        ),
        (
            "Sweep the porch, water the ferns and lock the shed. If the soil is wet, no need to water them.",
            [1, {"if": 4, "else": [2]}, 3],
        ),
        (
            "Iron the shirts and hang them in the closet. If they're still damp, don't bother ironing them.",
            [{"if": 3, "else": [1]}, 2],
        ),
        (
            "Dust the shelf, vacuum the rug and feed the cat, skipping the vacuuming if Lea is asleep.",
            [1, {"if": 4, "else": [2]}, 3],
        ),
        (
            "Wash the vase and put it back. If it's clean already, don't wash it, just dry it.",
            [{"if": 3, "then": [4], "else": [1]}, 2],
        ),
    ],
)
def test_the_order_whose_verb_is_named_is_skipped(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_without_its_verb_the_order_before_is_skipped(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Mow the lawn, but if it's wet, skip it.") == [{"if": 2, "else": [1]}]
