"""How far the words of a state go, and what is none."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load(encoder=True)


def _values(interpreter: Interpreter, text: str) -> dict[str, str]:
    """The arguments of the first check, or else of the first task."""
    tasks = interpreter.interpret(text).tasks
    task = next((task for task in tasks if task.type == "check_state"), tasks[0])
    return {a.type: a.value for a in task.arguments}


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("Are the toys boxed up yet? If not, box them up.", "boxed up"),
        ("Is the boat tied up? If not, tie it up.", "tied up"),
        ("Are the beans dug up yet? If so, wash them.", "dug up"),
        ("If the cat is shut in the shed, let it out.", "shut"),
    ],
)
def test_a_participle_keeps_its_particle(interpreter: Interpreter, text: str, state: str) -> None:
    assert _values(interpreter, text)["state"] == state


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("Unless the twins are already at breakfast, take them a roll.", "at breakfast"),
        ("Unless Ida is already at work, take her this.", "at work"),
        ("Unless the guests are still at supper, clear the table.", "at supper"),
    ],
)
def test_where_somebody_is_is_a_place(interpreter: Interpreter, text: str, place: str) -> None:
    told = _values(interpreter, text)
    assert (told.get("state"), told["location"]) == (None, place)


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("If the zip sticks on the way down, stop and tell me.", None),
        ("If the blind jams on the way up, call me.", None),
        ("If Tom is on the phone, wait outside.", "on the phone"),
        ("If the heater is on, switch it off.", "on"),
        ("If Ida is still at her prayers, close the door.", "at her prayers"),
    ],
)
def test_what_goes_wrong_on_the_way_is_in_no_state(interpreter: Interpreter, text: str, state: str | None) -> None:
    assert _values(interpreter, text).get("state") == state


def test_what_is_hung_back_on_is_put_in_no_state(interpreter: Interpreter) -> None:
    assert interpreter.interpret("Hang it back on if it's loose.").tasks[0].value("state") is None


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("If the power goes off this evening, light a candle.", {"object": "the power", "state": "off"}),
        ("If the radio's still on next door, turn it off.", {"object": "the radio", "state": "on"}),
    ],
)
def test_what_is_on_or_off_stays_so_ahead_of_a_time_or_a_place(
    interpreter: Interpreter, text: str, told: dict[str, str]
) -> None:
    task = interpreter.interpret(text).task(1)
    assert {kind: task.value(kind) for kind in told} == told


def test_haste_is_no_state(interpreter: Interpreter) -> None:
    text = "I need the plasters from the car, quick as you can, Ravi has cut his thumb! If there aren't any, tell me."
    assert [task.value("state") for task in interpreter.interpret(text).tasks if task.type == "check_state"] == [None]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Does Ravi have a fever? If he's hot, bring him the syrup, and if he isn't, give him his coat.", "hot"),
        ("Is Ravi tired? If he's hot, bring him the syrup, and if he isn't, give him his coat.", "hot"),
    ],
)
def test_nobody_is_what_they_have(interpreter: Interpreter, text: str, value: str) -> None:
    checks = [task for task in interpreter.interpret(text).tasks if task.type == "check_state"]
    assert checks[-1].value("state") == value
