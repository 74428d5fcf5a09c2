"""A pair of phrases without a verb has that of the pair before it, and a warning says so."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "said", "pair"),
    [
        (
            "Take the ladder to the shed and the hose to the garden.",
            ["the ladder", "to the shed", "the hose", "to the garden"],
            "the hose to the garden",
        ),
        (
            "Bring Grandpa his cane and Grandma her shawl.",
            ["Grandpa", "his cane", "Grandma", "her shawl"],
            "Grandma her shawl",
        ),
        ("Give Tom the ball, and Lily the kite.", ["Tom", "the ball", "Lily", "the kite"], "Lily the kite"),
        ("Turn the lamp on and the radio off.", ["the lamp", "on", "the radio", "off"], "the radio off"),
        ("Take the ladder and the hose to the garden.", ["the ladder and the hose", "to the garden"], None),
        ("Bring Grandpa and Grandma their tea.", ["Grandpa and Grandma", "their tea"], None),
        ("Put the plates on the table, one at a time.", ["the plates", "on the table"], None),
    ],
)
def test_a_second_pair_is_found_and_warned_of(text: str, said: list[str], pair: str | None, encoder: bool) -> None:
    instruction = Interpreter.load(encoder=encoder).interpret(text)
    assert [a.value for a in instruction.tasks[0].arguments if a.type != "manner"] == said
    assert len(instruction.tasks) == 1
    named = [warning.split("'")[1] for warning in instruction.warnings if "no verb" in warning]
    assert named == ([] if pair is None else [pair])
