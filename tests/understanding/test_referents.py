"""What a word cannot mean: what lacks the state, what is not there in this case, what is on a thing and no thing."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


def values(found: Interpreter, text: str, word: str, kind: str = "object") -> list[str | None]:
    """The values of the arguments of a type whose words are, or end in, a word."""
    tasks = found.interpret(text).tasks
    return [
        a.value
        for task in tasks
        for a in task.arguments
        if a.type == kind and a.span and a.span.of(text).lower().split()[-1] == word
    ]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Put the spade in the barn unless it's locked.", "the barn"),
        ("Take the ball to the gym, and if it's locked, leave it by the fence.", "the gym"),
        ("Put the biscuits in the tin, but if it's full, bring them here.", "the tin"),
        ("Hang the coats in the wardrobe. If it's full, lay them on the bed.", "the wardrobe"),
        ("Put the pie in the oven if it's hot enough.", "the oven"),
        # what has the state itself
        ("Put the suitcase in the hall if it's locked.", "the suitcase"),
        ("Put the bottle in the box if it's full.", "the bottle"),
        ("Put the soup on the table if it's hot enough.", "the soup"),
    ],
)
def test_a_state_is_of_what_can_have_it(interpreter: Interpreter, text: str, value: str) -> None:
    assert values(interpreter, text, "it")[0] == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Pour the milk into a jug if there's a clean one.", "a clean jug"),
        ("Put the photos in an envelope if there is a big one, otherwise leave them on the desk.", "a big envelope"),
        ("If there's a hole in the blue blanket, bring me the grey one.", "the grey blanket"),
        ("If there's a stain on the tablecloth, take it to the laundry and fetch a clean one.", "a clean tablecloth"),
        # no place that serves
        ("Put the lamp on the desk if there isn't already one there.", "a lamp"),
        ("Bring a plate to the kitchen if there's a dirty one.", "a dirty plate"),
    ],
)
def test_one_is_of_the_kind_that_serves(interpreter: Interpreter, text: str, value: str) -> None:
    found = values(interpreter, text, "one")
    assert found[0] in (value, value.replace("a ", "the ", 1))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Close the fridge, and if there's milk on the floor, mop it up.", ("milk", "the floor")),
        ("Turn off the washer. If there's foam on the tiles, wipe it up.", ("foam", "the tiles")),
        ("Look in the letterbox. If there's a letter, bring it to me; if not, close it.", ("the letterbox",)),
        ("Take the jug out of the fridge, and if it's cold pour Ann a glass, or else put it back.", ("the jug",)),
        ("Lift the chair off the rug, shake the rug out and then put it back.", ("the rug",)),
        ("Sweep the steps, and if you can't reach the top one, fetch a ladder and then sweep it.", ("the top step",)),
        # what is there after all
        ("Take the tray upstairs, and if there's room on the desk, put it there.", ("the tray",)),
        ("If there's no towel in the bathroom, put it on the shopping list.", ("towel", "a towel")),
        ("Only if Mum is awake take her up a coffee, otherwise leave it on the landing.", ("a coffee",)),
    ],
)
def test_what_is_handled_is_there_in_the_case(interpreter: Interpreter, text: str, value: tuple[str, ...]) -> None:
    assert values(interpreter, text, "it")[-1] in value


@pytest.mark.parametrize(
    ("text", "word", "kind", "value"),
    [
        ("If the visitors are early, take their hats and show them to the lounge.", "them", "object", "the visitors"),
        ("Find my phone. It should be on the couch, but if it's not, look under it.", "it", "location", "the couch"),
    ],
)
def test_no_thing_is_shown_in_nor_is_where_it_is_looked_for(
    interpreter: Interpreter, text: str, word: str, kind: str, value: str
) -> None:
    assert values(interpreter, text, word, kind)[-1:] == [value]


def test_nothing_is_within_itself(interpreter: Interpreter) -> None:
    found = values(interpreter, "Mop the bathroom floor and empty the bin in there.", "there", "location")
    assert found != ["the bin"]


def test_it_is_not_raining_is_of_nothing_named(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If it's raining, close the skylight, and if it isn't, water the beans.")
    checks = [task for task in found.tasks if task.type == "check_state"]
    assert [(task.value("state"), task.value("object")) for task in checks] == [("raining", "it")] * 2


def test_who_is_fed_is_what_that_is_done_to(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Feed the cat if its bowl is empty.")
    assert [task.value("object") for task in found.tasks] == ["the cat", "its bowl"]


def test_who_is_at_the_door_is_not_the_door(interpreter: Interpreter) -> None:
    found = values(interpreter, "Get the door, and if it's the plumber, show him the boiler.", "it")
    assert "the door" not in found


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If it's clean it goes in the cupboard, otherwise it goes in the sink.", "it"),
        ("If it's dirty, put it in the steriliser.", "it"),
        ("Bring it to me before my call with Lea.", "it"),
    ],
)
def test_nothing_is_put_into_itself_nor_is_a_time_brought(interpreter: Interpreter, text: str, value: str) -> None:
    orders = [task for task in interpreter.interpret(text).tasks if task.type != "check_state"]
    assert {task.value("object") for task in orders} == {value}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("There are two jugs. Hand me the one with the lid.", "the jug with the lid"),
        ("There are three crates in the shed. Empty the one without a handle.", "the crate without a handle"),
        ("If my cane isn't here, bring the one with the silver knob.", "the cane with the silver knob"),
    ],
)
def test_what_tells_which_one_stays_with_the_noun(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If the frog is in the pond close the hatch, and if it's gone open it.", "the hatch"),
        ("If the tin is empty, shut the drawer; if it isn't, open it.", "the drawer"),
        ("Turn the fan off if the kettle is boiling. If it isn't, turn it on.", "the fan"),
        # what has the state that the verb ends, and what the same is done to
        ("If the door is open close the window; if it's shut, open it.", "the door"),
        ("If the kettle's empty, fill the jug; if it's full, empty it.", "the kettle"),
        ("If the parcel is for Ann open it, otherwise close the door.", "the parcel"),
    ],
)
def test_the_contrary_is_done_to_the_same_thing(interpreter: Interpreter, text: str, value: str) -> None:
    assert values(interpreter, text, "it")[-1] == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("The coat is on the bed. If it's wet, hang it in the bathroom; if not, leave it there.", "the bed"),
        ("If the parcel in the hall is for Ann, take it to the office, otherwise leave it there.", "the hall"),
        ("Look at the cake in the oven. If it's done, put it on the rack, and if not, leave it there.", "the oven"),
        ("If the mug is dirty, put it in the sink; if it isn't, leave it there.", "there"),
        # where it is put in the same case
        ("If the cup is clean put it on the shelf, if not put it in the sink and leave it there.", "the sink"),
        ("Move three chairs from the hall to the kitchen and leave them there.", "the kitchen"),
    ],
)
def test_what_is_left_there_is_not_left_where_it_is_put_in_the_other_case(
    interpreter: Interpreter, text: str, value: str
) -> None:
    assert values(interpreter, text, "there", "goal") == [value]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Whose is this jacket? If there's a name in it, hang it on the hook.", "this jacket"),
        ("Take the parcel from the hall. If our address is on it, bring it in.", "the parcel"),
        ("Is there a name on the cup? If so, put it on the top shelf.", "the cup"),
        ("Check the jar. If there's no date on the lid, put it in the bin.", "the jar"),
        # what is done to what is written itself
        ("If there's a price on the vase, peel it off.", "a price"),
        ("If the name on the tag is wrong, change it.", "the name"),
        ("If Ann's name isn't on the list, put it there.", "Ann's name"),
    ],
)
def test_what_is_written_on_a_thing_is_not_what_is_moved(interpreter: Interpreter, text: str, value: str) -> None:
    assert values(interpreter, text, "it")[-1] == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Get a cloth and wipe the two chairs, then put one in the hall and take the other to Ann.", "one chair"),
        ("Get a ladder and take the two lamps down, then put one in the box and bring me the other.", "one lamp"),
        ("Fetch a towel, dry the plates, put one on the table and hang the other on the wall.", "one plate"),
        # where no other one is spoken of
        ("Get a towel and wipe the two chairs. If there's a dirty one, tell Ann.", "a dirty chair"),
        ("The towels are wet. Get a dry one and wipe the two chairs.", "a dry towel"),
    ],
)
def test_one_and_the_other_are_of_several(interpreter: Interpreter, text: str, value: str) -> None:
    assert values(interpreter, text, "one")[0] == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If there's a draught from the window, put the cushion against it.", "the window"),
        ("If there's a smell from the drain, pour some soda in it.", "the drain"),
        ("If there's a noise in the boiler, put a blanket over it.", "the boiler"),
        # what is there to put something on
        ("If there's a rug in the hall, put the shoes on it.", "a rug"),
    ],
)
def test_nothing_is_put_on_what_is_only_felt(interpreter: Interpreter, text: str, value: str) -> None:
    assert values(interpreter, text, "it", "goal") == [value]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("What's that smell? Go and look in the lunch boxes.", None),
        ("I can hear a noise in the loft. Look behind the wardrobe.", None),
        ("My keys are gone. Look in the hall.", "My keys"),
    ],
)
def test_nobody_looks_in_a_place_for_what_is_only_felt(interpreter: Interpreter, text: str, value: str | None) -> None:
    assert interpreter.interpret(text).task(1).value("object") == value


@pytest.mark.parametrize(
    ("text", "word", "kind", "value"),
    [
        # one person of any gender
        ("Go to the back door. If it's a neighbour, let them in.", "them", "object", "a neighbour"),
        ("If there's a box, put it on the bench. If it's a visitor, show them up.", "them", "object", "a visitor"),
        # what is made or brought, of which there may be none
        ("Switch the kettle on and make a pot of coffee, unless there isn't any.", "any", "object", "coffee"),
        ("Find two bowls and put a spoon in each.", "each", "goal", "two bowls"),
        ("The jug on the sill is cracked, so take it to the shed.", "it", "object", "The jug"),
        ("The jug is cracked, so put the milk in another one.", "one", "goal", "another jug"),
    ],
)
def test_what_goes_on_about_a_thing_in_other_words(
    interpreter: Interpreter, text: str, word: str, kind: str, value: str
) -> None:
    assert values(interpreter, text, word, kind)[-1:] == [value]


def test_what_a_verb_says_it_is_done_with_is_not_what_it_is_done_to(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Take the hoover up to the landing and hoover there.")
    assert found.tasks[-1].value("object") != "the hoover"
