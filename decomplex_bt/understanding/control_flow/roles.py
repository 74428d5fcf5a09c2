"""Roles: whether a task is a condition, a mention of an earlier one or neither, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, JOINTS, Wording
from decomplex_bt.understanding.control_flow.cases import told_apart
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.clauses import last_named
from decomplex_bt.understanding.control_flow.contrasts import (
    asks_of,
    is_apart_from,
    is_asked_again_after,
    is_content_of,
    is_named_apart,
    is_of_another,
    is_of_other_matter,
    is_of_other_state,
    is_opposite_of,
    is_other_case_than,
    joining_role,
)
from decomplex_bt.understanding.control_flow.failures import (
    finds_out,
    is_absence_of,
    is_case_against,
    is_failure_of,
    is_fallback_for,
    lacks_too,
    tries_out,
)
from decomplex_bt.understanding.control_flow.outcomes import (
    answers_ring,
    asks_needless,
    comes_through,
    is_answer_to,
    needs_found,
    turns_on_answer,
    turns_on_report,
)
from decomplex_bt.understanding.control_flow.repetitions import forbids_same, is_choice_beside, may_repeat, repeats
from decomplex_bt.understanding.cues import WISHING

_STANDING_FOR = frozenset("none one any some more left drop bit lot answer sign reply".split())
"""What there is that may be what was named, or an answer to it, in other words."""
_DOING = frozenset(("change_state", "placing", "taking", "bringing"))


def stated_roles(clauses: Sequence[Clause], roles: Sequence[str]) -> tuple[str, ...]:
    """The roles of tasks in text order, with those that the rules below settle; as long as `roles`."""
    stated = list(roles)
    for rule in (
        _join,
        _ask_twice,
        _ask_again,
        _take_up,
        _find_out,
        _part,
        _ask_of_other_order,
        _ask_ahead_of_other,
        _ask_ahead,
        _try_out,
        _oppose,
        _wait,
        _look_after,
        _miss,
        _answer,
        _repeat,
        _call_off,
        _choose,
        _fall_back,
        _turn_back,
        _be_able,
        _be_unable,
        _ask_openly,
        _find_first,
        _report,
        _lack_too,
        _name_other,
        _hold,
        _find_nobody,
        _ask_of_order,
        _wish,
    ):
        for k in range(1, len(clauses)):
            rule(clauses, stated, k)
    for cases in told_apart(clauses, stated):
        for k in cases[1:]:  # of three states none is the other side of another: "hot", "lukewarm", "cold"
            stated[k] = "condition"
        if stated[cases[0] - 1] == "condition" and cases[0] and _leaves_state(clauses[cases[0] - 1]):
            stated[cases[0]] = "mention"  # "check on him: if he's up, ..., if he's dozing, ..., if he's asleep, ..."
    return tuple(stated)


def _leaves_state(clause: Clause) -> bool:
    """Whether it is an order to check something that says no state of it."""
    return clause.task.type == "check_state" and clause.is_asked and not clause.wording.state and not clause.asks_where


def _join(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Checks under one "if" or "unless" are one condition of several parts, and so are a mention of one and a further
    case ("if he isn't, or if he's late, ...", "if not, or if he's late, ..."); an order to check is none of them
    ("close it if it's open and *see if the heating is on*")."""
    if roles[k - 1] in CONDITION_ROLES:
        roles[k] = joining_role(clauses[k], clauses[k - 1]) or roles[k]
    is_order = clauses[k].is_asked and not clauses[k].is_question and clauses[k].task.type == "check_state"
    if roles[k] in JOINTS and is_order and clauses[k - 1].is_check:
        roles[k] = "condition" if "mention" in roles[k + 1 :] else "task"
    if roles[k - 1] == "mention" and roles[k] in CONDITION_ROLES and is_other_case_than(clauses[k], clauses[k - 1]):
        roles[k] = "or"
    if roles[k] == "condition" and roles[:k] == ["condition", *["task"] * (k - 1)] and clauses[k].is_added_to_otherwise:
        roles[k] = "or"


def _ask_twice(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """A question with its opposite is one condition ("is it in the shed *or isn't it*?")."""
    clause, before = clauses[k], clauses[k - 1]
    is_echo = clause.says_only_whether and clause.near[:1] == ("or",) and {"or", "not"}.issuperset(clause.near)
    is_turned = clause.wording.is_negated != before.wording.is_negated and clause.sentence == before.sentence
    if is_echo and is_turned and before.is_question and roles[k - 1] in CONDITION_ROLES:
        roles[k] = "mention"


def _ask_again(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether something is still so, once something was done about it, is asked anew ("if it's red, restart it, and if
    it's *still red*, call Tom")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] != "task"), None)
    if roles[k] != "mention" or first is None or first == k - 1 or roles[first] != "condition":
        return
    is_done = any(clauses[j].task.type in _DOING for j in range(first + 1, k))
    if clauses[first].is_check and is_done and is_asked_again_after(clauses[k], clauses[first]):
        roles[k] = "condition"


def _find_out(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What tells how something before it went is a mention of that, which is thereby a condition."""
    found_out = _found_out(clauses, roles, k) if roles[k] in CONDITION_ROLES else None
    if found_out is not None:
        roles[k] = "mention"
        roles[found_out] = "condition" if roles[found_out] == "task" else roles[found_out]


def _found_out(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """What finds out what clause `k` tells of: the one before it, be it that who should get something is not there
    ("take it to Anna, and if she's out, ...") or that what was to be changed does not do so ("unlock it. If it won't
    open, ..."), or the one before that where what is between is done with what was found ("get it from the box and
    hang it up. If it isn't in the box, ...") or is done in that case ("look in the box, and tell me if it isn't
    there")."""
    before, clause = clauses[k - 1 : k + 1]
    earlier = [clauses[j] for j in range(k - 1) if roles[j] in CONDITION_ROLES]
    is_found = any(one.is_of_whereabouts or one.task.type == "searching" for one in earlier)
    is_own = before.task.type == "searching" or not is_found or not clause.places.isdisjoint(before.places)
    is_failure = is_failure_of(clause, before, last_named(clauses, k))
    is_outcome = (finds_out(before, clause) and is_own) or is_failure
    is_lacking = roles[k] == "mention" and lacks_too(clause, before)
    if (is_outcome and not clause.is_trailing) or is_lacking:
        return k - 1
    if is_absence_of(clause, before) and not _is_asked_after(clause, before, earlier) and not clause.is_trailing:
        return k - 1
    if k > 1 and roles[k - 1] == "task" and finds_out(clauses[k - 2], clauses[k]):
        return k - 2 if clauses[k - 1].has_pronoun or clauses[k].boundary == "none" else None
    return None


def _is_asked_after(clause: Clause, before: Clause, earlier: Sequence[Clause]) -> bool:
    """Whether an earlier condition asks where the one is who, by `clause`, is not there for the errand `before`: then
    it is that one which `clause` mentions."""
    if clause.says_too and clause.is_of_person:
        return False  # "and if she isn't in *either*"
    checks = [one for one in earlier if one.is_of_whereabouts or one.wording.is_echo]
    checks = [one for one in checks if one.objects or one.is_of_person == clause.is_of_person]
    return any(not (before.receivers and one.objects) or not before.receivers.isdisjoint(one.objects) for one in checks)


def _part(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """A check whose words are of another matter than those of all conditions before it is no mention of one, but a
    condition of its own; and then what an order to check asks is asked of nothing ("check if it is done, and if it's
    burnt, ...")."""
    clause, before = clauses[k], clauses[k - 1]
    is_bare = roles[k] == "mention" and roles[k - 1] == "condition" and "mention" not in roles[k + 1 :]
    is_order_to_check = is_bare and before.is_asked and is_of_other_matter(clause, before)
    firsts = [clauses[j] for j in range(k) if roles[j] == "condition"]
    if is_order_to_check or (is_bare and is_of_other_state(clause, before)):
        roles[k - 1 : k + 1] = "task", "condition"
    elif roles[k] == "mention" and firsts and all(is_of_another(clause, first) for first in firsts):
        roles[k] = "condition"
    last = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), k)
    if roles[k] == "mention" and roles[last] == "mention" and is_named_apart(clause, clauses[last]):
        roles[k] = "condition"


def _ask_ahead(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether what is ordered is so already is no outcome of the order ("open it. *If it's open already*, ...")."""
    is_outcome = roles[k - 1] == "condition" and roles[k] == "mention" and "mention" not in roles[k + 1 :]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    things = set(clauses[first].objects) if first is not None else set()
    is_other = bool(things) and things.isdisjoint(clauses[k - 1].objects)
    # "if the study is empty, close the window; if *that's closed already*, ...", not "if it's on, turn it off; ..."
    is_nested = (roles[k - 1], roles[k]) == ("task", "mention") and bool(clauses[k - 1].objects) and is_other
    if (is_outcome or is_nested) and asks_needless(clauses[k], clauses[k - 1]):
        roles[k - 1 : k + 1] = "task", "condition"


def _ask_of_other_order(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an order that an "or" opens hangs on, said behind it, is a case of its own ("open the window if it's sunny,
    *or* light the stove *if it's raining*")."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = clause.boundary == "none" and clause.near == ("if",) and clause.is_check
    is_order = roles[k - 1] in ("task", "or") and order.task.type in _DOING | {"informing", "motion"}
    is_led = k > 1 and roles[k - 2] == "condition" and order.near[:1] == ("or",) and is_order
    is_echo = clause.says_only_whether or is_opposite_of(clause, clauses[k - 2])
    is_case = roles[k] in ("or", "mention", "condition") and not is_echo
    if is_led and is_behind and is_case and clauses[k - 2].boundary == "none":
        roles[k - 1 : k + 1] = "task", "condition"


def _ask_ahead_of_other(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an "or if" opens behind an order and its case, with an order of its own, is no part of that case ("hang it
    up if it's wet, *or if it's dry*, fold it")."""
    if k < 2 or k + 1 >= len(clauses) or roles[k] != "or" or (roles[k - 2], roles[k + 1]) != ("task", "task"):
        return
    order, check, clause, other = clauses[k - 2 : k + 2]
    is_behind = check.boundary == "none" and check.near == ("if",) and roles[k - 1] == "condition"
    is_led = clause.boundary == "," and clause.near == ("or", "if") and other.boundary == "," and not other.near
    if is_behind and is_led and order.sentence == clause.sentence == other.sentence:
        roles[k] = "mention" if is_opposite_of(clause, check) else "condition"


def _try_out(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether what was fetched or put somewhere does what it is for is no mention of the fetching ("bring me the torch.
    If *it doesn't work*, take the lamp")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] != "mention" or first != k - 1 or roles[first] != "condition" or "mention" in roles[k + 1 :]:
        return
    if tries_out(clauses[k], clauses[first]):
        roles[first : k + 1] = "task", "condition"


def _oppose(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What tests the opposite of the condition before, of the same thing, is a mention of it."""
    clause = clauses[k]
    before = next((clauses[j] for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] == "condition" and before is not None and "if" in clause.near and is_opposite_of(clause, before):
        roles[k] = "mention"


def _hold(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That something is in what was asked to be empty is its other side ("if the basket is empty, ...; if *it still
    contains clothes*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[first], roles[k]) != ("condition", "condition") or first == k - 1:
        return
    is_opened = "if" in clauses[k].near and clauses[k].boundary != "none"
    is_changed = any(not clauses[j].effects.isdisjoint(("empty", "full")) for j in range(first + 1, k))
    if is_opened and not is_changed and is_content_of(clauses[k], clauses[first]):
        roles[k] = "mention"


def _wait(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What a "when" says to be so in the end is waited for where the order right before brings it about ("if the oven
    isn't hot, turn it on. *When it is hot*, put the cake in")."""
    clause, order = clauses[k], clauses[k - 1]
    is_when = roles[k] == "mention" and clause.near == ("when",) and clause.boundary != "none" and clause.is_check
    if is_when and roles[k - 1] == "task" and not clause.wording.is_negated and comes_through(clause, order):
        roles[k] = "task"


def _look_after(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an order to check leaves open is asked right behind it ("check on the baby. *If she's crying*, ...")."""
    clause, check = clauses[k], clauses[k - 1]
    is_asked = clause.is_check and clause.has_pronoun and not clause.objects and bool(clause.said_state)
    is_open = not check.is_question and _leaves_state(check) and roles[k - 1] == "condition"
    if is_asked and is_open and clause.near == ("if",) and roles[k] == "condition":
        roles[k] = "mention"


def _miss(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That somebody is not there tells of the look for them, not of what is given or told them then ("find Tom and give
    him this. *If he isn't there*, ...")."""
    if k < 2 or roles[k] != "mention" or not clauses[k].says_absent or not clauses[k].is_of_person:
        return
    search, order = clauses[k - 2 : k]
    is_told = order.task.type in ("bringing", "informing") and order.near[-1:] == ("and",) and order.has_pronoun
    if search.task.type == "searching" and is_told and not order.receivers and search.may_be_of_person:
        roles[k - 2 : k] = "condition", "task"


def _answer(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What tells how somebody answered is no mention of a condition before the question; and "if he says no" or "if he
    refuses" none of the question."""
    order = replied_to(clauses, roles, k)
    if roles[k] == "mention" and order is not None:
        is_offer = clauses[order].task.type == "bringing"  # "offer her the tea, and if she refuses": not given then
        if roles[order] == "task" or not is_offer:
            roles[order], roles[k] = "task", "condition"
    if roles[k] == "condition" and _is_other_reply(clauses, roles, k):
        roles[k] = "mention"
    is_last = "mention" not in roles[k + 1 :]
    if roles[k - 1 : k + 1] == ["condition", "mention"] and is_last and answers_ring(clauses[k], clauses[k - 1]):
        roles[k - 1 : k + 1] = "task", "condition"
    if clauses[k].says_answer and clauses[k - 1].question and roles[k - 1 : k + 1] == ["condition", "mention"]:
        roles[k - 1 : k + 1] = "task", "condition"
    others = [clauses[j] for j in range(k - 1) if roles[j] in CONDITION_ROLES]
    if roles[k] == "mention" and others and is_answer_to(clauses[k], clauses[k - 1], others):
        roles[k] = "condition"


def replied_to(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """The order that clause `k` tells somebody's reply to ("if she's in, *ask her to come*, ... If she refuses, ..."):
    the last one to ask, tell or offer something, without a condition between; else None."""
    if not clauses[k].says_reply:
        return None
    order = k - 1
    while order > 0 and roles[order] == "task" and not clauses[order].is_put_to_somebody:
        order -= 1
    is_near = clauses[k].sentence - clauses[order].sentence <= 1 and roles[order] in ("task", "condition")
    return order if order >= 0 and is_near and clauses[order].is_put_to_somebody else None


def _is_other_reply(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether it tells the other of two replies: "if he agrees, ...; *if he refuses*, ..."."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] != "task"), k)
    one, other = clauses[first].wording, clauses[k].wording
    are_replies = clauses[k].says_reply and clauses[first].says_reply and first < k
    return are_replies and (one.is_contrary != one.is_negated) != (other.is_contrary != other.is_negated)


def _repeat(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """An order that is only said again, to say what comes before it, is carried out once; what is of another type than
    all orders before, or names another thing, says none of them again."""
    if roles[k] == "again" and not any(roles[j] == "task" and may_repeat(clauses[k], clauses[j]) for j in range(k)):
        roles[k] = "task"
    if roles[k] == "task" and any(roles[j] == "task" and _says_again(clauses[k], clauses[j]) for j in range(k)):
        roles[k] = "again"


def _says_again(clause: Clause, before: Clause) -> bool:
    return repeats(clause, before) or forbids_same(clause, before)


def _call_off(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What tells in which case an order is not to be carried out is a condition."""
    if (roles[k - 1], roles[k]) == ("task", "task") and is_case_against(clauses[k], clauses[k - 1]):
        roles[k] = "condition"


def _choose(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Of two orders that an "or" joins the second is for where the first fails."""
    if may_choose(clauses, roles, k) and roles[k - 1] == "task":
        roles[k - 1] = "condition"


def _fall_back(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Of several fallbacks in a row each is for where the one before it fails, too, and what "or, failing that" opens
    is for where the order before it does, in a case that denies something ("if there's no bread, bring crackers *or,
    failing that, an apple*")."""
    clause, order = clauses[k], clauses[k - 1]
    is_or = {"or", "fail"} <= {*clause.far, *clause.near} and clause.sentence == order.sentence
    is_denied = k > 1 and roles[k - 2] in CONDITION_ROLES and clauses[k - 2].wording.is_negated
    is_for_order = is_or and is_denied and order.task.type != "check_state" and not order.is_forbidden
    is_next = roles[k - 1] == "task" and roles[k] in ("task", "condition")
    if is_next and (is_for_order or is_fallback_for(clause, order)):
        roles[k - 1] = "condition"


def _turn_back(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an "if not" opens is no condition of what an "otherwise" opens behind it."""
    if opened_if_not(clauses, roles, k) == k - 1 and roles[k - 1] == "condition":
        roles[k - 1] = "task"


def opened_if_not(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """The order that an "if not" opens right behind a condition, where an "otherwise" opens task `k` and nothing but
    what is done in that case stands between ("is it dry? *If not, hang it up*, otherwise ..."): `k` itself where no
    task stands between ("if not, fine, otherwise ..."); else None."""
    if clauses[k].turns[-1:] != ("otherwise",) or len(clauses[k].turns) > 2:
        return None
    first = k
    if len(clauses[k].turns) == 1:
        first -= 1
        while first > 0 and roles[first] == "task" and not clauses[first].turns:
            first -= 1
        if not clauses[first].is_done_if_not or clauses[k].sentence - clauses[first].sentence > 1:
            return None
    elif clauses[k].turns != ("not", "otherwise"):
        return None
    is_behind = first > 0 and roles[first - 1] in CONDITION_ROLES and not clauses[first - 1].wording.is_negated
    return first if is_behind else None


def _take_up(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Where one of two conditions that "and" joins is spoken of again alone, the second is asked where the first
    holds."""
    part = taken_up(clauses, roles, k)
    if part is not None:
        second = part if roles[part] == "and" else part + 1
        roles[second] = "condition" if roles[second] == "and" else roles[second]


def _ask_openly(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What no yes or no answers is no condition, so what is asked behind it is one of its own ("see what he's doing,
    and if he's asleep, ...")."""
    if clauses[k - 1].asks_open and roles[k - 1] == "condition":
        roles[k - 1] = "task"
        roles[k] = "condition" if roles[k] in CONDITION_ROLES else roles[k]


def _find_first(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What is fetched of what was checked to be there hangs on that ("see if there's any milk and *bring me some*")."""
    if (roles[k - 1], roles[k]) == ("task", "task") and needs_found(clauses[k], clauses[k - 1]):
        roles[k - 1] = "condition"


def _report(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What is to be told is a condition of what is done in one case of it ("tell me if it's on and switch it off if
    so"), and so is what somebody is asked ("ask him if he wants tea, and if so, make some")."""
    if (roles[k - 1], roles[k]) != ("task", "task"):
        return
    if turns_on_report(clauses[k], clauses[k - 1]) or turns_on_answer(clauses[k], clauses[k - 1]):
        roles[k - 1] = "condition"


def _lack_too(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What somebody does not do or have "either" tells how the order right before went, as the same said of another one
    told of an order of its own ("call Tom. If he doesn't answer, call Ann. If *she doesn't answer either*, ...")."""
    clause, order = clauses[k], clauses[k - 1]
    is_too = clause.says_too and clause.wording.is_negated and clause.has_pronoun and roles[k] == "mention"
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if not is_too or first is None or roles[k - 1] != "task" or order.task.type not in ("informing", "searching"):
        return
    if clauses[first].verb == clause.verb and clauses[first].wording.is_negated:
        roles[k - 1 if roles[first] == "mention" else k] = "condition"


def _be_able(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Behind "if you can ..., do this" an "if you can't" is of that, and not of what is done ("if you can find it,
    bring it; if you can't, tell me")."""
    if clauses[k].ability != "denied" or roles[k - 1] != "condition" or clauses[k - 1].ability:
        return
    first = next((j for j in range(k - 2, -1, -1) if roles[j] != "task"), None)
    if first is not None and roles[first] == "condition" and clauses[first].ability == "asked":
        roles[k - 1] = "task"


def _be_unable(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Behind the one order of a case that asks neither what can be done nor what can be found an "if you can't" is of
    that order ("unless it's raining, open the gate. *If you can't*, tell me")."""
    if k < 2 or clauses[k].ability != "denied" or tuple(roles[k - 2 : k + 1]) != ("condition", "task", "task"):
        return
    check, order = clauses[k - 2 : k]
    is_case = check.is_check and not check.ability
    if is_case and order.task.type in _DOING | {"informing"} and not order.is_forbidden and not order.turns:
        roles[k - 1] = "condition"


def taken_up(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """Of two conditions that "and" joins the one that mention `k`, which names nothing, is of: the one that asks for
    its state, or the opposite, or, where it says "there", for a place ("if he is in his room and he's awake, ...; *if
    he's asleep*, ...", "...; *if he isn't there*, ..."); else None."""
    clause = clauses[k]
    second = next((j for j in range(k - 1, 0, -1) if roles[j] != "task"), 0)
    first = second - 1
    if first < 0 or roles[first] != "condition" or roles[second] not in ("condition", "and") or roles[k] != "mention":
        return None
    if not clause.has_pronoun or clause.objects or clauses[second].wording.joins != "and":
        return None
    if clause.wording.state is not None:
        fitting = [j for j in (first, second) if _are_of_one_state(clauses[j].wording, clause.wording)]
    else:
        fitting = [j for j in (first, second) if clauses[j].is_of_whereabouts and "there" in clause.places]
    return fitting[0] if len(fitting) == 1 else None


def _are_of_one_state(one: Wording, other: Wording) -> bool:
    return one.state == other.state or one.is_opposite_of(other) or other.is_opposite_of(one)


def may_choose(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether task `k` is ordered instead of the one before it, as it may be; not where a condition stands behind them
    in their sentence ("... or grab the stick if you can't") or chooses between them ("depending on whether ...")."""
    sentence = clauses[k].sentence
    around = [j for j, clause in enumerate(clauses) if clause.sentence == sentence]
    is_chosen = any("depending" in (*clauses[j].far, *clauses[j].near) for j in around)
    is_asked = any(roles[j] in CONDITION_ROLES for j in around if j > k)
    return roles[k] == "task" and is_choice_beside(clauses[k], clauses[k - 1]) and not (is_chosen or is_asked)


def _name_other(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether there is something that was not spoken of is no mention of what state another thing is in ("check whether
    the timer is on; if *there are five minutes* left, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] != "mention" or first is None or not (clause.says_there_is and clauses[first].said_state):
        return
    named = {noun for before in clauses[:k] for noun in (*before.nouns, *before.thing)}
    if clause.objects and named.isdisjoint(clause.objects) and _STANDING_FOR.isdisjoint(clause.objects):
        roles[k] = "condition"


def _find_nobody(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That nobody is in a place is no failure of an order that has nothing to do with it ("wash the pan. If nobody is
    in the study, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] != "mention" or first is None or not is_apart_from(clauses[k], clauses[first]):
        return
    roles[k] = "condition"
    if roles[first] == "condition" and "mention" not in roles[first + 1 :]:
        roles[first] = "task"


def _ask_of_order(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an order right ahead hangs on is no mention of another state of another thing ("is the tv on? Then turn it
    off, and close the window if *it's open*")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if (roles[k - 1], roles[k]) == ("task", "mention") and first is not None:
        roles[k] = "condition" if asks_of(clauses[k], clauses[k - 1], clauses[first]) else "mention"


def _wish(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What somebody wants is no mention of a condition, where nothing before was a wish ("if he's out, ... Offer him a
    tea; *if he doesn't want one*, ...")."""
    is_first = not any(before.is_wish or not WISHING.isdisjoint(before.question) for before in clauses[:k])
    if roles[k] == "mention" and clauses[k].is_check and clauses[k].verb in WISHING and is_first:
        roles[k] = "condition"
