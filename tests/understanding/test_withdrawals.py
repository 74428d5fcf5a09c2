"""Orders that are taken back are no tasks; those taken back in one case only are left to the flow."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.withdrawals import withdrawn

GAZETTEER = Gazetteer({}, {}, frozenset())


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def words(parser: Parser, text: str) -> str:
    document = parser.parse(text)
    return " ".join(document.tokens[i].text for i in sorted(withdrawn(Observed(document, GAZETTEER))))


@pytest.mark.parametrize(
    ("text", "taken_back"),
    [
        ("Close the door. Actually, scratch that. Open the window.", "Close the door . scratch that"),
        ("Water the ferns, no, forget that, water the roses.", "Water the ferns , no , forget that"),
        ("Iron my shirt. Oh, never mind the shirt. Bring me a tie.", "Iron my shirt"),
        (
            "Bring the monitor. No, leave that, if you are there bring me a scarf.",
            "Bring the monitor . No , leave that",
        ),
        ("Sweep the step, hoover the stairs, no, forget the stairs, and wipe the tiles.", "hoover the stairs"),
    ],
)
def test_what_is_taken_back(parser: Parser, text: str, taken_back: str) -> None:
    assert words(parser, text) == taken_back


@pytest.mark.parametrize(
    "text",
    [
        "Bring me the soup. If it is cold, forget that.",
        "Close the door and never mind the noise.",
        "Bring me the book that I never mind reading.",
    ],
)
def test_what_is_not(parser: Parser, text: str) -> None:
    assert words(parser, text) == ""


def test_a_task_that_is_taken_back_is_none() -> None:
    text = "Close the door. Scratch that. Open the window."
    found = Interpreter.load("household", encoder=False).interpret(text)
    assert [task.span.of(text) for task in found.tasks] == ["Open"]
