"""When something is to be done is told, not heeded, and said so."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.cases.times import times


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("In ten minutes, turn off the oven.", ["In ten minutes"]),
        ("Turn the heater on for half an hour.", ["for half an hour"]),
        ("Later, bring me the book; tonight water the ferns.", ["Later", "tonight"]),
        ("Wake me at half past six.", ["at half past six"]),
        ("Wake me at 7 a.m. and at noon call Ann.", ["at 7 a.m.", "at noon"]),
        ("Bake it at 180 degrees.", []),
        ("My bus leaves in half an hour, so bring me the coat.", []),
        ("The shop shuts at six. Come here in ten minutes.", ["in ten minutes"]),
        ("If Ann comes in ten minutes, open the door.", ["in ten minutes"]),
        ("Bring me two cups, and put them in the box.", []),
        ("Come back later than Ann.", []),
        ("Look in the third drawer for an hourglass.", []),
    ],
)
def test_times_are_found(parser: Parser, text: str, told: list[str]) -> None:
    document = parser.parse(text)
    assert [document.span(time.start, time.stop - 1).of(text) for time in times(document)] == told


def test_a_time_is_warned_of_unless_somebody_is_told_it() -> None:
    interpreter = Interpreter.load("household", encoder=False)
    assert any("'In ten minutes'" in w for w in interpreter.interpret("In ten minutes, turn off the oven.").warnings)
    assert not interpreter.interpret("Tell Anna that dinner is at seven.").warnings
