"""Orders: which of two tasks comes first, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause


def stated_orders(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: Sequence[str]
) -> tuple[str, ...]:
    """The orders of tasks in text order, with those that the rule below settles; as long as `orders`."""
    stated = list(orders)
    for k in range(1, len(clauses)):
        _await(clauses, roles, sides, stated, k)
    return tuple(stated)


def _await(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int) -> None:
    """What something is not to be done before is done first ("don't go before you have locked up")."""
    before, clause = clauses[k - 1 : k + 1]
    is_next = roles[k - 1] == roles[k] == "task" and sides[k - 1] == sides[k]
    is_awaited = before.is_forbidden and clause.boundary == "none" and clause.near[-1:] == ("until",)
    if is_next and is_awaited and orders[k - 1 : k + 1] == ["keep", "keep"]:
        orders[k] = "before"
