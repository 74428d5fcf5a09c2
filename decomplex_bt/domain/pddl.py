"""The PDDL domain as text: its sections, and whether they fit together as positive STRIPS with types."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from decomplex_bt.domain.sexpr import Sexpr, read_sexpr, typed_list
from decomplex_bt.errors import among

ROOT = "object"
"""The type of everything."""
_SECTIONS = ("domain", ":requirements", ":types", ":predicates", ":action")
_PARTS = [":parameters", ":precondition", ":effect"]


def pddl_sections(text: str) -> dict[str, list[tuple[Sexpr, ...]]]:
    """The sections of a PDDL domain by keyword (":types", ":predicates", ":action"). Raises `ValueError`."""
    sections: dict[str, list[tuple[Sexpr, ...]]] = {}
    whole = read_sexpr(text)
    for section in whole[1:] if isinstance(whole, tuple) else ():
        if isinstance(section, tuple) and section:
            sections.setdefault(str(section[0]), []).append(section[1:])
    return sections


def pddl_types(text: str) -> set[str]:
    """The types of a PDDL domain, the root included. Raises `ValueError`."""
    return {ROOT} | {name for section in pddl_sections(text).get(":types", []) for name, _ in typed_list(section)}


def pddl_predicates(text: str) -> dict[str, int]:
    """The predicates of a PDDL domain with their numbers of objects. Raises `ValueError`."""
    return {
        str(predicate[0]): len(list(typed_list(predicate[1:])))
        for section in pddl_sections(text).get(":predicates", [])
        for predicate in section
        if isinstance(predicate, tuple)
    }


def pddl_actions(text: str) -> tuple[str, ...]:
    """The names of a PDDL domain's actions. Raises `ValueError`."""
    return tuple(str(action[0]) for action in pddl_sections(text).get(":action", []) if action)


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
    for section in sections.get(":predicates", []):
        for predicate in section:
            if not isinstance(predicate, tuple) or not predicate:
                raise ValueError(f":predicates: {predicate!r} stands outside of parentheses")
            _check_types(f"the predicate {predicate[0]}", predicate[1:], types)
    names = pddl_actions(text)
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise ValueError(f"action {twice}: it stands twice")
    for action in sections.get(":action", []):
        _check_action(action, types, predicates)


def conjuncts(expression: Sexpr) -> Iterator[tuple[Sexpr, ...]]:
    """The literals of a precondition or an effect, which may stand under an `and`."""
    items = expression if isinstance(expression, tuple) else (expression,)
    if items and items[0] == "and":
        yield from (item if isinstance(item, tuple) else (item,) for item in items[1:])
    elif items:
        yield items


def _check_action(action: tuple[Sexpr, ...], types: set[str], predicates: Mapping[str, int]) -> None:
    where = f"action {action[0] if action else '?'}"
    if list(action[1::2]) != _PARTS or len(action) != 1 + 2 * len(_PARTS):
        raise ValueError(f"{where}: expected {', '.join(_PARTS)} in this order, each with its parentheses")
    parameters, precondition, effect = action[2::2]
    if not isinstance(parameters, tuple):
        raise ValueError(f"{where}: its parameters stand outside of parentheses")
    _check_types(where, parameters, types)
    variables = [name for name, _ in typed_list(parameters)]
    for atom in conjuncts(precondition):
        if atom[:1] == ("not",):
            raise ValueError(f"{where}: {_said(atom)} in its precondition; the planner knows positive ones alone")
        _check_atom(where, atom, variables, predicates)
    for atom in conjuncts(effect):
        if atom[:1] == ("not",):
            atom = atom[1] if len(atom) == 2 and isinstance(atom[1], tuple) else ()
        _check_atom(where, atom, variables, predicates)


def _check_atom(where: str, atom: tuple[Sexpr, ...], variables: Sequence[str], predicates: Mapping[str, int]) -> None:
    name, *terms = atom or ("",)
    if name not in predicates:
        raise ValueError(f"{where}: unknown predicate in {_said(atom)}{among(_said(name), predicates)}")
    if len(terms) != predicates[str(name)]:
        raise ValueError(f"{where}: {_said(atom)} has {len(terms)} objects instead of {predicates[str(name)]}")
    if unknown := [term for term in terms if term not in variables]:
        raise ValueError(f"{where}: {_said(unknown[0])} in {_said(atom)} is none of its parameters")


def _check_types(where: str, items: tuple[Sexpr, ...], types: set[str]) -> None:
    if unknown := [of for _, of in typed_list(items) if of not in types]:
        raise ValueError(f"{where}: unknown type {unknown[0]!r}; known: {', '.join(sorted(types))}")


def _said(expression: Sexpr) -> str:
    return expression if isinstance(expression, str) else f"({' '.join(map(_said, expression))})"
