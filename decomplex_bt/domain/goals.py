"""Goals of tasks: templates over the fluents of the PDDL domain, filled from a task's arguments (DeComplex, III-E)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache

from pydantic import Field

from decomplex_bt.domain.document import Record
from decomplex_bt.domain.sexpr import Sexpr, read_sexpr, typed_list

Filled = tuple[str, ...]
"""A filled atom: predicate and objects."""


class GoalTemplate(Record):
    """What to bring about for a task with these roles. `of`: role to PDDL type; `atoms`: with roles in braces."""

    of: dict[str, str] = Field(min_length=1)
    atoms: tuple[str, ...] = Field(min_length=1)

    def parts(self) -> Iterator[Filled]:
        """The atoms as written, split into predicate and terms."""
        yield from map(_parts, self.atoms)


class Goals(Record):
    """`goals.yaml`. `fluents`: the fluent of a state value, where it is not named by the value itself."""

    format: int
    fluents: dict[str, str] = {}
    goals: dict[str, tuple[GoalTemplate, ...]]

    def fluent(self, value: str) -> str:
        """The predicate that says a thing is in this state."""
        return self.fluents.get(value, value)

    def fill(
        self, task_type: str, roles: Mapping[str, str], has_type: Callable[[str, str], bool]
    ) -> tuple[Filled, ...]:
        """The goal of a task whose roles are filled with these objects.

        `has_type` says whether an object is of a PDDL type; the role `state` takes a state value and needs none.
        Raises `KeyError` where no template of the task type fits.
        """
        for template in self.goals[task_type]:
            if all(
                role in roles and (role == "state" or has_type(roles[role], of)) for role, of in template.of.items()
            ):
                return _filled(template.atoms, *roles.items(), ("state", self.fluent(roles.get("state", ""))))
        raise KeyError(f"no goal of {task_type} takes {dict(roles)}")


@lru_cache(maxsize=4096)
def _filled(atoms: tuple[str, ...], *words: tuple[str, str]) -> tuple[Filled, ...]:
    """A template's atoms with words for its roles, a later one before an earlier; asked again at every decision."""
    spoken = dict(words)
    return tuple(tuple(part.format(**spoken) for part in parts) for parts in map(_parts, atoms))


def _parts(atom: str) -> Filled:
    return tuple(re.sub(r"[()]", " ", atom).split())


def check_goals(goals: Goals, predicates: Mapping[str, int], values: tuple[str, ...]) -> None:
    """Raises `ValueError` where a template or a state value has no fluent, or one with another number of objects."""
    for value in values:
        if predicates.get(goals.fluent(value)) != 1:
            raise ValueError(f"the state {value!r} has no fluent ({goals.fluent(value)} ?object) in domain.pddl")
    for task_type, templates in goals.goals.items():
        for template in templates:
            for predicate, *terms in template.parts():
                if unknown := [term for term in terms if term.strip("{}") not in template.of]:
                    raise ValueError(
                        f"goals.{task_type}: {unknown[0]} stands for none of the roles {sorted(template.of)}"
                    )
                if predicate != "{state}" and predicates.get(predicate) != len(terms):
                    raise ValueError(f"goals.{task_type}: domain.pddl has no ({predicate} ...) of {len(terms)} objects")


def pddl_sections(text: str) -> dict[str, list[tuple[Sexpr, ...]]]:
    """The sections of a PDDL domain by keyword (":types", ":predicates", ":action"). Raises `ValueError`."""
    sections: dict[str, list[tuple[Sexpr, ...]]] = {}
    whole = read_sexpr(text)
    for section in whole[1:] if isinstance(whole, tuple) else ():
        if isinstance(section, tuple) and section:
            sections.setdefault(str(section[0]), []).append(section[1:])
    return sections


def pddl_predicates(text: str) -> dict[str, int]:
    """The predicates of a PDDL domain with their numbers of objects. Raises `ValueError`."""
    return {
        str(predicate[0]): len(list(typed_list(predicate[1:])))
        for section in pddl_sections(text).get(":predicates", [])
        for predicate in section
        if isinstance(predicate, tuple)
    }
