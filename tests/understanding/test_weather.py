"""The weather, whose "it" stands for itself, also where it is mentioned again or said in other words."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "Is it hailing? If it is, bring the pots in.",
        "If it's raining, shut the hatch. If it isn't, leave it open.",
    ],
)
def test_a_mention_of_the_weather_names_nothing_else(interpreter: Interpreter, text: str) -> None:
    checks = [task for task in interpreter.interpret(text).tasks if task.type == "check_state"]
    assert len(checks) == 2
    assert all(check.value("object") in ("it", "It") for check in checks)


@pytest.mark.parametrize(
    "text", ["If it's proper chucking it down, bring the rugs in.", "If it's tipping down, bring the rugs in."]
)
def test_how_it_rains_is_no_order(interpreter: Interpreter, text: str) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == ["check_state", "bringing"]


def test_what_is_in_the_sky_is_not_moved(interpreter: Interpreter) -> None:
    text = "The quilts are airing on the wall. If there are clouds, bring them all in."
    assert interpreter.interpret(text).tasks[-1].value("object") == "The quilts"


def test_the_weather_is_nothings_without_its_apostrophe(interpreter: Interpreter) -> None:
    assert interpreter.interpret("fetch me my wellies if its pouring").tasks[1].value("object") is None
    assert interpreter.interpret("wash the jug if its dirty").tasks[1].value("object") == "the jug"


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("Turn the lamp on, but leave it if nobody is in the kitchen.", None),
        ("Is it dark? Turn the lamp on. If it's already on, leave it.", "the lamp"),
        ("Is it raining? Bring the washing in. If it's wet, hang it up.", "the washing"),
        ("If it's below zero, salt the steps.", "it"),
    ],
)
def test_what_no_weather_is_told_of_keeps_its_own_thing(interpreter: Interpreter, text: str, thing: str | None) -> None:
    checks = [task for task in interpreter.interpret(text).tasks if task.type == "check_state"]
    assert checks[-1].value("object") == thing


@pytest.mark.parametrize(
    "text",
    [
        "Bring me a jumper if it's chilly.",
        "Shut the blinds if it's night.",
        "Take the rug to the porch, then open the window if it's warm outside.",
    ],
)
def test_the_air_and_the_time_of_day_are_nothing_that_is_handled(interpreter: Interpreter, text: str) -> None:
    instruction = interpreter.interpret(text)
    assert instruction.tasks[-1].value("object") == "it"
    assert not instruction.missing
