"""Looking ahead: whether the rest of a plan still leads to its goal, by the actions of the PDDL domain."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.problem import Problem
from decomplex_bt.planning.schemas import ground_atoms, read_schemas

WHEREABOUTS = ("at", "in-room")
"""Fluents that say where the robot is: in the middle of a step they are neither as before it nor as after."""


def leads_to_goal(problem: Problem, steps: Sequence[GroundAction]) -> bool:
    """Whether the goal holds after these steps, each of them possible when its turn comes.

    The first step counts as under way: where the robot is now is as that step needs it. What no action changes is not
    asked about, for it was so when the plan was made.
    """
    schemas = read_schemas(problem.domain_pddl)
    fluents = _fluents(problem.domain_pddl)
    state = {atom for atom in problem.init if atom.predicate not in WHEREABOUTS}
    for index, step in enumerate(steps):
        schema = schemas[step.name]
        for atom in ground_atoms(schema.preconditions, step):
            if index == 0 and atom.predicate in WHEREABOUTS:
                state.add(atom)
            elif atom not in state and atom.predicate in fluents:
                return False
        state.difference_update(ground_atoms(schema.deletes, step))
        state.update(ground_atoms(schema.adds, step))
    return set(problem.goal) <= state | {atom for atom in problem.init if atom.predicate in WHEREABOUTS}


@cache
def _fluents(domain_pddl: str) -> frozenset[str]:
    """The predicates that actions change."""
    schemas = read_schemas(domain_pddl).values()
    changed = {predicate for schema in schemas for predicate, _ in (*schema.adds, *schema.deletes)}
    return frozenset(changed)
