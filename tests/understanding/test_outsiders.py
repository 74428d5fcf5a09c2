"""Sentences of people who did not know the corpus, each for a class that was misread."""

from __future__ import annotations

import pytest

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


@pytest.fixture(scope="module")
def with_encoder() -> Interpreter:
    pytest.importorskip("onnxruntime")
    return Interpreter.load("household")


def value(instruction: Instruction, task: int, argument: str) -> str | None:
    return instruction.tasks[task - 1].value(argument)


@pytest.mark.parametrize(
    "text", ["See what the noise is.", "Find out whose turn it is.", "Go and see what it is, and close the door."]
)
def test_a_question_that_no_yes_answers_lacks_no_state(interpreter: Interpreter, text: str) -> None:
    assert not interpreter.interpret(text).missing


def test_or_else_with_its_case_behind_is_an_or(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring the tea to Ann, or else to Bob if she's out.")

    assert [task.type for task in found.tasks] == ["bringing", "bringing", "check_state"]
    assert found.flow.to_json() == [{"if": 3, "then": [2], "else": [1]}]


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("Take the tray to room one and carry the cases up.", "to room one"),
        ("Put the red box in bay one and close the hatch.", "in bay one"),
    ],
)
def test_a_number_behind_a_noun_stands_for_nothing(interpreter: Interpreter, text: str, goal: str) -> None:
    assert value(interpreter.interpret(text), 1, "goal") == goal


def test_one_behind_a_noun_with_its_article_stands_for_a_thing(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring me the big mug. If it's dirty, bring me the kitchen one.")

    assert value(found, 3, "object") == "the kitchen mug"


@pytest.mark.parametrize(
    "text",
    [
        "Don't open the door until Oscar has put his shoes on, then call him.",
        "Keep the lights on until Mum has put the baby down.",
    ],
)
def test_what_somebody_is_waited_for_to_do_is_asked(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).tasks[1].type == "check_state"


def test_what_is_waited_for_to_have_been_done_is_an_order(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Once the guest has been brought to his seat, dim the lamp.")

    assert found.tasks[0].type != "check_state"


@pytest.mark.parametrize(
    "text",
    [
        "Put the toys in the red tub and if the red tub is full use the blue one.",
        "Put the toys in the red tub. If the red tub is full, use the blue one.",
    ],
)
def test_what_goes_elsewhere_is_not_the_place_that_is_full(with_encoder: Interpreter, text: str) -> None:
    found = with_encoder.interpret(text)

    assert value(found, 3, "object") == "the toys"
    assert found.flow.to_json() == [{"if": 2, "then": [3], "else": [1]}]


@pytest.mark.parametrize(
    ("text", "instead"),
    [
        ("Bring me a red pen. If there's no red one, blue is fine.", "a blue pen"),
        ("Fetch a green towel; if there are no green towels, white will do.", "a white towel"),
    ],
)
def test_another_sort_serves_as_well(interpreter: Interpreter, text: str, instead: str) -> None:
    found = interpreter.interpret(text)

    assert value(found, 3, "object") == instead
    assert found.flow.to_json() == [{"if": 2, "then": [1], "else": [3]}]


def test_nobody_wakes_the_lights(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Turn on the lights in the kids room and wake them up.")

    assert value(found, 2, "object") == "the kids"


def test_nothing_is_where_it_is_itself(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Get me the big pan, and if the big pan isn't there, the small one is fine.")

    assert value(found, 2, "location") == "there"


def test_trying_again_is_said_to_be_no_task(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Switch the fan on, and if it doesn't work, try again.")

    assert "'try again' is no task: say what to do again" in found.warnings


def test_what_is_done_while_there_is_not_repeated(interpreter: Interpreter) -> None:
    assert not interpreter.interpret("Go to the kitchen and put the kettle on while you are there.").warnings


@pytest.mark.parametrize(
    ("text", "argument", "values"),
    [
        ("Go to the kitchen, then to the study.", "goal", ["to the kitchen", "the study"]),
        ("Go to the kitchen and then to the study and then back to the hall.", "goal", ["to the kitchen", "the study"]),
        ("Put the apple on the desk, then on the couch.", "goal", ["on the desk", "the couch"]),
        ("Bring the apple to Tom, then to Anna.", "recipient", ["to Tom", "Anna"]),
    ],
)
def test_each_leg_of_a_way_is_an_order(interpreter: Interpreter, text: str, argument: str, values: list[str]) -> None:
    found = interpreter.interpret(text)

    assert [task.value(argument) for task in found.tasks][:2] == values
    assert len({task.type for task in found.tasks}) == 1


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("Go to the hall and then bring the cup to the study.", 2),
        ("Go to the kitchen, then tell Tom to come to the study.", 2),
        ("Take the cup from the table to the sink.", 1),
    ],
)
def test_what_is_no_further_leg(interpreter: Interpreter, text: str, count: int) -> None:
    assert len(interpreter.interpret(text).tasks) == count


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("Wait five minutes and then bring me the apple.", "'wait' is read as if once"),
        ("Check the oven every five minutes.", "'every so often' is read as if once"),
        ("Go to the kitchen again and again.", "'again and again' is read as if once"),
        ("Tell Tom, then Anna, that dinner is ready.", "only 'Tom' is heeded"),
    ],
)
def test_what_is_not_done_is_said(with_encoder: Interpreter, text: str, says: str) -> None:
    assert any(says in warning for warning in with_encoder.interpret(text).warnings)


@pytest.mark.parametrize("text", ["Put the cup on the table and the plate on the shelf.", "Tell Tom and Anna to come."])
def test_what_is_done_for_each_needs_no_warning(with_encoder: Interpreter, text: str) -> None:
    assert not with_encoder.interpret(text).warnings
