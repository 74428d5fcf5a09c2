"""An order of another matter behind an order and its case."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Switch off the lamp if nobody is in the study, and bolt the gate.", [{"if": 2, "else": [1]}, 3]),
        ("Turn off the radio if Mum isn't listening to it, and sweep the hall.", [{"if": 2, "else": [1]}, 3]),
        ("Close the roof hatch if it's raining, and feed the rabbit.", [{"if": 2, "then": [1]}, 3]),
        ("Put the jacket in the wardrobe, if it's dry, and sweep the stairs.", [{"if": 2, "then": [1]}, 3]),
        ("Bring in the cushions if it's raining, and take the washing in.", [{"if": 2, "then": [1, 3]}]),
        ("Put the jacket in the wardrobe, if it's dry, and close it.", [{"if": 2, "then": [1, 3]}]),
        ("Turn off the radio if Mum is asleep, and put a blanket over her.", [{"if": 2, "then": [1, 3]}]),
    ],
)
def test_a_chore_behind_a_case_is_done_in_any(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Is the tap running? Turn it off if it is, and dust the piano.", [{"if": [1, 3], "then": [2]}, 4]),
        ("See if the hatch is open. Shut it if it is, and water the fern.", [{"if": [1, 3], "then": [2]}, 4]),
        ("Is there any soup? Heat it if there is, and bring me the paper.", [{"if": [1, 3], "then": [2]}, 4]),
        ("Is Mia awake? Bring her the tea if she is, and open her curtains.", [{"if": [1, 3], "then": [2, 4]}]),
        ("Is Mia awake? Bring her the tea if she is, and open the curtains.", [{"if": [1, 3], "then": [2, 4]}]),
        (
            "Is the tap running? Turn it off if it is, and if not, dust the piano.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        (
            "Is the tap running? Turn it off if it is, otherwise dust the piano.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
    ],
)
def test_what_is_added_to_an_answer_is_never_its_other_side(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Shut the hatch if it's open, will you? Water the fern.", [{"if": 2, "then": [1]}, 3]),
        ("Could you shut the hatch if it's open? Water the fern.", [{"if": 2, "then": [1]}, 3]),
        ("Turn the radio off unless it's off, okay? Bring me the paper.", [{"if": 2, "else": [1]}, 3]),
        ("Could you shut the hatch if it's open? If not, water the fern.", [{"if": 2, "then": [1], "else": [3]}]),
    ],
)
def test_a_request_put_as_a_question_ends_with_it(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the radio is on, switch it off, and shut the hatch if it's open.",
            [{"if": 1, "then": [2]}, {"if": 4, "then": [3]}],
        ),
        (
            "If the gate is open, close it and wash the mug if it's dirty.",
            [{"if": 1, "then": [2]}, {"if": 4, "then": [3]}],
        ),
        (
            "If the lamp is off, turn it on, and water the fern if it's dry.",
            [{"if": 1, "then": [2]}, {"if": 4, "then": [3]}],
        ),
        (
            "If it's raining, bring in the rugs, and close the hatch if it's open.",
            [{"if": 1, "then": [2, {"if": 4, "then": [3]}]}],
        ),
        (
            "If the jug is full, empty it, and wash it if it's dirty.",
            [{"if": 1, "then": [2, {"if": 4, "then": [3]}]}],
        ),
    ],
)
def test_two_orders_each_undo_their_own_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Keep the radio on but put out the candle if nobody's in the den.", [1, {"if": 3, "else": [2]}]),
        ("Draw the blinds but bolt the gate if no one's at home.", [1, {"if": 3, "else": [2]}]),
        ("Switch off the fan if nobody is in, but leave the lamp on.", [{"if": 2, "else": [1]}, 3]),
        ("Bring me a fork but take a spoon if there's no fork.", [{"if": 3, "then": [1], "else": [2]}]),
        ("Open the hatch but shut it if it rains.", [1, {"if": 3, "then": [2]}]),
    ],
)
def test_a_but_sets_two_things_apart(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Stay with Grandad and ring me if he falls.", [1, {"if": 3, "then": [2]}]),
        ("Keep an eye on the rolls and take them out when they're brown.", [1, {"if": 3, "then": [2]}]),
        ("Put out the light and sing to Mia if she cries.", [1, {"if": 3, "then": [2]}]),
        ("Open the window and tell Mia a story if she's cold.", [{"if": 3, "then": [1, 2]}]),
        ("Go with Uncle Leo and text me if he goes out.", [{"if": 3, "then": [1, 2]}]),
    ],
)
def test_who_is_watched_over_is_so_until_something_happens(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If there's a postcard put it on my desk, everything else can go in the basket.", [{"if": 1, "then": [2]}, 3]),
        ("If there are any clean mugs bring me one, the rest can go in the rack.", [{"if": 1, "then": [2]}, 3]),
        ("If any plate is chipped, show it to me, and put the rest in the rack.", [{"if": 1, "then": [2]}, 3]),
        ("If the jug is dirty, rinse it; the cloth can go in the basket.", [{"if": 1, "then": [2]}, 3]),
        ("If there's a cake, bring me a slice and put the rest in the fridge.", [{"if": 1, "then": [2, 3]}]),
        ("If the loaf is stale, bring it to me and put the rest in the bin.", [{"if": 1, "then": [2, 3]}]),
    ],
)
def test_the_rest_is_seen_to_in_any_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected
