"""Tasks and conditions as sentences a person would say: the names of the nodes of a tree."""

from __future__ import annotations

import re
from collections.abc import Sequence

from decomplex_bt.domain.nouns import be
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.instruction import Task

_LEADS = {"goal": "to", "source": "from", "location": "in", "recipient": "to"}
"""What is put before an argument that has no preposition of its own (referents have none)."""
_CONDITIONS = (("check that ", "if "), ("look for ", "if I can find "))
"""How a task's sentence starts, and how it starts as a condition; any other: "if I can ..."."""
_CHECKING = ["check", "that"]
_RESTING = {"to": "in", "into": "in", "onto": "on"}
"""Prepositions of a place that somebody has gone to, as one says where they are."""
_ADVERBS = {"here", "there", "home", "back", "away", "outside", "inside", "upstairs", "downstairs", "everywhere"}
"""Places that need no preposition."""
_JOINED = {"object", "recipient", "state"}
"""Arguments that are coordinated where there are several; places follow one another."""
_ASKING = {"ask", "asks", "asking", "inquire", "enquire"}
_SWITCHED = {"on", "off"}
"""States that a thing is turned to, not made ("turn the tv off")."""


def say_task(
    task: Task, ontology: Ontology, *, verb: str = "", state: str | None = None, prepositions: Sequence[str] = ()
) -> str:
    """The task in plain English, as the ontology says it, all its arguments included ("look for a pen in the drawer").

    `verb`: what the instruction says for it, of which only that a message is asked is heeded ("ask Tom where it is").
    `state` stands in where the task names none (the verb implies it). `prepositions`: those that may lead a value.
    """
    values = {kind: list(task.values(kind)) for kind in dict.fromkeys(a.type for a in task.arguments)}
    if state is not None:
        values.setdefault("state", [state])
    words: list[str] = []
    for word in ontology.task_types[task.type].says.split():
        match = re.fullmatch(r"\{(\w+)\}", word)
        if match is None:
            said = be(words[-1]) if word == "is" else word
            words.append("ask" if said == "tell" and verb.lower() in _ASKING else said)
            continue
        found = values.pop(match[1], [])
        if match[1] == "object" and not found and words == _CHECKING:
            found = ["anybody"]  # "if nobody is in the kitchen" names none
        if words[-1:] == ["for"] and (not found or _first(found[0]) in _known(prepositions)):
            words.pop()  # "look [for {object}] in the drawer", "look [for] for my keys"
        if match[1] == "recipient" and len(words) == 1:
            words += _joined([_bare(value) for value in found])  # right behind the verb: "tell me", "tell Anna"
            continue
        if match[1] == "state" and words[0] == "make" and set(found) & _SWITCHED:
            words[0] = "turn"
        led = [_lead(match[1], value, prepositions) for value in found]
        words += _joined(led) if match[1] in _JOINED else led
    for kind, rest in values.items():
        words += [_lead(kind, value, prepositions) for value in rest]
    if words[-1] in ("is", "are"):
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


def _joined(values: list[str]) -> list[str]:
    """Several values as one: "the cup, the mug and the plate"."""
    return [" and ".join([", ".join(values[:-1]), values[-1]])] if len(values) > 1 else values


def _first(value: str) -> str:
    return value.partition(" ")[0].lower()


def _known(prepositions: Sequence[str]) -> set[str]:
    own = {"on", "at", "into", "onto", "with", "next", "under", "behind", "inside", "out", "off", "beside", "near"}
    return {*prepositions, *_LEADS.values(), *_RESTING, *own, "for"}


def _lead(kind: str, value: str, prepositions: Sequence[str]) -> str:
    """The value with a preposition where it needs one here."""
    first, _, rest = value.partition(" ")
    if kind == "recipient" and value == "I":
        return "to me"
    if kind == "location" and first.lower() in _RESTING and rest:
        return f"{_RESTING[first.lower()]} {rest}"
    if kind not in _LEADS or first.lower() in _known(prepositions) or value.lower() in _ADVERBS:
        return value
    return f"{_LEADS[kind]} {value}"
