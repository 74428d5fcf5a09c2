"""Cases of which only a noun or a state is said."""

from __future__ import annotations

import pytest
from annotated import DOMAIN, PARSER

from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.ellipses.verbless import verbless_cases


def observed(text: str) -> Observed:
    return Observed(PARSER.parse(text), Gazetteer.of(DOMAIN.lexicon, DOMAIN.kinds))


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
        ("When dark, draw the blinds.", ["dark"]),
        ("Empty the crate when full.", ["full"]),
        ("If still damp, hang the rug up.", ["damp"]),
        ("Come back when done.", []),
        ("Tell me when ready.", []),
    ],
)
def test_what_stands_alone_is_a_case(text: str, carriers: list[str]) -> None:
    found = observed(text)
    assert [found.document.tokens[case.carrier].text for case in verbless_cases(found, ())] == carriers


def test_what_has_a_task_of_its_own_is_none() -> None:
    assert not list(verbless_cases(observed("If the tall lamp flickers, switch it off."), {2}))


@pytest.mark.parametrize(
    ("text", "flow", "told"),
    [
        ("Look in the pot. If soup, bring me the ladle.", [1, {"if": 2, "then": [3]}], ("soup", None)),
        ("If no jam, fetch a jar from the cellar.", [{"if": 1, "else": [2]}], ("jam", None)),
        ("If no bread left, toast two crumpets.", [{"if": 1, "else": [2]}], ("bread", None)),
        ("Turn the lantern on when dark.", [{"if": 2, "then": [1]}], (None, None)),
        ("Serve the stew when ready.", [{"if": 2, "then": [1]}], ("the stew", None)),
        ("If not too heavy, bring me the crate.", [{"if": 1, "else": [2]}], ("the crate", None)),
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
