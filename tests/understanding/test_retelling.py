"""Alternatives without a verb or ahead of their condition, read from the instruction told in full."""

from __future__ import annotations

import pytest

from decomplex_bt.instruction import Instruction, Task
from decomplex_bt.understanding.interpreter import Interpreter


def repeating_the_first(instruction: Instruction, carrier: str, argument: str, flow: list[object]) -> Task:
    """The one task without a verb of its own, which has the first one's; checks what carries it and what it is of."""
    assert instruction.flow.to_json() == flow
    (task,) = (task for task in instruction.tasks if task.repeats)
    assert task.span.of(instruction.text) == carrier
    assert instruction.verb_of(task).id == 1
    assert argument in [found.value for found in task.arguments]
    return task


@pytest.mark.parametrize(
    ("text", "carrier", "argument", "flow"),
    [
        ("Bring me a pen, or a pencil if you can't find one.", "pencil", "a pencil", [{"if": [1, 3], "else": [2]}]),
        ("Put the vase on the shelf, or on the desk if the shelf is full.", "on", "on the desk",
         [{"if": 3, "then": [2], "else": [1]}]),
        ("Give Anna the red scarf if it's clean, the blue one if not.", "one", "the blue scarf",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Bring me tea if there is any, otherwise coffee.", "coffee", "coffee",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Carry the crates upstairs, or downstairs if the attic is full.", "downstairs", "downstairs",
         [{"if": 3, "then": [2], "else": [1]}]),
        ("Hang the rug outside, or inside if it's raining.", "inside", "inside", [{"if": 3, "then": [2], "else": [1]}]),
        ("Lay two mats on the bench, or three if Lea is here.", "three", "three mats",
         [{"if": 3, "then": [2], "else": [1]}]),
        ("Clean the hob and, if there's time, the oven.", "oven", "the oven", [1, {"if": 2, "then": [3]}]),
        ("Turn the fan off if it's running, on if it isn't.", "on", "the fan",
         [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Put the bowls in the rack if they're wet, in the cupboard if they're dry.", "in", "in the cupboard",
         [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Mop the kitchen, and the hall too if it's dirty.", "hall", "the hall", [1, {"if": 3, "then": [2]}]),
        ("Mop the kitchen, and the hall too, unless it's clean.", "hall", "the hall", [1, {"if": 3, "else": [2]}]),
        ("Fetch me the mop, and also the pail if it's empty.", "pail", "the pail", [1, {"if": 3, "then": [2]}]),
        ("I'd like a cup of coffee, and if there are any biscuits, two of those as well.", "those", "two biscuits",
         [1, {"if": 2, "then": [3]}]),
        ("Could I have some rice, and beans as well if we've got any?", "beans", "beans", [1, {"if": 3, "then": [2]}]),
        ("Put that in the pan if the trout is fresh, otherwise the cod.", "cod", "the cod",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Bring Tom a cup, the tall one if it's clean, otherwise the small one.", "one", "the small cup",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Hand Tom a cup. The tall one if it's clean, otherwise the small one.", "one", "the small cup",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Take a rug to Ada. The thick one if it's dry, if not the thin one. Then come.", "one", "the thin rug",
         [{"if": 2, "then": [1], "else": [3]}, 4]),
        ("Get me some fruit. A plum if there is one, otherwise a fig.", "fig", "a fig",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("bring me the tall glass or if its dirty the short one", "one", "the short glass",
         [{"if": 2, "then": [3], "else": [1]}]),
        ("put the mail on the shelf or if theres no room on the stairs", "on", "on the stairs",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("turn the fan on if its warm off if its cold", "off", "the fan",
         [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Close the door if it's raining, and in any case the windows.", "windows", "the windows",
         [{"if": 2, "then": [1]}, 3]),
        ("Take the tray to Tom, or to Anna if Tom is out, and then close the door.", "to", "to Anna",
         [{"if": 3, "then": [2], "else": [1]}, 4]),
        ("Put the bowls in the rack if they're wet and in the cupboard if they're dry.", "in", "in the cupboard",
         [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Bring me tea if it's cold outside and juice if it's hot.", "juice", "juice",
         [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Put the coat in the chest if it's dry, on the hook if it's damp, and close the door.", "on", "on the hook",
         [{"if": [2, 4], "then": [1], "else": [3]}, 5]),
        ("Take the large bag upstairs, the small one if the large one's too full.", "one", "the small bag",
         [{"if": 3, "then": [2], "else": [1]}]),
        ("Can you put the coat in the wardrobe, on the hook if the wardrobe's full?", "on", "on the hook",
         [{"if": 3, "then": [2], "else": [1]}]),
        ("Give Anna the apple, the pear if the apple is bad, and close the door.", "pear", "the pear",
         [{"if": 3, "then": [2], "else": [1]}, 4]),
        ("Mop the kitchen, and the hall too if it's dirty, and bring the pail in.", "hall", "the hall",
         [1, {"if": 3, "then": [2]}, 4]),
        ("Fold the shirts and the sheet as well if it's dry, then shut the door.", "sheet", "the sheet",
         [1, {"if": 3, "then": [2]}, 4]),
        ("Fetch me the tall ladder, or if it's broken, the short one, and open the gate.", "one", "the short ladder",
         [{"if": 2, "then": [3], "else": [1]}, 4]),
        ("Fetch a rug from the chest or, if it's locked, from the attic, and lay it by the bed.", "from",
         "from the attic", [{"if": 2, "then": [3], "else": [1]}, 4]),
        ("Fetch me an orange, or if there aren't any oranges a pear.", "pear", "a pear",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Bring Gran cake, or if there's no cake some biscuits.", "biscuits", "some biscuits",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Get me a cider, or if there's no cider left a beer.", "beer", "a beer",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Bring me a green mug, or brown if there's no green.", "brown", "a brown mug",
         [{"if": 3, "then": [1], "else": [2]}]),
        ("Get me a big envelope, or small if there isn't a big one.", "small", "a small envelope",
         [{"if": 3, "then": [1], "else": [2]}]),
        ("I'd like white wine, or red if there is no white left.", "red", "red wine",
         [{"if": 3, "then": [1], "else": [2]}]),
        ("Leave the spare key with Mia or, if she's out, with Leo.", "with", "with Leo",
         [{"if": 2, "then": [3], "else": [1]}]),
        ("Take the tray to Gran, or if she's gone, to Dad.", "to", "to Dad", [{"if": 2, "then": [3], "else": [1]}]),
        ("Hand the tickets to Lea or, if she isn't in, to her mum.", "to", "to her mum",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Take the tray to Gran, and if she's gone, to Dad.", "to", "to Dad", [{"if": 2, "then": [3], "else": [1]}]),
        ("Bring me juice or, if we're out, milk.", "milk", "milk", [{"if": 2, "then": [3], "else": [1]}]),
        ("Put the jug on the shelf or, if that's full, on the floor.", "on", "on the floor",
         [{"if": 2, "then": [3], "else": [1]}]),
        ("Fill the tall vase or, if it's cracked, the short one, and then set it on the desk.", "one", "the short vase",
         [{"if": 2, "then": [3], "else": [1]}, 4]),
        ("Take both cases up if Tom is in, otherwise only the small one.", "one", "the small case",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Feed the hens, the ducks as well if they're hungry, and shut the gate.", "ducks", "the ducks",
         [1, {"if": 3, "then": [2]}, 4]),
        ("Pass the ball to Sid if he's awake, to me if not.", "to", "to me", [{"if": 2, "then": [1], "else": [3]}]),
        ("Set the oven to ninety, or to fifty if the door is open.", "to", "to fifty",
         [{"if": 3, "then": [2], "else": [1]}]),
        ("Turn the fan down, or off altogether if it's cold.", "off", "off", [{"if": 3, "then": [2], "else": [1]}]),
        ("Fetch the lamp if the fuse has blown, and a jug of water if there's any left.", "jug", "a jug of water",
         [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}]),
        ("Shut the window if the fan is on, and the door if the cat is in, then come here.", "door", "the door",
         [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}, 5]),
        ("Wipe the desk and don't forget the shelf.", "shelf", "the shelf", [1, 2]),
        ("Bring the plates to the table. And never forget the forks.", "forks", "the forks", [1, 2]),
        ("Pack my toothbrush, but don't forget the charger.", "charger", "the charger", [1, 2]),
    ],
)  # fmt: skip
def test_an_unsaid_verb_is_carried_by_a_word_of_its_phrase(
    interpreter: Interpreter, text: str, carrier: str, argument: str, flow: list[object]
) -> None:
    instruction = interpreter.interpret(text)
    task = repeating_the_first(instruction, carrier, argument, flow)
    assert all(found.span is None for found in task.arguments)
    starts = [task.span.start for task in instruction.tasks]
    assert starts == sorted(set(starts))


@pytest.mark.parametrize(
    ("text", "carrier", "argument", "flow"),
    [
        ("Bring me a plum. If there aren't any, a fig will do.", "do", "a fig", [{"if": 2, "then": [1], "else": [3]}]),
        ("Put the tray on the desk. If that's full, the bed is fine too.", "is", "on the bed",
         [{"if": 2, "then": [3], "else": [1]}]),
        ("Bring Lea cocoa if there is any, if not milk would be fine.", "be", "milk",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Turn on the radio. No luck? Then the tv will do.", "do", "the tv", [{"if": 1, "else": [2]}]),
    ],
)  # fmt: skip
def test_what_serves_is_carried_by_the_verb_that_says_so(
    interpreter: Interpreter, text: str, carrier: str, argument: str, flow: list[object]
) -> None:
    repeating_the_first(interpreter.interpret(text), carrier, argument, flow)


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("Hand me the lamp. The red one.", "the red lamp"),
        ("Water the plant, the tall one.", "the tall plant"),
        ("Hand me a rug, the one with the fringe.", "the rug with the fringe"),
        ("Turn on a light in the hall. The small one.", "the small light"),
    ],
)
def test_which_one_is_meant_may_follow_alone(interpreter: Interpreter, text: str, thing: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert task.value("object") == thing


def test_a_bare_kind_is_no_other_choice_without_a_lack(interpreter: Interpreter) -> None:
    """It may be the state that the thing is in."""
    assert interpreter.interpret("Bring me a ripe plum, or green if Lea wants it green.").to_json()["flow"] == [
        {"if": 2, "then": [1]}
    ]


def test_an_exception_does_not_tell_which_one_is_meant(interpreter: Interpreter) -> None:
    """Of several things the one that has a condition need not be all that are meant."""
    assert (
        interpreter.interpret("Water the plants. The tall one only if it is dry.").tasks[0].value("object")
        == "the plants"
    )


def test_which_one_is_meant_hangs_on_its_condition_alone(interpreter: Interpreter) -> None:
    """What is ordered ahead of a thing of which only the kind is said is done in any case."""
    instruction = interpreter.interpret(
        "Shut the gate and take a rug to Ada. The thick one if it's dry, if not the thin one."
    )
    assert instruction.flow.to_json() == [1, {"if": 3, "then": [2], "else": [4]}]


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("Bring me the mop; failing that, the broom; failing that, a rag.", ["the mop", "the broom", "a rag"]),
        (
            "Bring me the red cup, failing which the green one, failing which a glass.",
            ["the red cup", "the green cup", "a glass"],
        ),
    ],
)
def test_each_of_several_alternatives_is_for_where_the_one_before_fails(
    interpreter: Interpreter, text: str, things: list[str]
) -> None:
    instruction = interpreter.interpret(text)
    assert instruction.flow.to_json() == [{"if": 1, "else": [{"if": 2, "else": [3]}]}]
    assert [task.value("object") for task in instruction.tasks] == things


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Open the window, or start the fan if the window is stuck.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Switch on the fan, or open the door if the fan is broken.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Lock the door if Tom is home, leave it open if he isn't.", [{"if": [2, 4], "then": [1], "else": [3]}]),
    ],
)
def test_an_order_ahead_of_its_condition_stands_in_place_of_the_one_before(
    interpreter: Interpreter, text: str, flow: list[object]
) -> None:
    instruction = interpreter.interpret(text)
    assert instruction.flow.to_json() == flow
    assert not any(task.repeats for task in instruction.tasks)


def test_what_is_named_behind_its_kind_is_what_is_meant(interpreter: Interpreter) -> None:
    order, check = interpreter.interpret("Get Tom a towel, the striped one if it's dry.").tasks
    assert (order.values("object"), check.values("object")) == (("the striped towel",), ("the striped towel",))


@pytest.mark.parametrize(
    "text",
    [
        "If it's the tap, call me, if it's the drain, clear it, anything else just tell Tom.",
        "If the bathroom smells open the window in there",
        "close the lid if it is on the left and the tap",
        "Fill the kettle if it's empty, whatever the time.",
        "Close the shutters if it's windy, and turn the heating on if it's cold.",
        "Bring me a pen or a pencil if you find one.",
        "Turn on the lamp or the radio if it's dark.",
        "Close the door if it's cold, and the window.",
        "Pass me the black stick, no, the one with the silver top.",
        "Bring the box if it's here, no problem if not.",
        "Leave everything else on the bench if it rains.",
        "Close the window if it's windy and the heater is on.",
        "Walk the dog and don't forget the bags.",
        "Bring me the cup, the red one if it's clean.",
        "Bring the cup, the plate and the bowl if the cup is clean.",
        "Sweep the hall, and don't forget the hamster. Fill his bottle.",
        "Bring me the tea. If it's hot, that is fine.",
        "Bring me the paper. If Tom has it, the magazine will do: bring me that.",
        "Turn on the heater. If it's broken, a blanket is fine.",
        "Wash the cup. If it's clean, everything is fine.",
        "Check the pasta. If it's done, dinner is fine.",
    ],
)
def test_what_is_no_alternative_is_read_as_it_stands(interpreter: Interpreter, text: str) -> None:
    assert not any(task.repeats for task in interpreter.interpret(text).tasks)


@pytest.mark.parametrize(
    ("text", "task", "places"),
    [
        ("Find my glasses, they're on the shelf or else beside the sink, and bring them to me.", 1,
         ["on the shelf", "beside the sink"]),
        ("My bag is in the hall or else under the desk, fetch it for me.", 1, ["in the hall", "under the desk"]),
        ("Get the ladder, it'll be in the shed or perhaps behind the garage.", 1, ["in the shed", "behind the garage"]),
        ("Look for my wallet on the table, or failing that in the car.", 1, ["on the table", "in the car"]),
        ("The keys could be under the mat, or else behind the pot. Bring them to me.", 1,
         ["under the mat", "behind the pot"]),
        ("Put the milk on the shelf or else on the table.", 1, []),
        ("Tell Tom dinner is at six or else at seven.", 1, []),
    ],
)  # fmt: skip
def test_of_two_places_one_may_be_the_one(interpreter: Interpreter, text: str, task: int, places: list[str]) -> None:
    instruction = interpreter.interpret(text)
    found = instruction.task(task)
    assert [*found.values("location"), *found.values("source")] == places
    assert not (places and instruction.warnings)


def test_what_goes_with_a_thing_is_no_alternative_to_it(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Is there any rice left? Bring me a bowl if there is, with a spoon.")
    assert not any(task.repeats for task in found.tasks)


@pytest.mark.parametrize(
    ("text", "source"),
    [
        ("Bring me the red mug from my desk, or if it's not there, the one from the shelf.", "from the shelf"),
        ("Bring me the red mug from the larder or, if it's dirty, the one with the handle.", "from the larder"),
    ],
)
def test_another_one_is_where_it_is_said_to_be(text: str, source: str) -> None:
    assert Interpreter.load("household").interpret(text).tasks[-1].values("source") == (source,)


@pytest.mark.parametrize(
    "text",
    [
        "Bring me the milk, and the sugar too, if there's any.",
        "Hand me the milk, will you? And the sugar if it's there.",
        "Bring me the post, and my walking stick if you see it.",
        "Bring me the milk and then the sugar if it's on the shelf.",
    ],
)
def test_the_last_of_two_things_has_the_condition_behind_it(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).flow.to_json() == [1, {"if": 3, "then": [2]}]


def test_two_things_without_a_mark_share_their_condition(interpreter: Interpreter) -> None:
    text = "Bring me the milk and the sugar if they're on the shelf."
    assert interpreter.interpret(text).flow.to_json() == [{"if": 2, "then": [1]}]


@pytest.mark.parametrize(
    "text",
    [
        "Look for my ring in the bath, and if it isn't there, in the sink, and bring it to me.",
        "Search for the cat in the barn and, if it's not there, on the roof, and then bring it here.",
        "Look for Gran's hat in the hall, and if it isn't there, under the bed, and tell me.",
    ],
)
def test_what_goes_on_behind_a_second_place_is_done_after_either(interpreter: Interpreter, text: str) -> None:
    instruction = interpreter.interpret(text)
    assert instruction.flow.to_json() == [{"if": [1, 2], "else": [3]}, 4]
    assert instruction.tasks[2].value("location").startswith(("in the sink", "on the roof", "under the bed"))


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Hang the pans on the rack, or if there's no room on the rack, put them in the chest.",
         [{"if": 2, "then": [1], "else": [3]}]),
        ("Wipe the bowls and stack them in the box, or if there's no space in the box, leave them in the sink.",
         [1, {"if": 3, "then": [2], "else": [4]}]),
        ("Put the mail in the tray, or if there are letters in the tray, hand it to Lea.",
         [{"if": 2, "then": [3], "else": [1]}]),
        ("put the mail on the shelf or if theres no room on the stairs, and shut the door",
         [{"if": 2, "then": [1], "else": [3]}, 4]),
        ("Put the mail on the shelf, or if it's full on the stairs, and shut the door.",
         [{"if": 2, "then": [3], "else": [1]}, 4]),
    ],
)  # fmt: skip
def test_a_place_ahead_of_the_order_of_its_case_is_no_order(interpreter: Interpreter, text: str, flow: object) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == flow


@pytest.mark.parametrize(
    "text",
    [
        "Lock the shed. Hang the coat in the hall if it's dry, or in the attic if it's wet.",
        "Lock the shed. Give Ada tea if she's cold or juice if she's hot.",
    ],
)
def test_either_is_told_in_full_wherever_it_stands(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == [1, {"if": [3, 5], "then": [2], "else": [4]}]


def test_what_an_and_adds_with_a_case_of_its_own_hangs_on_that_alone(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Water the roses if they're dry, and the tulips if they're wilting.")
    assert found.to_json()["flow"] == [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}]
    assert [task.value("object") for task in found.tasks] == ["the roses", "the roses", "the tulips", "the tulips"]
