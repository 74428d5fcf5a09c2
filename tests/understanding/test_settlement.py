"""What an order needs is asked ahead of it, and what is waited for is a condition, however the arcs tell it."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Once Kim's here, bring her the stool and dim the lamp.", [{"if": 1, "then": [2, 3]}]),
        ("As soon as the jam has set, put it in the larder. Then mop the hall.", [{"if": 1, "then": [2]}, 3]),
        ("Warm the broth and, once it's hot, pour it into the flask.", [1, {"if": 2, "then": [3]}]),
        ("Shut the hatch as soon as the goat is out.", [{"if": 2, "then": [1]}]),
        ("Shut the hatch once the goat is out, then feed the hens.", [{"if": 2, "then": [1, 3]}]),
        ("Shut the hatch once the goat is out and feed the hens.", [{"if": 2, "then": [1]}, 3]),
        # what the listener has done is no event, and nobody waits for "until" and "after" otherwise than in order
        ("Tell me when the broth is ready, then feel the radiator and bring me a spoon.", [1, 2, 3]),
        ("Ring once, and if Kim opens, give her the letter, and then come home.", [1, {"if": 2, "then": [3]}, 4]),
        ("Once you've washed the jug, dry it.", [1, 2]),
        ("Don't open the hatch until the goat is out.", [2, 1]),
        ("After the guests have gone, mop the hall.", [1, 2]),
    ],
)
def test_an_event_that_is_waited_for_is_a_condition(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Take the stew to Kim. If she isn't in, leave it on the step.", {"if": 2, "then": [1], "else": [3]}),
        ("Take the stew to Kim. If she's out, leave it on the step.", {"if": 2, "then": [3], "else": [1]}),
        ("Tell Kim the taxi is here, and if she's not at home, ring her.", {"if": 2, "then": [1], "else": [3]}),
        ("Fetch me a quince. If there are none left, fetch me a plum.", {"if": 2, "then": [1], "else": [3]}),
        ("Get the mop from the shed. If it's gone, get the broom.", {"if": 2, "then": [3], "else": [1]}),
        ("Give Kim her post. If she's gone out, put it on her desk.", {"if": 2, "then": [3], "else": [1]}),
        ("Take the letter to Kim. If she's in the garden, leave it here.", {"if": 2, "then": [3], "else": [1]}),
        ("Bring me a quince. None left? Bring me a plum.", {"if": 2, "then": [1], "else": [3]}),
    ],
)
def test_what_an_order_needs_is_asked_ahead_of_it(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == [expected]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Turn the lantern on. If it won't come on, bring me a candle.", [{"if": [1, 2], "else": [3]}]),
        ("Look for the mop in the shed. If it isn't there, get the broom.", [{"if": [1, 2], "else": [3]}]),
        ("Ask Kim if she's at home. If she isn't, lock the gate.", [{"if": [1, 2], "else": [3]}]),
    ],
)
def test_how_an_order_went_is_asked_of_it(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "thing", "place"),
    [
        ("Bring me the pens. If there are none, bring me the pencil.", "the pens", None),
        ("Pass Kim the salt. If there's none, pass her the pepper.", "the salt", None),
        ("Give the kids their sweets. If there are none left, give them crisps.", "their sweets", None),
        ("Give Kim the book. If she isn't there, put it on the shelf.", "Kim", "there"),
    ],
)
def test_what_is_asked_ahead_is_of_what_the_order_needs(
    interpreter: Interpreter, text: str, thing: str, place: str | None
) -> None:
    found = interpreter.interpret(text)
    assert (found.task(2).value("object"), found.task(2).value("location")) == (thing, place)
    assert not found.missing


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("Turn the wireless down.", "down"),
        ("Turn down the wireless a bit.", "down"),
        ("Crank the boiler up a notch.", "up a notch"),
        ("Turn the boiler down to fifty.", "down to fifty"),
        ("Pull the shutters up.", "up"),
        ("Turn the wireless so Kim wakes up.", None),
        ("Turn out your pockets.", None),
        ("Knock the wall down.", None),
        ("Roll the rug up.", None),
        ("Warm the broth up.", None),
    ],
)
def test_a_level_is_a_state(interpreter: Interpreter, text: str, state: str | None) -> None:
    assert interpreter.interpret(text).task(1).value("state") == state


@pytest.mark.parametrize(
    ("text", "recipient"),
    [
        ("Bring me the ladle. If it's dirty, bring the spoon.", "me"),
        ("Bring me the ladle, and if the whisk is clean, fetch that as well.", "me"),
        ("Bring us the jug, and if there's ice in the freezer, bring that too.", "us"),
        ("Fetch the ladle for me, and if the spoon is clean, bring that too.", "me"),
        ("Bring the ladle to us. If it's dirty, bring the spoon instead.", "us"),
        ("Bring the ladle to Kim. If it's dirty, bring the spoon instead.", "Kim"),
        ("Bring me the ladle. If it's raining, bring the chairs in.", None),
        ("Bring Kim the ladle. If it's dirty, bring the spoon to the cook.", "to the cook"),
        ("If the ladle is dirty, wash it and bring the spoon.", None),
        ("Bring me the ladle. If Kim is cold, bring a blanket.", None),
    ],
)
def test_what_is_brought_besides_is_for_the_speaker(interpreter: Interpreter, text: str, recipient: str | None) -> None:
    assert interpreter.interpret(text).tasks[-1].value("recipient") == recipient
