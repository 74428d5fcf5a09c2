"""Preparations: what is done in one case of two ahead of an order that is carried out in either."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.arcs import BOTH, CONDITION_ROLES, flip_of, is_flipped, other_side, side_of
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.sides.labels import FAILS, HOLDS, OPENING, beside, hangs_ahead

_HANDLING = frozenset(("bringing", "taking", "placing", "change_state"))
_JOINED = frozenset((("and",), ("then",), ("and", "then")))


def make_ready(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is to be done *first* in the other case makes ready for what is ordered, which is then done in either ("put
    the plates away if they're clean, otherwise *wash them first*"); where that case is told in words of its own, the
    order is one of both branches ("bring it if it's hot; if it's gone cold, *heat it first*")."""
    clause = clauses[k]
    is_first = "first" in clause.behind and {"first", "before"} <= set(clause.wording.orders)
    if roles[k] != "task" or not is_first or clause.task.type not in _HANDLING or sides[k] not in (HOLDS, FAILS):
        return
    if k + 1 < len(clauses) and roles[k + 1] == "task" and sides[k + 1] == sides[k]:
        return
    first = next((j for j in range(k - 1, -1, -1) if roles[j] == "condition"), 0)
    orders, is_told_again = _opposed(clauses, roles, sides, k), "mention" in roles[first:k]
    if is_told_again and not (clause.has_pronoun or any(clause.names_same(clauses[j]) for j in (first, *orders))):
        return
    for j in orders:
        sides[j] = f"{sides[j]}{BOTH}" if is_told_again else beside(sides[first]) if j > first else sides[first]


def _opposed(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], k: int) -> list[int]:
    """The orders on the other side of the one condition before, be it mentioned again, that an order hangs on: all that
    hang on it besides, in its sentence; none where one of them is on the same side."""
    last = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if last is None:
        return []
    first = next((j for j in range(last, -1, -1) if roles[j] == "condition"), last)
    if roles[first] != "condition" or (first != last and "condition" in roles[first + 1 : last + 1]):
        return []
    sentence, wordings = clauses[first].sentence, [clause.wording for clause in clauses]
    ahead = list(takewhile(lambda j: hangs_ahead(clauses, roles, sides, j, sentence), range(first - 1, -1, -1)))
    orders = [*reversed(ahead), *(j for j in range(first + 1, k) if roles[j] == "task")]
    if any(j > last > first for j in orders):
        return []
    flip = is_flipped(first, first, wordings)
    used = {side_of(flip != sides[j].endswith("-")) for j in orders}
    flip_last = flip if last == first else flip_of(last, first, wordings, used)
    is_one = used == {other_side(side_of(flip_last != sides[k].endswith("-")))}
    return orders if is_one and all(sides[j][:2] in (">1", "<1") for j in orders) else []


def use_found(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with what was looked for in one place and, where it is not, in another is done wherever it was
    ("look in the drawer; if it's not there, look on the shelf, *and bring it here*")."""
    clause, search = clauses[k], clauses[k - 1]
    if k < 2 or roles[k] != "task" or clause.near not in _JOINED or clause.far or sides[k] not in (HOLDS, FAILS):
        return
    first = next((j for j in range(k - 1, -1, -1) if roles[j] == "condition"), None)
    if first is None or first == k - 1 or (roles[k - 1], sides[k - 1]) != ("task", sides[k]):
        return
    is_search = clauses[first].task.type == search.task.type == "searching" and OPENING.isdisjoint(clauses[first].near)
    is_only = all(roles[j] == "mention" for j in range(first + 1, k - 1)) and clause.sentence == search.sentence
    is_failed = clauses[k - 2].wording.is_negated or not {"else", "fail"}.isdisjoint((*search.far, *search.near))
    is_told = clause.task.type == "informing" and clauses[first].may_be_of_person and not clause.receivers
    if not (is_search and is_only and is_failed) or not clause.has_pronoun or clause.objects:
        return
    if clause.task.type in _HANDLING or is_told:
        for j in range(k, len(clauses)):
            if sides[j] != sides[k - 1] or roles[j] != "task" or clauses[j].sentence != clause.sentence:
                break
            sides[j] = "top"
