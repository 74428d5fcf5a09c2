"""Who is given a hand gets nothing, and who is given a ring is called."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Give Ida a hand with the crates.", []),
        ("Lend us a hand.", []),
        ("Give Leo a hand, then mop the porch.", [1]),
        ("Give us a hand finding my other boot.", [1]),
        ("Give Ida a hand towel.", [1]),
        ("Give the baker a hand of bananas.", [1]),
    ],
)
def test_to_give_a_hand_is_no_order_of_its_own(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_who_is_given_a_hand_gets_nothing_else(interpreter: Interpreter) -> None:
    (mop,) = interpreter.interpret("Give Leo a hand with the crates, then mop the porch.").tasks
    assert {a.type: a.value for a in mop.arguments} == {"object": "the porch"}


@pytest.mark.parametrize(
    ("text", "type"),
    [
        ("Give the roofer a ring if the attic is damp.", "informing"),
        ("Give my brother a bell.", "informing"),
        ("Give the caretaker a shout when it's done.", "informing"),
        ("Give the bride a ring from the box.", "bringing"),
        ("Give the bride the ring.", "bringing"),
    ],
)
def test_who_is_given_a_ring_is_called(interpreter: Interpreter, text: str, type: str) -> None:
    task = interpreter.interpret(text).tasks[0]
    assert task.type == type


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Fetch Ida her cane, then help her up.", {"object": "Ida"}),
        ("Open the gate, then help Grandpa down the ramp.", {"object": "Grandpa", "path": "down the ramp"}),
        ("Open the gate and help the guest to her car.", {"object": "the guest", "goal": "to her car"}),
        ("If Ida is tired, help her to bed.", {"object": "Ida", "goal": "to bed"}),
        ("Help Grandpa down the ramp.", {"object": "Grandpa", "path": "down the ramp"}),
    ],
)
def test_who_is_helped_somewhere_is_gone_with(interpreter: Interpreter, text: str, expected: dict[str, str]) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.type, {a.type: a.value for a in task.arguments}) == ("following", expected)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Fetch the sheets, then help Ida fold them.", ["bringing", "change_state"]),
        ("Help Ida to fold the sheets.", ["change_state"]),
        ("Bring the chair, then help me with the curtains.", ["bringing"]),
    ],
)
def test_who_is_helped_with_something_is_not(interpreter: Interpreter, text: str, expected: list[str]) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == expected
