"""A wish is a task of its own unless the request behind it asks for the same."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.orders.wishes import backgrounds, is_background, is_served


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def served(parser: Parser, text: str) -> bool:
    document = parser.parse(text)
    wish = next(token.i for token in document.tokens if token.lemma in ("like", "want", "need", "love"))
    request = next(token.i for token in document.tokens if token.lemma in ("bring", "get", "pick", "take"))
    return is_served(document, wish, request)


@pytest.mark.parametrize(
    "text",
    [
        "I'd like some tea, can you get me some?",
        "I need the map. Please get it.",
        "I would really love a clean towel, bring me a towel.",
        "we want a knife and a fork can you bring us them",
        "I want the red book, pick it up.",
        "Anna would like a cup of tea. Please bring her one.",
        "My son wants the map, take him the old one.",
        "I'd love a towel. Bring me the big one.",
        "I want the plates, bring them.",
        "I'd like the pens. Bring them here, please.",
    ],
)
def test_a_wish_that_a_request_serves(parser: Parser, text: str) -> None:
    assert served(parser, text)


@pytest.mark.parametrize(
    "text",
    [
        "I'd like some tea. Bring one to Anna.",  # for somebody else
        "I'd like a coffee. Bring one up to my mother.",
        "I'd like a coffee. Bring one for me as well.",
        "My son would like some tea, bring me some.",  # somebody else's wish
        "I'd like a clean towel. Take the dirty towel away.",  # another one
        "I'd like some tea, get me the tea bags.",  # another thing
        "I'd like my phone. Get one of the chargers.",
        "I'd like some tea if there is any, bring me some.",  # in a case
        "I'd like some tea and then bring it back.",  # one more order
        "I'd like some tea. It is cold. Bring me some.",  # too far away
        "I'd like a coffee, bring her one.",
        "Anna would like a coffee, bring me one.",
        "I'd like a pen. Bring me another one for Tom.",
        "I'd like to sleep, get out.",  # nothing that could be brought
    ],
)
def test_a_wish_of_its_own(parser: Parser, text: str) -> None:
    assert not served(parser, text)


@pytest.mark.parametrize(
    ("text", "verb", "kind", "expected"),
    [
        ("feel like some music turn on the radio", "turn", "change_state", True),
        ("Fancy a biscuit. Open the tin.", "Open", "change_state", True),
        ("oh, could do with some light, open the curtains", "open", "change_state", True),
        ("need to iron a shirt get the board", "get", "taking", True),
        ("wanna read a bit, bring me my book", "bring", "bringing", True),
        ("need to feed the cat, mop the hall", "mop", "change_state", False),
        ("need to feed the cat and bring me the bowl", "bring", "bringing", False),
        ("fancy a biscuit if there is one, open the tin", "open", "change_state", False),
        ("I fancy a biscuit, open the tin", "open", "change_state", False),
        ("feel the radiator turn it down", "turn", "change_state", False),
    ],
)
def test_a_wish_that_only_tells_why(parser: Parser, text: str, verb: str, kind: str, expected: bool) -> None:
    document = parser.parse(text)
    at = next(token.i for token in document.tokens if token.text == verb)
    assert is_background(document, 0, at, kind) == expected
    assert (at - 2 in backgrounds(document, {at: kind})) == expected


@pytest.mark.parametrize("encoder", [False, True])
def test_who_is_wanted_to_do_something_is_ordered_to(encoder: bool) -> None:
    text = "You can mop the porch, but look first if there's a frog on it, because if there is I want you to catch it."
    found = Interpreter.load(encoder=encoder).interpret(text).tasks
    assert [task.value("object") for task in found] == ["the porch", "a frog", "a frog", "a frog"]
