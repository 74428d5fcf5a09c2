"""Prohibitions: on which side stands what is forbidden, excepted, called off or allowed."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, JOINTS
from decomplex_bt.understanding.control_flow.clause import FINDING_OUT, Clause
from decomplex_bt.understanding.control_flow.failures import is_case_against
from decomplex_bt.understanding.control_flow.repetitions import forbids_same
from decomplex_bt.understanding.control_flow.sides.labels import FAILS, HOLDS, MOVING, TURNING, goes_on, hangs_ahead

_EXCEPTING = frozenset("unless but and please not still".split())
"""The cues of an exception: "but please don't if it's still on"."""


def make_exception(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is forbidden "unless ..." is done where that holds, so not as it is stated, and all else as it is stated;
    around "unless A or B" the rest of the sentence is done as it is stated, till something turns it."""
    clause = clauses[k]
    around = [j for j, other in enumerate(clauses) if other.sentence == clause.sentence and roles[j] == "task"]
    is_opened = "unless" in clause.near and roles[k] in CONDITION_ROLES
    if is_opened and k - 1 in around and clauses[k - 1].is_forbidden and sides[k - 1] == ">1+":
        sides[k - 1] = ">1-"
    if is_opened and clause.wording.is_negated and "not" not in (*clause.near, *clauses[k - 1].behind):
        for j in range(k - 1, -1, -1):
            if j not in around or sides[j] != ">1-" or clauses[j].is_forbidden or clauses[j].wording.is_negated:
                break
            sides[j] = ">1+"
    if not clause.is_excepted or roles[k] not in JOINTS:
        return
    for j in around:
        turning = {*clauses[j].far, *clauses[j].near, *clauses[j - 1].behind} & TURNING if j > k else ()
        if turning:
            return
        if sides[j] in (">1-", "<1-") and not clauses[j].is_forbidden:
            sides[j] = f"{sides[j][:2]}+"


def except_behind(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence of its own excepts from the sentence before is done where that does not hold ("iron the shirts.
    *Not if they're damp*", "mow the lawn. *Don't if it's wet*"), and what is said behind an exception to be done
    instead where it does ("mow the lawn, but don't if it's wet, *sweep the hall instead*")."""
    order, check = clauses[k - 1 : k + 1]
    is_behind = (roles[k - 1], roles[k], sides[k]) == ("task", "condition", "top") and check.is_check
    is_opened = "unless" in check.near and {*check.near} <= _EXCEPTING and not check.far
    instead = k + 1 < len(clauses) and not check.ends_sentence
    if instead and "instead" not in (*clauses[k + 1].near, *clauses[k + 1].behind):
        return
    if not (is_behind and is_opened):
        return
    if check.sentence == order.sentence + 1:
        for j in range(k - 1, -1, -1):
            is_hanging = roles[j] == "task" and sides[j] in ("top", ">1-", ">1+")
            if not is_hanging or clauses[j].sentence != order.sentence or clauses[j].is_forbidden:
                break
            sides[j] = ">1+"
    if instead and check.sentence - order.sentence <= 1 and sides[k + 1] == HOLDS:
        sides[k + 1] = FAILS


def replace_order(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What "in which case" or, without a mark, "then" opens behind "..., unless ..." is done where that keeps from the
    order ahead of it, which may be a sentence of its own ("turn it off. Unless Tom's there, *in that case* ask him");
    and what is moved elsewhere then is the thing of that order alone ("sweep up and give him the bill unless my wife's
    back then give it to her")."""
    if k < 2 or (roles[k - 2], roles[k - 1], roles[k]) != ("task", "condition", "task"):
        return
    order, check, clause = clauses[k - 2 : k + 1]
    is_afterthought = check.near == ("unless",) and check.sentence == order.sentence + 1
    is_afterthought = is_afterthought and clause.near in (("so",), ("then",)) and clause.boundary in (",", "none")
    if is_afterthought and sides[k - 2] == "top" and not order.is_forbidden:
        sides[k - 2] = ">1+"
        for j in range(k, len(clauses)):
            if j > k and not goes_on(clauses, roles, sides, j, clause.sentence):
                break
            sides[j] = FAILS
        return
    is_restricted = "unless" in check.near and sides[k - 2] == ">1+" and not order.is_forbidden
    is_moved = clause.task.type in MOVING and order.task.type in MOVING and clause.is_of_it
    is_opened = clause.near == ("so",) or (is_moved and clause.boundary == "none" and clause.near == ("then",))
    if not (is_restricted and is_opened) or clause.sentence != check.sentence or sides[k] not in (HOLDS, FAILS):
        return
    side = sides[k]
    for j in range(k, len(clauses)):
        if sides[j] != side or not (j == k or goes_on(clauses, roles, sides, j, clause.sentence)):
            break
        sides[j] = FAILS
    for j in range(k - 3, -1, -1):
        is_ahead = hangs_ahead(clauses, roles, sides, j, clause.sentence)
        if not (is_moved and is_ahead) or not clauses[j].nouns.isdisjoint(order.objects) or order.has_pronoun:
            return
        sides[j] = sides[k - 1] if sides[k - 1] in (HOLDS, FAILS) else "top"


def forbid(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is forbidden in a case is done in the other ("if it isn't full, don't empty it"), what is said instead of it
    in that case ("if it's wet, don't iron it, hang it up"), and what an "otherwise" opens behind it in the other."""
    clause = clauses[k]
    is_task = roles[k] == "task" and roles[k - 1] in CONDITION_ROLES
    is_beside = roles[k - 1] == "condition" and clause.boundary == "," and clause.sentence == clauses[k - 1].sentence
    # "if they're asleep, don't vacuum", be it taken for the order of a later case, which there is none
    is_free = sides[k] == "top" or (sides[k][:1] == ">" and CONDITION_ROLES.isdisjoint(roles[k:]))
    is_beside = is_beside and is_free and "if" in clauses[k - 1].near
    if not (is_task and clause.is_forbidden and (sides[k] in (HOLDS, FAILS) or is_beside)):
        return
    sides[k] = FAILS
    for j in range(k + 1, len(clauses)):
        later = clauses[j]
        is_instead = "instead" in later.behind and later.sentence == clause.sentence + 1 and j == k + 1
        if (later.sentence != clause.sentence and not is_instead) or roles[j] != "task":
            return
        turning = {*later.far, *later.near} & TURNING
        is_beside = j == k + 1 and (not later.has_pronoun or bool(later.objects))
        turning -= {"but"} if is_beside else set()  # "don't vacuum *but* sweep"
        if turning == {"else"} and sides[j] == HOLDS:
            sides[j] = FAILS
        if later.is_forbidden or turning:
            return
        if sides[j] == FAILS:
            sides[j] = HOLDS


def set_right(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is to be done first, or ends the state that keeps from an order, is done in the case in which that was
    forbidden right before ("if it's wet, don't fold it. *Dry it first*", "don't serve it if it's cold; *heat it*")."""
    if k < 2 or tuple(sorted(roles[k - 2 : k])) != ("condition", "task") or roles[k] != "task":
        return
    forbidden, check = (k - 2, k - 1) if roles[k - 2] == "task" else (k - 1, k - 2)
    order, case, clause = clauses[forbidden], clauses[check], clauses[k]
    is_case = case.is_check and "if" in case.near and "unless" not in case.near and order.is_forbidden
    is_case = is_case and sides[forbidden] == (FAILS if check < forbidden else ">1-")
    is_next = clause.sentence - order.sentence <= 1 and not {*clause.far, *clause.near} & (TURNING - {"but", "not"})
    is_first = "first" in clause.behind and clause.has_pronoun and not clause.objects
    is_ended = case.wording.state in (clause.effects if case.wording.is_negated else clause.needs)
    is_ended = is_ended and (clause.takes_up(case) or clause.takes_up(order) or clause.names_same(case))
    if is_case and is_next and (is_first or is_ended) and sides[k] in ("top", HOLDS, FAILS):
        sides[k] = HOLDS


def urge(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is to be done all the same is done in any case ("don't open the window if it rains, *but do* shut the
    door")."""
    if k < 2 or (roles[k - 2], roles[k - 1], roles[k]) != ("task", "condition", "task"):
        return
    if clauses[k].is_urged and clauses[k - 2].is_forbidden and clauses[k].sentence == clauses[k - 2].sentence:
        sides[k] = sides[k - 1] if sides[k - 1] in ("top", HOLDS, FAILS) else sides[k]


def remember(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is not to be forgotten "if" something is so is done where it is ("*don't forget to* lock up if you go")."""
    order, check = clauses[k - 1 : k + 1]
    is_trailing = (roles[k - 1], roles[k]) == ("task", "condition") and check.near == ("if",) and check.is_trailing
    if order.is_reminder and is_trailing and sides[k - 1] == ">1-" and not check.wording.is_negated:
        sides[k - 1] = ">1+"


def forbid_again(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is ordered and then forbidden in a case right behind is done where that is not so, and that is asked where
    it would be done ("if the grass is long, mow it, but *don't mow it if it's wet*")."""
    if (roles[k - 1], roles[k]) != ("again", "condition"):
        return
    again, check = clauses[k - 1 : k + 1]
    order = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES or roles[j] == "task"), k)
    is_behind = check.boundary == "none" and not {"if", "when"}.isdisjoint(check.near) and again.is_forbidden
    is_ordered = is_behind and roles[order] == "task" and sides[order] in ("top", HOLDS, FAILS)
    if is_ordered and forbids_same(again, clauses[order]):
        sides[order], sides[k - 1], sides[k] = ">1-", ">1-", sides[order]


def forbid_repeated(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Of several orders the one that a case behind them forbids is done where that does not hold, the others in any,
    and what is said instead of it in the case ("iron the shirt and fold the towels. If the shirt is damp, *don't iron
    it, hang it up*")."""
    if (roles[k - 1], roles[k]) != ("condition", "again") or not clauses[k].is_forbidden or sides[k - 1] != "top":
        return
    check, again = clauses[k - 1 : k + 1]
    ahead = list(takewhile(lambda j: roles[j] == "task" and sides[j] in ("top", ">1+", ">1-"), range(k - 2, -1, -1)))
    order = next((j for j in ahead if forbids_same(again, clauses[j])), None)
    if order is None or {"if", "when"}.isdisjoint(check.near) or check.sentence != again.sentence:
        return
    for j in ahead:
        sides[j] = ">1-" if j == order else "top"
    sides[k] = f"<{min(9, ahead.index(order) + 1)}"
    for j in range(k + 1, len(clauses)):
        later = clauses[j]
        is_instead = later.sentence == again.sentence + 1 and "instead" in later.behind and j == k + 1
        is_next = (later.sentence == again.sentence or is_instead) and roles[j] == "task" and not later.is_forbidden
        if not is_next or {*later.far, *later.near} & TURNING - {"but"}:
            return
        sides[j] = HOLDS


def await_outcome(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is not to be done until something is so is done only where that is found to be so, where a later sentence
    tells what to do if it is not ("don't open the gate until you have found the dog. *If you can't find her*, ...")."""
    order, awaited = clauses[k - 1 : k + 1]
    is_awaited = order.is_forbidden and "until" in awaited.near and awaited.sentence == order.sentence
    is_awaited = is_awaited and awaited.task.type in FINDING_OUT
    if not is_awaited or (roles[k - 1], roles[k]) != ("task", "condition") or k + 1 >= len(clauses):
        return
    is_told = roles[k + 1] == "mention" and clauses[k + 1].sentence > awaited.sentence
    sides[k - 1] = ">1+" if is_told and sides[k - 1] in ("top", ">1-", ">1+") else sides[k - 1]


def permit(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done in the opposite of a case in which something is forbidden is done where that is not ("don't wake
    him if he's asleep; if he's up, bring him tea", "if he's asleep, don't wake him; if he's up, ..."): the case that is
    stated again has no tasks but the forbidden one, which is done in the other (`arcs.flip_of`)."""
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[first], roles[k - 1], sides[k - 1]) != ("condition", "mention", "<1"):
        return
    check, again = clauses[first], clauses[k - 1]
    is_plain = not {"if", "when"}.isdisjoint(check.near) and "unless" not in check.near and not check.wording.is_negated
    ahead = [first - 1] if first and sides[first - 1] == ">1-" else []
    done = [*ahead, *range(first + 1, k - 1)]
    are_forbidden = all(roles[j] == "task" and clauses[j].is_forbidden and sides[j] in (">1-", FAILS) for j in done)
    is_opposite = again.wording.is_negated != again.wording.contradicts(check.wording)
    if not (is_plain and done and are_forbidden and is_opposite) or "unless" in again.near:
        return
    for j in range(k, len(clauses)):
        between = {*clauses[j].far, *clauses[j].near, *clauses[j - 1].behind}
        is_turned = bool(between & (TURNING - {"not"})) or clauses[j].is_forbidden
        if sides[j] != HOLDS or roles[j] != "task" or clauses[j].sentence != again.sentence or is_turned:
            return
        sides[j] = FAILS


def call_off(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is called off in a case is done in the other ("mow the lawn, but if it's wet, leave it"), and so are the
    orders that are joined to it; never in that case, be it one that comes through the order ("open it, and if it's
    stuck, leave it")."""
    if roles[k] != "condition" or roles[k - 1] != "task":
        return
    is_inverted = clauses[k].calls_off and sides[k - 1] == ">1+" and {*clauses[k].near} <= {"if", "and", "but"}
    if not is_inverted and not is_case_against(clauses[k], clauses[k - 1]):
        return
    if sides[k - 1] not in ("top", ">1+", ">1-") or sides[k] not in ("top", HOLDS):
        return
    if k > 1 and roles[k - 2] in CONDITION_ROLES and clauses[k - 2].sentence == clauses[k - 1].sentence:
        return  # what hangs on another condition already
    for j in range(k - 1, -1, -1):
        is_joined = j == k - 1 or (clauses[j].sentence == clauses[k - 1].sentence and sides[j] == ">1+")
        if roles[j] != "task" or not is_joined:
            break
        sides[j] = ">1-"
    sides[k] = "top"


def skip(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Of several orders the one whose verb is named is not done in the case that says so, and the others are done in
    any ("wash it and put it away. If it's clean already, *skip the washing*")."""
    check = clauses[k]
    if not check.skips or roles[k] != "condition" or "unless" in check.near or sides[k] not in ("top", HOLDS, FAILS):
        return
    orders = []
    for j in range(k - 1, -1, -1):
        if roles[j] != "task" or sides[j] not in ("top", ">1+", ">1-"):
            break
        orders.append(j)
    named = next((j for j in orders if clauses[j].verb in check.skips and not clauses[j].is_forbidden), None)
    if named is None:
        return
    for j in orders:
        is_there = clauses[named].task.type == "motion" and j > named  # what is to be done there hangs on going there
        sides[j] = ">1-" if j == named or is_there else "top"
    sides[k] = "top"


def allow(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is forbidden but allowed in a case is done in that ("don't open it, but if it's hot, do")."""
    if (roles[k - 1], roles[k]) != ("task", "condition") or not clauses[k].allows or not clauses[k - 1].is_forbidden:
        return
    if sides[k - 1] in ("top", ">1+", ">1-") and sides[k] in ("top", HOLDS):
        sides[k - 1], sides[k] = ">1+", "top"


def elide(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is forbidden in a case by a "don't" without its verb is done in the other, and what follows is done in the
    case ("put the radio on, and if she's asleep *don't*, just shut the door", "... *don't*; shut the door instead")."""
    if roles[k - 1] not in CONDITION_ROLES or not clauses[k - 1].forbids_order or roles[k] != "task":
        return
    check = clauses[k - 1]
    if "unless" in check.near:
        return
    if k > 1 and roles[k - 2] == "task" and sides[k - 2] == ">1+" and clauses[k - 2].sentence == check.sentence:
        sides[k - 2] = ">1-"
    is_instead = "instead" in clauses[k].behind and clauses[k].sentence == check.sentence + 1
    sentence = check.sentence + is_instead
    for j in range(k, len(clauses)):
        if j > k and not goes_on(clauses, roles, sides, j, sentence):
            return
        if clauses[j].sentence != sentence or sides[j] != FAILS or clauses[j].is_otherwise:
            return
        sides[j] = HOLDS
