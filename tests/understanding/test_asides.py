"""What is said aside orders nothing, asks nothing and lends its words to no task."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.speech.asides import (
    asides,
    means,
    means_of,
    musing,
    reason,
    reasons,
    tag_question,
    whereabouts,
)


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def words(parser: Parser, text: str) -> str:
    document = parser.parse(text)
    return " ".join(document.tokens[i].text for i in sorted(asides(document, ()) | reasons(document, ())))


@pytest.mark.parametrize(
    ("text", "aside"),
    [
        ("Glyn's asleep, is he? Close the door.", "is he"),
        ("The lamp is on, isn't it? Turn it off.", "is n't it"),
        ("The lamp isn\u2019t on, is it? Turn it on.", "is it"),
        ("Then, let me think, hang it up.", "let me think"),
        ("Make yourself useful and hang it up.", "Make yourself useful"),
        ("Since the fan is broken, open the window.", "Since the fan is broken"),
        ("Open the window because the fan is broken.", "because the fan is broken"),
        ("Whether or not it is done, turn it off.", "Whether or not it is done"),
        ("Bring her the coat even if it's sunny.", "even if it 's sunny"),
        ("Lock the door regardless of whether Tom is in.", "regardless of whether Tom is in"),
        ("If the mug is dirty, wash it. Dirty or not, put it away.", "Dirty or not"),
        ("Fill it. Full or empty, put it away.", "Full or empty"),
    ],
)
def test_what_is_an_aside(parser: Parser, text: str, aside: str) -> None:
    assert words(parser, text) == aside


@pytest.mark.parametrize(
    "text",
    [
        "Is he asleep? Close the door.",
        "Let me think about it.",
        "Let me know whether it is on.",
        "Because if the fan is broken, open the window.",
        "If it is on, turn it off.",
        "Ask him unless it is on, and even if it is.",
        "Because it's late check that the kids are asleep.",
        "Bring him his cane, he's in the garden.",
        "Tell me if it's full or not, then close the lid.",
        "Is the lamp on or not? Turn it off.",
        "Bring the red or blue, I don't mind.",
    ],
)
def test_what_is_none(parser: Parser, text: str) -> None:
    assert words(parser, text) == ""


def test_what_has_a_task_in_it_is_no_aside(parser: Parser) -> None:
    document = parser.parse("Out again, is he? Slide it under his door.")
    assert asides(document, ()) == {3, 4}
    assert asides(document, (3,)) == frozenset()


def test_an_aside_is_known_by_the_token_that_it_is_asked_of(parser: Parser) -> None:
    document = parser.parse("He's in, isn't he? Well, let me see.")
    assert tag_question(document, 1) is None
    assert tag_question(document, 4) == range(4, 7)
    assert musing(document, 10) == range(10, 13)
    assert reason(document, 0) is None


def test_where_somebody_is_is_told_in_a_clause(parser: Parser) -> None:
    assert whereabouts(parser.parse("Bring him his cane, he's in the garden."), 5) == range(5, 10)
    assert whereabouts(parser.parse("Bring me the cane, it's in the garden."), 5) is None
    assert whereabouts(parser.parse("Tell Ann she's in the garden."), 2) is None


@pytest.mark.parametrize(
    ("text", "governing", "verb", "expected"),
    [
        ("Leave the house by crossing the hall, then sit.", "Leave", "crossing", "by crossing the hall"),
        ("You can reach the stage by walking past the bar.", "reach", "walking", "by walking past the bar"),
        # what is done is an order itself
        ("Help me by carrying the bags.", "", "carrying", None),
        ("You can go on by crossing out the name.", "", "crossing", None),
        ("Find the keys by going through the drawer.", "", "going", None),
        # of another sentence
        ("Leave the house. By crossing the hall you save time.", "Leave", "crossing", None),
        ("By crossing the hall you leave.", "leave", "crossing", None),
    ],
)
def test_how_somebody_goes_is_no_task(
    parser: Parser, text: str, governing: str, verb: str, expected: str | None
) -> None:
    document = parser.parse(text)
    tasks = {token.i: "motion" for token in document.tokens if token.text == governing}
    at = next(token.i for token in document.tokens if token.text == verb)
    found = means(document, at, tasks)
    assert (None if found is None else " ".join(document.tokens[i].text for i in found)) == expected
    assert means_of(document, tasks) == frozenset(found or ())


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("If the lamp is red, which means that the mixer is done, stop it.", ["is", "stop"]),
        ("If the tank is warm, which would mean the pump is on, call Lea.", ["is", "call"]),
        ("If the tank is warm and the pump is on, call Lea.", ["is", "is", "call"]),
    ],
)
def test_what_something_means_is_no_condition(text: str, verbs: list[str]) -> None:
    assert [task.span.of(text) for task in Interpreter.load().interpret(text).tasks] == verbs
