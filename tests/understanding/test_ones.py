"""Which ones, and how many more of them, are meant."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        # one of the kind, and not the very thing
        ("This knife is blunt. Bring me one that cuts.", "a knife"),
        ("Take that glass away and get me one which isn't chipped.", "a glass"),
        ("The torch is dead. Fetch one that works.", "a torch"),
        # one of several
        ("Look for the brownies and bring me one.", "a brownie"),
        ("Get the mugs and fill one.", "a mug"),
        # so many more
        ("Take the blue shelf to Ben and put the other two in the loft.", "two shelves"),
        ("When both jars are empty, bring me two more.", "two jars"),
        # as before
        ("If you find a pen, bring me one.", "a pen"),
        ("Get a pear if there is one.", "a pear"),
        ("The red mug is dirty. Bring me a clean one.", "a clean mug"),
        ("Bring me three of the apples.", "three of the apples"),
    ],
)
def test_one_is_of_a_kind(text: str, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("object") == value
