"""Cases of the steps of a plan: which order they are about, what makes way for that, and what is asked anew."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow, unordered

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Unplug the pump and put it away when it's cooled down.", [1, {"if": 3, "then": [2]}]),
        ("Take the pie out, but cut it only when it's cold.", [1, {"if": 3, "then": [2]}]),
        ("Warm the stew, but only serve it to Ann if she's up.", [1, {"if": 3, "then": [2]}]),
        ("Sweep the porch and only mop it if it's dirty.", [1, {"if": 3, "then": [2]}]),
        (
            "See if the lanterns are on in the shed and turn them off if nobody's there.",
            [{"if": 1, "then": [{"if": 3, "else": [2]}]}],
        ),
        (
            "If the alarm does not ring, wake Tom, and call me if he doesn't get up.",
            [{"if": 1, "else": [2, {"if": 4, "else": [3]}]}],
        ),
        (
            "Please dim the lanterns, draw the blinds and start the film, unless Kim isn't back.",
            [{"if": 4, "then": [1, 2, 3]}],
        ),
    ],
)
def test_what_a_case_behind_the_last_order_is_of(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Move the trunk to the cot; if there are books on the cot, put them on the mat.",
            [1, {"if": 2, "then": [3]}],
        ),
        (
            "Take the lift to the roof and bring Kim the parcel; if the lift is out of order, return to the hall.",
            [{"if": 3, "then": [4], "else": [1, 2]}],
        ),
        (
            "If the soup is hot, pour it into a jug and bring it to Lea. If it's not, heat it first.",
            [{"if": [1, 4], "then": [{"same": [2]}, {"same": [3]}], "else": [5, 2, 3]}],
        ),
        ("Set the table for six. If Gran is coming, set it for seven.", [{"if": 2, "then": [3], "else": [1]}]),
        (
            "Set the table for four, or for five if Lea is coming, then light the lanterns.",
            [{"if": 3, "then": [2], "else": [1]}, 4],
        ),
        ("Give her half a tin, but if she leaves it, take it away.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_which_steps_a_case_is_of(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert unordered(flow(interpreter, text)) == unordered(expected)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Check the oven. If it's on, turn it off.", [1, {"if": 2, "then": [3]}]),
        ("Check the larder for eggs. If there are fewer than four, tell Kim.", [1, {"if": 2, "then": [3]}]),
        ("Is the pump on? Are the jars clean? If they are, fill them.", [1, {"if": [2, 3], "then": [4]}]),
        (
            "If the light is red, change the battery, and if you don't have one, call me.",
            [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}],
        ),
        (
            "If the tap in the attic is dripping, close it, and if it keeps dripping, call Kim.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        (
            "If Kim is not back by six, cook the rice, and if he is not back by seven, call me.",
            [{"if": 1, "else": [2, {"if": 3, "else": [4]}]}],
        ),
        ("If there's bread but no butter, go to the shop.", [{"if": 1, "then": [{"if": 2, "else": [3]}]}]),
        ("If Lea doesn't shut the gate, shut it.", [{"if": 1, "else": [2]}]),
    ],
)
def test_what_is_asked_anew(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_where_something_is_keeps_nothing_from_the_next_order(interpreter: Interpreter) -> None:
    assert flow(interpreter, "If Kim asks, the key is on the hook. Lock the gate.") == [1, 2]


@pytest.mark.parametrize(
    "text",
    [
        "See if the cat is in the attic. If she is, bring her in; if she's on the roof, call Kim; if you can't find "
        "her, let me know.",
        "Check if Kim is in the study. If he is, give him the jar; if he's in the shed, tell him to come; if he's out, "
        "put the jar on the mat.",
    ],
)
def test_who_is_nowhere_is_in_none_of_the_places(interpreter: Interpreter, text: str) -> None:
    second = {"if": [4, 6], "then": [5], "else": [7]}
    assert flow(interpreter, text) == [{"if": [1, 2], "then": [3], "else": [second]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Switch the router off and on again.", [1, 2]),
        ("If the screen is black, turn it off and then back on.", [{"if": 1, "then": [2, 3]}]),
        ("Turn the lantern on if it's off and on the desk.", None),
        ("Switch the router off and on again when it hangs.", [{"if": 3, "then": [1, 2]}]),
    ],
)
def test_what_is_switched_off_and_on_again(interpreter: Interpreter, text: str, expected: Any) -> None:
    found = interpreter.interpret(text)
    states = [task.value("state") for task in found.tasks if task.type == "change_state"]
    assert states == (["off", "on"] if expected is not None else ["on"])
    assert expected is None or found.to_json()["flow"] == expected


def test_a_second_place_is_looked_at_as_well(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Look for the rope on the desk, otherwise in the trunk. Then bring it.")
    assert [task.value("location") for task in found.tasks[:2]] == ["on the desk", "in the trunk"]
    assert found.to_json()["flow"] == [{"if": 1, "else": [2]}, 3]


def test_who_is_told_is_not_whom_it_is_about(interpreter: Interpreter) -> None:
    assert interpreter.interpret("If he is in pain, get the nurse.").tasks[0].value("object") == "he"
    assert interpreter.interpret("If he's asleep, wake Kim.").tasks[0].value("object") == "Kim"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If Kim is asleep, leave the lantern on. Once he's awake, turn it off.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
        (
            "Take the first jar to the attic, or to the shed if the attic is full.",
            [{"if": 3, "then": [2], "else": [1]}],
        ),
        ("If I'm late, start cooking the rice and set the table.", [{"if": 1, "then": [2, 3]}]),
    ],
)
def test_when_and_what_is_begun(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Switch the lantern on for the children and off again once they've left.", [1, {"if": 3, "then": [2]}]),
        ("Turn the radio on for Gran, and off again after she's gone to bed.", [1, 3, 2]),
        ("Turn the heater on now and off when I leave.", [1, {"if": 3, "then": [2]}]),
        ("Turn the pump off for now and back on when Lea comes home.", [1, {"if": 3, "then": [2]}]),
    ],
)
def test_what_is_switched_for_something_is_switched_back_after_it(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Has my supper come? If it's downstairs fetch it, put the stew in a bowl and zap it if it's gone cold, "
         "then bring it to me.", [{"if": [1, 2], "then": [3, 4, {"if": 6, "then": [5]}, 7]}]),
        ("Did the cake come? If it's outside bring it in, pour the tea in a pot and heat it up if it's cold, "
         "then call me.", [{"if": [1, 2], "then": [3, 4, {"if": 6, "then": [5]}, 7]}]),
        ("If she's home, put the stew in a dish and zap it if it's cold, then take it up.",
         [{"if": 1, "then": [2, {"if": 4, "then": [3]}, 5]}]),
        ("Is the stew cold? If it is, put it in a pan and heat it if it's cold.",
         [{"if": [1, 2, 5], "then": [3, 4]}]),
        ("Is the gate open? Close it if it's open, then come back.", [{"if": [1, 3], "then": [2]}, 4]),
    ],
)  # fmt: skip
def test_what_is_asked_behind_one_step_of_a_case_is_of_that_step(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected
