"""A "no" without a mark takes an order back only where another order stands behind it."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.speech.marks import marked


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("turn the radio on no turn it off", "turn the radio on, no, turn it off"),
        ("lift the no sweep the steps", "lift the, no, sweep the steps"),
        ("fetch the ladder no wait leave it there", "fetch the ladder, no wait, leave it there"),
        ("tell bea no tell leo that supper is ready", "tell bea, no, tell leo that supper is ready"),
        ("put the vase here no if it's cracked bin it", "put the vase here, no, if it's cracked bin it"),
    ],
)
def test_what_takes_an_order_back_is_marked(parser: Parser, text: str, plain: str) -> None:
    found = marked(parser.parse(text))
    assert found is not None
    assert found.text == plain


@pytest.mark.parametrize(
    "text",
    [
        "is the gate open no close it",  # answers
        "ask leo if he wants soup if no bring him bread",
        "tell him no and lock the gate",
        "open the gate no need to knock",
        "make a tea no milk and bring it",
        "if there's no soap the baby can't bathe",
        "take room no 7 the towels",
        "turn the radio on, no, turn it off",  # is set off already
        "no close the gate",
    ],
)
def test_what_takes_nothing_back_is_not(parser: Parser, text: str) -> None:
    assert marked(parser.parse(text)) is None


def test_spans_are_those_of_the_text_as_it_was_typed(interpreter: Interpreter) -> None:
    found = interpreter.interpret("turn the radio on no turn it off")
    (task,) = found.tasks
    assert found.text[task.span.start : task.span.end] == "turn"
    assert task.span.start == 21
    assert task.value("state") == "off"
