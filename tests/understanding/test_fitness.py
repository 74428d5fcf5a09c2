"""What a state or an act cannot be of, be it named ever so near."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verb", "value"),
    [
        ("Before putting the figurine on the side table, rinse it in the sink.", "rinse", "the figurine"),
        ("Before laying the cloth on the garden table, iron it.", "iron", "the cloth"),
        ("Don't put the roast on the guest's plate unless it isn't hot anymore.", "is", "the roast"),
        ("Put the jam on the shelf if it is cold.", "is", "the jam"),
        # what is hot, opened or filled itself
        ("Put the quiche in the oven when it's hot.", "'s", "the oven"),
        ("Before putting the tulips in the vase, fill it with water.", "fill", "the vase"),
        ("Put the gown in the wardrobe, then close it.", "close", "the wardrobe"),
    ],
)
def test_what_is_put_is_what_is_washed_or_hot(text: str, verb: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("object") for task in found.tasks if task.span.of(text) == verb] == [value]


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Turn the grill on and wipe the bench, and once it's hot call me.", "the grill"),
        ("Switch on the hob and warm the gravy. If it's hot, serve it.", "the gravy"),
        ("Turn the grill on and mop the floor. If it's dry, call me.", "the floor"),
        ("Turn the lamp on and check the radiator. If it's warm, call me.", "the radiator"),
    ],
)
def test_what_is_wiped_does_not_get_hot(text: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("object") for task in found.tasks if task.span.of(text) == "'s"] == [value]


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("I need a stamp. Look in the drawer; if it's empty, ask Lea.", "the drawer"),
        ("Is there any honey in the jar? If it's empty, tell me.", "the jar"),
        ("Check the toolbox for a hammer, and if it's empty, call me.", "the toolbox"),
        # what is filled itself
        ("Look in the cupboard for the flask, and if it's empty, fetch the jug.", "the flask"),
        ("Find the watering can in the shed. If it's empty, leave it.", "the watering can"),
    ],
)
def test_what_is_looked_for_is_not_what_is_empty(text: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("object") for task in found.tasks if task.span.of(text) == "'s"] == [value]


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Take the novel to the library, and if it's closed, come home.", 2, "the library"),
        ("Take this to the bank. If it's shut, bring it back.", 2, "the bank"),
        ("Put the plate on the shelf, and if it's full, on the counter.", 2, "the shelf"),
        ("Put the juice in the fridge. If it's nearly empty, tell me.", 2, "the juice"),
        ("Spread the cloth on the table. If it's ripped, get another.", 2, "the cloth"),
        ("Take the mat off the floor. If it's dry, fold it.", 2, "the mat"),
        # what can be so itself
        ("Take the bag to the library, and if it's open, close it.", 2, "the bag"),
        ("Put the jug on the shelf, and if it's full, cover it.", 2, "the jug"),
        ("Put the wine in the fridge if it's empty.", 2, "the fridge"),
        ("Put the soup in the pot. If it's empty, fill it.", 2, "the pot"),
        ("Mop the floor. If it's dry, call me.", 2, "the floor"),
    ],
)
def test_a_state_is_of_what_can_have_it(interpreter: Interpreter, text: str, number: int, value: str) -> None:
    assert interpreter.interpret(text).task(number).value("object") == value


def test_nothing_is_where_it_is_itself(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Get me the big pan, and if the big pan isn't there, the small one is fine.")

    assert found.tasks[1].value("location") == "there"


@pytest.mark.parametrize(
    "text",
    [
        "Put the toys in the red tub and if the red tub is full use the blue one.",
        "Put the toys in the red tub. If the red tub is full, use the blue one.",
    ],
)
def test_what_goes_elsewhere_is_not_the_place_that_is_full(text: str) -> None:
    found = Interpreter.load().interpret(text)

    assert found.tasks[2].value("object") == "the toys"
    assert found.flow.to_json() == [{"if": 2, "then": [3], "else": [1]}]


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Scrub the toilet and open the window, but if it's occupied, tell me.", 3, "the toilet"),
        ("Clean the bathroom and the mirror, but if it's occupied, wait.", 2, "the bathroom"),
        # what is not asked to be free
        ("Scrub the toilet and empty the bucket, but if it's cracked, tell me.", 3, "the bucket"),
    ],
)
def test_a_place_is_occupied_and_no_thing(interpreter: Interpreter, text: str, number: int, value: str) -> None:
    assert interpreter.interpret(text).task(number).value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If there's post on the tray, sort it. If the tray's bare, look in the porch.", None),
        ("Is there tea in the tin? If the tin is empty, look in the cupboard.", None),
        ("If the tin is missing, look in the cupboard.", "the tin"),
    ],
)
def test_what_is_empty_is_not_looked_for(interpreter: Interpreter, text: str, value: str | None) -> None:
    found = interpreter.interpret(text).tasks[-1].value("object")
    assert found == value or (value is None and found in ("post", "tea"))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If the milk is sour, pour half of it away.", "the milk"),
        ("Shut the tap. If the water is cloudy, change a third of it.", "a third of the water"),
    ],
)
def test_so_much_is_of_what_a_case_is_of(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") in (value, f"half of {value}")
