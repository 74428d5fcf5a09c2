"""What is only to be waited for is no order, and nothing in it is what another order is about."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If the rice is still hard, give it three more minutes, otherwise drain it.", [{"if": 1, "else": [2]}]),
        ("If the pie isn't done, give it another half hour, otherwise take it out.", [{"if": 1, "then": [2]}]),
        ("Give us a few minutes and then bring the tea.", [1]),
        ("Give Lea a bit of cake.", [1]),
        ("Give him the hour hand if he is building the clock.", [{"if": 2, "then": [1]}]),
    ],
)
def test_to_give_it_some_time_is_no_order(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_the_time_given_is_not_what_is_handled_then(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Hang up the rug. Give it an hour, and if it's still wet, hang it in the cellar.")
    assert not any("hour" in value for task in found.tasks for value in task.values("object"))
