"""Orders: which of two tasks comes first, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import BOTH
from decomplex_bt.understanding.control_flow.clause import Clause

_KEEPING = frozenset("keep leave stay sit stand hold remain watch".split())


def stated_orders(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: Sequence[str]
) -> tuple[str, ...]:
    """The orders of tasks in text order, with those that the rules below settle; as long as `orders`."""
    stated = list(orders)
    for k in range(1, len(clauses)):
        _stay(clauses, stated, k)
        _await(clauses, roles, sides, stated, k)
        _await_for_both(clauses, roles, sides, stated, k)
        _keep_turn(clauses, roles, sides, stated, k)
        _keep_on(clauses, roles, sides, stated, k)
        _take_away(clauses, roles, sides, stated, k)
        _go_behind(clauses, roles, sides, stated, k)
        _go_ahead(clauses, roles, sides, stated, k)
        _prepare(clauses, roles, sides, stated, k)
        _make_ready(clauses, roles, sides, stated, k)
        _make_ready_all(clauses, sides, stated, k)
        _clear_way(clauses, roles, sides, stated, k)
        _arrive(clauses, roles, sides, stated, k)
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
    """What something is not to be done before is done first ("don't go before you have locked up", "before you have
    locked up, don't go")."""
    before, clause = clauses[k - 1 : k + 1]
    is_next = roles[k - 1] == roles[k] == "task" and sides[k - 1] == sides[k]
    is_awaited = before.is_forbidden and clause.boundary == "none" and clause.near[-1:] == ("until",)
    if is_next and is_awaited and orders[k - 1 : k + 1] == ["keep", "keep"]:
        orders[k] = "before"
    is_ahead = clause.is_forbidden and before.near[-1:] == ("until",) and before.sentence == clause.sentence
    if is_next and is_ahead and (k == 1 or clauses[k - 2].sentence != clause.sentence):
        orders[k - 1] = orders[k] = "keep"


def _await_for_both(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int
) -> None:
    """What a "but" has two orders wait for that an "and" joins goes ahead of both ("switch it off and shut the lid,
    *but not until it's cold*", not "dry it, and put it away, but not until ...")."""
    if k < 2 or orders[k] not in ("before", "before+") or tuple(roles[k - 2 : k + 1]) != ("task",) * 3:
        return
    other, clause = clauses[k - 1 : k + 1]
    is_joined = other.near == ("and",) and other.boundary == "none" and clauses[k - 2].sentence == clause.sentence
    is_set_off = clause.boundary == "," and "but" in (*clause.far, *clause.near)
    is_set_off = is_set_off and clause.near[-1:] in (("until",), ("before",), ("after",))
    if is_joined and is_set_off and [j for j in range(k) if sides[j] == sides[k]] == [k - 2, k - 1]:
        orders[k] = orders[k].replace("before", "first")


def _keep_turn(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int
) -> None:
    """What is waited for in a clause of its own ("turn it on, *wait until it's hot* and bring it"), and an order that a
    "but" alone sets beside the one before ("keep it open *but draw the blinds*"), come in the order of the text."""
    before, clause = clauses[k - 1 : k + 1]
    is_next = roles[k - 1] == roles[k] == "task" and sides[k - 1] == sides[k] and before.sentence == clause.sentence
    if not is_next or before.is_forbidden or not (clause.is_mere_contrast or clause.is_waited_for):
        return
    orders[k] = "keep" if orders[k] in _AHEAD else orders[k]
    if orders[k - 1] in ("after", "last") and not before.wording.orders:
        orders[k - 1] = "keep"


def _keep_on(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int) -> None:
    """What is kept or done "until" something comes is so before that comes ("*keep the gate shut* until Tom is back",
    "*beat the eggs* until they're stiff", "until Tom is back, keep the gate shut")."""
    before, clause = clauses[k - 1 : k + 1]
    is_next = roles[k - 1] == roles[k] == "task" and sides[k - 1] == sides[k] and before.sentence == clause.sentence
    if not is_next or before.is_forbidden or clause.is_forbidden or before.wording.is_negated:
        return
    is_behind = clause.near[-1:] == ("until",) and clause.boundary == "none"
    is_done = clause.is_end and "not" not in (*before.far, *before.near)
    if is_behind and (before.verb in _KEEPING or (is_done and orders[k] in _AHEAD)):
        orders[k - 1 : k + 1] = "keep", "keep"
    is_ahead = before.near[-1:] == ("until",) and before.is_check and clause.verb in _KEEPING
    if is_ahead and (k == 1 or clauses[k - 2].sentence != clause.sentence):
        orders[k - 1 : k + 1] = "keep", "before"


def _take_away(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int
) -> None:
    """What a "but" has taken away in a case is so from what was made ready before ("set the table, *but if Leo isn't
    coming, take a plate away*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_removed = order.task.type == "change_state" and other.task.type == "taking" and other.removes
    is_plain = check.near == ("but", "if") and not (check.wording.orders or other.wording.orders)
    if is_removed and is_plain and not order.wording.orders and sides[k - 1] == sides[k] == "top":
        orders[k - 1 : k + 1] = "keep", "keep"


def _go_behind(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int
) -> None:
    """What is waited for behind an order comes before that alone, not before what an "and" adds ("serve it *as soon as
    it's hot* and open the wine")."""
    before, clause = clauses[k - 1 : k + 1]
    if k + 1 >= len(clauses) or not clause.is_check or clause.near != ("after",) or clause.boundary != "none":
        return
    are_tasks = all(roles[j] == "task" and sides[j] == sides[k] for j in (k - 1, k, k + 1))
    is_added = clauses[k + 1].near == ("and",) and clauses[k + 1].sentence == clause.sentence == before.sentence
    if are_tasks and is_added and orders[k - 1 : k + 1] == ["keep", "before+"]:
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


def _make_ready(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int
) -> None:
    """A condition behind an order goes ahead of it where what makes ready for it hangs on it ("put it away if it's
    clean, otherwise wash it *first*", "... if it's clean. If not, wash it *first*": `preparations.make_ready`), and so
    does that of an order of both branches."""
    if _is_first(clauses[k]) and any(side.endswith(BOTH) for side in sides[:k]) and orders[k] == "keep":
        orders[k] = "before"
        return
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    before, clause, after = clauses[k - 1 : k + 2]
    is_behind = before.sentence == clause.sentence >= after.sentence - 1 and sides[k - 1] == sides[k]
    is_turned = before.is_forbidden or not {"else", "so", "fail"}.isdisjoint((*after.far, *after.near))
    if is_behind and is_turned and _is_first(after) and sides[k + 1][:2] == "<1" and orders[k] == "keep":
        orders[k] = "before"


def _make_ready_all(clauses: Sequence[Clause], sides: Sequence[str], orders: list[str], k: int) -> None:
    """What a sentence of its own has done "first" in a case goes ahead of all orders that stand in both ("if it's hot,
    pour it and bring it. If it's not, *heat it first*")."""
    both = [j for j in range(k) if sides[j].endswith(BOTH)]
    if len(both) > 1 and _is_first(clauses[k]) and clauses[both[-1]].sentence < clauses[k].sentence:
        orders[k] = "first"


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


def _arrive(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], orders: list[str], k: int) -> None:
    """What is done before somebody goes somewhere comes ahead of that, and behind it what is done once they are there
    ("before you go out, shut the door, *and once you're there*, roll up the hose")."""
    clause = clauses[k]
    is_there = clause.is_on_arrival or (k > 0 and roles[k - 1] == "again" and clauses[k - 1].task.type == "motion")
    first = next((j for j in range(k - 1, -1, -1) if "before" in clauses[j].near), None)
    if first is None or not is_there or clauses[first].task.type != "motion" or roles[k] != "task":
        return
    between = [j for j in range(first + 1, k) if roles[j] != "again"]
    is_one = clauses[first].sentence == clause.sentence and all(sides[j] == sides[first] for j in (*between, k))
    if between and is_one and all(roles[j] == "task" for j in between):
        orders[first] = "keep"
        for j in between:
            orders[j] = "before"
        orders[k] = "keep"


def _is_first(clause: Clause) -> bool:
    """Whether it is to be done "first" or "before that"."""
    is_said = not _FIRST.isdisjoint((*clause.near, *clause.behind))
    return is_said and {"first", "before"} <= set(clause.wording.orders)


_AHEAD = frozenset(("before", "before+", "first", "first+"))
_FIRST = frozenset(("first", "before_that"))
_LEADING_ON = frozenset(("then", "after_that"))
