"""Scopes: how far a condition reaches among the orders around it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, is_flipped
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.contrasts import (
    asks_of,
    is_apart_from,
    is_elsewhere_than,
    is_of_other_matter,
    is_rival_of,
)
from decomplex_bt.understanding.control_flow.failures import lacks_too
from decomplex_bt.understanding.control_flow.outcomes import (
    OBSTRUCTED,
    asks_needless,
    comes_through,
    is_cleared,
    is_guard_of,
    is_only_of,
    undoes,
)
from decomplex_bt.understanding.control_flow.sides.labels import (
    FAILS,
    HOLDS,
    MOVING,
    OPENING,
    TURNING,
    beside,
    goes_on,
    hangs_ahead,
)

_IFS = frozenset(("if", "when"))
_ENDING = frozenset((".", "?", "!"))
_ALL = frozenset(("everything", "anything", "all"))
_PARTING = frozenset((".", ";"))
_SOME = frozenset("one ones some two three half few couple rest other others".split())
_LEAVING = frozenset(("leave", "keep"))
_CARRYING = frozenset(("placing", "bringing", "taking"))
_FILLED = frozenset("full packed crammed overflowing".split())
_TELLING = frozenset(("informing", "check_state"))
_ANSWERING = frozenset("know remember recall answer reply say agree refuse".split())
_REMOVING = frozenset("leave pour throw tip chuck bin".split())


def stand_apart(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Whether nobody is in a place is not asked of the order before, which has nothing to do with it ("water the
    ferns. If nobody is in the study, ...")."""
    is_behind = (roles[k - 1], roles[k]) == ("task", "condition") and clauses[k].boundary in _PARTING
    is_instead = k + 1 < len(clauses) and "instead" in (*clauses[k + 1].near, *clauses[k + 1].behind)
    if is_behind and sides[k - 1][:2] == ">1" and is_apart_from(clauses[k], clauses[k - 1]) and not is_instead:
        sides[k - 1] = "top"


def precede(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "before that", in its sentence, is done in the same case ("otherwise switch it on, but before that
    plug it in"), and so is what is done with it then."""
    near = clauses[k].near or clauses[k].far  # "but before that, ..."
    if "before_that" not in near or "either_way" in near or roles[k] != "task" or roles[k - 1] != "task":
        return
    if sides[k - 1] not in (HOLDS, FAILS):
        return
    for j in range(k, len(clauses)):
        is_joined = clauses[j].sentence == clauses[k - 1].sentence and roles[j] == "task" and sides[j] == "top"
        if not is_joined or (j > k and set(clauses[j].near) - {"and"}):
            return
        sides[j] = sides[k - 1]


def restrict(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What restricts what an "otherwise" opens is asked there as well ("otherwise hang it up, unless it's dry")."""
    if roles[k] != "condition" or roles[k - 1] != "task" or sides[k] not in (HOLDS, "top"):
        return
    first = k
    while first and roles[first - 1] == "task" and sides[first - 1][:2] == ">1":
        first -= 1
    is_own = first < k and clauses[first].sentence == clauses[k].sentence
    leading = {*clauses[first].far, *clauses[first].near}
    if is_own and leading & {"else", "fail"} and not CONDITION_ROLES.isdisjoint(roles[:first]):
        sides[k] = FAILS


def go_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What has nothing to do with the condition before is never asked in the case that was not spoken of last: "if the
    stove is on, turn it off and, if nobody is in, open the window", "If Tom is in, tell him. If it's raining, ..."."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[k] != "condition" or sides[k] not in (HOLDS, FAILS):
        return
    leading = {*clause.far, *clause.near}
    is_added = {"and", "if"} <= leading and clause.sentence == clauses[k - 1].sentence
    is_opened = clause.is_of_weather and not leading.isdisjoint(_IFS)
    if not (is_added or is_opened) or leading & TURNING - {"not", "whether"}:
        return
    if not is_of_other_matter(clause, clauses[first]):
        return
    if first == k - 1:
        sides[k] = HOLDS
    elif sides[k - 1] in (HOLDS, FAILS) and sides[k - 1] != sides[k]:
        sides[k] = "top"


def wait_for(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done when something is so that is only waited for is done where that is ("turn it on if it's off, then
    run a bath, and *when it's ready* tell me")."""
    awaited, clause = clauses[k - 1], clauses[k]
    is_awaited = (roles[k - 1], roles[k]) == ("task", "task") and awaited.is_check and "when" in awaited.near
    is_next = clause.sentence == awaited.sentence and not clause.near and not clause.far
    if is_awaited and is_next and sides[k - 1] == "top" and sides[k] in (HOLDS, FAILS):
        sides[k] = "top"


def obstruct(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is put elsewhere where its place is full or shut is not put there ("put it in the box. If the box is full,
    put it on the shelf"), and that is asked where it would have been put."""
    if k + 1 >= len(clauses) or roles[k] != "condition" or roles[k - 1] != roles[k + 1] or roles[k - 1] != "task":
        return
    before, clause, after = clauses[k - 1 : k + 2]
    are_moves = before.task.type in MOVING and after.task.type in MOVING
    is_place = not (before.nouns - set(before.objects)).isdisjoint(clause.objects)
    is_one = before.number == "many" != clause.number and clause.has_pronoun and not clause.objects
    is_place = is_place or (is_one and before.task.type == "placing")  # "put the cans in the bin, and if that's full"
    is_shut = clause.wording.state in OBSTRUCTED and not clause.wording.is_negated
    is_same = after.has_pronoun and not after.objects and not {"first", "before"} & set(after.wording.orders)
    # "if the bin is full, take it out", not "take them out", of which one is not full
    is_carried = after.task.type == "bringing" and clause.wording.state in _FILLED and after.number != "many"
    is_leading = after.sentence == clause.sentence and clause.boundary != "none"
    if (
        are_moves
        and not is_carried
        and is_place
        and is_shut
        and is_same
        and is_leading
        and sides[k - 1] in ("top", HOLDS, FAILS)
    ):
        sides[k - 1], sides[k] = ">1-", sides[k - 1]


def replace_there(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done *instead*, in a case that is asked of the place or the person of the order ahead, stands in place of
    that order alone, and is asked where that would be done ("pick it up and put it in the box. If the box is full, put
    it on the bench *instead*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_instead = "instead" in (*other.near, *other.behind) and other.sentence == check.sentence
    is_led = check.boundary in _PARTING and "if" in check.near and not {*other.far, *other.near} & TURNING
    is_place = not (order.nouns - set(order.objects)).isdisjoint(check.objects)
    is_receiver = check.is_of_person and any(kind in ("recipient", "goal") for kind, _ in order.task.arguments)
    is_moved = order.task.type in MOVING and sides[k + 1] == HOLDS
    is_moved = is_moved and (other.verb not in _LEAVING or bool(other.receivers))
    if not (is_instead and is_led and is_moved and (is_place or is_receiver)) or order.is_forbidden:
        return
    if sides[k - 1] == ">1-" and order.has_pronoun and not order.objects and other.task.type in MOVING:
        for j in range(k - 2, -1, -1):
            if roles[j] != "task" or sides[j] != ">1-" or clauses[j].sentence != order.sentence:
                return
            sides[j] = sides[k] if sides[k] in (HOLDS, FAILS) else "top"
    elif sides[k - 1] in ("top", HOLDS, FAILS):
        sides[k - 1], sides[k] = ">1-", sides[k - 1]


def leave_be(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is left somewhere in a case is not moved in it ("bring the washing in. If it's damp, *leave it on the
    line*"); where only some of it is left, the rest is ("bring the milk in. If there are two, *leave one outside*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    before, clause, after = clauses[k - 1 : k + 2]
    is_left = before.task.type in MOVING and after.task.type == "placing" and after.verb in _LEAVING
    is_next = after.sentence == clause.sentence and after.boundary == "," and "if" in clause.near
    is_led = clause.boundary in _PARTING and not {*clause.near, *after.near} & TURNING
    if not (is_left and is_next and is_led and before.verb not in _LEAVING and sides[k - 1] in ("top", ">1-")):
        return
    is_turned = any("else" in (*later.far, *later.near) for later in clauses[k + 2 :])
    is_known = not (clause.is_of_some or is_turned) and (
        not clause.objects or not before.nouns.isdisjoint(clause.objects)
    )
    if after.is_of_it and is_known and sides[k - 1] == "top" and sides[k] == "top":
        sides[k - 1] = ">1-"
    elif not _SOME.isdisjoint(after.thing) and sides[k - 1] == ">1-":
        sides[k - 1] = "top"


def confine(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A condition behind one of several orders is of that one alone where it stands within a list ("pick up the mug,
    wash it if it's dirty, and put it away"), or asks whether that order is needed ("turn the tv off if it's on and come
    here")."""
    clause, order = clauses[k], clauses[k - 1]
    is_guard = is_guard_of(clause, order) and (roles[k - 1], roles[k]) == ("task", "condition")
    is_behind = clause.boundary == "none" or (clause.boundary == "," and is_guard and "unless" in clause.near)
    if not is_behind or OPENING.isdisjoint(clause.near) or "mention" in roles[k + 1 :]:
        return
    if is_guard and sides[k - 1] in (HOLDS, FAILS):
        sides[k - 1], sides[k] = ">1+", sides[k - 1]
    if (roles[k - 1], roles[k]) != ("task", "condition") or sides[k - 1][:2] != ">1":
        return
    ahead = [j for j in range(k - 1) if clauses[j].sentence == clause.sentence and roles[j] == "task"]
    is_listed = bool(ahead) and ahead[-1] == k - 2 and order.boundary == ","
    later = list(takewhile(lambda j: goes_on(clauses, roles, sides, j, clause.sentence), range(k + 1, len(clauses))))
    if not later or not (is_guard or (is_listed and clauses[k + 1].boundary == ",")):
        return
    if is_listed:
        for j in ahead:
            sides[j] = "top" if sides[j][:2] == ">1" else sides[j]
    for j in later:
        sides[j] = beside(sides[k])


def ask_first(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Who does not know or cannot help has been asked ("ask Tom where it is, and *if he doesn't know*, ...")."""
    clause, order = clauses[k], clauses[k - 1]
    if k < 2 or (roles[k - 1], roles[k]) != ("task", "condition") or roles[k - 2] not in CONDITION_ROLES:
        return
    is_asked = order.task.type == "informing" and bool(order.receivers) and sides[k - 1][:2] == ">1"
    is_unable = clause.verb == "be" and clause.wording.state is None and clause.wording.is_negated and not clause.places
    if is_asked and clause.near[:2] == ("and", "if") and (clause.verb in _ANSWERING or is_unable):
        sides[k - 1] = HOLDS


def ask_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is so already is not brought about ("open the window. *If it's open already*, turn the fan on")."""
    is_next = (roles[k - 1], roles[k]) == ("task", "condition") and sides[k - 1] in ("top", HOLDS, FAILS)
    is_beside = is_next and sides[k] in (sides[k - 1], "<1")
    if is_beside and k + 1 < len(clauses) and sides[k + 1] == HOLDS and asks_needless(clauses[k], clauses[k - 1]):
        sides[k - 1], sides[k] = ">1-", sides[k - 1]


def do_without(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What there is none of is not fetched ("bring me a pear. If *there is no pear*, bring me a plum. If *there is no
    plum either*, ...")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k]) != ("task", "condition") or roles[k + 1] in ("mention", "and"):
        return
    order, clause = clauses[k - 1 : k + 1]
    is_lacking = clause.says_there_is and clause.wording.is_negated and clause.names_same(order) and not clause.places
    is_next = "if" in clause.near and "unless" not in clause.near and clause.boundary != "none"
    is_fetched = is_next and order.task.type in _CARRYING
    if is_lacking and is_fetched and sides[k - 1] == sides[k] == "top":
        sides[k - 1] = ">1-"
    if is_fetched and lacks_too(clause, order) and sides[k - 1] in (HOLDS, FAILS):
        sides[k - 1], sides[k] = ">1-", sides[k - 1]


def clear_way(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An order is carried out though something is in its way that is then undone ("take the bin out. If the gate is
    locked, *unlock it*")."""
    if is_cleared(clauses, roles, k) and (sides[k - 1], sides[k]) == (">1-", "top"):
        sides[k - 1] = "top"


def check_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is checked first not to be so is for the order ahead, which is not done where it is so and the thing is put
    elsewhere or left ("warm the milk, but first check that it isn't sour, and if it is, pour it away")."""
    if k + 2 >= len(clauses) or tuple(roles[k - 1 : k + 3]) != ("task", "condition", "mention", "task"):
        return
    check, echo, order = clauses[k : k + 3]
    is_first = check.is_asked and check.wording.is_negated and bool({"before", "first"} & set(check.wording.orders))
    is_so = echo.wording.is_echo and not echo.wording.is_negated and "if" in echo.near
    is_removed = (order.task.type == "placing" or order.verb in _REMOVING) and order.has_pronoun and not order.objects
    if is_first and is_so and is_removed and sides[k - 1] == "top" and sides[k + 2] == HOLDS:
        sides[k - 1] = ">1+"


def ask_anew(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A question of its own about another thing, behind what was done in a case, is asked in any case ("Window open?
    Close it. *Baby awake?* Feed her")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[k - 1], roles[k]) != ("task", "condition") or sides[k][:2] != "<1":
        return
    is_plain = clause.is_question and not (clause.far or clause.near) and clause.boundary in _ENDING
    known = {word for before in clauses[first:k] for word in (*before.nouns, *before.thing)}
    is_of_other = bool(clause.thing) and not clause.has_pronoun and known.isdisjoint(clause.thing)
    if is_plain and is_of_other and clauses[first].is_question:
        sides[k] = "top"


def come_first(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is to be done "first", "whatever you do" or "either way", hangs on none of the cases told just before
    ("bring the tray if it's ready or if Gran is awake, but *whatever you do, fill her bottle first*")."""
    clause = clauses[k]
    if roles[k] != "task" or not clause.is_first_anyway or sides[k] == "top":
        return
    told = [j for j in range(k) if roles[j] in ("condition", "mention") and clauses[j].sentence == clause.sentence]
    if told and all(sides[j] == "top" or roles[j] == "mention" for j in told):
        sides[k] = "top"


def list_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is listed on behind an "instead" is done in any case ("fetch the pan, if it's dirty take the pot instead,
    *lay the table, light the candles*")."""
    clause = clauses[k]
    is_behind = "instead" in clauses[k - 1].behind and clause.sentence == clauses[k - 1].sentence
    is_listed = clause.boundary == "," and clause.near in ((), ("then",)) and roles[k - 1] == "task"
    if not (is_behind and is_listed) or clause.has_pronoun or not clause.objects:
        return
    for j in range(k, len(clauses)):
        if sides[j] not in (HOLDS, FAILS) or clauses[j].sentence != clause.sentence:
            return
        if j > k and not goes_on(clauses, roles, sides, j, clause.sentence) and roles[j] != "condition":
            return
        sides[j] = "top"
        if roles[j] == "condition":
            return


def make_up(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done ", then" behind the one thing that makes up for what is not so is done in any case ("if there isn't
    a clean cup, wash one, *then fill it*")."""
    clause, before = clauses[k], clauses[k - 1]
    if k < 2 or roles[k - 2] not in CONDITION_ROLES or (roles[k - 1], roles[k]) != ("task", "task"):
        return
    is_next = (clause.boundary, clause.near) == (",", ("then",)) and clause.sentence == before.sentence
    is_of_lack = clauses[k - 2].wording.is_negated and clauses[k - 2].sentence == clause.sentence
    is_step = "first" in (*before.far, *before.near, *before.behind)
    if not (is_next and is_of_lack) or is_step or sides[k] != sides[k - 1] or sides[k] not in (HOLDS, FAILS):
        return
    for j in range(k, len(clauses)):
        if j > k and not (sides[j] == sides[k - 1] and goes_on(clauses, roles, sides, j, clause.sentence)):
            return
        sides[j] = "top"


def move_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "then" leads on to, with another thing, behind the one order that undoes what was found to be so is done
    in any case ("if the iron is still on, turn it off, *and then bring me the basket*"), but not a report of it."""
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
    if not (is_undone and is_of_it and is_new and is_plain) or clause.task.type in _TELLING:
        return
    if last.sentence != clause.sentence or sides[k - 1] not in (HOLDS, FAILS):
        return
    for j in range(k, len(clauses)):
        if sides[j] != sides[k - 1] or not (j == k or goes_on(clauses, roles, sides, j, clause.sentence)):
            return
        sides[j] = "top"


def replace_last(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done *instead* in a case that is asked in a sentence of its own stands in place of the last order of its
    kind, with the same thing, not of those ahead about others ("before you sweep, put the toys in the box. If it's
    full, put them on the shelf *instead*")."""
    if k < 2 or k + 1 == len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, other = clauses[k - 1], clauses[k + 1]
    is_instead = "instead" in (*other.near, *other.behind) and other.has_pronoun and sides[k + 1] == HOLDS
    is_alike = order.task.type == other.task.type and order.task.type in _CARRYING and bool(order.objects)
    if not is_instead or not is_alike or sides[k - 1] != ">1-" or clauses[k].sentence == order.sentence:
        return
    for j in range(k - 2, -1, -1):
        clause = clauses[j]
        if roles[j] != "task" or sides[j] != ">1-" or clause.has_pronoun:
            return
        if not frozenset(order.objects).isdisjoint(clause.nouns) or clause.sentence != order.sentence:
            return
        sides[j] = "top"


def resume(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What goes on behind an order and a case that commas set off is done in any case: behind an "unless" with a "then"
    and another matter ("shut the door, unless Mum's in there, *and then feed the dog*", not "..., then leave it open"),
    behind whether the order is needed with an "and" ("close it, if it's open, *and bring me a towel*")."""
    if k != 2 or (roles[0], roles[1], roles[2]) != ("task", "condition", "task") or sides[0][:2] != ">1":
        return
    order, check, clause = clauses[:3]
    is_set_off = check.boundary == clause.boundary == "," and order.sentence == check.sentence == clause.sentence
    is_instead = clause.task.type == order.task.type and order.task.type in _CARRYING
    is_other = not (is_instead or clause.has_pronoun or order.is_forbidden) and order.nouns.isdisjoint(clause.nouns)
    is_on = check.near == ("unless",) and clause.near in (("then",), ("and", "then")) and is_other
    is_done = is_guard_of(check, order) or (check.says_already and not check.has_pronoun and not check.objects)
    is_needless = check.near == ("if",) and clause.near == ("and",) and is_done
    if not is_set_off or not (is_on or is_needless) or TURNING & set(clause.far) - {"not"}:
        return
    for j in range(k, len(clauses)):
        if roles[j] != "task" or clauses[j].sentence != clause.sentence or sides[j][:2] != "<1":
            return
        sides[j] = "top"


def report_on(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an order to check found is told whatever that is, where "and tell me" says no more and nothing goes by the
    answer ("see if it's raining *and tell me*")."""
    check, clause = clauses[k - 1], clauses[k]
    if (roles[k - 1], roles[k]) != ("condition", "task") or sides[k] != HOLDS or k + 1 < len(clauses):
        return
    is_asked = check.is_asked and not check.is_question and check.near[:1] != ("if",)
    is_report = clause.task.type == "informing" and all(kind == "recipient" for kind, _ in clause.task.arguments)
    is_joined = clause.near[-1:] == ("and",) and {"whether", "and"}.issuperset(clause.near)
    if is_asked and is_report and is_joined and clause.boundary == "none":
        sides[k] = beside(sides[k - 1])


def gather(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "then" does, behind both cases, with that into which something was put in either is done in any case ("if
    there's milk, pour it into the jug, if not, put water in it, *and then bring the jug*")."""
    clause, order = clauses[k], clauses[k - 1]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or "then" not in clause.near or (roles[k], sides[k], sides[k - 1]) != ("task", FAILS, FAILS):
        return
    filled = [clauses[j].receivers - set(clauses[j].objects) for j in range(first + 1, k) if sides[j] == HOLDS]
    is_filled = bool(clause.objects) and any(goals.issuperset(clause.objects) for goals in filled)
    is_in_both = order.has_pronoun or not order.receivers.isdisjoint(clause.objects)
    is_turned = {"else", "fail"} & {*order.far, *order.near}
    if is_filled and is_in_both and is_turned and sides[first] == "top" and roles[first] == "condition":
        sides[k] = "top"


def guard(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An order hangs on what is asked right behind it after its own thing, and behind a "then" that is asked whatever
    came of another condition ("is the tv on? Turn it off, *then* close the window if *it's open*")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[k - 1], roles[k]) != ("task", "condition") or sides[k - 1][:2] != "<1":
        return
    if asks_of(clauses[k], clauses[k - 1], clauses[first]):
        is_next = "then" in clauses[k - 1].near and clauses[k - 1].sentence == clauses[first].sentence
        sides[k - 1], sides[k] = ">1+", "top" if is_next else sides[k - 1]


def guard_other(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "or if" opens behind an order and its case is asked where that is not so, with its own order ("hang it up
    if it's wet, *or if it's torn, mend it*")."""
    if k < 2 or k + 1 >= len(clauses) or clauses[k].near != ("or", "if") or clauses[k - 1].boundary != "none":
        return
    if tuple(roles[k - 2 : k]) == ("task", "condition") and sides[k - 2][:2] == ">1" and roles[k] != "or":
        sides[k] = FAILS if roles[k] == "condition" else "<1"
        sides[k + 1] = HOLDS if roles[k + 1] == "task" else sides[k + 1]


def guard_each(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Of orders in a row, each with a condition of its own thing right behind it, each hangs on its own ("switch the
    stove off if it's on, *close the door if it's open*, and come here"), be it the other side of the one before ("bring
    the cup if it's clean and *wash it if it's dirty*")."""
    if k < 3 or tuple(roles[k - 3 : k]) != ("task", "condition", "task"):
        return
    last, order, clause = clauses[k - 2 : k + 1]
    is_row = sides[k - 3][:2] == ">1" and last.boundary == "none" and last.sentence == order.sentence
    is_alternative = order.near == ("or",) and roles[k] == "condition"  # "..., or light the stove if it's raining"
    if is_row and is_alternative and clause.near == ("if",) and clause.boundary == "none":
        sides[k - 1], sides[k] = ">1+", FAILS
        return
    is_behind = clause.boundary == "none" and clause.near in (("if",), ("unless",)) and TURNING.isdisjoint(order.near)
    if not (is_row and is_behind and clause.is_check):
        return
    is_last = k + 1 == len(clauses) or clauses[k + 1].boundary != "none"  # not "... if it's hot just bring it"
    if roles[k] == "mention" and sides[k - 1] in (HOLDS, FAILS) and is_last:
        is_opposite = is_flipped(1, 0, (last.wording, clause.wording)) != last.wording.is_negated
        sides[k - 1] = FAILS if is_opposite else HOLDS
    is_own = clause.names_same(order) or clause.takes_up(order) or clause.is_of_weather
    if roles[k] == "condition" and is_own and last.nouns.isdisjoint(order.objects):
        sides[k - 1] = ">1+"
        sides[k] = beside(sides[k - 2])


def withhold(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A condition behind the last of several orders is of that one alone where it takes back what one before it brings
    about ("light the candles and blow them out if they drip"), where what is asked comes through one ("fill the tub
    and call me when it's full") or is about the thing of the last one ("shut the door and fill the jug if it's
    empty"), and where a comma parts it from them ("shut the door, and bring a chair if there is one")."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = clause.boundary == "none" and (roles[k - 1], roles[k]) == ("task", "condition")
    if not is_behind or OPENING.isdisjoint(clause.near) or sides[k - 1][:2] != ">1" or "or" in order.near:
        return
    ahead = list(takewhile(lambda j: hangs_ahead(clauses, roles, sides, j, clause.sentence), range(k - 2, -1, -1)))
    is_parted = order.boundary == "," and "and" in order.near and "when" not in clause.near
    if any(undoes(order, clauses[j]) or comes_through(clause, clauses[j]) for j in ahead) or (
        ahead and (is_parted or is_only_of(clause, order, clauses[ahead[0]]))
    ):
        for j in ahead:
            sides[j] = sides[k] if sides[k] in (HOLDS, FAILS) else "top"


def go_ahead(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is to be done before something is asked is done whatever the answer ("if the floor is still wet after you
    have mopped it, ...")."""
    clause, before = clauses[k], clauses[k - 1]
    if not (clause.is_had_done and roles[k] == "task" and sides[k] in (HOLDS, FAILS) and clause.boundary == "none"):
        return
    if roles[k - 1] == "condition" and not OPENING.isdisjoint(before.near) and before.sentence == clause.sentence:
        sides[k] = beside(sides[k - 1])
    elif roles[k - 1] == "task" and before.is_had_done and clause.near == ("and",):
        sides[k] = sides[k - 1]


def turn_away(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence with a "now" or the like opens hangs on no condition before ("if Ann asks, I'm out. *Now bring me
    the tea*"), nor is it asked in one ("*separately*, if it's dry, ...")."""
    if not clauses[k].is_new_matter or sides[k] not in (HOLDS, FAILS):
        return
    if roles[k] == "condition":
        sides[k] = "top"
    side = sides[k]
    for j in range(k, len(clauses)):
        if clauses[j].sentence != clauses[k].sentence or roles[j] != "task" or sides[j] != side:
            return
        sides[j] = "top"


def exclude(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Whether somebody is elsewhere is asked where they are not where they were looked for ("if Ann is in the office,
    give it to her, but if she's at lunch, ..."); and whether it is another thing, or is so instead, never where the
    first holds ("if it's the phone, ..., *if it's the doorbell*, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or (roles[first], roles[k]) != ("condition", "condition"):
        return
    is_led = not _IFS.isdisjoint(clause.near) and clause.boundary != "none" and "or" not in clause.near
    if is_led and is_rival_of(clause, clauses[first]) and sides[k] == HOLDS:
        sides[k] = FAILS
    if not {"but", "if"} <= {*clause.far, *clause.near} or not is_elsewhere_than(clause, clauses[first]):
        return
    if sides[k] in (HOLDS, "top") and all(sides[j] in (HOLDS, ">1+", ">1-") for j in range(first + 1, k)):
        sides[first + 1 : k] = [HOLDS] * (k - first - 1)
        sides[k] = FAILS


def leave_rest(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with everything else than what a case spoke of, in a clause of its own, is done in any case ("if
    there's a letter, bring it; *leave everything else* on the mat")."""
    clause = clauses[k]
    is_rest = roles[k] == "task" and "else" in clause.thing and not _ALL.isdisjoint(clause.thing)
    if is_rest and clause.boundary in _PARTING and sides[k] == HOLDS:
        sides[k] = "top"
