"""Who is told something in somebody's place, or as well, is told the same."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("Inform the caretaker that the lift is stuck; if he's at lunch, inform the porter.", "that the lift is stuck"),
        ("ask paul to walk the dog and if hes still asleep ask rita", "to walk the dog"),
        ("If Jo is in the garden, tell her the kettle is on; otherwise tell Max.", "the kettle is on"),
        ("Let my wife know the bath is free; if she doesn't hear you, tell the kids.", "the bath is free"),
        ("Let Nina know that the bus is here, and if you can't find her, tell Omar.", "that the bus is here"),
        ("Tell Sven the film is starting, and then tell Olga too.", "the film is starting"),
    ],
)
def test_who_is_told_in_somebodys_place_is_told_the_same(interpreter: Interpreter, text: str, message: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("message") == message


@pytest.mark.parametrize(
    "text",
    [
        "Ask Leo what he wants for supper and tell Nora.",
        "Tell Ben that lunch is ready, and if he says no, tell Clara.",
        "Tell Ben that lunch is ready, and if he's out, tell me.",
        "Tell Ben that lunch is ready, look in the shed, and if nobody's there, tell Clara.",
        "Tell Ben that lunch is ready, and if you find the dog, tell Clara.",
    ],
)
def test_what_was_found_out_in_between_may_be_what_is_told(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("message") is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("Tell mum the parcel came, then tell it to dad.", "the parcel came"),
        ("Inform the guests that the taxi is here and tell the driver that as well.", "that the taxi is here"),
        ("If Leo is up, tell him lunch is served. If Mia is up, tell her that too.", "lunch is served"),
        ("Ask Ann her name and tell it to me.", "her name"),  # not what was said, but what is asked for
        ("Tell Ann the truth. Get the letter and read it to Ben.", "the letter"),
    ],
)
def test_it_is_what_was_told_just_before(interpreter: Interpreter, text: str, message: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("message") == message


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Take this gauge to Ravi. Once it beeps, read it.", None),
        ("Take the tablet to Nadia. When it rings, answer it.", None),
        ("Take the letter to Nadia and read it to her.", "Nadia"),
    ],
)
def test_what_beeps_is_read_to_nobody(text: str, value: str | None, encoder: bool) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("recipient") == value
