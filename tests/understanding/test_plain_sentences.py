"""Plain sentences: one frame for each way to join orders and conditions, filled with things of the house, whose flow
and things are known by construction."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter

_WORDS = {
    "thing": "mug plate pen book letter parcel phone laptop cushion blanket jacket towel umbrella".split(),
    "device": "lamp heater radio fan".split(),
    "opening": "door window curtain gate".split(),
    "place": ["on the desk", "on the shelf", "in the drawer", "in the cupboard", "on the sofa", "under the bed"],
    "room": "kitchen bathroom bedroom office hallway garage".split(),
    "person": ["Anna", "my wife", "grandma", "the nurse"],
}
_FILLINGS = 4
"""How often a frame is filled anew."""
_IF = [{"if": 1, "then": [2]}]
_FRAMES: list[tuple[str, Any, list[str | None]]] = [
    ("The {device} is on. Turn it off.", [1], ["the {device}"]),
    ("The {opening} in the {room} is open. Close it and bring me the {thing}.", [1, 2], [None, "the {thing}"]),
    ("The {device} is on and the {opening} is open. Close the {opening}.", [1], ["the {opening}"]),
    ("The {thing} is {place}. Bring it to {person}.", [1], ["the {thing}"]),
    ("I can't find my {thing}. Look {place}.", [1], ["my {thing}"]),
    ("If the {device} is on, turn it off.", _IF, ["the {device}", "the {device}"]),
    ("Turn the {device} on if the {opening} is closed.", [{"if": 2, "then": [1]}], ["the {device}", "the {opening}"]),
    ("Unless the {opening} is closed, close it and come back.", [{"if": 1, "else": [2, 3]}], ["the {opening}"] * 2),
    ("Wash the {thing} unless the {device} is on.", [{"if": 2, "else": [1]}], ["the {thing}", "the {device}"]),
    ("If it is raining, close the {opening}, otherwise open it.", [{"if": 1, "then": [2], "else": [3]}], [None]),
    (
        "If the {thing} isn't {place}, turn the {device} on. Otherwise, close the {opening}.",
        [{"if": 1, "then": [3], "else": [2]}],
        ["the {thing}", "the {device}", "the {opening}"],
    ),
    (
        "If nobody is in the {room}, close the {opening}. If somebody is, turn the {device} on.",
        [{"if": [1, 3], "then": [4], "else": [2]}],
        [],
    ),
    (
        "If there's no {thing} {place}, call {person}, otherwise bring it to me.",
        [{"if": 1, "then": [3], "else": [2]}],
        ["{thing}"],
    ),
    (
        "Is the {thing} {place}? If so, bring it to {person}. If not, turn the {device} off.",
        [{"if": 1, "then": [2], "else": [3]}],
        ["the {thing}", "the {thing}", "the {device}"],
    ),
    (
        "Check whether the {device} is on. If it is, turn it off.",
        [{"if": [1, 2], "then": [3]}],
        ["the {device}"] * 3,
    ),
    (
        "Look for my {thing} in the {room}. If you can't find it, call {person}.",
        [{"if": [1, 2], "else": [3]}],
        ["my {thing}", "my {thing}"],
    ),
    (
        "Go to the {room} and look for my {thing}. If you find it, bring it to me.",
        [1, {"if": [2, 3], "then": [4]}],
        [None, "my {thing}", "my {thing}", "my {thing}"],
    ),
    (
        "Go to the {room} and look for my {thing}. If you can't find it, tell {person}.",
        [1, {"if": [2, 3], "else": [4]}],
        [None, "my {thing}", "my {thing}"],
    ),
    (
        "Bring me the {thing} if it's raining or a hat if it's sunny.",
        [{"if": 2, "then": [1], "else": [{"if": 4, "then": [3]}]}],
        ["the {thing}", None, "a hat", None],
    ),
    (
        "Turn on the {device} if {person} is up, or the oven if {person} is out.",
        [{"if": 2, "then": [1], "else": [{"if": 4, "then": [3]}]}],
        ["the {device}", None, "the oven", None],
    ),
    ("I need my {thing}. If it isn't {place}, ask {person}.", [{"if": [1, 2], "else": [3]}], ["my {thing}"] * 2),
    ("If you don't know where the {thing} is, ask {person}.", [{"if": 1, "else": [2]}], ["the {thing}"]),
    ("Wash the {thing} if it's dirty, else leave it.", [{"if": 2, "then": [1]}], ["the {thing}"] * 2),
    ("Close the {opening} if it's cold, otherwise leave it.", [{"if": 2, "then": [1]}], ["the {opening}"]),
    ("Close the {opening}, but leave it if {person} is up.", [{"if": 2, "else": [1]}], ["the {opening}"]),
    ("If dirty, wash the {thing}.", [{"if": 1, "then": [2]}], ["the {thing}"] * 2),
    ("Unless closed, close the {opening}.", [{"if": 1, "else": [2]}], ["the {opening}"] * 2),
    ("Check whether you see the {thing}. If so, bring it to me.", _IF, ["the {thing}", "the {thing}"]),
    ("Could you check if my {thing} is {place} and if so bring it here?", _IF, ["my {thing}", "my {thing}"]),
    ("Take the {thing} to the {room}, then close the {opening}, and call {person}.", [1, 2, 3], ["the {thing}"]),
    ("Before you close the {opening}, turn the {device} off.", [2, 1], ["the {opening}", "the {device}"]),
    ("After you wash the {thing}, put it {place}.", [1, 2], ["the {thing}", "the {thing}"]),
    ("Once you have washed the {thing}, put it {place}.", [1, 2], ["the {thing}", "the {thing}"]),
    ("Close the {opening}. If the {device} is on, turn it off.", [1, {"if": 2, "then": [3]}], ["the {opening}"]),
    (
        "Turn the {device} on only if the {opening} is closed, and wash the {thing} in any case.",
        [{"if": 2, "then": [1]}, 3],
        ["the {device}", "the {opening}", "the {thing}"],
    ),
    (
        "If the {device} is on, turn it off. Either way, close the {opening}.",
        [{"if": 1, "then": [2]}, 3],
        ["the {device}", "the {device}", "the {opening}"],
    ),
    (
        "If the {opening} is open, close it, else if the {device} is on, turn it off, else call {person}.",
        [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4], "else": [5]}]}],
        ["the {opening}", "the {opening}", "the {device}", "the {device}"],
    ),
    ("Don't turn the {device} off. Just close the {opening}.", [1], ["the {opening}"]),
    ("Would you mind if I asked you to close the {opening}? And then wash the {thing}.", [1, 2], ["the {opening}"]),
]
"""Each frame with its flow and the things of its first tasks, None where any will do."""


@pytest.mark.parametrize(("frame", "expected", "things"), _FRAMES, ids=[frame for frame, _, _ in _FRAMES])
def test_plain_sentences(interpreter: Interpreter, frame: str, expected: Any, things: list[str | None]) -> None:
    rng = np.random.default_rng(7)
    for _ in range(_FILLINGS):
        filling = {slot: words[rng.integers(len(words))] for slot, words in _WORDS.items()}
        text = frame.format(**filling)
        text = text[0].upper() + text[1:]
        assert flow(interpreter, text) == expected, text
        tasks = interpreter.interpret(text).tasks
        named = [thing and thing.format(**filling) for thing in things]
        for task, thing in zip(tasks, named, strict=False):
            values = [a.value.lower().removeprefix("for ") for a in task.arguments if a.type == "object"]
            assert thing is None or values == [thing], text
