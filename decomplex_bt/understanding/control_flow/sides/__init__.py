"""Sides: in which branch of which condition a task stands, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.sides import (
    mentions,
    preparations,
    prohibitions,
    resumptions,
    reversals,
    scopes,
    states,
)

_RULES = (
    mentions.repeat,
    mentions.answer,
    mentions.name,
    mentions.pass_reply,
    mentions.join,
    mentions.cover,
    mentions.depend,
    mentions.find_first,
    mentions.ask_openly,
    prohibitions.make_exception,
    prohibitions.replace_order,
    prohibitions.forbid,
    reversals.oppose,
    reversals.agree,
    reversals.report,
    reversals.turn_back,
    reversals.affirm,
    reversals.correct,
    reversals.deny,
    reversals.agree_behind,
    reversals.search_on,
    reversals.affirm_ahead,
    scopes.stand_apart,
    scopes.precede,
    scopes.restrict,
    scopes.go_on,
    scopes.wait_for,
    scopes.obstruct,
    scopes.replace_there,
    scopes.leave_be,
    reversals.fall_back,
    reversals.follow,
    prohibitions.permit,
    scopes.guard,
    scopes.guard_each,
    scopes.guard_other,
    scopes.ask_first,
    scopes.ask_ahead,
    scopes.do_without,
    scopes.clear_way,
    scopes.check_ahead,
    scopes.ask_anew,
    scopes.come_first,
    resumptions.disregard,
    resumptions.rejoin,
    resumptions.add_also,
    resumptions.go_between,
    scopes.list_on,
    scopes.make_up,
    scopes.move_on,
    scopes.replace_last,
    scopes.report_on,
    scopes.resume,
    scopes.gather,
    scopes.confine,
    scopes.withhold,
    prohibitions.set_apart,
    scopes.go_ahead,
    prohibitions.stand_alone,
    prohibitions.call_off,
    prohibitions.elide,
    prohibitions.allow,
    scopes.exclude,
    scopes.turn_away,
    scopes.leave_rest,
    reversals.choose,
    preparations.make_ready,
    preparations.use_found,
)
"""One after the other on each task, left to right: a later one speaks of a rarer wording and has the last word."""


def stated_sides(clauses: Sequence[Clause], roles: Sequence[str], attachments: Sequence[str]) -> tuple[str, ...]:
    """The attachments of tasks in text order, with the sides of the rules below; as long as `attachments`."""
    sides = list(attachments)
    for k in range(1, len(clauses)):
        for rule in _RULES:
            rule(clauses, roles, sides, k)
    states.tell_apart(clauses, roles, sides)
    return tuple(sides)
