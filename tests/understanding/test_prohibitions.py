"""Forbidden verbs are no tasks, and what nobody named is asked for."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


@pytest.mark.parametrize(
    ("text", "verb", "tasks"),
    [
        ("Don't open the window.", "open", []),
        ("You must not touch the lamp.", "touch", []),
        ("Never turn off the fridge. Bring me a pen.", "turn", ["Bring"]),
        ("Close the door and do not wash the cup.", "wash", ["Close"]),
    ],
)
def test_a_prohibition_is_no_task_and_is_warned_of(
    interpreter: Interpreter, text: str, verb: str, tasks: list[str]
) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(text) for task in found.tasks] == tasks
    assert any(f"'{verb}" in warning and "prohibition" in warning for warning in found.warnings)


@pytest.mark.parametrize("text", ["Don't open the window unless the oven is hot.", "Why don't you bring me a pen?"])
def test_what_is_forbidden_only_under_a_condition_or_asked_politely_stays(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    assert found.tasks
    assert not any("prohibition" in warning for warning in found.warnings)


def test_an_unnamed_thing_is_asked_for_and_never_the_place_it_goes_to(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Put it on the table.")
    assert [(m.task, m.argument) for m in found.missing] == [(1, "object")]
