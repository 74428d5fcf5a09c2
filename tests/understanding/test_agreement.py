"""What gender, number and contrast settle of what a word refers to."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "kind", "meant"),
    [
        # who is spoken of, not who was asked in between
        ("If the lady is upset, ask Mark what happened and bring her a towel.", "recipient", "the lady"),
        ("If grandpa is thirsty, ask Julia where the juice is and bring him a bottle.", "recipient", "grandpa"),
        ("Ask Hannah where my uncle is and take him the hat.", "recipient", "my uncle"),
        ("If the window is open, ask Paul what happened and give him a towel.", "recipient", "Paul"),
        # one person, of the gender that a title or kin tells
        ("Find Peter and his wife and give him the parcel.", "recipient", "Peter"),
        ("If Mrs. Green is in the hall with Mr. Stone, hand him the key.", "recipient", "Mr. Stone"),
        ("If Mr. Green is in the hall, hand him the key.", "recipient", "Mr. Green"),
        # two single things together, but not beside a plural
        ("Get the butter. Get the bread too. Bring them here.", "object", "the butter and the bread"),
        ("Rinse the melon, peel the mango and put them in the bowl.", "object", "the melon and the mango"),
        ("Take the knife from the drawer, get the forks and wash them.", "object", "the forks"),
        # another place
        ("Take the hats out of the left drawer and put them in the right one.", "goal", "the right drawer"),
        ("Take the coats off the metal hook and hang them on the wooden one.", "goal", "the wooden hook"),
        ("Move the books from one shelf to the other.", "goal", "the other shelf"),
        ("Put the beans in a pot and put the corn in another.", "goal", "another pot"),
        ("Take the clean towel from the rack and put the wet one in the washer.", "object", "the wet towel"),
        # within one order
        ("Take Mia's tablet from her.", "source", "Mia"),
        ("Take the tray and put the cups on it.", "goal", "the tray"),
        # one of two, by its place in the order
        ("Check the radio and the heater. If the former is on, turn it off.", "object", "the radio"),
        ("Find the hammer and the saw and bring me the latter.", "object", "the saw"),
        (
            "Get the red bowl and the white bowl; if the second one is cracked, throw it away.",
            "object",
            "the white bowl",
        ),
        # one of all of them
        ("If all the plates are clean, bring me one.", "object", "one plate"),
        ("If all the plates are clean, bring me them.", "object", "all the plates"),
        # the place that is asked of, not the one that tells which it is
        ("If the table by the window is clean, put the flowers there.", "goal", "the table"),
        ("If the lamp in the hall is on, put the shoes there.", "goal", "the hall"),
        ("If the carpet in the study is dry, take the chair there.", "goal", "the study"),
        # where the rest is
        ("Move three chairs from the hall to the kitchen and leave the rest there.", "goal", "the hall"),
        ("Move three chairs from the hall to the kitchen and leave them there.", "goal", "the kitchen"),
        ("The harp is due in the hall. If you can get it off its stand, carry it down there.", "goal", "the hall"),
        ("Dad is in the shed. Take the drill off the hook and bring it out there.", "goal", "the shed"),
        ("The kids are in the tent. Get the torch from the drawer and take it there.", "goal", "the tent"),
        # back where it was
        ("Take the cups off the shelf, rinse them and put them back there.", "goal", "the shelf"),
        ("Remove the lid from the pan, take out a sausage and put it back on.", "object", "the lid"),
        ("Take the picture out of the frame, wipe the glass and put it back in.", "object", "the picture"),
        ("Take the milk out of the fridge, get a cup and put it back on the shelf.", "object", "a cup"),
        # what is lacking
        ("The stapler is out of staples; get some.", "object", "some staples"),
        ("My mug is empty of tea; bring me some.", "object", "some tea"),
    ],
)
def test_gender_number_and_contrast_say_what_is_meant(text: str, kind: str, meant: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value(kind) == meant


def test_what_is_in_the_first_of_two_things_is_told_by_it() -> None:
    told = Interpreter.load(encoder=True).interpret("Pick up the basket and the apples in it.")
    assert told.tasks[-1].value("source") == "the basket"


def test_what_is_open_is_a_place_itself() -> None:
    told = Interpreter.load(encoder=True).interpret("See if the library near the park is open, and if so, go there.")
    assert told.tasks[-1].value("goal") == "the library"


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Put the radio on, and if he's still awake, tell me.", 2, "he"),
        ("Close the shutters in the nursery, and if she wakes up, tell me.", 2, "she"),
        ("Lay out the rugs, and if she is hungry, call me.", 2, "she"),
        ("Don't wake him if he's asleep; if he's up, give him his tea.", 2, "he"),
        ("Clear the counter once they've finished.", 2, "they"),
        ("When they arrive, take their hats.", 1, "they"),
        ("Find my dolls' cot, then fetch the goldfish and put him in it.", 3, "the goldfish"),
        ("Take the towels off Ann's chair, and if she's up, call her.", 2, "Ann"),
    ],
)
def test_he_she_and_they_are_no_thing(interpreter: Interpreter, text: str, number: int, value: str) -> None:
    assert interpreter.interpret(text).task(number).value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If he's eaten the gruel, bring him a pear.", "him"),
        ("If Gus has finished the soup, hand him the bread.", "Gus"),
        ("If he's on the phone, hand him a note.", "him"),
    ],
)
def test_who_has_finished_something_is_not_what_is_finished(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).task(2).value("recipient") == value


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Put the cat out and lock up.", 2, None),
        ("Clear the desk and wash up.", 2, None),
        ("Walk Ann to the front door, then lock up.", 2, "the front door"),
    ],
)
def test_what_is_done_up_without_an_object_is_done_to_nothing_that_it_cannot_be_done_to(
    interpreter: Interpreter, text: str, number: int, value: str | None
) -> None:
    assert interpreter.interpret(text).task(number).value("object") == value


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("If the fan or the heater is on, turn it off.", 2, "the fan or the heater"),
        ("Look for a pen or a pencil and bring it to me.", 2, "a pen or a pencil"),
        ("If it's Thursday or the bin is full, empty it.", 3, "the bin"),
    ],
)
def test_whichever_of_two_it_is(interpreter: Interpreter, text: str, number: int, value: str) -> None:
    found = interpreter.interpret(text)
    assert found.tasks[min(number, len(found.tasks)) - 1].value("object") == value


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Take the tray away, and hang the towel up unless it stinks.", 3, "the towel"),
        ("Empty the kettle, then wash the jug if it needs rinsing.", 3, "the jug"),
        ("If the shed is taken, make me a toast first and then see if it's free.", 3, "the shed"),
    ],
)
def test_an_if_it_right_behind_an_order_is_of_what_that_names(
    interpreter: Interpreter, text: str, number: int, value: str
) -> None:
    assert interpreter.interpret(text).task(number).value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Take the rug out and beat the mat, but only if it's dirty.", "the mat"),
        ("Get the hose and rinse the terrace, but not if it's wet.", "the terrace"),
        ("Sweep the porch, and while you're at it empty the tub, though not if it's half full.", "the tub"),
        # the place where something is put, what it is like outside
        ("Put the towel in the basket, but not if it's full.", "the basket"),
        ("Close the curtain and turn on the lamp, but not if it's sunny.", "it"),
        ("Turn the oven off and open the window, but only if it's warm out.", "it"),
    ],
)
def test_what_is_hung_on_an_order_is_of_what_that_names(interpreter: Interpreter, text: str, value: str | None) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value


def test_what_is_put_in_is_put() -> None:
    task = Interpreter.load().interpret("When it boils, put in the peas.").tasks[-1]
    assert (task.value("object"), task.value("goal")) == ("the peas", None)


@pytest.mark.parametrize(
    ("text", "verb", "kind", "meant"),
    [
        # whose limb or thing it is
        ("If my brother-in-law's ankle is swollen, follow him to the car.", "follow", "object", "my brother-in-law"),
        ("If my niece's satchel is heavy, accompany her to the bus.", "accompany", "object", "my niece"),
        ("If my grandfather's back is stiff, bring him the stool.", "bring", "recipient", "my grandfather"),
        # who was called "he" is not "her"
        ("The gardener is here and he can't stand dogs, so if the collie is in the hall, take her to the attic.",
         "take", "object", "the collie"),
        ("The tutor is coming and she likes tea, so if the pot is full, pour her a cup.",
         "pour", "recipient", "The tutor"),
        # who would have got it in the other case
        ("My uncle left me a violin. If it's in the attic, show it to the buyer; otherwise tell him to wait.",
         "tell", "recipient", "the buyer"),
        ("My uncle is in the garden. If the mail is here, take it to him; otherwise ask him to wait.",
         "ask", "recipient", "My uncle"),
    ],
)  # fmt: skip
def test_who_somebody_is_is_told_by_whose_things_and_by_earlier_words(
    interpreter: Interpreter, text: str, verb: str, kind: str, meant: str
) -> None:
    found = interpreter.interpret(text)
    assert [task.value(kind) for task in found.tasks if task.span.of(text).lower() == verb] == [meant]


def test_somebodys_little_one_is_a_child(interpreter: Interpreter) -> None:
    text = "Check whether my cousin's little one is by the swing, and if she is, walk with her to the gate."
    found = interpreter.interpret(text)
    assert [task.value("object") for task in found.tasks] == ["my cousin's little one"] * 3


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Rinse both jugs, put one on the tray and bring me the other.", "one jug"),
        ("Get two vests and put one in the bag and the other on the bed.", "one vest"),
        ("Blow up the balls and put five of them in the net.", "five of the balls"),
        ("Get the vests and put them in the bag.", "the vests"),
    ],
)
def test_one_or_some_of_several_are_not_all_of_them(text: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("object") for task in found.tasks if task.span.of(text) == "put"][:1] == [value]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Open the crate and put the hoses inside.", "the crate"),
        ("Unlock the chest in the hall and put the masks inside.", "the chest"),
        ("Open the crate and put the hoses in.", "the crate"),
        ("Is the strongbox open? If yes, put the rings inside.", "the strongbox"),
        ("If the alarm is off, open the show case, take out the old cards and lay in the new ones.", "the show case"),
        ("Open the door and put the boots inside.", "inside"),
        ("If the window is open, put the pots inside.", "inside"),
        ("If it's raining, put the cushions inside.", "inside"),
        ("Lock the side gate and put the dog out.", "out"),
        ("Lock the side gate and put the plates out.", None),
        ("Lock the side gate and put the dog out on the terrace.", "on the terrace"),
    ],
)
def test_inside_is_in_what_was_opened_and_out_is_outside(
    interpreter: Interpreter, text: str, value: str | None
) -> None:
    found = interpreter.interpret(text)
    assert found.tasks[-1].value("goal") == value


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("Warm the porridge if the toddler is awake. When it's hot, take it to him.", 4, "the porridge"),
        ("Put the pie in the oven if Ruth is home. When it's done, slice it.", 4, "the pie"),
        ("Is Ella on the balcony? If it's dirty, sweep it.", 3, "the balcony"),
        ("If the puppy is wet, pick it up.", 2, "the puppy"),
        ("If somebody rings and it's Paul, let him in.", 2, "somebody"),
        # of one thing and several
        ("Scrape the mud off the boots and put them on the mat.", 2, "the boots"),
        ("Take the photos out of the album and bring it to me.", 2, "the album"),
        ("Take the photos out of the album and bring them to me.", 2, "the photos"),
        ("Fill either of the jugs and bring it here.", 2, "either of the jugs"),
        ("Get the thermos from the car and fill it.", 2, "the thermos"),
        # what is put in the wash
        ("Get the mark off the blouse; if it won't come off, soak it.", 3, "the blouse"),
        ("Get the mark off the blouse; if it won't come off, leave it in the basin.", 3, "the blouse"),
    ],
)
def test_it_is_one_thing_and_nobody(interpreter: Interpreter, text: str, number: int, value: str) -> None:
    assert interpreter.interpret(text).task(number).value("object") == value
