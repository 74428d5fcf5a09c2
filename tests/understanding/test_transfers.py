"""What goes where or to whom, and what somebody is to have, said without a verb."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.ellipses.transfers import transfers


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.fixture(scope="module")
def gazetteer() -> Gazetteer:
    domain = load_domain("household")
    return Gazetteer.of(domain.lexicon, domain.kinds)


@pytest.mark.parametrize(
    ("text", "orders"),
    [
        ("Both towels to Lea, please.", [("bringing", "to", {"object": "Both towels", "recipient": "Lea"})]),
        ("My coat to the study, please.", [("bringing", "to", {"object": "My coat", "goal": "the study"})]),
        ("A cup of cocoa for Grandma, please.",
         [("bringing", "for", {"object": "A cup of cocoa", "recipient": "Grandma"})]),
        ("Three mugs on the desk, please!", [("placing", "on", {"object": "Three mugs", "goal": "the desk"})]),
        ("The dirty bowls into the sink!", [("placing", "into", {"object": "The dirty bowls", "goal": "the sink"})]),
        ("First the bread, to Sid; and then the butter, to me.",
         [("bringing", "to", {"object": "the bread", "recipient": "Sid"}),
          ("bringing", "to", {"object": "the butter", "recipient": "me"})]),
        ("Two lemonades, please.", [("bringing", "lemonades", {"object": "Two lemonades"})]),
        ("The key to Lea and the parcel to Sid.",
         [("bringing", "to", {"object": "The key", "recipient": "Lea"}),
          ("bringing", "to", {"object": "the parcel", "recipient": "Sid"})]),
        ("Water, please.", [("bringing", "Water", {"object": "Water"})]),
        ("A lemonade, please, and shut the door.", [("bringing", "lemonade", {"object": "A lemonade"})]),
    ],
)  # fmt: skip
def test_an_order_without_a_verb_is_carried_by_its_preposition_or_else_its_noun(
    parser: Parser, gazetteer: Gazetteer, text: str, orders: list[tuple[str, str, dict[str, str]]]
) -> None:
    document = parser.parse(text)
    tokens = document.tokens
    found = [
        (
            one.type,
            tokens[one.carrier].text,
            {
                name: document.text[tokens[said.start].start : tokens[said.stop - 1].end]
                for name, said in one.told.items()
            },
        )
        for one in transfers(Observed(document, gazetteer))
    ]
    assert found == orders


@pytest.mark.parametrize(
    "text",
    [
        "The bowl on the desk, please.",  # tells which bowl
        "The way to the study, please.",
        "Two steps to the left, please.",
        "Three cheers for Sid!",
        "Hands on the desk, please!",
        "Robot, to the study, please.",
        "Lea to the study, please.",
        "Both towels to Lea?",
        "The letter to Lea is on the desk.",
        "Quiet, please.",
        "One moment, please, and wait here.",
        "The window, please, and be quick.",
        "The bowl, please bring it here.",
        "Bring both towels to Lea, please.",
    ],
)
def test_what_only_names_something_orders_nothing(parser: Parser, gazetteer: Gazetteer, text: str) -> None:
    assert not list(transfers(Observed(parser.parse(text), gazetteer)))


def test_what_somebody_is_to_have_is_brought_and_then_made_so() -> None:
    found = Interpreter.load().interpret("Juice, please, and make it hot.")
    assert [(task.type, task.value("object")) for task in found.tasks] == [
        ("bringing", "Juice"),
        ("change_state", "Juice"),
    ]
    assert found.flow.to_json() == [1, 2]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A biscuit for Ida if she's up.", [{"if": 2, "then": [1]}]),
        ("Two eggs for Ida, please, unless she has eaten.", [{"if": 2, "else": [1]}]),
        ("Some more honey if there is any.", [{"if": 2, "then": [1]}]),
        ("More tea if there's any left.", [{"if": 2, "then": [1]}]),
        ("Coffee for Grandpa, please, but knock first.", [2, 1]),
        ("A coffee to the garden, and take the empty cup away.", [1, 2]),
        ("Water to the cat and close the hatch.", [1, 2]),
        ("Heater off if it's hot.", [{"if": 2, "then": [1]}]),
        ("One thing if the stove is on then switch it off.", [{"if": 1, "then": [2]}]),
        ("Nip to the shop and get some milk.", [1, 2]),
    ],
)
def test_what_is_asked_for_goes_on(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "type", "expected"),
    [
        ("A biscuit for Ida if she's up.", "bringing", {"object": "A biscuit", "recipient": "Ida"}),
        ("Some more honey if there is any.", "bringing", {"object": "Some more honey"}),
        ("A coffee to the garden, and take the empty cup away.", "bringing",
         {"object": "A coffee", "goal": "the garden"}),
        ("A window open if it's hot.", "change_state", {"object": "A window"}),
    ],
)  # fmt: skip
def test_what_is_asked_for_in_a_case_is_brought(
    interpreter: Interpreter, text: str, type: str, expected: dict[str, str]
) -> None:
    task = interpreter.interpret(text).tasks[0]
    assert (task.type, {a.type: a.value for a in task.arguments}) == (type, expected)
