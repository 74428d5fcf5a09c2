"""What is heated, chilled or washed where it was put, and what is brought wrapped."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Put the lasagne in the microwave for Ravi and heat it for a minute.", 2, "the lasagne"),
        ("Put the cider in the fridge for Nadia and chill it.", 2, "the cider"),
        ("Stick the duvet in the tumble dryer for Lou and dry it.", 2, "the duvet"),
        ("Place the porridge on the stove for Uli, warm it and carry it to him.", 3, "the porridge"),
        ("Put the bottles in the cooler and chill them for the party.", 2, "the bottles"),
        ("Wrap the bottle in the fleece, and bring me that.", 2, "the bottle"),
        ("Roll the vase in the newspaper and put it in the box.", 2, "the vase"),
        # what is itself heated, set or emptied
        ("Put the tart in the oven and heat it to 180 degrees.", 2, "the oven"),
        ("Put some logs in the stove and heat it.", 2, "the stove"),
        ("Put the pot on the stove and turn it on.", 2, "the stove"),
        ("Put the plates in the dishwasher and close it.", 2, "the dishwasher"),
        ("Put the lid on the pot, but before that rinse it out.", 2, "the pot"),
    ],
)
def test_what_is_put_in_a_device_is_what_that_does(text: str, number: int, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).task(number).value("object") == value
