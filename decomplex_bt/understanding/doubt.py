"""Doubt: where two control flows are nearly as likely, the question that tells them apart, and what it changes."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from rapidfuzz import fuzz, process

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.domain.sentences import say_condition, say_task
from decomplex_bt.errors import InputError, quoted
from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.instruction import Choice, Doubt, Instruction, Task

THRESHOLD = 0.6
"""Below this confidence in the flow a question pays; see docs/accuracy.md for what it costs and gains."""
SIMILAR = 60.0
"""How like a choice an answer must be [percent]."""
_YOURS = {"me": "you", "my": "your", "mine": "yours", "myself": "yourself"}


def doubt_of(instruction: Instruction, ontology: Ontology, *, threshold: float = THRESHOLD) -> Doubt | None:
    """The question to ask about an instruction whose flow is less certain than `threshold`; None where it is certain
    enough, or where no other flow is known.

    The question is about the first task that stands elsewhere in the likeliest other flow. The choices are the ways
    that task stands in any of the flows, likeliest first, each with the likeliest flow that has it so.
    """
    if instruction.confidence >= threshold or not instruction.alternatives:
        return None
    best, other = instruction.flow, instruction.alternatives[0].flow
    for task in instruction.tasks:
        if _place(best, task.id) == _place(other, task.id):
            continue
        says = _said(task, instruction, ontology)
        flows = [(best, instruction.confidence), *((a.flow, a.probability) for a in instruction.alternatives)]
        choices: dict[str, Choice] = {}
        for flow, probability in flows:
            text = said_when(flow, task.id, instruction, ontology)
            known = choices.get(text)
            if known is None:
                choices[text] = Choice(text, flow, probability)
            else:
                choices[text] = replace(known, probability=known.probability + probability)
        if len(choices) > 1:
            return Doubt(task.id, f"Should I {says} {', or '.join(choices)}?", tuple(choices.values()))
    return None


def resolved(instruction: Instruction, doubt: Doubt, answer: str | int | Choice) -> Instruction | None:
    """The instruction with the flow that an answer chooses: one of the choices, its number, from 1, or its words, whole
    or in part. None for an answer that fits none of them, or several alike."""
    chosen = _chosen(doubt, answer)
    return None if chosen is None else replace(instruction, flow=chosen.flow, confidence=1.0, alternatives=())


def _chosen(doubt: Doubt, answer: str | int | Choice) -> Choice | None:
    if isinstance(answer, Choice):
        return answer if answer in doubt.choices else None
    said = str(answer).strip().lower()
    if said.isdecimal():
        return doubt.choices[int(said) - 1] if 1 <= int(said) <= len(doubt.choices) else None
    sides = _sides(said)
    choices = [choice for choice in doubt.choices if not sides or _sides(choice.text) == sides]
    texts = [choice.text.lower() for choice in choices]
    if said in texts:
        return choices[texts.index(said)]
    found = process.extract(said, texts, scorer=fuzz.token_set_ratio, score_cutoff=SIMILAR, limit=2)
    is_plain = len(found) == 1 or (len(found) == 2 and found[0][1] > found[1][1])
    return choices[found[0][2]] if is_plain else None


def settled(
    instruction: Instruction,
    ontology: Ontology,
    ask: Callable[[Doubt], str | int | Choice | None],
    *,
    threshold: float = THRESHOLD,
) -> Instruction:
    """The instruction after at most one question; as it was where there is no doubt, or no answer (None).

    Raises `InputError` for an answer that fits no choice, or several alike.
    """
    doubt = doubt_of(instruction, ontology, threshold=threshold)
    answer = ask(doubt) if doubt is not None else None
    if doubt is None or answer is None:
        return instruction
    chosen = resolved(instruction, doubt, answer)
    if chosen is None:
        choices = ", ".join(f"{n}: {quoted(choice.text)}" for n, choice in enumerate(doubt.choices, start=1))
        raise InputError(
            f"the answer to {doubt.question!r} is {_shown(answer)}; expected one of its choices, by number or in words "
            f"({choices}), or None for the likeliest"
        )
    return chosen


def _shown(answer: str | int | Choice) -> str:
    return quoted(answer.text) if isinstance(answer, Choice) else repr(answer)


def _place(flow: Flow, number: int) -> tuple[tuple[int, str], ...]:
    """The conditions above a task with the side of each, outermost first; its own mentions, where it is one."""
    found = _path(flow.nodes, number)
    return found if found is not None else ()


def _path(nodes: tuple[Node, ...], number: int) -> tuple[tuple[int, str], ...] | None:
    for node in nodes:
        if isinstance(node, If):
            if number in node.tasks:
                return ((node.task, "is"),)
            for side, branch in (("then", node.then), ("else", node.orelse)):
                inner = _path(branch, number)
                if inner is not None:
                    return ((node.task, side), *inner)
        elif isinstance(node, Do) and number in node.tasks and not node.is_repeat:
            return ()
    return None


def said_when(flow: Flow, number: int, instruction: Instruction, ontology: Ontology) -> str:
    """When a flow has a task done, in words."""
    path = [(condition, side) for condition, side in _place(flow, number) if side != "is"]
    if any(number in node.tasks for node, _ in flow.walk() if isinstance(node, If)):
        return "to find out what to do next"
    if not path:
        return "in any case"
    words = []
    for condition, side in path:
        said = say_condition(_said(instruction.task(condition), instruction, ontology))
        words.append(said if side == "then" else f"unless {said.removeprefix('if ')}")
    return ("only " if path[0][1] == "then" else "") + ", and ".join(words)


def _said(task: Task, instruction: Instruction, ontology: Ontology) -> str:
    """The task in the words of one who speaks to the user: "bring my cup to me" as "bring your cup to you". Where only
    the verb says the state, the user's own verb ("open the fridge")."""
    said = say_task(task, ontology, verb=instruction.verb_of(task).span.of(instruction.text))
    wants_state = "{state}" in ontology.task_types[task.type].says and not said.startswith("check that ")
    if wants_state and not task.values("state"):
        said = instruction.phrase(task.id).lower()
    return re.sub(r"\b(me|my|mine|myself)\b", lambda match: _YOURS[match[0].lower()], said, flags=re.IGNORECASE)


def _sides(text: str) -> tuple[str, ...]:
    """Whether its conditions are to hold or to fail, one after the other, for "if it rains" is nearly "unless it
    rains" to the letter."""
    found = re.findall(r"\b(unless|if not|not if|if)\b", text.lower())
    return tuple("if" if words == "if" else "unless" for words in found)
