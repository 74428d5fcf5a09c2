"""Orders: which orders are a condition of others, said again, or asked about before they are carried out."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, flip_of, side_of
from decomplex_bt.understanding.control_flow.clause import AROUND, Clause
from decomplex_bt.understanding.control_flow.contrasts import asks_of, is_opposite_of
from decomplex_bt.understanding.control_flow.failures import is_fallback_behind, is_fallback_for
from decomplex_bt.understanding.control_flow.outcomes import comes_through
from decomplex_bt.understanding.control_flow.repetitions import forbids_same, is_choice_beside, may_repeat, repeats
from decomplex_bt.understanding.cue_phrases import GOVERNING

_TURNING = GOVERNING | frozenset("else fail so or instead then".split())
_DOING = frozenset(("change_state", "placing", "taking", "bringing"))
_LEAVING = frozenset(("leave", "keep"))


def leave_as_is(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """A case in which a thing is left or kept as it is tells nothing of how the order right ahead went ("take the pie
    out. *If it isn't brown*, leave it in", "turn the lamp on. *If nobody's in*, leave it off")."""
    if tuple(roles[k - 1 : k + 2]) != ("condition", "mention", "task") or "mention" in roles[k + 1 :]:
        return
    order, clause, kept = clauses[k - 1 : k + 2]
    is_kept = kept.verb in _LEAVING and kept.is_of_it and not kept.objects and kept.sentence == clause.sentence
    is_state = clause.is_check and bool(clause.said_state) and not clause.wording.is_contrary
    is_outcome = clause.wording.state in order.effects | AROUND or comes_through(clause, order)
    is_case = (clause.is_of_nobody and order.task.type == "change_state") or (is_state and not is_outcome)
    if is_kept and is_case and {*clause.near} <= {"if", "not"} and order.task.type in _DOING and not order.is_forbidden:
        roles[k - 1 : k + 1] = "task", "condition"


def ask_of_other_order(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
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


def ask_ahead_of_other(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an "or if" opens behind an order and its case, with an order of its own, is no part of that case ("hang it
    up if it's wet, *or if it's dry*, fold it")."""
    if k < 2 or k + 1 >= len(clauses) or roles[k] != "or" or (roles[k - 2], roles[k + 1]) != ("task", "task"):
        return
    order, check, clause, other = clauses[k - 2 : k + 2]
    is_behind = check.boundary == "none" and check.near == ("if",) and roles[k - 1] == "condition"
    is_of_verb = (other.verb, other.task.type) == (order.verb, order.task.type)  # "tea if it's cold or *juice* if ..."
    is_set_off = clause.boundary == "," or (clause.boundary == "none" and is_of_verb)
    is_led = is_set_off and clause.near == ("or", "if") and other.boundary == "," and not other.near
    if is_behind and is_led and order.sentence == clause.sentence == other.sentence:
        roles[k] = "mention" if is_opposite_of(clause, check) else "condition"


def repeat(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """An order that is only said again, to say what comes before it, is carried out once; what is of another type than
    all orders before, or names another thing, says none of them again, and what is done in the other case of the last
    one is done then, too ("if it's hot, serve it; if it's cold, warm it *before you serve it*")."""
    if roles[k] == "again" and not any(roles[j] == "task" and may_repeat(clauses[k], clauses[j]) for j in range(k)):
        roles[k] = "task"
    if roles[k] == "task" and any(roles[j] == "task" and _says_again(clauses[k], clauses[j]) for j in range(k)):
        roles[k] = "again"
    if roles[k] == "again" and is_of_other_case(clauses, roles, k):
        roles[k] = "task"


def is_of_other_case(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether clause `k` is behind a "before" in the other case of a condition in whose one case all is ordered that it
    may say again."""
    if "before" not in clauses[k].near:
        return False
    alike = [j for j in range(k) if roles[j] == "task" and _says_again(clauses[k], clauses[j])]
    alike = alike or [j for j in range(k) if roles[j] == "task" and may_repeat(clauses[k], clauses[j])]
    turn = next((j for j in range(k - 1, 0, -1) if roles[j] != "task" or _turns(clauses[j])), 0)
    first = next((j for j in range(turn - 1, -1, -1) if roles[j] != "task"), None)
    if first is None or roles[first] != "condition" or clauses[k].sentence != clauses[turn].sentence or not alike:
        return False
    start = first - (first > 0 and clauses[first].boundary == "none")  # "serve it if it's hot"
    is_of_first = start <= min(alike) and max(alike) < turn
    if roles[turn] == "task":
        return is_of_first  # "if it's hot, serve it. *If not*, ..."
    wordings = [clause.wording for clause in clauses]
    is_denied = wordings[first].is_negated
    is_opposite = flip_of(turn, first, wordings, {side_of(is_denied)}) != is_denied
    return is_of_first and roles[turn] == "mention" and is_opposite


def _turns(clause: Clause) -> bool:
    return "else" in (*clause.far, *clause.near)


def _says_again(clause: Clause, before: Clause) -> bool:
    return repeats(clause, before) or forbids_same(clause, before)


def choose(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Of two orders that an "or" joins the second is for where the first fails."""
    if may_choose(clauses, roles, k) and roles[k - 1] == "task":
        roles[k - 1] = "condition"


def fall_back(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Of several fallbacks in a row each is for where the one before it fails, too, and what "or, failing that" opens
    is for where the order before it does, in a case that denies something ("if there's no bread, bring crackers *or,
    failing that, an apple*"), and so is what an "if you can't" stands behind ("move the chest and *call Tom if you
    can't manage*")."""
    clause, order = clauses[k], clauses[k - 1]
    is_or = {"or", "fail"} <= {*clause.far, *clause.near} and clause.sentence == order.sentence
    is_denied = k > 1 and roles[k - 2] in CONDITION_ROLES and clauses[k - 2].wording.is_negated
    is_for_order = is_or and is_denied and order.task.type != "check_state" and not order.is_forbidden
    is_next = roles[k - 1] == "task" and roles[k] in ("task", "condition")
    is_behind = is_fallback_behind(clause, order) and not any(before.ability for before in clauses[:k])
    if is_next and (is_for_order or is_fallback_for(clause, order) or is_behind):
        roles[k - 1] = "condition"


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


def go_first(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Going to where something is looked for is no condition of the look ("*go to the hall* and look for my keys. If
    you can't find them, ...")."""
    clause, order = clauses[k], clauses[k - 1]
    is_look = roles[k] in CONDITION_ROLES and clause.task.type in ("searching", "check_state")
    is_led = clause.near in ((), ("and",), ("then",), ("and", "then")) and clause.sentence == order.sentence
    if roles[k - 1] == "condition" and order.task.type in ("motion", "following") and is_look and is_led:
        roles[k - 1] = "task"


def may_choose(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether task `k` is ordered instead of the one before it, as it may be; not where a condition stands behind them
    in their sentence ("... or grab the stick if you can't") or chooses between them ("depending on whether ...")."""
    sentence = clauses[k].sentence
    around = [j for j, clause in enumerate(clauses) if clause.sentence == sentence]
    is_chosen = any("depending" in (*clauses[j].far, *clauses[j].near) for j in around)
    is_asked = any(roles[j] in CONDITION_ROLES for j in around if j > k)
    return roles[k] == "task" and is_choice_beside(clauses[k], clauses[k - 1]) and not (is_chosen or is_asked)


def ask_of_order(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an order right ahead hangs on is no mention of another state of another thing ("is the tv on? Then turn it
    off, and close the window if *it's open*"), nor of what was asked of the thing of another order ("shut the window if
    it's open, and open the door if *it's shut*")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if (roles[k - 1], roles[k]) != ("task", "mention") or first is None:
        return
    clause, order, check = clauses[k], clauses[k - 1], clauses[first]
    is_own = first == k - 2 > 0 and clause.boundary == check.boundary == "none" and clause.wording.state is not None
    is_own = is_own and clause.takes_up(order) and check.takes_up(clauses[first - 1])
    is_own = is_own and set(order.objects).isdisjoint(clauses[first - 1].objects) and clause.number == order.number
    if is_own or asks_of(clause, order, check):
        roles[k] = "condition"


def request(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What is politely asked for is no condition where nothing behind tells how it came out ("I'd be obliged if you
    would *find it* and bring it to me")."""
    order, later = clauses[k - 1], range(k, len(clauses))
    is_asked_for = roles[k - 1] == "condition" and order.task.type != "check_state"
    if not is_asked_for or "please" not in order.near or not GOVERNING.isdisjoint({*order.far, *order.near}):
        return
    is_told = any(roles[j] in CONDITION_ROLES for j in later)
    is_turned = any(not _TURNING.isdisjoint({*clauses[j].far, *clauses[j].near}) for j in later)
    if not (is_told or is_turned):
        roles[k - 1] = "task"
