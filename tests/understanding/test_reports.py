"""How far goes what somebody is told or asked."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "message"),
    [
        # a second clause with a subject of its own
        ("If Dad's up, tell him the sauna is warm and the towels are in there.",
         "the sauna is warm and the towels are in there"),
        ("tell Rosa I'm only parking the car and I'll be in soon", "I'm only parking the car and I'll be in soon"),
        ("if it beeps again tell nils the scanner's broken and its not urgent",
         "the scanner's broken and its not urgent"),
        # what takes up the thing of the request
        ("Ask Oskar to fold the sheets and put them in the chest; if he's busy, do it yourself.",
         "to fold the sheets and put them in the chest"),
        ("Tell Jonas to bring the sledge in and dry it.", "to bring the sledge in and dry it"),
        # when those do it who are asked
        ("Ask Petra if she can water the herbs before she leaves.", "if she can water the herbs before she leaves"),
        ("Ask the boys to tidy the loft before they go out.", "to tidy the loft before they go out"),
    ],
)  # fmt: skip
def test_a_clause_that_orders_nothing_belongs_to_the_message(interpreter: Interpreter, text: str, message: str) -> None:
    found = interpreter.interpret(text)
    told = [task for task in found.tasks if task.type == "informing"]
    assert [task.value("message") for task in told] == [message]


@pytest.mark.parametrize(
    ("text", "message", "order"),
    [
        ("Tell Rosa the tea is ready and fetch the biscuits.", "the tea is ready", "fetch"),
        ("Tell Oskar the game starts at six and switch the radio on for him.", "the game starts at six", "switch"),
        ("Ask Petra to sit down and bring her a blanket.", "to sit down", "bring"),
        ("Ask Jonas where the saw is and take it to the shed.", "where the saw is", "take"),
        ("Tell Rosa it's snowing and if the door is open, shut it.", "it's snowing", "shut"),
        ("Ask Petra if she is cold before you air the room.", "if she is cold", "air"),
    ],
)
def test_an_order_behind_a_message_is_an_order(interpreter: Interpreter, text: str, message: str, order: str) -> None:
    found = interpreter.interpret(text)
    told = next(task for task in found.tasks if task.type == "informing")
    assert told.value("message") == message
    assert order in [task.span.of(text) for task in found.tasks]


@pytest.mark.parametrize(
    ("text", "recipients", "messages"),
    [
        ("Tell Rosa her tea is ready and Oskar his is on the stove.",
         ["Rosa", "Oskar"], ["her tea is ready", "his is on the stove"]),
        ("Remind Petra to lock the shed and Jonas to feed the hens.",
         ["Petra", "Jonas"], ["to lock the shed", "to feed the hens"]),
        ("Tell Rosa the tea is ready and Oskar is in the loft.",
         ["Rosa"], ["the tea is ready and Oskar is in the loft"]),
        ("Tell Rosa the tea is ready and the cake is cut.", ["Rosa"], ["the tea is ready and the cake is cut"]),
        ("Tell Rosa and Oskar the tea is ready.", ["Rosa and Oskar"], ["the tea is ready"]),
    ],
)  # fmt: skip
def test_who_is_told_something_else_behind_an_and_has_a_message_of_their_own(
    interpreter: Interpreter, text: str, recipients: list[str], messages: list[str]
) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert list(task.values("recipient")) == recipients
    assert list(task.values("message")) == messages


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Say I'm asleep and take a note.", ["informing", "taking"]),
        ("If Kim rings, tell her I'm away and take a note.", ["check_state", "informing", "taking"]),
        ("Tell Lea the bath is full and fetch a towel.", ["informing", "bringing"]),
        ("Tell Lea the boys are up and want their tea.", ["informing"]),
        ("Tell Lea the jug is broken and it's leaking.", ["informing"]),
    ],
)
def test_an_order_behind_what_is_told_is_none_of_it(interpreter: Interpreter, text: str, types: list[str]) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == types


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Read to Kim if she can't sleep.", [{"if": 2, "else": [1]}]),
        ("Sing to Kim if she's upset.", [{"if": 2, "then": [1]}]),
        ("Announce supper once the lamps are lit.", [{"if": 2, "then": [1]}]),
        ("Tell me if she's upset.", [1]),
        ("Ask Kim if she's upset.", [1]),
    ],
)
def test_who_is_read_to_in_a_case_is_not_told_that(interpreter: Interpreter, text: str, flow: object) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == flow


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("Ask Lea to come down and say goodbye.", "to come down and say goodbye"),
        ("Take the cake to Kim and remind him to phone Nan and say thanks.", "to phone Nan and say thanks"),
        ("If Lea is up, tell her to wash her hands and say grace.", "to wash her hands and say grace"),
        ("Tell Kim to run over and say hello to the boys, then lock up.", "to run over and say hello to the boys"),
    ],
)
def test_who_is_asked_to_do_something_says_what_is_polite(interpreter: Interpreter, text: str, message: str) -> None:
    told = [task for task in interpreter.interpret(text).tasks if task.type == "informing"]
    assert [task.value("message") for task in told] == [message]


@pytest.mark.parametrize(
    "text",
    [
        "Tell Kim to come in and say that lunch is ready.",
        "Tell Kim to hurry up and say I'm sorry.",
        "Tell Kim lunch is ready and say goodbye.",
        "Go to Kim and say hello.",
    ],
)
def test_what_the_listener_is_to_say_stays_an_order(interpreter: Interpreter, text: str) -> None:
    assert len(interpreter.interpret(text).tasks) == 2
