"""Purposes: what something is done for, or to be avoided by it, is no order."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("Open the hatch to let the steam out and lay the towel over the rail.", ["Open", "lay"]),
        ("Shut the parlour door to keep the heat in, then bring me the shawl.", ["Shut", "bring"]),
        ("Put a lid on the pan to keep the soup warm.", ["Put"]),
        ("Wipe the screen, taking care not to scratch it, and dust the shelf.", ["Wipe", "dust"]),
        ("Close the nursery door so as not to wake the twins.", ["Close"]),
    ],
)
def test_a_purpose_is_no_task(interpreter: Interpreter, text: str, verbs: list[str]) -> None:
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == verbs


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("Go down to the cellar to fetch the pears.", ["Go", "fetch"]),
        ("I need you to polish the boots.", ["polish"]),
        ("Run to the gate to see if the van is there.", ["Run", "see"]),
    ],
)
def test_where_one_goes_to_do_something_that_is_ordered(interpreter: Interpreter, text: str, verbs: list[str]) -> None:
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == verbs


def test_what_a_purpose_names_is_no_argument(interpreter: Interpreter) -> None:
    text = "Open the skylight to get the smell of paint out and hang the coat over the chair."
    opened, _ = interpreter.interpret(text).tasks
    assert [argument.value for argument in opened.arguments if argument.type == "object"] == ["the skylight"]
