"""What somebody wants: brought where nothing else is ordered that it would be the reason of; and wanted states."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "who", "thing"),
    [
        ("I need a spoon.", "I", "a spoon"),
        ("Robot, I also need some envelopes, please.", "I", "some envelopes"),
        ("I need a coffee please, a big one.", "I", "a coffee"),
        ("I need something to dig with.", "I", "something to dig with"),
        ("If it rains, I need an umbrella.", "I", "an umbrella"),
        ("I'm soaked, I need a towel.", "I", "a towel"),
        ("I need water.", "I", "water"),
        ("I don't need the hammer, I need the saw.", "I", "the saw"),
        ("I don't want the red cup, I want the blue one.", "I", "the blue cup"),
        ("Lea needs her scarf.", "Lea", "her scarf"),
        ("My grandma wants a cup of tea.", "My grandma", "a cup of tea"),
        ("The twins are here. The kids want some juice.", "The kids", "some juice"),
    ],
)
def test_who_needs_a_thing_is_brought_it(interpreter: Interpreter, text: str, who: str, thing: str) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.type, task.value("recipient"), task.value("object")) == ("bringing", who, thing)


def test_a_thing_may_be_needed_somewhere(interpreter: Interpreter) -> None:
    (task,) = interpreter.interpret("We need two towels in here, the soft ones.").tasks
    assert (task.type, task.value("object"), task.value("goal")) == ("bringing", "two towels", "in here")


@pytest.mark.parametrize(
    "text",
    [
        "I need a nap.",
        "I need sleep.",
        "I need some help.",
        "I need more patience, and quietness.",
        "We need a new fridge.",
        "I don't need a spoon.",
        "Lea wants a dog.",
        "Lea wants to sleep.",
    ],
)
def test_what_nobody_brings_is_no_task(interpreter: Interpreter, text: str) -> None:
    assert not interpreter.interpret(text).tasks


def test_something_else_may_do_for_what_is_wanted(interpreter: Interpreter) -> None:
    found = interpreter.interpret("I need a spoon. If there's none, a fork will do.")
    assert found.flow.to_json() == [{"if": 2, "then": [1], "else": [3]}]


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Boil the kettle. I need hot water.", ["change_state"]),
        ("I need a spoon. Look in the drawer.", ["searching"]),
        ("I need a spoon. Is there one in the drawer?", ["check_state"]),
        ("I need a spoon. If it's in the drawer, bring it.", ["check_state", "bringing"]),
        ("Lea wants her scarf. Take it to her.", ["bringing"]),
        ("Tell Lea I need a spoon.", ["informing"]),
    ],
)
def test_a_want_is_no_task_beside_what_is_ordered_about_it(
    interpreter: Interpreter, text: str, types: list[str]
) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == types


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("If the fan is running, I'd like it off.", "the fan"),
        ("Check if the gate is shut. If it is, I want it open.", "the gate"),
        ("I'd like the lamp on, please.", "the lamp"),
    ],
)
def test_a_wanted_state_is_brought_about(interpreter: Interpreter, text: str, thing: str) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.type, task.value("object")) == ("change_state", thing)


@pytest.mark.parametrize(
    "text",
    ["I want my coat on.", "Tell Tom I want it off.", "If I want it off, I'll say so.", "I'd like it on the desk."],
)
def test_what_is_wanted_elsewhere_changes_no_state(interpreter: Interpreter, text: str) -> None:
    assert "change_state" not in [task.type for task in interpreter.interpret(text).tasks]


@pytest.mark.parametrize(
    "text",
    [
        "I need my scarf. If it isn't on the hook, bring the shawl.",
        "I need the ladder. It should be in the shed, but if it isn't, ask Tom.",
        "I want my boots. If they aren't under the bench, look in the hall.",
    ],
)
def test_what_is_done_where_it_is_not_found_leaves_the_want_standing(interpreter: Interpreter, text: str) -> None:
    want, check, _ = interpreter.interpret(text).tasks
    assert (want.type, check.type) == ("bringing", "check_state")
    assert want.value("object") == check.value("object")


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("I fancy a cup of coffee. If we have no milk, just bring me a tea.", [{"if": 2, "then": [1], "else": [3]}]),
        ("I could do with a plum. If we have no plums, bring me a fig.", [{"if": 2, "then": [1], "else": [3]}]),
        ("I need a saw. If we don't have one, fetch me the axe.", [{"if": 2, "then": [1], "else": [3]}]),
        ("I fancy a plum if there are any.", [{"if": 2, "then": [1]}]),
        ("I could murder a tea if the kettle's on.", [{"if": 2, "then": [1]}]),
        # no order of its own
        ("I fancy an omelette. If we have eggs, heat the pan.", [{"if": 1, "then": [2]}]),
        ("I fancy a walk. If we have no umbrella, tell me.", [{"if": 1, "else": [2]}]),
        ("I fancy a bath if the water is hot.", [1]),
    ],
)
def test_a_wish_is_an_order_beside_what_is_for_where_it_cannot_be_had(
    interpreter: Interpreter, text: str, flow: object
) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == flow
