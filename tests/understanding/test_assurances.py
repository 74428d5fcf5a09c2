"""What somebody makes sure of, and of what they make sure that it does not hold."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "thing", "state"),
    [
        ("Make sure the heater is on.", "the heater", "on"),
        ("Make sure the heater is not on.", "the heater", "off"),
        ("Make sure the heater is off and the drawer isn't open.", "the drawer", "closed"),
        ("Ensure that the plates aren't dirty.", "the plates", "clean"),
        ("See to it that the drawer is never open.", "the drawer", "closed"),
        ("Be sure the gate isn't left unlocked.", "the gate", "locked"),
        ("Make sure the fan is no longer running.", "the fan", "off"),
        ("Make sure the dough isn't lumpy.", "the dough", "not lumpy"),
        ("Make sure no lamp is on.", "every lamp", "off"),
        ("Make sure none of the drawers is open.", "all of the drawers", "closed"),
    ],
)
def test_what_is_made_sure_not_to_hold_is_undone(interpreter: Interpreter, text: str, thing: str, state: str) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.type, task.value("object"), task.value("state")) == ("change_state", thing, state)


def test_what_is_denied_and_then_asked_for_is_a_check_of_the_state(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Make sure the heater isn't on. If it is, turn it off.")
    assert [(task.type, task.value("state")) for task in found.tasks[:1]] == [("check_state", "on")]
    assert found.flow.to_json() == [{"if": [1, 2], "then": [3]}]


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Make sure the gate is shut and the hose is off, and if she wants one, bring Ann a cup.",
         ["change_state", "change_state", "check_state", "bringing"]),
        ("Make sure the hose is off, and if I am late, sweep the hall.",
         ["change_state", "check_state", "change_state"]),
        ("Make sure the hose is off, and if it isn't, call me.", ["check_state", "check_state", "informing"]),
    ],
)  # fmt: skip
def test_a_later_case_of_somebody_does_not_take_it_up(interpreter: Interpreter, text: str, types: list[str]) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == types


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "Make sure the fan's off, the heater's off and the gate's locked.",
            [("the fan", "off"), ("the heater", "off"), ("the gate", "locked")],
        ),
        (
            "Ensure that the shed is shut, the hose isn't running and the lamp is on.",
            [("the shed", "shut"), ("the hose", "off"), ("the lamp", "on")],
        ),
        ("Make sure the radio is off, the fan is off.", [("the radio", "off"), ("the fan", "off")]),
        ("Make sure the radio and the fan are off.", [("the radio and the fan", "off")]),
        ("Make sure the drawer is shut, the wind is strong.", [("the drawer", "shut")]),
        ("Make sure the drawer is shut, the key is in the hall.", [("the drawer", "shut")]),
    ],
)
def test_each_thing_that_is_made_sure_of_is_an_order(
    interpreter: Interpreter, text: str, told: list[tuple[str, str]]
) -> None:
    found = interpreter.interpret(text)
    assert [(task.value("object"), task.value("state")) for task in found.tasks] == told
    assert {task.type for task in found.tasks} == {"change_state"}
    assert found.flow.to_json() == [*range(1, len(told) + 1)]


def test_a_list_that_is_asked_for_behind_it_is_none_of_orders(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Make sure the fan is off and the heater is off. If it isn't, call me.")
    assert [task.type for task in found.tasks][:1] == ["check_state"]
