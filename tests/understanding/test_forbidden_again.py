"""Orders that a case behind them forbids, with or without a mark, and what is said instead."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow, unordered

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Iron the apron and fold the napkins. If the apron is damp, don't iron it, hang it up.",
            [{"if": 3, "then": [5], "else": [{"same": [1, 4]}]}, 2],
        ),
        (
            "Sweep the porch and mop the hall, but if Gran's asleep, don't mop; wipe the shelf instead.",
            [1, {"if": 3, "then": [5], "else": [{"same": [2, 4]}]}],
        ),
        (
            "Sweep the porch and mop the hall, but if Gran's asleep don't mop, wipe the shelf instead.",
            [1, {"if": 3, "then": [4], "else": [2]}],
        ),
    ],
)
def test_the_forbidden_order_hangs_on_the_case_alone(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_a_case_needs_no_mark_ahead_of_what_it_forbids(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Feed the dog and walk him, but if it's icy don't walk him.") == [
        1,
        {"if": 3, "else": [2]},
    ]


def test_what_somebody_does_not_do_is_a_case(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If the mugs that are left don't fit, tell Joe.")
    assert [task.type for task in found.tasks] == ["check_state", "informing"]


def test_what_is_to_be_done_there_hangs_on_going_there(interpreter: Interpreter) -> None:
    text = "Go to the attic and wipe the shelf. If the lamp's off, don't go in, call me."
    assert unordered(flow(interpreter, text)) == [{"if": 3, "then": [4], "else": [1, 2]}]


def test_a_no_that_answers_takes_nothing_back(interpreter: Interpreter) -> None:
    text = "Pipe leaking? Yes: put a bowl under it. No: forget about it."
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}]
