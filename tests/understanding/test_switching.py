"""What is switched or shut, and not what is in it."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verb", "value"),
    [
        ("Lift the wok off the stove and turn it off.", "turn", "the stove"),
        ("The shirts are in the dryer, so start it.", "start", "the dryer"),
        ("The stew is on the hob, switch it off.", "switch", "the hob"),
        ("Turn the grill off if the fish is ready. If it isn't, leave it on.", "leave", "the grill"),
        ("Get the butter out of the fridge and close it.", "close", "the fridge"),
        ("If the safe is open, put the tray inside and close it.", "close", "the safe"),
        ("Is the gate open? If so, carry the box to the shed and close it.", "close", "the gate"),
        ("Put the pie in the oven, and when it's done, turn it off.", "turn", "the oven"),
        ("Take the spade back to the shed and lock it.", "lock", "the shed"),
        # what has a switch, or is shut, itself
        ("If Max is at home, get the parasol in and close it.", "close", "the parasol"),
        ("Take the batteries out of the remote and turn it off.", "turn", "the remote"),
        ("Lift the kettle off the hob and switch it off.", "switch", "the kettle"),
        ("Take the umbrella out of the wardrobe and close it.", "close", "the umbrella"),
        ("Put the pasta in the pot and turn the stove on. When it's done, turn it off.", "turn", "the stove"),
    ],
)
def test_what_is_switched_or_shut_can_be(text: str, verb: str, value: str, encoder: bool) -> None:
    tasks = Interpreter.load(encoder=encoder).interpret(text).tasks
    assert [task.value("object") for task in tasks if task.span.of(text) == verb][-1] == value


def test_what_is_switched_is_not_in_itself() -> None:
    task = Interpreter.load(encoder=True).interpret("The shirts are in the dryer, so start it.").task(1)
    assert [(a.type, a.value) for a in task.arguments] == [("object", "the dryer")]
