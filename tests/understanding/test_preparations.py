"""What makes ready for an order, and what is done with a thing wherever it was found, is of both cases."""

from __future__ import annotations

from typing import Any

import pytest

from decomplex_bt.flow import Do, If
from decomplex_bt.understanding.control_flow.arcs import Arc, Wording
from decomplex_bt.understanding.control_flow.construction import flow_of
from decomplex_bt.understanding.interpreter import Interpreter


def test_an_order_of_both_sides_stands_in_both_branches() -> None:
    arcs = [Arc("task", ">1+="), Arc("condition", "top"), Arc("mention", "<1"), Arc("task", "<1+", "before")]
    wordings = [Wording(), Wording(), Wording(is_negated=True), Wording()]
    assert flow_of(arcs, wordings).nodes == (If((2, 3), (Do((1,)),), (Do((4,)), Do((1,), is_repeat=True))),)


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Stack the crates up if they're dry, otherwise wipe them first.", [{"if": 2, "else": [3]}, 1]),
        ("Stack the crates up if they're dry. If not, wipe them first.", [{"if": 2, "else": [3]}, 1]),
        ("Serve the broth if it's hot. Otherwise, heat it up first.", [{"if": 2, "else": [3]}, 1]),
        ("Let the dog in if he's clean; if not, wipe his paws first.", [{"if": 2, "else": [3]}, 1]),
        ("Fold the flag unless it's damp, in which case iron it first.", [{"if": 2, "then": [3]}, 1]),
        (
            "If Lea is at the gate, open it, unless the goat's loose, in which case take him to the barn first.",
            [{"if": 1, "then": [{"if": 3, "then": [4]}, 2]}],
        ),
        (
            "Hand me the broth if it's warm; if it's gone cold, heat it first.",
            [{"if": [2, 3], "then": [1], "else": [4, {"same": [1]}]}],
        ),
        (
            "If the sledge is clean, put it away; if it isn't, wash it first. Then call Lea.",
            [{"if": [1, 3], "then": [2], "else": [4, {"same": [2]}]}, 5],
        ),
    ],
)
def test_what_is_done_first_in_the_other_case_makes_ready(interpreter: Interpreter, text: str, flow: Any) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == flow


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        (
            "If the sledge is clean, put it away; otherwise wash it first, then hang it up.",
            [{"if": 1, "then": [2], "else": [3, 4]}],
        ),
        ("Stack the crates up if they're dry. If not, wipe them.", [{"if": 2, "then": [1], "else": [3]}]),
        ("If the sledge is clean, put it away; otherwise ask Lea first.", [{"if": 1, "then": [2], "else": [3]}]),
        (
            "If the lamp won't light, bring me the first aid kit, otherwise put it out.",
            [{"if": 1, "else": [2], "then": [3]}],
        ),
    ],
)
def test_a_first_step_of_its_own_case_stays_there(interpreter: Interpreter, text: str, flow: Any) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == flow


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        (
            "Look for the saw in the barn; if it's not there, look in the cellar, and bring it to Lea.",
            [{"if": [1, 2], "else": [3]}, 4],
        ),
        (
            "Find Lea in the barn; if you can't find her there, look in the cellar, and tell her that it's late.",
            [{"if": [1, 2], "else": [3]}, 4],
        ),
        (
            "Look for the saw in the barn. If it isn't there, look in the cellar and tell me.",
            [{"if": [1, 2], "else": [3, 4]}],
        ),
        (
            "Look for the goat in the yard. If he's not there, search the barn and shut the gate.",
            [{"if": [1, 2], "else": [3, 4]}],
        ),
    ],
)
def test_what_was_found_in_either_place_is_used_anyway(interpreter: Interpreter, text: str, flow: Any) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == flow


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        (
            "See whether the hens are in, then sweep the barn. If they were in, shut the hatch.",
            [{"if": [1, 3], "then": [2, 4], "else": [{"same": [2]}]}],
        ),
        (
            "See whether the stove is lit, then put it out. If it isn't, tell Lea.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        ("Check the hatch too, bolt that as well if it isn't.", [{"if": [1, 3], "else": [2]}]),
    ],
)
def test_what_stands_between_a_check_and_its_answer(interpreter: Interpreter, text: str, flow: Any) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == flow
