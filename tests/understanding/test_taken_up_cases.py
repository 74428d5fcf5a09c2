"""Cases that are taken up again: "in that case", "if neither", "too", "instead", what is found wherever it was."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the stew is hot, serve it. If it is not, heat it. In that case, also set the table.",
            [{"if": [1, 3], "then": [2], "else": [4, 5]}],
        ),
        (
            "If the jug is full, bring it; if it isn't, fill it. In the latter case, also tell Lea.",
            [{"if": [1, 3], "then": [2], "else": [4, 5]}],
        ),
        (
            "If the jug is full, bring it; otherwise fill it. In the former case, close the hatch.",
            [{"if": 1, "then": [2, 4], "else": [3]}],
        ),
        (
            "If the hatch is open, close it. In that case also tell Lea.",
            [{"if": 1, "then": [2, 3]}],
        ),
    ],
)
def test_what_is_done_in_that_case_is_done_in_the_case_told_last(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Is the dog in the yard? Is the cat in the shed? If neither, close the gate.",
            [{"if": 1, "else": [{"if": 2, "else": [3]}]}],
        ),
        (
            "Check if the kiln is hot and check if the vat is full. If neither, tell Lea, otherwise lock up the shed.",
            [{"if": 1, "then": [4], "else": [{"if": 2, "then": [{"same": [4]}], "else": [3]}]}],
        ),
        (
            "Look for the pliers in the shed and look for them in the attic. If they're in neither, tell Lea.",
            [{"if": 1, "else": [{"if": [2, 3], "else": [4]}]}],
        ),
    ],
)
def test_neither_of_two_things_that_are_found_out(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Close the open shutters, and if none of them are open, tell Lea.",
        "Wash any dirty bowls. If none are dirty, tell me.",
        "Pick up the wet towels, and if none is wet, tell me.",
    ],
)
def test_none_is_so_of_what_an_order_calls_so(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}]


@pytest.mark.parametrize(
    "text",
    ["Turn on the fan; if it isn't working, open the hatch.", "Switch on the lantern. If it's not lit, tell me."],
)
def test_what_is_switched_on_and_does_not_work_has_failed(interpreter: Interpreter, text: str) -> None:
    (node,) = flow(interpreter, text)[-1:]
    assert node["else"] == [3]
    assert "then" not in node


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Bring in some peat from the barn. If it's wet, leave it by the stove; if it's dry, put it in the chest.",
            [1, {"if": [2, 4], "then": [3], "else": [5]}],
        ),
        (
            "Bring the washing in. If it's damp, leave it on the line.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
    ],
)
def test_what_both_cases_handle_is_fetched_in_either(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_what_was_looked_for_in_two_places_is_brought_from_either(interpreter: Interpreter) -> None:
    text = "Look for my scarf on the rack, and if it isn't there, look in the chest. Bring it to me, unless it's wet."
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}, {"if": 5, "else": [4]}]


def test_a_further_thing_is_brought_too(interpreter: Interpreter) -> None:
    text = "If Lea's kite's in the shed bring it to the porch, if Tim's kite's in the shed bring that to the porch too."
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Take her scarf and hang it in the porch. If there isn't a free peg, lay it on the bench.",
            [1, {"if": 3, "then": [2], "else": [4]}],
        ),
        (
            "Wash the bowls and put them in the cupboard. If there's no space, put them on the bench.",
            [1, {"if": 3, "then": [2], "else": [4]}],
        ),
    ],
)
def test_what_there_is_no_room_for_is_put_elsewhere(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_what_is_put_right_first_is_for_the_order_ahead(interpreter: Interpreter) -> None:
    text = "Put the pie in the oven, but first see if it's hot, and if it's not, turn it on."
    assert flow(interpreter, text) == [{"if": [2, 3], "else": [4]}, 1]


@pytest.mark.parametrize(
    "text",
    [
        "If the lantern isn't on, unplug the charger, then plug it back in.",
        "If the light isn't green, switch off the pump, wait a minute, then switch it back on.",
    ],
)
def test_what_is_undone_in_a_case_is_put_back_in_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "else": [2, 3]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Go to the porch, but first check if the gate is locked, and unlock it if it is.",
            {"if": [2, 4], "then": [3]},
        ),
        ("See if the hatch is open, and close it if it is.", {"if": [1, 3], "then": [2]}),
        ("See if the hatch is shut, and shut it if it isn't.", {"if": [1, 3], "else": [2]}),
    ],
)
def test_an_order_ahead_of_an_echo_is_on_its_side(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text)[0] == expected


def test_the_second_of_two_conditions_is_taken_up_by_its_name(interpreter: Interpreter) -> None:
    text = "If the shutters are closed and the lantern is on, bring me the map. If the lantern is off, turn it on."
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": [2, 4], "then": [3], "else": [5]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the shed is dusty, sweep it. Second, if the bin is not full, put the leaves in it; if it is, "
            "burn them. Third, close the hatch, unless it is already closed.",
            [{"if": 1, "then": [2]}, {"if": [3, 5], "then": [6], "else": [4]}, {"if": 8, "else": [7]}],
        ),
        (
            "First, look for the hose in the shed. Second, provided the search succeeded, water the ferns.",
            [{"if": 1, "then": [2]}],
        ),
    ],
)
def test_the_next_of_several_matters_hangs_on_none_before(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Take the boots to the porch. Before any of this check if the gate is locked, and if it is, unlock it.",
            [{"if": [2, 3], "then": [4]}, 1],
        ),
        (
            "Look in the shed; if it is not there, try the attic. Oh, and shut the gate before you start any of that.",
            [4, {"if": [1, 2], "else": [3]}],
        ),
        ("Before you go to the attic, close the hatch, and once you're there, turn on the lantern.", [2, 1, 3]),
        ("Before you go to the attic, close the hatch, and then turn on the lantern.", [2, 1, 3]),
    ],
)
def test_what_comes_before_all_that_or_on_arrival(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_an_order_beside_a_remark_that_leaves_the_choice(interpreter: Interpreter) -> None:
    text = "If there's any cider, bring us the jug, and if there isn't, just a glass of water, I'm not fussy."
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}]


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("Fill the bucket. If the tap is broken, fill it from the pond.", "object", "the bucket"),
        ("Check the trap, and if the bait's gone, put a bit of ham in it.", "goal", "the trap"),
        ("Turn on the torch. If the battery is dead, put a new one in it.", "goal", "the torch"),
        ("Turn on the heater. If the tank is empty, put some oil in it.", "goal", "the tank"),
        ("Take my aunt's scarf to her.", "recipient", "my aunt"),
        (
            "Clean my apron and if the stain doesn't come off bring me another one from the attic.",
            "object",
            "another apron",
        ),
        ("See whether next door's gate is still open. If it is, close it.", "object", "next door's gate"),
        ("If there is cider, bring me a glass of it.", "object", "a glass of cider"),
        ("Has the milk gone off? If not, warm one cup of it.", "object", "one cup of the milk"),
        ("Wash the pot and keep in the cupboard.", "object", "the pot"),
        ("Rinse the bowls and stack in the dishwasher.", "object", "the bowls"),
        ("Open the washer and put in the sheets.", "goal", "the washer"),
        ("Bring me a knife, a plate, plus a fork.", "object", "a knife, a plate, plus a fork"),
    ],
)
def test_what_the_last_order_is_of(interpreter: Interpreter, text: str, kind: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value(kind) == value


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Take the ash out. If the crate is full, take that out too.", [1, {"if": 2, "then": [3]}]),
        ("Bring me the map. If the globe is on the bench, bring me that as well.", [1, {"if": 2, "then": [3]}]),
        (
            "Get the scarf from the car and put it on the rack if it's dry; otherwise put it in the dryer.",
            [1, {"if": 3, "then": [2], "else": [4]}],
        ),
        (
            "Dry the jars and put them in the chest, but if one of them is chipped, set it aside.",
            [1, 2, {"if": 3, "then": [4]}],
        ),
        (
            "Don't open the gate until you have found the dog. If you can't find her, tell Lea.",
            [{"if": [2, 3], "then": [1], "else": [4]}],
        ),
        (
            "If the milk is sour, don't give it to Lea, but give her juice instead.",
            [{"if": 1, "then": [3], "else": [2]}],
        ),
        (
            "If the lantern is off, turn it on; if it is on, dust it before taking it to Lea.",
            [{"if": [1, 3], "then": [2], "else": [4, 5]}],
        ),
    ],
)
def test_what_a_case_keeps_from_and_what_not(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "If the gate is open, and it usually is, close it.",
        "If the stew is burning, which it will do if you look away, take it off the hob.",
        "If the door is stuck, for the hinges are old, tell Lea.",
        "If the jug, which is on the bench, is dirty, wash it.",
        "If the blue jug that is on the bench is clean, bring it.",
    ],
)
def test_what_is_said_in_passing_is_no_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}]


def test_what_is_put_right_is_what_the_case_is_of(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Wash the pan. If the sink is full, empty it.")
    assert found.tasks[-1].value("object") == "the sink"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Take the stew out, and if it's frozen, defrost it, and then put it in the oven.",
            [1, {"if": 2, "then": [3]}, 4],
        ),
        ("Check the soup. If it's cold, heat it, then give it to Lea.", [{"if": [1, 2], "then": [3]}, 4]),
        (  # what a case has done is no state that was put right
            "If it's raining, take the rugs in, then fold them.",
            [{"if": 1, "then": [2, 3]}],
        ),
        (
            "If the bowl is dirty, wash it, then bring it, otherwise leave it on the shelf.",
            [{"if": 1, "then": [2, 3], "else": [4]}],
        ),
    ],
)
def test_what_comes_then_comes_whether_or_not_something_was_put_right(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Bring Lea the soup, but the rolls only if there are enough left.",
            [1, {"if": 3, "then": [2]}],
        ),
        (
            "Bring Lea the soup, but the rolls only if Max is up, and close the hatch.",
            [1, {"if": 3, "then": [2]}, 4],
        ),
    ],
)
def test_what_a_but_names_hangs_on_its_own_condition(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Put the bowls in the cabinet, but if one is chipped, throw it away.",
        "Wash the bowls in the basin. If one is cracked, put it in the crate.",
    ],
)
def test_one_of_several_is_what_is_so(interpreter: Interpreter, text: str) -> None:
    tasks = interpreter.interpret(text).tasks
    assert [task.value("object") for task in tasks] == ["the bowls", "one of the bowls", "one of the bowls"]
