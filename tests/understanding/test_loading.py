"""What is loaded with things is where those are put; what is filled with a stuff changes its state."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Load the dryer with the sheets.", {"object": "with the sheets", "goal": "the dryer"}),
        (
            "Load the dishwasher with the mugs from the desk.",
            {"object": "with the mugs", "goal": "the dishwasher", "source": "from the desk"},
        ),
        ("Stuff the hamper with all of the shirts.", {"object": "with all of the shirts", "goal": "the hamper"}),
        ("Feed the machine with the blanket.", {"object": "with the blanket", "goal": "the machine"}),
        ("Fill the basket with the apples.", {"object": "with the apples", "goal": "the basket"}),
        (
            "Pack the crate with the bottles and the jars.",
            {"object": "with the bottles and the jars", "goal": "the crate"},
        ),
        ("If the washer is empty, load it with the jeans.", {"object": "with the jeans", "goal": "the washer"}),
    ],
)
def test_what_is_loaded_with_things_is_where_they_are_put(text: str, found: dict[str, str]) -> None:
    task = Interpreter.load().interpret(text).tasks[-1]
    assert task.type == "placing"
    assert {argument.type: argument.value for argument in task.arguments} == found


@pytest.mark.parametrize(
    "text",
    [
        "Fill the jug with water.",
        "Fill the bowl with the soup.",
        "Fill the bucket with warm water and bring it here.",
        "Fill the feeder with seeds.",
        "Load the dishwasher.",
        "Load the printer with paper.",
        "Feed the hens with the crumbs.",
    ],
)
def test_what_is_filled_with_a_stuff_is_put_nowhere(text: str) -> None:
    assert Interpreter.load().interpret(text).tasks[0].type != "placing"


@pytest.mark.parametrize(
    ("text", "type_"),
    [
        ("Stuff the boots with newspaper.", "change_state"),
        ("Stuff the boots with newspaper if they're wet.", "change_state"),
        ("Stuff the socks in the drawer.", "placing"),
    ],
)
def test_what_is_stuffed_with_a_stuff_goes_nowhere(text: str, type_: str) -> None:
    found = Interpreter.load().interpret(text)
    assert (found.task(1).type, found.missing) == (type_, ())
