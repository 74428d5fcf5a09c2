"""The case of somebody or something named is a check, be none of its words a task by itself."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.rules.conditions import untold


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("If Lea's borrowed the drill, let me know.", "'s"),
        ("If the moon is out, shut the blinds.", "is"),
        ("Put the kettle on, and when she's brought the eggs in, boil two.", "'s"),
        ("Wipe the board only if there's nothing important on it.", "'s"),
        ("Unless the paint has dried, leave the window open.", "has"),
    ],
)
def test_an_untold_case_is_a_check(parser: Parser, text: str, word: str) -> None:
    document = parser.parse(text)
    assert [document.tokens[i].text for i in untold(document, {})] == [word]


@pytest.mark.parametrize(
    ("text", "tasks"),
    [
        ("If the moon is out, shut the blinds.", {"out": "check_state"}),
        ("If it's not too much trouble, shut the blinds.", {}),
        ("Should the second attempt be in vain, or if that attempt is in vain, stop.", {}),
        ("Tell Lea, if the bus is late, to wait.", {"Tell": "informing"}),
        ("See if the moon is out.", {"See": "check_state"}),
        ("If there's no sign of it, go on.", {}),
        ("If there is nothing to sort out, go on.", {}),
        ("If you're done, come here.", {}),
    ],
)
def test_no_untold_case(parser: Parser, text: str, tasks: dict[str, str]) -> None:
    document = parser.parse(text)
    told = {token.i: tasks[token.text] for token in document.tokens if token.text in tasks}
    assert untold(document, told) == frozenset()
