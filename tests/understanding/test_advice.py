"""What is carried out as less than it says is said so."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Make me a coffee.", "'Make' is read as 'bring'"),
        ("If Tom is home, could you make him a sandwich?", "'make' is read as 'bring'"),
        ("Count the mugs on the counter.", "'Count' is read as 'look for'"),
        ("Tell Anna how many plates are in the sink.", "'how many plates are in the sink' is told without a number"),
        ("Bring me a coffee.", None),
        ("Make sure the tv is off.", None),
        ("Tell Anna that many plates are in the sink.", None),
    ],
)
def test_what_would_have_to_be_made_or_counted_is_warned_of(text: str, said: str | None) -> None:
    warnings = [w for w in Interpreter.load().interpret(text).warnings if "counted" in w or "nothing is made" in w]
    assert [warning.startswith(said or "") for warning in warnings] == [True] * (said is not None)
