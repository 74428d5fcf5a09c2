"""Weather: the "it" of the weather, the day and the time is the thing of its check and names nothing else ("is *it*
snowing? If *it* is, ...")."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Argument, Task, in_text_order
from decomplex_bt.understanding.document import Document

_BESIDE = 2
"""Within so many words ahead of its verb stands an "it" that the parse hangs elsewhere: "if *it* still is"."""


def with_weather(document: Document, tasks: Sequence[Task], flow: Flow) -> tuple[Task, ...]:
    """The tasks, those checks of which nothing but an "it" is said to be so with that as their object; in mentions of
    such a check that say no more it is no other thing."""
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
    subjects = [j for j in document.children[check] if tokens[j].dep in ("nsubj", "nsubjpass", "expl")]
    beside = [*range(check - 1, max(-1, check - 1 - _BESIDE), -1), *range(check + 1, min(len(tokens), check + 2))]
    its = [j for j in subjects or beside if tokens[j].lower == "it" and j not in said]
    if not its or any(tokens[j].pos == "VERB" for j in range(its[0] + 1, check)):
        return task
    span = document.span(its[0], its[0])
    it = Argument("object", span.of(document.text), span, task.confidence)
    return replace(task, arguments=in_text_order((*task.arguments, it)))


def _is_of_weather(task: Task) -> bool:
    said = {word for state in task.values("state") for word in state.lower().split()}
    return not WEATHER.isdisjoint(said) and (task.value("object") or "").lower() == "it"


def _naming_nothing(document: Document, task: Task) -> Task:
    """A mention whose "it", if it says no more than that, stands for itself."""
    if any(a.type != "object" and a.span is not None for a in task.arguments):
        return task
    arguments = (
        replace(a, value=a.span.of(document.text))
        if a.span is not None and a.span.of(document.text).lower() == "it"
        else a
        for a in task.arguments
    )
    return replace(task, arguments=tuple(arguments))
