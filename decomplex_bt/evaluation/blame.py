"""Where a failed episode went wrong: in understanding, grounding, planning or execution."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.row import Stage
from decomplex_bt.flow import If, Node
from decomplex_bt.instruction import Instruction, Task
from decomplex_bt.planning.ground_task import GroundInstruction, GroundTask, Referent
from decomplex_bt.planning.grounding import ground

Blame = tuple[Stage, str]


def blame_reading(reading: Instruction, gold: Instruction, domain: Domain) -> Blame | None:
    """What is wrong with a reading that ought to come to what a gold one comes to; None where nothing is.

    Readings are compared by what they come to in the house, so that a harmless difference in words is none.
    Raises `InputError` where the gold reading does not ground.
    """
    wanted = meaning(ground(gold, domain))
    try:
        found = meaning(ground(reading, domain)) if reading.tasks else ()
    except InputError as error:
        is_same = _spoken(reading) == _spoken(gold)
        return ("grounding" if is_same else "understanding"), str(error)
    return None if found == wanted else ("understanding", describe_difference(reading, gold))


def blame_run(failures: Sequence[Mapping[str, Any]], violations: Sequence[str], *, is_truncated: bool) -> Blame:
    """What went wrong in an episode with a right reading; `failures` as the agent knows them, `run --json` form."""
    if violations:
        return "execution", violations[0]
    if failures:
        last = failures[-1]
        where = "" if last["task"] is None else f"task {last['task']}: "
        return last["stage"], where + str(last["reason"])
    return "execution", "the time was up" if is_truncated else "gave up with tasks left undone"


def meaning(instruction: GroundInstruction) -> tuple[Any, ...]:
    """What an instruction comes to: its control flow over what its tasks mean in the house, without its words."""
    return tuple(_node_meaning(node, instruction) for node in instruction.flow.nodes)


def describe_difference(reading: Instruction, gold: Instruction) -> str:
    """How a reading differs from a gold one, in one line; the coarsest difference there is."""
    mine, wanted = ([(task.span.of(i.text), task.type) for task in i.tasks] for i in (reading, gold))
    if mine != wanted:
        lost = [f"{verb} ({kind})" for verb, kind in wanted if (verb, kind) not in mine]
        extra = [f"{verb} ({kind})" for verb, kind in mine if (verb, kind) not in wanted]
        parts = [f"missed {', '.join(lost)}" if lost else "", f"made up {', '.join(extra)}" if extra else ""]
        return "tasks: " + ("; ".join(part for part in parts if part) or "in another order")
    if reading.flow != gold.flow:
        return f"flow: {reading.flow.to_json()} instead of {gold.flow.to_json()}"
    for task, right in zip(reading.tasks, gold.tasks, strict=True):
        if _arguments(task) != _arguments(right):
            return f"arguments of {right.span.of(gold.text)!r}: {_say(task)} instead of {_say(right)}"
    return "no difference"


def _node_meaning(node: Node, instruction: GroundInstruction) -> tuple[Any, ...]:
    task = _task_meaning(instruction.task(node.task))
    if not isinstance(node, If):
        return ("do", task)
    branches = (tuple(_node_meaning(child, instruction) for child in branch) for branch in (node.then, node.orelse))
    return ("if", task, *branches)


def _task_meaning(task: GroundTask) -> tuple[Any, ...]:
    groups = (task.objects, task.places, (task.goal,) if task.goal else (), task.recipients)
    return (task.type, task.state, *(tuple(_referent_meaning(referent) for referent in group) for group in groups))


def _referent_meaning(referent: Referent) -> tuple[Any, ...]:
    return frozenset(referent.candidates), referent.is_all, referent.count, referent.where, referent.is_any


def _spoken(instruction: Instruction) -> tuple[Any, ...]:
    return instruction.flow, tuple((task.type, task.span, _arguments(task)) for task in instruction.tasks)


def _arguments(task: Task) -> list[tuple[str, str]]:
    return sorted((argument.type, argument.value.lower()) for argument in task.arguments)


def _say(task: Task) -> str:
    return ", ".join(f"{kind} {value!r}" for kind, value in _arguments(task)) or "none"
