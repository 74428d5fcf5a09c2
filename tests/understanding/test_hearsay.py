"""What somebody has heard that the robot can do is no order; what others say that it can do for them is one."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("I heard you can carry trays. Carry this one to the attic.", ["Carry"]),
        ("I've read that you can water plants, so water the ferns.", ["water"]),
        ("My niece says you can open doors. Open the one to the shed.", ["Open"]),
        ("My niece says you can open the shed now.", ["open"]),
        ("I think you can fetch the ladder now.", ["fetch"]),
        ("Lea told me you can take the keys to her.", ["take"]),
    ],
)
def test_what_one_has_heard_it_can_do_is_no_order(text: str, verbs: list[str], encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.span.of(text) for task in found.tasks] == verbs
    assert all(len(task.values("object")) == 1 for task in found.tasks)
