"""What turns up is found; what somebody refuses is what they are brought; a place that is taken has somebody in it."""

from __future__ import annotations

import pytest
from readings import flow, unordered

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "Look for the drill in the barn. When it turns up, bring it here. If it doesn't show up, ask Joe.",
        "Hunt for my cap in the car; should it surface, put it on the hook, otherwise tell me.",
    ],
)
def test_what_turns_up_was_looked_for(interpreter: Interpreter, text: str) -> None:
    (case,) = unordered(flow(interpreter, text))
    assert case["if"][:2] == [1, 2]
    assert case["then"] == [3]
    assert case["else"] in ([4], [5])


def test_what_turns_up_in_one_of_two_places_is_brought_from_either(interpreter: Interpreter) -> None:
    text = "Look in the hall for my bag. If it isn't there, look in the car. When it turns up, bring it here."
    (case,) = flow(interpreter, text)
    assert case == {"if": [1, 2], "then": [5], "else": [{"if": [3, 4], "then": [{"same": [5]}]}]}


def test_who_refuses_what_they_are_brought_is_asked_where_it_is(interpreter: Interpreter) -> None:
    text = "If the broth is hot, take it to Joan, and if she refuses it, put it in the fridge; if it's cold, warm it."
    (case,) = unordered(flow(interpreter, text))
    assert case["then"] == [2, {"if": 3, "then": [4]}]
    assert case["else"] == [6]


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("Is anyone in the den? If it's occupied, call me.", "then"),
        ("Is anyone in the den? If it's free, call me.", "else"),
        ("Is anyone in the den? If it's occupied, wait; if it's free, call me.", "else"),
    ],
)
def test_a_place_that_is_occupied_has_somebody_in_it(interpreter: Interpreter, text: str, side: str) -> None:
    found = interpreter.interpret(text)
    (case,) = found.flow.to_json()
    assert case[side] == [len(found.tasks)]


@pytest.mark.parametrize(
    "text",
    [
        "Try ringing Joe. No answer? Pin a note on the fridge. If he does pick up, tell him to buy oil.",
        "Ring Joe; if there's no answer, pin a note on the fridge, and if he answers, tell him to buy oil.",
    ],
)
def test_who_picks_up_was_called(interpreter: Interpreter, text: str) -> None:
    (case,) = flow(interpreter, text)
    assert [len(case["then"]), len(case["else"])] == [1, 1]


def test_who_does_not_come_was_called_in_the_case(interpreter: Interpreter) -> None:
    text = "If the pup is out, call him, and if he doesn't come, tell me; if he's in, brush him."
    assert flow(interpreter, text) == [{"if": [1, 5], "then": [2, {"if": 3, "else": [4]}], "else": [6]}]


def test_what_somebody_says_is_asked_where_they_are(interpreter: Interpreter) -> None:
    text = "See if Gran is up. If she is, ask her if she wants her egg now or later, and if she says now, boil it."
    assert flow(interpreter, text) == [{"if": [1, 2], "then": [3, {"if": 4, "then": [5]}]}]


def test_what_hangs_on_what_is_found_is_not_lost_in_the_other_place(interpreter: Interpreter) -> None:
    searched = "Look in the hall for my bag. If it isn't there, look in the car."
    found = flow(interpreter, f"{searched} When it turns up, bring it and if it is wet, dry it.")
    assert str(found).count("7") == 1
    assert found[-1]["if"] == 4, "asked once, of both places"
