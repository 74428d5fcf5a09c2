"""Accounts: sentences that only tell how things are, and orders that hang on nothing said ahead of them."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("The oven is on and the kettle is off. Turn the oven off.", "the oven"),
        ("The window is open but the door is closed. Shut the window.", "the window"),
        ("I am cold and the heater is off. Turn it on.", "the heater"),
        ("Dinner is ready and the guests are here. Open the gate.", "the gate"),
        ("I think the shutter is open and the door isn't locked. Shut the shutter.", "the shutter"),
    ],
)
def test_what_two_clauses_tell_is_no_case(interpreter: Interpreter, text: str, thing: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert [a.value for a in task.arguments if a.type == "object"] == [thing]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Tom is in the garden and Anna is in the kitchen. Bring them the tea.", [1]),
        ("Either the mop is in the hall or it's in the shed. Bring it to me.", [1]),
        ("Either shut the hatch or light the stove.", [{"if": 1, "else": [2]}]),
        ("You can find the screws in the shed. Bring me five of them.", [1]),
        ("If you can find the screws in the shed, bring me five of them.", [{"if": 1, "then": [2]}]),
        ("The oven is on and the kettle is off. If the kettle is hot, turn the oven off.", [{"if": 1, "then": [2]}]),
        (
            "Is the oven on and the kettle off? Then turn the oven off.",
            [{"if": 1, "then": [{"if": 2, "then": [3]}]}],
        ),
        (
            "The gate is shut and the hens are in. True: lock it. False: tell Lea.",
            [{"if": 1, "then": [{"if": 2, "then": [3], "else": [4]}], "else": [{"same": [4]}]}],
        ),
    ],
)
def test_only_what_is_asked_or_taken_up_is_a_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Go to the hall and look for my keys. If you can't find them, call me.", [1, {"if": [2, 3], "else": [4]}]),
        ("Wash the bowl. If you can't find the hammer, bring me the saw.", [1, {"if": 2, "else": [3]}]),
        ("Look for my keys. If you can't find them, call me.", [{"if": [1, 2], "else": [3]}]),
    ],
)
def test_only_a_look_for_it_fails_where_it_is_not_found(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_what_is_seen_is_asked_once(interpreter: Interpreter) -> None:
    text = "Check whether you can see the cat. If so, open the hatch, if not, call Lea."
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [3]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If you don't know where the salt is, ask me.", [{"if": 1, "else": [2]}]),
        ("If you don't know what it is, leave it there.", [{"if": 1, "else": [2]}]),
        ("See who is at the gate, and if it's Lea, let her in.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_whether_one_knows_is_a_case_and_what_one_is_to_see_is_none(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


def test_asking_for_a_favour_is_no_case(interpreter: Interpreter) -> None:
    text = "Would you mind if I asked you to go to the shed? And then put the rake on the shelf."
    assert flow(interpreter, text) == [1, 2]
    assert {a.type for task in interpreter.interpret(text).tasks for a in task.arguments} == {"goal", "object"}


def test_who_is_said_to_be_somewhere_is_not_joined_to_the_place_before(interpreter: Interpreter) -> None:
    (task,) = interpreter.interpret("Tom is in the garden and Anna is in the kitchen. Bring them the tea.").tasks
    assert "garden" not in next(a.value for a in task.arguments if a.type == "recipient")
