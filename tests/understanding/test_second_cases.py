"""A second thing with its state behind a condition is a check of its own, without an "is"."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.ellipses.second_cases import second_cases


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("If the bin is full and the lid loose, tell me.", [("the lid", "loose")]),
        ("Should the hedge be wet or the ladder missing, stop.", [("the ladder", "missing")]),
        ("If the soup's hot and the rice cooker free, start it.", [("the rice cooker", "free")]),
        ("When the oven is hot and the dough ready put it in.", [("the dough", "ready")]),
        ("Bring the jug if it is clean and the juice cold.", [("the juice", "cold")]),
        ("If the jug or the bowl is full, tell me.", []),
        ("If Tom is in the hall or the kitchen upstairs, tell him.", []),
        ("If the shirt is clean and the right size, bring it.", []),
        ("If the jug is full and cold, bring it.", []),
        ("If there is jam and the bread fresh, make toast.", []),
        ("If the grill is on or the casing feels hot, tell me.", []),
        ("If the gate is open and the shed is locked, tell me.", []),
    ],
)
def test_a_second_thing_with_its_state(parser: Parser, text: str, found: list[tuple[str, str]]) -> None:
    document = parser.parse(text)
    said = [
        (document.span(case.object.start, case.object.stop - 1).of(text), document.tokens[case.carrier].text)
        for case in second_cases(document)
    ]
    assert said == found


def test_either_of_two_cases_is_enough_behind_an_or() -> None:
    found = Interpreter.load().interpret("Should the hedge be wet or the ladder missing, call Tom.")
    assert [task.span.of(found.text) for task in found.tasks] == ["be", "missing", "call"]
    assert found.tasks[1].value("object") == "the ladder"
    assert found.flow.to_json() == [{"if": 1, "then": [3], "else": [{"if": 2, "then": [{"same": [3]}]}]}]
