"""Orders without an article, whose verbs look like nouns."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


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
