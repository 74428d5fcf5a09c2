"""A noun that the tagger takes for something else is the last word of its phrase."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load(encoder=True)


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("The towel warmer smells odd. Turn it off.", "The towel warmer"),
        ("The soil warmer is humming. Unplug it.", "The soil warmer"),
        ("The jar is warmer than the cup. Bring it to me.", "The jar"),
        ("You'll find the door stop under the desk. Bring it here.", "the door stop"),
        ("Can't find the bike pump anywhere. Could you check the shed?", "the bike pump"),
        ("I can't see my gym pass anywhere. Try the desk drawer.", "my gym pass"),
        ("You'll see the gate lock hanging on a nail, bring it over here.", "the gate lock"),
        ("You'll see the dog run out. Call him back and wash him.", "the dog"),
        ("If you find the jug fill it.", "the jug"),
        ("If you can't find the lid use foil.", "the lid"),
    ],
)
def test_what_can_be_but_a_noun_ends_a_compound(interpreter: Interpreter, text: str, thing: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == thing
