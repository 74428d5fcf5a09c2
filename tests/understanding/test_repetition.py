"""What a verb is of that is said again without its object."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Mop the hall. If Oskar is in the hall, give him the paper and mop afterwards.", "the hall"),
        ("Sweep the porch, and if it's wet, get the mat from the shed and sweep again.", "the porch"),
        ("Polish the table unless the vase is on it, in which case give me the vase and polish later.", "the table"),
        ("Polish the table. If the cloth is wet, dry the cloth first and then polish again.", "the table"),
        # what is named anew, or added
        ("Water the basil. If the mint is dry, water it too.", "the mint"),
        ("Dust the shelf, get the tray from the loft and dust that.", "the tray"),
    ],
)
def test_a_verb_said_again_is_of_what_it_was_of(text: str, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("object") == value
