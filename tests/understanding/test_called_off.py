"""What is called off, forbidden again or put otherwise in a case behind its order."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "Vacuum the attic, but leave it if the baby is asleep.",
        "Wake Lea at six, but let her sleep if she was ill.",
        "Mow the meadow, but skip it if it's wet.",
        "Fold the rugs but don't bother if they're still damp.",
    ],
)
def test_what_a_but_calls_off_ahead_of_the_case_is_not_done_in_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "else": [1]}]


@pytest.mark.parametrize(
    "text",
    [
        "Pick the figs, and if any of them are green, leave them be.",
        "Pick the figs, and if any are green, leave them.",
        "Iron the blouses. If any of them are silk, leave those alone.",
    ],
)
def test_some_that_are_let_be_call_off_the_order(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "else": [1]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Empty the ashtrays if they are full and leave them alone otherwise.", [{"if": 2, "then": [1]}]),
        ("Water the ferns if they're dry and leave them otherwise.", [{"if": 2, "then": [1]}]),
        ("Wash the towels if they smell and leave them alone if they don't.", [{"if": [2, 3], "then": [1]}]),
    ],
)
def test_what_is_let_be_otherwise_is_done_in_the_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_what_is_left_somewhere_is_put_there(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Wash the wok, but leave it on the stove if it's hot.")
    assert [task.type for task in found.tasks] == ["change_state", "placing", "check_state"]


@pytest.mark.parametrize(
    "text",
    [
        "If the fern looks dry, water it; but don't water it if there's still water in the saucer.",
        "If the meadow is long, mow it. Don't mow it if it's wet.",
        "If the wok is dirty, scrub it, but don't scrub it if it's the black one.",
    ],
)
def test_what_is_forbidden_again_in_a_case_hangs_on_that_too(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 4, "else": [{"same": [2, 3]}]}]}]


def test_an_order_may_be_forbidden_again_in_the_next_sentence(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Mow the meadow. Don't mow it if it's wet.") == [{"if": 3, "else": [{"same": [1, 2]}]}]


@pytest.mark.parametrize(
    "text",
    [
        "Don't switch the fan off, just turn it down if it gets cold.",
        "Don't wake Lea, just leave the tray on the shelf if she's asleep.",
    ],
)
def test_what_is_done_just_instead_has_the_case_and_none_of_the_forbidden_words(
    interpreter: Interpreter, text: str
) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == [{"if": 2, "then": [1]}]
    assert "off" not in found.tasks[0].values("state")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Put the jug away if nobody needs it.", [{"if": 2, "else": [1]}]),
        ("Put the pie in the freezer if no one wants it.", [{"if": 2, "else": [1]}]),
        ("Close the hatch if nobody has done it yet and wipe the shelf.", [{"if": 2, "else": [1]}, 3]),
        ("Turn the fan down if someone objects.", [{"if": 2, "then": [1]}]),
        ("See if anyone wants tea.", [1]),
        ("Let me know if somebody calls.", [1]),
        ("Nobody left unless somebody had fainted.", []),
    ],
)
def test_a_case_of_somebody_behind_its_order(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Put the pie in the freezer if there's space, or else in the larder.",
        "Hang the cape on the hook if the hook is free, or else over the rail.",
        "Take the parcel to Lea if she's in, or else to Kim.",
    ],
)
def test_an_or_else_names_another_place_for_the_order(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1], "else": [3]}]


def test_a_place_where_something_is_may_be_another(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring me the horn, it's in the attic or else under the bench.")
    assert len(found.tasks) == 1
    assert found.tasks[0].values("source") == ("in the attic", "under the bench")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Turn off the heating. If Gran's cold, leave it on.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Close the curtains. If Mia isn't asleep, keep them open.", [{"if": 2, "then": [1], "else": [3]}]),
        ("Lock the gate, but leave it open if the goat is out.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Turn the fan off. Leave it on if the study is hot.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Turn the lamp on. If nobody's in, leave it off.", [{"if": 2, "then": [1], "else": [3]}]),
        (
            "Turn the radio off and close the hatch. If Tom is listening, leave it on.",
            [{"if": 3, "then": [4], "else": [1]}, 2],
        ),
        (
            "If it's dark, close the hatch. If the cat is outside, leave it open.",
            [{"if": 1, "then": [{"if": 3, "then": [4], "else": [2]}]}],
        ),
        ("Throw away the rolls. If they're still fresh, keep them.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Take the pie out of the oven. If it isn't brown, leave it in.", [{"if": 2, "then": [1], "else": [3]}]),
        ("Take the pie out. If it isn't done, leave it in.", [{"if": 2, "then": [1], "else": [3]}]),
    ],
)
def test_what_is_kept_as_it_was_is_not_changed(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Open the hatch. If it's warm, leave it open.", [1, {"if": 2, "then": [3]}]),
        ("Close the hatch. If Anna is asleep, leave the radio on.", [1, {"if": 2, "then": [3]}]),
        ("Open the hatch. If the cat is outside, let it in.", [1, {"if": 2, "then": [3]}]),
        ("Pick up the scarf. If it's wet, leave it on the radiator.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_what_is_done_to_another_end_comes_behind(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected
