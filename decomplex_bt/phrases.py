"""Phrases: a task in a few words of English, near to those of the instruction."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from decomplex_bt.instruction import Argument, Instruction, Span, Task

_CONTRACTED = {"'s": "is", "\u2019s": "is", "'re": "are", "\u2019re": "are", "'m": "am", "\u2019m": "am"}
PREPOSITIONS = frozenset(
    ("about", "at", "behind", "beside", "by", "for", "from", "in", "inside", "into", "near", "next", "of", "off", "on")
) | {"onto", "out", "over", "to", "under", "with"}
_RESTING = PREPOSITIONS - {"about", "by", "for", "from", "into", "of", "off", "onto", "out", "over", "to", "with"}
"""Prepositions of where something is."""
_OF_NOBODY = re.compile(r"\b(nobody|no one|no-one|noone)( else)? *$", re.IGNORECASE)
_NOR = re.compile(r" nor ", re.IGNORECASE)
_PLACES = {"goal": "to", "source": "from", "location": "in"}
"""Arguments that are places, with the preposition of one that has none of its own and has none elsewhere."""
_PARTICLES = frozenset(("away", "back", "down", "know", "off", "out", "over", "up"))
"""Words of a verb that no argument has: "put *away*", "let me *know*"."""
_LED = frozenset(("is", "are", "was", "were", "am", "has", "have", "had", "do", "does", "did", "can", "will"))
"""Verbs that a question has ahead of its subject: "is the tv on", but "the mail arrives"."""
_WORD = re.compile(r" *([a-z]+)", re.IGNORECASE)
_ADVERBS = frozenset(("here", "there", "home", "back", "away", "outside", "inside", "upstairs", "downstairs"))


def phrase_of(instruction: Instruction, task: Task) -> str:
    """The task's verb with its arguments' values, as in "find a pen on the table"."""
    verb = instruction.verb_of(task).span.of(instruction.text)
    words = [_CONTRACTED.get(verb.lower(), verb)]
    if words[0] in ("is", "are") and re.search(r"\bthere *$", instruction.text[: task.span.start], re.IGNORECASE):
        words.insert(0, "there")
    if task.argument("object") is None and _OF_NOBODY.search(instruction.text[: task.span.start]):
        words.insert(0, "anybody")  # the flow has the "no"
    if (subject := _subject(task)) is not None:
        words.insert(0, subject.value)
    task = replace(task, arguments=(*task.arguments, *_particles(instruction, task)))
    if task.type == "check_state" and words == [verb] and verb.lower() not in _LED:
        ahead = [a for a in task.arguments if a.type == "object" and a.span is not None and a.span < task.span]
        task = replace(task, arguments=tuple(a for a in task.arguments if a not in ahead))
        words = [" and ".join(spoken(instruction, a, task) for a in ahead), verb] if ahead else words
    last = ""
    for argument in _in_order(task):
        joint = argument.type == last and argument.type in ("object", "recipient", "state")
        words += ["and"] * joint + [spoken(instruction, argument, task)]
        last = argument.type
    return " ".join(words)


def spoken(instruction: Instruction, argument: Argument, task: Task) -> str:
    """An argument's value with a preposition, where its own words have one or where it needs one: of a place that
    is only meant ("there") that which leads it elsewhere in the instruction."""
    value, surface = argument.value, instruction.surface(argument.span) or ""
    if task.type == "check_state":  # of "neither on the desk nor on the bed" the flow has the "no"
        value, surface = (_NOR.sub(" or ", said) for said in (value, surface))
    first, is_meant = surface.partition(" ")[0].lower(), argument.type in _PLACES
    if value.partition(" ")[0].lower() in PREPOSITIONS or value == surface:
        return value
    if first in PREPOSITIONS and first != surface.lower():
        return f"{first} {value}"
    if argument.type == "object" and task.type == "searching" and not surface and task.argument("location"):
        return f"for {value}"  # "try the desk drawer for my keys"
    if not is_meant or value.lower() in _ADVERBS:
        return f"to {value}" if argument.type == "recipient" and not surface else value
    rests = argument.type == "location" or task.type == "placing"
    elsewhere = (a.value for other in instruction.tasks for a in other.arguments if rests and a.type in _PLACES)
    found = (said for said in elsewhere if said.lower().endswith(f" {value.lower()}"))
    fitting = (said for said in found if said[: -len(value) - 1].lower() in _RESTING)
    usual = "in" if task.type == "placing" and argument.type == "goal" else _PLACES[argument.type]
    return next(fitting, f"{usual} {value}")


def _particles(instruction: Instruction, task: Task) -> Iterator[Argument]:
    """What belongs to the verb of the words that stand behind it, among its own arguments, and are in none."""
    behind = {a.span.start: a.span.end for a in task.arguments if a.span is not None}
    at = task.span.end
    while not task.repeats and (word := _WORD.match(instruction.text, at)):
        if word.start(1) in behind:
            at = behind[word.start(1)]
        elif word[1].lower() in _PARTICLES:
            yield Argument("particle", word[1], Span(*word.span(1)))
            at = word.end()
        else:
            return


def _subject(task: Task) -> Argument | None:
    """The one who says what they want to have ("I need my phone")."""
    return next((a for a in task.arguments if a.type == "recipient" and a.value == "I" and a.span is not None), None)


def _in_order(task: Task) -> Iterator[Argument]:
    """A task's arguments as one says them behind the verb: the object first where it was said before or not at all,
    other such arguments last."""
    subject = _subject(task)
    own = [a for a in task.arguments if a.span is not None and a.span.start >= task.span.end]
    others = [a for a in task.arguments if a not in own and a is not subject]
    is_last = task.type == "searching" and bool(own)
    yield from (a for a in others if a.type == "object" and not is_last)
    yield from sorted(own, key=lambda a: a.span.start if a.span is not None else 0)
    yield from (a for a in others if a.type != "object" or is_last)
