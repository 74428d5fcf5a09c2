"""What some of what lies somewhere may be."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "thing", "place"),
    [
        ("Tell me what's lying on the desk, and if any of it is post, take it to Ann.", "post", "on the desk"),
        ("See what's in the crate, and if some of it is rubbish, take it out.", "rubbish", "in the crate"),
        (
            "Tell Pia what's standing on the worktop, and if any of it is crockery, wash it.",
            "crockery",
            "on the worktop",
        ),
    ],
)
def test_of_what_lies_somewhere_a_kind_is_asked_for(text: str, thing: str, place: str, encoder: bool) -> None:
    *_, check, order = Interpreter.load(encoder=encoder).interpret(text).tasks
    assert (check.value("object"), check.value("location"), check.value("state")) == (thing, place, None)
    assert order.value("object") == thing


def test_of_a_state_nothing_is_asked_for(interpreter: Interpreter) -> None:
    check = interpreter.interpret("Tell me what's on the line, and if any of it is wet, tell Ann.").task(2)
    assert check.value("state") == "wet"
