"""What "it" is beside a part, a flaw or a reason; what is fetched to clean up is not where the mess is."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("If there is a stain on the cape, wash it.", "the cape"),
        ("If there is a hole in my sock, throw it away.", "my sock"),
        ("If there is something on the bench, wipe it.", "the bench"),
        ("If there is something on the bench, bring it here.", "something"),
        ("If there is dust on the bench, wipe it off.", "dust"),
        ("Get my phone. If the battery is empty, charge it.", "my phone"),
        ("Bring the tablet here, and if the battery is low, plug it in.", "the tablet"),
        ("If the spare battery is empty, charge it.", "the spare battery"),
        ("Make coffee. The mug is dirty, so wash it first.", "the mug"),
        ("Set the table. The plate is dirty, so wash it.", "the plate"),
        ("I want the ring. If the safe's locked, the code is with Ida, so get it from her.", "the code"),
        ("If the soup is boiling, turn down the heat and stir it.", "the soup"),
        ("If the rice is done, turn off the stove and drain it.", "the rice"),
        ("If the radio is on, turn it off.", "the radio"),
    ],
)
def test_it_is_the_whole_and_what_is_meant(interpreter: Interpreter, text: str, thing: str) -> None:
    orders = [task for task in interpreter.interpret(text).tasks if task.type != "check_state"]
    assert thing in {value.lower() for task in orders for value in task.values("object")}


@pytest.mark.parametrize(
    "text",
    [
        "I spilled my coke on the table, can you bring me a sponge?",
        "There is coffee on the floor, can you bring me a cloth?",
        "I dropped a glass in the kitchen, bring me the broom.",
    ],
)
def test_what_cleans_is_not_where_the_mess_is(interpreter: Interpreter, text: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert task.values("source") == task.values("location") == ()


def test_a_broom_is_where_it_is_said_to_be(interpreter: Interpreter) -> None:
    (task,) = interpreter.interpret("The broom is in the larder, bring me the broom.").tasks
    assert task.value("source") == "in the larder"


def test_nobody_is_home_or_on(interpreter: Interpreter) -> None:
    asked = interpreter.interpret("If she is home, ask her if she would like to have coffee.").tasks[1]
    told = interpreter.interpret("if someone's in there knock on the door and tell them to hurry up").tasks[-1]
    assert asked.value("recipient") == "her"
    assert told.value("recipient") == "someone"
