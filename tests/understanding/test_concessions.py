"""What is said to make no difference is no task, and what is ordered beside it is done either way."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.cues import find_cues
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.cases.concessions import concessions


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Whether there is or not, sweep the shed.", "Whether there is or not"),
        ("Whether or not it is, sweep the shed.", "Whether or not it is"),
        ("Try the tap, and whether it works or it doesn't, sweep the shed.", "whether it works or it does n't"),
        ("Sweep the shed whether it's raining or not, then rest.", "whether it 's raining or not"),
        ("No matter if she is, sweep the shed.", "No matter if she is"),
        ("Sweep the shed regardless of whether Lea comes.", "regardless of whether Lea comes"),
        ("Whether you find the key or not sweep the shed.", "Whether you find the key or not"),
        ("whether or not you can find the key bring me the saw", "whether or not you can find the key"),
        ("whether or not the stove's hot put the pie in", "whether or not the stove 's hot"),
        ("whether joe is in or out leave the mail there", "whether joe is in or out"),
    ],
)
def test_what_makes_no_difference_is_a_concession(parser: Parser, text: str, said: str) -> None:
    document = parser.parse(text)
    (found,) = concessions(document)
    assert " ".join(document.tokens[i].text for i in found) == said
    inside = [cue for cue in find_cues(document) if cue.first in found]
    assert [(cue.name, cue.first, cue.last) for cue in inside] == [("either_way", found[0], found[-1])]


@pytest.mark.parametrize(
    "text",
    [
        "See whether there is any soup or not.",
        "Ask Lea whether or not she's hungry.",
        "Depending on whether the pump is on or not, turn it off or on.",
        "I'm not sure whether it's shut or not.",
        "Let me know whether Lea is coming or not.",
        "Find out whether the gate is locked.",
        "If it's on or not quite off, turn it off.",
    ],
)
def test_what_is_asked_is_none(parser: Parser, text: str) -> None:
    assert concessions(parser.parse(text)) == ()


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("If there's any straw on the cart, take it down. Whether there is or not, sweep the shed.",
         [{"if": 1, "then": [2]}, 3]),
        ("If Lea is asleep, shut her door. No matter if she is, turn the radio off.", [{"if": 1, "then": [2]}, 3]),
        ("See if Lea's awake; if she is, bring her the juice, and whether she is or she isn't, open the blinds.",
         [{"if": [1, 2], "then": [3]}, 4]),
        ("Whether you find the mop or not, sweep the loft.", [1]),
        ("See whether there is any soup or not. If there isn't, fetch me some bread.", [{"if": [1, 2], "else": [3]}]),
        ("If the gate's open, close it, and if it isn't, tell me.", [{"if": [1, 3], "then": [2], "else": [4]}]),
    ],
)  # fmt: skip
def test_what_is_done_either_way_hangs_on_nothing(interpreter: Interpreter, text: str, flow: list[object]) -> None:
    assert interpreter.interpret(text).flow.to_json() == flow
