"""Orders: which of two tasks comes first, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause


def stated_orders(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: Sequence[str]
) -> tuple[str, ...]:
    """The orders of tasks in text order, with those that the rules below settle; as long as `orders`."""
    stated = list(orders)
    for k in range(1, len(clauses)):
        _await(clauses, roles, sides, stated, k)
        _go_ahead(clauses, roles, sides, stated, k)
    return tuple(stated)


def _await(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int) -> None:
    """What something is not to be done before is done first ("don't go before you have locked up")."""
    before, clause = clauses[k - 1 : k + 1]
    is_next = roles[k - 1] == roles[k] == "task" and sides[k - 1] == sides[k]
    is_awaited = before.is_forbidden and clause.boundary == "none" and clause.near[-1:] == ("until",)
    if is_next and is_awaited and orders[k - 1 : k + 1] == ["keep", "keep"]:
        orders[k] = "before"


def _go_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int) -> None:
    """What is to be done before something is asked goes ahead of that, with what an "and" joins to it ("if it's still
    wet after you have swept and mopped it")."""
    clause, before = clauses[k], clauses[k - 1]
    if not clause.is_had_done or roles[k] != "task" or clause.boundary != "none":
        return
    is_next = roles[k - 1] == "condition" and sides[k] in ("top", f"<2{sides[k - 1][2:]}") and orders[k] != "first"
    is_joined = before.is_had_done and clause.near == ("and",) and (sides[k - 1], orders[k - 1]) == (sides[k], "before")
    if is_next or is_joined:
        orders[k] = "before"
