"""Where something is put "in" or "on" that does not say what."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "goal"),
    [
        # not what was taken out, nor where it was, nor its like
        ("Take the tart out of the oven and put the loaf in.", "the oven"),
        ("Get the bulbs out of the drawer and put them in.", None),
        ("Take out the filter and put a new one in.", None),
        ("Pull the plug out of the sink and hang the shirts.", None),
        ("Put the juice in the fridge and set out four plates.", None),
        # kept, let in and left out is nowhere in particular
        ("Throw the tin away but keep the label.", None),
        ("Sweep the mat and let the cat back in.", None),
        ("Give Nina her bear and tuck her in.", None),
        ("Load the washer, but leave out the blue shirt.", None),
        # in what it is a part of, and not where that was
        ("Find the radio in the cupboard; if the batteries are flat, put new ones in.", "the radio"),
        ("Get the lantern out of the shed. If its bulb's gone, put a new one in.", "the lantern"),
        # what holds something
        ("Open the oven and put the loaf in.", "the oven"),
        ("Take the jar from the shelf and spoon some oats in.", "the jar"),
        ("Clear the mugs off the table and set out four plates.", "the table"),
    ],
)
def test_nothing_is_put_into_what_does_not_hold_it(text: str, goal: str | None, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("goal") == goal


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("Take the lid off, stir the stew and put it back on.", None),
        ("Take the album out of the drawer and put it back in.", "the drawer"),
    ],
)
def test_what_is_put_back_is_where_it_was(interpreter: Interpreter, text: str, goal: str | None) -> None:
    assert interpreter.interpret(text).tasks[-1].value("goal") == goal


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("Put the roses in the blue vase. If the water is dirty, put the tulips in instead.", "the blue vase"),
        ("Load the washer with the shirts. If they're clean, put the towels in instead.", "the washer"),
        ("Put the milk in the flask, unless it's sour; then put the juice in instead.", "the flask"),
        ("If the jam is open, put a jar in each of the two bags, otherwise put some honey in instead.", "each of the"),
        # where that is said
        ("Put the chicken in the oven. If it's frozen, put the fish in the pan instead.", "in the pan"),
        ("Put the lamp on the desk. If the bulb is broken, put the lantern there instead.", "the desk"),
    ],
)
def test_what_is_put_in_instead_goes_where_the_other_would(interpreter: Interpreter, text: str, goal: str) -> None:
    assert (interpreter.interpret(text).tasks[-1].value("goal") or "").startswith(goal)
