"""A plural after an order that leaves its verb out the second time means the two of a kind in it."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter

_VESSELS = "the vase and the jug"


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("Bring Sue the stamps and Al the glue, then ask them if they want tea.", "recipient", "Sue and Al"),
        ("Give the map to Sue and the torch to Al and tell them it's late.", "recipient", "Sue and Al"),
        ("Take the soup to Sue and the stew to Al, and bring them a spoon.", "recipient", "Sue and Al"),
        ("Put the saw in the chest and the axe in the locker, then shut them.", "object", "the chest and the locker"),
        ("Take the ham from the oven and the pie from the pan and bring them.", "object", "the ham and the pie"),
        ("Put the vase on the sill and the jug on the desk. If they're wet, wipe them.", "object", _VESSELS),
        ("Bring me the map and the torch, then put them away.", "object", "the map and the torch"),
    ],
)  # fmt: skip
def test_what_a_plural_means_together(interpreter: Interpreter, text: str, kind: str, value: str) -> None:
    found = interpreter.interpret(text)
    plural = [a for task in found.tasks for a in task.arguments if a.span and a.span.of(text) in ("them", "they")]
    assert {(a.type, a.value) for a in plural} == {(kind, value)}


def test_who_may_be_meant_as_well_as_what_is_left_open(interpreter: Interpreter) -> None:
    text = "Take the soup to Sue and the stew to Al. If they're ready, tell me."
    assert interpreter.interpret(text).tasks[1].value("object") != "the stew and Al"
