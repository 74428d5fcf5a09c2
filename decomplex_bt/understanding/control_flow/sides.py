"""Sides: in which branch of which condition a task stands, as far as English settles it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, JOINTS, Arc
from decomplex_bt.understanding.control_flow.cases import told_apart, told_in_a_row
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.clauses import last_named
from decomplex_bt.understanding.control_flow.construction import Builder
from decomplex_bt.understanding.control_flow.roles import may_choose, opened_if_not, taken_up
from decomplex_bt.understanding.cues import are_apart

_HOLDS, _FAILS = "<1+", "<1-"
"""In the branch of the condition before: where that holds as it is stated, and where it does not (`arcs`)."""
_OTHERS = frozenset("else so if unless when only_if".split())
_IFS = frozenset(("if", "when"))
_OPENING = frozenset(("if", "only_if", "unless", "when"))
_MOVING = frozenset(("placing", "bringing"))
_FILLED = frozenset("full packed crammed overflowing".split())
_OBSTRUCTED = frozenset(
    "full packed crammed crowded overflowing occupied taken use locked shut closed stuck jammed blocked obstructed "
    "service order".split()
)
"""States, by their last word, of a place that nothing can be put in or brought to: "full", "in use", "out of order"."""
_TURNING = frozenset("else fail so unless either_way only_if even_if but either until whether or not".split())


def stated_sides(clauses: Sequence[Clause], roles: Sequence[str], attachments: Sequence[str]) -> tuple[str, ...]:
    """The attachments of tasks in text order, with the sides of the rules below; as long as `attachments`."""
    sides = list(attachments)
    for k in range(1, len(clauses)):
        for rule in (
            _repeat,
            _answer,
            _name,
            _join,
            _cover,
            _depend,
            _ask_openly,
            _except,
            _forbid,
            _oppose,
            _turn_back,
            _affirm,
            _deny,
            _affirm_ahead,
            _precede,
            _restrict,
            _go_on,
            _obstruct,
            _fall_back,
            _follow,
            _permit,
            _confine,
            _withhold,
            _set_apart,
            _go_ahead,
            _stand_alone,
            _call_off,
            _allow,
            _exclude,
            _turn_away,
            _choose,
        ):
            rule(clauses, roles, sides, k)
    _tell_apart(clauses, roles, sides)
    return tuple(sides)


def _tell_apart(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str]) -> None:
    """A further state of the same thing is never asked for where it has the one before, and of three or more each
    where it has none of those before; what is done in the case follows on it ("if it's lit, empty it; if it's blinking,
    call Tom; if it's out, start it")."""
    for run in told_in_a_row(clauses, roles):
        for k in run[1:]:
            if roles[k] == "condition" and sides[k] == _HOLDS and sides[k - 1][:2] != ">1":
                sides[k] = _FAILS
    for run in told_apart(clauses, roles):
        for k, later in zip(run, [*run[1:], len(clauses)], strict=True):
            sides[k] = _FAILS if k != run[0] else sides[k]
            _follow_case(clauses, roles, sides, range(k, later))


def _follow_case(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], of: range) -> None:
    """What follows on the first of some clauses, a case, in its sentence is done in that case till something turns
    it."""
    for j in of[1:]:
        is_turned = bool(_TURNING & {*clauses[j].far, *clauses[j].near}) or clauses[j].is_forbidden
        is_next = clauses[j].sentence == clauses[of.start].sentence and roles[j] == "task"
        if not is_next or sides[j][:2] != "<1" or is_turned:
            return
        sides[j] = _HOLDS


def _repeat(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is said again is the last order that says the same, never one of another type or another thing."""
    if roles[k] != "again":
        return
    orders = [j for j in range(k - 1, -1, -1) if roles[j] == "task"]
    meant = int(sides[k][1]) - 1 if sides[k] != "top" else 0
    if orders and not clauses[k].may_repeat(clauses[orders[min(meant, len(orders) - 1)]]):
        fitting = (rank for rank, j in enumerate(orders, start=1) if clauses[k].may_repeat(clauses[j]))
        sides[k] = f"<{min(9, next(fitting, 1))}"
    if "before" not in clauses[k].near:
        return
    rank = next((rank for rank, j in enumerate(orders, start=1) if clauses[k].repeats(clauses[j])), None)
    sides[k] = sides[k] if rank is None else f"<{min(9, rank)}"


def _answer(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """How somebody answers is asked where the question is."""
    others = [clauses[j] for j in range(k - 1) if roles[j] in CONDITION_ROLES]
    if roles[k] == "condition" and others and clauses[k].is_answer_to(clauses[k - 1], others):
        sides[k] = sides[k - 1]


def _name(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A mention that names what a condition before was about, as no other one was, is of that condition ("if the stove
    is cold, light the kindling, and if it won't burn, ... If the stove is still warm, ..."), unless it tells that the
    change before it failed ("if the safe is locked, open it. If the safe won't open, ..."); one that names nothing may
    be of one of two conditions that "and" joins (`roles.taken_up`)."""
    clause = clauses[k]
    if roles[k] != "mention" or clause.task.type != "check_state":
        return
    part = taken_up(clauses, roles, k)
    if part is not None and sides[k][:1] == "<":
        sides[k] = "<1" if roles[part + 1] == "task" or part + 1 == k else "<2"
    if not clause.objects:
        return
    if roles[k - 1] == "condition" and clause.is_failure_of(clauses[k - 1], last_named(clauses, k)):
        sides[k] = "<1"
        return
    groups = _groups(roles, sides, k)
    nearest = list(dict.fromkeys(groups[j] for j in range(k - 1, -1, -1) if j in groups))
    named = {groups[j] for j in groups if clause.names_same(clauses[j])}
    states = {clauses[j].wording.state for j in groups if groups[j] in named}
    is_other = any(state and clause.wording.state and are_apart(state, clause.wording.state) for state in states)
    if len(named) == 1 and not is_other:
        sides[k] = f"<{nearest.index(named.pop()) + 1}"


def _groups(roles: Sequence[str], sides: Sequence[str], k: int) -> dict[int, int]:
    """Of every condition and mention before `k` the condition that it is, or is a mention of."""
    builder = Builder([Arc(*labels) for labels in zip(roles[:k], sides[:k], strict=True)], ())
    builder.collect_groups()
    return builder.group_of


def _join(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A check that "and" or "or" joins to the one before it points there by a plain `<1+`, from which the construction
    makes the side on which it is asked."""
    is_joined = bool(clauses[k].wording.joins) or clauses[k].is_other_case_than(clauses[k - 1])
    if roles[k] in JOINTS and is_joined and roles[k - 1] in CONDITION_ROLES:
        sides[k] = _HOLDS
    elif roles[k] in JOINTS and clauses[k].is_added_to_otherwise:
        sides[k] = _FAILS


def _cover(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """All that was ordered before hangs on what "all this only if ..." asks, be it the first that is asked."""
    if clauses[k].covers and roles[k] == "condition" and set(roles[:k]) == {"task"}:
        sides[:k] = [f">1{clauses[k].covers}"] * k


def _depend(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with a thing depends on its being found, where that is then said to fail ("get it from the box and
    hang it up. If it isn't there, ...")."""
    is_finding = k > 1 and (roles[k - 2], roles[k - 1], roles[k]) == ("condition", "task", "mention")
    if is_finding and sides[k - 1] == "top" and clauses[k].boundary != "none" and not clauses[k - 1].wording.orders:
        is_of_it = clauses[k - 2].finds_out(clauses[k]) and clauses[k - 1].has_pronoun
        sides[k - 1] = _HOLDS if is_of_it else sides[k - 1]


def _ask_openly(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What no yes or no answers keeps nothing from what is done, or asked, right behind it."""
    if clauses[k - 1].asks_open and roles[k - 1] == "task" and sides[k][:2] == "<1":
        sides[k] = sides[k - 1] if sides[k - 1] in ("top", _HOLDS, _FAILS) else "top"


def _except(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
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
        turning = {*clauses[j].far, *clauses[j].near, *clauses[j - 1].behind} & _TURNING if j > k else ()
        if turning:
            return
        if sides[j] in (">1-", "<1-") and not clauses[j].is_forbidden:
            sides[j] = f"{sides[j][:2]}+"


def _forbid(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is forbidden in a case is done in the other ("if it isn't full, don't empty it"), what is said instead of it
    in that case ("if it's wet, don't iron it, hang it up"), and what an "otherwise" opens behind it in the other."""
    clause = clauses[k]
    is_task = roles[k] == "task" and roles[k - 1] in CONDITION_ROLES
    if not (is_task and clause.is_forbidden and sides[k] in (_HOLDS, _FAILS)):
        return
    sides[k] = _FAILS
    for j in range(k + 1, len(clauses)):
        later = clauses[j]
        if later.sentence != clause.sentence or roles[j] != "task":
            return
        turning = {*later.far, *later.near} & _TURNING
        if turning == {"else"} and sides[j] == _HOLDS:
            sides[j] = _FAILS
        if later.is_forbidden or turning:
            return
        if sides[j] == _FAILS:
            sides[j] = _HOLDS


def _oppose(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "otherwise" opens right behind a condition is done where that does not hold ("if it's raining, fine,
    otherwise ...", "don't start it if it isn't full, otherwise ..."), and behind a mention that affirms the condition
    of a task on the other side than that task ("bring it if it is, otherwise ...", "look for it and bring it if you see
    it, or else ..."), which is how such a mention is stated (`arcs.flip_of`)."""
    is_restricted = "unless" in clauses[k - 1].near
    is_forbidding = k > 1 and clauses[k - 2].is_forbidden and sides[k - 2] == ">1-" and not is_restricted
    is_plain = roles[k - 1] == "condition" and (is_forbidding or not clauses[k - 1].wording.is_negated)
    if roles[k] == "task" and clauses[k].is_otherwise and is_plain and sides[k] == _HOLDS:
        sides[k] = _FAILS
    if _is_echoed_before(clauses, roles, k) and (clauses[k].is_otherwise or _falls_back(clauses[k])):
        is_of_it = sides[k - 2][:2] == "<1" and sides[k][:2] == "<1"
        sides[k] = _HOLDS if is_of_it else sides[k]
    elif _is_affirmed_before(clauses, roles, sides, k) and {"else", "fail"} & {*clauses[k].far, *clauses[k].near}:
        for j in range(k, len(clauses)):
            if roles[j] != "task" or sides[j] != _FAILS or clauses[j].sentence != clauses[k].sentence:
                break
            sides[j] = _HOLDS


def _turn_back(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "otherwise" opens behind what an "if not" opens is done where the condition holds ("is it dry? If not,
    hang it up, otherwise fold it"), and so is what goes on with it."""
    first = opened_if_not(clauses, roles, k)
    if first is None or roles[k] != "task" or {*sides[first:k]} - {_FAILS}:
        return
    for j in range(k, len(clauses)):
        is_next = j == k or _goes_on(clauses, roles, sides, j, clauses[k].sentence)
        if sides[j] != _FAILS or not is_next:
            return
        sides[j] = _HOLDS


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
    is_in_case = set(sides[first + 1 : k - 1]) == {_HOLDS} and set(roles[first + 1 : k - 1]) == {"task"}
    is_opened = not {"if", "only_if"}.isdisjoint(mention.near)
    return is_plain and is_behind and is_in_case and is_opened and not before.wording.is_negated


def _affirm(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if" or "only if" what was asked before proves true, said behind it at the end of a sentence, is
    done where it does ("..., failing that, ask Tom. Bring it to me if you find it")."""
    clause, task = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] != "condition" or (roles[k - 1], roles[k]) != ("task", "mention"):
        return
    is_plain = not clause.wording.is_negated and not clause.wording.contradicts(clauses[first].wording)
    is_taken_up = clause.wording.is_echo or clause.task.type == "searching"
    is_trailing = is_taken_up and clause.sentence == task.sentence and clause.is_trailing
    is_leading = k > 1 and clauses[k - 2].sentence != task.sentence
    is_of_if = {"if", "only_if"} & set(clause.near) and not {"not", "or", "unless", "but"} & set(clause.near)
    is_other = task.is_forbidden or {"else", "fail", "not", "or"} & {*task.far, *task.near, *task.behind}
    if is_plain and is_trailing and is_leading and is_of_if and not is_other and sides[k - 1] in (_HOLDS, _FAILS):
        sides[k - 1] = _FAILS if clauses[first].wording.is_negated else _HOLDS


def _deny(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "if it isn't", said behind it at the end of a sentence, is done where what was asked before proves
    false ("see whether it's shut, and shut it *if it isn't*")."""
    clause, task = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] != "condition" or (roles[k - 1], roles[k]) != ("task", "mention"):
        return
    is_denied = clause.says_only_whether and clause.wording.is_negated and not clauses[first].wording.is_negated
    is_behind = clause.is_trailing and clause.sentence == task.sentence and clause.near[:1] == ("if",)
    is_turned = task.is_forbidden or {"else", "fail", "not", "or"} & {*task.far, *task.near, *task.behind[:-1]}
    if is_denied and is_behind and not is_turned and sides[k - 1] == _HOLDS and clauses[first].ability == "":
        sides[k - 1] = _FAILS


def _affirm_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
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
        if sides[j] != _HOLDS or not (j == k + 1 or _goes_on(clauses, roles, sides, j, mention.sentence)):
            return
        sides[j] = _FAILS


def _precede(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "before that", in its sentence, is done in the same case ("otherwise switch it on, but before that
    plug it in"), and so is what is done with it then."""
    near = clauses[k].near
    if "before_that" not in near or "either_way" in near or roles[k] != "task" or roles[k - 1] != "task":
        return
    if sides[k - 1] not in (_HOLDS, _FAILS):
        return
    for j in range(k, len(clauses)):
        is_joined = clauses[j].sentence == clauses[k - 1].sentence and roles[j] == "task" and sides[j] == "top"
        if not is_joined or (j > k and set(clauses[j].near) - {"and"}):
            return
        sides[j] = sides[k - 1]


def _restrict(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What restricts what an "otherwise" opens is asked there as well ("otherwise hang it up, unless it's dry")."""
    if roles[k] != "condition" or roles[k - 1] != "task" or sides[k] not in (_HOLDS, "top"):
        return
    first = k
    while first and roles[first - 1] == "task" and sides[first - 1][:2] == ">1":
        first -= 1
    is_own = first < k and clauses[first].sentence == clauses[k].sentence
    leading = {*clauses[first].far, *clauses[first].near}
    if is_own and leading & {"else", "fail"} and not CONDITION_ROLES.isdisjoint(roles[:first]):
        sides[k] = _FAILS


def _go_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What has nothing to do with the condition before is never asked in the case that was not spoken of last: "if the
    stove is on, turn it off and, if nobody is in, open the window", "If Tom is in, tell him. If it's raining, ..."."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[k] != "condition" or sides[k] not in (_HOLDS, _FAILS):
        return
    leading = {*clause.far, *clause.near}
    is_added = {"and", "if"} <= leading and clause.sentence == clauses[k - 1].sentence
    is_opened = clause.is_of_weather and not leading.isdisjoint(_IFS)
    if not (is_added or is_opened) or leading & _TURNING - {"not", "whether"}:
        return
    if not clause.is_of_other_matter(clauses[first]):
        return
    if first == k - 1:
        sides[k] = _HOLDS
    elif sides[k - 1] in (_HOLDS, _FAILS) and sides[k - 1] != sides[k]:
        sides[k] = "top"


def _obstruct(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is put elsewhere where its place is full or shut is not put there ("put it in the box. If the box is full,
    put it on the shelf"), and that is asked where it would have been put."""
    if k + 1 >= len(clauses) or roles[k] != "condition" or roles[k - 1] != roles[k + 1] or roles[k - 1] != "task":
        return
    before, clause, after = clauses[k - 1 : k + 2]
    are_moves = before.task.type in _MOVING and after.task.type in _MOVING
    is_place = not (before.nouns - set(before.objects)).isdisjoint(clause.objects)
    is_shut = clause.wording.state in _OBSTRUCTED and not clause.wording.is_negated
    is_same = after.has_pronoun and not after.objects and not {"first", "before"} & set(after.wording.orders)
    is_carried = after.task.type == "bringing" and clause.wording.state in _FILLED  # "if the bin is full, take it out"
    is_leading = after.sentence == clause.sentence and clause.boundary != "none"
    if (
        are_moves
        and not is_carried
        and is_place
        and is_shut
        and is_same
        and is_leading
        and sides[k - 1] in ("top", _HOLDS, _FAILS)
    ):
        sides[k - 1], sides[k] = ">1-", sides[k - 1]


def _confine(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A condition behind one of several orders is of that one alone where it stands within a list ("pick up the mug,
    wash it if it's dirty, and put it away"), or asks whether that order is needed ("turn the tv off if it's on and come
    here")."""
    clause, order = clauses[k], clauses[k - 1]
    is_guard = clause.is_guard_of(order) and (roles[k - 1], roles[k]) == ("task", "condition")
    is_behind = clause.boundary == "none" or (clause.boundary == "," and is_guard and "unless" in clause.near)
    if not is_behind or _OPENING.isdisjoint(clause.near) or "mention" in roles[k + 1 :]:
        return
    if is_guard and sides[k - 1] in (_HOLDS, _FAILS):
        sides[k - 1], sides[k] = ">1+", sides[k - 1]
    if (roles[k - 1], roles[k]) != ("task", "condition") or sides[k - 1][:2] != ">1":
        return
    ahead = [j for j in range(k - 1) if clauses[j].sentence == clause.sentence and roles[j] == "task"]
    is_listed = bool(ahead) and ahead[-1] == k - 2 and order.boundary == ","
    later = list(takewhile(lambda j: _goes_on(clauses, roles, sides, j, clause.sentence), range(k + 1, len(clauses))))
    if not later or not (is_guard or (is_listed and clauses[k + 1].boundary == ",")):
        return
    if is_listed:
        for j in ahead:
            sides[j] = "top" if sides[j][:2] == ">1" else sides[j]
    for j in later:
        sides[j] = f"<2{sides[k][2:]}" if sides[k] in (_HOLDS, _FAILS) else "top"


def _withhold(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A condition behind the last of several orders is of that one alone where it takes back what one before it brings
    about ("light the candles and blow them out if they drip"), and where what is asked comes through one ("fill the tub
    and call me when it's full") or is about the thing of the last one ("shut the door and fill the jug if it's
    empty")."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = clause.boundary == "none" and (roles[k - 1], roles[k]) == ("task", "condition")
    if not is_behind or _OPENING.isdisjoint(clause.near) or sides[k - 1][:2] != ">1" or "or" in order.near:
        return
    ahead = list(takewhile(lambda j: _hangs_ahead(clauses, roles, sides, j, clause.sentence), range(k - 2, -1, -1)))
    if any(order.undoes(clauses[j]) or clause.comes_through(clauses[j]) for j in ahead) or (
        ahead and clause.is_only_of(order, clauses[ahead[0]])
    ):
        for j in ahead:
            sides[j] = sides[k] if sides[k] in (_HOLDS, _FAILS) else "top"


def _set_apart(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is ordered before "but don't ... if ..." of another thing hangs on nothing ("light the fire, but don't wake
    Tom if he's asleep")."""
    clause = clauses[k]
    is_other = clause.is_forbidden and "but" in (*clause.far, *clause.near) and roles[k] == "task"
    if not is_other or sides[k][:2] != ">1":
        return
    for j in range(k - 1, -1, -1):
        if not _hangs_ahead(clauses, roles, sides, j, clause.sentence) or clauses[j].is_forbidden:
            return
        sides[j] = "top"


def _go_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is to be done before something is asked is done whatever the answer ("if the floor is still wet after you
    have mopped it, ...")."""
    clause, before = clauses[k], clauses[k - 1]
    if not (clause.is_had_done and roles[k] == "task" and sides[k] in (_HOLDS, _FAILS) and clause.boundary == "none"):
        return
    if roles[k - 1] == "condition" and not _OPENING.isdisjoint(before.near) and before.sentence == clause.sentence:
        sides[k] = f"<2{sides[k - 1][2:]}" if sides[k - 1] in (_HOLDS, _FAILS) else "top"
    elif roles[k - 1] == "task" and before.is_had_done and clause.near == ("and",):
        sides[k] = sides[k - 1]


def _stand_alone(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "and" adds behind "..., unless ..." is not done where that alone keeps from the order before it: it goes
    with that where it needs it ("go in, unless he's asleep, and make the bed", "iron it unless it's wet and hang it
    up"), else it stands alone ("bring him tea, unless he's asleep, and shut the door")."""
    if k < 2 or (roles[k - 2], roles[k - 1]) != ("task", "condition") or "unless" not in clauses[k - 1].near:
        return
    order, check = clauses[k - 2 : k]
    if order.is_forbidden or sides[k - 2] != ">1+" or sides[k - 1] != "top" or order.sentence != check.sentence:
        return
    for j in range(k, len(clauses)):
        clause = clauses[j]
        words = {*clause.far, *clause.near, *clauses[j - 1].behind}
        is_added = roles[j] == "task" and sides[j] == _FAILS and clause.sentence == check.sentence and "and" in words
        if not is_added or words & (_TURNING - {"not"} | {"then"}):
            return
        is_of_it = order.task.type == "motion" or (clause.has_pronoun and not check.is_guard_of(order))
        sides[j] = _HOLDS if is_of_it and clause.task.type != "motion" else "top"


def _call_off(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is called off in a case is done in the other ("mow the lawn, but if it's wet, leave it"), and so are the
    orders that are joined to it."""
    if roles[k] != "condition" or roles[k - 1] != "task" or not clauses[k].is_case_against(clauses[k - 1]):
        return
    if sides[k - 1] not in ("top", ">1+", ">1-") or sides[k] not in ("top", _HOLDS):
        return
    if k > 1 and roles[k - 2] in CONDITION_ROLES and clauses[k - 2].sentence == clauses[k - 1].sentence:
        return  # what hangs on another condition already
    for j in range(k - 1, -1, -1):
        is_joined = j == k - 1 or (clauses[j].sentence == clauses[k - 1].sentence and sides[j] == ">1+")
        if roles[j] != "task" or not is_joined:
            break
        sides[j] = ">1-"
    sides[k] = "top"


def _allow(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is forbidden but allowed in a case is done in that ("don't open it, but if it's hot, do")."""
    if (roles[k - 1], roles[k]) != ("task", "condition") or not clauses[k].allows or not clauses[k - 1].is_forbidden:
        return
    if sides[k - 1] in ("top", ">1+", ">1-") and sides[k] in ("top", _HOLDS):
        sides[k - 1], sides[k] = ">1+", "top"


def _turn_away(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence with a "now" or the like opens hangs on no condition before ("if Ann asks, I'm out. *Now bring me
    the tea*"), nor is it asked in one ("*separately*, if it's dry, ...")."""
    if not clauses[k].is_new_matter or sides[k] not in (_HOLDS, _FAILS):
        return
    if roles[k] == "condition":
        sides[k] = "top"
    side = sides[k]
    for j in range(k, len(clauses)):
        if clauses[j].sentence != clauses[k].sentence or roles[j] != "task" or sides[j] != side:
            return
        sides[j] = "top"


def _exclude(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Whether somebody is elsewhere is asked where they are not where they were looked for ("if Ann is in the office,
    give it to her, but if she's at lunch, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or (roles[first], roles[k]) != ("condition", "condition"):
        return
    if not {"but", "if"} <= {*clause.far, *clause.near} or not clause.is_elsewhere_than(clauses[first]):
        return
    if sides[k] in (_HOLDS, "top") and all(sides[j] in (_HOLDS, ">1+", ">1-") for j in range(first + 1, k)):
        sides[first + 1 : k] = [_HOLDS] * (k - first - 1)
        sides[k] = _FAILS


def _choose(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What may be done instead of the order before it is done where that fails; what goes on behind it hangs on what
    it hung on."""
    if roles[k - 1] != "condition" or not may_choose(clauses, roles, k):
        return
    sides[k] = _FAILS
    for j in takewhile(lambda j: roles[j] == "task", range(k + 1, len(clauses))):
        if sides[j][0] == "<":
            sides[j] = f"<{min(9, int(sides[j][1]) + 1)}{sides[j][2:]}"


def _hangs_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], k: int, sentence: int) -> bool:
    """Whether an order of this sentence hangs on the condition behind it."""
    return roles[k] == "task" and sides[k][:2] == ">1" and clauses[k].sentence == sentence


def _goes_on(clauses: Sequence[Clause], roles: Sequence[str], sides: Sequence[str], k: int, sentence: int) -> bool:
    """Whether a task goes on with what hangs on the condition before it, in this sentence."""
    is_plain = roles[k] == "task" and sides[k] in (_HOLDS, _FAILS)
    return is_plain and clauses[k].sentence == sentence and _TURNING.isdisjoint({*clauses[k].far, *clauses[k].near})


def _permit(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
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
    are_forbidden = all(roles[j] == "task" and clauses[j].is_forbidden and sides[j] in (">1-", _FAILS) for j in done)
    is_opposite = again.wording.is_negated != again.wording.contradicts(check.wording)
    if not (is_plain and done and are_forbidden and is_opposite) or "unless" in again.near:
        return
    for j in range(k, len(clauses)):
        between = {*clauses[j].far, *clauses[j].near, *clauses[j - 1].behind}
        is_turned = bool(between & (_TURNING - {"not"})) or clauses[j].is_forbidden
        if sides[j] != _HOLDS or roles[j] != "task" or clauses[j].sentence != again.sentence or is_turned:
            return
        sides[j] = _FAILS


def _fall_back(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "failing that" opens is never done where something held, and a second one is for where the first fails as
    well ("failing that, try the porch; failing that, ask Tom")."""
    is_echoed = _is_echoed_before(clauses, roles, k)
    if roles[k] == "task" and sides[k] == _HOLDS and _falls_back(clauses[k]) and not is_echoed:
        sides[k] = _FAILS
    if roles[k - 1] == "condition" and roles[k] in ("task", "condition") and clauses[k].is_fallback_for(clauses[k - 1]):
        sides[k] = _FAILS


def _falls_back(clause: Clause) -> bool:
    leading = {*clause.far, *clause.near}
    return "fail" in leading and leading.isdisjoint(_OTHERS)


def _follow(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What follows an "if it does not ..." in its sentence is done where it does not, unless an "otherwise" or the like
    stands between.

    In "if it does not work" the cue says so, not the clause's own negation; it is the other side only right behind what
    it mentions, before one side of that has tasks (`arcs.flip_of`).
    """
    clause, before = clauses[k], clauses[k - 1]
    is_denied = before.wording.is_negated and not _IFS.isdisjoint(before.near)
    is_mention = roles[k - 1] == "mention" and roles[max(0, k - 2)] == "condition"
    is_contrary = before.wording.is_contrary or before.wording.is_negated
    is_failure = is_mention and "fail" in before.near and not is_contrary
    between = {*clause.far, *clause.near, *before.behind}
    if roles[k - 1] not in CONDITION_ROLES or not (is_failure or is_denied) or between & _TURNING:
        return
    wrong, right = (_HOLDS, _FAILS) if is_failure else (_FAILS, _HOLDS)
    for j in range(k, len(clauses)):
        if sides[j] != wrong or clauses[j].sentence != before.sentence:
            return
        sides[j] = right
