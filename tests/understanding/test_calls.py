"""Who is called, paid or sent for, and what is gone on with."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "number", "expected"),
    [
        ("Call a locksmith.", 1, {"recipient": "a locksmith"}),
        ("Call an electrician if the fuse blows.", 1, {"recipient": "an electrician"}),
        ("If Grandma faints, call an ambulance.", 2, {"recipient": "an ambulance"}),
        ("Ring for an electrician.", 1, {"recipient": "for an electrician"}),
        ("Shout for help.", 1, {"message": "for help"}),
        ("Call Mum.", 1, {"recipient": "Mum"}),
    ],
)
def test_who_is_called_is_told(interpreter: Interpreter, text: str, number: int, expected: dict[str, str]) -> None:
    task = interpreter.interpret(text).tasks[number - 1]
    assert (task.type, {a.type: a.value for a in task.arguments}) == ("informing", expected)


@pytest.mark.parametrize(
    ("text", "type", "expected"),
    [
        ("Pay the baker.", "bringing", {"recipient": "the baker"}),
        ("Pay the gardener when he comes.", "bringing", {"recipient": "the gardener"}),
        ("Pay the bill.", "change_state", {"object": "the bill"}),
        ("Carry on with the hoovering.", "change_state", {}),
        ("Go on with the mopping.", "change_state", {}),
        ("Carry on ironing the sheets.", "change_state", {"object": "the sheets"}),
        ("Carry on.", "motion", {}),
    ],
)
def test_what_a_verb_says_by_what_stands_behind_it(
    interpreter: Interpreter, text: str, type: str, expected: dict[str, str]
) -> None:
    task = interpreter.interpret(text).tasks[0]
    assert (task.type, {a.type: a.value for a in task.arguments}) == (type, expected)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Turn off the fountain, then lock up.", None),
        ("Water the ferns and lock up.", None),
        ("Shut the gate and lock up.", "the gate"),
        ("Go to the barn and lock up.", "the barn"),
        ("Wash the plates and recharge.", None),
        ("Put the bricks away, then recharge.", None),
        ("If the torch is flat, recharge.", "the torch"),
        ("Bring the pup to Ida when she gets in, then recharge.", None),
        ("If you hear the baby, tell me. Otherwise get on with the ironing.", None),
    ],
)
def test_who_locks_up_or_recharges_does_it_to_nothing_handled_before(
    interpreter: Interpreter, text: str, expected: str | None
) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == expected
