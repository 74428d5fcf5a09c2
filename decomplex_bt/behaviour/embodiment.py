"""The two protocols through which a behaviour tree reaches a body, simulated or real."""

from __future__ import annotations

from enum import Enum
from typing import Any, NamedTuple, Protocol

from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.percept import Percept


class SkillStatus(Enum):
    """How a skill stands after a tick."""

    RUNNING = "running"
    SUCCESS = "success"
    FAILURE = "failure"


class SkillTick(NamedTuple):
    """What a skill wants done now. `action` is what the body's environment takes; `reason` says why it failed."""

    status: SkillStatus
    action: Any
    reason: str = ""


class Skill(Protocol):
    """One PDDL action carried out in closed loop, on observations alone."""

    def tick(self, observation: Any) -> SkillTick:
        """One tick's work; never waits. After SUCCESS or FAILURE it is not ticked again."""

    def stop(self) -> Any:
        """Ends the skill at once, finished or not; returns the action that brings the body to rest within one step."""


class Embodiment(Protocol):
    """A body: it makes percepts of observations and skills of plan steps; it holds no reference to the true world.

    `domain`: what it lives in, the house map included. `ended`: the observation with which the episode has ended, None
    while it runs; `is_out_of_time`: whether it has ended by the time limit (a body need not have these two; the agent
    then learns of an end only by what it did itself).
    """

    domain: Domain
    ended: Any
    is_out_of_time: bool

    def reset(self, observation: Any) -> None:
        """Forgets the last episode."""

    def perceive(self, observation: Any) -> Percept:
        """The observation in the domain's names."""

    def skill(self, step: GroundAction) -> Skill:
        """A fresh skill for this step. Raises `KeyError` for an action it has no skill for."""

    def rest(self) -> Any:
        """The action that does nothing."""

    def finish(self) -> Any:
        """The action that ends the episode."""
