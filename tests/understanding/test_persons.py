"""Who "he" and "she" are, and what they cannot be."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "values"),
    [
        (
            "Ask Mrs Vane which vase she meant. If it's the enamel, take it to her; if it's tin, tell her it broke.",
            ["Mrs Vane", "Mrs Vane", "Mrs Vane"],
        ),
        ("Ask the lodger which tie he means. If it is the silk one, give it to him.", ["the lodger", "the lodger"]),
        ("Check the label on the jar for Gran. If it's the chutney, bring it to her.", ["Gran"]),
        ("If the matches are damp, hand him the lighter.", ["him"]),
        ("If the bulbs are dusty, give her two of those.", ["her"]),
        ("If the lantern is cracked, hand him the torch.", ["him"]),
        ("If the kids are asleep, hand her the keys.", ["her"]),
        # who may be meant
        ("If the sexton is wet, hand him the towel.", ["the sexton"]),
        ("If the ferret is loose, hand him a biscuit.", ["the ferret"]),
        ("Should the window cleaner turn up, hand him the bucket.", ["the window cleaner"]),
        ("If it's that fellow about the gutters, tell him I'm out.", ["that fellow about the gutters"]),
        ("Somebody rang. If it's the vicar, tell him I'm out.", ["the vicar"]),
    ],
)
def test_nobody_is_a_thing_that_is_asked_about(interpreter: Interpreter, text: str, values: list[str]) -> None:
    found = interpreter.interpret(text)
    assert [task.value("recipient") for task in found.tasks if task.value("recipient")] == values


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("My niece's little one is crying in the barn. Go there, open up and walk with her.", "My niece's little one"),
        ("The tenant's wee one is at the gate. Walk with her.", "The tenant's wee one"),
        ("The tenant's son is at the gate. Walk with him.", "The tenant's son"),
        ("The tenant's hen house is open. Walk there with her.", "The tenant"),
    ],
)
def test_somebodys_little_one_is_who_is_spoken_of(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Take this parcel to Mrs Abara. If she opens, tell her it's from me.", "Mrs Abara"),
        ("Carry the crate to the widow. If she opens, tell her it's from me.", "the widow"),
        ("Ring for Ivo. If he opens, tell him it's me.", "Ivo"),
        ("If the sexton is in the crypt, open the door.", "the door"),
    ],
)
def test_who_opens_is_somebody(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).task(2).value("object") == value


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("Nan wants her shawl. Take it to her in the conservatory and tell her it's dry.", ["Nan", "Nan"]),
        ("Hugo's broth is ready. Carry it up to him in the attic.", ["Hugo"]),
        ("If the girls are hungry, bring the crisps out to them on the porch.", ["the girls"]),
        # nobody named, and words that name who it is
        ("Take the mallet to him on the roof.", ["to him on the roof"]),
        ("Take the mallet to the man on the roof.", ["to the man on the roof"]),
    ],
)
def test_who_is_somewhere_is_who_was_named(interpreter: Interpreter, text: str, values: list[str]) -> None:
    found = interpreter.interpret(text)
    assert [task.value("recipient") for task in found.tasks if task.value("recipient")] == values


def test_who_has_nodded_off_is_who_was_to_be_brought_something(interpreter: Interpreter) -> None:
    text = "Gran's pot of tea is stewing. Take it out to her by the pond, and if she's dozed off, leave it on the sill."
    found = interpreter.interpret(text)
    assert (found.tasks[0].value("recipient"), found.tasks[1].value("object")) == ("Gran", "Gran")


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("If a builder rings, let him in. Should it be the policewoman instead, give her the papers.", ["policewoman"]),
        ("If the curate calls, show him in. Should it be the piano tuner, tell him I'm out.", ["piano tuner"]),
        ("If the matron comes, bring her the chart. If it's the chaplain, bring him a chair.", ["matron", "chaplain"]),
        ("If the curate calls, pour him a cup. Should it be raining, give him the umbrella.", ["curate", "curate"]),
        ("If Ivo is cold, bring him tea. If the kettle is cold, tell him to wait.", ["Ivo", "Ivo"]),
    ],
)
def test_somebody_else_who_calls_is_who_is_given_something(
    interpreter: Interpreter, text: str, values: list[str]
) -> None:
    found = interpreter.interpret(text)
    said = [task.value("recipient") for task in found.tasks if task.value("recipient")]
    assert [value.removeprefix("the ") for value in said] == values


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (
            "When the woman in the loft rings, go up. If her door is ajar, ask whether she wants tea.",
            "the woman in the loft",
        ),
        ("Look for the nurse and ask how long she needs.", "the nurse"),
        ("Find Granny. If she's in the garden, ask whether she needs her hat.", "Granny"),
        # whoever that is
        ("If the lodger isn't in his room, ask when he comes back.", None),
        ("If Mr Bose is in, show him up, else ring the desk and ask whether he has cancelled.", None),
        ("Find Granny. If Ivo is in the garden, ask where he left the hat.", "Ivo"),
        ("Walk the dog. If the gate is shut, ask when it opens.", None),
    ],
)
def test_who_is_asked_is_whom_the_orders_are_about(interpreter: Interpreter, text: str, value: str | None) -> None:
    assert interpreter.interpret(text).tasks[-1].value("recipient") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If there's nobody in the hall, lock up, otherwise tell them to leave.", "them"),
        ("Unless the porch is empty, tell them to go.", "them"),
        ("Is anyone at the table? If so, tell them lunch is ready.", "anyone"),
        ("Drive to the school and tell them Ann is ill.", "the school"),
        ("Ring the bakery. If the bread is ready, tell them to keep it.", "the bakery"),
    ],
)
def test_whoever_is_told_something_is_no_thing_or_room(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("recipient") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Whose is this satchel? If Bea's name is inside, put it on her peg.", "this satchel"),
        ("If Nan's name is on the letter, bring it up to her.", "the letter"),
        ("Is my name on the crate? If so, bring it to me.", "the crate"),
        ("If Lea's initials are in the cap, hang it on her peg.", "the cap"),
        ("If the name tag is on the shelf, bring it to her.", "the name tag"),
    ],
)
def test_what_bears_somebodys_name_is_handled(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value


@pytest.mark.parametrize(
    ("text", "kind", "values"),
    [
        ("wake sean and if he won't get up tell him it's noon", "recipient", ["sean"]),
        ("ned's got the rake, get it off him", "source", ["ned"]),
        ("If she's still up in the morning, hand her the shawl.", "recipient", ["her"]),
        ("Get hold of the janitor and have him unlock the shed.", "recipient", ["the janitor"]),
        ("Fetch Grandad's boots for him.", "recipient", ["Grandad"]),
        ("Nobody's in the study, is there? If there is, ask them to leave.", "recipient", ["them"]),
        (
            "Look for a spade in the yard; if they're all dirty, bring the hoe.",
            "object",
            ["for a spade", "a spade", "the hoe"],
        ),
    ],
)
def test_who_is_named_in_passing(interpreter: Interpreter, text: str, kind: str, values: list[str]) -> None:
    found = interpreter.interpret(text)
    assert [task.value(kind) for task in found.tasks if task.value(kind)] == values


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Is the nurse here? Ask her to look at Grandad, and tell him she's coming.", "Grandad"),
        ("If the vet calls, ask her to see to Hugo's foal and tell him she's on her way.", "Hugo"),
        ("Is the nurse here? Ask her to look at Grandad, and tell her he's asleep.", "the nurse"),
    ],
)
def test_who_was_called_her_is_not_him(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("recipient") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If the book is at the neighbour's, ask him for it.", "the neighbour"),
        ("Go round to the dentist's and tell her I'll be late.", "the dentist"),
        ("Go round to the dentist's and tell me if it's open.", "me"),
        ("If the butcher's open, ask him for mince.", "the butcher"),
    ],
)
def test_who_is_at_somebodys_is_that_person(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("recipient") == value


def test_nobody_wakes_the_lights(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Turn on the lights in the kids room and wake them up.")

    assert found.tasks[1].value("object") == "the kids"


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("go and fetch nina from the garden and tell her i need the spare key", "nina"),
        ("if the gate is stuck get maria from the yard and tell her to bring the oil", "maria"),
        ("if the boiler is off fetch gareth from the barn and ask him to light it", "gareth"),
        ("go and find jodie in the greenhouse and give her these gloves", "jodie"),
        # nobody is named
        ("get milk from the shop and tell her it's in the fridge", "her"),
        ("Go up to the attic workshop and tell him supper is ready.", "him"),
        ("Fetch the ladder from the shed and tell her it's broken.", "her"),
    ],
)
def test_who_is_fetched_by_name_is_somebody(text: str, value: str, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("recipient") == value


@pytest.mark.parametrize(
    ("text", "number", "value"),
    [
        ("See if anyone's in the study. If it's empty, call me.", 2, "the study"),
        ("If the lady next door is in, give the letter to her.", 2, "the lady next door"),
    ],
)
def test_it_is_nobody_and_who_is_next_door_somebody(
    interpreter: Interpreter, text: str, number: int, value: str
) -> None:
    task = interpreter.interpret(text).task(number)
    assert (task.value("recipient") or task.value("object")) == value
