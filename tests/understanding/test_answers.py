"""What somebody may answer, choose or ask for is a case each, and who they are is said by a pronoun again."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "If Lea wants soup, heat the pot. If she wants cake, lay the table.",
        "If she says tea, fill the jug, and if she says coffee, bring the pot.",
        "If the guests choose ice cream, get bowls, if they choose pie, get plates.",
    ],
)
def test_one_answer_is_not_the_other(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}]


def test_somebody_may_ask_for_both(interpreter: Interpreter) -> None:
    text = "If Lea asks for tea, make some. If she asks for water, fill the jug."
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}]


@pytest.mark.parametrize(
    "text",
    [
        "If he says yes, open the hatch, and if he says no, close it.",
        "If Kim is hungry, heat the soup. If he isn't hungry, close the lid.",
    ],
)
def test_yes_and_no_are_one_question(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}]


def test_nobody_is_what_they_answer(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Ask her what she wants. If she says tea, bring her a cup.")
    assert found.tasks[-1].value("recipient") == "her"


@pytest.mark.parametrize(
    "text",
    [
        "Don't open the hatch unless it's Aunt Lea. If it is her, take her coat.",
        "Don't open the hatch unless it's Tom. If it's him, take his coat.",
    ],
)
def test_who_it_is_once_more_affirms_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [2, 3], "then": [1, 4]}]


@pytest.mark.parametrize(
    "text",
    [
        "Ask Lea if she wants a fig. If she says yeah bring her one, if she says nah come back.",
        "Ask Tom if he's cold. If he says yep, light the stove; if he says nope, open the hatch.",
    ],
)
def test_yeah_and_nah_are_yes_and_no(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": [2, 4], "then": [3], "else": [5]}]
