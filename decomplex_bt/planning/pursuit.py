"""The pursuit of one task at run time: what to bring about next, or that it is done or past hope.

How the leaf of a behaviour tree uses it (`bindings` is shared by all leaves of an instruction, `since` is the belief's
tick when the task became due):

    belief.update(percept)                               # every tick
    pursuit = pursue(task, belief, bindings, since=since)
    bindings = pursuit.bindings
    if pursuit.status is ONGOING:                        # keep the running plan while pursuit.goal_atoms stay the same
        problem = belief_problem(belief, pursuit.goal_atoms)     # planning/problem.py
        result = planner.solve(problem)                          # planning/planner.py
        if result.status is not SOLVED: belief.give_up(pursuit.goal_atoms, result.reason)   # and pursue again
        else run the skills of result.steps in order; a skill's end is reported by
            belief.succeeded(step)   or   belief.failed(step, reason)                        # and pursue again

`pursue` is a pure function of its arguments and cheap; calling it whenever `belief.revision` has changed lets the leaf
see at once that a thing has turned up on the way, or that the goal holds already.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING

from decomplex_bt.planning.ground_task import GroundTask, Referent
from decomplex_bt.planning.pddl import Atom

if TYPE_CHECKING:
    from decomplex_bt.planning.belief import Belief

Bindings = Mapping[Referent, tuple[str, ...]]
"""Which entities a referent has turned out to mean; final once a task that names it is done."""


class PursuitStatus(Enum):
    """How a task stands."""

    ONGOING = "ongoing"
    DONE = "done"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class Pursuit:
    """How a task stands and what to bring about next.

    `goal_atoms` (ONGOING): the goal of the next plan. `truth` (DONE, FAILED): what the task is as a condition: true,
    false, or None where it is neither, which is a failure with the `reason` whatever the flow. As a plain step DONE is
    success and FAILED failure. `doing`: in words what is being done now, for feedback. `bindings` replaces the bindings
    that were handed in.
    """

    status: PursuitStatus
    goal_atoms: tuple[Atom, ...] = ()
    truth: bool | None = None
    reason: str = ""
    doing: str = ""
    bindings: Bindings = field(default_factory=dict)


def pursue(task: GroundTask, belief: Belief, bindings: Bindings, *, since: int) -> Pursuit:
    """How the task stands, by what the robot has perceived since `belief.tick` was `since` (contracts.md)."""
    raise NotImplementedError
