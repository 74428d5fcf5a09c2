"""Words that only some people say are read as the plain ones, and stand where and as they were said."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("said", ["I cannae see", "I didny see", "I WASNAE there", "Winna it open?"])
def test_a_verb_joined_to_its_not_is_two_words(said: str) -> None:
    assert len(Parser().parse(said).tokens) > len(said.replace("?", " ?").split())


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("If the hatch isnae shut, shut it.", "If the hatch isn't shut, shut it."),
        ("If ye cannae find the saw, bring us the axe.", "If you can't find the saw, bring us the axe."),
        ("If there's nowt in the jar, tell Lea.", "If there's nothing in the jar, tell Lea."),
        ("Is the stove on? Naw? Then light it.", "Is the stove on? No? Then light it."),
    ],
)
def test_a_dialect_has_the_flow_of_plain_english(interpreter: Interpreter, said: str, plain: str) -> None:
    found, wanted = interpreter.interpret(said), interpreter.interpret(plain)
    assert found.flow == wanted.flow
    assert [task.type for task in found.tasks] == [task.type for task in wanted.tasks]


def test_spans_and_values_keep_what_was_said(interpreter: Interpreter) -> None:
    text = "Fetch the saw oot the shed and gie it tae Lea."
    task = interpreter.interpret(text).tasks[-1]
    assert task.span.of(text) == "gie"
    assert task.value("recipient") == "tae Lea"


@pytest.mark.parametrize(
    "text", ["Tell Lea abt the leak.", "Remind Tom abt his shoes.", "let grandma know abt the tea"]
)
def test_who_is_told_about_something_is_named_without_it(interpreter: Interpreter, text: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert task.value("message") == text[text.index("abt") :].rstrip(".")
    assert task.value("recipient") in text[: text.index(" abt")]
