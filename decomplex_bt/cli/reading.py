"""One instruction given on the command line: understood, and completed by asking where somebody is there to answer."""

from __future__ import annotations

import sys
from collections import defaultdict
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from decomplex_bt.cli.output import remark
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import Argument, Doubt, Instruction, Missing, escaped

if TYPE_CHECKING:
    from decomplex_bt.domain.loader import Domain
    from decomplex_bt.planning.ground_task import GroundInstruction


@dataclass(frozen=True)
class Reading:
    """An instruction as the robot understands it, in words and in the house's names."""

    domain: Domain
    instruction: Instruction
    grounded: GroundInstruction


def read(text: str, domain: str | Path, *, may_ask: bool, threshold: float | None = None) -> Reading:
    """Understands and grounds a text. `may_ask`: what is missing is asked for on the terminal, and what was meant where
    the control flow is less certain than `threshold` (0 to 1; None: `doubt.THRESHOLD`). What the reading warns of goes
    to standard error.

    Raises `InputError` for text without a known task, unknown words, impossible goals and unanswered questions.
    """
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.planning.grounding import ground
    from decomplex_bt.understanding.doubt import THRESHOLD
    from decomplex_bt.understanding.interpreter import Interpreter

    loaded = load_domain(domain)
    instruction = Interpreter.load(loaded).interpret(text)
    if not instruction.tasks:
        kinds = (kind.description.split(",")[0] for kind in loaded.ontology.task_types.values())
        raise InputError(f"{text!r} holds no task that this robot knows; it {', '.join(kinds)}")
    may_ask = may_ask and sys.stdin.isatty()
    if may_ask:
        instruction = _settled(instruction, loaded, THRESHOLD if threshold is None else threshold)
    answers: dict[int, list[Argument]] = defaultdict(list)

    def ask(missing: Missing) -> str | None:
        answer = _prompt(missing)
        if answer is not None:
            answers[missing.task].append(Argument(missing.argument, answer))
        return answer

    grounded = ground(instruction, loaded, ask=ask if may_ask else None)
    for warning in instruction.warnings:
        remark(f"warning: {escaped(warning)}")
    return Reading(loaded, _completed(instruction, answers), grounded)


def _settled(instruction: Instruction, domain: Domain, threshold: float) -> Instruction:
    """The instruction after an answer that fits; as it was where nothing is in doubt, or nothing is answered."""
    from decomplex_bt.understanding.doubt import doubt_of, resolved

    doubt = doubt_of(instruction, domain.ontology, threshold=threshold)
    while doubt is not None and (answer := _prompt(doubt)) is not None:
        chosen = resolved(instruction, doubt, answer)
        if chosen is not None:
            return chosen
        remark(f"{answer!r} is not one of these; answer with a number or in the words of one, or just press Enter")
    return instruction


def _prompt(question: Missing | Doubt) -> str | None:
    """The answer from the terminal, None for none. The choices of a doubt are numbered, for a number will do."""
    said = question.question
    if isinstance(question, Doubt):
        said += "".join(f"\n  {n}: {choice.text}" for n, choice in enumerate(question.choices, start=1)) + "\n"
    sys.stderr.write(f"{said} ")
    sys.stderr.flush()
    return sys.stdin.readline().strip() or None


def _completed(instruction: Instruction, answers: dict[int, list[Argument]]) -> Instruction:
    """The instruction with the answers as arguments that have no words of their own."""
    tasks = tuple(replace(task, arguments=(*task.arguments, *answers.get(task.id, ()))) for task in instruction.tasks)
    missing = tuple(m for m in instruction.missing if not any(a.type == m.argument for a in answers.get(m.task, ())))
    return replace(instruction, tasks=tasks, missing=missing)
