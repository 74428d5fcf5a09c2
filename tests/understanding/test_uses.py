"""What a thing is wanted for is part of its words and no order."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.orders.uses import uses


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "use"),
    [
        ("Bring me a sponge to wash the sledge with.", "to wash the sledge with"),
        ("Find something to scrape it off with and hurry.", "to scrape it off with"),
        ("Fetch a crate to put the pears in.", "to put the pears in"),
        ("Is there a bench to sit on?", "to sit on"),
        ("If there's nothing to dig with in the shed, tell Lea.", "to dig with"),
    ],
)
def test_a_use_goes_from_its_to_up_to_its_preposition(parser: Parser, text: str, use: str) -> None:
    document = parser.parse(text)
    (found,) = uses(document)
    assert document.span(found.words.start, found.words[-1]).of(text) == use


@pytest.mark.parametrize(
    "text",
    [
        "Use the sponge to wash the sledge.",
        "Tell the twins to put their boots on.",
        "Get the lantern to come on.",
        "Open the hatch to let some air in.",
        "Ask Lea to come in.",
        "I know the way to turn it on.",
    ],
)
def test_what_is_done_or_told_is_no_use(parser: Parser, text: str) -> None:
    assert list(uses(parser.parse(text))) == []


@pytest.mark.parametrize(
    ("text", "types", "thing"),
    [
        (
            "Bring me a sponge to wash the sledge with, and shut the hatch.",
            ["bringing", "change_state"],
            "a sponge to wash the sledge with",
        ),
        ("I need a crate to put the pears in.", ["bringing"], "a crate to put the pears in"),
        (
            "I want something to read and something to drink.",
            ["bringing"],
            "something to read and something to drink",
        ),
        ("Find a rod to poke it out with.", ["searching"], "a rod to poke it out with"),
    ],
)
def test_it_is_no_task(interpreter: Interpreter, text: str, types: list[str], thing: str) -> None:
    tasks = interpreter.interpret(text).tasks
    assert [task.type for task in tasks] == types
    assert tasks[0].value("object") == thing


def test_that_there_is_nothing_for_it_is_a_case(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If there's nothing to dig with in the shed, tell Lea.")
    assert found.to_json()["flow"] == [{"if": 1, "else": [2]}]
