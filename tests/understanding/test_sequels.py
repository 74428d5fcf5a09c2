"""A list that names no verb again tells to what an order is done next."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "kind", "values"),
    [
        ("Feed the spaniel, then the terrier, and finally the goat.", "object", 3),
        ("Dust the shelf, then the desk, then the piano.", "object", 3),
        ("Shut the side gate, then the shutters, and lastly the hatch.", "object", 3),
        ("Hand me the drill, and then the saw, please.", "object", 2),
        ("Look for my keys in the attic, then the cellar, and finally the shed.", "location", 3),
        ("Sweep the house: first the porch, then the hall.", "object", 3),
    ],
)
def test_an_order_goes_on_to_what_a_list_names_next(
    interpreter: Interpreter, text: str, kind: str, values: int
) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == [1]
    assert sum(argument.type == kind for argument in found.tasks[0].arguments) == values


def test_what_is_next_is_told_by_its_noun(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Rinse the green jug, then the white one, and dry the tray.")
    assert found.to_json()["flow"] == [1, 2]
    assert [a.value for a in found.tasks[0].arguments] == ["the green jug", "the white jug"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Open the hatch, then the cat can come in.", [1]),
        ("Walk the dog, then wash the van.", [1, 2]),
        ("Put the jug on the tray, then the mug on the shelf.", [1]),
    ],
)
def test_a_clause_of_its_own_is_no_next_thing(interpreter: Interpreter, text: str, expected: object) -> None:
    assert flow(interpreter, text) == expected
