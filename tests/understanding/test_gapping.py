"""What a verb does to another thing elsewhere without being said again."""

from __future__ import annotations

import pytest

from decomplex_bt.planning.distribution import distributed
from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "pairs"),
    [
        ("Put the lid on the pan and the spoon in the drawer.",
         [("object", "the lid"), ("goal", "on the pan"), ("object", "the spoon"), ("goal", "in the drawer")]),
        ("Give Anna the camera, Tom the ball and the guest his umbrella.",
         [("recipient", "Anna"), ("object", "the camera"), ("recipient", "Tom"), ("object", "the ball"),
          ("recipient", "the guest"), ("object", "his umbrella")]),
        ("Turn the lamp on and the radio off.",
         [("object", "the lamp"), ("state", "on"), ("object", "the radio"), ("state", "off")]),
        ("Bring a mug to Anna and another to Tom.",
         [("object", "a mug"), ("recipient", "to Anna"), ("object", "another mug"), ("recipient", "to Tom")]),
        ("Give Tom the ball, and Lily the kite.",
         [("recipient", "Tom"), ("object", "the ball"), ("recipient", "Lily"), ("object", "the kite")]),
    ],
)  # fmt: skip
def test_each_thing_has_what_is_told_of_it(text: str, pairs: list[tuple[str, str]], encoder: bool) -> None:
    (task,) = Interpreter.load(encoder=encoder).interpret(text).tasks
    assert [(argument.type, argument.value) for argument in task.arguments] == pairs


@pytest.mark.parametrize(
    ("text", "arguments"),
    [
        ("Put the cup, the plate and the fork in the sink.",
         [("object", "the cup, the plate and the fork"), ("goal", "in the sink")]),
        ("Put the book on the shelf, the one in the hall.", [("object", "the book"), ("goal", "on the shelf")]),
        ("Take the cup and the plate to the hall.", [("object", "the cup and the plate"), ("goal", "to the hall")]),
    ],
)  # fmt: skip
def test_what_is_told_of_several_things_is_told_once(text: str, arguments: list[tuple[str, str]]) -> None:
    (task,) = Interpreter.load().interpret(text).tasks
    assert [(argument.type, argument.value) for argument in task.arguments] == arguments


@pytest.mark.parametrize(
    ("text", "objects"),
    [
        ("Bring me the pills from the cabinet and a glass of water.", ["the pills", "a glass of water"]),
        ("Fetch the towels from the cupboard and the soap.", ["the towels", "the soap"]),
        ("Take the skis to the attic, and the snowshoes.", ["the skis", "the snowshoes"]),
        ("Bring me a pen or a pencil, whichever is nearer, and the notebook.", ["a pen or a pencil", "the notebook"]),
        ("Fetch the cups from the table and the sideboard.", ["the cups"]),
        ("Bring me the mug from the counter and water the plants.", ["the mug"]),
        ("Take the letter to Anna and the guest.", ["the letter"]),
    ],
)
def test_a_thing_behind_what_is_told_of_the_first_is_added(text: str, objects: list[str]) -> None:
    found = Interpreter.load("household").interpret(text)
    assert [a.value for a in found.tasks[0].arguments if a.type == "object"] == objects


@pytest.mark.parametrize(
    ("text", "arguments"),
    [
        ("Put the ladder away and the brush in the tin.",
         [("object", "the ladder"), ("object", "the brush"), ("goal", "in the tin")]),
        ("Put the juice on ice and the butter out.",
         [("object", "the juice"), ("goal", "on ice"), ("object", "the butter")]),
        ("Put the rakes away, the bikes in the shed and the hose out.",
         [("object", "the rakes"), ("object", "the bikes"), ("goal", "in the shed"), ("object", "the hose")]),
        ("Take the crates out and the letters to Anna.",
         [("object", "the crates"), ("object", "the letters"), ("recipient", "to Anna")]),
        ("Put the bread and the butter away.", [("object", "the bread and the butter")]),
        ("Put the ladder away and the brush too.", [("object", "the ladder"), ("object", "the brush")]),
    ],
)  # fmt: skip
def test_a_particle_tells_where_a_thing_goes_as_a_place_does(text: str, arguments: list[tuple[str, str]]) -> None:
    (task,) = Interpreter.load("household").interpret(text).tasks
    assert [(argument.type, argument.value) for argument in task.arguments] == arguments


def test_what_is_put_away_is_not_put_where_the_next_thing_goes() -> None:
    found = Interpreter.load("household").interpret("Put the ladder away and the brush in the tin.")
    ladder, brush = distributed(found).tasks
    assert (ladder.value("goal"), brush.value("goal")) == (None, "in the tin")
