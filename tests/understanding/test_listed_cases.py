"""Cases that are told one by one: of several things, of states that are asked barely, of levels."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


def test_things_that_are_asked_of_in_a_list_are_asked_of_in_any_case(interpreter: Interpreter) -> None:
    text = (
        "See to the barn: if the trough is dry, fill it, if the gate has dropped, call Joe, and if a hen is in there, "
        "come to me."
    )
    *_, trough, gate, hen = flow(interpreter, text)
    assert [len(case["then"]) for case in (trough, gate, hen)] == [1, 1, 1]


def test_what_hangs_on_the_outcome_of_a_case_stays_in_it(interpreter: Interpreter) -> None:
    text = "If the bell rings, open the door, and if it's Tom, let him in, and if he's wet, bring him a towel."
    assert flow(interpreter, text) == [{"if": 1, "then": [2, {"if": 3, "then": [4, {"if": 5, "then": [6]}]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Lock the shed, feed the goat if her trough is empty, take Ann her mail, and ring Joe.",
        "Lock the shed, feed the goat if her trough is empty, bring me the paper, and ring Joe.",
    ],
)
def test_an_if_without_a_mark_is_of_the_order_ahead(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": 3, "then": [2]}, 4, 5]


def test_the_last_of_a_list_hangs_on_no_case_of_the_others(interpreter: Interpreter) -> None:
    text = "Water the ivy if it's dry, feed the dog if he's hungry, and bring me the paper."
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}, 5]


@pytest.mark.parametrize(
    "text",
    [
        "Look at the lamp on the meter. Red? Call Joe. Green? Dust the shelf. Off? Get the torch.",
        "Check on the pup. Whining? Open the crate. Awake? Fill his bowl. Fast asleep? Switch the lamp off.",
    ],
)
def test_states_that_are_asked_barely_exclude_each_other(interpreter: Interpreter, text: str) -> None:
    *_, case = flow(interpreter, text)
    first, second, third = case, case["else"][0], case["else"][0]["else"][0]
    assert [len(one["then"]) for one in (first, second, third)] == [1, 1, 1]
    assert "else" not in third


def test_too_much_so_is_asked_as_a_sentence_of_its_own(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Fill the tub and test the water. Too hot for Ann? Open the window.")
    assert [task.type for task in found.tasks][-2:] == ["check_state", "change_state"]
    assert found.tasks[-2].value("state") == "Too hot"
    assert found.flow.to_json()[-1]["then"] == [len(found.tasks)]


def test_levels_are_cases(interpreter: Interpreter) -> None:
    text = "Look at the thermostat. If under twenty-one, turn on the stove; if over twenty-six, open the hatch."
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3], "else": [{"if": 4, "then": [5]}]}]
