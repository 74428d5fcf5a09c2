"""The case of somebody or something named is a check, be none of its words a task by itself."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.cases.certain_cases import certain_cases
from decomplex_bt.understanding.rules.cases.conditions import untold


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("If Lea's borrowed the drill, let me know.", "'s"),
        ("If the moon is out, shut the blinds.", "is"),
        ("Put the kettle on, and when she's brought the eggs in, boil two.", "'s"),
        ("Wipe the board only if there's nothing important on it.", "'s"),
        ("Shut the hatch as soon as she's gone to the cellar.", "'s"),
        ("Air the attic once Lea's left for work, and shut the hatch.", "'s"),
        ("Unless the paint has dried, leave the window open.", "has"),
    ],
)
def test_an_untold_case_is_a_check(parser: Parser, text: str, word: str) -> None:
    document = parser.parse(text)
    assert [document.tokens[i].text for i in untold(document, {})] == [word]


@pytest.mark.parametrize(
    ("text", "tasks"),
    [
        ("If the moon is out, shut the blinds.", {"out": "check_state"}),
        ("If it's not too much trouble, shut the blinds.", {}),
        ("Should the second attempt be in vain, or if that attempt is in vain, stop.", {}),
        ("Tell Lea, if the bus is late, to wait.", {"Tell": "informing"}),
        ("See if the moon is out.", {"See": "check_state"}),
        ("If there's no sign of it, go on.", {}),
        ("If there is nothing to sort out, go on.", {}),
        ("If you're done, come here.", {}),
        ("Shut the hatch as soon as it's gone six.", {}),
        ("Shut the hatch as soon as you've left.", {}),
        ("Shut the hatch as soon as she's ready.", {}),
        ("Shut the hatch after she's gone.", {"gone": "check_state"}),
        ("In the case that the search fails, ring the bell.", {}),
    ],
)
def test_no_untold_case(parser: Parser, text: str, tasks: dict[str, str]) -> None:
    document = parser.parse(text)
    told = {token.i: tasks[token.text] for token in document.tokens if token.text in tasks}
    assert untold(document, told) == frozenset()


@pytest.mark.parametrize(
    ("text", "verbs"),
    [
        ("Tell Lea in the event that the pump is not running.", ["is"]),
        ("Call me in the case that Lea wakes up.", ["wakes"]),
        ("On condition that you cannot lift the crate, ask Tim.", ["lift"]),
        ("Supposing the pipes are frozen, fetch the lamp.", ["are"]),
        ("Ring the bell so long as nobody is asleep.", ["is"]),
        # no case is opened
        ("Lea says she may stay up so long as it isn't late.", []),
        ("Lay the flute in the case that is open.", []),
        ("Tell Lea of the event that starts at six.", []),
        ("So long as you're in the attic, fetch the lamp.", []),
        ("Use the brush they provided.", []),
        ("I'm assuming the oats are dry. Fetch them.", []),
        ("Look in the case of the flute.", []),
        ("If the pipes are frozen, fetch the lamp.", []),
    ],
)
def test_more_than_an_if_opens_a_case_for_certain(parser: Parser, text: str, verbs: list[str]) -> None:
    document = parser.parse(text)
    assert [document.tokens[case.verb].text for case in certain_cases(document)] == verbs


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Inform Lea in the event that the pump is not running.", [{"if": 2, "else": [1]}]),
        ("Notify Tim on the condition that the crate has come.", [{"if": 2, "then": [1]}]),
        ("Turn on the radio so long as nobody is sleeping.", [{"if": 2, "else": [1]}]),
        ("Tell Tim that the pump is not running.", [1]),
        ("Tell me if the pump is on, and shut the hatch.", [1, 2]),
        ("Lay the flute in the case that Lea bought.", [1]),
    ],
)
def test_what_is_told_in_a_case_is_no_message(text: str, flow: list[object]) -> None:
    found = Interpreter.load().interpret(text)
    assert found.flow.to_json() == flow
    if len(flow) == 1 and flow != [1]:
        assert found.tasks[0].value("message") is None


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("If she doesn't want it give it to Lea.", "want"),
        ("If my aunt does not care for pears, bring her the plums.", "care"),
        ("Unless the twins don't mind, shut the blinds.", "mind"),
    ],
)
def test_what_somebody_does_not_do_needs_no_mark(parser: Parser, text: str, word: str) -> None:
    document = parser.parse(text)
    orders = {t.i: "bringing" for t in document.tokens if t.lower in ("give", "bring", "shut")}
    assert [document.tokens[i].text for i in untold(document, orders)] == [word]


@pytest.mark.parametrize(
    "text",
    [
        "If it doesn't matter, bring her the plums.",
        "If you don't mind, bring her the plums.",
        "If the first attempt doesn't work, bring her the plums.",
        "Ask Lea, if she doesn't want it, to bring the plums.",
    ],
)
def test_what_is_said_by_the_way_is_no_case(parser: Parser, text: str) -> None:
    document = parser.parse(text)
    orders = {
        t.i: "informing" if t.lower == "ask" else "bringing" for t in document.tokens if t.lower in ("ask", "bring")
    }
    assert untold(document, orders) == frozenset()


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("I've no idea whether there's any wax. If not, tell Lea.", "'s"),
        ("Not sure if the hatch is shut; if so, open it.", "is"),
    ],
)
def test_what_nobody_knows_is_a_check_where_an_order_goes_by_it(parser: Parser, text: str, word: str) -> None:
    document = parser.parse(text)
    orders = {t.i: "informing" for t in document.tokens if t.lower in ("tell", "open")}
    assert [document.tokens[i].text for i in untold(document, orders)] == [word]


def test_who_does_not_want_what(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If she doesn't want it, give it to me.")
    assert found.tasks[0].value("object") == "she"
    assert found.to_json()["flow"] == [{"if": 1, "else": [2]}]


def test_what_there_may_be(interpreter: Interpreter) -> None:
    found = interpreter.interpret("I've no idea whether there's wax. If not, call Kim.")
    assert found.tasks[0].value("object") == "wax"
    assert found.to_json()["flow"] == [{"if": 1, "else": [2]}]


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("Hand us the rope once I'm through the gap.", "'m"),
        ("Dim the lamp once I've gone to bed.", "gone"),
        ("If there happens to be a leak, tell Lea.", "be"),
    ],
)
def test_what_the_speaker_waits_for_or_happens_to_be_so_is_a_check(
    interpreter: Interpreter, text: str, word: str
) -> None:
    tasks = interpreter.interpret(text).tasks
    assert [task.span.of(text) for task in tasks if task.type == "check_state"] == [word]


@pytest.mark.parametrize("text", ["Tell Lea I'll call when I'm home.", "When I was a girl we had a stove."])
def test_what_is_told_or_was_once_is_none(interpreter: Interpreter, text: str) -> None:
    assert all(task.type != "check_state" for task in interpreter.interpret(text).tasks)


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("If my flask has been rinsed, fill it.", ["check_state", "change_state"]),
        ("See if the cups have been rinsed, and if not, rinse them.", ["check_state", "change_state"]),
        ("If he did eat it all just bring the tray.", ["check_state", "bringing"]),
        ("If it's Lea bringing the eggs, let her in.", ["check_state", "change_state"]),
    ],
)
def test_what_was_done_or_is_being_done_is_one_check(interpreter: Interpreter, text: str, types: list[str]) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == types


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Bolt the hatch when Uncle's gone.", [{"if": 2, "then": [1]}]),
        ("Air the attic when she's left.", [{"if": 2, "then": [1]}]),
        ("Open the dryer when it's finished.", [{"if": 2, "then": [1]}]),
        ("Dim the lamp when they're gone, please.", [{"if": 2, "then": [1]}]),
        ("When I'm done, put the jar away.", [{"if": 1, "then": [2]}]),
        ("Take the basin away when I'm done.", [{"if": 2, "then": [1]}]),
        ("When I've finished with it, rinse the brush.", [{"if": 1, "then": [2]}]),
        ("When I shout, lower the rope.", [{"if": 1, "then": [2]}]),
        ("Fetch me the soap when I call you.", [{"if": 2, "then": [1]}]),
        ("Let me know when he's gone.", [1]),
        ("When you're done, air the attic.", [1]),
        ("Air the attic when that's done.", [1]),
    ],
)
def test_who_has_gone_or_is_done_or_calls_is_waited_for(interpreter: Interpreter, text: str, expected: object) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == expected


@pytest.mark.parametrize(
    ("text", "of"),
    [("Take the basin away when I'm done.", ("I", "done")), ("When I shout, lower the rope.", ("I", None))],
)
def test_who_is_done_or_calls(interpreter: Interpreter, text: str, of: tuple[str, str | None]) -> None:
    check = next(task for task in interpreter.interpret(text).tasks if task.type == "check_state")
    assert (check.value("object"), check.value("state")) == of


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Roll up the rug after the paint dries.", [2, 1]),
        ("Rinse the pan, then pour the sauce in after it cools.", [1, 3, 2]),
        ("Dim the lamp after they arrive.", [2, 1]),
        ("Air the tent after it stops and shut the hatch.", [2, 1, 3]),
        ("Rinse the pan after you dry it.", [2, 1]),
        ("Tell me after the film ends.", [1]),
        ("Dust the attic after supper.", [1]),
    ],
)
def test_what_happens_by_itself_is_waited_for(interpreter: Interpreter, text: str, expected: object) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == expected
