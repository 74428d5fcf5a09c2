"""Which ones, and how many more of them, are meant."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        # one of the kind, and not the very thing
        ("This knife is blunt. Bring me one that cuts.", "a knife"),
        ("Take that glass away and get me one which isn't chipped.", "a glass"),
        ("The torch is dead. Fetch one that works.", "a torch"),
        # one of several
        ("Look for the brownies and bring me one.", "a brownie"),
        ("Get the mugs and fill one.", "a mug"),
        ("If there are any pears in the basket, bring me one.", "a pear"),
        ("Change the filter in the pump and bin the old one.", "the old filter"),
        # of what is brought in any case, not only where there is none of the first
        ("Bring me a cocoa, or a milk if there's no cocoa left, and take one up to Ann.", "a cocoa"),
        # what is left of some
        ("Give Rex some of the mince and bring me the rest of it.", "the rest of the mince"),
        # so many more
        ("Take the blue shelf to Ben and put the other two in the loft.", "two shelves"),
        ("When both jars are empty, bring me two more.", "two jars"),
        # as before
        ("If you find a pen, bring me one.", "a pen"),
        ("Get a pear if there is one.", "a pear"),
        ("The red mug is dirty. Bring me a clean one.", "a clean mug"),
        ("Bring me three of the apples.", "three of the apples"),
        # any of a kind, where a known thing is named beside it
        ("Hang the scarf on a peg if you can find one.", "a peg"),
        ("Serve the tart on a board if there is one.", "a board"),
        ("Pour the broth into a jug if you find a clean one.", "a clean jug"),
        ("Put the plums in a bowl, and if you find a rotten one, throw it away.", "a rotten plum"),
    ],
)
def test_one_is_of_a_kind(text: str, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("Put the green cube on top of the yellow one.", "the yellow cube"),
        ("Stand the tall vase in front of the short one.", "the short vase"),
        ("Hang my brown scarf to the left of the white one.", "the white scarf"),
        ("If the white jar is open, set the brown jar next to the black one.", "the black jar"),
        ("If the red shelf is full, put the tin on top of the other one.", "the other shelf"),
        ("Stack the green cube on the yellow one.", "the yellow cube"),
        # as before
        ("If the old bench is wet, put the rug under the new one.", "the new bench"),
        ("The old desk is full. Put the new lamp on the small one.", "the small desk"),
        ("Put the note in the pocket of the yellow one.", "in the pocket of the yellow one"),
        ("Put the keys next to the blue one.", "next to the blue one"),
        ("If the red mug is clean, put the spoon in the green one.", "the green mug"),
    ],
)
def test_a_thing_is_put_by_another_of_its_kind(interpreter: Interpreter, text: str, goal: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("goal") == goal


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Look for the nail brush. If you can't find it, hand me the blue one.", "the blue nail brush"),
        ("If the pastry brush is dirty, wash it and bring me the other one.", "the other pastry brush"),
        ("If the vacuum bag is full, pull it out and put a new one in.", "a new vacuum bag"),
        ("If the waffle iron is broken, fetch me the old one.", "the old waffle iron"),
        ("The green sippy bottle stays here. Pack the yellow one.", "the yellow sippy bottle"),
        # as before
        ("If the blue coat is wet, bring me the red one.", "the red coat"),
        ("Get the blue bucket. If there's no room in it, bring the red one.", "the red bucket"),
        ("If the kitchen lamp is on, switch off the bedroom one.", "the bedroom lamp"),
        ("If the clean plates are gone, wash the dirty ones.", "the dirty plates"),
    ],
)
def test_another_is_called_what_the_first_one_is(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Any oat cakes left on the shelf? Bring me three if there are.", "three oat cakes"),
        ("Are there any lemons? If there are, bring me four.", "four lemons"),
        ("If there are any clean napkins in the chest, bring me six.", "six clean napkins"),
        ("Are there any plain rolls? If so, take five to Mum.", "five plain rolls"),
        ("If there are fresh rolls in the tin, bring me two of those.", "two fresh rolls"),
        # as before
        ("Are there any lemons? If there are, bring me some.", "lemons"),
        ("If you find a spare fuse, bring me one.", "a spare fuse"),
    ],
)
def test_a_number_alone_is_that_many(interpreter: Interpreter, text: str, value: str) -> None:
    bringing = [task for task in interpreter.interpret(text).tasks if task.type == "bringing"]
    assert bringing[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Get a cloth and dry the two mugs by the tap, then give one to Ida and bring me the other.", "one mug"),
        ("Fetch a tray, rinse both bowls, carry one to Ida and put the other on it.", "one bowl"),
        ("Take a tin and the two spoons. Carry one to Ida and the other to Max.", "one spoon"),
        # as before
        ("Get the two mugs and bring me one.", "a mug"),
        ("Look on the shelves for a candle. If you find a candle, bring me one.", "a candle"),
    ],
)
def test_one_and_the_other_are_of_the_pair_named(interpreter: Interpreter, text: str, value: str) -> None:
    carried = [task for task in interpreter.interpret(text).tasks if task.type == "bringing"]
    assert value in [task.value("object") for task in carried]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Collect the pens. If one of them is dry, tell me.", "one of the pens"),
        ("Follow the kids, and should one of them slip, call me.", "one of the kids"),
        ("Rinse the jars, and if one of them is cracked, tell me.", "one of the jars"),
        ("If the big bowls are dirty, see if one of the small ones is clean.", "one of the small bowls"),
        ("Have a look at the tyres, and if one is low, tell me.", "one of the tyres"),
        ("Wash my shirts. If one has a stain, tell me.", "one of my shirts"),
        # there is one, or it is of no known several
        ("Bring me a pen. If one is broken, tell me.", "a pen"),
        ("Rinse the jars, and if any of them is cracked, tell me.", "any of the jars"),
        ("Rinse the jars, and if either of them is cracked, tell me.", "either of the jars"),
    ],
)
def test_one_of_them_is_one_of_those_named(interpreter: Interpreter, text: str, value: str) -> None:
    checks = [task for task in interpreter.interpret(text).tasks if task.type == "check_state"]
    assert checks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Check the plates, and if the apple one's dirty, give it a wash.", "the apple plate"),
        ("Look at the mugs, and if the owl one's dirty, give it a rinse.", "the owl mug"),
        ("Get the socks, and if the left one's wet, dry it.", "the left sock"),
    ],
)
def test_it_is_the_one_spoken_of_by_its_noun(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If there's any of that paste left, bring it here.", "that paste"),
        ("Check if there's any of the dough left. If there is, bake it.", "the dough"),
        ("Is there any of Mum's stew left? If there is, heat it up.", "Mum's stew"),
        # as before
        ("Is there any rice left? If there is, heat it up.", "any rice"),
        ("Get half a loaf and toast it.", "half a loaf"),
    ],
)
def test_it_is_what_there_may_be_some_of(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("Take the tray to room one and carry the cases up.", "to room one"),
        ("Put the red box in bay one and close the hatch.", "in bay one"),
    ],
)
def test_a_number_behind_a_noun_stands_for_nothing(interpreter: Interpreter, text: str, goal: str) -> None:
    assert interpreter.interpret(text).tasks[0].value("goal") == goal


def test_one_behind_a_noun_with_its_article_stands_for_a_thing(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring me the big mug. If it's dirty, bring me the kitchen one.")

    assert found.tasks[2].value("object") == "the kitchen mug"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If one of the windows is open, close it.", "one of the windows"),
        ("Look at the lamps. If one is on, turn it off.", "one of the lamps"),
        ("If one of my shirts is dirty, wash it.", "one of my shirts"),
        # as before
        ("If the windows are open, close them.", "the windows"),
    ],
)
def test_what_is_done_to_one_of_several_is_done_to_that_one(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value
