"""Questions and orders without a verb, and alternatives without one."""

from __future__ import annotations

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.ellipses.alternatives import alternatives
from decomplex_bt.understanding.rules.ellipses.fragments import fragments


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "carrier", "thing", "place"),
    [
        ("Any letters in the mailbox? Bring them to me.", "in", "Any letters", "the mailbox"),
        ("No salt on the table then? Fetch some.", "on", "salt", "the table"),
        ("Well, somebody at the gate? Tell me.", "at", "somebody", "the gate"),
        ("Not anyone in the sauna? Turn it off.", "in", "anyone", "the sauna"),
        ("Nobody in the sauna? Turn it off.", "in", "", "the sauna"),
        ("Letter on mat? Bring it up.", "on", "Letter", "mat"),
        ("dog in garden? let him in", "in", "dog", "garden"),
        ("No sign on the gate? Go in.", "on", "sign", "the gate"),
        ("And see a stain on the rug? Tell me.", "see", "a stain", "on the rug"),
        ("Spot any crumbs? Wipe the table.", "Spot", "any crumbs", ""),
        ("All shutters and gates closed?", "closed", "All shutters and gates", ""),
        ("The cat and the dog fed yet? If not, feed them.", "fed", "The cat and the dog", ""),
    ],
)
def test_a_question_without_a_verb_is_carried_by_its_preposition_and_a_bare_one_by_its_verb(
    parser: Parser, text: str, carrier: str, thing: str, place: str
) -> None:
    document = parser.parse(text)
    (fragment,) = fragments(document)
    assert document.tokens[fragment.carrier].text == carrier
    words = [" ".join(document.tokens[i].text for i in said) for said in (fragment.object, fragment.place)]
    assert words == [thing, place]


@pytest.mark.parametrize(
    "text",
    [
        "Any milk left in the fridge? Bring me some.",  # carried by "left"
        "Any chance of a drink in the garden? Bring me one.",
        "No luck? Look in the truck.",
        "Is there any milk in the fridge? Bring me some.",
        "Oven on? Turn it off.",
        "Bring me any letters in the mailbox.",
        "Breakfast in the garden?",
        "Every gate closed, please?",
        "All gates closed, okay?",
        "Ready in the kitchen? Start the oven.",
        "See the stain on the rug? Clean it.",
        "See a mug that is clean? Bring it.",
        "Find a chair in the hall?",
        "Any sign of the dog in the garden? Tell me.",
    ],
)
def test_other_questions_are_left_to_the_models(parser: Parser, text: str) -> None:
    assert not list(fragments(parser.parse(text)))


@pytest.mark.parametrize(
    ("text", "orders"),
    [
        ("Tv off, radio on", [("off", "Tv", ""), ("on", "radio", "")]),
        ("Lights off in the kitchen.", [("off", "Lights", "in the kitchen")]),
        ("If it's dark, the lamp on, please, and bring me a pen.", [("on", "the lamp", "")]),
        ("Turn the tv on and the radio off.", []),
        ("If the tv is on and the lamp off, close the door.", []),
        ("Shoes on, Millie!", []),
        ("Oven on? Turn it off.", []),
        ("Bring me the book on the table.", []),
    ],
)
def test_an_order_without_a_verb_is_carried_by_its_state(
    parser: Parser, text: str, orders: list[tuple[str, str, str]]
) -> None:
    document = parser.parse(text)
    found = [
        tuple(
            " ".join(document.tokens[i].text for i in said)
            for said in ((fragment.carrier,), fragment.object, fragment.place)
        )
        for fragment in fragments(document)
        if fragment.type == "change_state"
    ]
    assert found == orders


@pytest.mark.parametrize(
    ("text", "placings"),
    [
        ("Tidy the shed: rakes on the wall, pots in the crate, and the hose by the tap.",
         [("on", "rakes", "the wall"), ("in", "pots", "the crate"), ("by", "the hose", "the tap")]),
        ("The shopping's here: eggs and ham in the fridge, rolls in the bin.",
         [("in", "eggs and ham", "the fridge"), ("in", "rolls", "the bin")]),
        ("Boots in the hall, coats behind the door, please.",
         [("in", "Boots", "the hall"), ("behind", "coats", "the door")]),
        ("Bring me two things: the rake on the wall and the pot in the crate.", []),
        ("Water the plants: the fern in the hall, the cactus on the sill.", []),
        ("Rakes on the wall.", []),
        ("There's a rake on the wall and a pot in the crate.", []),
        ("Boots in the hall, coats behind the door?", []),
    ],
)  # fmt: skip
def test_a_list_of_places_orders_what_goes_where(
    parser: Parser, text: str, placings: list[tuple[str, str, str]]
) -> None:
    document = parser.parse(text)
    found = [
        tuple(
            " ".join(document.tokens[i].text for i in said)
            for said in ((fragment.carrier,), fragment.object, fragment.place)
        )
        for fragment in fragments(document)
        if fragment.type == "placing"
    ]
    assert found == placings


def test_a_list_of_places_is_read_as_placings() -> None:
    found = Interpreter.load().interpret(
        "Sort the tools: saws on the rack, nails in the tin. If the tin is full, tell me."
    )
    assert [(task.type, task.value("object"), task.value("goal")) for task in found.tasks[1:3]] == [
        ("placing", "saws", "the rack"),
        ("placing", "nails", "the tin"),
    ]
    assert found.flow.to_json() == [1, 2, 3, {"if": 4, "then": [5]}]


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "branch"),
    [
        ("No hammer in the toolbox? Look in the truck then.", "else"),
        ("Any dishes in the sink? Wash them.", "then"),
        ("Someone at the door? Tell me.", "then"),
    ],
)
def test_what_follows_hangs_on_the_question(text: str, branch: str, encoder: bool) -> None:
    instruction = Interpreter.load(encoder=encoder).interpret(text)
    assert instruction.flow.to_json() == [{"if": 1, branch: [2]}]
    assert not instruction.missing


@pytest.mark.parametrize(
    ("text", "tasks", "words"),
    [
        ("Bring me a pear if there is one, otherwise an apple.", ("Bring", "is"), "an apple"),
        ("Bring me a cola, and if there's none, a beer.", ("Bring", "'s"), "a beer"),
        ("Bring me the red scarf, or if it's dirty, the blue one.", ("Bring", "'s"), "the blue one"),
        ("Bring me a pear if there is one, otherwise bring an apple.", ("Bring", "is", "bring"), None),
        ("Bring me the cup, the plate and, if it's dirty, wash it.", ("Bring", "'s", "wash"), None),
        ("If the door is open, close it, please, Anna.", ("is", "close"), None),
        ("Otherwise fine, close the door.", ("close",), None),
    ],
)
def test_what_is_named_instead_without_a_verb_is_found(
    parser: Parser, text: str, tasks: tuple[str, ...], words: str | None
) -> None:
    domain = load_domain("household")
    observed = Observed(parser.parse(text), Gazetteer.of(domain.lexicon, domain.kinds))
    types = {"is": "check_state", "'s": "check_state"}
    places = {t.i: types.get(t.text, "bringing") for t in observed.document.tokens if t.text in tasks}
    said = [found.tokens for found in alternatives(observed, places)]
    found = [observed.document.span(tokens.start, tokens.stop - 1).of(text) for tokens in said]
    assert found == ([] if words is None else [words])


def test_what_no_task_has_is_no_argument_of_another() -> None:
    instruction = Interpreter.load().interpret("If the tea is cold, a big coffee.")
    assert [task.value("object") for task in instruction.tasks] == ["the tea"]
    assert any("a big coffee" in warning for warning in instruction.warnings)


@pytest.mark.parametrize(
    ("text", "orders"),
    [
        ("Radio down, please, and shut the hatch.", [("change_state", "Radio"), ("change_state", "the hatch")]),
        ("Rubbish out, please.", [("taking", "Rubbish")]),
        ("Heater off, oven on.", [("change_state", "Heater"), ("change_state", "oven")]),
        ("Curtains open upstairs, fan off downstairs.", [("change_state", "Curtains"), ("change_state", "fan")]),
        ("Telly off.", [("change_state", "Telly")]),
        ("Hang on, shut the hatch.", [("change_state", "the hatch")]),
        ("Later on, shut the hatch.", [("change_state", "the hatch")]),
    ],
)
def test_a_state_is_ordered_of_whatever_is_known_as_a_thing(text: str, orders: list[tuple[str, str]]) -> None:
    found = Interpreter.load().interpret(text)
    assert [(task.type, task.value("object")) for task in found.tasks] == orders


def test_or_else_with_its_case_behind_is_an_or(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring the tea to Ann, or else to Bob if she's out.")

    assert [task.type for task in found.tasks] == ["bringing", "bringing", "check_state"]
    assert found.flow.to_json() == [{"if": 3, "then": [2], "else": [1]}]


@pytest.mark.parametrize(
    ("text", "instead"),
    [
        ("Bring me a red pen. If there's no red one, blue is fine.", "a blue pen"),
        ("Fetch a green towel; if there are no green towels, white will do.", "a white towel"),
    ],
)
def test_another_sort_serves_as_well(interpreter: Interpreter, text: str, instead: str) -> None:
    found = interpreter.interpret(text)

    assert found.tasks[2].value("object") == instead
    assert found.flow.to_json() == [{"if": 2, "then": [1], "else": [3]}]
