"""States of one thing that exclude each other, so that a further one is asked for where it has none of those before."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from decomplex_bt.understanding.control_flow.cases import told_apart, told_in_a_row
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.sides.labels import FAILS, HOLDS, TURNING


def tell_apart(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str]) -> None:
    """A further state of the same thing is never asked for where it has the one before, and of three or more each
    where it has none of those before; what is done in the case follows on it ("if it's lit, empty it; if it's blinking,
    call Tom; if it's out, start it")."""
    for run in told_in_a_row(clauses, roles):
        for before, k in pairwise(run):
            if clauses[k].is_wish:  # "if she wants tea, bring it, but if she'd rather have water, ..."
                sides[before + 1 : k] = [HOLDS if side[:2] == ">1" else side for side in sides[before + 1 : k]]
            if roles[k] == "condition" and sides[k] == HOLDS and sides[k - 1][:2] != ">1":
                sides[k] = FAILS
    for run in told_apart(clauses, roles):
        sides[run[0]] = "<1" if roles[run[0]] == "mention" and roles[run[0] - 1] == "condition" else sides[run[0]]
        for k, later in zip(run, [*run[1:], len(clauses)], strict=True):
            sides[k] = FAILS if k != run[0] else sides[k]
            _follow_case(clauses, roles, sides, range(k, later))


def _follow_case(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], of: range) -> None:
    """What follows on the first of some clauses, a case, in its sentence is done in that case till something turns
    it."""
    for j in of[1:]:
        is_turned = bool(TURNING & {*clauses[j].far, *clauses[j].near}) or clauses[j].is_forbidden
        is_next = clauses[j].sentence == clauses[of.start].sentence and roles[j] == "task"
        if not is_next or sides[j][:2] != "<1" or is_turned:
            return
        sides[j] = HOLDS
