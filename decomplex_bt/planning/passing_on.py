"""Passing on: what is fetched and goes elsewhere by the next order is not handed over in between ("fetch the ball and
give it to Anna")."""

from __future__ import annotations

from dataclasses import replace

from decomplex_bt.instruction import Instruction, Task

_WHITHER = ("recipient", "goal")
_CARRYING = frozenset(("bringing", "placing"))


def passed_on(instruction: Instruction) -> Instruction:
    """The instruction, in which what is only fetched is taken where the next order says where it goes: what is brought
    to nobody named is brought to who speaks, and these are not meant to get it first."""
    fetched = {
        first.id
        for first, second in (map(instruction.task, pair) for pair in instruction.flow.neighbours())
        if first.type == "bringing" and _is_passed_on(first, second)
    }
    tasks = (replace(task, type="taking") if task.id in fetched else task for task in instruction.tasks)
    return replace(instruction, tasks=tuple(tasks)) if fetched else instruction


def _is_passed_on(task: Task, following: Task) -> bool:
    """Whether nothing says where the things of a task go, and the order behind it says so of all of them."""
    things = {value.lower() for value in task.values("object")}
    is_open = all(task.value(kind) is None for kind in _WHITHER)
    is_told = following.type in _CARRYING and any(following.value(kind) is not None for kind in _WHITHER)
    return is_open and is_told and bool(things) and things <= {value.lower() for value in following.values("object")}
