"""Orders said again, said both to be done and not to be done, or given as a choice."""

from __future__ import annotations

from decomplex_bt.understanding.control_flow.clause import CHOOSING, Clause


def repeats(clause: Clause, before: Clause) -> bool:
    """Whether it only says again what is ordered before, to put something ahead of it or behind it: "before you
    bring it", "when you've brought it"."""
    is_same = clause.verb == before.verb and clause.task.type == before.task.type
    is_of_it = clause.is_of_it or (bool(clause.objects) and clause.names_same(before))
    is_of_it = is_of_it and not _are_elsewhere(clause, before)
    return is_same and is_of_it and ("before" in clause.near or clause.is_had_done)


def forbids_same(clause: Clause, before: Clause) -> bool:
    """Whether one of both forbids what the other orders, with the same verb: "don't open it if it's windy,
    otherwise *open it*", "water it, but if it's wet *don't water it*", "mow it. *Don't mow it* if it's wet"."""
    is_same = clause.verb == before.verb and clause.task.type == before.task.type
    is_bare = all(kind != "object" for kind, _ in clause.task.arguments)
    is_of_it = clause.is_of_it or is_bare or (bool(clause.objects) and clause.names_same(before))
    is_next = clause.sentence - before.sentence == 1
    is_taken_up = clause.is_forbidden and (clause.is_of_it or is_bare)
    is_near = clause.sentence == before.sentence or (is_next and (clause.is_otherwise or is_taken_up))
    is_near = is_near and clause.receivers <= before.receivers
    return clause.is_forbidden != before.is_forbidden and is_same and is_of_it and is_near


def may_repeat(clause: Clause, before: Clause) -> bool:
    """Whether both may be one and the same order: of one type, to one effect, and of things that are not named
    apart."""
    is_same = not (clause.objects and before.objects) or clause.names_same(before)
    verbs = {clause.verb, before.verb}
    is_other = len(verbs) == 2 and "do" not in verbs and clause.effects != before.effects
    is_of_thing = clause.has_pronoun or bool(clause.objects)
    if _are_elsewhere(clause, before):
        return False
    # "load it, but don't start it until ...", not "don't start until ..."
    is_other_change = clause.task.type == "change_state" and is_other and is_of_thing
    return clause.task.type == before.task.type and is_same and not is_other_change


def is_choice_beside(clause: Clause, before: Clause) -> bool:
    """Whether it is ordered instead of the order before, as it may be: "close the window *or turn the heater on*";
    not where a condition may choose, nor with what is forbidden."""
    are_orders = clause.task.type != "check_state" != before.task.type and clause.sentence == before.sentence
    is_joined = clause.near == ("or",) and not clause.far and clause.boundary in ("none", ",")
    # of the case ahead: "if it isn't dry, *hang it up or ...*", "otherwise *hang it up or ...*"
    ahead = {*before.far, *before.near} - ({"not", "else"} if before.turns else {"not"})
    is_free = not {*ahead, *before.behind, *clause.behind} & CHOOSING
    return are_orders and is_joined and is_free and not (clause.is_forbidden or before.is_forbidden)


def _are_elsewhere(clause: Clause, before: Clause) -> bool:
    """Whether both put things somewhere, and not in one place: "put the peelings *in it*", "put it back *under the
    sink*"."""
    is_placed = clause.task.type == before.task.type == "placing" and bool(clause.receivers)
    return is_placed and clause.receivers.isdisjoint(before.receivers)
