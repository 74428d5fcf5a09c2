"""What is fetched and goes elsewhere by the next order is taken, not handed over in between."""

from __future__ import annotations

import pytest

from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Instruction, Span, Task
from decomplex_bt.planning.passing_on import passed_on

CUP, PEN = ("object", "the cup"), ("object", "the pen")
IN_ORDER = [1, 2]


def _types(flow: list[object], fetched: tuple[tuple[str, str], ...], *then: tuple[str, str]) -> list[str]:
    said = [("bringing", fetched), ("placing" if ("goal", "in the sink") in then else "bringing", then)]
    tasks = tuple(
        Task(number, kind, Span(number, number + 1), tuple(Argument(*one) for one in arguments))
        for number, (kind, arguments) in enumerate(said, start=1)
    )
    return [task.type for task in passed_on(Instruction("...", tasks, Flow.from_json(flow))).tasks]


@pytest.mark.parametrize(
    ("flow", "fetched", "then"),
    [
        (IN_ORDER, (CUP,), (CUP, ("recipient", "to Anna"))),
        (IN_ORDER, (CUP, ("source", "from the shelf")), (CUP, ("goal", "in the sink"))),
        (IN_ORDER, (CUP,), (CUP, PEN, ("recipient", "to Anna"))),
        ([{"if": 1, "then": [2]}], (CUP,), (CUP, ("goal", "in the sink"))),
    ],
)
def test_what_the_next_order_hands_on_is_taken(
    flow: list[object], fetched: tuple[tuple[str, str], ...], then: tuple[tuple[str, str], ...]
) -> None:
    assert _types(flow, fetched, *then)[0] == "taking"


@pytest.mark.parametrize(
    ("flow", "fetched", "then"),
    [
        (IN_ORDER, (CUP, ("recipient", "me")), (CUP, ("goal", "in the sink"))),
        (IN_ORDER, (CUP,), (PEN, ("recipient", "to Anna"))),
        (IN_ORDER, (CUP, PEN), (PEN, ("recipient", "to Anna"))),
        (IN_ORDER, (CUP,), (CUP,)),
        ([{"if": 1, "else": [2]}], (CUP,), (CUP, ("goal", "in the sink"))),
    ],
)
def test_what_goes_to_somebody_or_nowhere_else_is_brought(
    flow: list[object], fetched: tuple[tuple[str, str], ...], then: tuple[tuple[str, str], ...]
) -> None:
    assert _types(flow, fetched, *then)[0] == "bringing"
