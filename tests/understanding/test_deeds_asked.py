"""What "if he has" and "if it didn't" ask again is what was asked before."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verb", "state"),
    [
        ("Has the glazier left? If he has, lock the gate.", "has", "left"),
        (
            "Have the twins finished their porridge? If they haven't, leave the bowls.",
            "have",
            "finished their porridge",
        ),
        ("If the dough has risen, shape it; if it hasn't, close the door.", "has", "risen"),
        ("See if the courier has come. If he has, bring me the parcel.", "has", "come"),
        ("Did the alarm ring this morning? If it did, wake Ida.", "did", "ring"),
        ("If the sweep turns up by noon, let him in; if he doesn't, call him.", "does", "turns up"),
    ],
)
def test_a_deed_is_asked_again_in_its_own_words(text: str, verb: str, state: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("state") for task in found.tasks if task.span.of(text) == verb] == [state]


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verb", "state"),
    [
        ("Did I leave the grill on? If I did, turn it off.", "did", "on"),  # a state that was asked
        ("Does the mower have any petrol? If it doesn't, bring the can.", "does", None),  # a thing that is had
        ("If Ida is in the loft, call her; if she isn't, close the hatch.", "is", None),  # a place
    ],
)
def test_what_is_no_deed_is_not_asked_as_one(text: str, verb: str, state: str | None, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert found.tasks[-2].span.of(text) == verb
    assert found.tasks[-2].value("state") == state
