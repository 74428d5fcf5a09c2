"""Weather: a later mention of it names nothing either ("is it snowing? If *it* is, ...")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Task


def without_weather(tasks: Sequence[Task], flow: Flow) -> tuple[Task, ...]:
    """The tasks, those that mention a check of the weather without its "it"."""
    mentions = {number for node, _ in flow.walk() if isinstance(node, If) for number in _mentions(tasks, node)}
    return tuple(
        replace(task, arguments=tuple(a for a in task.arguments if (a.type, a.value.lower()) != ("object", "it")))
        if task.id in mentions
        else task
        for task in tasks
    )


def _mentions(tasks: Sequence[Task], node: If) -> Sequence[int]:
    first = next(task for task in tasks if task.id == node.tasks[0])
    said = {word for a in first.arguments if a.type == "state" for word in a.value.lower().split()}
    is_of_weather = not WEATHER.isdisjoint(said) and all(a.type != "object" for a in first.arguments)
    return node.tasks[1:] if is_of_weather else ()
