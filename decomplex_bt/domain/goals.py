"""Goals of tasks: templates over the fluents of the PDDL domain, filled from a task's arguments (DeComplex, III-E)."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping
from functools import lru_cache
from typing import Annotated

from pydantic import Field, field_validator

from decomplex_bt.domain.document import Format, Record
from decomplex_bt.domain.pddl import Signatures, Types
from decomplex_bt.errors import InputError, among

Filled = tuple[str, ...]
"""A filled atom: predicate and objects."""
STATE = "state"
"""The role that takes a state value; it is no object, and as a predicate it stands for the value's fluent."""
FACT = "fact"
"""The role, beside the arguments of a task, of what a check wants to know."""
_ATOM = re.compile(r"\((?:[\w-]+|\{state\})(?: \{\w+\})*\)")


class GoalTemplate(Record):
    """What to bring about for a task with these roles. `of`: role to PDDL type; `atoms`: with roles in braces."""

    of: dict[str, str] = Field(min_length=1)
    atoms: tuple[str, ...] = Field(min_length=1)

    @field_validator("atoms")
    @classmethod
    def _check_atoms(cls, atoms: tuple[str, ...]) -> tuple[str, ...]:
        for atom in atoms:
            if not _ATOM.fullmatch(atom):
                raise ValueError(f"{atom!r} is no atom; expected one as in '(lies {{object}} {{goal}})'")
        return atoms

    def parts(self) -> Iterator[Filled]:
        """The atoms as written, split into predicate and terms."""
        yield from map(_parts, self.atoms)


class Goals(Record):
    """`goals.yaml`. `fluents`: the fluent of a state value, where it is not named by the value itself."""

    format: Format
    fluents: dict[str, str] = {}
    goals: dict[str, Annotated[tuple[GoalTemplate, ...], Field(min_length=1)]]

    def fluent(self, value: str) -> str:
        """The predicate that says a thing is in this state."""
        return self.fluents.get(value, value)

    def fill(
        self, task_type: str, roles: Mapping[str, str], has_type: Callable[[str, str], bool]
    ) -> tuple[Filled, ...]:
        """The goal of a task whose roles are filled with these objects.

        `has_type` says whether an object is of a PDDL type; the role `state` takes a state value and needs none.
        Raises `InputError` where no template of the task type fits.
        """
        templates = self.goals.get(task_type, ())
        for template in templates:
            if all(role in roles and (role == STATE or has_type(roles[role], of)) for role, of in template.of.items()):
                return _filled(template.atoms, *roles.items(), (STATE, self.fluent(roles.get(STATE, ""))))
        known = "; or ".join(", ".join(f"{role}: {of}" for role, of in template.of.items()) for template in templates)
        raise InputError(
            f"there is no goal of {task_type} with {', '.join(f'{role}: {name}' for role, name in roles.items())}; "
            f"goals.yaml has {f'those with {known}' if known else 'none'}: add one, or say the instruction otherwise"
        )


@lru_cache(maxsize=4096)
def _filled(atoms: tuple[str, ...], *words: tuple[str, str]) -> tuple[Filled, ...]:
    """A template's atoms with words for its roles, a later one before an earlier; asked again at every decision."""
    spoken = dict(words)
    return tuple(tuple(part.format(**spoken) for part in parts) for parts in map(_parts, atoms))


def _parts(atom: str) -> Filled:
    return tuple(atom.strip("()").split())


def check_goals(
    goals: Goals,
    predicates: Signatures,
    types: Types,
    values: Collection[str],
    arguments: Collection[str],
) -> None:
    """Raises `ValueError` where a template or a state value has no fluent, or one with other objects, and where a role
    or its type is unknown. `arguments`: the argument types, which are roles."""
    if unknown := [value for value in goals.fluents if value not in values]:
        raise ValueError(f"fluents: {unknown[0]!r} is no state value of kinds.yaml{among(unknown[0], values)}")
    called: dict[str, str] = {}
    for value in values:
        if (other := called.setdefault(goals.fluent(value), value)) != value:
            raise ValueError(
                f"fluents: {other!r} and {value!r} are both called {goals.fluent(value)}; each state value has a "
                "fluent of its own"
            )
        if len(predicates.get(goals.fluent(value), ())) != 1:
            raise ValueError(f"the state {value!r} has no fluent ({goals.fluent(value)} ?object) in domain.pddl")
    for task_type, templates in goals.goals.items():
        for template in templates:
            _check_template(f"goals.{task_type}", template, predicates, types, arguments)


def _check_template(
    where: str,
    template: GoalTemplate,
    predicates: Signatures,
    types: Types,
    arguments: Collection[str],
) -> None:
    for role, of in template.of.items():
        if role not in (*arguments, FACT):
            raise ValueError(f"{where}: the role {role!r} is neither an argument type of ontology.yaml nor {FACT!r}")
        if role != STATE and of not in types:
            raise ValueError(f"{where}: {role} is of the type {of!r}, which domain.pddl does not have")
    for predicate, *terms in template.parts():
        if unknown := [term for term in terms if term.strip("{}") not in template.of]:
            raise ValueError(f"{where}: {unknown[0]} stands for none of the roles {sorted(template.of)}")
        if predicate == f"{{{STATE}}}":
            continue
        signature = predicates.get(predicate)
        if signature is None or len(signature) != len(terms):
            raise ValueError(f"{where}: domain.pddl has no ({predicate} ...) of {len(terms)} objects")
        for term, takes in zip(terms, signature, strict=True):
            of = template.of[term.strip("{}")]
            if not types.is_a(of, takes):
                raise ValueError(f"{where}: {term} is of the type {of!r}; ({predicate} ...) takes {takes!r}")
