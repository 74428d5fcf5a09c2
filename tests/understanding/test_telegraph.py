"""Orders without an article, whose verbs look like nouns."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.ellipses.telegraph import named


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "orders"),
    [
        ("feed dog, walk dog, brush dog", [("feed", "dog"), ("walk", "dog"), ("brush", "dog")]),
        ("close window, dust shelves, water plants", [("close", "window"), ("dust", "shelves"), ("water", "plants")]),
    ],
)
def test_what_looks_like_nouns_may_be_an_order(
    interpreter: Interpreter, text: str, orders: list[tuple[str, str]]
) -> None:
    found = interpreter.interpret(text).tasks
    assert [(task.span.of(text), task.value("object")) for task in found] == orders


def test_with_articles_nouns_are_nouns(interpreter: Interpreter) -> None:
    assert len(interpreter.interpret("Bring the cup, dust pans and a towel.").tasks) == 1


def test_what_is_to_be_fetched_may_be_a_list(interpreter: Interpreter) -> None:
    assert "dust" not in [
        task.span.of("bring cups, dust pans, brushes")
        for task in interpreter.interpret("bring cups, dust pans, brushes").tasks
    ]


@pytest.mark.parametrize("text", [">*$’$–,)]`#_. /’—+", "feed cat, and then"])
def test_neither_marks_nor_joints_are_done_to_anything(parser: Parser, text: str) -> None:
    document = parser.parse(text)
    others = [token.i for token in document.tokens if not token.text.isalnum() or token.lower in ("and", "then")]
    assert others
    assert not any(named(document, i) for i in others)


def test_marks_without_words_are_read(interpreter: Interpreter) -> None:
    text = ">*$’$–,)]`#_. /’—+\"[$./<'@}  ?:; &,~/$}%«-'-~—&–)[^…~#??…%@«"  # its marks may be taken for verbs
    assert interpreter.interpret(text).text == text
