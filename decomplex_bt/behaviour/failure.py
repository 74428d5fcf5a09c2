"""A failure as a value: what went wrong, where in the instruction and where in the plan."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from decomplex_bt.planning.pddl import GroundAction

Stage = Literal["understanding", "grounding", "planning", "execution"]


@dataclass(frozen=True, slots=True)
class Failure:
    """Why a task failed.

    `task`: its number, None where no single task is to blame. `words`: the span of its verb in the instruction (code
    points, end exclusive). `action`: the plan step at which it failed, None where there was no plan. `expected` and
    `observed`: what the step or the plan was to bring about, and what came instead. `attempts`: plans that were tried.
    """

    stage: Stage
    task: int | None
    words: tuple[int, int] | None
    action: GroundAction | None
    expected: str
    observed: str
    attempts: int = 0

    @property
    def reason(self) -> str:
        """In one line: what was observed instead of what was expected."""
        return self.observed if not self.expected else f"{self.observed} (expected: {self.expected})"

    def to_json(self) -> dict[str, Any]:
        """As `run --json` prints it."""
        return {
            "stage": self.stage,
            "task": self.task,
            "words": list(self.words) if self.words is not None else None,
            "action": str(self.action) if self.action is not None else None,
            "reason": self.reason,
            "attempts": self.attempts,
        }

    def __str__(self) -> str:
        where = f"task {self.task}: " if self.task is not None else ""
        at = f" at {self.action}" if self.action is not None else ""
        return f"{where}{self.stage}{at}: {self.reason}"
