"""Weather: the "it" of the weather, the day and the time is the thing of its check and names nothing else ("is *it*
snowing? If *it* is, ...")."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Argument, Task, in_text_order
from decomplex_bt.understanding.document import MARKS, Document

_NEAR = 4
"""Within so many words ahead of a check, or right behind it in a question, stands its "it"."""


def with_weather(document: Document, tasks: Sequence[Task], flow: Flow) -> tuple[Task, ...]:
    """The tasks, those checks of which nothing but an "it" is said to be so with that as their object; in the mentions
    of such a check it is no other thing."""
    said = {j for task in tasks for a in task.arguments if a.span is not None for j in document.indices(a.span)}
    tasks = tuple(_with_it(document, task, said) for task in tasks)
    named = {task.id: task for task in tasks}
    mentions = {
        number
        for node, _ in flow.walk()
        if isinstance(node, If) and _is_of_weather(named[node.tasks[0]])
        for number in node.tasks[1:]
    }
    return tuple(_naming_nothing(document, task) if task.id in mentions else task for task in tasks)


def _with_it(document: Document, task: Task, said: Collection[int]) -> Task:
    if task.type != "check_state" or task.value("object") is not None:
        return task
    check, tokens = document.indices(task.span).start, document.tokens
    found: int | None = None
    for j in range(check - 1, max(-1, check - 1 - _NEAR), -1):
        if tokens[j].text in MARKS:
            break
        if tokens[j].lower == "it":
            found = j
            break
    if found is None and check + 1 < len(tokens) and tokens[check + 1].lower == "it":
        found = check + 1
    if found is None or found in said:
        return task
    span = document.span(found, found)
    it = Argument("object", span.of(document.text), span, task.confidence)
    return replace(task, arguments=in_text_order((*task.arguments, it)))


def _is_of_weather(task: Task) -> bool:
    said = {word for state in task.values("state") for word in state.lower().split()}
    return not WEATHER.isdisjoint(said) and (task.value("object") or "").lower() == "it"


def _naming_nothing(document: Document, task: Task) -> Task:
    """A mention whose "it", if it has one, stands for itself."""
    arguments = (
        replace(a, value=a.span.of(document.text))
        if a.type == "object" and a.span is not None and a.span.of(document.text).lower() == "it"
        else a
        for a in task.arguments
    )
    return replace(task, arguments=tuple(arguments))
