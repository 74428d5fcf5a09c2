"""What is to be got done, be it to several things, what somebody else is to do, and what is let go on by itself."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "deeds", "thing"),
    [
        ("Get the hedge trimmed.", ["trimmed"], "the hedge"),
        ("Get the lawns mown.", ["mown"], "the lawns"),
        ("Please get the hamster fed before supper.", ["fed"], "the hamster"),
        ("Get the stairs swept and mopped.", ["swept", "mopped"], "the stairs"),
        ("Could you get the blinds dusted?", ["dusted"], "the blinds"),
        ("Have the carpet beaten.", ["beaten"], "the carpet"),
    ],
)
def test_what_is_to_be_got_done_is_done_to_the_thing(
    interpreter: Interpreter, text: str, deeds: list[str], thing: str
) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(text) for task in found.tasks] == deeds
    assert {task.value("object") for task in found.tasks} == {thing}


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("Have the rug beaten and the curtains washed.", ["the rug", "the curtains"]),
        ("Have the crate sent up, and call Lea.", ["the crate", None]),
        ("Get the towels folded, the shelf dusted and the bath scrubbed.", ["the towels", "the shelf", "the bath"]),
        ("Could the yard be swept and the gate painted?", ["the yard", "the gate"]),
        ("Could the yard be swept and the gate be painted?", ["the yard", "the gate"]),
        ("Can the forks be washed and dried?", ["the forks", "the forks"]),
    ],
)
def test_what_is_got_done_to_several_things_is_several_orders(
    interpreter: Interpreter, text: str, things: list[str | None]
) -> None:
    assert flow(interpreter, text) == list(range(1, len(things) + 1))
    assert [task.value("object") for task in interpreter.interpret(text).tasks] == things


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Have the jars been emptied? If not, empty them.", ["check_state", "change_state"]),
        ("Have the girls eaten?", ["check_state"]),
        ("Get the hatch shut.", ["change_state"]),
        ("Get the boxes stacked by the door.", ["placing"]),
        ("Have a look at the towels.", ["searching"]),
    ],
)
def test_what_is_asked_or_tells_the_state_or_place_is_read_as_it_is(
    interpreter: Interpreter, text: str, types: list[str]
) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == types


def test_a_table_that_is_laid_is_put_nowhere(interpreter: Interpreter) -> None:
    types = [task.type for task in interpreter.interpret("Have the table laid and the beds made.").tasks]
    assert types == ["change_state", "change_state"]


def test_what_is_got_shut_is_got_so(interpreter: Interpreter) -> None:
    assert interpreter.interpret("Get the hatch shut.").tasks[0].value("state") == "shut"


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("Get the crate marked fragile.", ["the crate marked fragile"]),
        ("Get the cooked ham.", ["the cooked ham"]),
        ("Get the gate closed.", ["the gate"]),
    ],
)
def test_what_tells_which_thing_or_how_it_is_to_be_is_no_deed(
    interpreter: Interpreter, text: str, things: list[str]
) -> None:
    found = interpreter.interpret(text)
    assert [(task.span.of(text), task.value("object")) for task in found.tasks] == [("Get", *things)]


@pytest.mark.parametrize(
    ("text", "whom", "message"),
    [
        ("Have Lena polish the spoons.", "Lena", "polish the spoons"),
        ("Get Olaf to wind the clock.", "Olaf", "to wind the clock"),
        ("Could you have my uncle lift the trunk?", "my uncle", "lift the trunk"),
        ("Let Iris hold the ladder.", "Iris", "hold the ladder"),
        ("Get the twins to wash their hands.", "the twins", "to wash their hands"),
    ],
)
def test_who_is_to_do_something_is_told_to(interpreter: Interpreter, text: str, whom: str, message: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert (task.type, task.value("recipient"), task.value("message")) == ("informing", whom, message)


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("Let the cat out.", ["Let"]),
        ("Let Otto know that the bus is here.", ["Let"]),
        ("Have a look in the cellar.", ["Have"]),
        ("Get Olaf to the station.", ["Get"]),
    ],
)
def test_a_light_verb_before_a_thing_is_the_order(interpreter: Interpreter, text: str, verbs: list[str]) -> None:
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == verbs


@pytest.mark.parametrize(
    ("text", "objects"),
    [
        ("Give my boots a brush.", ["my boots"]),
        ("Fold the sheets and give the sideboard a polish.", ["the sheets", "the sideboard"]),
        ("Give the hamster a bath.", ["the hamster"]),
        ("Wipe the counter off.", ["the counter"]),
        ("Shake the mat off.", ["the mat"]),
    ],
)
def test_a_deed_is_done_to_what_it_is_given_to(text: str, objects: list[str]) -> None:
    found = Interpreter.load().interpret(text)
    assert [{a.type: a.value for a in task.arguments} for task in found.tasks] == [{"object": o} for o in objects]


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("If you find my earring when you sweep, bring it to me.", ["find", "bring"]),
        ("If somebody comes to collect the crate, call me.", ["comes", "call"]),
        ("When you sweep the hall, open the door.", ["sweep", "open"]),
    ],
)
def test_what_only_tells_of_a_case_is_no_order(text: str, verbs: list[str]) -> None:
    assert [task.span.of(text) for task in Interpreter.load().interpret(text).tasks] == verbs
