"""What the judge says of an episode, as frozen values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from decomplex_bt.domain.nouns import be

CauseKind = Literal["thing nowhere", "person out", "device broken", "place not reachable", "goal not possible"]
"""All that makes an instruction infeasible in a world."""


@dataclass(frozen=True, slots=True)
class Cause:
    """Why a task cannot be done in the true world, whoever tries: `entity` is what it is about, or the phrase."""

    kind: CauseKind
    entity: str
    task: int

    def __str__(self) -> str:
        name = self.entity.replace("_", " ")
        says = {
            "thing nowhere": f"{name} {be(name)} nowhere in the house",
            "person out": f"{name} is out",
            "device broken": f"{name} {be(name)} broken",
            "place not reachable": f"{name} cannot be reached",
            "goal not possible": f"{name} cannot be made so",
        }[self.kind]
        return f"task {self.task}: {says}"


@dataclass(frozen=True, slots=True)
class Branch:
    """A condition that was reached: its number, its truth (None: undecided) and the branch it led to, if any."""

    task: int
    truth: bool | None
    taken: Literal["then", "else"] | None

    def to_json(self) -> dict[str, Any]:
        return {"task": self.task, "truth": self.truth, "taken": self.taken}


@dataclass(frozen=True, slots=True)
class Violation:
    """A task that was not due and was brought about all the same; `due` is the task that was."""

    task: int
    due: int | None
    reason: str

    def __str__(self) -> str:
        return self.reason


@dataclass(frozen=True, slots=True)
class Verdict:
    """How an episode stands.

    `met`, `total`: tasks and conditions due that are settled, and all that are due in this world. `is_over`: success or
    a violation. `unsettled`: the task that is due now, None when nothing is left.
    """

    is_success: bool
    met: int
    total: int
    branches: tuple[Branch, ...]
    violations: tuple[Violation, ...]
    unsettled: int | None

    @property
    def is_over(self) -> bool:
        return self.is_success or bool(self.violations)
