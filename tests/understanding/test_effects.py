"""A bare "if it isn't" behind an order asks for the state that the order ends in."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("Turn the heater on if it isn't already.", "on"),
        ("Close the drawer if it isn't, and bring me the paper.", "closed"),
        ("Open the shutters unless they already are.", "open"),
        ("Fill the vase if it isn't yet.", "full"),
        ("Switch the fan and the lamp off, but only if they're on.", "on"),
        ("If the stew is cold, heat it, and if it isn't, bring it.", "cold"),
    ],
)
def test_a_condition_that_says_no_more_asks_whether_the_order_is_carried_out(
    interpreter: Interpreter, text: str, state: str
) -> None:
    found = interpreter.interpret(text)
    checks = [task for task in found.tasks if task.type == "check_state"]
    assert [check.value("state") for check in checks][:1] == [state]
    assert not found.missing


@pytest.mark.parametrize(
    ("text", "thing", "state"),
    [
        ("Turn on the fan. If that fails, try the heater.", "the heater", "on"),
        ("Open the shutters; if they're stuck, try the door.", "the door", "open"),
    ],
)
def test_what_is_tried_where_a_change_fails_is_changed_likewise(
    interpreter: Interpreter, text: str, thing: str, state: str
) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.type, task.value("object"), task.value("state")) == ("change_state", thing, state)


def test_where_something_is_looked_for_instead_nothing_is_changed(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring me the keys from the desk. If they aren't there, try the shelf.")
    assert (found.tasks[-1].type, found.tasks[-1].value("location")) == ("searching", "the shelf")


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("Bring me a clean jug. If there is none, wash one and bring it to me.", ["a clean jug", "a jug", "a jug"]),
        ("If there is no clean spoon, rinse one.", ["a spoon"]),
        ("Bring me a red jug. If there is none, wash one.", ["a red jug", "a red jug"]),
        ("Take the clean jug, wash it and bring it to me.", ["the clean jug", "the clean jug", "the clean jug"]),
    ],
)
def test_one_is_brought_into_a_state_that_it_is_not_in(interpreter: Interpreter, text: str, values: list[str]) -> None:
    tasks = interpreter.interpret(text).tasks
    assert [task.value("object") for task in tasks if task.type != "check_state"] == values
