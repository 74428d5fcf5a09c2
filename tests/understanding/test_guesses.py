"""A guess at where something is, behind a case, orders nothing and is no case of what is ordered next."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.background.guesses import guesses


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "guess"),
    [
        ("If the torch isn't on the hook, it must be in the cellar. Fetch it for me.", "it must be in the cellar"),
        ("If my boots are not in the porch they're under the bench. Bring them here.", "they 're under the bench"),
        ("If Lea isn't in the barn she'll be in the attic. Tell her supper is on.", "she 'll be in the attic"),
        ("If the cat isn't in the barn, she must be out. Shut the gate.", ""),
        ("If the torch isn't on the hook, look in the cellar. Fetch it for me.", ""),
        ("If the torch isn't on the hook, it must be charged. Fetch it for me.", ""),
        ("If the torch isn't on the hook, it must be in the cellar. Fetch it from there.", ""),
        ("If the torch isn't on the hook, it must be in the cellar, so fetch it.", ""),
        ("If the torch is on the hook, it must be in the porch. Fetch it for me.", ""),
        ("If it's on the hook, bring it. If it isn't on the hook, it must be in the cellar. Fetch it.", ""),
    ],
)
def test_what_is_guessed(parser: Parser, text: str, guess: str) -> None:
    document = parser.parse(text)
    found = [" ".join(document.tokens[i].text for i in words) for words in guesses(document)]
    assert found == ([guess] if guess else [])


def test_what_is_ordered_behind_a_guess_is_done_in_any_case() -> None:
    found = Interpreter.load("household", encoder=False).interpret(
        "If the torch is not on the desk, it must be on the bed. Bring it to me."
    )
    assert found.flow.to_json() == [1, 2]
    assert found.task(2).value("source") is None
