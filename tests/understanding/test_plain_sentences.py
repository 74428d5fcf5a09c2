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
    (
        "I need my {thing}. If it isn't {place}, ask {person}.",
        [{"if": 2, "then": [1], "else": [3]}],
        ["my {thing}"] * 2,
    ),
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
    ("Look for the {thing}. Call me if you can't find it.", [{"if": [1, 3], "else": [2]}], []),
    ("Close the {opening} and call {person} if you can't close it.", [{"if": [1, 3], "else": [2]}], []),
    ("Bring me the {thing} and call {person} if you can't find it.", [{"if": [1, 3], "else": [2]}], []),
    ("If the {opening} doesn't quite close, call me.", [{"if": 1, "else": [2]}], []),
    (
        "Take the {thing} to {person} and leave it on the table if she's not there.",
        [{"if": 3, "then": [1], "else": [2]}],
        [],
    ),
    ("Close the {opening} if it's open. If you can't, call me.", [{"if": 2, "then": [{"if": 1, "else": [3]}]}], []),
    (
        "If {person} is thirsty, bring her a beer, and if there isn't any, bring her water.",
        [{"if": 1, "then": [{"if": 3, "then": [2], "else": [4]}]}],
        [],
    ),
    (
        "If the {opening} is closed, open it, or call me if you can't.",
        [{"if": 1, "then": [{"if": 2, "else": [3]}]}],
        [],
    ),
    ("The {device} is on isn't it? Turn it off.", [{"if": 1, "then": [2]}], []),
    ("Isn't the {opening} open? If so close it.", [{"if": 1, "then": [2]}], []),
    ("Wash the {thing}. Don't if it's wet.", [{"if": 2, "else": [1]}], []),
    ("Bring me the {thing} if it's clean. If not, wash it first.", [{"if": 2, "else": [3]}, 1], []),
    ("Turn off the {device}. If {person} is asleep, leave it on.", [{"if": 2, "then": [3], "else": [1]}], []),
    ("If the {thing} isn't dry, hang it up or put it in the dryer.", [{"if": 1, "else": [{"if": 2, "else": [3]}]}], []),
    ("Open the {opening} if it's warm, but close it if it's cold.", [{"if": [2, 4], "then": [1], "else": [3]}], []),
    ("If the {thing} is dirty, don't bring it. Wash it first.", [{"if": 1, "then": [3]}, 2], []),
    (
        "If the {device} is on, turn it off. If it's smoking, call me.",
        [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        [],
    ),
    (
        "If the {device} is too loud, turn it down. If it's too quiet, turn it up.",
        [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        [],
    ),
    ("Is the {opening} open? Close it if it is, and turn the {device} on.", [{"if": [1, 3], "then": [2]}, 4], []),
    (
        "If the {device} is on, turn it off, and close the {opening} if it's open.",
        [{"if": 1, "then": [2]}, {"if": 4, "then": [3]}],
        [],
    ),
    ("Turn off the {device} if nobody is in the {room}, and close the {opening}.", [{"if": 2, "else": [1]}, 3], []),
    ("Close the {opening} if it's open, will you? Feed the cat.", [{"if": 2, "then": [1]}, 3], []),
    ("Leave the {device} on but close the {opening} if nobody's there.", [1, {"if": 3, "else": [2]}], []),
    ("Take this letter to {person}; if she's asleep, bring it back.", [1, {"if": 2, "then": [3]}], []),
    ("Keep an eye on the toast and take it out when it's brown.", [1, {"if": 3, "then": [2]}], []),
    ("Bring me the {thing}. If it's dirty, bring me a sweater, please.", [{"if": 2, "then": [3], "else": [1]}], []),
    ("Close the {opening} when {person} has gone.", [{"if": 2, "then": [1]}], []),
    ("Close the {opening} when she's gone.", [{"if": 2, "then": [1]}], []),
    ("When I'm done, take the {thing} away.", [{"if": 1, "then": [2]}], []),
    ("Feed the dog, then the cat, and finally the fish.", [1], []),
    ("Heat the soup until it's hot, then bring it to me.", [1, 2, 3], []),
    ("Open the {opening}, no, close it.", [1], []),
    ("Wait for {person} to leave, then vacuum the hall.", [1, 2], []),
    ("Take the {thing} out of the oven and turn it off.", [1, 2], ["the {thing}", "the oven"]),
    (
        "Bring me a {thing}. The big one if it's clean, otherwise the small one.",
        [{"if": 2, "then": [1], "else": [3]}],
        ["the big {thing}"] * 2 + ["the small {thing}"],
    ),
    ("When dark, turn the {device} on.", [{"if": 1, "then": [2]}], [None, "the {device}"]),
    ("Wash the {thing} when dirty.", [{"if": 2, "then": [1]}], ["the {thing}"] * 2),
    ("What I want is the {thing}, and then close the {opening}.", [1, 2], ["the {thing}", "the {opening}"]),
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
