"""Settling: what an instruction leaves open is asked for, so that robot and judge are given the same reading."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import InputError, is_whole, quoted
from decomplex_bt.instruction import Argument, Choice, Doubt, Instruction, Missing, check_instruction
from decomplex_bt.planning.distribution import distributed
from decomplex_bt.planning.grounding import ground
from decomplex_bt.understanding.doubt import THRESHOLD, settled

Answer = str | int | Choice | None
Ask = Callable[[Missing | Doubt], Answer]
"""Answers the `question` of what is missing, in words, or in doubt, with one of its `choices`, with the number of one,
from 1, as a number or in writing, or in the words of one, whole or in part. None or blank text is no answer."""


def settle(
    instruction: str | Instruction,
    ask: Ask,
    *,
    domain: str | Path | Domain = "household",
    threshold: float = THRESHOLD,
) -> Instruction:
    """The instruction of which nothing is left open: a text as the robot understands it, or a reading of one.

    `ask` is given a `Doubt` where it is less certain than `threshold`, from 0 (never) to 1, which control flow is
    meant, and a `Missing` for each argument that is nowhere said; both have a `question`. It answers

    - a `Doubt` with one of its `choices`, its number, from 1, or its `text`, or with None: then the likeliest is taken;
    - a `Missing` with the words that were left out ("on the desk"); they become an argument without words of its own.

    What comes of it is given to `reset` as the instruction and to `TreeAgent` as the flow, so that robot and judge go
    by the same; a `TreeAgent` without a flow reads the text anew, in which what was asked for is not said.

    Raises `InputError` for text without a known task, unknown words, impossible goals, what is missing and is not
    answered (`MissingArgumentError`), answers that are no choice or, to a `Missing`, no text, a threshold beyond 0 and
    1, and for what is no instruction or no function to ask.
    """
    check_threshold(threshold)
    check_ask(ask)
    known = domain if isinstance(domain, Domain) else load_domain(domain)
    reading = _read(instruction, known)
    chosen = distributed(settled(reading, known.ontology, lambda doubt: _choice(ask, doubt), threshold=threshold))
    answers: dict[int, list[Argument]] = defaultdict(list)

    def answer(missing: Missing) -> str | None:
        said = _words(ask, missing)
        if said is not None:
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


def _words(ask: Ask, missing: Missing) -> str | None:
    """The answer to what is missing; None for none, as blank text is."""
    said = ask(missing)
    if said is not None and not isinstance(said, str):
        raise InputError(f"the answer to {missing.question!r} is {said!r}; expected text or None")
    return said if said is not None and said.strip() else None


def _choice(ask: Ask, doubt: Doubt) -> Answer:
    """The answer to what is in doubt; None for none, as blank text is."""
    said = ask(doubt)
    if said is not None and not (isinstance(said, (str, Choice)) or is_whole(said)):
        raise InputError(f"the answer to {doubt.question!r} is {said!r}; expected one of its choices or None")
    return None if isinstance(said, str) and not said.strip() else said


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
