"""Roles: whether a task is a condition, a mention of an earlier one or neither, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.cases import told_apart
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.roles import orders, parts, replies

_RULES = (
    parts.join,
    replies.ask_again,
    parts.take_up,
    replies.find_out,
    replies.turn_up,
    parts.part,
    orders.ask_of_other_order,
    orders.ask_ahead_of_other,
    orders.leave_as_is,
    replies.try_out,
    replies.look_over,
    replies.search_asked,
    replies.come_about,
    replies.search_within,
    parts.oppose,
    parts.be_occupied,
    replies.wait,
    replies.come_to_be,
    parts.look_after,
    replies.find_after_all,
    replies.miss,
    replies.miss_thing,
    replies.fit_in,
    replies.answer,
    replies.pick_up,
    orders.repeat,
    orders.choose,
    orders.fall_back,
    replies.do_in_vain,
    replies.ask_openly,
    orders.go_first,
    replies.report,
    replies.lack_too,
    replies.suppose,
    parts.look_over,
    parts.name_other,
    parts.ask_of_person,
    parts.lack,
    parts.lack_ordered,
    parts.find_nobody,
    parts.find_other,
    orders.ask_of_order,
    parts.lack_one,
    parts.find_neither,
    parts.tell_of_both,
    parts.miss_anywhere,
    orders.request,
)
"""One after the other, each on all tasks from left to right: a later one has the last word."""


def stated_roles(clauses: Sequence[Clause], roles: Sequence[str]) -> tuple[str, ...]:
    """The roles of tasks in text order, with those that the rules below settle; as long as `roles`."""
    stated = list(roles)
    for rule in _RULES:
        for k in range(1, len(clauses)):
            rule(clauses, stated, k)
    for cases in told_apart(clauses, stated):
        for k in cases[1:]:  # of three states none is the other side of another: "hot", "lukewarm", "cold"
            stated[k] = "condition"
        if stated[cases[0] - 1] == "condition" and cases[0] and clauses[cases[0] - 1].leaves_open:
            stated[cases[0]] = "mention"  # "check on him: if he's up, ..., if he's dozing, ..., if he's asleep, ..."
    return tuple(stated)
