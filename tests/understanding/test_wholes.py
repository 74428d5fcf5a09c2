"""What a condition asks of a part is done with the whole."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Carry the trunk to the loft, and if a hinge is loose, put it in the hall.", "the trunk"),
        ("carry the pram to the car and if a wheel squeaks leave it in the hall", "the pram"),
        ("Look at the trolley; if one wheel is broken, take it to the workshop.", "the trolley"),
        ("Fill the jug. If the handle's cracked, throw it away.", "the jug"),
        ("If the lid of the box is on the floor, put it on the table.", "the lid of the box"),
        ("Take the box to the kerb; if the lid is off, put it on the box first.", "the lid"),
        ("Fetch the pram, and if a wheel is missing, bring it from the garage.", "a wheel"),
        ("Empty the jar; if the lid is loose, tighten it.", "the lid"),
    ],
)
def test_a_part_is_put_nowhere_by_itself(interpreter: Interpreter, text: str, value: str) -> None:
    found = interpreter.interpret(text)
    verbs = [task for task in found.tasks if any(a.span and a.span.of(text) == "it" for a in task.arguments)]
    assert [task.value("object") for task in verbs] == [value]


@pytest.mark.parametrize(
    "text",
    ["Call the lift, and if none comes, take the stairs.", "Ring for a nurse and if none comes bring me the phone."],
)
def test_if_none_comes_is_of_the_case_in_which_nothing_does(interpreter: Interpreter, text: str) -> None:
    flow = interpreter.interpret(text).flow
    assert [(len(node.then), len(node.orelse)) for node in flow.nodes] == [(0, 1)]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Inspect the doorbell. If it's dead, press its button, and stand the stool under it.", "the doorbell"),
        ("Check the clock in the hall. Wind its spring and put the box beside it.", "the clock"),
    ],
)
def test_what_stands_by_a_part_stands_by_the_whole(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("goal") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Get the kit. If the shirt has stains on it, wash the shirt.", "the shirt"),
        ("If the coat has mud on it, brush it.", "the coat"),
        ("Find the case. If the purse has money in it, give it to the porter.", "the purse"),
    ],
)
def test_what_has_something_on_it_has_it_on_itself(interpreter: Interpreter, text: str, value: str) -> None:
    check = next(task for task in interpreter.interpret(text).tasks if task.type == "check_state")
    assert check.value("location") == value


def test_who_has_something_and_what_that_is_are_both_told(interpreter: Interpreter) -> None:
    text = "Take the parcel off the mat. Has it got my name on it? Bring it to me. Ann's name? Leave it at her door."
    assert interpreter.interpret(text).task(2).values("object") == ("the parcel", "my name")
