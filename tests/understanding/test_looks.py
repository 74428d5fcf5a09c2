"""Looks and calls that are told by a noun: the noun is no thing."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.references.looks import looks, shouts


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("have a squiz in the larder", ["a squiz"]),
        ("Take a good shufti at the bins.", ["a good shufti"]),
        ("have a butcher's in the loft", ["a butcher's"]),
        ("give the larder a quick scan for jam", ["a quick scan"]),
        ("Do a quick search of the loft.", ["a quick search"]),
        ("give Tom a peek at the letter", []),
        ("Take a butcher's knife from the block.", []),
        ("take a scan of the letter to Ann", []),
        ("take the gander to the pond", []),
        ("give the counter a quick sweep", []),
    ],
)
def test_a_look(parser: Parser, text: str, words: list[str]) -> None:
    document = parser.parse(text)
    assert [document.span(w.start, w.stop - 1).of(text) for _, w, _ in looks(document)] == words


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("gimme a shout if it rings", ["a shout"]),
        ("Give me a ring when it's done.", ["a ring"]),
        ("gimme a ring from the box", []),
        ("give the dog a treat", []),
    ],
)
def test_a_call(parser: Parser, text: str, words: list[str]) -> None:
    document = parser.parse(text)
    assert [document.span(w.start, w.stop - 1).of(text) for _, w, _ in shouts(document)] == words


def test_what_is_looked_for_is_what_a_later_check_asks_of() -> None:
    found = Interpreter.load().interpret("have a shufti in the larder for jam, and if there isn't any, buy some")
    assert [(task.type, task.value("object")) for task in found.tasks[:2]] == [
        ("searching", "for jam"),
        ("check_state", "jam"),
    ]


def test_what_is_given_a_look_is_its_place() -> None:
    found = Interpreter.load().interpret("Give the larder a quick squiz. If it's damp, mop it.")
    assert (found.tasks[0].type, found.tasks[0].value("location")) == ("searching", "the larder")
    assert found.tasks[1].value("object") == "the larder"


def test_an_eye_that_is_kept_on_something_is_no_thing() -> None:
    found = Interpreter.load().interpret("Keep a close eye on the rice and take it off the stove when it's soft.")
    assert [found.tasks[k].value("object") for k in (1, 2)] == ["the rice", "the rice"]
