"""Mentions: to which condition before a clause what takes something up belongs."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, Arc
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.clauses import last_named
from decomplex_bt.understanding.control_flow.construction import Builder
from decomplex_bt.understanding.control_flow.contrasts import is_elsewhere_than
from decomplex_bt.understanding.control_flow.failures import finds_out, is_failure_of, may_fail_as
from decomplex_bt.understanding.control_flow.outcomes import is_answer_behind, is_answer_to
from decomplex_bt.understanding.control_flow.repetitions import may_repeat, repeats
from decomplex_bt.understanding.control_flow.roles.parts import (
    are_asked_of_both,
    missed_anywhere,
    taken_up,
)
from decomplex_bt.understanding.control_flow.roles.replies import (
    fetched_before,
    replied_to,
    sought_twice,
    tried_in_case,
)
from decomplex_bt.understanding.control_flow.sides.labels import FAILS, HOLDS, goes_on
from decomplex_bt.understanding.states import are_apart


def take_place(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An order that a mention behind it was found to be of stands where that was asked, no longer in its case."""
    order = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] != "mention" or order is None or clauses[order].is_check:
        return
    if roles[order] == "condition" and sides[order].startswith(">1"):
        sides[order], sides[k] = sides[k], "<1"


def repeat(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is said again is the last order that says the same, never one of another type or another thing."""
    if roles[k] != "again":
        return
    orders = [j for j in range(k - 1, -1, -1) if roles[j] == "task"]
    meant = int(sides[k][1]) - 1 if sides[k] != "top" else 0
    if orders and not may_repeat(clauses[k], clauses[orders[min(meant, len(orders) - 1)]]):
        fitting = (rank for rank, j in enumerate(orders, start=1) if may_repeat(clauses[k], clauses[j]))
        sides[k] = f"<{min(9, next(fitting, 1))}"
    rank = next((rank for rank, j in enumerate(orders, start=1) if repeats(clauses[k], clauses[j])), None)
    sides[k] = sides[k] if rank is None else f"<{min(9, rank)}"


def answer(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """How somebody answers is asked where the question is, and how they take what they are told where that is."""
    order = replied_to(clauses, roles, k)
    is_told = order is not None and (roles[order], roles[k]) == ("task", "condition")
    if order is not None and is_told and sides[order] in ("top", HOLDS, FAILS):
        sides[k] = sides[order]
    others = [clauses[j] for j in range(k - 1) if roles[j] in CONDITION_ROLES]
    if roles[k] == "condition" and others and is_answer_to(clauses[k], clauses[k - 1], others):
        sides[k] = sides[k - 1]
    is_behind = k > 1 and tuple(roles[k - 2 : k + 1]) == ("task", "task", "condition")
    if is_behind and is_answer_behind(clauses[k], clauses[k - 1], clauses[k - 2]):
        sides[k] = sides[k - 2] if sides[k - 2] in ("top", HOLDS, FAILS) else sides[k]
        sides[k - 1] = ">1-" if clauses[k].wording.is_negated else ">1+"


def find_neither(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if neither", or "if either", of two things to be found out is done on its side of both."""
    if roles[k] != "or" or not are_asked_of_both(clauses, k):
        return
    sides[k] = side = HOLDS
    for j in range(k + 1, len(clauses)):
        if roles[j] != "task" or sides[j] not in (HOLDS, FAILS):
            return
        if clauses[j].of_both:
            side = FAILS if clauses[j].of_both == "neither" else HOLDS
        elif clauses[j].is_otherwise:
            side = FAILS if side == HOLDS else HOLDS
        elif clauses[j].sentence != clauses[j - 1].sentence or not goes_on(
            clauses, roles, sides, j, clauses[j].sentence
        ):
            return
        sides[j] = side


def name(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A mention that names what a condition before was about, as no other one was, is of that condition ("if the stove
    is cold, light the kindling, and if it won't burn, ... If the stove is still warm, ..."), unless it tells that the
    change before it failed ("if the safe is locked, open it. If the safe won't open, ..."); one that names nothing may
    be of one of two conditions that "and" joins (`roles.taken_up`)."""
    clause = clauses[k]
    if roles[k] != "mention" or clause.task.type != "check_state":
        return
    part = taken_up(clauses, roles, k)
    if part is not None and sides[k][:1] == "<":
        sides[k] = "<1" if roles[part + 1] == "task" or part + 1 == k else "<2"
    if not clause.objects:
        return
    before = clauses[k - 1]
    is_outcome = is_failure_of(clause, before, last_named(clauses, k)) or finds_out(before, clause)
    if roles[k - 1] == "condition" and is_outcome:
        sides[k] = "<1"
        return
    groups = _groups(roles, sides, k)
    nearest = list(dict.fromkeys(groups[j] for j in range(k - 1, -1, -1) if j in groups))
    named = {groups[j] for j in groups if clause.names_same(clauses[j])}
    states = {clauses[j].wording.state for j in groups if groups[j] in named}
    is_other = any(state and clause.wording.state and are_apart(state, clause.wording.state) for state in states)
    if len(named) == 1 and not is_other:
        sides[k] = f"<{nearest.index(named.pop()) + 1}"


def find_after_all(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """That something is found in one of two places tells of either look for it, where the second is in the case that
    the first was in vain, or is asked where the first is (`roles`)."""
    first = sought_twice(clauses, roles, k)
    if first is not None and roles[k] == "condition":
        sides[k] = sides[first] if sides[first] in ("top", HOLDS, FAILS) else "top"
    elif first is not None and tuple(roles[k - 1 : k + 1]) == ("or", "mention"):
        sides[k - 1], sides[k] = FAILS if roles[k - 2] == "mention" else sides[k - 1], "<1"
        sides[k + 1] = HOLDS if roles[k + 1] == "task" else sides[k + 1]


def miss_elsewhere(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """That somebody is nowhere to be found is asked where they are in none of the places before ("see if she's in the
    garden. If she is, ...; if she's on the roof, ...; *if you can't find her*, ...")."""
    last = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if last is None or (roles[last], roles[k]) != ("condition", "mention") or last == k - 1:
        return
    first = next((j for j in range(last - 1, -1, -1) if roles[j] == "condition"), None)
    clause = clauses[k]
    is_away = clause.wording.is_contrary or (clause.task.type == "searching" and clause.wording.is_negated)
    is_led = "if" in clause.near and clause.has_pronoun and not clause.objects
    if first is None or not (is_away and is_led) or not is_elsewhere_than(clauses[last], clauses[first]):
        return
    if sides[last] in (HOLDS, FAILS) and sides[k][:1] == "<":
        sides[last], sides[k] = FAILS, "<1"


def miss_anywhere(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """That something is in neither of two places is asked where it is in neither (`roles`)."""
    if (roles[k - 1], roles[k]) == ("condition", "condition") and missed_anywhere(clauses, roles, k) is not None:
        sides[k - 1] = sides[k] = FAILS
        for j in range(k + 1, len(clauses)):
            if sides[j] not in (HOLDS, FAILS) or clauses[j].sentence != clauses[k].sentence:
                return
            sides[j] = FAILS


def _groups(roles: Sequence[str], sides: Sequence[str], k: int) -> dict[int, int]:
    """Of every condition and mention before `k` the condition that it is, or is a mention of."""
    builder = Builder([Arc(*labels) for labels in zip(roles[:k], sides[:k], strict=True)], ())
    builder.collect_groups()
    return builder.group_of


def pass_reply(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """ "If it isn't" behind how somebody takes what they are asked or brought, and a state that is that of the
    condition before or its opposite, is of that condition ("if the gate is locked, ask Tom for the key; if he refuses,
    call me. *If it isn't*, ...", "if the tea is hot, take it to Ann; if she refuses it, ... *If it's cold*, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] == "condition"), None)
    head = next((j for j in range((first or 0) - 1, -1, -1) if roles[j] == "condition"), None)
    is_pronoun = clause.is_of_it or (clause.is_of_somebody and not clause.says_only_whether)
    if first is None or head is None or roles[k] != "mention" or not is_pronoun:
        return
    one, other = clause.wording, clauses[head].wording
    is_turned = one.is_opposite_of(other) or other.is_opposite_of(one)
    is_of_head = one.state is not None and (one.state == other.state or is_turned)
    if clauses[first].says_reply and (clause.says_only_whether or is_of_head) and sides[k] == "<1":
        sides[k] = "<2"


def cover(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """All that was ordered before hangs on what "all this only if ..." asks, be it the first that is asked."""
    if clauses[k].covers and roles[k] == "condition" and set(roles[:k]) == {"task"}:
        sides[:k] = [f">1{clauses[k].covers}"] * k


def depend(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with a thing depends on its being found, where that is then said to fail ("get it from the box and
    hang it up. If it isn't there, ...", "find my glasses. Bring them here, and if you can't see them, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] != "task"), k)
    if roles[k] != "mention" or first >= k - 1 or roles[first] != "condition" or clauses[k].boundary == "none":
        return
    is_sought = may_fail_as(clauses[first], clauses[k])
    if not is_sought and (first < k - 2 or not finds_out(clauses[first], clauses[k])):
        return
    for j in range(first + 1, k):
        if sides[j] == "top" and clauses[j].has_pronoun and not clauses[j].objects and not clauses[j].wording.orders:
            sides[j] = HOLDS


def ask_openly(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What no yes or no answers keeps nothing from what is done, or asked, right behind it."""
    if clauses[k - 1].asks_open and roles[k - 1] == "task" and sides[k][:2] == "<1":
        sides[k] = sides[k - 1] if sides[k - 1] in ("top", HOLDS, FAILS) else "top"


def miss(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What somebody is given or told who was looked for, and may not be there, is so where they are (`roles`)."""
    if k < 2 or (roles[k - 2], roles[k - 1], roles[k]) != ("condition", "task", "mention"):
        return
    is_told = clauses[k - 2].task.type == "searching" and clauses[k].says_absent and clauses[k - 1].has_pronoun
    if is_told and sides[k - 1] in ("top", HOLDS, "<1") and clauses[k - 1].near[-1:] == ("and",):
        sides[k - 1] = HOLDS


def miss_thing(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """That what was to be fetched cannot be found is of the order to fetch it (`roles`); what was asked of the thing
    in between is asked where it was found, unless that is seen to first."""
    order = fetched_before(clauses, k)
    if order is None or (roles[order], roles[order + 1], roles[k]) != ("condition", "condition", "mention"):
        return
    sides[k] = "<2"
    is_first = any(c.wording.orders for c in clauses[order + 2 : k])
    sides[order + 1] = sides[order] if is_first and sides[order] in ("top", HOLDS, FAILS) else HOLDS


def do_in_vain(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done where an order fails behind which its case is told is done in that case (`roles`)."""
    if k < 2 or roles[k - 2] != "condition" or sides[k - 2][:2] != ">1" or not tried_in_case(clauses, roles, k):
        return
    if roles[k] == "mention":
        sides[k] = "<2"
        return
    for j in range(k, len(clauses)):
        if j > k and not goes_on(clauses, roles, sides, j, clauses[k].sentence):
            return
        sides[j] = "<2-"
