"""Things that are named by whose they are, or of what kind."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("There's a spare torch in the hall. If it works, give it to Ned; if not, give him mine.", "my torch"),
        ("Put Ann's boots in the hall and mine on the mat.", "my boots"),
        ("If the papers are here, bring me mine and leave Nan's on the step.", "Nan's papers"),
        ("Charge my tablet and Tom's, and when his is full, take it to him.", "his tablet"),
        ("Put my mug on the tray, and if Ida's is on it, bring me hers.", "her mug"),
        ("Is there any bread in the bin? If there's white, toast it.", "white bread"),
        ("See if there's any wine in the cellar. If there's red, open it.", "red wine"),
    ],
)
def test_a_thing_told_by_its_owner_or_kind_has_its_noun(interpreter: Interpreter, text: str, value: str) -> None:
    tasks = interpreter.interpret(text).tasks
    assert value in {a.value for a in tasks[-1].arguments if a.type == "object"}


def test_only_what_there_is_has_a_kind(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Is the lamp in the hall? If it's white, bring it to me.")
    assert found.tasks[-1].value("object") == "the lamp"


def test_anything_of_ours_is_said_in_full(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Look under the bunks and if there's anything of ours, put it in the red bag.")
    assert found.tasks[1].value("object") == "anything of ours"
    assert found.tasks[2].value("object") == "anything of ours"
