"""The planner protocol: a problem in, a result out."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Protocol

from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.problem import Problem


class PlanStatus(Enum):
    """How a search for a plan ended. Only UNSOLVABLE shows that there is no plan: after TIMEOUT there may be one."""

    SOLVED = "solved"
    UNSOLVABLE = "unsolvable"
    TIMEOUT = "timeout"
    UNSUPPORTED = "unsupported"

    @property
    def is_final(self) -> bool:
        """Whether it settles whether there is a plan."""
        return self in (PlanStatus.SOLVED, PlanStatus.UNSOLVABLE)


@dataclass(frozen=True, slots=True)
class PlanResult:
    """What a planner found. `steps`: the plan when SOLVED, empty if the goal holds already. `reason`: why not, else.

    `evaluations`: states looked at. `seconds`: wall time of the search that found it, 0 from the cache.
    """

    status: PlanStatus
    steps: tuple[GroundAction, ...] = ()
    reason: str = ""
    evaluations: int = 0
    seconds: float = 0.0

    @property
    def is_solved(self) -> bool:
        return self.status is PlanStatus.SOLVED

    def __str__(self) -> str:
        if self.is_solved:
            return "\n".join(map(str, self.steps))
        return f"{self.status.value}: {self.reason}" if self.reason else self.status.value


class Planner(Protocol):
    """Anything that finds plans."""

    def solve(self, problem: Problem) -> PlanResult:
        """A plan for the problem. Never raises for a problem that is well formed: what went wrong is in the status.

        UNSOLVABLE only where it is shown that there is no plan: whether something can be done is judged by it.
        """
