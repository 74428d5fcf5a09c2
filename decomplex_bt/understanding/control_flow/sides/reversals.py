"""Reversals: what turns a side round: an "otherwise", an "if not", an "if it is" behind the order, a fallback."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, is_flipped
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.failures import is_fallback_behind, is_fallback_for
from decomplex_bt.understanding.control_flow.outcomes import turns_on_report
from decomplex_bt.understanding.control_flow.roles.orders import may_choose, opened_if_not
from decomplex_bt.understanding.control_flow.sides.labels import (
    FAILS,
    HOLDS,
    MOVING,
    OPENING,
    TURNING,
    beside,
    goes_on,
)

_OTHERS = frozenset("else so if unless when only_if".split())
_IFS = frozenset(("if", "when"))
_BARE = frozenset(("be", "do", "have"))
_LISTING = ((), ("and",), ("then",), ("and", "then"))


def oppose(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "otherwise" opens right behind a condition is done where that does not hold ("if it's raining, fine,
    otherwise ...", "don't start it if it isn't full, otherwise ..."), and behind a mention that affirms the condition
    of a task on the other side than that task ("bring it if it is, otherwise ...", "look for it and bring it if you see
    it, or else ..."), which is how such a mention is stated (`arcs.flip_of`)."""
    is_restricted = "unless" in clauses[k - 1].near
    is_forbidding = k > 1 and clauses[k - 2].is_forbidden and sides[k - 2] == ">1-" and not is_restricted
    is_plain = roles[k - 1] == "condition" and (is_forbidding or not clauses[k - 1].wording.is_negated)
    is_search = clauses[k - 1].task.type == "searching" and "if" not in clauses[k - 1].near
    is_in_vain = is_search and clauses[k].far[-2:] == ("fail", "if")  # "should you come up empty, ..."
    if roles[k] == "task" and (clauses[k].is_otherwise or is_in_vain) and is_plain and sides[k] == HOLDS:
        sides[k] = FAILS
    if _is_echoed_before(clauses, roles, k) and (clauses[k].is_otherwise or _falls_back(clauses[k])):
        is_of_it = sides[k - 2][:2] == "<1" and sides[k][:2] == "<1"
        for j in range(k, len(clauses)) if is_of_it else ():
            if j > k and not goes_on(clauses, roles, sides, j, clauses[k].sentence):
                break
            sides[j] = HOLDS
    elif _is_affirmed_before(clauses, roles, sides, k) and {"else", "fail"} & {*clauses[k].far, *clauses[k].near}:
        for j in range(k, len(clauses)):
            if roles[j] != "task" or sides[j] != FAILS or clauses[j].sentence != clauses[k].sentence:
                break
            sides[j] = HOLDS


def see_to(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What right behind a question brings about the state that it asks for is done where that is not so, and what ends
    it where it is ("the hatch isn't shut, is it? *Shut it*", "isn't the lamp on? *Switch it off*"); and so is what is
    done "if not" or "if so", said behind it ("is the lamp on? Switch it on *if not*")."""
    question, order = clauses[k - 1 : k + 1]
    is_next = (roles[k - 1], roles[k]) == ("condition", "task") and order.sentence == question.sentence + 1
    is_plain = not (order.near or question.far) and order.takes_up(question) and question.is_question
    state = question.wording.state
    if not (is_next and is_plain and state) or sides[k] not in (HOLDS, FAILS):
        return
    if order.behind in (("so",), ("else",)) and order.ends_sentence:
        sides[k] = HOLDS if (order.behind == ("so",)) != question.wording.is_negated else FAILS
    elif not order.behind and state in order.effects ^ order.needs:
        sides[k] = HOLDS if (state in order.needs) != question.wording.is_negated else FAILS


def take_up_case(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "in that case", right behind what is done in one, is done in the same ("if it's hot, bring
    it. If not, fill it. *In that case* also ..."), and what is done "in the former case" or "over that" in the
    other one."""
    clause, before = clauses[k], clauses[k - 1]
    is_behind = (roles[k - 1], roles[k]) == ("task", "task") and clause.sentence - before.sentence in (0, 1)
    if not (is_behind and clause.case and sides[k - 1] in (HOLDS, FAILS)):
        return
    other = FAILS if sides[k - 1] == HOLDS else HOLDS
    side, was = sides[k - 1] if clause.case == "same" else other, sides[k]
    for j in range(k, len(clauses)):
        if roles[j] != "task" or clauses[j].sentence != clause.sentence or sides[j] != was:
            return
        sides[j] = side


def do_then(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with the same thing in another place "then", in the sentence behind an "unless", is done where that
    holds ("put it on the shelf unless it's full. *Put it on the floor then*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "condition", "task"):
        return
    order, check, clause = clauses[k - 2 : k + 1]
    is_excepted = check.near == ("unless",) and check.boundary == "none" and check.sentence == order.sentence
    is_same = order.task.type == clause.task.type in MOVING and clause.is_of_it and not clause.objects
    is_elsewhere = bool(clause.receivers) and clause.receivers.isdisjoint(order.receivers)
    is_next = clause.sentence == check.sentence + 1 and sides[k - 1] == sides[k] == "top"
    if is_excepted and is_same and is_elsewhere and is_next and clause.is_then:
        sides[k] = FAILS


def report(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if so" or "if not" behind what is to be told hangs on that."""
    if (roles[k - 1], roles[k]) == ("condition", "task") and (case := turns_on_report(clauses[k], clauses[k - 1])):
        sides[k] = HOLDS if case == "so" else FAILS


def turn_back(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "otherwise" opens behind what an "if not" opens is done where the condition holds ("is it dry? If not,
    hang it up, otherwise fold it"), and so is what goes on with it."""
    first = opened_if_not(clauses, roles, k)
    if first is None or roles[k] != "task" or {*sides[first:k]} - {FAILS}:
        return
    for j in range(k, len(clauses)):
        is_next = j == k or goes_on(clauses, roles, sides, j, clauses[k].sentence)
        if sides[j] != FAILS or not is_next:
            return
        sides[j] = HOLDS


def affirm(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if" or "only if" what was asked before proves true, said behind it at the end of a sentence, is
    done where it does ("..., failing that, ask Tom. Bring it to me if you find it", "see if it's locked, and unlock it
    *if it is*")."""
    clause, task = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    order = None if first is None else _stated_at(roles, first)
    if first is None or order is None or (roles[k - 1], roles[k]) != ("task", "mention"):
        return
    is_plain = not clause.wording.is_negated and not clause.wording.contradicts(clauses[order].wording)
    is_taken_up = clause.wording.is_echo or clause.task.type == "searching"
    is_end = clause.ends_sentence or clauses[k + 1].is_otherwise
    is_trailing = is_taken_up and clause.sentence == task.sentence and clause.boundary == "none" and is_end
    is_leading = clauses[k - 2].sentence != task.sentence
    is_leading = is_leading or (first == k - 2 and clauses[first].is_asked and clause.wording.is_echo)
    is_leading = is_leading or (first > order and _is_denied(clauses, first, order))  # "if she isn't, ..."
    is_of_if = {"if", "only_if"} & set(clause.near) and not {"not", "or", "unless", "but"} & set(clause.near)
    is_other = task.is_forbidden or {"else", "fail", "not", "or"} & {*task.far, *task.near, *task.behind}
    if is_plain and is_trailing and is_leading and is_of_if and not is_other and sides[k - 1] in (HOLDS, FAILS):
        sides[k - 1] = FAILS if _is_denied(clauses, first, order) else HOLDS


def deny(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if it isn't", said behind it at the end of a sentence or ahead of a comma, is done where what was
    asked before proves false ("see whether it's shut, and shut it *if it isn't*"), or what was ordered before fails
    ("look for my ring and wake Tom *if you can't find it*"), and what is done "if it is" where that was denied ("shut
    it if it isn't shut, and tell me *if it is*"). What is listed on behind that is done in any case ("..., *and then
    come here*")."""
    clause, task = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[k - 1], roles[k]) != ("task", "mention"):
        return
    opening = tuple(cue for cue in clause.near if cue != "also")  # "shut that as well if it isn't"
    is_failing = opening == ("fail",)  # "if it doesn't"
    is_first = roles[first] == "condition"
    is_other = is_first and (clause.wording.is_negated or is_failing) != clauses[first].wording.is_negated
    opener = ("whether",) if task.task.type == "informing" else ("if",)  # "tell me if it isn't"
    is_opened = is_failing or opening[:1] in (("if",), opener)
    is_listed = not clause.ends_sentence and clauses[k + 1].boundary == ","
    is_closed = clause.boundary == "none" and (clause.ends_sentence or is_listed)
    is_behind = is_closed and clause.sentence == task.sentence and is_opened
    is_turned = task.is_forbidden or {"else", "fail", "not", "or"} & {*task.far, *task.near, *task.behind[:-1]}
    is_plain = not is_turned and clauses[first].ability == ""
    is_bare = clause.says_only_whether and is_other and sides[k - 1] in (HOLDS, FAILS)
    if not (is_behind and is_plain and (is_bare or _is_failure_behind(clauses, roles, sides, k, first))):
        return
    sides[k - 1] = FAILS
    if is_listed and is_first:
        _list_on(clauses, roles, sides, k, first)


def _is_failure_behind(
    clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], k: int, first: int
) -> bool:
    """Whether mention `k` says that what an order was to find out or do is not so; `first`: that order, or an "if you
    find it" right behind it."""
    order = _stated_at(roles, first)
    if order is None or sides[k][:2] != "<1" or sides[k - 1] not in ("top", HOLDS):
        return False
    is_order = not clauses[order].is_check and OPENING.isdisjoint(clauses[order].near)
    is_other = _is_denied(clauses, first, order) != _is_denied(clauses, k, order)
    return is_order and is_other and not clauses[order].wording.is_negated and _is_denied(clauses, k, order)


def _stated_at(roles: Sequence[str], k: int) -> int | None:
    """The condition at `k`, or right ahead of the mention at `k`."""
    at = k if roles[k] == "condition" else k - 1
    return at if at >= 0 and roles[at] == "condition" else None


def _is_denied(clauses: Sequence[Clause], k: int, first: int) -> bool:
    """Whether clause `k` denies the condition `first`, which it takes up or is."""
    return is_flipped(k, first, [clause.wording for clause in clauses])


def agree_behind(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "then" lists on behind an order and its "if it is" is done in any case ("check if it's open, close it *if
    it is*, and then tell me")."""
    clause = clauses[k]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] != "condition" or (roles[k - 1], roles[k]) != ("task", "mention"):
        return
    is_listed = k + 1 < len(clauses) and clauses[k + 1].boundary in (",", "none") and "then" in clauses[k + 1].near
    is_behind = clause.boundary == "none" and clause.near == ("if",) and clause.sentence == clauses[k - 1].sentence
    is_bare = clause.behind == ("then",) and clause.verb in _BARE and not (clause.said_state or clause.places)
    is_bare = clause.wording.is_echo or (is_bare and clause.has_pronoun and not clause.objects)
    if is_listed and is_behind and is_bare and not clause.wording.is_negated:
        _list_on(clauses, roles, sides, k, first)


def _list_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int, first: int) -> None:
    """Sets what is listed on behind mention `k` beside the condition `first` that it is of."""
    for j in range(k + 1, len(clauses) if clauses[k + 1].near in _LISTING else 0):
        is_next = j == k + 1 and roles[j] == "task" and sides[j] in (HOLDS, FAILS)  # a "not" ahead is the mention's
        if not (is_next or goes_on(clauses, roles, sides, j, clauses[k].sentence)):
            return
        sides[j] = beside(sides[first])


def search_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A search of another place "if it isn't there", said behind it, is for where the one before fails ("look in the
    bag, then try the shelf *if it isn't there*, and failing that ask Tom")."""
    clause, task = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] != "condition" or roles[k - 1] == "mention" or roles[k] != "mention":
        return
    is_search = clauses[first].task.type == task.task.type == "searching" and task.sentence == clause.sentence
    is_behind = clause.boundary == "none" and clause.near == ("if",) and clause.wording.is_negated
    is_end = k + 1 == len(clauses) or clauses[k + 1].boundary != "none"
    if not (is_search and is_behind and is_end and sides[k - 1][:2] == "<1" and "but" not in (*task.far, *task.near)):
        return
    sides[k - 1] = FAILS
    is_gone_on = k + 1 < len(clauses) and (clauses[k + 1].near, sides[k + 1][:2]) == (("and",), "<1")
    if is_gone_on and clauses[k + 1].sentence == clause.sentence:
        sides[k + 1] = "top"  # "... and bring it here", wherever it was
    if roles[k - 1] == "condition":
        sides[k] = "<2"  # it is the search before that, and what follows is of the one behind
        for j in range(k + 1, len(clauses)):
            is_of_second = _falls_back(clauses[j]) or (j == k + 1 and clauses[j].near[:2] == ("and", "if"))
            sides[j] = "<2-" if roles[j] == "task" and sides[j][:2] == "<1" and is_of_second else sides[j]


def affirm_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if she does", right behind the condition of an order ahead of it, is done in the case of that order
    ("leave it open in case the cat comes, and *if she does*, ..."), though `arcs.flip_of` takes such a mention for the
    other case."""
    if k < 2 or k + 1 == len(clauses) or (roles[k - 2], roles[k - 1], roles[k]) != ("task", "condition", "mention"):
        return
    mention, check = clauses[k], clauses[k - 1]
    is_leading = not mention.is_trailing and mention.boundary != "none"
    is_plain = mention.wording.is_echo and "if" in mention.near and not check.wording.is_negated
    if not (is_leading and is_plain and sides[k - 2] == ">1+" and "unless" not in check.near):
        return
    for j in range(k + 1, len(clauses)):
        if sides[j] != HOLDS or not (j == k + 1 or goes_on(clauses, roles, sides, j, mention.sentence)):
            return
        sides[j] = FAILS


def affirm_anew(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if it was", or in the very words that were asked, is done where that is so, as what was done before
    it is ("check if it's on, turn it off, and *if it was on*, tell me"), though `arcs.flip_of` takes such a mention for
    the other case."""
    if k < 2 or k + 1 == len(clauses) or roles[k] != "mention" or roles[k + 1] != "task":
        return
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), k)
    if first >= k - 1 or roles[first] != "condition" or any(sides[j] != HOLDS for j in range(first + 1, k)):
        return
    mention, check = clauses[k], clauses[first]
    one, other = mention.wording, check.wording
    is_same = one.is_echo or (bool(one.state) and one.state == other.state)
    is_plain = not (one.is_negated or other.is_negated or one.contradicts(other))
    is_led = mention.near in (("if",), ("and", "if")) and mention.boundary != "none"
    is_led = is_led and mention.sentence == check.sentence
    if not (is_same and is_plain and is_led and check.is_asked):
        return
    for j in range(k + 1, len(clauses)):
        if sides[j] != HOLDS or not (j == k + 1 or goes_on(clauses, roles, sides, j, mention.sentence)):
            return
        sides[j] = FAILS


def choose(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What may be done instead of the order before it is done where that fails; what goes on behind it hangs on what
    it hung on."""
    if roles[k - 1] != "condition" or not may_choose(clauses, roles, k):
        return
    sides[k] = FAILS
    for j in takewhile(lambda j: roles[j] == "task", range(k + 1, len(clauses))):
        if sides[j][0] == "<":
            sides[j] = f"<{min(9, int(sides[j][1]) + 1)}{sides[j][2:]}"


def fall_back(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "failing that" opens is never done where something held, and a second one is for where the first fails as
    well ("failing that, try the porch; failing that, ask Tom"); what an "if you can't" stands behind is for where the
    order before fails."""
    is_echoed = _is_echoed_before(clauses, roles, k)
    if roles[k] == "task" and sides[k] == HOLDS and _falls_back(clauses[k]) and not is_echoed:
        sides[k] = FAILS
    is_second = roles[k - 1] == "condition" and roles[k] in ("task", "condition")
    clause, order = clauses[k], clauses[k - 1]
    if is_second and (is_fallback_for(clause, order) or is_fallback_behind(clause, order)):
        sides[k] = FAILS


def follow(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What follows an "if it does not ..." in its sentence is done where it does not, unless an "otherwise" or the like
    stands between.

    In "if it does not work" the cue says so, not the clause's own negation; it is the other side only right behind what
    it mentions, before one side of that has tasks, be they ahead of it (`arcs.flip_of`).
    """
    clause, before = clauses[k], clauses[k - 1]
    is_denied = before.wording.is_negated and not _IFS.isdisjoint(before.near)
    # "light it. If it lights, fine. If it doesn't, ..."
    first = next((j for j in range(k - 1, 0, -1) if roles[j] != "mention"), 0)
    is_mention = roles[k - 1] == "mention" and roles[first] == "condition"
    is_mention = is_mention and not (first and roles[first - 1] == "task" and sides[first - 1][:2] == ">1")
    is_contrary = before.wording.is_contrary or before.wording.is_negated
    is_failure = is_mention and "fail" in before.near and not is_contrary
    between = {*clause.far, *clause.near, *before.behind}
    if roles[k - 1] not in CONDITION_ROLES or not (is_failure or is_denied) or between & TURNING:
        return
    behind = clauses[k + 1] if k + 1 < len(clauses) else None
    if behind is not None and behind.is_trailing and roles[k + 1] == "mention":
        return  # "if it doesn't bark, fine, and wake him *if it does*"
    wrong, right = (HOLDS, FAILS) if is_failure else (FAILS, HOLDS)
    for j in range(k, len(clauses)):
        if sides[j] != wrong or clauses[j].sentence != before.sentence:
            return
        sides[j] = right


def do_after_all(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done where something is "still" otherwise than it is after "if I did", of which nothing comes, is done
    where I did not ("I'm not sure if I locked it. If I did, fine, *but if it's still open*, lock it")."""
    if k < 2 or (roles[k - 2], roles[k - 1], roles[k]) != ("condition", "mention", "task") or sides[k] != HOLDS:
        return
    first, mention = clauses[k - 2 : k]
    is_done = first.verb == "do" and first.wording.is_echo and "if" in first.near and not first.wording.is_negated
    is_still = mention.near == ("but", "if") and mention.says_still and not mention.wording.is_negated
    for j in range(k, len(clauses)) if is_done and is_still and mention.sentence == first.sentence else ():
        if sides[j] != HOLDS or not (j == k or goes_on(clauses, roles, sides, j, mention.sentence)):
            return
        sides[j] = FAILS


def pick(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with those of what is to be checked that are not so is done where it is not so ("check that the
    windows are shut *and shut any that aren't*")."""
    check, clause = clauses[k - 1], clauses[k]
    is_next = (roles[k - 1], roles[k]) == ("condition", "task") and check.sentence == clause.sentence
    if is_next and clause.picks and check.is_asked and sides[k] in (HOLDS, FAILS):
        sides[k] = FAILS if (clause.picks == "not") != check.wording.is_negated else HOLDS


def _is_echoed_before(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether an echo that affirms a condition stands right before, and what is done in that case before the echo."""
    is_echo = k > 1 and (roles[k - 2], roles[k - 1]) == ("task", "mention") and clauses[k - 1].wording.is_echo
    first = next((j for j in range(k - 2, -1, -1) if roles[j] == "condition"), None)
    return is_echo and first is not None and not clauses[first].wording.is_negated


def _is_affirmed_before(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], k: int) -> bool:
    """Whether right before, behind what is done in its case, an "if" takes up what an earlier task finds out: "look for
    it there and bring it *if you see it*, ..."."""
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), k)
    if roles[k - 1] != "mention" or not first < k - 2 or roles[first] != "condition":
        return False
    before, mention = clauses[first], clauses[k - 1]
    is_plain = not mention.wording.is_negated and not mention.wording.contradicts(before.wording)
    is_behind = mention.boundary in ("none", ",") and mention.sentence == clauses[k - 2].sentence
    is_in_case = set(sides[first + 1 : k - 1]) == {HOLDS} and set(roles[first + 1 : k - 1]) == {"task"}
    is_opened = not {"if", "only_if"}.isdisjoint(mention.near)
    return is_plain and is_behind and is_in_case and is_opened and not before.wording.is_negated


def _falls_back(clause: Clause) -> bool:
    leading = {*clause.far, *clause.near}
    return "fail" in leading and leading.isdisjoint(_OTHERS)
