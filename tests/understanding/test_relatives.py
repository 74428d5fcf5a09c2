"""What only tells which thing is meant, and which is not, is no state to bring about and nobody's argument."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


def arguments(text: str, encoder: bool, number: int = -1) -> dict[str, str]:
    """The arguments of one of the tasks by their types."""
    task = Interpreter.load(encoder=encoder).interpret(text).tasks[number]
    assert len({argument.type for argument in task.arguments}) == len(task.arguments)
    return {argument.type: argument.value for argument in task.arguments}


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Turn off every lamp that is on.", {"object": "every lamp", "state": "off"}),
        ("Lock every door that's unlocked.", {"object": "every door"}),
        ("Shut the drawers which are still open.", {"object": "the drawers"}),
        ("Turn the lamp that is on off.", {"object": "the lamp", "state": "off"}),
        ("Switch off whichever fan is on.", {"object": "whichever fan is on", "state": "off"}),
        ("Whichever of the taps is open, close it.", {"object": "Whichever of the taps is open"}),
        ("Bring me the towel that is dry.", {"object": "the towel", "recipient": "me"}),
        ("Turn off the lamp that is on the desk.", {"object": "the lamp", "state": "off", "location": "on the desk"}),
        ("If any lamp that is on is hot, turn on the fan.", {"object": "the fan", "state": "on"}),
        ("Ask Leo who is in the pool.", {"recipient": "Leo", "message": "who is in the pool"}),
    ],
)
def test_a_clause_that_tells_which_is_meant_brings_about_no_state(
    text: str, found: dict[str, str], encoder: bool
) -> None:
    assert arguments(text, encoder) == found


def test_what_a_clause_before_states_is_not_to_be_brought_about() -> None:
    close, check = Interpreter.load().interpret("the window in the den's open i think close it if it is").tasks
    assert close.value("state") is None
    assert check.value("state") == "open"


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Turn off every light but the one in the hall.", "every light but the one in the hall"),
        ("Water the plants except for the cactus.", "the plants except for the cactus"),
        ("Wash all the cups apart from the red one.", "all the cups apart from the red one"),
        ("Bring me the bowls except the cracked one.", "the bowls except the cracked one"),
        ("Switch off every heater save the one in the attic.", "every heater save the one in the attic"),
    ],
)
def test_what_is_left_out_is_part_of_the_phrase_that_it_stands_behind(text: str, said: str, encoder: bool) -> None:
    found = arguments(text, encoder)
    assert found["object"] == said
    assert "location" not in found
    assert not Interpreter.load(encoder=encoder).interpret(text).missing


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("Turn the radiators off everywhere but in the den.", "everywhere but in the den"),
        ("Close the curtains in every room except the den.", "in every room except the den"),
        ("Carry all the chairs to the shed except the rocking chair.", None),
        ("Look everywhere, but move nothing.", "everywhere"),
    ],
)
def test_of_places_what_is_left_out_is_part_of_all_of_a_kind(text: str, place: str | None) -> None:
    assert arguments(text, True).get("location") == place


@pytest.mark.parametrize(
    ("text", "left_out"),
    [
        ("Empty the dishwasher, except for the roasting tin.", "except for the roasting tin"),
        ("Bring me a chair, but not the broken one.", "but not the broken one"),
        ("Take the boxes to the cellar, all but the small one.", "all but the small one"),
        ("Bring me the cup, but wash it first.", None),
        ("Turn off the light, but not before locking the door.", None),
        ("Turn off everything but leave the fan on.", None),
    ],
)
def test_what_is_left_out_elsewhere_is_warned_of(text: str, left_out: str | None) -> None:
    warnings = [w for w in Interpreter.load().interpret(text).warnings if "leaves something out" in w]
    assert [warning.split("'")[1] for warning in warnings] == ([] if left_out is None else [left_out])


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (
            "Put the pan, which is on the floor, in the sink.",
            {"object": "the pan", "location": "on the floor", "goal": "in the sink"},
        ),
        (
            "Put the magazine, which is on the bed, on the desk, which is in the study.",
            {"object": "the magazine", "location": "on the bed", "goal": "on the desk, which is in the study"},
        ),
        (
            "Put the lid in the box that's on the shelf.",
            {"object": "the lid", "goal": "in the box that's on the shelf"},
        ),
        (
            "Put whatever's on the bed in the wardrobe.",
            {"object": "whatever's", "location": "on the bed", "goal": "in the wardrobe"},
        ),
        (
            "Put everything on the sofa in the basket.",
            {"object": "everything", "location": "on the sofa", "goal": "in the basket"},
        ),
        ("Put everything on the sofa in the living room.", None),
        ("Put the cups on the shelf in the cupboard.", None),
        ("Put the vase on the table next to the lamp.", None),
        ("Put it on the chair in the hall.", None),
    ],
)
def test_a_place_that_tells_which_thing_is_moved_is_not_where_to(text: str, found: dict[str, str] | None) -> None:
    if found is None:
        assert arguments(text, encoder=True).keys().isdisjoint(("location", "source"))
    else:
        assert arguments(text, encoder=True) == found


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("Whatever's in the washing machine, hang it on the line.", "Whatever's"),
        ("What is on the stairs, carry it upstairs.", "What is"),
        ("There's a cup on the stairs, carry it upstairs.", "a cup"),
    ],
)
def test_whatever_is_at_a_place_is_what_an_order_behind_takes_up(text: str, thing: str, encoder: bool) -> None:
    assert arguments(text, encoder)["object"] == thing
