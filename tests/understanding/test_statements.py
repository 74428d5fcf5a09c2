"""Where something is said to be, which tells nothing of another thing."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load(encoder=True)


def _sources(interpreter: Interpreter, text: str) -> list[str]:
    return [a.value for a in interpreter.interpret(text).tasks[-1].arguments if a.type == "source"]


@pytest.mark.parametrize(
    "text",
    [
        "Grandma is in the garden. Fetch me the newspaper.",
        "There's a wasp on the window, get a glass.",
        "the dog is on the sofa bring me a blanket",
        "The kitten's stuck in the tree. Get the ladder.",
        "Dad is asleep on the couch. Bring me the tray.",
        "Lisa's in the kitchen. Grab my phone.",
    ],
)
def test_where_somebody_is_no_thing_is_fetched_from(interpreter: Interpreter, text: str) -> None:
    assert _sources(interpreter, text) == []


@pytest.mark.parametrize(
    ("text", "source"),
    [
        ("The cups are on the shelf and the bowls are in the dishwasher. Bring me a bowl.", "in the dishwasher"),
        ("The pens are in the drawer, the pencils are in the jar. Get me a pencil.", "in the jar"),
        ("The milk is in the fridge and the bread is on the table, so bring me the milk.", "in the fridge"),
    ],
)
def test_of_two_statements_the_one_about_the_thing_tells_where_it_is(
    interpreter: Interpreter, text: str, source: str
) -> None:
    assert _sources(interpreter, text) == [source]


@pytest.mark.parametrize(
    ("text", "sources"),
    [
        ("My keys are on the table. Bring me my keys.", ["on the table"]),
        ("The forks are in the drawer and the plates are on the rack. Bring me a plate and a fork.",
         ["in the drawer", "on the rack"]),
        ("The tools are in the shed. Get me the hammer.", ["in the shed"]),  # which may be among them
        ("The cat is in the garden. Bring her in.", ["in the garden"]),
        ("New bulbs are in the cupboard. Get one.", ["in the cupboard"]),
    ],
)  # fmt: skip
def test_where_the_thing_itself_may_be_is_kept(interpreter: Interpreter, text: str, sources: list[str]) -> None:
    assert _sources(interpreter, text) == sources


def _places(interpreter: Interpreter, text: str) -> list[str]:
    return [a.value for a in interpreter.interpret(text).tasks[0].arguments if a.type in ("source", "location")]


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("The alarm in the hall is bleeping, find a battery in the drawer and bring it to Ann.", ["in the drawer"]),
        ("The lamp on the desk is flickering. Look for a bulb in the shed.", ["in the shed"]),
        ("The bulb in the study has gone, get a new one from the cupboard.", ["from the cupboard"]),
        # where the thing itself is
        ("The plant on the sill is dying, water it.", ["on the sill"]),
        ("The kettle in the kitchen is boiling, turn it off.", ["in the kitchen"]),
    ],
)
def test_which_thing_is_spoken_of_is_no_place_of_another(
    interpreter: Interpreter, text: str, places: list[str]
) -> None:
    assert _places(interpreter, text) == places


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("The roast is expected in the dining room. Take it out of the oven.", ["out of the oven"]),
        ("The vase belongs in the parlour. If you can lift it off the shelf, dust it.", ["off the shelf"]),
        ("The carpet is due in the hall. Take it off the line.", ["off the line"]),
        # where it is now
        ("The roast is in the dining room. Take it to Ann.", ["in the dining room"]),
    ],
)
def test_where_something_is_to_be_it_is_not_yet(interpreter: Interpreter, text: str, places: list[str]) -> None:
    assert _places(interpreter, text) == places


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("There's a lamp in the study. If it's on the desk, bring it to me.", ["on the desk"]),
        ("My coat is in the hall. If it's under the stairs, hang it up.", ["under the stairs"]),
        ("There are some plates on the table. If they're on the tray, wash them.", ["on the tray"]),
        # of what it is asked how that is
        ("The flour on the shelf, is it open? If so, put it in the jar.", ["on the shelf"]),
        ("If the towels in the bathroom are dry, fold them.", ["in the bathroom"]),
    ],
)
def test_what_is_asked_to_be_elsewhere_is_at_one_place(interpreter: Interpreter, text: str, places: list[str]) -> None:
    assert _places(interpreter, text) == places


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("There's half a sack of oats in the barn. Bring it to me.", "half a sack of oats"),
        ("I left half a melon on the counter. Wrap it.", "half a melon"),
        ("There's a couple of blankets in the loft. Bring them down to me.", "a couple of blankets"),
        ("I left a pair of pliers on the bench. Bring them to me.", "a pair of pliers"),
        ("All the forks are in the sink. Wash them.", "All the forks"),
        # as before
        ("There's a sack of oats in the barn. Bring it to me.", "a sack of oats"),
        ("There's a couple of blankets in the loft. Get one.", "a blanket"),
        ("There are two jugs on the shelf. Bring them here.", "two jugs"),
    ],
)
def test_what_is_told_of_a_part_is_handled_as_that_part(interpreter: Interpreter, text: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value("object") == value
