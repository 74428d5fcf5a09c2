"""What may happen to whoever carries an order out is asked, and never brought about."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "If you break anything, tell me.",
        "If you wake the twins, call me.",
        "If you lose the token, use the spare one.",
        "If you get stuck, call Kim.",
        "If you make a mess, clean it up.",
        "If you have trouble with the lid, ask Kim.",
        "Should you need more plates, get them from the larder.",
        "If you run out of varnish, open the other tin.",
    ],
)
def test_what_may_happen_is_checked(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == [{"if": 1, "then": [2]}]
    assert found.tasks[0].type == "check_state"


def test_what_may_happen_on_the_way_keeps_nothing_from_the_order(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring me the goblets, and if you break one, tell Kim.")
    assert found.to_json()["flow"] == [1, {"if": 2, "then": [3]}]


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("If you can open the hatch, bring the rope.", ["change_state", "bringing"]),
        ("When you get a minute, wake the twins.", ["change_state"]),
        ("If you see the twins, wake them.", ["searching", "change_state"]),
    ],
)
def test_what_is_done_on_purpose_is_no_mishap(interpreter: Interpreter, text: str, types: list[str]) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == types


@pytest.mark.parametrize(
    "text",
    ["Take the urn to the attic and if you drop it, get the broom.", "Carry the vase up, and if you drop it, call me."],
)
def test_what_is_dropped_was_not_brought(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) in ([{"if": [1, 2], "else": [3]}], [1, {"if": 2, "then": [3]}])
