"""What is carried out as less than it says is said so, and nothing is asked that was said."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Make me a coffee.", "'Make' is read as 'bring'"),
        ("If Tom is home, could you make him a sandwich?", "'make' is read as 'bring'"),
        ("Count the mugs on the counter.", "'Count' is read as 'look for'"),
        ("Tell Anna how many plates are in the sink.", "'how many plates are in the sink' is told without a number"),
        ("Order a taxi if the bus has left.", "'Order' is read as 'take'"),
        ("Bring me a coffee.", None),
        ("Make sure the tv is off.", None),
        ("Tell Anna that many plates are in the sink.", None),
    ],
)
def test_what_would_have_to_be_made_or_counted_is_warned_of(text: str, said: str | None) -> None:
    warnings = [w for w in Interpreter.load().interpret(text).warnings if "counted" in w or "nothing is made" in w]
    assert [warning.startswith(said or "") for warning in warnings] == [True] * (said is not None)


@pytest.mark.parametrize(
    "text",
    [
        "Lock the back door and set the alarm.",
        "See what the noise is.",
        "Find out whose turn it is.",
        "Go and see what it is, and close the door.",
    ],
)
def test_what_says_its_state_or_asks_openly_lacks_none(interpreter: Interpreter, text: str) -> None:
    assert not interpreter.interpret(text).missing


@pytest.mark.parametrize(
    ("text", "quoted"),
    [
        ("Don't open the window and turn on the tv.", "open the window"),
        ("Turn on the tv and don't open the window then close the door.", "open the window"),
        ("Never put the cup and the plate on the kitchen table, but bring me a pen.",
         "put the cup and the plate on the kitchen table"),
    ],
)  # fmt: skip
def test_a_warning_quotes_what_is_forbidden_and_no_more(interpreter: Interpreter, text: str, quoted: str) -> None:
    assert f"{quoted!r} is forbidden: a prohibition is not watched" in interpreter.interpret(text).warnings


def test_trying_again_is_said_to_be_no_task(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Switch the fan on, and if it doesn't work, try again.")

    assert "'try again' is no task: say what to do again" in found.warnings


def test_what_is_done_while_there_is_not_repeated(interpreter: Interpreter) -> None:
    assert not interpreter.interpret("Go to the kitchen and put the kettle on while you are there.").warnings


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("Wait five minutes and then bring me the apple.", "'wait' is read as if once"),
        ("Check the oven every five minutes.", "'every so often' is read as if once"),
        ("Go to the kitchen again and again.", "'again and again' is read as if once"),
        ("Tell Tom, then Anna, that dinner is ready.", "only 'Tom' is heeded"),
    ],
)
def test_what_is_not_done_is_said(text: str, says: str) -> None:
    assert any(says in warning for warning in Interpreter.load().interpret(text).warnings)


@pytest.mark.parametrize("text", ["Put the cup on the table and the plate on the shelf.", "Tell Tom and Anna to come."])
def test_what_is_done_for_each_needs_no_warning(text: str) -> None:
    assert not Interpreter.load().interpret(text).warnings
