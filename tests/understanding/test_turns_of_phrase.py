"""Turns of phrase that open a case are read as plainer ones, word for word."""

from __future__ import annotations

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.speech.turns_of_phrase import plain_phrases


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("The minute the taxi comes , wake me", "Just when the taxi comes , wake me"),
        ("Call me the moment she lands", "Call me just when she lands"),
        ("Every time it beeps , open it", "Just when it beeps , open it"),
        ("Open the second drawer", None),
        ("At the moment the shed is shut", None),
        ("because it cries the moment I leave", None),
        ("the Instant Pot is hot", None),
        ("it annoys me every time I see it", None),
        ("Were he to object , leave", "Should he ever object , leave"),
        ("Were the hose to leak , tell me", "Should the hose ever leak , tell me"),
        ("Were you able to find it ? If not , stop", None),
        ("I think it 's on . If that 's true , stop it", "I think it 's on . If it 's then , stop it"),
        ("She says it 's on . If she 's wrong , stop", "She says it 's on . If it 's not , stop"),
        ("Is it on ? If that 's the case , stop it", None),
        ("In the absence of salt , call", "In case of no salt , call"),
        ("Go , but not unless it 's dry", "Go , but only if it 's dry"),
        ("Anything under ten , light it", "If under ten , light it"),
        ("Bring anything under the sink", None),
        ("Tea or milk ? For tea , boil it", "Tea or milk ? If tea , boil it"),
        ("For Ann , boil it", None),
        ("In the event he 's out , stop", "On condition that he 's out , stop"),
        ("In the event of rain , stop", None),
    ],
)
def test_phrases_are_replaced_word_for_word(said: str, meant: str | None) -> None:
    words = said.split(" ")
    found = plain_phrases(words)
    assert found == (None if meant is None else meant.split(" "))
    assert found is None or len(found) == len(words)


@pytest.mark.parametrize(
    "text",
    [
        "The second the timer goes, take the pie out.",
        "Were the hose to leak, turn off the pump.",
        "I think the gate is open. If that's the case, close it.",
    ],
)
def test_what_they_open_is_a_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}]


def test_who_is_wrong_denies_what_they_say(interpreter: Interpreter) -> None:
    text = "Ann reckons the pump is off; if she's right, start it, and if she's wrong, tell her."
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}]


def test_spans_and_values_keep_what_was_said(interpreter: Interpreter) -> None:
    found = interpreter.interpret("The minute the taxi comes, wake me.")
    assert found.text == "The minute the taxi comes, wake me."
    assert found.tasks[0].value("object") == "the taxi"
