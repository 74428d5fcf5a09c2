"""Settling: what an instruction leaves open is asked for, so that robot and judge are given the same reading."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import InputError, quoted
from decomplex_bt.instruction import Argument, Doubt, Instruction, Missing, check_instruction
from decomplex_bt.planning.distribution import distributed
from decomplex_bt.planning.grounding import ground
from decomplex_bt.understanding.doubt import THRESHOLD, settled

Ask = Callable[[Missing | Doubt], str | None]
"""Answers the `question` of what is missing or in doubt; None or blank text if it has no answer. A choice of a doubt is
named by its number, from 1, or by its words."""


def settle(
    instruction: str | Instruction,
    ask: Ask,
    *,
    domain: str | Path | Domain = "household",
    threshold: float = THRESHOLD,
) -> Instruction:
    """The instruction of which nothing is left open: a text as the robot understands it, or a reading of one.

    `ask` is asked which control flow is meant where that is less certain than `threshold`, from 0 (never) to 1, and for
    each argument that is missing. Its answers are arguments without words of their own. Given to `reset` as the
    instruction and to `TreeAgent` as the flow, robot and judge go by the same.

    Raises `InputError` for text without a known task, unknown words, impossible goals, unanswered questions, answers
    that are no text, a threshold beyond 0 and 1, and for what is no instruction or no function to ask.
    """
    check_threshold(threshold)
    check_ask(ask)
    ask = _in_words(ask)
    known = domain if isinstance(domain, Domain) else load_domain(domain)
    reading = _read(instruction, known)
    chosen = distributed(settled(reading, known.ontology, ask, threshold=threshold))
    answers: dict[int, list[Argument]] = defaultdict(list)

    def answer(missing: Missing) -> str | None:
        said = ask(missing)
        if said:
            answers[missing.task].append(Argument(missing.argument, said))
        return said

    ground(chosen, known, ask=answer)
    return _completed(chosen, answers) if answers else chosen


def _read(instruction: Any, domain: Domain) -> Instruction:
    if isinstance(instruction, str):
        return understood(instruction, domain)
    if isinstance(instruction, Instruction):
        return check_instruction(instruction)
    raise InputError(f"instruction is a {type(instruction).__name__}; expected a text or an Instruction")


def check_ask(ask: Any) -> None:
    """Raises `InputError` for what cannot be asked."""
    if not callable(ask):
        raise InputError(f"ask is {ask!r}; expected a function that answers a question")


def check_threshold(threshold: float) -> None:
    """Raises `InputError` for what is no number from 0 to 1."""
    if not isinstance(threshold, (int, float)) or not 0 <= threshold <= 1:
        raise InputError(f"threshold is {threshold!r}; expected a number from 0 (never ask) to 1")


def _in_words(ask: Ask) -> Ask:
    """The same, its answers checked to be text and blank ones taken for none."""

    def answer(asked: Missing | Doubt) -> str | None:
        said = ask(asked)
        if said is not None and not isinstance(said, str):
            raise InputError(f"the answer to {asked.question!r} is {said!r}; expected text or None")
        return said if said is not None and said.strip() else None

    return answer


def understood(text: str, domain: Domain) -> Instruction:
    """The text as the robot reads it. Raises `InputError` for text without a known task."""
    # Only here is language needed; a gold flow runs without it.
    from decomplex_bt.understanding.interpreter import Interpreter

    # The words are the folder's; the house may be another one.
    return with_tasks(Interpreter.load(domain.folder).interpret(text), domain)


def with_tasks(instruction: Instruction, domain: Domain) -> Instruction:
    """The instruction, if it asks for anything. Raises `InputError`."""
    if instruction.tasks:
        return instruction
    known = (kind.description.split(",")[0] for kind in domain.ontology.task_types.values())
    raise InputError(
        f"{quoted(instruction.text)} holds no task that this robot knows; what it does: {', '.join(known)}"
    )


def _completed(instruction: Instruction, answers: Mapping[int, Sequence[Argument]]) -> Instruction:
    tasks = tuple(replace(task, arguments=(*task.arguments, *answers.get(task.id, ()))) for task in instruction.tasks)
    missing = tuple(m for m in instruction.missing if not any(a.type == m.argument for a in answers.get(m.task, ())))
    return replace(instruction, tasks=tasks, missing=missing)
