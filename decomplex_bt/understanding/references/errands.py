"""Errands: a check of what an order needs, asked ahead of it, asks for the order's own thing ("bring me the pens. If
there are *none*, ...") and for nobody in that ("give Ann the book. If she isn't *there*, ...")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Argument, Task


def with_things_asked(text: str, tasks: Sequence[Task], drawn: Flow, flow: Flow) -> tuple[Task, ...]:
    """The tasks, put right where checks are mentions of an order as `drawn`, and conditions of their own in the
    `flow`."""
    asked = {node.task for node, _ in flow.walk() if isinstance(node, If)}
    orders = {
        number: node.task
        for node, _ in drawn.walk()
        if isinstance(node, If)
        for number in node.tasks[1:]
        if number in asked
    }
    named = {task.id: task for task in tasks}
    return tuple(_put_right(text, task, named[orders[task.id]]) if task.id in orders else task for task in tasks)


def _put_right(text: str, check: Task, order: Task) -> Task:
    thing = order.value("object")
    if check.type != "check_state" or thing is None:
        return check
    if check.value("object") is None:
        return replace(check, arguments=(Argument("object", thing, None, check.confidence), *check.arguments))
    arguments = (
        replace(a, value=a.span.of(text)) if a.type == "location" and a.span is not None and a.value == thing else a
        for a in check.arguments
    )
    return replace(check, arguments=tuple(arguments))
