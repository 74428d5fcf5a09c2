"""Substitutions: what a case behind an order has done in place of it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.clause import AROUND, Clause
from decomplex_bt.understanding.control_flow.failures import lacks_too
from decomplex_bt.understanding.control_flow.outcomes import OBSTRUCTED, asks_needless, spares
from decomplex_bt.understanding.control_flow.sides.labels import (
    CARRYING,
    FAILS,
    HOLDS,
    MOVING,
    PARTING,
    TURNING,
    VESSELS,
    goes_on,
)
from decomplex_bt.understanding.vocabulary import ROOM

_SOME = frozenset("one ones some two three half few couple rest other others".split())
_MEASURES = frozenset(("state", "manner"))
_WAYS = frozenset("stairs stair stairway staircase elevator lift corridor path way passage".split())
"""What lies on the way to where something is carried."""
_BROKEN = frozenset("broken out order".split())
_MOVED = MOVING | {"change_state", "taking"}
_SERVED = frozenset(("bringing", "placing"))
_TASTING = frozenset("want like eat drink finish touch take accept fancy enjoy".split())
_LEAVING = frozenset(("leave", "keep"))
_KEEPING = _LEAVING | {"let"}
_USELESS = frozenset(
    "dirty broken cracked torn ripped chipped empty stale sour mouldy moldy rotten used use order taken occupied gone "
    "missing lost finished flat dead".split()
)
_FAILING = frozenset("broken order service use locked shut closed empty stuck down".split())
"""What nothing can be taken from, or done with."""
_LOST = frozenset("missing gone lost cracked torn".split())
_FILLED = frozenset("full packed crammed overflowing".split())
_CHOOSING = (("or", "if"), ("or", "if", "not"))


def override(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "but if" says of an order that has a case already is asked ahead of that case, where it calls the order
    off or keeps its thing from it ("let her out if she's at the door, *but if it's raining keep her in*", "...,
    *don't*")."""
    if k < 2 or (roles[k - 2], roles[k - 1], roles[k]) != ("task", "condition", "condition"):
        return
    order, check, clause = clauses[k - 2 : k + 1]
    is_led = clause.near == ("but", "if") and check.near == ("if",) and check.boundary == "none"
    is_guarded = sides[k - 2] == ">1+" and order.sentence == check.sentence == clause.sentence and clause.is_check
    other = clauses[k + 1] if k + 1 < len(clauses) and goes_on(clauses, roles, sides, k + 1, clause.sentence) else None
    is_kept = other is not None and other.verb in _KEEPING and other.has_pronoun and not other.objects
    is_off = (other is None or is_kept) and (clause.calls_off or clause.forbids_order or is_kept)
    if not (is_led and is_guarded and is_off) or order.is_forbidden:
        return
    sides[k - 1], sides[k] = ">1-", sides[k - 1] if sides[k - 1] in (HOLDS, FAILS) else "top"
    if other is not None:
        sides[k + 1] = HOLDS


def choose(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "or" with a case set off by commas has done stands in place of the order right ahead of it alone ("dry it
    and put it in the box *or, should the box be wet, lay it on the bench*"); what an "and" with one adds does not
    ("bring the set *and, unless it is whole, tell me*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_set_off = check.boundary == "," and check.near[:1] in (("if",), ("when",), ("unless",))
    is_one = order.sentence == check.sentence == other.sentence and sides[k + 1] in (HOLDS, FAILS)
    if not (is_set_off and is_one) or order.is_forbidden:
        return
    if check.far == ("or",):
        _choose_last(clauses, roles, sides, k)
    elif check.far == ("and",) and sides[k - 1] == f">1{sides[k + 1][2:]}":
        sides[k - 1] = sides[k]


def _choose_last(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Has the order ahead of clause `k` alone hang on it, and that stand where the orders before it stand."""
    order, other = clauses[k - 1], clauses[k + 1]
    if sides[k - 1] in ("top", HOLDS, FAILS):
        sides[k - 1], sides[k] = ">1-" if sides[k + 1] == HOLDS else ">1+", sides[k - 1]
        return
    listed = [*takewhile(lambda j: roles[j] == "task" and clauses[j].sentence == order.sentence, range(k - 2, -1, -1))]
    if sides[k - 1] != ">1-" or sides[k] != "top" or not listed:
        return
    outer = next((sides[j] for j in listed if sides[j] != ">1-"), "top")
    is_listed = order.near == ("and",) or (order.verb == other.verb and other.verb != clauses[k - 2].verb)
    if not is_listed or outer not in ("top", HOLDS, FAILS):
        return
    sides[k] = outer
    if order.verb == other.verb:
        for j in listed:
            sides[j] = outer


def make_exception_of(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "but if" behind an order has done does not hang on the same case as that: it is done in place of it where
    it is the same deed to the same thing ("take him to the hall, *except that if he's tired, take him home*"), else
    besides it ("..., *except that if one is torn, throw it away*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_led = check.near == ("but", "if") and check.boundary == "," and order.sentence == other.sentence
    if not is_led or (sides[k - 1], sides[k + 1]) != (">1+", HOLDS) or order.is_forbidden:
        return
    is_same = other.has_pronoun and not other.objects and other.task.type == order.task.type
    sides[k - 1] = ">1-" if is_same and not check.is_of_some else sides[k]


def find_no_room(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is put elsewhere where there is no room, or no hook, for it is not put where that was ordered ("hang it in
    the hall. *If there isn't a free hook*, lay it on the chair")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_lacking = check.says_there_is and check.wording.is_negated and check.boundary in PARTING
    is_lacking = is_lacking and check.near[:1] == ("if",) and not check.names_same(order)
    is_elsewhere = order.task.type == other.task.type == "placing" and other.is_of_it and not other.objects
    is_elsewhere = is_elsewhere and bool(other.receivers) and order.receivers.isdisjoint(other.receivers)
    is_one = not (order.number and other.number) or order.number == other.number
    is_whole = is_elsewhere and is_one and other.sentence == check.sentence and not {*other.near} & TURNING
    if is_lacking and is_whole and sides[k + 1] == HOLDS and sides[k - 1] == sides[k] in ("top", HOLDS, FAILS):
        sides[k - 1] = ">1-"


def obstruct(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is put elsewhere where its place is full, shut or missing is not put there ("put it in the box. If the box
    is full, put it on the shelf", "... is missing, use the basket"), and that is asked where it would have been put."""
    if k + 1 >= len(clauses) or roles[k] != "condition" or roles[k - 1] != roles[k + 1] or roles[k - 1] != "task":
        return
    before, clause, after = clauses[k - 1 : k + 2]
    are_moves = before.task.type in MOVING and after.task.type in MOVING
    is_place = is_named = not (before.nouns - set(before.objects)).isdisjoint(clause.objects)
    is_one = before.number == "many" != clause.number and clause.has_pronoun and not clause.objects
    is_place = is_place or (is_one and before.task.type == "placing")  # "put the cans in the bin, and if that's full"
    is_way = not _WAYS.isdisjoint(clause.objects[-1:]) and clause.boundary in PARTING
    is_place = is_place or is_way  # "carry it upstairs. If the stairs are blocked, ..."
    is_useless = clause.wording.state in _BROKEN | (frozenset() if is_way else _LOST) and (is_way or is_named)
    is_shut = (clause.wording.state in OBSTRUCTED or is_useless) and not clause.wording.is_negated
    is_used = after.verb == "use" and after.task.type == "placing"
    is_same = is_used or (after.has_pronoun and not after.objects)
    is_same = is_same and not {"first", "before"} & set(after.wording.orders)
    # "if the bin is full, take it out", not "take them out", of which one is not full
    is_carried = after.task.type == "bringing" and clause.wording.state in _FILLED and after.number != "many"
    is_leading = after.sentence == clause.sentence and (clause.boundary != "none" or is_used)
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


def leave_be(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is left somewhere, or kept, in a case is not moved in it ("bring the washing in. If it's damp, *leave it on
    the line*", "throw the rolls away. If they're fresh, *keep them*"); where only some of it is left, the rest is
    ("bring the milk in. If there are two, *leave one outside*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    before, clause, after = clauses[k - 1 : k + 2]
    is_left = before.task.type in CARRYING and after.verb in _LEAVING
    is_left = is_left and (after.task.type == "placing" or _is_kept(after))
    is_left = is_left and (before.task.type != "taking" or after.receivers <= before.places)
    is_next = after.sentence == clause.sentence and after.boundary == "," and "if" in clause.near
    is_led = clause.boundary in PARTING and not {*clause.near, *after.near} & TURNING
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


def _is_kept(clause: Clause) -> bool:
    """Whether it says to keep something, and neither where nor how."""
    is_bare = all(kind == "object" for kind, _ in clause.task.arguments) and clause.wording.state is None
    return clause.verb == "keep" and is_bare


def keep_state(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is left or kept in a case as it was before an order is not changed in it ("turn off the heater. If Gran's
    cold, *leave it on*", "close the gate. *Leave it open* if the dog's out")."""
    is_led = k + 1 < len(clauses) and sides[k + 1] == HOLDS
    check, kept = clauses[k], k + 1 if is_led else k - 1
    if (roles[k], roles[kept]) != ("condition", "task") or clauses[kept].sentence != check.sentence:
        return
    clause, is_behind = clauses[kept], sides[kept] == ">1+" and check.boundary == "none"
    is_opened = "if" in check.near and not {*check.far, *clause.near} & (TURNING - {"but"})
    if not (is_opened and (is_led or is_behind)):
        return
    ahead = takewhile(lambda j: roles[j] == "task", range(min(kept, k) - 1, -1, -1))
    changed = next((j for j in ahead if spares(clause, clauses[j])), None)
    if changed is None:
        return
    if sides[changed] in ("top", HOLDS, FAILS) and sides[k] in ("top", sides[changed]):
        sides[changed], sides[k] = ">1-", sides[changed]
    elif is_behind and sides[changed] == ">1+":
        sides[changed] = ">1-"


def go_ahead_of_both(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is ordered in a sentence of its own is in place of neither of two cases that each say what is done then
    ("bring the towels to the cellar. If the dryer is free, *put them in; if not, hang them up*"), nor of what is asked
    of another place, where it only fills what goes there ("put the cake in a box, and if there's no room *in the
    fridge*, ...")."""
    if k + 1 >= len(clauses) or tuple(roles[k - 1 : k + 2]) != ("task", "condition", "task"):
        return
    order, check = clauses[k - 1 : k + 1]
    if sides[k - 1] not in (">1-", ">1+") or "if" not in check.near or order.is_forbidden:
        return
    side = sides[k] if sides[k] in ("top", HOLDS, FAILS) else "top"
    later = [j for j in range(k + 1, len(clauses)) if roles[j] == "task" and not {*clauses[j].near} & {"if", "unless"}]
    turned = [j for j in later if clauses[j].turns and sides[j][:2] == "<1"]
    is_both = bool(turned) and turned[0] > k + 1 and sides[k + 1][:2] == "<1"
    are_moves = order.task.type == "bringing" and all(clauses[j].has_pronoun for j in (k + 1, *turned[:1]))
    if is_both and are_moves and check.boundary in PARTING and order.sentence < check.sentence:
        sides[k - 1] = side
    is_room = check.says_there_is and not ROOM.isdisjoint(check.thing) and check.wording.is_negated
    is_elsewhere = bool(check.places - AROUND) and not order.receivers.isdisjoint(VESSELS - check.places)
    if is_room and is_elsewhere and check.boundary != "none" and order.task.type == "placing":
        sides[k - 1] = side


def try_first(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What somebody does not want, eat or finish was brought or served first ("take Joe this plate, *and if he doesn't
    want it*, ..."); not "give him the tea if he wants it"."""
    order, check = clauses[k - 1 : k + 1]
    is_served = order.task.type in _SERVED and not order.is_forbidden and sides[k - 1] in (">1+", ">1-")
    is_taken = check.is_check and check.verb in _TASTING and check.wording.is_negated and "unless" not in check.near
    is_led = check.near[:1] in (("if",), ("and",), ("but",)) and "if" in check.near and not check.is_trailing
    is_led = is_led and (check.boundary != "none" or check.near[:1] != ("if",)) and not check.ends_sentence
    if (roles[k - 1], roles[k]) == ("task", "condition") and is_served and is_taken and is_led:
        sides[k - 1] = sides[k] if sides[k] in ("top", HOLDS, FAILS) else "top"


def leave_in_place(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a "but" says to leave in a case is not moved in it ("take the towels out and put them on the bed, *but leave
    them in there if they're damp*")."""
    order = clauses[k - 1]
    is_left = order.task.type == "placing" and order.verb in _LEAVING and order.near[:1] == ("but",)
    is_behind = clauses[k].boundary == "none" and clauses[k].near == ("if",) and clauses[k].sentence == order.sentence
    if (roles[k - 1], roles[k]) != ("task", "condition") or not (is_left and is_behind):
        return
    ahead = [j for j in range(k - 1) if clauses[j].sentence == order.sentence and clauses[j].task.type in _MOVED]
    run = [j for j in ahead if all(roles[i] == "task" for i in range(j, k))]
    if not run or not order.has_pronoun or {sides[j] for j in run} - {"top", HOLDS, FAILS}:
        return
    side = sides[run[-1]]
    if {sides[j] for j in run} == {side} and sides[k - 1] in (">1+", side):
        sides[k - 1], sides[k] = ">1+", side
        for j in run:
            sides[j] = ">1-"


def stand_in(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is fetched likewise in a case in which the thing ahead is of no use, or as another "one", is fetched in its
    place ("bring me a spoon, and if they're all dirty, *bring me a fork*", "bring me the blue towel, and if it's wet,
    *the white one*", as `retelling` tells it), and another thing of its own kind in a sentence of its own ("bring me
    the shawl. If it's torn, *get me a blanket, please*"), not "bring me the paper and, if it's hot, bring me the
    coffee"."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_alike = (order.verb, order.task.type) == (other.verb, other.task.type) and order.task.type in CARRYING
    is_led = check.near == ("and", "if") and check.has_pronoun and not check.objects and check.is_check
    is_led = is_led and other.sentence == order.sentence and not (other.near or other.behind)
    is_useless = check.wording.state in _USELESS and not check.wording.is_negated
    is_apart = check.boundary in PARTING and check.near == ("if",) and check.takes_up(order) and is_useless
    is_apart = is_apart and order.task.type == other.task.type == "bringing" and other.is_of_kind
    is_apart = is_apart and {"please"}.issuperset((*other.near, *other.behind)) and other.number == order.number
    is_replaced = is_alike and is_led and (is_useless or "one" in other.thing)
    if other.names_same(order) or not (is_apart or is_replaced):
        return
    if sides[k + 1] == HOLDS and sides[k] == sides[k - 1] and sides[k] in ("top", HOLDS, FAILS):
        sides[k - 1] = ">1-"


def alter(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done to the same thing to another measure in a case is not done as it was said first ("set the table for
    six. If Gran comes, *set it for seven*"), unless it is still not so, or done again."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_same = (order.verb, order.task.type) == (other.verb, other.task.type) and order.task.type == "change_state"
    is_same = is_same and _is_of_same(other, order) and not (order.is_forbidden or other.is_forbidden)
    measures = [{t for kind, t in c.task.arguments if kind in _MEASURES} for c in (order, other)]
    is_led = check.boundary in PARTING and check.near == ("if",) and other.sentence == check.sentence
    is_later = check.says_still or check.is_of_it or bool(other.ways) or not set(other.behind) <= {"instead"}
    is_beside = sides[k] == sides[k - 1] and sides[k] in ("top", HOLDS, FAILS) and sides[k + 1] == HOLDS
    if is_same and all(measures) and is_led and not is_later and is_beside and check.is_check:
        sides[k - 1] = ">1-"


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
    is_fetched = is_next and order.task.type in CARRYING
    if is_lacking and is_fetched and sides[k - 1] == sides[k] == "top":
        sides[k - 1] = ">1-"
    if is_fetched and lacks_too(clause, order) and sides[k - 1] in (HOLDS, FAILS):
        sides[k - 1], sides[k] = ">1-", sides[k - 1]


def find_some(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is fetched is fetched where there is some of it ("I'd like a pear. *Are there any?* If not, ...")."""
    order, clause = clauses[k - 1 : k + 1]
    is_some = clause.is_question and clause.verb == "be" and clause.is_of_any and not clause.wording.is_negated
    is_fetched = (roles[k - 1], roles[k]) == ("task", "condition") and order.task.type in CARRYING
    if is_some and is_fetched and sides[k - 1] == ">1-":
        sides[k - 1] = ">1+"


def choose_by_case(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "or if" opens behind an order, with an order of its own, is done in place of that ("tell my wife, *or if
    she's asleep, tell me*", "leave it with Ann *or, if she's out, with Tom*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_or = check.far + check.near in _CHOOSING and check.boundary == "," and check.is_check
    is_one = order.sentence == check.sentence == other.sentence and other.boundary == "," and not other.near
    is_alike = order.task.type == other.task.type and not (order.is_forbidden or other.is_forbidden)
    is_open = sides[k + 1] == HOLDS and {sides[k - 1], sides[k]} <= {"top", HOLDS, FAILS}
    if is_or and is_one and is_alike and is_open:
        sides[k - 1], sides[k] = ">1-", sides[k - 1]


def replace_last(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done *instead* in a case that is asked in a sentence of its own stands in place of the last order of its
    kind, with the same thing, not of those around about others ("before you sweep, put the toys in the box. If it's
    full, put them on the shelf *instead*")."""
    if k < 2 or k + 1 == len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    other = clauses[k + 1]
    ahead = list(takewhile(lambda j: roles[j] == "task" and sides[j] == ">1-", range(k - 1, -1, -1)))
    alike = [j for j in ahead if clauses[j].task.type == other.task.type and _is_of_same(other, clauses[j])]
    is_instead = "instead" in (*other.near, *other.behind) and sides[k + 1] == HOLDS
    if not is_instead or not alike or other.task.type not in CARRYING or clauses[k].sentence == clauses[k - 1].sentence:
        return
    meant = clauses[alike[0]]
    for j in ahead:
        is_other = meant.objects and frozenset(meant.objects).isdisjoint(clauses[j].nouns)
        if j != alike[0] and is_other and not clauses[j].has_pronoun and clauses[j].sentence == meant.sentence:
            sides[j] = "top"


def _is_of_same(other: Clause, order: Clause) -> bool:
    return bool(order.objects) and (other.has_pronoun or other.names_same(order))


def break_down(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What comes before the order that a case keeps from is kept from as well, where that case is of what it needs
    ("take the lift up and bring Ann the parcel; *if the lift is broken*, come back")."""
    clause = clauses[k]
    if roles[k] != "condition" or sides[k - 1] != ">1-" or clause.wording.state not in _FAILING or not clause.objects:
        return
    is_led = clause.boundary in PARTING and clause.near[-1:] == ("if",) and not clause.wording.is_negated
    own = [j for j in range(k - 1, -1, -1) if clauses[j].sentence == clauses[k - 1].sentence]
    ahead = list(takewhile(lambda j: roles[j] == "task" and sides[j] in (">1-", "top"), own))
    needing = [j for j in ahead if not clauses[j].nouns.isdisjoint(clause.objects)]
    if is_led and needing and sides[k] == "top":
        for j in range(needing[-1], k):
            sides[j] = ">1-"


def run_out(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is fetched is not where all that there is of it is of no use, and another one is then fetched ("bring me a
    plate. If *all the plates are dirty*, wash one and bring it")."""
    order, check = clauses[k - 1 : k + 1]
    is_behind = (roles[k - 1], roles[k]) == ("task", "condition") and check.boundary in PARTING
    if not is_behind or check.near[:1] != ("if",) or sides[k - 1] != "top" or sides[k] != "top":
        return
    is_of_all = check.objects[-1:] == order.objects[-1:] != () and check.number == "many" != order.number
    is_useless = check.wording.state in _USELESS or bool(check.places)
    later = [j for j in range(k + 1, len(clauses)) if goes_on(clauses, roles, sides, j, check.sentence)]
    is_replaced = any(clauses[j].task.type == order.task.type and sides[j] == HOLDS for j in later)
    if is_of_all and is_useless and is_replaced and order.task.type in CARRYING and not check.wording.is_negated:
        sides[k - 1] = ">1-"
