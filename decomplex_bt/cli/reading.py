"""One instruction given on the command line: understood, and completed by asking where somebody is there to answer."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from decomplex_bt.cli.output import remark
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.instruction import Doubt, Instruction, Missing, escaped

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
    from decomplex_bt.behaviour.settling import understood
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.planning.grounding import ground
    from decomplex_bt.understanding.doubt import THRESHOLD

    loaded = load_domain(domain)
    instruction = understood(text, loaded)
    if may_ask and sys.stdin is not None and sys.stdin.isatty():
        instruction = _settled(instruction, loaded, THRESHOLD if threshold is None else threshold)
    grounded = ground(instruction, loaded)
    for warning in instruction.warnings:
        remark(f"warning: {escaped(warning)}")
    return Reading(loaded, instruction, grounded)


def _settled(instruction: Instruction, domain: Domain, threshold: float) -> Instruction:
    """The instruction with what it leaves open asked for on the terminal; what cannot be used is asked for again."""
    from decomplex_bt.behaviour.settling import settle

    answers: dict[Missing | Doubt, str | None] = {}

    def ask(question: Missing | Doubt) -> str | None:
        if question not in answers:
            answers[question] = _answer(instruction, question)
        return answers[question]

    while True:
        try:
            return settle(instruction, ask, domain=domain, threshold=threshold)
        except (UnknownWordError, ImpossibleGoalError) as error:
            unusable = _answered_with(error, answers)
            if unusable is None:
                raise
            remark(f"{escaped(str(error))}; answer otherwise, or just press Enter")
            del answers[unusable]


def _answered_with(
    error: UnknownWordError | ImpossibleGoalError, answers: dict[Missing | Doubt, str | None]
) -> Missing | None:
    """The question whose answer, the latest about the task, an error can be of; None where it is of the text."""
    for question, answer in reversed(answers.items()):
        if isinstance(question, Missing) and question.task == error.task and answer is not None:
            is_told = not isinstance(error, UnknownWordError) or error.phrase.casefold() in answer.casefold()
            if is_told:
                return question
    return None


def _answer(instruction: Instruction, question: Missing | Doubt) -> str | None:
    """The answer from the terminal; for a doubt one that fits, or none."""
    from decomplex_bt.understanding.doubt import resolved

    while (answer := _prompt(question)) is not None:
        if not isinstance(question, Doubt) or resolved(instruction, question, answer) is not None:
            return answer
        remark(f"{answer!r} is not one of these; answer with a number or in the words of one, or just press Enter")
    return None


def _prompt(question: Missing | Doubt) -> str | None:
    """The answer from the terminal, None for none. The choices of a doubt are numbered, for a number will do."""
    said = question.question
    if isinstance(question, Doubt):
        said += "".join(f"\n  {n}: {choice.text}" for n, choice in enumerate(question.choices, start=1)) + "\n"
    sys.stderr.write(f"{said} ")
    sys.stderr.flush()
    return sys.stdin.readline().strip() or None
