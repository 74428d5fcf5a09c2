"""Messages: what is told to somebody else as well, or in somebody's place, without being said again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.context import paths_of

_TELLING = frozenset(("tell", "let", "inform"))
_SPEAKING = frozenset("say reply refuse object want agree ask complain mind".split())
"""What somebody answers by, which may be what is told on."""
_SAYING = _TELLING | frozenset("say whisper shout repeat report".split())
_SAID = frozenset(("it", "that", "this"))
_ADDING = frozenset(("too", "also"))
_ONESELF = frozenset(("me", "us"))


def with_messages(document: Document, tasks: Sequence[Task], flow: Flow) -> tuple[Task, ...]:
    """The tasks; who is told or asked something in the same words as another person before, with nothing but conditions
    in between, gets that person's message: "tell Ann *that supper is ready*, and if she's out, tell Bea". Not what is
    told on: "ask Ann what she wants and tell Bea", "if she says no, tell Bea"."""
    found: list[Task] = []
    for task in tasks:
        before = next((one for one in reversed(found) if one.type != "check_state"), None)
        between = found[found.index(before) + 1 :] if before is not None else []
        if before is not None:
            task = _said_again(document, task, before)
        message = _passed_on(document, task, before, between, flow) if before is not None else None
        if message is not None:
            told = Argument("message", message.value, None, message.confidence)
            task = replace(task, arguments=(*task.arguments, told))
        found.append(task)
    return tuple(found)


def _said_again(document: Document, task: Task, before: Task) -> Task:
    """The task; the "it" or "that" that somebody else is told is what was said just before: "tell Ann *supper is ready*
    and tell *it* to Bea". What was asked is not what is told on ("ask her name and tell it to Bea")."""
    message = next((a for a in before.arguments if a.type == "message"), None)
    verbs = {document.tokens[document.indices(one.span).start].lemma for one in (task, before)}
    if message is None or {task.type, before.type} != {"informing"} or not verbs <= _SAYING:
        return task
    return replace(
        task,
        arguments=tuple(
            replace(a, value=message.value, confidence=a.confidence * message.confidence) if _is_said(a) else a
            for a in task.arguments
        ),
    )


def _is_said(argument: Argument) -> bool:
    """Whether a message is no more than a word for another one: "that too"."""
    words = [word for word in argument.value.lower().split() if word not in _ADDING]
    return argument.type == "message" and len(words) == 1 and words[0] in _SAID


def _passed_on(document: Document, task: Task, before: Task, between: Sequence[Task], flow: Flow) -> Argument | None:
    """The message of the one who was told before; None where it is not theirs that a task passes on."""
    message = next((a for a in before.arguments if a.type == "message"), None)
    if message is None or {task.type, before.type} != {"informing"} or task.value("message") is not None:
        return None
    whom, first = task.value("recipient"), before.value("recipient")
    if whom is None or first is None or whom == first or {whom, first} & _ONESELF:
        return None
    verbs = {document.tokens[document.indices(one.span).start].lemma for one in (task, before)}
    spoken = {document.tokens[document.indices(one.span).start].lemma for one in between} & _SPEAKING
    is_answer = (before.id, "then") in paths_of(flow).get(task.id, ())
    return None if spoken or is_answer or (len(verbs) > 1 and not verbs <= _TELLING) else message
