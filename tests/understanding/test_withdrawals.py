"""Orders that are taken back are no tasks; those taken back in one case only are left to the flow."""

from __future__ import annotations

import pytest

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.speech.withdrawals import Withdrawals, withdrawals_of

GAZETTEER = Gazetteer({}, {}, frozenset())


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


def withdrawals(parser: Parser, text: str) -> tuple[str, list[str]]:
    """The words that are taken back and the phrases that correct others."""
    document = parser.parse(text)
    found: Withdrawals = withdrawals_of(Observed(document, GAZETTEER))
    words = " ".join(document.tokens[i].text for i in sorted(found.tokens))
    return words, [document.span(c.start, c.stop - 1).of(text) for c in found.corrections]


def tasks(instruction: Instruction) -> list[str]:
    return [task.span.of(instruction.text) for task in instruction.tasks]


@pytest.mark.parametrize(
    ("text", "taken_back"),
    [
        ("Close the door. Actually, scratch that. Open the window.", "Close the door . Actually , scratch that"),
        ("Water the ferns, no, forget that, water the roses.", "Water the ferns , no , forget that"),
        ("Turn on the lamp no scratch that turn on the fan", "Turn on the lamp no scratch that"),
        ("Bring me a beer. Never mind.", "Bring me a beer . Never mind"),
        (
            "Bring the monitor. No, leave that where it is, bring me a scarf.",
            "Bring the monitor . No , leave that where it is",
        ),
        ("Turn on the lamp. No, don\u2019t.", "Turn on the lamp . No , do n't"),
        (
            "run the bath no scratch that it's late now get the towels and if they're wet dry them",
            "run the bath no scratch that",
        ),
    ],
)
def test_what_is_taken_back(parser: Parser, text: str, taken_back: str) -> None:
    assert withdrawals(parser, text) == (taken_back, [])


@pytest.mark.parametrize(
    ("text", "taken_back"),
    [
        (
            "Wash the cups and close the blinds, no, scratch that, open the blinds.",
            "close the blinds , no , scratch that",
        ),
        ("Go out, get a plate, and open the gate. Scratch that last one.", "open the gate . Scratch that last one"),
        (
            "Sweep the step, light that candle, actually no, don't, it smells.",
            "light that candle , actually no , do n't",
        ),
        ("Wax the floor? No, better not, just sweep it.", "Wax the floor ? No , better not"),
        ("Ring Maud and open the gate. On second thoughts, best not.", "open the gate . On second thoughts , best not"),
        ("Turn up the radio, no, perhaps not, and shut the door.", "Turn up the radio , no , perhaps not"),
        ("Light the stove. Hm, maybe not. Bring a rug.", "Light the stove . Hm , maybe not"),
        ("Sweep the loft, or maybe you'd better not.", "Sweep the loft , or maybe you 'd better not"),
    ],
)
def test_of_several_orders_the_last_one_is_taken_back(parser: Parser, text: str, taken_back: str) -> None:
    assert withdrawals(parser, text) == (taken_back, [])


@pytest.mark.parametrize(
    ("text", "taken_back"),
    [
        ("Iron my shirt. Oh, never mind the shirt. Bring me a tie.", "Iron my shirt never mind"),
        ("Sweep the step, hoover the stairs, no, forget the stairs, and wipe it.", "hoover the stairs forget"),
        ("Vacuum the carpet, then roll it up. Never mind the carpet.", "Vacuum the carpet roll it up Never mind"),
        ("Go in and look for my keys. Never mind the keys.", "look for my keys Never mind"),
    ],
)
def test_what_is_taken_back_by_what_it_is_about(parser: Parser, text: str, taken_back: str) -> None:
    assert withdrawals(parser, text) == (taken_back, [])


@pytest.mark.parametrize(
    "text",
    [
        "Bring me the soup. If it is cold, forget that.",
        "Close the door and never mind the noise.",
        "Bring me the book that I never mind reading.",
        "Open the window and ignore that smell.",
        "Hang the coats up, forget that old jacket, and sweep the hall.",
        "Water the plants, and scratch that label off the jar.",
        "Turn off the oven. Forget that it was ever on.",
        "Fetch the ladder. Oh wait, it's in the shed. Bring it in.",
        "Bring me tea. Actually, I would like it without milk. Put lemon in instead.",
        "Put the soup on the stove. Wait, it needs salt. Put in pepper instead of salt.",
        "Bring the cake to the table. Wait, there is no plate. Use the tray instead.",
        "Bring the milk and the eggs in, and don't forget the milk.",
        "Take out the cake before I forget the cake.",
        "Mop the floor but don't scratch that.",
        "Tell Anna to forget that. Then close the door.",
        "Close the window, tell Jonas never mind the window.",
        "Wash the blue mug, and forget the red mug.",
        "Bring me the book with the red cover, forget the cover.",
        "Fold the towels; never mind the towels in the dryer.",
        "Empty the bin. Never mind the bin if it is empty.",
        "The timer is on. Cancel that.",
        "Inspect the carton. Full, forget it. Empty, toss it out.",
        "Wash the car. Oh, and leave it in the garage.",
        "Look for my glasses and my watch. Forget the glasses, I've got them on.",
        "Wash the shirt and the socks. Never mind the socks.",
        "Bring me tea. No sugar.",
        "Bring me a cup. Oh, and a fork.",
        "Take the bag upstairs. No, the door is locked.",
        "Is it on? No, the other one is.",
        "Is the soup hot? Maybe not. Heat it up and bring it to me.",
        "See if the shop is open. Maybe not, but go and look.",
        "Bring the tray. Oh, better not wake Sam, so walk softly.",
        "Put the milk in the fridge. Maybe not the red one.",
        "The stove is on, or maybe not. Go and look.",
    ],
)
def test_what_is_not(parser: Parser, text: str) -> None:
    assert withdrawals(parser, text) == ("", [])


@pytest.mark.parametrize(
    ("text", "phrase"),
    [
        ("Bring me the blue cup, scratch that, the red one.", "the red one"),
        ("Put the milk in the fridge, no, forget that, in the freezer.", "in the freezer"),
        ("Bring me the keys from the hall, scratch that, the kitchen.", "the kitchen"),
        ("Bring me the green mug. No wait, the white one.", "the white one"),
        ("Fetch the yellow bucket, I mean the red one, and fill it.", "the red one"),
        ("Bring me the long ruler, or rather the short one.", "the short one"),
        ("Put the salt on the tray. Wait, no, the sugar.", "the sugar"),
        ("fetch the yellow bucket no the red one", "the red one"),
        ("bring me the long ruler sorry the short one", "the short one"),
    ],
)
def test_before_a_bare_phrase_only_an_argument_is_taken_back(parser: Parser, text: str, phrase: str) -> None:
    assert withdrawals(parser, text)[1] == [phrase]


@pytest.mark.parametrize(
    ("text", "taken_back"),
    [
        ("Bring me a chair. Never mind, Tom.", "Bring me a chair . Never mind"),
        ("Find my keys. Never mind, in my hand.", "Find my keys . Never mind"),
        ("Bring me a chair. Forget it, thanks.", "Bring me a chair . Forget it"),
    ],
)
def test_a_never_mind_corrects_nothing(parser: Parser, text: str, taken_back: str) -> None:
    assert withdrawals(parser, text) == (taken_back, [])


def test_a_condition_may_be_taken_back_as_a_whole(parser: Parser) -> None:
    words, _ = withdrawals(parser, "If the bin is full, empty it. No, leave it.")
    assert words == "If the bin is full , empty it . No , leave it"
    assert withdrawals(parser, "Check if the oven is on. Never mind.")[0] == "Check if the oven is on . Never mind"


def test_a_task_that_is_taken_back_is_none(interpreter: Interpreter) -> None:
    assert tasks(interpreter.interpret("Close the door. Scratch that. Open the window.")) == ["Open"]
    assert tasks(interpreter.interpret("Have a look in the drawer. Scratch that. Bring me the milk.")) == ["Bring"]
    assert tasks(interpreter.interpret("Bring me the milk, and don't forget the milk.")) == ["Bring"]


def test_a_correction_takes_the_place_of_the_argument(interpreter: Interpreter) -> None:
    read = interpreter.interpret("Turn on the heater, no wait, scratch that, the fan.")
    assert [a.value for a in read.tasks[0].arguments if a.type == "object"] == ["the fan"]


def test_no_leave_it_somewhere_is_an_order_itself(interpreter: Interpreter) -> None:
    read = interpreter.interpret("Bring me the cup, no, leave it on the table.")
    assert tasks(read) == ["leave"]
    assert ("object", "the cup") in [(a.type, a.value) for a in read.tasks[0].arguments]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Iron the shirts and fold the towels. Oh, skip the ironing.", ["fold"]),
        ("Vacuum the rug and dust the shelf. Actually, skip the vacuuming.", ["dust"]),
        ("Wipe the table, then bring me the salt. On second thoughts, skip the wiping.", ["bring"]),
        ("Mop the floor and shut the window. Never mind the mopping.", ["shut"]),
        ("Dust the shelf. Well, skip dusting it and bring me a pen.", ["bring"]),
        ("Iron the shirts. Skip the ironing board.", ["Iron"]),
        ("Wipe the table. Skip the mopping and bring me a pen.", ["Wipe", "bring"]),
        ("Wash the mug. If it's clean, skip the washing.", ["Wash", "'s"]),
    ],
)
def test_what_is_skipped_by_its_verb_is_taken_back(interpreter: Interpreter, text: str, expected: list[str]) -> None:
    assert tasks(interpreter.interpret(text)) == expected


def test_an_if_no_takes_nothing_back(interpreter: Interpreter) -> None:
    text = "Is it dry? Then hang them in the shed, if no, leave them there."
    assert [task.span.of(text) for task in interpreter.interpret(text).tasks] == ["Is", "hang", "leave"]
