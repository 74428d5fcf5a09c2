"""What "this" and a first "it" point at, which nothing named later is."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Put this in the cellar and bring me the jar.", 1, "this"),
        ("Take these to Lena, and get the key from her.", 1, "these"),
        ("If Ruth is out, leave this on the porch.", 2, "this"),
        ("Fold it and bring me a clean shirt.", 1, "it"),
        ("Shut it and open the blinds.", 1, "it"),
        # what was pointed at is taken up again
        ("Take this to Ben, and if he's asleep, put it on the desk.", 3, "this"),
        ("Take this to the pharmacy. If it's closed, put it in the hall.", 3, "this"),
        # what was named before, or is asked of behind
        ("Fold the rug, lay this on top and carry everything to the van.", 2, "the rug"),
        ("Bring it to me if the tea is hot.", 1, "the tea"),
        ("Before you wash it, empty the pot.", 1, "the pot"),
    ],
)
def test_nothing_named_later_is_pointed_at(text: str, number: int, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).task(number).value("object") == value
