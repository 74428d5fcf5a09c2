"""A second check is a condition of its own, a mention of the first or none of both, by what it says."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "If it is dark, turn on the lantern, and if it is raining, close the hatch.",
        "If it's sunny, put the washing out, and if it's windy, close the hatch.",
        "Close the blinds if the sun is shining and turn on the fan if it is hot.",
    ],
)
def test_two_sorts_of_weather_are_two_conditions(interpreter: Interpreter, text: str) -> None:
    one, other = flow(interpreter, text)
    assert len(one["then"]) == len(other["then"]) == 1


def test_one_sort_of_weather_instead_of_another(interpreter: Interpreter) -> None:
    text = "If it is raining, close the hatch, but if it is snowing, make tea."
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Feed the hens, and if nobody is in the attic, close the hatch.",
        "Bring me the axe, and if nobody is using the iron, close the hatch.",
    ],
)
def test_nobody_elsewhere_keeps_nothing_from_the_order_before(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": 2, "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "If the dog has been out, feed him, and if he hasn't been out yet, open the gate.",
        "If Lea has called, tell me, and if she hasn't called yet, ring her.",
    ],
)
def test_what_is_denied_of_the_same_one_is_the_other_side(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}]


def test_fewer_than_was_said_is_the_other_side(interpreter: Interpreter) -> None:
    text = "Check if there are six plates in the larder. If there are fewer, tell me."
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "If Kim is home, ask him whether he has eaten. If he hasn't, heat the soup.",
        "If Lea is awake, ask her if she has slept. If she hasn't, close the blinds.",
    ],
)
def test_a_has_answers_what_was_asked_in_a_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}]


def test_if_so_goes_by_what_was_asked_last(interpreter: Interpreter) -> None:
    text = "If Kim is home, ask him if he wants tea, and if so, make some."
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 2, "then": [3]}]}]


def test_either_tells_of_the_one_asked_last(interpreter: Interpreter) -> None:
    text = "Call Tom. If he doesn't answer, call Anna. If she doesn't answer either, tell me."
    assert flow(interpreter, text) == [1, {"if": 2, "else": [3, {"if": 4, "else": [5]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Close the hatch if it's open and see if the fan is on.",
        "shut the gate if it's open and check that the hatch is locked",
    ],
)
def test_what_is_to_be_checked_besides_is_no_part_of_the_condition(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}, 3]


@pytest.mark.parametrize(
    "text", ["run the washer if its full if not just leave it", "Water the ferns if they're dry and if not leave them."]
)
def test_what_is_left_if_not_is_done_if_so(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}]


@pytest.mark.parametrize(
    "text",
    [
        "Take the pillow to the attic and turn on the lamp if it's dark.",
        "Feed the hens and bring in the laundry if it starts raining.",
        "Feed the hens and close the window when it rains.",
        "Take the horn to the attic and open the hatch if it's closed.",
    ],
)
def test_weather_is_a_case_of_the_last_order_alone_if_only_that_is_for_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": 3, "then": [2]}]


def test_weather_may_be_a_case_of_two_orders(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Bring the chairs in and close the windows if it's raining.") == [
        {"if": 3, "then": [1, 2]}
    ]


@pytest.mark.parametrize(
    "text",
    [
        "Turn on the heater when the attic is cold and turn it off when it's warm.",
        "Turn on the lantern when it's dark and turn it off when it's bright.",
    ],
)
def test_a_when_of_the_opposite_is_the_other_side(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [2, 4], "then": [1], "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "Find Kim and give him this letter. If he isn't there, slide it under his door.",
        "Find Lea and tell her dinner is ready. If she isn't there, call her.",
    ],
)
def test_who_is_not_there_was_not_found(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}]


@pytest.mark.parametrize(
    "text",
    [
        "If the oven is not hot, turn it on. When it is hot, put the pie in.",
        "If the gate is closed, open it. When it is open, let the dog out.",
    ],
)
def test_what_an_order_is_for_is_waited_for_in_any_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text)[1:] == [{"if": 3, "then": [4]}]


def test_a_check_that_leaves_the_state_open_is_one_with_the_next(interpreter: Interpreter) -> None:
    text = "Could you check on the baby? If she's crying call me, otherwise just close the door again."
    assert flow(interpreter, text) == [{"if": [1, 2], "then": [3], "else": [4]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Check on the baby. If she's crying, tell me.", [{"if": [1, 2], "then": [3]}]),
        ("Check on the soup. If it's boiling, turn it down.", [{"if": [1, 2], "then": [3]}]),
        ("Go up and check on the twins. If they are awake, read them a story.", [{"if": [1, 2], "then": [3]}]),
        # what is asked then is of something else
        ("Check on the soup. If the pan is hot, tell me.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_what_a_check_leaves_open_the_case_behind_it_asks(
    interpreter: Interpreter, text: str, expected: list[object]
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("Check that the hatches are closed and close any that aren't.", "else"),
        ("See whether the gates are locked and lock those that aren't.", "else"),
    ],
)
def test_those_that_are_not_so_are_on_the_other_side(interpreter: Interpreter, text: str, side: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, side: [2]}]


@pytest.mark.parametrize(
    "text",
    [
        "Take a plate if there is one, otherwise take a bowl, and bring it to me.",
        "If a cup is clean pick it up, if not wash one, and bring it to me.",
    ],
)
def test_what_is_done_with_either_is_done_in_both_cases(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text)[1] == 4


def test_what_was_picked_up_was_so_in_both_cases(interpreter: Interpreter) -> None:
    text = "Take the rug off the hook and fold it, unless it's damp, in which case put it over the rail."
    assert flow(interpreter, text) == [1, {"if": 3, "then": [4], "else": [2]}]


@pytest.mark.parametrize(
    ("text", "check"),
    [
        ("Turn on the heater if it's cold.", 1),
        ("If it's hot, open the window.", 0),
        ("Bring me a jumper if it's cold.", 1),
    ],
)
def test_how_warm_it_is_is_said_of_no_other_thing(interpreter: Interpreter, text: str, check: int) -> None:
    assert interpreter.interpret(text).tasks[check].value("object") == "it"


@pytest.mark.parametrize(
    ("text", "thing"), [("Bring me the soup if it's hot.", "the soup"), ("Turn off the iron if it is hot.", "the iron")]
)
def test_what_can_be_hot_is_said_to_be_so(interpreter: Interpreter, text: str, thing: str) -> None:
    assert interpreter.interpret(text).tasks[1].value("object") == thing


@pytest.mark.parametrize("state", ["free", "empty"])
def test_a_room_is_free_where_nobody_is(interpreter: Interpreter, state: str) -> None:
    text = f"See if anyone is in the study. If it's {state}, open the hatch."
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}]


def test_it_is_asked_anew_if_a_thing_still_does_not_work(interpreter: Interpreter) -> None:
    text = "If the lamp doesn't work, change the bulb, and if it still doesn't work, tell Kim."
    assert flow(interpreter, text) == [{"if": 1, "else": [2, {"if": 3, "else": [4]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Bring the rugs in if they're wet, and leave them out when they're dry.",
        "Keep the hatch shut if it's wet and leave it open when it's dry.",
    ],
)
def test_the_opposite_of_one_it_is_the_other_side(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [2, 4], "then": [1], "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "Shut the hatch if it's open and open the gate if it's shut.",
        "Turn off the lantern if it's on and turn on the pump if it's off.",
        "Charge the drill if it's flat and unplug it when it's full.",
    ],
)
def test_the_opposite_of_another_thing_is_a_condition_of_its_own(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}]


def test_nobody_there_keeps_nothing_from_an_order_to_change_something(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Feed the hens, and if nobody is there, shut the gate.") == [1, {"if": 2, "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "See if the jug is empty; if there's something left in it, put it in the fridge.",
        "Check if the soup is gone, and if there's some left, bring it.",
        "See if the parcel is gone. If it's still there, bring it.",
        "Check if the radio is broken, and if it still works, bring it.",
    ],
)
def test_what_is_still_there_is_not_gone(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "See if the jug is empty. If there's nothing in it, put it away.",
        "See if the parcel is gone. If it isn't there any more, tell me.",
        "Check if the radio is broken. If it doesn't work, throw it away.",
        "See if the jug is full. If there's something in it, bring it.",
        "See if the fan is on. If it works, tell me.",
    ],
)
def test_what_is_not_there_is_gone(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 2], "then": [3]}]
