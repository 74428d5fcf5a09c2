"""Clauses that order nothing and ask nothing, read past within an instruction."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Shut the hatch, because if those goats get in, I'll cry.", [1]),
        ("Leave the porch light on so that it looks as if somebody is in.", [1]),
        ("Turn on the heater, even if I'm out in the yard, and close the hatch.", [1, 2]),
        ("Air the loft, however cold it is, and fold the quilt.", [1, 2]),
        ("However late it is, fold the quilt.", [1]),
        ("Bring me the saw, whichever way you do it.", [1]),
        ("However, fold the quilt if it's dry.", [{"if": 2, "then": [1]}]),
        ("If the tiles are wet from me mopping them, put out the mat.", [{"if": 1, "then": [2]}]),
        ("If the fuse is out on account of that kettle acting up, tell Lea.", [{"if": 1, "then": [2]}]),
    ],
)
def test_what_is_said_in_passing_is_read_past(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Leave the lamp on so that it looks like we're home and lock the hatch.", [1, 2]),
        ("Shut the hatch, because if those goats get in, I'll cry, and feed the hens.", [1, 2]),
        ("Wipe the tiles on account of the kids spilling juice and mop the hall.", [1, 2]),
        ("Turn on the lamp because otherwise I can't see, and bring me the book.", [1, 2]),
        (
            "Bring the tea because if Tom is here he wants some, and if he isn't, drink it.",
            [1, {"if": 2, "else": [3]}],
        ),
        (  # a reason that orders something
            "Check the kettle is plugged in, because if it isn't, you'd better plug it in.",
            [{"if": [1, 2], "else": [3]}],
        ),
        (
            "If the lamp is on, turn it off so it looks tidy, and if it's hot, tell me.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        (
            "Turn off the lamp, and even if Tom is out, close the hatch. If it's wet, wipe it.",
            [1, 2, {"if": 3, "then": [4]}],
        ),
    ],
)
def test_what_orders_or_asks_is_no_digression(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_a_clipped_ing_is_read_as_the_whole(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If Tom is cookin', bring him the pan.")
    assert [task.type for task in found.tasks] == ["check_state", "bringing"]
    assert found.tasks[0].value("state") == "cookin'"


def test_from_whom_something_is_taken_is_no_cause(interpreter: Interpreter) -> None:
    (task,) = interpreter.interpret("Take the cup from the man sitting on the couch.").tasks
    assert task.value("source") == "from the man sitting on the couch"


def test_what_is_sworn_is_passed_over(interpreter: Interpreter) -> None:
    text = "If the iron's on, for heaven's sake turn it off, and bring the shirts down."
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == ["'s", "turn", "bring"]


@pytest.mark.parametrize(
    "text",
    [
        "Fetch the wheelbarrow. It's in the barn, unless somebody has borrowed it.",
        "Bring my scarf. It should be on the hook unless I left it at work.",
        "Bring my scarf, it's in the chest unless Ann took it.",
    ],
)
def test_where_something_may_not_be_is_no_ban(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).flow.to_json() == [1]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Bring my scarf unless Ann took it.", [{"if": 2, "else": [1]}]),
        (
            "Fetch the wheelbarrow. It's in the barn, unless Tom has borrowed it, in which case ask Ann.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
    ],
)
def test_what_an_order_hangs_on_stays(interpreter: Interpreter, text: str, expected: object) -> None:
    assert interpreter.interpret(text).flow.to_json() == expected
