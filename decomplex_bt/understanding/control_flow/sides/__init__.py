"""Sides: in which branch of which condition a task stands, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.sides import (
    guards,
    mentions,
    preparations,
    prohibitions,
    resumptions,
    reversals,
    scopes,
    states,
    substitutions,
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
    mentions.miss,
    mentions.miss_thing,
    prohibitions.make_exception,
    prohibitions.replace_order,
    prohibitions.forbid,
    prohibitions.forbid_again,
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
    substitutions.obstruct,
    substitutions.replace_there,
    substitutions.leave_be,
    substitutions.stand_in,
    reversals.fall_back,
    reversals.follow,
    prohibitions.permit,
    guards.guard,
    guards.guard_each,
    guards.guard_other,
    scopes.ask_first,
    substitutions.ask_ahead,
    substitutions.do_without,
    substitutions.find_some,
    substitutions.run_out,
    substitutions.clear_way,
    substitutions.go_besides,
    substitutions.do_back,
    substitutions.carry_in,
    substitutions.have_in_hand,
    substitutions.check_ahead,
    scopes.ask_anew,
    scopes.come_first,
    resumptions.disregard,
    resumptions.rejoin,
    resumptions.add_also,
    resumptions.go_between,
    resumptions.look_on,
    resumptions.list_on,
    resumptions.make_up,
    resumptions.move_on,
    substitutions.replace_last,
    resumptions.report_on,
    resumptions.resume,
    resumptions.gather,
    guards.confine,
    guards.withhold,
    prohibitions.set_apart,
    scopes.go_ahead,
    prohibitions.stand_alone,
    prohibitions.call_off,
    prohibitions.elide,
    prohibitions.allow,
    scopes.exclude,
    scopes.turn_away,
    scopes.leave_rest,
    scopes.ask_each,
    scopes.answer_ring,
    reversals.choose,
    reversals.pick,
    resumptions.share,
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
