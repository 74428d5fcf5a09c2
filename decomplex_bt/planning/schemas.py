"""Action schemas: the actions of the PDDL domain as values, for those who must know effects without a planner."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache

from decomplex_bt.domain.contract import FLUENTS
from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.pddl import conjuncts, pddl_sections
from decomplex_bt.domain.sexpr import Sexpr, typed_list
from decomplex_bt.planning.pddl import Atom, GroundAction

Lifted = tuple[str, tuple[int, ...]]
"""An atom with the positions of an action's parameters in place of objects."""


@dataclass(frozen=True, slots=True)
class Schema:
    """An action of the domain: the types of the objects it takes, what it needs, what it makes true and what false."""

    types: tuple[str, ...]
    preconditions: tuple[Lifted, ...]
    adds: tuple[Lifted, ...]
    deletes: tuple[Lifted, ...]


def ground_atoms(atoms: tuple[Lifted, ...], step: GroundAction) -> Iterator[Atom]:
    """The atoms of a schema for the objects of a step."""
    for predicate, positions in atoms:
        yield Atom(predicate, tuple(step.objects[position] for position in positions))


@cache
def read_schemas(domain_pddl: str) -> Mapping[str, Schema]:
    """The actions of a PDDL domain by name."""
    schemas: dict[str, Schema] = {}
    for section in pddl_sections(domain_pddl)[":action"]:
        parts = {str(key): value for key, value in zip(section[1::2], section[2::2], strict=True)}
        typed = list(typed_list(_as_tuple(parts[":parameters"])))
        parameters = [name for name, _ in typed]
        effects = list(conjuncts(parts[":effect"]))
        schemas[str(section[0])] = Schema(
            tuple(of for _, of in typed),
            tuple(_lift(atom, parameters) for atom in conjuncts(parts[":precondition"])),
            tuple(_lift(atom, parameters) for atom in effects if atom[0] != "not"),
            tuple(_lift(_as_tuple(atom[1]), parameters) for atom in effects if atom[0] == "not"),
        )
    return schemas


def values_after(step: GroundAction, domain: Domain) -> dict[tuple[str, str], str]:
    """The values of (entity, state pair) that a step brings about; empty for an action the domain does not have."""
    of_fluent = _values_of_fluents(domain)
    schema = read_schemas(domain.domain_pddl).get(step.name)
    adds = ground_atoms(schema.adds, step) if schema is not None else ()
    return {
        (atom.objects[0], of_fluent[atom.predicate][0]): of_fluent[atom.predicate][1]
        for atom in adds
        if atom.predicate in of_fluent
    }


def news_after(step: GroundAction, domain: Domain) -> tuple[Atom, ...]:
    """What a step makes true in fluents of the domain's own, of which nothing but the step tells."""
    schema = read_schemas(domain.domain_pddl).get(step.name)
    adds = ground_atoms(schema.adds, step) if schema is not None else ()
    known = FLUENTS.keys() | _values_of_fluents(domain).keys()
    return tuple(atom for atom in adds if atom.predicate not in known)


@lru_cache(maxsize=32)
def _values_of_fluents(domain: Domain) -> dict[str, tuple[str, str]]:
    """State pair and value of every fluent that says a state."""
    pairs = domain.kinds.state_pairs.items()
    return {domain.goals.fluent(value): (name, value) for name, pair in pairs for value in pair.values}


def _lift(atom: tuple[Sexpr, ...], parameters: Sequence[str]) -> Lifted:
    return str(atom[0]), tuple(parameters.index(str(term)) for term in atom[1:])


def _as_tuple(expression: Sexpr) -> tuple[Sexpr, ...]:
    return expression if isinstance(expression, tuple) else (expression,)
