"""What a message tells of is what the order behind it goes on about."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Tell Nora supper's on the counter, and if she doesn't come down, take it up to her.", "supper"),
        ("Let Ben know his bath is ready, and if he doesn't want it, let it out.", "his bath"),
        ("If Ruth's up, bring her a bun; tell her she can listen to the radio, and turn it on for her.", "the radio"),
        ("Take Finn some juice, tell him he can watch tv, and switch it on.", "tv"),
        # another thing was named before, or the message tells of somebody
        ("Bring the scarf in, tell Ann her brother is here and give it to her.", "the scarf"),
        ("Pick up the parcel, tell Joe the bus is at the gate and put it on the bench.", "the parcel"),
    ],
)
def test_an_order_goes_on_about_what_was_told(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value
