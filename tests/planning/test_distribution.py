"""One verb with several things, each with something of its own, as a task for each."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Instruction, Span, Task
from decomplex_bt.planning.distribution import distributed


def _task(number: int, *arguments: tuple[str, str]) -> Task:
    said = (Argument(kind, value, Span(10 * i, 10 * i + 5)) for i, (kind, value) in enumerate(arguments, start=1))
    return Task(number, "bringing", Span(0, 5), tuple(said))


def test_each_pair_is_a_task_and_what_is_said_once_holds_for_all() -> None:
    put = _task(2, ("recipient", "me"), ("object", "a pen"), ("source", "from the desk"), ("object", "a cup"),
                ("source", "from the shelf"))  # fmt: skip
    flow = Flow.from_json([{"if": 1, "then": [2, 3], "else": [{"same": [2]}]}])
    instruction = distributed(Instruction("...", (_task(1, ("object", "the tv")), put, _task(3)), flow))
    assert [task.id for task in instruction.tasks] == [1, 2, 3, 4]
    assert instruction.task(2).values("object") == ("a pen",)
    assert {a.type: a.value for a in instruction.task(4).arguments} == {
        "recipient": "me",
        "object": "a cup",
        "source": "from the shelf",
    }
    assert instruction.flow.to_json() == [{"if": 1, "then": [2, 4, 3], "else": [{"same": [2]}, {"same": [4]}]}]
    assert distributed(instruction) == instruction


@pytest.mark.parametrize(
    "arguments",
    [
        (("object", "a pen"), ("object", "a cup"), ("goal", "to the hall")),
        (("object", "a pen"), ("goal", "to the hall"), ("goal", "to the kitchen")),
        (("recipient", "Anna"), ("recipient", "Tom"), ("object", "a pen")),
    ],
)
def test_what_is_told_of_all_is_one_task(arguments: tuple[tuple[str, str], ...]) -> None:
    instruction = Instruction("...", (_task(1, *arguments),), Flow.from_json([1]))
    assert distributed(instruction) == instruction


@pytest.mark.parametrize(
    ("said", "wardrobe", "table"),
    [
        ("{}, [the bag](1:object) too, and [the camera](1:object) {}", ("the shoes", "the bag"), ("the camera",)),
        ("{}, [the bag](1:object) as well, but [the camera](1:object) {}", ("the shoes", "the bag"), ("the camera",)),
        ("{}, [the bag](1:object), and [the camera](1:object) {}", ("the shoes",), ("the bag", "the camera")),
    ],
)
def test_what_has_no_place_of_its_own_goes_with_its_neighbour(
    said: str, wardrobe: tuple[str, ...], table: tuple[str, ...]
) -> None:
    text = said.format("[the shoes](1:object) [in the wardrobe](1:goal)", "[on the table](1:goal)")
    found = distributed(read_markup(f"[Put](1:placing) {text}.", load_domain().ontology, flow=[1]))
    assert [task.values("object") for task in found.tasks] == [wardrobe, table]


def test_what_is_left_over_leaves_all_in_one() -> None:
    text = "[Put](1:placing) [the shoes](1:object) [in the wardrobe](1:goal), [the bag](1:object) and [it](1:object)."
    (task,) = distributed(read_markup(text, load_domain().ontology, flow=[1])).tasks
    assert len(task.values("object")) == 3


@pytest.mark.parametrize("meant", ["", "=the window"])
def test_one_in_either_place_is_a_choice_whatever_a_reading_has_for_it(meant: str) -> None:
    text = (
        "[Close](1:change_state) [the window](1:object) [in the kitchen](1:location) or "
        f"[the one](1:object{meant}) [in the bedroom](1:location)."
    )
    instruction = distributed(read_markup(text, load_domain("household").ontology, flow=[1]))

    assert [{a.type: a.value for a in task.arguments} for task in instruction.tasks] == [
        {"object": "the window", "location": "in the kitchen or in the bedroom"}
    ]
