"""Conditions that are said again: what "if it is" and "if they're still there" are about."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


def told(found: Interpreter, text: str, kind: str) -> list[str | None]:
    """What the checks of a text are about, or where that is, in text order."""
    return [task.value(kind) for task in found.interpret(text).tasks if task.type == "check_state"]


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("Is the tea still warm? I'll have a cup if it is. If it's cold, warm it up.", ["the tea"] * 3),
        ("Is the ironing done? Bring me a shirt if it is.", ["the ironing"] * 2),
        ("Check whether the freezer is on. Plug in the lamp if it is, and if it isn't, call Ada.", ["the freezer"] * 3),
        ("Is the milk fresh? I'd like a glass if it is, otherwise pour it away.", ["the milk"] * 2),
        ("Has the kettle boiled? Make the tea if it has.", ["the kettle"] * 2),
        ("Did the post come? Bring me a knife if it did.", ["the post"] * 2),
        # a condition that was not asked before is of what is named right ahead of it
        ("Is the dryer done? Hang the shirt up if it's wet.", ["the dryer", "the shirt"]),
        ("Bring me the paper if it's dry. If it isn't, hang it over the chair.", ["the paper"] * 2),
        ("If the soup is hot, bring me a bowl. If the bowl is chipped, bring a mug.", ["the soup", "the bowl"]),
    ],
)
def test_a_condition_said_again_is_of_what_it_was_of(interpreter: Interpreter, text: str, values: list[str]) -> None:
    assert told(interpreter, text, "object") == values


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (
            "Look into the loft. If the bats are gone, shut the hatch and carry the crates to the garage; if they are "
            "still there, tell Lea.",
            "the loft",
        ),
        ("Look in the pen. If the hens are out, carry the straw to the barn; if they're still there, wait.", "the pen"),
        ("Is the ladder in the garage? If it is, bring it to the balcony; if it's not there, tell me.", "the garage"),
        # where something is already is where it is to go
        (
            "Is there a rug on the sofa? If there is, put it in the chest. If it's in there already, tell me.",
            "the chest",
        ),
        ("See if Tom's van is gone. If so, roll the bin onto his drive. If it's still there, ask Tom.", "his drive"),
    ],
)
def test_there_is_no_place_that_is_first_named_in_the_other_case(
    interpreter: Interpreter, text: str, value: str
) -> None:
    assert told(interpreter, text, "location")[-1] == value


def test_he_is_somebody(interpreter: Interpreter) -> None:
    text = "My gloves aren't here. See if the dog has them, and if he does, get them back."
    assert told(interpreter, text, "object")[-1] == "the dog"


def test_nothing_is_there_where_it_is_itself(interpreter: Interpreter) -> None:
    assert "the parcel" not in told(
        interpreter, "If the parcel has come, tell me; if it isn't there, wait.", "location"
    )


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("Open the fridge. Is the cake in it? If it is, bring it to me.", ["the fridge"] * 2),
        ("Mop the hall unless the paint is still in there. If it is, tell me.", ["the hall"] * 2),
        ("Would you clear the shelf, or is Ben's model still up there? If it is, clean the hob.", ["the shelf"] * 2),
        # what was asked otherwise, or at a place that was named
        ("Look at the soup in the pot. Is it hot? If it is, bring it to me.", [None] * 2),
        ("Is the cake in the fridge? If it is, bring it to me.", ["in the fridge"] * 2),
    ],
)
def test_a_condition_said_again_is_of_the_same_place(
    interpreter: Interpreter, text: str, places: list[str | None]
) -> None:
    assert told(interpreter, text, "location") == places


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        (
            "Take the bottles out. If the grey bin's full, use the red one, and if that's full too, tell me.",
            "the red bin",
        ),
        ("If the first key is bent, try the second one, and if that's bent as well, tell me.", "the second key"),
        # of another state, too
        ("If the towel is wet, wring the towel, and if it's dirty as well, wash it.", "the towel"),
    ],
)
def test_what_is_so_as_well_is_something_else(text: str, value: str, encoder: bool) -> None:
    checks = [t for t in Interpreter.load(encoder=encoder).interpret(text).tasks if t.type == "check_state"]
    assert checks[-1].value("object") == value
