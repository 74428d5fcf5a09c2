"""Words that stand for several are read as these."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("lemme know if the grill is on", "if the grill is on"),
        ("lemme know whether bea's in and gimme my scarf", "whether bea's in"),
        ("if the shed's locked lemme know", None),
    ],
)
def test_lemme_know_asks_to_be_told(interpreter: Interpreter, text: str, message: str | None) -> None:
    found = interpreter.interpret(text)
    told = next(task for task in found.tasks if task.span.of(found.text) == "lemme")
    assert (told.type, told.value("message")) == ("informing", message)


def test_lemme_have_is_a_request(interpreter: Interpreter) -> None:
    found = interpreter.interpret("lemme have the scissors")
    assert [(task.span.of(found.text), task.type) for task in found.tasks] == [("have", "bringing")]


@pytest.mark.parametrize(
    ("text", "thing", "state"),
    [
        ("if leo's gonna be late call me", "leo", "gonna be late"),
        ("if the rice is going to burn turn the stove off", "the rice", "going to burn"),
        ("if it's gonna be cold tonight close the skylight", "it", "gonna be cold"),
    ],
)
def test_what_is_gonna_be_so_is_a_state(interpreter: Interpreter, text: str, thing: str | None, state: str) -> None:
    check = interpreter.interpret(text).tasks[0]
    assert check.type == "check_state"
    assert (check.value("object"), check.value("state")) == (thing, state)


@pytest.mark.parametrize(
    ("text", "tasks"),
    [
        ("gimme a sec then turn on the fan", ["turn"]),
        ("gimme a minute steak from the freezer", ["gimme"]),
        ("gimme the fan", ["gimme"]),
    ],
)
def test_a_moment_is_nothing_to_be_brought(interpreter: Interpreter, text: str, tasks: list[str]) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(found.text) for task in found.tasks] == tasks
