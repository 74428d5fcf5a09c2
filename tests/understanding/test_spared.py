"""What is left as it is orders nothing; what is left somewhere or in some state does."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("Wash the big pan and leave the small ones.", ["Wash"]),
        ("Carry the full crates to the cellar, leave the other ones, and shut the hatch.", ["Carry", "shut"]),
        ("Take out the glass bottles and leave the rest of the rubbish.", ["Take"]),
        ("Put the forks in the drawer but leave the spoons.", ["Put"]),
        ("Leave the towels where they are and bring me a blanket.", ["bring"]),
        ("Dust the shelf, but leave the vases as they are.", ["Dust"]),
        ("Leave the plates and bring me the salt.", ["bring"]),
    ],
)
def test_what_is_left_as_it_is_is_no_task(interpreter: Interpreter, text: str, verbs: list[str]) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(text) for task in found.tasks] == verbs
    assert found.warnings == ()


@pytest.mark.parametrize(
    "text",
    [
        "Wash the big pan and leave the small one in the sink.",
        "Close the window but leave the door open.",
        "Wash the pan and leave the kitchen.",
        "Leave the room and close the door.",
        "Take the letter to Anna and leave it there.",
        "Go to the desk and leave the blue one.",
        "If the crate is too heavy, leave it where it is and come back.",
        "Leave the key with Anna and come back.",
    ],
)
def test_what_is_left_somewhere_or_goes_away_is_a_task(interpreter: Interpreter, text: str) -> None:
    assert "leave" in [task.span.of(text).lower() for task in interpreter.interpret(text).tasks]


def test_a_warning_tells_what_must_not_be_left(interpreter: Interpreter) -> None:
    warnings = interpreter.interpret("Wash the pan and don't leave the others.").warnings
    assert any("prohibition" in warning for warning in warnings)


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("If the stew is hot, serve it, but do leave the ladle where it is.", ["is", "serve"]),
        ("Bring the stew, but if it's cold, leave it where it is.", ["Bring", "'s", "leave"]),
    ],
)
def test_what_was_not_named_before_is_spared_in_a_case_too(
    interpreter: Interpreter, text: str, verbs: list[str]
) -> None:
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == verbs
