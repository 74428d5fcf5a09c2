"""Distribution: one verb with several things, each with a place, a state or a person of its own, as a task for each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.flow import Do, Flow, If, Node, in_reading_order
from decomplex_bt.instruction import Argument, Instruction, Task

_THINGS = frozenset(("object", "message"))
_PAIRED = frozenset(("goal", "recipient", "state", "source", "location"))


def distributed(instruction: Instruction) -> Instruction:
    """The instruction with "put the lid on the pan and the pan in the oven" as two tasks, one behind the other.

    The further tasks have the verb of the first and numbers after all others. What is said once ("bring *me* a pen from
    the desk and a cup from the shelf") holds for each. A condition is left whole.
    """
    conditions = {number for node, _ in instruction.flow.walk() if isinstance(node, If) for number in node.tasks}
    tasks: list[Task] = []
    further: dict[int, tuple[int, ...]] = {}
    number = len(instruction.tasks)
    for task in instruction.tasks:
        rounds = _rounds(task) if task.id not in conditions else (task.arguments,)
        tasks.append(replace(task, arguments=rounds[0]))
        for arguments in rounds[1:]:
            number += 1
            tasks.append(replace(task, id=number, arguments=arguments))
            further[task.id] = (*further.get(task.id, ()), number)
    if not further:
        return instruction
    ordered = tuple(sorted(tasks, key=lambda task: task.id))
    return replace(instruction, tasks=ordered, flow=Flow(in_reading_order(_with(instruction.flow.nodes, further))))


def _rounds(task: Task) -> tuple[tuple[Argument, ...], ...]:
    """The arguments for each thing, where several things have something of their own; else all in one."""
    said = sorted((a for a in task.arguments if a.span is not None), key=lambda a: a.span.start if a.span else 0)
    rounds: list[list[Argument]] = [[]]
    for argument in said:
        if argument.type in _THINGS | _PAIRED and any(a.type == argument.type for a in rounds[-1]):
            rounds.append([])
        rounds[-1].append(argument)
    kinds = [{argument.type for argument in arguments} for arguments in rounds]
    paired = set.intersection(*kinds) & _PAIRED
    if len(rounds) < 2 or not paired or not all(kind & _THINGS for kind in kinds):
        return (task.arguments,)
    silent = [argument for argument in task.arguments if argument.span is None]
    first = rounds[0]
    return tuple(
        (*arguments, *(a for a in first if a.type not in kind), *silent)
        for arguments, kind in zip(rounds, kinds, strict=True)
    )


def _with(nodes: Sequence[Node], further: dict[int, tuple[int, ...]]) -> tuple[Node, ...]:
    """The nodes with the further tasks behind each of theirs."""
    found: list[Node] = []
    for node in nodes:
        if isinstance(node, If):
            found.append(If(node.tasks, _with(node.then, further), _with(node.orelse, further)))
            continue
        found.append(node)
        found += [Do((number,), node.is_repeat) for number in further.get(node.task, ())]
    return tuple(found)
