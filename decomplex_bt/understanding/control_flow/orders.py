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
        _stay(clauses, stated, k)
        _await(clauses, roles, sides, stated, k)
        _go_ahead(clauses, roles, sides, stated, k)
        _prepare(clauses, roles, sides, stated, k)
        _clear_way(clauses, roles, sides, stated, k)
    return tuple(stated)


def _stay(clauses: Sequence[Clause], orders: list[str], k: int) -> None:
    """A "first" at the end of a clause says nothing of an "and if" behind it ("bring it in, shake it *first*, and if it
    rains, ...")."""
    before, clause = clauses[k - 1 : k + 1]
    is_of_one_before = bool(_FIRST & {*before.behind} & {*clause.far}) and before.sentence == clause.sentence
    is_plain = clause.near == ("and", "if") and k + 1 < len(clauses) and not clauses[k + 1].wording.orders
    if is_of_one_before and is_plain and orders[k] in ("first", "before", "before+"):
        orders[k] = "keep"


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


def _prepare(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int) -> None:
    """What is done "first" behind a condition comes ahead of the order that hangs on the same case ahead of it ("bleed
    it if it's cold; in that case put a towel down first")."""
    clause = clauses[k]
    if k < 2 or orders[k] != "keep" or not _is_first(clause) or (roles[k - 1], roles[k]) != ("condition", "task"):
        return
    is_alone = k == 2 or sides[k - 3] != sides[k - 2]
    is_ahead = roles[k - 2] == "task" and sides[k - 2][:2] == ">1" and is_alone
    leads_on = k + 1 < len(clauses) and not _LEADING_ON.isdisjoint((*clauses[k + 1].far, *clauses[k + 1].near))
    if is_ahead and sides[k] == f"<1{sides[k - 2][2:]}" and not leads_on:
        takes_along = k + 1 < len(clauses) and clauses[k + 1].boundary == "none" and bool(_FIRST & {*clause.near})
        orders[k] = "before+" if takes_along else "before"


def _clear_way(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int
) -> None:
    """A condition about something that the first of several orders needs, and the last does not name, goes ahead of all
    where what hangs on it is done "first" ("get the mop from the shed and wipe the hall; if the shed is locked, get the
    key first")."""
    if roles[k] != "condition" or k + 1 >= len(clauses) or orders[k] not in ("keep", "before"):
        return
    after = clauses[k + 1]
    if roles[k + 1] != "task" or sides[k + 1][:2] != "<1" or not _is_first(after):
        return
    ahead = [j for j in range(k) if sides[j] == sides[k]]
    is_plain = len(ahead) > 1 and ahead[-1] == k - 1 and all(roles[j] == "task" for j in ahead)
    if not is_plain or any(orders[j] != "keep" for j in ahead):
        return
    things = set(clauses[k].objects)
    if not clauses[ahead[0]].needed.isdisjoint(things) and clauses[k - 1].nouns.isdisjoint(things):
        orders[k] = "first"


def _is_first(clause: Clause) -> bool:
    """Whether it is to be done "first" or "before that"."""
    is_said = not _FIRST.isdisjoint((*clause.near, *clause.behind))
    return is_said and {"first", "before"} <= set(clause.wording.orders)


_FIRST = frozenset(("first", "before_that"))
_LEADING_ON = frozenset(("then", "after_that"))
