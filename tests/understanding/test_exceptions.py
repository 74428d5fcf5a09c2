"""What a "but", an "unless" or a prohibition says of an order that has a case of its own, and what it leaves alone."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Let the cat out if she's at the gate, but if it's raining keep her in.",
            [{"if": 3, "then": [4], "else": [{"if": 2, "then": [1]}]}],
        ),
        (
            "Take the rugs out if they're dry, but if it rains, don't.",
            [{"if": 3, "else": [{"if": 2, "then": [1]}]}],
        ),
        (
            "Feed the cat if she's hungry, but if she's asleep let her be.",
            [{"if": 3, "else": [{"if": 2, "then": [1]}]}],
        ),
        ("Let the dog in, but if he's muddy let him wait.", [{"if": 2, "else": [1]}]),
    ],
)
def test_an_exception_is_asked_ahead_of_the_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If Lea is home, give her the letter, but if Kim is home, give it to him.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        (
            "If it's my aunt, let her in, but if it's my landlord, call me.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        (
            "If the dog barks, let him out, but if the cat miaows, feed her.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
    ],
)
def test_another_case_behind_a_but_is_none_within_the_first(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_a_but_of_the_same_one_is_asked_within_the_first(interpreter: Interpreter) -> None:
    text = "If Lea is in, give her the jar, but if she's asleep, call me."
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 3, "then": [4], "else": [2]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Walk the dog. Unless it's raining, then just let him out.", [{"if": 2, "then": [3], "else": [1]}]),
        (
            "Turn off the radio unless Kim's listening to it and then bring me the rope.",
            [{"if": 2, "else": [1]}, 3],
        ),
        ("Open the blinds unless she says no, and then bring her a scone.", [{"if": 2, "else": [1]}, 3]),
        ("Turn off the radio unless Kim asks you not to.", [{"if": 2, "else": [1]}]),
        ("Shut the hatch unless I tell you not to.", [{"if": 2, "else": [1]}]),
        (
            "Open the gate unless it's the salesman. If it's the courier, take the parcel.",
            [{"if": 2, "else": [1]}, {"if": 3, "then": [4]}],
        ),
    ],
)
def test_what_is_excepted_by_an_unless(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Throw the rolls away if they are old, but keep the pie.", [{"if": 2, "then": [1]}, 3]),
        ("Bring me the paper if it's come, and open the blinds.", [{"if": 2, "then": [1]}, 3]),
        ("If the twins are asleep, don't vacuum; sweep the attic instead.", [{"if": 1, "then": [3], "else": [2]}]),
        ("If the twins are asleep, don't vacuum but sweep the attic.", [{"if": 1, "then": [3], "else": [2]}]),
    ],
)
def test_what_is_done_besides_or_instead(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Mow the lawn. Don't if the grass is wet.", [{"if": 2, "else": [1]}]),
        ("Open the curtains. But don't if Mum's asleep.", [{"if": 2, "else": [1]}]),
        ("Iron the blouse. Not if it's silk, though.", [{"if": 2, "else": [1]}]),
        ("Turn on the heater. Don't if it isn't cold.", [{"if": 2, "then": [1]}]),
        ("Water the roses and sweep the patio. Not if it's raining.", [{"if": 3, "else": [1, 2]}]),
        ("Mow the lawn. Don't if it's wet. Then call Tom.", [{"if": 2, "else": [1]}, 3]),
        ("Mow the lawn. Don't if it's wet, sweep the hall instead.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Sweep the patio, but don't if it's wet, sweep the hall instead.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Close the window. Unless it's hot, turn on the heater.", [1, {"if": 2, "else": [3]}]),
        ("Run the dishwasher. Only if it's full.", [{"if": 2, "then": [1]}]),
    ],
)
def test_an_exception_in_a_sentence_of_its_own(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If the broth is hot, don't serve it. Cool it first.", [{"if": 1, "then": [3]}, 2]),
        ("If the rug is wet, don't roll it up; dry it first.", [{"if": 1, "then": [3]}, 2]),
        ("If the stove isn't clean, don't turn it on. Clean it first.", [{"if": 1, "else": [3]}, 2]),
        ("Don't fold the blanket if it's wet. Dry it first.", [{"if": 2, "then": [3]}, 1]),
        ("Don't fold the blanket if it's wet; dry it.", [{"if": 2, "then": [3], "else": [1]}]),
        ("If it's raining, don't water the ferns. Open the hatch.", [{"if": 1, "else": [2]}, 3]),
    ],
)
def test_what_sets_right_is_done_in_the_case_that_keeps(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Rinse the pail, but if there's glue in it, don't; take it to the shed instead.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
        (
            "Water the fern, but if the soil is wet, don't; open the hatch instead.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
        ("Mow the lawn, but if it's wet, don't. Sweep the hall instead.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Mow the lawn, but if it's wet, don't. Then sweep the hall.", [{"if": 2, "else": [1]}, 3]),
    ],
)
def test_what_is_done_instead_behind_a_bare_prohibition(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Wake Leo, unless he's up, and hand him the letter.",
        "Wake Grandma, unless she's awake, and take her the phone.",
        "Wake my brother, unless he's up already, and give him his tea.",
    ],
)
def test_who_is_up_is_not_woken_and_gets_what_is_brought(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "else": [1]}, 3]


def test_who_is_ill_is_neither_woken_nor_brought_anything(interpreter: Interpreter) -> None:
    text = "Wake Leo, unless he's ill, and bring him the letter."
    assert flow(interpreter, text) == [{"if": 2, "else": [1, 3]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Carry the jug to Ann; if she's busy, bring it back.", [1, {"if": 2, "then": [3]}]),
        ("Take the parcel to the library. If it's closed, come home.", [1, {"if": 2, "then": [3]}]),
        ("Give Leo his tablet; if he drops it, give him another.", [1, {"if": 2, "then": [3]}]),
        ("Give Leo a biscuit. If he drops it, give him another one.", [1, {"if": 2, "then": [3]}]),
        ("Bring me the red mug. If it's chipped, bring me another.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Carry the jug to Ann. If she's asleep, leave it on her desk.", [{"if": 2, "then": [3], "else": [1]}]),
    ],
)
def test_what_comes_back_was_taken_there(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Bring me the shawl. If it's torn, get me a blanket, please.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Bring me the jug. If it's cracked, bring me a bottle, please.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Fetch me the cape. If it's dirty, get me a jacket.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Bring me the soup. If it's cold, bring me a salad, please.", [1, {"if": 2, "then": [3]}]),
        ("Bring me my tablets; if the jar is empty, bring me the phone too.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_another_thing_is_brought_in_place_of_what_is_of_no_use(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Wash the mugs, and if it's late, the pans can wait.", [1, 2]),
        ("Put away the shopping, and if there's no room in the larder, the jars can stay on the table.", [1, 2]),
        ("Sweep the stairs. If the hall is wet, the rug can stay on the line.", [1, 2]),
        ("Wash the car, but if it's raining, it can wait.", [{"if": 2, "else": [1]}]),
        ("Wash the mugs, but if it's late, the mugs can wait.", [{"if": 2, "else": [1]}]),
    ],
)
def test_another_thing_that_can_wait_keeps_from_nothing(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Set the table, but if Leo isn't coming, take one chair away.", [1, {"if": 2, "else": [3]}]),
        (
            "Warm the stew. Oh, but if it's gone mouldy, get the broth out instead.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
        ("Set the table for six, but if Leo's not coming, take one chair away.", [1, {"if": 2, "else": [3]}]),
        ("Make the bed, but if it's hot, take the quilt off.", [1, {"if": 2, "then": [3]}]),
        ("Lay the table, but if Ann is late, take her plate away.", [1, {"if": 2, "then": [3]}]),
        ("Make the bed, but if Leo is away, take his pillow away.", [1, {"if": 2, "then": [3]}]),
        ("Set the table, but if it's laid already, take it away.", [{"if": 2, "then": [3], "else": [1]}]),
    ],
)
def test_what_is_taken_away_from_what_was_made_ready(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected
