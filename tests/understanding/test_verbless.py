"""Cases of which only a noun is said."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.verbless import verbless_cases


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "carriers"),
    [
        ("If a letter, open it; if cold meat, bring the oil.", ["letter", "meat"]),
        ("Unless Friday, lock the gate.", ["Friday"]),
        ("Take a coat if snow.", ["snow"]),
        ("If only two plates, wash the third.", ["plates"]),
        ("If no clean cups in the rack, wash two.", ["cups"]),
        ("any clean bowls? if so bring two", ["bowls"]),
        ("Any flour in the tin? If so, sift it.", []),
        ("Any flour? Bring two eggs.", []),
        ("Any luck? If not, tell me.", []),
        ("In case of frost, cover the pots.", ["frost"]),
        ("Cover the pots in the event of a storm.", ["storm"]),
        ("Cover the pots in case of frost.", []),
        ("In the event of failure, cover the pots.", []),
        ("Look in the case of the flute.", []),
        ("Take a torch in case of emergency.", []),
        ("Even if the phone rings, bring the pan.", []),
        ("If possible, bring the pan.", []),
        ("If no, bring the pan.", []),
        ("If so, bring the pan. If not, tell me.", []),
        ("If in doubt, ask Ann.", []),
        ("If the soup, no, the stew is hot, bring it.", []),
        ("If the guest-room door is open, shut it.", []),
        ("If the bread is stale, toast it.", []),
    ],
)
def test_a_noun_that_stands_alone_is_a_case(parser: Parser, text: str, carriers: list[str]) -> None:
    document = parser.parse(text)
    assert [document.tokens[case.carrier].text for case in verbless_cases(document, ())] == carriers


def test_what_has_a_task_of_its_own_is_none(parser: Parser) -> None:
    document = parser.parse("If the tall lamp flickers, switch it off.")
    assert not list(verbless_cases(document, {2}))


@pytest.mark.parametrize(
    ("text", "flow", "told"),
    [
        ("Look in the pot. If soup, bring me the ladle.", [1, {"if": 2, "then": [3]}], ("soup", None)),
        ("If no jam, fetch a jar from the cellar.", [{"if": 1, "else": [2]}], ("jam", None)),
        ("If no bread left, toast two crumpets.", [{"if": 1, "else": [2]}], ("bread", None)),
        ("Unless Friday, lock the gate and bring the key.", [{"if": 1, "else": [2, 3]}], (None, "Friday")),
        ("If a letter, bring it to me, otherwise shut the box.",
         [{"if": 1, "then": [2], "else": [3]}], ("a letter", None)),
    ],
)  # fmt: skip
def test_orders_hang_on_it(
    interpreter: Interpreter, text: str, flow: list[object], told: tuple[str | None, str | None]
) -> None:
    found = interpreter.interpret(text)
    assert found.flow.to_json() == flow
    check = next(task for task in found.tasks if task.type == "check_state")
    assert (check.value("object"), check.value("state")) == told
