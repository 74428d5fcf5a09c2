"""What a further case asks: an answer, another want, a state behind a deed, what was left undone."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        # what somebody was asked, and no earlier condition
        (
            "If Leo's in the den, ask him whether he's thirsty, and bring him some juice if he is.",
            [{"if": 1, "then": [2, {"if": 4, "then": [3]}]}],
        ),
        (
            "If Mum is up, ask her if she wants tea, and make her a cup if she does.",
            [{"if": 1, "then": [2, {"if": 4, "then": [3]}]}],
        ),
        ("If the lamp is on, ask Tom why, and turn it off if it is.", [{"if": [1, 4], "then": [2, 3]}]),
        # another want is asked in any case
        (
            "Look in on Ann; if she's thirsty, bring her some water, and if she's cold, bring her a shawl.",
            [1, {"if": 2, "then": [3]}, {"if": 4, "then": [5]}],
        ),
        (
            "If she's awake, bring her some tea, and if she's asleep, close the door.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        # a state is no opposite of a deed
        (
            "Dim the lights if the kids complain, and if they still aren't happy, switch them off.",
            [{"if": 2, "then": [1, {"if": 3, "else": [4]}]}],
        ),
        (
            "If the kettle has stopped, pour the tea; if it's still going, wait by the door.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        # what I did not do after all
        (
            "I can't recall whether I shut the gate. If I did, great, but if it's still open, shut it and tell me.",
            [{"if": [1, 2], "else": [3, 4]}],
        ),
        (
            "Is the gate open? If it is, shut it, but if it's still open after that, tell me.",
            [{"if": [1, 2], "then": [3, {"if": 4, "then": [5]}]}],
        ),
    ],
)
def test_what_a_further_case_asks(interpreter: Interpreter, text: str, wanted: Any) -> None:
    assert flow(interpreter, text) == wanted


def test_the_answer_is_what_was_asked(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If Leo's in the den, ask him whether he's thirsty, and bring him juice if he is.")
    assert [task.value("state") for task in found.tasks if task.span.of(found.text) == "is"] == ["thirsty"]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("Mow the lawn after you've raked it, which you should only do if it's dry out.", [{"if": 3, "then": [2, 1]}]),
        ("Feed the hens, which you must only do if the coop is shut.", [{"if": 2, "then": [1]}]),
        # wherever it was found
        (
            "Is my hat on the peg? If not, look in the trunk, and once you have it, brush it.",
            [{"if": 1, "else": [2]}, 3],
        ),
        (
            "Look in the hall for my bag. If it's not there, try the car, and when you've got it, hang it up.",
            [{"if": [1, 2], "else": [3]}, 4],
        ),
        # no task at all
        ("Switch the fan off, no, sorry, leave the fan, just open the hatch.", [1]),
        ("Leave the radio, just turn off the lamp.", [1]),
        ("Leave the radio on the table, just turn off the lamp.", [1, 2]),
        # what serves instead, in short
        ("Fetch the ladder; if you can't find it, the stool'll do.", [{"if": [1, 2], "else": [3]}]),
        ("Get the door, would you? If it's the postman, take the parcel.", [1, {"if": 2, "then": [3]}]),
        ("Go to the door and if it's tom let him in and take his coat", [1, {"if": 2, "then": [3, 4]}]),
    ],
)
def test_how_far_a_case_reaches(interpreter: Interpreter, text: str, wanted: Any) -> None:
    assert flow(interpreter, text) == wanted


@pytest.mark.parametrize(
    ("text", "verb", "kind", "values"),
    [
        ("Let the plumber in and show him the boiler.", "Let", "placing", {"object": "the plumber"}),
        ("Get the door for me, please.", "Get", "change_state", {"object": "the door"}),
        ("Get the door handle from the shed.", "Get", "taking", {"object": "the door handle"}),
        ("if no one is in the study close the window", "is", "check_state", {"location": "in the study"}),
        ("The copier's out of toner. If it is, tell Sue.", "is", "check_state", {"state": "out of toner"}),
        ("If it isn't ready, bring it anyway, along with my coat.", "bring", "bringing", {"object": "my coat"}),
    ],
)
def test_what_is_told_of_it(interpreter: Interpreter, text: str, verb: str, kind: str, values: dict[str, str]) -> None:
    task = next(task for task in interpreter.interpret(text).tasks if task.span.of(text) == verb)
    assert task.type == kind
    assert all(value in task.values(name) for name, value in values.items())


def test_nobody_in_a_room_is_told_up_to_the_order(interpreter: Interpreter) -> None:
    check, order = interpreter.interpret("if nobody's in the cellar turn off the radio").tasks
    assert (check.value("location"), order.value("state")) == ("in the cellar", "off")


def test_a_wish_is_what_the_case_behind_a_question_brings(interpreter: Interpreter) -> None:
    assert flow(interpreter, "I'd love a coffee. Is there any milk? If not, bring it black.") == [
        {"if": 1, "else": [2]}
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Check whether the oven is on, turn it off, and if it was on, tell me.", [{"if": [1, 3], "then": [2, 4]}]),
        ("See if the gate is locked, unlock it, and if it was, tell Lea.", [{"if": [1, 3], "then": [2, 4]}]),
        (
            "See if the gate is locked, unlock it, and if it isn't, tell Lea.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        (
            "Check whether the oven is on, turn it off if it is, otherwise tell me.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
    ],
)
def test_what_is_asked_in_the_same_words_again_is_the_same_case(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the attic is hot and the hatch is shut, open it. If it's still hot after that, turn on the fan.",
            [{"if": 1, "then": [{"if": 2, "then": [3, {"if": 4, "then": [5]}]}]}],
        ),
        (
            "If the pan is cold and the stove is free, heat it. If it's still cold afterwards, call me.",
            [{"if": 1, "then": [{"if": 2, "then": [3, {"if": 4, "then": [5]}]}]}],
        ),
        (
            "If the hall is wet and the mop is clean, mop it. If the hall is still wet, open the hatch.",
            [{"if": 1, "then": [{"if": 2, "then": [3]}]}, {"if": 4, "then": [5]}],
        ),
        (
            "If the attic is hot and the hatch is shut, open it. If the hatch is open, turn on the fan.",
            [{"if": 1, "then": [{"if": [2, 4], "then": [3], "else": [5]}]}],
        ),
    ],
)
def test_one_part_of_two_is_asked_anew(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_who_is_told_otherwise_is_not_turned_to_the_other_case(interpreter: Interpreter) -> None:
    text = "Unless I tell you otherwise, close the curtains when it gets dark and open them when it gets light."
    assert flow(interpreter, text) == [{"if": 1, "else": [{"if": 3, "then": [2]}, {"if": 5, "then": [4]}]}]


def test_what_does_the_same_again_is_the_same_thing(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Don't open the oven until the timer rings. When it rings, take the cake out.")
    assert [task.value("object") for task in found.tasks if task.type == "check_state"] == ["the timer", "the timer"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If Tom calls, tell him I'm out. If Ann calls, lock the door. If he calls again, tell me.", ["Tom"]),
        ("If the kids cry, sing. If Max cries, bring him a rug. If they cry again, call me.", ["the kids", "they"]),
    ],
)
def test_of_several_who_do_the_same_it_is_the_one_that_suits(
    interpreter: Interpreter, text: str, expected: list[str]
) -> None:
    check = interpreter.interpret(text).tasks[4]
    assert check.type == "check_state"
    assert check.value("object") in expected


@pytest.mark.parametrize("text", ["Let the plumber in and wipe the sink.", "Let the dog in if he barks."])
def test_nobody_asks_where_to_let_somebody_in(interpreter: Interpreter, text: str) -> None:
    assert not interpreter.interpret(text).missing
