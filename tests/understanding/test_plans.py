"""What speakers mean to do by themselves is no order; what they want from others is."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.rules.background.plans import is_planned, plans


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def planned(parser: Parser, text: str, verb: str, tasks: dict[str, str]) -> bool:
    document = parser.parse(text)
    at = {token.lower: token.i for token in document.tokens}
    return is_planned(document, at[verb], {at[word]: kind for word, kind in tasks.items()} | {at[verb]: "taking"})


@pytest.mark.parametrize(
    ("text", "verb", "other"),
    [
        ("I want to roast a duck. Fetch the tin.", "roast", {"fetch": "taking"}),
        ("We'd love to knit a scarf, so bring the wool.", "knit", {"bring": "bringing"}),
        ("i wanna paint get me the brushes", "paint", {"get": "bringing"}),
        ("I'd like to show you the cellar.", "show", {}),
        ("I want to take you to the porch.", "take", {}),
        ("I'm going to mow the lawn.", "mow", {}),
        ("we're about to leave lock the door", "leave", {"lock": "change_state"}),
    ],
)
def test_what_the_speaker_will_do_is_planned(parser: Parser, text: str, verb: str, other: dict[str, str]) -> None:
    assert planned(parser, text, verb, other)


@pytest.mark.parametrize(
    ("text", "verb", "other"),
    [
        ("I want you to roast a duck. Fetch the tin.", "roast", {"fetch": "taking"}),
        ("I'd like to have my soup. If it's cold, heat it.", "have", {"heat": "change_state"}),
        ("I want to turn the fan on. If it's on, tell me.", "turn", {"tell": "informing"}),
        ("I want to roast a duck.", "roast", {}),  # what else could be meant
        ("Tell Ann I'm going to mow the lawn.", "mow", {"tell": "informing"}),
        ("If I'm going to mow the lawn, bring the shears.", "mow", {"bring": "bringing"}),
        ("Tom wants to bake a pie. Get the flour.", "bake", {"get": "taking"}),
    ],
)
def test_what_others_are_to_do_or_to_bring_is_not(parser: Parser, text: str, verb: str, other: dict[str, str]) -> None:
    assert not planned(parser, text, verb, other)


def test_words_of_a_plan_are_those_of_its_clause(parser: Parser) -> None:
    document = parser.parse("I want to bake a pie. If there is no flour, buy some.")
    tasks = {token.i: "check_state" for token in document.tokens if token.lower == "is"}
    assert [document.tokens[i].text for i in sorted(plans(document, tasks))] == ["I", "want", "to", "bake", "a", "pie"]
