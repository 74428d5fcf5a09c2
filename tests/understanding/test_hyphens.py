"""Names of several words that hyphens join, among them words that elsewhere point or join clauses."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("Put the post-it on the mirror.", "post-it"),
        ("Check the use-by date on the ham.", "use-by"),
        ("Bring Ida her pick-me-up.", "pick-me-up"),
        ("Hang the do-not-disturb sign on the handle.", "do-not-disturb"),
        ("It is in my just-in-case-it-rains bag.", "just-in-case-it-rains"),
        ("Scan the letter and e-mail it to Tom.", "e-mail"),
        ("Stir-fry the vegetables.", "Stir-fry"),
    ],
)
def test_a_name_is_one_token(parser: Parser, text: str, word: str) -> None:
    document = parser.parse(text)
    (token,) = (token for token in document.tokens if "-" in token.text)
    assert token.text == word
    assert text[token.start : token.end] == word
    assert [span.of(text) for span in parser.tokens(text)] == [token.text for token in document.tokens]


@pytest.mark.parametrize(
    "text",
    [
        "bring me the cup-if it is clean",
        "wash the pan-it is dirty-and dry it",
        "the soup - it is cold - goes in the bin",
        "Take it to my mother-in-law.",
        "Bring me the lean-to key.",
        "give-it-to-me now",
    ],
)
def test_what_joins_clauses_or_points_stays_a_word(parser: Parser, text: str) -> None:
    assert all(token.text == "-" for token in parser.parse(text).tokens if "-" in token.text)


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "orders"),
    [
        ("Scan the letter and e-mail it to Tom.", ["Scan", "e-mail"]),
        ("Stir-fry the vegetables and bring them to me.", ["Stir-fry", "bring"]),
        ("If the dog is wet, blow-dry him.", ["is", "blow-dry"]),
    ],
)
def test_a_verb_of_two_words_is_one_order(text: str, orders: list[str], encoder: bool) -> None:
    tasks = Interpreter.load(encoder=encoder).interpret(text).tasks
    assert [task.span.of(text) for task in tasks] == orders


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Stick the post-it on the mirror.", "the post-it"),
        ("Check the use-by date on the ham.", "the use-by date"),
        ("Bring me the pick-me-up from the larder.", "the pick-me-up"),
    ],
)
def test_an_argument_has_the_whole_name(text: str, value: str, encoder: bool) -> None:
    (task,) = Interpreter.load(encoder=encoder).interpret(text).tasks
    assert task.value("object") == value
