"""Resumptions: what is done in any case behind what was said of one."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.outcomes import is_guard_of
from decomplex_bt.understanding.control_flow.sides.labels import (
    CARRYING,
    FAILS,
    HOLDS,
    MOVING,
    OPENING,
    TURNING,
    beside,
    goes_on,
)

_ANEW = frozenset(("back", "again"))
_COMING = frozenset(("come", "arrive"))
_TELLING = frozenset(("informing", "check_state"))
_WHETHER = frozenset(("whether", "if"))
_AFTER_ASKING = frozenset(("whether", "there", "and"))
_LEADING_ON = frozenset(("and", "if", "there"))
_GOING_ON = frozenset("and then also after_that last".split())


def disregard(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done whether something is so or not hangs on no more than what that hangs on ("if you find it, bring it,
    and *whether you find it or not*, come back", "..., and close the door *regardless*"), nor does what ", and" adds to
    an "otherwise" that orders nothing ("otherwise don't wake her, *and lock up*"), nor what is ordered behind a guess
    ("if it's not here, it must be in the hall. *Bring it to me*") or, of something else, behind a case that only says
    where something is ("if he asks, the key is in the drawer. *Offer him tea*")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] == "condition"), None)
    clause = clauses[k]
    if first is None:
        return
    is_past_place = first == k - 1 and clauses[first].tells_where and clause.sentence == clauses[first].sentence + 1
    is_past_place = is_past_place and bool(clause.objects) and TURNING.isdisjoint((*clause.far, *clause.near))
    is_at_last = roles[k] == "task" and "either_way" in clause.behind and clause.ends_sentence
    is_at_last = is_at_last and roles[k - 1] == "task" and clause.sentence == clauses[k - 1].sentence
    if clause.is_either_way or clause.is_past_idle or clause.is_past_guess or is_past_place or is_at_last:
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


def go_between(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "then" leads on to behind an order to check, about another thing, is done whatever that finds where a
    later sentence goes by it ("see whether the gate is shut, *then feed the hens*. If it was open, ..."), and does not
    say that it was looked for in vain ("find the dog, then open the gate. If you can't find her, ...")."""
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
    is_missed = goes_by and clauses[stop].task.type == "searching" and clauses[stop].wording.is_negated
    if is_next and is_other and goes_by and not is_missed and all(sides[j] == HOLDS for j in range(k, stop)):
        for j in range(k, stop):
            sides[j] = beside(sides[k - 1])


def make_up(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done ", then" behind the one thing that makes up for what is not so is done in any case ("if there isn't
    a clean cup, wash one, *then fill it*"; not "if there's no tent, take a quilt, then spread that")."""
    clause, before = clauses[k], clauses[k - 1]
    if k < 2 or roles[k - 2] not in CONDITION_ROLES or (roles[k - 1], roles[k]) != ("task", "task"):
        return
    is_next = (clause.boundary, clause.near) == (",", ("then",)) and clause.sentence == before.sentence
    lack = clauses[k - 2]
    is_of_lack = lack.wording.is_negated and lack.sentence == clause.sentence and lack.wording.state in before.effects
    is_step = "first" in (*before.far, *before.near, *before.behind)
    if not (is_next and is_of_lack) or is_step or sides[k] != sides[k - 1] or sides[k] not in (HOLDS, FAILS):
        return
    for j in range(k, len(clauses)):
        if j > k and not (sides[j] == sides[k - 1] and goes_on(clauses, roles, sides, j, clause.sentence)):
            return
        sides[j] = "top"


def move_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "then" leads on to behind the one order that undoes what was found to be so is done in any case: with
    another thing ("if the iron is still on, turn it off, *and then bring me the basket*"), or by moving what was put
    right ("if it's frozen, defrost it, *and then put it in the oven*"), but not a report of it."""
    clause, order = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] not in ("task", "mention")), None) if k > 1 else None
    if first is None or roles[k - 2] not in CONDITION_ROLES or (roles[k - 1], roles[k]) != ("task", "task"):
        return
    is_alone = "task" not in roles[first : k - 1] and roles[first] == "condition" and sides[first] == "top"
    check, last = clauses[first], clauses[k - 2]  # "is the gate open? *If it is*, close it, then ..."
    is_alone = is_alone and (last.is_question or not OPENING.isdisjoint(last.near))
    state = last.wording.state or check.wording.state
    is_undone = is_alone and state in (order.effects if last.wording.is_negated else order.needs)
    is_of_it = order.names_same(check) or (order.is_of_it and not order.objects)
    known = {word for before in (check, order) for word in (*before.nouns, *before.thing)}
    is_new = not clause.has_pronoun and bool(clause.nouns) and known.isdisjoint(clause.nouns)
    is_next = "then" in clause.near and {"and", "then", "please"}.issuperset(clause.near) and not clause.is_only_then
    is_plain = is_next and clause.boundary in (",", "none") and "first" not in order.behind
    is_moved = clause.boundary == "," and clause.task.type in MOVING and clause.is_of_it and not clause.objects
    is_turned = any("else" in (*c.far, *c.near) for c in clauses[k + 1 :] if c.sentence == clause.sentence)
    is_mended = is_moved and not (is_turned or order.said_state)  # not "turn it off, then put it away"
    if not (is_undone and is_of_it and (is_new or is_mended) and is_plain) or clause.task.type in _TELLING:
        return
    if last.sentence != clause.sentence or sides[k - 1] not in (HOLDS, FAILS):
        return
    for j in range(k, len(clauses)):
        if sides[j] != sides[k - 1] or not (j == k or goes_on(clauses, roles, sides, j, clause.sentence)):
            return
        sides[j] = "top"


def resume(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What goes on behind an order and a case that commas set off is done in any case: behind an "unless" with a "then"
    and another matter ("shut the door, unless Mum's in there, *and then feed the dog*", not "..., then leave it open"),
    behind whether the order is needed, or the thing has come, with an "and" ("close it, if it's open, *and bring me a
    towel*", "bring the paper if it's come, *and open the blinds*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "condition", "task") or sides[k - 2][:2] != ">1":
        return
    order, check, clause = clauses[k - 2 : k + 1]
    if k > 2 and clauses[k - 3].sentence == order.sentence:
        return
    is_one = order.sentence == check.sentence == clause.sentence
    is_set_off = is_one and check.boundary == clause.boundary == ","
    is_run_on = is_one and clause.is_and_then and check.boundary == "none"
    is_led_on = is_set_off or is_run_on  # "shut it unless Mum's in there and then feed the dog"
    is_instead = clause.task.type == order.task.type and order.task.type in CARRYING
    is_of_it = clause.has_pronoun and not clause.objects
    is_other = not (is_instead or is_of_it or order.is_forbidden) and order.nouns.isdisjoint(clause.nouns)
    is_other = is_other and "instead" not in clause.behind
    is_on = check.near == ("unless",) and clause.near in (("then",), ("and", "then")) and is_other
    is_done = is_guard_of(check, order) or (check.says_already and not check.has_pronoun and not check.objects)
    is_needless = is_set_off and check.near == ("if",) and clause.near == ("and",) and is_done
    is_come = check.near == ("if",) and check.verb in _COMING and check.takes_up(order) and is_other
    is_come = is_come and clause.boundary == "," and clause.near == ("and",) and is_one
    if not ((is_led_on and is_on) or is_needless or is_come) or TURNING & set(clause.far) - {"not"}:
        return
    for j in range(k, len(clauses)):
        if roles[j] != "task" or clauses[j].sentence != clause.sentence or sides[j][:2] != "<1":
            return
        sides[j] = beside(sides[k - 1])


def undo(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "then" puts back, or does again, right behind the order of a case that undid it belongs to that case ("if
    the light is red, unplug the router, *then plug it back in*")."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = (roles[k - 1], roles[k], sides[k]) == ("task", "task", "top") and sides[k - 1] in (HOLDS, FAILS)
    is_next = is_behind and clause.sentence == order.sentence and "then" in clause.near
    is_again = not clause.ways.isdisjoint(_ANEW) and clause.is_of_it and not clause.objects
    is_undone = clause.task.type == order.task.type
    if is_next and is_again and is_undone and {"and", "then"}.issuperset(clause.near):
        sides[k] = sides[k - 1]


def report_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What was found out is told whatever that is, where "and tell me" says no more and nothing in its sentence but a
    case goes by the answer ("see if it's raining *and tell me*", "check for bread *and let me know*. If there isn't
    any, ...")."""
    check, clause = clauses[k - 1], clauses[k]
    if (roles[k - 1], roles[k]) != ("condition", "task") or sides[k] != HOLDS:
        return
    is_asked = check.is_asked and not check.is_question and check.near[:1] != ("if",)
    is_report = clause.task.type == "informing" and all(kind == "recipient" for kind, _ in clause.task.arguments)
    is_joined = clause.near[-1:] == ("and",) and _AFTER_ASKING.issuperset(clause.near)
    is_last = k + 1 == len(clauses) or (
        roles[k + 1] != "task" and "if" in clauses[k + 1].near and _LEADING_ON.issuperset(clauses[k + 1].near)
    )
    if is_asked and is_report and is_joined and is_last and clause.boundary == "none":
        sides[k] = beside(sides[k - 1])


def keep_besides(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "but" has done with another thing behind an order and its case is done in any case ("throw the rolls away
    if they're old, *but keep the cake*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "condition", "task") or sides[k - 2][:2] != ">1":
        return
    order, check, clause = clauses[k - 2 : k + 1]
    is_set_off = check.boundary == "none" and clause.boundary == "," and clause.near == ("but",)
    is_one = order.sentence == check.sentence == clause.sentence
    is_one = is_one and check.near == (("if", "not") if check.is_of_nobody else ("if",))
    known = {*order.thing, *check.thing, *check.nouns}
    is_other = bool(clause.objects) and known.isdisjoint(clause.objects) and not order.is_forbidden
    if is_set_off and is_one and is_other and sides[k] in (HOLDS, FAILS) and not clause.is_forbidden:
        sides[k] = beside(sides[k - 1])


def have_found(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence of its own does with what was looked for in one place and then in another, in a case that it
    tells, is done wherever it was found ("if it's not there, look in the car. *Bring it to me, unless it's wet*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "task", "condition") or sides[k] not in (HOLDS, FAILS):
        return
    search, order = clauses[k - 2 : k]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] == "condition"), None)
    if first is None:
        return
    is_sought = clauses[first].task.type == search.task.type == "searching" and sides[k - 2] in (HOLDS, FAILS)
    is_next = order.sentence == search.sentence + 1 == clauses[k].sentence and not (order.near or order.far)
    is_of_it = order.is_of_it and not order.objects and order.task.type in (*CARRYING, "change_state")
    if is_sought and is_next and is_of_it and sides[k - 1][:2] == ">1":
        sides[k] = beside(sides[first])


def share(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done, set off by a comma, with what is picked up in one case and got otherwise in the other is done with
    either ("take a plate if there is one, otherwise take a bowl, *and bring it to me*", "take the plate, or if it's
    dirty get the bowl, *and bring it*")."""
    clause, order = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] != "condition" or (roles[k - 1], roles[k]) != ("task", "task"):
        return
    is_one = clause.sentence == order.sentence == clauses[first].sentence
    is_set_off = is_one and clause.boundary == "," and clause.near in (("and",), ("then",), ("and", "then"))
    is_of_it = clause.has_pronoun and not clause.objects and clause.task.type in ("bringing", "placing")
    is_substitute = "or" in clauses[first].near and sides[k] == HOLDS
    is_other = sides[k] == sides[k - 1] and order.task.type in ("taking", "change_state")
    is_other = is_other and (sides[k] == FAILS or is_substitute)
    held_by = (FAILS, ">1-") if is_substitute else (HOLDS, ">1+")
    held = [j for j in range(k - 1) if sides[j] == held_by[0] or (sides[j] == held_by[1] and j == first - 1)]
    is_held = bool(held) and all(clauses[j].task.type == "taking" and roles[j] == "task" for j in held)
    if is_set_off and is_of_it and is_other and is_held:
        sides[k] = beside(sides[first])


def _take_out(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int, outer: str) -> None:
    """Takes an order, and what goes on with it, out of the case that it hangs on to where that stands itself."""
    side, outside = sides[k], beside(outer)
    if roles[k] != "task" or side not in (HOLDS, FAILS):
        return
    for j in range(k, len(clauses)):
        if sides[j] != side or not (j == k or goes_on(clauses, roles, sides, j, clauses[k].sentence)):
            return
        sides[j] = outside
