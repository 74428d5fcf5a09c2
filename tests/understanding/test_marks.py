"""Marks that a text lacks or has otherwise: commas ahead of what a case forbids, question marks behind bare cases."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.speech.marks import marked


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("If the rug is wet don't beat it.", "If the rug is wet, don't beat it."),
        ("If the rug is wet dont beat it.", "If the rug is wet, dont beat it."),
        ("If they don't open it, call me.", None),
        ("If the mugs we have don't fit, call me.", None),
        ("Look at it. Amber, call Joe. Green, come back.", "Look at it. Amber? call Joe. Green? come back."),
        ("Read it: under ten, light it, otherwise dust it.", "Read it: under ten? light it, otherwise dust it."),
        ("Clean, dry and fold the napkins.", None),
        ("Open it. Clean, wipe it. Dry, fold it.", None),
        ("Get up. Hungry, he left.", None),
        ("Go up. Tired, rest a while.", None),
    ],
)
def test_marks_are_put_where_plain_english_has_them(parser: Parser, text: str, plain: str | None) -> None:
    found = marked(parser.parse(text))
    assert (None if found is None else found.text) == plain
    assert found is None or len(found.places) == len(found.text)


def test_bare_states_and_levels_are_cases(interpreter: Interpreter) -> None:
    text = "What colour is the lamp on the pump? Red, ring Joe. Amber, tell me. Green, sweep the porch."
    case = flow(interpreter, text)[-1]
    assert case["then"] == [2]
    assert case["else"] == [{"if": 3, "then": [4], "else": [{"if": 5, "then": [6]}]}]


def test_what_is_in_between_is_neither(interpreter: Interpreter) -> None:
    text = "Read the gauge. Above sixty, open the valve; below ten, shut it; anything in between, call me."
    case = flow(interpreter, text)[-1]
    assert case["then"] == [3]
    assert case["else"] == [{"if": 4, "then": [5], "else": [6]}]


def test_somebody_in_there_is_in_the_place_before(interpreter: Interpreter) -> None:
    text = "Nobody in the den? Sweep it and dust the shelf. Somebody in there? Leave the towels by the door."
    assert flow(interpreter, text) == [{"if": [1, 4], "then": [5], "else": [2, 3]}]


def test_what_is_done_instead_is_done_in_the_case(interpreter: Interpreter) -> None:
    text = "Sweep the stairs, unless Gran's having her nap, then dust the shelf instead."
    assert flow(interpreter, text) == [{"if": 2, "then": [3], "else": [1]}]


def test_what_somebody_does_instead_leaves_the_first_case_its_orders(interpreter: Interpreter) -> None:
    text = "If she sits on the bench, bring her the hat, and if she goes to the pond instead, call me."
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}]
