"""What says that something before it did not come about: an order that failed, a search without result, who is away."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import AROUND, CHOOSING, FINDING, Clause
from decomplex_bt.understanding.control_flow.outcomes import comes_through
from decomplex_bt.understanding.states import OPPOSITES


def is_absence_of(clause: Clause, before: Clause) -> bool:
    """Whether it says no more than that whoever the task before should give or tell something to is not there:
    "take it to Anna, and if she's out, ..."."""
    return _is_absence(clause, before) and not _is_choice(clause)


def _is_choice(clause: Clause) -> bool:
    return clause.boundary == "," and (*clause.far, *clause.near)[:2] == ("or", "if")


def _is_absence(clause: Clause, before: Clause) -> bool:
    is_left_with = clause.says_too and clause.is_of_person and before.task.type == "placing"
    is_handed = before.task.type in _HANDING or is_left_with  # "leave it with Tom, and if he isn't in either"
    if clause.task.type != "check_state" or not is_handed or not clause.is_of_somebody:
        return False
    if not clause.is_of_person and before.number == "many":
        return False  # "they" may as well be what is given
    kinds = {kind for kind, _ in before.task.arguments}
    # not "in by six"
    is_all = max((j for _, indices in clause.task.arguments for j in indices), default=0) >= clause.last
    is_gone = clause.wording.state in _GONE and not clause.wording.is_negated
    is_away = clause.wording.is_negated and (clause.wording.state in AROUND or not clause.places.isdisjoint(AROUND))
    return bool(kinds & {"recipient", "goal"}) and "unless" not in clause.near and is_all and (is_gone or is_away)


def is_kept_from(clause: Clause, handing: Clause, other: Clause) -> bool:
    """Whether it says, behind another order, that whoever should get something cannot take it, and that order is what
    is done in place of the `handing`: put the thing elsewhere, or tell somebody else ("take it to Anna and leave it on
    the step *if she's out*", "..., and call me *if nobody answers*")."""
    is_elsewhere = other.task.type in ("placing", "bringing") and other.is_of_it and not other.objects
    is_elsewhere = is_elsewhere and any(kind in ("goal", "recipient") for kind, _ in other.task.arguments)
    is_told = other.task.type == "informing" and not other.has_pronoun
    is_told = is_told and other.receivers.isdisjoint(handing.receivers)
    is_handed = handing.task.type == "bringing" and bool(handing.objects)
    is_handed = is_handed and any(kind in ("recipient", "goal") for kind, _ in handing.task.arguments)
    is_nobody = clause.verb == "answer" or not AROUND.isdisjoint({*clause.places, clause.wording.state})
    is_away = is_absence_of(clause, handing) or (clause.is_of_nobody and is_nobody)
    is_resting = clause.is_of_person and clause.wording.state in _RESTING and not clause.wording.is_negated
    return is_handed and ((is_away and (is_elsewhere or is_told)) or (is_resting and is_elsewhere))


def lacks_too(clause: Clause, before: Clause) -> bool:
    """Whether it says that there is none of what the order before names, "either": "bring me a pear. If *there's no
    pear either*, ..."."""
    is_named = clause.says_there_is and clause.names_same(before) and clause.wording.is_negated
    return is_named and "either" in clause.behind and before.task.type in FINDING and "if" in clause.near


def lacks_kind(clause: Clause, before: Clause) -> bool:
    """Whether it says that none of what the order before names is as that calls them: "close the *open* windows, and if
    none of them *is open*, ..."."""
    is_none = clause.is_check and clause.wording.is_negated and set(clause.objects) <= {"none"} and "if" in clause.near
    is_change = before.task.type in ("change_state", "taking", "bringing", "placing") and before.number != "one"
    return is_none and is_change and bool(before.objects) and clause.wording.state in before.thing


def is_failure_of(clause: Clause, before: Clause, named: Clause) -> bool:
    """Whether it says no more than that the change before it failed: "unlock it, and if it won't open, ..." or "if
    the trunk won't open"; `named`: the clause up to there that last names a thing, which may be put in what is
    changed then ("put the shirts in the washing machine and start it. If *the machine* doesn't start, ...")."""
    is_one = not (clause.number and before.number) or clause.number == before.number
    is_opposite = clause.wording.state is not None and OPPOSITES.get(clause.wording.state) == before.wording.state
    is_change = before.task.type == "change_state" and is_one and not is_opposite
    is_where_put = before.has_pronoun and not before.objects and not named.receivers.isdisjoint(clause.objects[-1:])
    is_of_it = clause.says_undone or (clause.says_named_undone and (clause.names_same(named) or is_where_put))
    is_of_it = is_of_it or (before.wording.state == "on" and says_broken(clause, named))
    return is_change and is_of_it and "unless" not in clause.near


def fails_behind(clause: Clause, order: Clause, before: Sequence[Clause]) -> bool:
    """Whether it says, behind another order, that an order ahead of that was not carried out: "lift it, or call Tom *if
    you can't lift it*", "bring me a pen, and tell Tom *if you can't find one*", "open it, and tell me *if it won't
    open*"; `before`: all clauses up to there."""
    named = next((one for one in reversed(before[:-1]) if one.objects), order)
    is_of_it = clause.has_pronoun and not clause.objects
    is_same = is_of_it or clause.names_same(named)
    is_sought = clause.task.type == "searching" and order.task.type in FINDING
    is_undone = clause.wording.is_negated and (is_sought or clause.verb == order.verb) and "not" in clause.near
    is_led = "if" in clause.near or "whether" in clause.near
    return is_led and not order.is_forbidden and ((is_undone and is_same) or is_failure_of(clause, order, named))


def says_broken(clause: Clause, named: Clause) -> bool:
    """Whether it asks if what was named last is out of order, which is found out by switching it on; not where that
    chooses between two orders ("switch it on, *or if it's broken* open the door")."""
    is_broken = clause.is_check and clause.wording.state in _BROKEN and not clause.wording.is_negated
    is_broken = is_broken and "or" not in (*clause.far, *clause.near)
    return is_broken and (clause.names_same(named) or (clause.has_pronoun and not clause.objects))


def tries_out(clause: Clause, before: Clause) -> bool:
    """Whether it asks if what was handled before works; of what was moved with an effort ("lift it") "it doesn't
    work" says that the effort failed."""
    is_handled = before.task.type in _MOVED and before.verb not in _STRAINING
    is_of_thing = (
        clause.is_check
        and clause.verb in _FUNCTIONING
        and not is_kept_out(clause, before)
        and not clause.is_of_person
        and bool(before.objects)
    )
    is_it = clause.has_pronoun and not clause.objects and "fail" not in clause.near
    return is_handled and is_of_thing and (is_it or clause.names_same(before))


def is_kept_out(clause: Clause, before: Clause) -> bool:
    """Whether it asks if what the order before puts somewhere goes in there: "put it in the case. If *it won't
    fit*, ..."."""
    return clause.verb == "fit" and before.task.type == "placing"


def finds_out(clause: Clause, after: Clause) -> bool:
    """Whether a later clause tells what it found out: "look in the box. If it isn't there, ...", "bring the tongs
    from the shed, and if they're not in the shed, ...", "..., and if the tongs aren't there, ..."."""
    is_place = "there" in after.places or not after.places.isdisjoint(clause.places)
    is_thing = clause.task.type == "searching" or not after.is_of_person
    says_absent = after.says_absent or (after.says_named_absent and after.names_same(clause))
    is_lacking = clause.is_of_any and not clause.objects and after.says_there_is and after.wording.is_negated
    says_absent = says_absent or (is_lacking and after.is_check)  # "get one from the shed. If there's no bulb there"
    return says_absent and is_thing and is_place and bool(clause.places) and clause.task.type in FINDING


def may_fail_as(clause: Clause, after: Clause) -> bool:
    """Whether it is a search of which a later clause tells that it failed: "find my keys. ... If you can't see
    them"."""
    are_searches = clause.task.type == after.task.type == "searching"
    is_same = after.names_same(clause) or (after.has_pronoun and not after.objects)
    return are_searches and is_same and after.wording.is_negated and "if" in after.near


def is_not_to_be_found(clause: Clause, order: Clause, check: Clause) -> bool:
    """Whether it says that what an order should fetch cannot be found, and not how what was `check`ed between them came
    out: "bring me the mug. If *it's dirty*, wash it. *If you can't find it*, ..."."""
    is_missed = clause.task.type == "searching" and clause.wording.is_negated and clause.is_of_it
    is_missed = is_missed or (clause.says_absent and not clause.places.isdisjoint(order.places | {"there"}))
    is_led = "if" in clause.near and clause.boundary != "none"
    is_one = not (clause.number and order.number) or clause.number == order.number
    is_fetched = order.task.type in FINDING and bool(order.objects) and not (order.is_forbidden or order.turns)
    is_of_state = check.is_check and check.wording.state is not None and not check.is_of_whereabouts
    return is_missed and is_led and is_one and is_fetched and is_of_state


def is_fallback_for(clause: Clause, before: Clause) -> bool:
    """Whether it is for where the order before fails, that is itself done where something else does: "look in the
    shed; failing that, try the porch; *failing that*, ask Tom". An "otherwise" behind a "failing that" turns back
    to where the first did not fail."""
    ahead, own = {*before.far, *before.near}, {*clause.far, *clause.near}
    are_orders = clause.task.type != "check_state" != before.task.type and clause.sentence - before.sentence < _FAR
    is_opened = not own.isdisjoint(_FALLING_BACK) and clause.near != ("and",)
    is_other = clause.is_otherwise and not before.is_otherwise and "fail" not in own
    is_plain = own.isdisjoint(CHOOSING - _FALLING_BACK) and not (clause.is_forbidden or before.is_forbidden)
    return are_orders and not ahead.isdisjoint(_FALLING_BACK) and is_opened and is_plain and not is_other


def is_fallback_behind(clause: Clause, before: Clause) -> bool:
    """Whether it is for where the order before fails, by what is said behind it at the end of its sentence: "move the
    chest and call Tom *if you can't manage*"."""
    are_orders = clause.task.type != "check_state" != before.task.type and clause.sentence - before.sentence < _FAR
    is_behind = clause.behind == ("fail",) and clause.ends_sentence and _LISTING.issuperset((*clause.far, *clause.near))
    is_plain = not (clause.is_forbidden or before.is_forbidden) and "fail" not in before.behind
    return are_orders and is_behind and is_plain and CHOOSING.isdisjoint({*before.far, *before.near})


def is_case_against(clause: Clause, order: Clause) -> bool:
    """Whether it calls off the order before it in a case that does not come about through that: "mow the lawn, but
    if it's wet, leave it", not "turn it on, and if it won't start, leave it"."""
    is_gone = clause.wording.is_contrary and (clause.names_same(order) or not clause.objects)
    is_outcome = clause.says_undone or clause.says_named_undone or is_gone or "fail" in clause.near
    is_plain = clause.is_check and not is_outcome and not comes_through(clause, order) and not clause.wording.is_echo
    return clause.calls_off and is_plain and order.task.type in _CALLED_OFF and not order.is_forbidden


_FALLING_BACK = frozenset(("else", "fail"))
_LISTING = frozenset(("and", "or", "then", "please", "but"))
_FAR = 2
"""From so many sentences on a "failing that" is not about the order before [sentences]."""
_BROKEN = frozenset("broken faulty busted bust kaput knackered damaged order blink".split())
"""States in which nothing can be switched on: "out of *order*", "on the *blink*"."""
_CALLED_OFF = frozenset("taking placing bringing change_state following motion".split())
"""The types of orders that may be called off: not what is looked for, asked or waited for."""
_HANDING = frozenset(("bringing", "informing"))
_MOVED = frozenset(("taking", "placing", "bringing"))
_STRAINING = frozenset("lift pull push drag move shift heave pry remove peel hide fish squeeze stuff".split())
_FUNCTIONING = frozenset("work function write run fit light start ring".split())
"""What a thing does that is as it should be."""
_RESTING = frozenset("asleep sleeping dozing napping resting busy".split())
_GONE = frozenset(("out", "away", "gone"))
