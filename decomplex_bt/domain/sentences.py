"""Tasks and conditions as sentences a person would say: the names of the nodes of a tree."""

from __future__ import annotations

import re
from collections.abc import Sequence

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.instruction import Task

_LEADS = {"goal": "to", "source": "from", "location": "in", "recipient": "to"}
"""What is put before an argument that has no preposition of its own (referents have none)."""
_CONDITIONS = (("check that ", "if "), ("look for ", "if I can find "))
"""How a task's sentence starts, and how it starts as a condition; any other: "if I can ..."."""
_SWITCHED = {"on", "off"}
"""States that a thing is turned to, not made ("turn the tv off")."""


def say_task(task: Task, ontology: Ontology, *, state: str | None = None, prepositions: Sequence[str] = ()) -> str:
    """The task in plain English, as the ontology says it, all its arguments included ("look for a pen in the drawer").

    `state` stands in where the task names none (the verb implies it). `prepositions`: those that may lead a value.
    """
    values = {kind: list(task.values(kind)) for kind in dict.fromkeys(a.type for a in task.arguments)}
    if state is not None:
        values.setdefault("state", [state])
    words: list[str] = []
    for word in ontology.task_types[task.type].says.split():
        match = re.fullmatch(r"\{(\w+)\}", word)
        if match is None:
            words.append(word)
            continue
        found = values.pop(match[1], [])
        if not found and words[-1:] == ["for"]:
            words.pop()  # "look [for {object}] in the drawer"
        if match[1] == "recipient" and len(words) == 1:
            words += [_bare(value) for value in found]  # right behind the verb: "tell me", "tell Anna"
            continue
        if match[1] == "state" and words[0] == "make" and set(found) & _SWITCHED:
            words[0] = "turn"
        words += [_lead(match[1], value, prepositions) for value in found]
    for kind, rest in values.items():
        words += [_lead(kind, value, prepositions) for value in rest]
    if words[-1] == "is":
        words.append("there")
    return " ".join(words)


def say_condition(sentence: str) -> str:
    """The sentence of a task as a condition: "check that the tv is on" becomes "if the tv is on"."""
    for start, condition in _CONDITIONS:
        if sentence.startswith(start):
            return condition + sentence.removeprefix(start)
    return f"if I can {sentence}"


def _bare(recipient: str) -> str:
    first, _, rest = recipient.partition(" ")
    return rest if first.lower() == "to" and rest else recipient


def _lead(kind: str, value: str, prepositions: Sequence[str]) -> str:
    """The value with a preposition where it needs one here."""
    first = value.partition(" ")[0]
    known = {*prepositions, *_LEADS.values(), "on", "at", "into", "onto", "with", "next", "under", "behind", "inside"}
    if kind not in _LEADS or first.lower() in known:
        return value
    return f"{_LEADS[kind]} {value}"
