"""Looking ahead: whether the rest of a plan still leads to its goal, by the actions of the PDDL domain."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from decomplex_bt.domain.goals import pddl_sections
from decomplex_bt.domain.sexpr import Sexpr, typed_list
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.problem import Problem

WHEREABOUTS = ("at", "in-room")
"""Fluents that say where the robot is: in the middle of a step they are neither as before it nor as after."""


@dataclass(frozen=True, slots=True)
class Schema:
    """An action of the domain. Atoms have the parameters' positions in place of objects: (predicate, positions)."""

    preconditions: tuple[tuple[str, tuple[int, ...]], ...]
    adds: tuple[tuple[str, tuple[int, ...]], ...]
    deletes: tuple[tuple[str, tuple[int, ...]], ...]


def leads_to_goal(problem: Problem, steps: Sequence[GroundAction]) -> bool:
    """Whether the goal holds after these steps, each of them possible when its turn comes.

    The first step counts as under way: where the robot is now is as that step needs it. What no action changes is not
    asked about, for it was so when the plan was made.
    """
    schemas = _schemas(problem.domain_pddl)
    fluents = _fluents(problem.domain_pddl)
    state = {atom for atom in problem.init if atom.predicate not in WHEREABOUTS}
    for index, step in enumerate(steps):
        schema = schemas[step.name]
        for atom in _ground(schema.preconditions, step):
            if index == 0 and atom.predicate in WHEREABOUTS:
                state.add(atom)
            elif atom not in state and atom.predicate in fluents:
                return False
        state.difference_update(_ground(schema.deletes, step))
        state.update(_ground(schema.adds, step))
    return set(problem.goal) <= state | {atom for atom in problem.init if atom.predicate in WHEREABOUTS}


def _ground(atoms: tuple[tuple[str, tuple[int, ...]], ...], step: GroundAction) -> Iterator[Atom]:
    for predicate, positions in atoms:
        yield Atom(predicate, tuple(step.objects[position] for position in positions))


@cache
def _fluents(domain_pddl: str) -> frozenset[str]:
    """The predicates that actions change, but for `within`: it changes for people alone."""
    schemas = _schemas(domain_pddl).values()
    changed = {predicate for schema in schemas for predicate, _ in (*schema.adds, *schema.deletes)}
    return frozenset(changed - {"within"})


@cache
def _schemas(domain_pddl: str) -> Mapping[str, Schema]:
    schemas: dict[str, Schema] = {}
    for section in pddl_sections(domain_pddl)[":action"]:
        parts = {str(key): value for key, value in zip(section[1::2], section[2::2], strict=True)}
        parameters = [name for name, _ in typed_list(_as_tuple(parts.get(":parameters", ())))]
        effects = list(_conjuncts(parts.get(":effect", ())))
        schemas[str(section[0])] = Schema(
            tuple(_lift(atom, parameters) for atom in _conjuncts(parts.get(":precondition", ()))),
            tuple(_lift(atom, parameters) for atom in effects if atom[0] != "not"),
            tuple(_lift(_as_tuple(atom[1]), parameters) for atom in effects if atom[0] == "not"),
        )
    return schemas


def _conjuncts(expression: Sexpr) -> Iterator[tuple[Sexpr, ...]]:
    items = _as_tuple(expression)
    if items and items[0] == "and":
        yield from (_as_tuple(item) for item in items[1:])
    elif items:
        yield items


def _lift(atom: tuple[Sexpr, ...], parameters: Sequence[str]) -> tuple[str, tuple[int, ...]]:
    return str(atom[0]), tuple(parameters.index(str(term)) for term in atom[1:])


def _as_tuple(expression: Sexpr) -> tuple[Sexpr, ...]:
    return expression if isinstance(expression, tuple) else (expression,)
