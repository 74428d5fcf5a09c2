"""Resumptions: what is done in any case behind what was said of one."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.sides.labels import FAILS, HOLDS, beside, goes_on

_WHETHER = frozenset(("whether", "if"))
_GOING_ON = frozenset("and then also after_that last".split())


def disregard(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done whether something is so or not hangs on no more than what that hangs on ("if you find it, bring it,
    and *whether you find it or not*, come back"), nor does what ", and" adds to an "otherwise" that only forbids
    ("otherwise don't wake her, *and lock up*"), nor what is ordered behind a guess ("if it's not here, it must be
    in the hall. *Bring it to me*")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] == "condition"), None)
    clause = clauses[k]
    if first is not None and (clause.is_either_way or clause.is_past_forbidden or clause.is_past_guess):
        _take_out(clauses, roles, sides, k, sides[first])


def rejoin(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence goes on with behind an order and the same order otherwise in a case is done after either ("take
    a towel from the rack or, if it's wet, take one from the shelf. *And put it here*", as `retelling` tells "..., from
    the shelf, and put it here")."""
    if k < 3 or roles[k - 3] not in ("task", "condition") or roles[k - 2] not in ("condition", "mention"):
        return
    order, check, other, clause = clauses[k - 3 : k + 1]
    is_same = (order.task.type, order.verb) == (other.task.type, other.verb) and roles[k - 1] == "task"
    opening = {*check.far, *check.near}
    is_choice = "or" in opening and opening.isdisjoint(("unless", "whether"))
    is_one = order.sentence == check.sentence == other.sentence == clause.sentence - 1
    is_plain = bool(clause.near) and _GOING_ON.issuperset((*clause.far, *clause.near))
    if is_same and is_choice and is_one and is_plain:
        _take_out(clauses, roles, sides, k, sides[k - 3] if roles[k - 3] == "condition" else sides[k - 2])


def add_also(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What "and then also" adds behind an order and its condition is done in that case, too ("call me if it's wet, and
    *then also* close the hatch")."""
    if k < 2 or (roles[k - 2], roles[k - 1], roles[k]) != ("task", "condition", "task") or sides[k] != "top":
        return
    clause, check = clauses[k], clauses[k - 1]
    is_added = {"then", "also"} <= {*clause.near} and clause.boundary in (",", "none")
    if is_added and sides[k - 2][:2] == ">1" and clauses[k - 2].sentence == check.sentence == clause.sentence:
        sides[k] = f"<1{sides[k - 2][2:]}"


def go_between(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "then" leads on to behind an order to check, about another thing, is done whatever that finds where a
    later sentence goes by it ("see whether the gate is shut, *then feed the hens*. If it was open, ...")."""
    check, clause = clauses[k - 1], clauses[k]
    is_led_on = clause.near in (("then",), ("and", "then")) and _WHETHER.issuperset(clause.far)
    if (roles[k - 1], roles[k]) != ("condition", "task") or not is_led_on:
        return
    is_next = check.is_asked and not check.is_question and check.sentence == clause.sentence
    is_other = not clause.has_pronoun and bool(clause.nouns) and check.nouns.isdisjoint(clause.nouns)
    stop = k + 1
    while stop < len(clauses) and roles[stop] == "task" and clauses[stop].sentence == clause.sentence:
        stop += 1
    goes_by = stop < len(clauses) and roles[stop] == "mention" and clauses[stop].sentence > clause.sentence
    if is_next and is_other and goes_by and all(sides[j] == HOLDS for j in range(k, stop)):
        for j in range(k, stop):
            sides[j] = beside(sides[k - 1])


def _take_out(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int, outer: str) -> None:
    """Takes an order, and what goes on with it, out of the case that it hangs on to where that stands itself."""
    side, outside = sides[k], beside(outer)
    if roles[k] != "task" or side not in (HOLDS, FAILS):
        return
    for j in range(k, len(clauses)):
        if sides[j] != side or not (j == k or goes_on(clauses, roles, sides, j, clauses[k].sentence)):
            return
        sides[j] = outside
