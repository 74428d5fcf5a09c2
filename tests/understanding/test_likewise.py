"""What "the same" says again of something else is an order of its own, with the verb and state of the one before."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "carrier", "kind", "said"),
    [
        (
            "Switch off the fan. Do the same with the heater.",
            "Do",
            "change_state",
            {"object": "the heater", "state": "off"},
        ),
        ("rinse the bowl and do the same for the tray", "do", "change_state", {"object": "the tray"}),
        (
            "Empty the bin in the study and do the same with the one in the hall.",
            "do",
            "change_state",
            {"location": "in the hall"},
        ),
        (
            "Shut the blind in the study, then do exactly the same in the den.",
            "do",
            "change_state",
            {"object": "the blind", "location": "in the den"},
        ),
        (
            "Switch the heater on in the den and do the same upstairs.",
            "do",
            "change_state",
            {"object": "the heater", "location": "upstairs"},
        ),
        ("Turn the fan off, same for the lamp.", "same", "change_state", {"object": "the lamp", "state": "off"}),
        (
            "If the gate is open, shut it. The same goes for the shed door.",
            "same",
            "change_state",
            {"object": "the shed door"},
        ),
        (
            "Take the green pot to Lea and do the same with the brown one.",
            "do",
            "bringing",
            {"object": "the brown pot", "recipient": "to Lea"},
        ),
        (
            "If the fan is on, turn it off. If the pump is on, do the same.",
            "do",
            "change_state",
            {"object": "the pump", "state": "off"},
        ),
        (
            "If Kim is awake, bring him a tea. If Lea is awake, do the same.",
            "do",
            "bringing",
            {"object": "a tea", "recipient": "Lea"},
        ),
    ],
)
def test_the_same_is_ordered_of_something_else(
    text: str, carrier: str, kind: str, said: dict[str, str], encoder: bool
) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    task = found.tasks[-1]
    assert (task.span.of(text), task.type) == (carrier, kind)
    assert {name: task.value(name) for name in said} == said


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    "text",
    [
        "Bring me the same mug as yesterday.",
        "Fetch the jar with the same label and put it on the desk.",
        "If Lea does the same with the bikes, tell me.",
        "Shut the blind and tell Lea to do the same.",
    ],
)
def test_what_is_the_same_otherwise_repeats_no_order(text: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert not any(task.repeats for task in found.tasks)
