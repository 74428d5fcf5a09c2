"""A "do so" orders what somebody was asked about; what was ordered before is not ordered again."""

from __future__ import annotations

import pytest

from decomplex_bt.flow import Flow
from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "kind", "thing", "state"),
    [
        ("Ask Lea whether you should lock the shed. If so, do it.", "change_state", "the shed", None),
        ("ask lea if you should water the ferns if yes do so", "change_state", "the ferns", None),
        ("Ask Lea if I should turn off the grill, and if she says yes, do that.", "change_state", "the grill", "off"),
        ("Ask Lea if she wants the hatch open. If she does, do so.", "change_state", "the hatch", "open"),
        ("Ask Lea whether she wants her milk warmed up, and if she says yes, do it.", "change_state", "her milk", None),
        ("Ask Lea to walk the dog. If she can't, do it yourself.", "following", "the dog", None),
        ("Check whether I switched the fan off. If I didn't, please do it.", "change_state", "the fan", "off"),
        ("See if the ferns have been watered, and if not, do it.", "change_state", "the ferns", None),
        ("Has anybody shut the hatch? If not, do so.", "change_state", "the hatch", "shut"),
        ("Did I feed the hens? If not please do it.", "change_state", "the hens", None),
        ("Check if the shed is locked. If it isn't, do it.", "change_state", "the shed", "locked"),
    ],
)
def test_what_was_asked_about_is_done(
    interpreter: Interpreter, text: str, kind: str, thing: str, state: str | None
) -> None:
    found = interpreter.interpret(text)
    task = found.tasks[-1]
    assert (task.span.of(found.text), task.type) == ("do", kind)
    assert (task.value("object"), task.value("state")) == (thing, state)


@pytest.mark.parametrize(
    "text",
    [
        "Lock the shed, and do it before you go.",
        "Ask my nephew to come and do it.",
        "If you can't open the jar, ask Lea to do it.",
        "Ask Lea whether you should lock the shed. If she says no, don't do it.",
        "You can mow the lawn if it's dry. If it's wet, don't do so.",
    ],
)
def test_what_others_do_or_was_ordered_is_no_task_again(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    assert "do" not in [task.span.of(found.text) for task in found.tasks]


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Tell me if the fan's still on, and switch it off if so.", [{"if": [1], "then": [2]}]),
        ("let me know whether the hatch is open and shut it if so", [{"if": [1], "then": [2]}]),
        ("Tell Lea whether there is any oil, and fetch some if not.", [{"if": [1], "else": [2]}]),
        ("Tell me whether the fan is on, and switch the heater off.", [1, 2]),
        ("Tell me why the fan is on, and switch it off.", [1, 2]),
    ],
)
def test_what_is_done_if_so_hangs_on_what_is_to_be_told(interpreter: Interpreter, text: str, flow: list) -> None:
    assert interpreter.interpret(text).flow == Flow.from_json(flow)
