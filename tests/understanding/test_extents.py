"""How far the words of a thing go, and which task has the place that is told of it."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load(encoder=True)


def _values(interpreter: Interpreter, text: str, task: int = 1) -> dict[str, str]:
    return {a.type: a.value for a in interpreter.interpret(text).tasks[task - 1].arguments}


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("Fetch the mug with a chip in it and put it in the bin.", "the mug with a chip in it"),
        ("Is there a letter with a stamp on it? If so, bring it to me.", "a letter with a stamp on it"),
        ("Find the bag with the shoes in it and take it upstairs.", "the bag with the shoes in it"),
        ("Put the cup with no milk in it on the table.", "the cup with no milk in it"),
        ("Take the plate and put a napkin on it.", "the plate"),
        ("Take the cup with you and put it on the table.", "the cup"),
        ("There's a stand by the door. Put the pot with the fern on it.", "the pot with the fern"),
        ("Wipe the shelf with the sponge in it.", "the shelf"),
    ],
)
def test_what_a_thing_has_on_it_is_part_of_its_words(interpreter: Interpreter, text: str, thing: str) -> None:
    assert _values(interpreter, text)["object"] == thing


@pytest.mark.parametrize("verb", ["Bring", "Get", "Fetch"])
def test_two_things_that_are_both_brought_are_no_person(interpreter: Interpreter, verb: str) -> None:
    assert _values(interpreter, f"{verb} both my keys and my wallet.") == {"object": "both my keys and my wallet"}


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("Check if there is enough bread for breakfast, and if not, tell Anna.", "enough bread for breakfast"),
        ("Is there cake for tonight? If so, bring me a piece.", "cake for tonight"),
        ("Supposing the drawer for Monday is still full, tell Tom.", "the drawer for Monday"),
        ("If the oven is on for tomorrow, turn it off.", "the oven"),
        ("If there's no answer for a minute, come back.", "answer"),
    ],
)
def test_what_a_thing_is_for_is_part_of_its_words(interpreter: Interpreter, text: str, thing: str) -> None:
    assert _values(interpreter, text)["object"] == thing


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("After you take out the trash can you bring the bottles down.", "the trash"),
        ("After you bring in the recycling can you sweep the hall", "the recycling"),
        ("Take out the trash can.", "the trash can"),
        ("Before you clean the trash can you need gloves.", "the trash can"),
        ("When you've emptied the trash can put it back.", "the trash can"),
    ],
)
def test_the_can_of_a_question_is_no_can(interpreter: Interpreter, text: str, thing: str) -> None:
    assert _values(interpreter, text)["object"] == thing


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("Put the cup that is standing on the piano in the sink.", {"location": "on the piano", "goal": "in the sink"}),
        ("Put the shoes that are by the door in the cupboard.", {"source": "by the door", "goal": "in the cupboard"}),
        (
            "Take the box which is lying under the bed to the attic.",
            {"source": "under the bed", "goal": "to the attic"},
        ),
        ("Bring me the jar that is on the shelf in the pantry.", {"source": "on the shelf in the pantry"}),
        ("Put the lamp that's on the desk away.", {"source": "on the desk"}),
    ],
)
def test_a_clause_about_a_thing_tells_no_goal(interpreter: Interpreter, text: str, where: dict[str, str]) -> None:
    found = _values(interpreter, text)
    assert {name: found[name] for name in ("location", "source", "goal") if name in found} == where


@pytest.mark.parametrize(
    ("text", "sources"),
    [
        ("The children have left their skates at the bottom of the stairs. Pick them up and hang them on the hooks; if "
         "the hooks are taken, the skates can go in the chest.", ["at the bottom of the stairs", None, None, None]),
        ("Granny's shawl is on the piano stool. Fetch it for her; if it's torn, give her the blanket from the chest.",
         ["on the piano stool", None, "from the chest"]),
        ("The toolbox is in the shed. Open it and bring me the hammer.", [None, "in the shed"]),
    ],
)  # fmt: skip
def test_the_nearest_order_that_takes_a_thing_up_has_its_place(
    interpreter: Interpreter, text: str, sources: list[str | None]
) -> None:
    assert [task.value("source") for task in interpreter.interpret(text).tasks] == sources


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("You remember the lamp my aunt had, the one with the green shade, well, it's in the attic. Bring it down.",
         "the lamp"),
        ("The mug with the blue handle is on the shelf. Bring it to me.", "The mug with the blue handle"),
        ("My rain coat is torn. Get Tom's from the car.", "Tom's rain coat"),
        ("Bring me Mum's.", "Mum's"),
    ],
)  # fmt: skip
def test_a_thing_is_what_is_spoken_of(interpreter: Interpreter, text: str, thing: str) -> None:
    assert _values(interpreter, text)["object"] == thing


def test_what_is_switched_off_is_what_the_condition_names(interpreter: Interpreter) -> None:
    assert _values(interpreter, "Something is beeping. If it's the oven turn it off.", 2)["object"] == "the oven"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("If the shelf is empty, tell me so.", "the shelf is empty"),
        ("If the shelf is empty, tell me so, because I forget.", "the shelf is empty"),
        ("If the shelf is empty, tell me so I can fill it.", None),
        ("If the cat's in the garden, let Ann know that.", "the cat is in the garden"),
        ("If the bin isn't full, tell me so.", "the bin isn't full"),
        ("If the milk is off, state this clearly to Anna.", "the milk is off"),
        ("If the washing is dry, remind me this evening.", None),
        ("If Tom asks, tell him that I'm out.", "that I'm out"),
        ("If Bernie is up, say good night.", "good night"),
        ("If she asks, tell her tomorrow's date.", "tomorrow's date"),
    ],
)
def test_so_is_what_was_asked_and_a_time_is_no_message(
    interpreter: Interpreter, text: str, message: str | None
) -> None:
    assert _values(interpreter, text, 2).get("message") == message


def test_how_likely_something_is_is_no_state(interpreter: Interpreter) -> None:
    found = _values(interpreter, "My scarf is likely on the hook; if it is, bring it to me.")
    assert "state" not in found
    assert found["location"] == "on the hook"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Put on some music in the living room, not too loud.", "change_state"),
        ("put on the lights in the hall", "change_state"),
        ("put the radio on the table", "placing"),
        ("put the pan on the hob", "placing"),
        ("put on some plates in the kitchen", "placing"),
    ],
)
def test_what_is_played_is_put_on_wherever_it_is(interpreter: Interpreter, text: str, kind: str) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == [kind]


def test_a_message_is_a_whole_clause(interpreter: Interpreter) -> None:
    (task,) = interpreter.interpret("Ask my aunt, who is in the yard, whether she has fed the hens.").tasks
    assert task.value("message") == "whether she has fed the hens"


def test_what_somebody_has_come_for_is_no_place(interpreter: Interpreter) -> None:
    text = "Has the fitter come to mend the sink yet? If he has, show him in."
    assert interpreter.interpret(text).tasks[0].value("location") is None


def test_a_room_with_a_number_is_a_goal(interpreter: Interpreter) -> None:
    assert interpreter.interpret("Follow the nurse to room 12.").tasks[0].value("goal") == "to room 12"


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("Put the nails in the jar marked C. If it's full, tell me.", "in the jar marked C"),
        ("Carry the crate to room B. Then come back.", "to room B"),
        ("Put the key in drawer D.", "in drawer D"),
        ("Put it in J. Ford's pigeonhole and come back.", "in J. Ford's pigeonhole"),
    ],
)
def test_the_full_stop_behind_a_letter_ends_the_sentence(interpreter: Interpreter, text: str, goal: str) -> None:
    assert _values(interpreter, text)["goal"] == goal


def test_a_letter_ahead_of_a_surname_keeps_its_full_stop(interpreter: Interpreter) -> None:
    assert _values(interpreter, "Tell J. Hale the bath is full.")["recipient"] == "J. Hale"


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("Lock the hatch to the loft, please, and come back.", "the hatch to the loft"),
        ("Go and bolt the door to the coal shed and then come back in.", "the door to the coal shed"),
        ("Close the gate to the upper paddock, would you, unless it's raining.", "the gate to the upper paddock"),
        ("Lock the scooter to the fence.", "the scooter"),
        ("Open the curtain to your left.", "the curtain"),
        ("Close the lid to keep the heat in.", "the lid"),
    ],
)
def test_where_a_door_leads_to_is_part_of_its_words(interpreter: Interpreter, text: str, thing: str) -> None:
    assert _values(interpreter, text)["object"] == thing


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("The spare key to cabin two isn't on its nail. Look in the blue bowl.", "The spare key to cabin two"),
        ("The batteries for the torch are in the drawer. Bring them to me.", "The batteries for the torch"),
        ("The heater for the fish tank, is it on? If not, switch it on.", "The heater for the fish tank"),
        ("The lid of the tank, is it shut? If not, shut it.", "The lid of the tank"),
        ("The lamp on the desk, is it on? If so, switch it off.", "The lamp"),
        ("The key to the shed is on the hook. Unlock it.", "the shed"),
    ],
)
def test_what_is_told_of_is_a_thing_with_what_it_belongs_to(interpreter: Interpreter, text: str, thing: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == thing


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("There's half a loaf in the bin. Bring it to me.", "half a loaf"),
        ("There ought to be half a sack of meal behind the tractor. Carry it to the barn.", "half a sack of meal"),
        ("There should be half the cake left. Put it in the tin.", "half the cake"),
        ("There's a loaf in the bin. Bring it to me.", "a loaf"),
    ],
)
def test_half_of_a_thing_is_part_of_its_words(interpreter: Interpreter, text: str, thing: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == thing


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "type_", "value"),
    [
        ("If he is, let him in and dry his paws with the old bath mat.", "manner", "with the old bath mat"),
        ("Sand the board with the old grey sanding block.", "manner", "with the old grey sanding block"),
        ("Cover the cake with the beaded net before it goes in.", "manner", "with the beaded net"),
    ],
)
def test_what_something_is_done_with_has_its_noun(text: str, type_: str, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value(type_) in (value, None)
