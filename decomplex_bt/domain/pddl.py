"""The PDDL domain as text: its sections, and whether they fit together as positive STRIPS with types."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from decomplex_bt.domain.sexpr import Sexpr, read_sexpr, typed_list
from decomplex_bt.errors import among

ROOT = "object"
"""The type of everything."""
Signatures = Mapping[str, tuple[str, ...]]
"""The type of each object of a predicate, by its name."""
_SECTIONS = ("domain", ":requirements", ":types", ":predicates", ":action")
_PARTS = [":parameters", ":precondition", ":effect"]


@dataclass(frozen=True, slots=True)
class Types:
    """The types of a PDDL domain; `supers`: of each but the root the type it is one of."""

    supers: Mapping[str, str]

    def __contains__(self, name: object) -> bool:
        return name == ROOT or name in self.supers

    def names(self) -> list[str]:
        return sorted({ROOT, *self.supers})

    def is_a(self, special: str, general: str) -> bool:
        """Whether everything of the type `special` is of the type `general`."""
        return general in self._upwards(special)

    def cyclic(self) -> str | None:
        """A type that is one of its own, by way of others or not."""
        return next((name for name in self.supers if self.is_a(self.supers[name], name)), None)

    def _upwards(self, name: str) -> list[str]:
        """The type and all above it, the root last, as far as none comes twice."""
        found: list[str] = []
        while name not in found:
            found.append(name)
            name = self.supers.get(name, ROOT)
        return found


def pddl_sections(text: str) -> dict[str, list[tuple[Sexpr, ...]]]:
    """The sections of a PDDL domain by keyword (":types", ":predicates", ":action"). Raises `ValueError`."""
    sections: dict[str, list[tuple[Sexpr, ...]]] = {}
    whole = read_sexpr(text)
    for section in whole[1:] if isinstance(whole, tuple) else ():
        if isinstance(section, tuple) and section:
            sections.setdefault(str(section[0]), []).append(section[1:])
    return sections


def pddl_types(text: str) -> Types:
    """The types of a PDDL domain. Raises `ValueError`."""
    sections = pddl_sections(text).get(":types", [])
    return Types({name: of for section in sections for name, of in typed_list(section) if name != ROOT})


def pddl_predicates(text: str) -> dict[str, tuple[str, ...]]:
    """The predicates of a PDDL domain with the types of their objects. Raises `ValueError`."""
    return {
        str(predicate[0]): tuple(of for _, of in typed_list(predicate[1:]))
        for section in pddl_sections(text).get(":predicates", [])
        for predicate in section
        if isinstance(predicate, tuple)
    }


def pddl_actions(text: str) -> tuple[str, ...]:
    """The names of a PDDL domain's actions. Raises `ValueError`."""
    return tuple(str(action[0]) for action in pddl_sections(text).get(":action", []) if action)


def pddl_parameters(text: str) -> dict[str, tuple[tuple[str, str], ...]]:
    """The parameters of a PDDL domain's actions, each a variable and its type. Raises `ValueError`."""
    return {name: tuple(typed_list(_tuple(parts[0]))) for name, parts in _parts_of_actions(text)}


def pddl_adds(text: str) -> dict[str, tuple[tuple[Sexpr, ...], ...]]:
    """The atoms that a PDDL domain's actions make true. Raises `ValueError`."""
    return {
        name: tuple(atom for atom in conjuncts(parts[2]) if atom[0] != "not") for name, parts in _parts_of_actions(text)
    }


def check_pddl(text: str) -> None:
    """Raises `ValueError` that names the action and what is wrong with it, or else the section."""
    sections = pddl_sections(text)
    if unknown := next((name for name in sections if name not in _SECTIONS), None):
        raise ValueError(f"unknown section {unknown}; expected one of {', '.join(_SECTIONS)}")
    if missing := next((name for name in _SECTIONS if name.startswith(":") and name not in sections), None):
        raise ValueError(f"there is no {missing} section")
    types, predicates = pddl_types(text), pddl_predicates(text)
    for section in sections.get(":types", []):
        _check_types(":types", section, types)
        _check_once(":types", (name for name, _ in typed_list(section)))
    if (name := types.cyclic()) is not None:
        raise ValueError(f":types: {name} is a type of its own kind, by way of {types.supers[name]}")
    for section in sections.get(":predicates", []):
        for predicate in section:
            if not isinstance(predicate, tuple) or not predicate:
                raise ValueError(f":predicates: {predicate!r} stands outside of parentheses")
            _check_types(f"the predicate {predicate[0]}", predicate[1:], types)
        _check_once(":predicates", (_said(predicate[0]) for predicate in section))
    _check_once(":action", pddl_actions(text))
    for action in sections.get(":action", []):
        _check_action(action, types, predicates)


def conjuncts(expression: Sexpr) -> Iterator[tuple[Sexpr, ...]]:
    """The literals of a precondition or an effect, which may stand under an `and`."""
    items = expression if isinstance(expression, tuple) else (expression,)
    if items and items[0] == "and":
        yield from (item if isinstance(item, tuple) else (item,) for item in items[1:])
    elif items:
        yield items


def _check_action(action: tuple[Sexpr, ...], types: Types, predicates: Signatures) -> None:
    where = f"action {action[0] if action else '?'}"
    if list(action[1::2]) != _PARTS or len(action) != 1 + 2 * len(_PARTS):
        raise ValueError(f"{where}: expected {', '.join(_PARTS)} in this order, each with its parentheses")
    parameters, precondition, effect = action[2::2]
    if empty := next((key for key, part in zip(_PARTS[1:], (precondition, effect), strict=True) if part == ()), None):
        raise ValueError(f"{where}: its {empty} is (), which planners do not read; write (and) for none")
    if not isinstance(parameters, tuple):
        raise ValueError(f"{where}: its parameters stand outside of parentheses")
    _check_types(where, parameters, types)
    variables = dict(typed_list(parameters))
    _check_once(where, (name for name, _ in typed_list(parameters)))
    for atom in conjuncts(precondition):
        if atom[:1] == ("not",):
            raise ValueError(f"{where}: {_said(atom)} in its precondition; the planner knows positive ones alone")
        _check_atom(where, atom, variables, types, predicates)
    for atom in conjuncts(effect):
        if atom[:1] == ("not",):
            atom = atom[1] if len(atom) == 2 and isinstance(atom[1], tuple) else ()
        _check_atom(where, atom, variables, types, predicates)


def _check_atom(
    where: str, atom: tuple[Sexpr, ...], variables: Mapping[str, str], types: Types, predicates: Signatures
) -> None:
    name, *terms = atom or ("",)
    if name not in predicates:
        raise ValueError(f"{where}: unknown predicate in {_said(atom)}{among(_said(name), predicates)}")
    signature = predicates[str(name)]
    if len(terms) != len(signature):
        raise ValueError(f"{where}: {_said(atom)} has {len(terms)} objects instead of {len(signature)}")
    if unknown := [term for term in terms if term not in variables]:
        raise ValueError(f"{where}: {_said(unknown[0])} in {_said(atom)} is none of its parameters")
    for term, of in zip(terms, signature, strict=True):
        if not types.is_a(variables[str(term)], of):
            raise ValueError(
                f"{where}: {_said(term)} in {_said(atom)} is of the type {variables[str(term)]!r}; the predicate takes "
                f"{of!r}"
            )


def _parts_of_actions(text: str) -> Iterator[tuple[str, tuple[Sexpr, ...]]]:
    """The name of each action with its parameters, precondition and effect."""
    yield from ((str(action[0]), action[2::2]) for action in pddl_sections(text).get(":action", []))


def _tuple(expression: Sexpr) -> tuple[Sexpr, ...]:
    return expression if isinstance(expression, tuple) else (expression,)


def _check_types(where: str, items: tuple[Sexpr, ...], types: Types) -> None:
    if unknown := [of for _, of in typed_list(items) if of not in types]:
        raise ValueError(f"{where}: unknown type {unknown[0]!r}; known: {', '.join(types.names())}")


def _check_once(where: str, names: Iterable[str]) -> None:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise ValueError(f"{where}: {name} stands twice")
        seen.add(name)


def _said(expression: Sexpr) -> str:
    return expression if isinstance(expression, str) else f"({' '.join(map(_said, expression))})"
