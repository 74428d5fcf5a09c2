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
        (
            "Go up. They're right: hang it up. They're wrong: call Joe.",
            "Go up. They're right? hang it up. They're wrong? call Joe.",
        ),
        ("With nobody in the den, sweep it.", "nobody in the den? sweep it."),
        ("With the lid on, come back. With it off, close it.", "the lid on? come back. off? close it."),
        ("With a damp cloth, wipe the shelf.", None),
        ("Wipe the tray. Any crumbs on it, sweep them up.", "Wipe the tray. Any crumbs on it? sweep them up."),
        ("Look for a pear, no pear then get a plum.", "Look for a pear. no pear? then get a plum."),
        (
            "What does it say? More than 20, open it. Less than 10, shut it.",
            "What does it say? More than 20? open it. Less than 10? shut it.",
        ),
        ("Bring two things: open the bag.", None),
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


def test_for_one_of_two_that_were_offered(interpreter: Interpreter) -> None:
    text = "Ask Gran whether she'd like tea or cocoa. For tea, fill the kettle. For cocoa, warm the milk."
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3], "else": [{"if": 4, "then": [5]}]}]


def test_an_if_so_is_of_the_order_ahead_alone(interpreter: Interpreter) -> None:
    text = "have a look at the filter and clean it if so then put the towels in and run it"
    (case, *rest) = flow(interpreter, text)
    assert case["then"] == [2]
    assert rest == [3, 4]


def test_any_that_is_so_picks_and_asks_nothing(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Go round the windows, close any that's open, and report back to me.") == [1, 2, 3]


def test_so_much_so_is_no_also(interpreter: Interpreter) -> None:
    text = "Stir the porridge, thin it with milk if it's gone too thick, turn the ring down and call the kids."
    assert flow(interpreter, text) == [1, {"if": 3, "then": [2]}, 4, 5]
