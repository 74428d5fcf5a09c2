"""What the leaves of one tree share during one episode: the body, the belief, the planner, the action of this tick."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from decomplex_bt.behaviour.embodiment import Embodiment
from decomplex_bt.behaviour.failure import Failure
from decomplex_bt.behaviour.foresight import leads_to_goal
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.plan_check import checked
from decomplex_bt.planning.planner import Planner, PlanResult
from decomplex_bt.planning.problem import Problem, belief_problem
from decomplex_bt.planning.pursuit import Bindings

Fingerprint = tuple[str | None, ...]


@dataclass
class Session:
    """One episode's shared state; each tree has its own, so trees in one process have nothing in common.

    `observation` is this tick's. `action` is what the running leaf wants done in this tick, None until it says so.
    `is_out_of_time`: the time limit has ended the episode. `bindings`: what phrases have turned out to mean.
    `failures`: why tasks failed, in order. `plans` and `replans` are counts over the episode.
    """

    embodiment: Embodiment
    belief: Belief
    planner: Planner
    make_problem: Callable[..., Problem] = belief_problem
    observation: Any = None
    action: Any = None
    is_out_of_time: bool = False
    bindings: Bindings = field(default_factory=dict)
    failures: list[Failure] = field(default_factory=list)
    plans: int = 0
    replans: int = 0
    _steps: tuple[GroundAction, ...] = ()
    _names: tuple[str, ...] = ()
    _states: tuple[tuple[str, str], ...] = ()

    def begin_tick(self, observation: Any) -> None:
        """Takes an observation in: the belief is fed, the last action forgotten. One that the body refuses changes
        nothing."""
        percept = self.embodiment.perceive(observation)
        self.observation, self.action = observation, None
        self.belief.update(percept)

    def fingerprint(self, steps: tuple[GroundAction, ...]) -> Fingerprint:
        """What is believed of everything that these steps are about; equal fingerprints, same prospects."""
        belief = self.belief
        if steps is not self._steps:
            self._steps = steps
            self._names = tuple(dict.fromkeys(name for step in steps for name in step.objects))
            self._states = tuple((name, pair) for name in self._names for pair in belief.domain.kinds.state_pairs)
        state, place_of = belief.state, belief.place_of
        return (
            belief.held,
            *belief.tray,
            *(place_of(name) for name in self._names),
            *(state(name, pair) for name, pair in self._states),
        )

    def still_works(self, goal_atoms: tuple[Atom, ...], steps: tuple[GroundAction, ...]) -> bool:
        """Whether these steps, the first of them under way, still lead to the goal from what is believed now."""
        return leads_to_goal(self.make_problem(self.belief, goal_atoms), steps)

    def plan(self, goal_atoms: tuple[Atom, ...], forbidden: tuple[GroundAction, ...] = ()) -> PlanResult:
        """A plan from what is believed now, without the forbidden steps; UNSUPPORTED where it cannot be one."""
        self.plans += 1
        problem = self.make_problem(self.belief, goal_atoms, forbidden=forbidden)
        return checked(self.planner.solve(problem), problem, self.belief.domain)
