"""Labels of sides, and what is asked of them again and again."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause

HOLDS, FAILS = "<1+", "<1-"
"""In the branch of the condition before: where that holds as it is stated, and where it does not (`arcs`)."""
OPENING = frozenset(("if", "only_if", "unless", "when"))
TURNING = frozenset("else fail so unless either_way only_if even_if but either until whether or not".split())

MOVING = frozenset(("placing", "bringing"))
CARRYING = MOVING | {"taking"}
VESSELS = frozenset("box container bag bowl tub jar dish basket tin carton crate sack".split())
PARTING = frozenset((".", ";"))


def beside(side: str) -> str:
    """The side of what stands beside a condition on this side, as seen from behind that condition."""
    return f"<2{side[2:]}" if side in (HOLDS, FAILS) else "top"


def hangs_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], k: int, sentence: int) -> bool:
    """Whether an order of this sentence hangs on the condition behind it."""
    return roles[k] == "task" and sides[k][:2] == ">1" and clauses[k].sentence == sentence


def goes_on(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], k: int, sentence: int) -> bool:
    """Whether a task goes on with what hangs on the condition before it, in this sentence."""
    is_plain = roles[k] == "task" and sides[k] in (HOLDS, FAILS)
    return is_plain and clauses[k].sentence == sentence and TURNING.isdisjoint({*clauses[k].far, *clauses[k].near})
