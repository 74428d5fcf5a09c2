"""Forbidden verbs are no tasks, and what nobody named is asked for."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.orders.prohibitions import is_elided, lifts


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


@pytest.mark.parametrize(
    ("text", "verb", "tasks"),
    [
        ("Don't open the window.", "open", []),
        ("You must not touch the lamp.", "touch", []),
        ("Never turn off the fridge. Bring me a pen.", "turn", ["Bring"]),
        ("Close the door and do not wash the cup.", "wash", ["Close"]),
        ("Never boil or fry the eggs. Bring me a pen.", "boil", ["Bring"]),
        ("Without opening the fridge, bring me the juice.", "opening", ["bring"]),
        ("Don't wake Anna, but if she's already up, bring her the tea.", "wake", ["'s", "bring"]),
        ("Don't open the hatch even if somebody rings, and shut the gate.", "open", ["shut"]),
        ("Even when it's dark, don't light the lamp. Bring me a pen.", "light", ["Bring"]),
        ("Don't empty the bin; if it's full, tell me.", "empty", ["'s", "tell"]),
        ("If the pie is done, take it out, otherwise don't open the oven.", "open", ["is", "take"]),
        ("Could you please not open the gate, but do shut the window?", "open", ["shut"]),
        ("Would you mind not opening the gate? Bring me a pen.", "opening", ["Bring"]),
        ("Can you not open the gate but light the lamp?", "open", ["light"]),
        ("You'd better not open the gate. Shut the window.", "open", ["Shut"]),
        ("You had better not open the gate. Shut the window.", "open", ["Shut"]),
        ("Better not open the gate. Shut the window.", "open", ["Shut"]),
        ("Sweep the hall, but best not open the gate.", "open", ["Sweep"]),
        ("The hinge is loose, so better not open the gate. Shut the window.", "open", ["Shut"]),
        ("Let's not open the gate. Shut the window.", "open", ["Shut"]),
        ("Try not to open the gate, please, and shut the window.", "open", ["shut"]),
        ("Don't give the dog any cake, but if he's hungry, you may bring him a biscuit.", "give", ["'s", "bring"]),
    ],
)
def test_a_prohibition_is_no_task_and_is_warned_of(
    interpreter: Interpreter, text: str, verb: str, tasks: list[str]
) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(text) for task in found.tasks] == tasks
    assert any(f"'{verb}" in warning and "prohibition" in warning for warning in found.warnings)


@pytest.mark.parametrize(
    ("text", "tasks"),
    [
        ("Don't only close the door, close the window too.", ["close", "close"]),
        ("Do not just rinse the pan, scrub it as well.", ["rinse", "scrub"]),
        ("You don't need to wash the cup, just bring it.", ["bring"]),
        ("No need to wash the cup, just bring it.", ["bring"]),
        ("It isn't necessary to wash the cup, bring it instead.", ["bring"]),
        ("You needn't empty the bin, just close the door.", ["close"]),
        ("Don't forget to close the door.", ["close"]),
        ("Don't have a look in the drawer.", []),
        ("Rather than washing the pan, put it in the sink.", ["put"]),
        ("Rather than turn off the tv, mute it.", ["mute"]),
        ("Fold the towel instead of hanging it up.", ["Fold"]),
        ("Don't start the oven before the pan is in it.", ["start", "is"]),
        ("I feel better not having the radio on, so turn it off.", ["turn"]),
        ("Not.", []),
    ],
)
def test_what_is_done_all_the_same_and_what_is_not(interpreter: Interpreter, text: str, tasks: list[str]) -> None:
    found = interpreter.interpret(text)
    assert [task.span.of(text) for task in found.tasks] == tasks
    assert not any("need" in warning or "wash" in warning for warning in found.warnings)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Don't put the jacket in the closet, hang it on the chair.",
            {("object", "the jacket"), ("goal", "on the chair")},
        ),
        ("Don't turn the radio off, dust it.", {("object", "the radio")}),
    ],
)
def test_the_words_of_what_is_forbidden_are_no_other_tasks(
    interpreter: Interpreter, text: str, expected: set[tuple[str, str]]
) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert {(a.type, a.value) for a in task.arguments} == expected


@pytest.mark.parametrize(
    "text",
    [
        "Don't open the window unless the oven is hot.",
        "Why don't you bring me a pen?",
        "Don't open it, but if it's hot, do.",
    ],
)
def test_what_is_forbidden_only_under_a_condition_or_asked_politely_stays(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    assert found.tasks
    assert not any("prohibition" in warning for warning in found.warnings)


def test_an_unnamed_thing_is_asked_for_and_never_the_place_it_goes_to(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Put it on the table.")
    assert [(m.task, m.argument) for m in found.missing] == [(1, "object")]


@pytest.mark.parametrize(
    "text",
    [
        "Don't wash the rug, but if it's muddy, do.",
        "Don't wash the rug; if it's muddy, though, do.",
        "Don't wash the rug. If it's muddy, you may.",
        "Don't wash the rug but if it's muddy do.",
        "You needn't wash the rug, but if it's muddy, do so.",
        "You don't have to wash the rug, but if it's muddy, go ahead.",
    ],
)
def test_what_is_allowed_after_all_is_done_in_that_case(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    check, wash = found.flow.nodes[0].tasks[0], found.flow.nodes[0].then[0].tasks[0]  # type: ignore[union-attr]
    assert (found.task(check).type, found.task(wash).span.of(text)) == ("check_state", "wash")
    assert not found.warnings


@pytest.mark.parametrize(
    "text",
    [
        "Don't wash the rug, but if it's muddy, do tell me.",
        "Don't wash the rug; if it's muddy, tell me, ok.",
        "Don't wash the rug. If it's muddy, tell me.",
        "Don't wash the rug, but tell me if the boys do.",
    ],
)
def test_another_order_in_a_case_lifts_no_prohibition(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    assert "wash" not in [task.span.of(text) for task in found.tasks]
    assert any("'wash" in warning for warning in found.warnings)


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Lift the crate. If it's too heavy, leave it.", [{"if": 2, "else": [1]}]),
        ("Take the bench outside, and if it's wet, leave it.", [{"if": 2, "else": [1]}]),
        ("Open the hatch and if it is stuck, leave it.", [{"if": 2, "else": [1]}]),
        ("Lift the crate. If it's too heavy, leave it by the door.", [1, {"if": 2, "then": [3]}]),
        ("Take the cake to the porch and leave it there.", [1, 2]),
    ],
)
def test_what_is_left_in_a_case_is_not_done_in_it(interpreter: Interpreter, text: str, flow: list[object]) -> None:
    assert interpreter.interpret(text).flow.to_json() == flow


@pytest.mark.parametrize(
    ("text", "is_said"),
    [
        ("Play the radio, and if Gran's in there don't, just shut the door.", True),
        ("Light the lamp, but if it's day, then don't.", True),
        ("Mow the lawn, and if it's wet please don't.", True),
        ("If they don't, play the radio.", False),
        ("If the boys who are upstairs don't, call them.", False),
        ("If it's wet, don't mow the lawn.", False),
        ("Don't. Play the radio.", False),
    ],
)
def test_a_dont_may_say_no_verb(text: str, is_said: bool) -> None:
    document = Parser().parse(text)
    assert any(is_elided(document, i) for i in range(len(document))) == is_said


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Play the radio in the den, and if Gran's in there don't, just shut the door.",
         [{"if": 2, "then": [3], "else": [1]}]),
        ("Wake Lea if it's late, otherwise don't go in, and feed the hens.", [{"if": 2, "then": [1]}, 3]),
        ("Tell Lea I'm out if she calls, otherwise don't say a word, and fold my coat.", [{"if": 2, "then": [1]}, 3]),
        ("Air the room if it's stuffy, otherwise don't bother, and fold my coat.", [{"if": 2, "then": [1]}, 3]),
        # done in the other case
        ("Wake Lea if it's late, otherwise go out and feed the hens.", [{"if": 2, "then": [1], "else": [3, 4]}]),
        ("If the soup is hot, serve it, otherwise don't serve it but heat it up.",
         [{"if": 1, "then": [{"same": [2, 3]}], "else": [4]}]),
    ],
)  # fmt: skip
def test_what_stands_beside_a_mere_dont(text: str, flow: list[object]) -> None:
    assert Interpreter.load().interpret(text).flow.to_json() == flow


@pytest.mark.parametrize(
    ("text", "start", "wanted"),
    [
        ("Don't open the oven, but if it's hot, do.", "if", True),
        ("Don't open the oven, but if it's hot, tell me.", "if", False),
        ("Don't open the oven if -- then.", "then", False),  # nothing is said but what stands beside
        ("Close the den. , !", ",", False),  # ... and nothing but marks
    ],
)
def test_only_what_is_said_lifts_a_prohibition(text: str, start: str, wanted: bool) -> None:
    document = Parser().parse(text)
    at = max(token.i for token in document.tokens if token.lower == start)
    assert lifts(document, at) is wanted


def test_a_case_that_breaks_off_is_read() -> None:
    text = (
        "As long as the den. free, heat it up, unroll the bath beside the tub shutters my robe on the grab bar. If it's"
        " occupied, come back the bathroom's"
    )
    assert Interpreter.load("household").interpret(text).text == text
