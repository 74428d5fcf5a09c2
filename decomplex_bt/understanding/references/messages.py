"""Messages: what is told to somebody else as well, or in somebody's place, without being said again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.context import paths_of
from decomplex_bt.understanding.vocabulary import PRONOUNS

_TELLING = frozenset(("tell", "let", "inform"))
_SPEAKING = frozenset("say reply refuse object want agree ask complain mind".split())
"""What somebody answers by, which may be what is told on."""
_SAYING = _TELLING | frozenset("say whisper shout repeat report".split())
_SAID = frozenset(("it", "that", "this"))
_FOUND = frozenset(("so", "that", "this"))
_BE = frozenset("is are was were".split())
_CONTRACTED = {"'s": "is", "'re": "are"}
_DENYING = frozenset("not n't isn't aren't no never".split())
_ADDING = frozenset(("too", "also"))
_ONESELF = frozenset(("me", "us"))


def with_messages(document: Document, tasks: Sequence[Task], flow: Flow) -> tuple[Task, ...]:
    """The tasks; who is told or asked something in the same words as another person before, with nothing but conditions
    in between, gets that person's message: "tell Ann *that supper is ready*, and if she's out, tell Bea". Not what is
    told on: "ask Ann what she wants and tell Bea", "if she says no, tell Bea"."""
    found: list[Task] = []
    for task in tasks:
        before = next((one for one in reversed(found) if one.type != "check_state"), None)
        if before is not None:
            task = _said_again(document, task, before)
        task = _found_out(document, task, tasks, flow)
        before = _told_in_vain(found, before, flow)
        between = found[found.index(before) + 1 :] if before is not None else []
        message = _passed_on(document, task, before, between, flow) if before is not None else None
        if message is not None:
            told = Argument("message", message.value, None, message.confidence)
            task = replace(task, arguments=(*task.arguments, told))
        found.append(task)
    return tuple(found)


def _told_in_vain(found: Sequence[Task], before: Task | None, flow: Flow) -> Task | None:
    """The task before, or the order to tell somebody that it, a search, says to fail: "tell Ann ..., and if you *can't
    find her*, ..."."""
    if before is None or before.type != "searching":
        return before
    groups = [node.tasks for node, _ in flow.walk() if isinstance(node, If) and before.id in node.tasks]
    told = [one for one in found if one.type == "informing" and any(one.id in group for group in groups)]
    is_of_them = bool(told) and before.value("object") == told[-1].value("recipient")
    return told[-1] if is_of_them else before


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
            replace(a, value=message.value, confidence=a.confidence * message.confidence)
            if _is_said(document, a)
            else a
            for a in task.arguments
        ),
    )


def _found_out(document: Document, task: Task, tasks: Sequence[Task], flow: Flow) -> Task:
    """The task; a "so" or "that" that somebody is told in a case is what its condition found out: "if *the shelf is
    empty*, tell me *so*"."""
    path = paths_of(flow).get(task.id, ())
    told = next((a for a in task.arguments if a.type == "message" and a.value.lower() in _FOUND), None)
    check = next((one for one in tasks if path and one.id == path[-1][0] < task.id), None)
    if task.type != "informing" or told is None or check is None or check.type != "check_state":
        return task
    clause = _clause(document, check)
    is_denied = any(word in _DENYING for word in clause.lower().split())
    if not clause or (path[-1][1] == "else") != is_denied:
        return task
    said = tuple(replace(a, value=clause) if a is told else a for a in task.arguments)
    return replace(task, arguments=said)


def _clause(document: Document, check: Task) -> str:
    """What a check asks, as a statement: "the shelf is empty"; "" where its words make none."""
    tokens, verb = document.tokens, document.indices(check.span).start
    said = {a.type: a for a in check.arguments if a.span is not None}
    thing = said.get("object")
    rest = [said[name] for name in ("state", "location") if name in said]
    if not rest or (thing is not None and thing.value.lower() in PRONOUNS):
        return ""
    if thing is None or thing.span is None:  # "if it's raining"
        return f"it is {rest[0].value}" if verb and tokens[verb - 1].lower == "it" else ""
    words, end = document.indices(thing.span), max(a.span.end for a in rest if a.span is not None)
    start = words.stop
    if words.start > verb and tokens[verb].lower in _BE:  # "is the shelf empty?"
        return f"{thing.value} {tokens[verb].lower} {document.text[tokens[start].start : end]}"
    if start >= len(tokens) or tokens[start].start >= end or tokens[start].tag == "VB":
        return ""
    be = _CONTRACTED.get(tokens[start].lower)
    behind = document.text[tokens[start + 1].start : end] if be else document.text[tokens[start].start : end]
    return " ".join([thing.value, *([be] if be else ()), behind])


def _is_said(document: Document, argument: Argument) -> bool:
    """Whether a message is no more than a word for another one: "that too"."""
    said = argument.value if argument.span is None else argument.span.of(document.text)
    words = [word for word in said.lower().split() if word not in _ADDING]
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
