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
