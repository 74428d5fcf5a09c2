"""Guards: which of the orders ahead of it a condition right behind an order is about."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, is_flipped
from decomplex_bt.understanding.control_flow.clause import FINDING_OUT, Clause
from decomplex_bt.understanding.control_flow.contrasts import asks_of
from decomplex_bt.understanding.control_flow.failures import is_kept_from
from decomplex_bt.understanding.control_flow.outcomes import (
    comes_through,
    is_against,
    is_guard_of,
    is_only_of,
    spares,
    undoes,
)
from decomplex_bt.understanding.control_flow.roles.parts import guards_own_order
from decomplex_bt.understanding.control_flow.sides.labels import (
    FAILS,
    HOLDS,
    OPENING,
    TURNING,
    beside,
    goes_on,
    hangs_ahead,
)
from decomplex_bt.understanding.vocabulary import ROOM

_HANDLING = frozenset(("taking", "change_state"))
_SAYING = frozenset(("not", "there", "still"))
_WATCHING = frozenset("keep watch mind supervise stay remain sit stand wait".split())
_SETTING_OUT = frozenset("go leave want need wish like".split())
_LISTING = frozenset(("and", "please"))
_OF_MATTERS = FINDING_OUT | {"informing"}
"""Orders that an "if" may open the matter of: "tell me *if she's in*"."""
_AND_ONLY = (("but", "but"), ("and", "but"))
"""The cues of "but only" and "and only" ahead of a verb."""
_LIST = 3
"""From so many orders on they are a list."""

_SWITCHED = frozenset(("on", "off"))
_AT_ONCE = 3
"""The most tokens from "off" to "on" in "off and back on"."""


def confine(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A condition behind one of several orders is of that one alone where it stands within a list ("pick up the mug,
    wash it if it's dirty, and put it away"), or asks whether that order is needed ("turn the tv off if it's on and come
    here", "if he's home, pour the tea and warm it if it's cold, then come here")."""
    clause, order = clauses[k], clauses[k - 1]
    is_guard = is_guard_of(clause, order) or guards_own_order(clauses, roles, k)
    is_guard = is_guard and (roles[k - 1], roles[k]) == ("task", "condition")
    is_behind = clause.boundary == "none" or (clause.boundary == "," and is_guard and "unless" in clause.near)
    if not is_behind or OPENING.isdisjoint(clause.near[:1]) or "mention" in roles[k + 1 :]:
        return
    if is_guard and sides[k - 1] in (HOLDS, FAILS):
        sides[k - 1], sides[k] = ">1+", sides[k - 1]
    if (roles[k - 1], roles[k]) != ("task", "condition") or sides[k - 1][:2] != ">1":
        return
    ahead = [j for j in range(k - 1) if clauses[j].sentence == clause.sentence and roles[j] == "task"]
    is_second = k > 2 and roles[k - 2] == "condition" and clauses[k - 2].boundary == "none" and sides[k - 3] == ">1+"
    is_second = is_second and clauses[k - 2].sentence == clause.sentence  # "wash it *if it's dirty*, dry it if ..."
    is_listed = bool(ahead) and (ahead[-1] == k - 2 or is_second) and order.boundary == ","
    later = list(takewhile(lambda j: goes_on(clauses, roles, sides, j, clause.sentence), range(k + 1, len(clauses))))
    if not later or not (is_guard or (is_listed and clauses[k + 1].boundary == ",")) or clauses[later[0]].is_otherwise:
        return
    if is_listed and not is_second:
        for j in ahead:
            sides[j] = "top" if sides[j][:2] == ">1" else sides[j]
    for j in later:
        sides[j] = beside(sides[k])


def bind_behind(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An "if" that no mark parts from the order before it is of that order, not of what a comma sets off behind it
    ("shut the gate, *feed the hen if her bowl is empty*, bring Ann her tablets, and ...")."""
    if k + 1 >= len(clauses) or tuple(roles[k - 1 : k + 2]) != ("task", "condition", "task"):
        return
    order, clause, later = clauses[k - 1 : k + 2]
    is_behind = clause.boundary == "none" and clause.near == ("if",) and clause.is_check and not clause.far
    is_parted = order.boundary != "none" and later.boundary == "," and TURNING.isdisjoint({*later.near, *later.far})
    is_one = order.sentence == clause.sentence == later.sentence and order.task.type not in _OF_MATTERS
    if is_behind and is_parted and is_one and sides[k - 1 : k + 2] == ["top", "top", HOLDS]:
        sides[k - 1] = ">1+"
        for j in takewhile(lambda j: goes_on(clauses, roles, sides, j, clause.sentence), range(k + 1, len(clauses))):
            sides[j] = "top"


def bind_so(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An "if so" behind an order is of that alone, not of what a "then" goes on with ("look if the filter is full and
    clean it *if so then* run the dryer")."""
    before, clause = clauses[k - 1], clauses[k]
    is_next = (roles[k - 1], roles[k]) == ("task", "task") and before.behind[:1] == ("so",) and sides[k - 1] == HOLDS
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    is_run_on = clause.boundary == "none" and clause.near[-1:] == ("then",) and before.sentence == clause.sentence
    if first is None or not (is_next and is_run_on):
        return
    for j in range(k, len(clauses)):
        if not (j == k or goes_on(clauses, roles, sides, j, clause.sentence)) or sides[j] != HOLDS:
            return
        sides[j] = beside(sides[first])


def list_all(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Of several orders in a list ahead of a case that a comma sets off, all hang on it where more than the last do
    ("dim the lights, draw the blinds and start the film, *unless Tom isn't back*")."""
    clause = clauses[k]
    is_behind = clause.boundary == "," and clause.near in (("unless",), ("if",)) and roles[k] == "condition"
    ahead = list(
        takewhile(lambda j: roles[j] == "task" and clauses[j].sentence == clause.sentence, range(k - 1, -1, -1))
    )
    if not is_behind or len(ahead) < _LIST or not clause.ends_sentence or sides[k - 1] != sides[k - 2]:
        return
    is_list = all(not clauses[j].far and _LISTING.issuperset(clauses[j].near) for j in ahead)
    if is_list and sides[k - 1][:2] == ">1" and all(sides[j] in ("top", sides[k - 1]) for j in ahead):
        for j in ahead:
            sides[j] = sides[k - 1]


def guard(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An order hangs on what is asked right behind it after its own thing, and behind a "then" that is asked whatever
    came of another condition ("is the tv on? Turn it off, *then* close the window if *it's open*")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[k - 1], roles[k]) != ("task", "condition") or sides[k - 1][:2] != "<1":
        return
    if asks_of(clauses[k], clauses[k - 1], clauses[first]):
        is_next = "then" in clauses[k - 1].near and clauses[k - 1].sentence == clauses[first].sentence
        sides[k - 1], sides[k] = ">1+", "top" if is_next else sides[k - 1]


def confine_to_sentence(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A condition right behind the one order of its sentence is not of those in sentences before ("bring the tea. *Shut
    the hatch if it's cold*")."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = clause.boundary == "none" and (roles[k - 1], roles[k]) == ("task", "condition")
    is_one = k > 1 and order.sentence == clause.sentence > clauses[k - 2].sentence and not order.covers
    if not (is_behind and is_one and sides[k - 1][:2] == ">1") or OPENING.isdisjoint(clause.near) or order.has_pronoun:
        return
    for j in takewhile(lambda j: roles[j] == "task" and sides[j][:2] == ">1", range(k - 2, -1, -1)):
        sides[j] = sides[k] if sides[k] in (HOLDS, FAILS) else "top"


def guard_last(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An order in a case hangs on what is asked right behind it as well, where nothing else would ("see if the lights
    are on and turn them off *if nobody's there*")."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = clause.boundary == "none" and clause.near[:1] in (("if",), ("unless",)) and clause.ends_sentence
    is_behind = is_behind and _SAYING.issuperset(clause.near[1:])
    is_free = sides[k - 1] in (HOLDS, FAILS) and (k + 1 == len(clauses) or sides[k + 1][:1] != "<")
    if is_behind and is_free and (roles[k - 1], roles[k]) == ("task", "condition") and "or" not in order.near:
        sides[k - 1], sides[k] = ">1+", sides[k - 1]


def guard_other(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "or if" opens behind an order and its case is asked where that is not so, with its own order ("hang it up
    if it's wet, *or if it's torn, mend it*")."""
    if k < 2 or k + 1 >= len(clauses) or clauses[k].near != ("or", "if") or clauses[k - 1].boundary != "none":
        return
    if tuple(roles[k - 2 : k]) == ("task", "condition") and sides[k - 2][:2] == ">1" and roles[k] != "or":
        sides[k] = FAILS if roles[k] == "condition" else "<1"
        sides[k + 1] = HOLDS if roles[k + 1] == "task" else sides[k + 1]


def guard_room(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Whether there is room is asked of the last order alone that puts things somewhere, which were taken on the way to
    it ("take the books to the study and put them on the shelf *if there's room*, otherwise ..."), or somebody went
    there ("drive home and put the bag on the table, *provided there's room on it*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "task", "condition"):
        return
    taken, put, check = clauses[k - 2 : k + 1]
    is_room = check.says_there_is and not ROOM.isdisjoint(check.thing) and not {"if", "only_if"}.isdisjoint(check.near)
    is_room = is_room and taken.sentence == put.sentence == check.sentence and put.task.type == "placing"
    is_gone = taken.task.type == "motion" and "and" in put.near
    if not is_gone:
        is_put = put.has_pronoun and not put.objects and put.near == ("and",) and check.boundary == "none"
        is_taken = taken.task.type == "bringing" and any(kind == "goal" for kind, _ in taken.task.arguments)
        is_turned = k + 1 < len(clauses) and clauses[k + 1].is_otherwise and clauses[k + 1].has_pronoun
        is_room = is_room and is_put and is_taken and is_turned and roles[k + 1] == "task"
    if is_room:
        sides[k - 2] = sides[k] if sides[k] in ("top", HOLDS, FAILS) else "top"


def guard_handing(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A thing is handed over where what is said behind another order to keep somebody from taking it is not so ("take
    it to Lea *and leave it on the step if she's out*")."""
    if k < 2 or roles[k - 2] != "task" or roles[k - 1] != "task" or roles[k] not in CONDITION_ROLES:
        return
    handing, other, check = clauses[k - 2 : k + 1]
    is_behind = check.is_trailing and check.near[:1] == ("if",) and other.near[-1:] in (("and",), ("then",))
    is_one = handing.sentence == other.sentence == check.sentence and sides[k - 1][:2] == ">1"
    if is_behind and is_one and sides[k - 2] in ("top", sides[k - 1]) and is_kept_from(check, handing, other):
        sides[k - 2] = ">1-" if sides[k - 1] == ">1+" else ">1+"


def guard_within(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is asked in the midst of an order is asked of that one alone ("clean the filter and lay it, *when it is
    dry*, into its frame")."""
    order, check = clauses[k - 1], clauses[k]
    is_within = any(indices.start > check.task.token for _, indices in order.task.arguments if len(indices))
    if not is_within or (roles[k - 1], roles[k]) != ("task", "condition") or sides[k - 1][:2] != ">1":
        return
    for j in range(k - 2, -1, -1):
        if not hangs_ahead(clauses, roles, sides, j, check.sentence):
            return
        sides[j] = sides[k] if sides[k] in ("top", HOLDS, FAILS) else "top"


def guard_each(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Of orders in a row, each with a condition of its own thing right behind it, each hangs on its own ("switch the
    stove off if it's on, *close the door if it's open*, and come here"), be it the other side of the one before ("bring
    the cup if it's clean and *wash it if it's dirty*"), or what takes back the order before, or leaves it undone ("turn
    it on if he reads, *but turn it off if he sleeps*")."""
    if k < 3 or tuple(roles[k - 3 : k]) != ("task", "condition", "task"):
        return
    first, last, order, clause = clauses[k - 3 : k + 1]
    is_counter = (undoes(order, first) or spares(order, first)) and clause.near == last.near
    is_row = sides[k - 3][:2] == ">1" and last.boundary == "none"
    is_row = is_row and order.sentence - last.sentence <= (is_counter and not order.near)
    is_alternative = order.near == ("or",) and roles[k] == "condition"  # "..., or light the stove if it's raining"
    if is_row and is_alternative and clause.near == ("if",) and clause.boundary == "none":
        sides[k - 1], sides[k] = ">1+", FAILS
        return
    is_led = clause.near in (("if",), ("unless",), ("when",))
    is_behind = clause.boundary == "none" and is_led and TURNING.isdisjoint({*order.near} - {"but"})
    if not (is_row and is_behind and clause.is_check):
        return
    is_last = k + 1 == len(clauses) or clauses[k + 1].boundary != "none"  # not "... if it's hot just bring it"
    if roles[k] == "mention" and sides[k - 1] in (HOLDS, FAILS) and is_last:
        is_opposite = is_flipped(1, 0, (last.wording, clause.wording)) != last.wording.is_negated
        sides[k - 1] = FAILS if is_opposite else HOLDS
    is_other = clause.is_of_same_it(last) and not order.objects and clause.wording.state != last.wording.state
    is_own = clause.names_same(order) or clause.takes_up(order) or clause.is_of_weather or is_other
    is_own = is_own and last.nouns.isdisjoint(order.objects) and "but" not in order.near
    if roles[k] == "condition" and (is_own or is_counter):
        sides[k - 1] = ">1+"
        sides[k] = beside(sides[k - 2])


def withhold(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A condition behind the last of several orders is of that one alone where it takes back what one before it brings
    about ("light the candles and blow them out if they drip"), where what is asked comes through one ("fill the tub
    and call me when it's full"), is about the thing of the last one ("shut the door and fill the jug if it's empty"),
    or in what state that will be which was handled before ("unplug it and put it away when it's cold"), where a "but"
    or an "only" sets that one apart ("take it out, but cut it only when it's cold", "... but only cut it when ..."),
    where it is about weather that only the last is for ("feed the cat and shut the window if it rains"), where
    somebody whom only the last speaks to does something ("put out the light and sing to Mia if she cries"), where
    somebody or something is gone with or watched over until then ("sit with Gran and call me if she wakes"), and where
    a comma parts it from them ("shut the door, and bring a chair if there is one")."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = clause.boundary == "none" and (roles[k - 1], roles[k]) == ("task", "condition")
    if not is_behind or OPENING.isdisjoint(clause.near) or sides[k - 1][:2] != ">1" or "or" in order.near:
        return
    ahead = list(takewhile(lambda j: hangs_ahead(clauses, roles, sides, j, clause.sentence), range(k - 2, -1, -1)))
    is_parted = order.boundary == "," and "and" in order.near and "when" not in clause.near
    is_awaited = clause.near[-1:] == ("when",) and clause.is_of_it and order.is_of_it and "and" in order.near
    is_awaited = is_awaited and not order.objects and clause.wording.state is not None
    is_of_weather = is_against(order, clause) and not (
        clause.objects or any(is_against(clauses[j], clause) for j in ahead)
    )
    if (
        is_of_weather
        or (is_awaited and len(ahead) == 1 and clauses[ahead[0]].task.type in _HANDLING)
        or (order.near == ("but",) and order.boundary == "," and clause.near == ("only_if",))
        or order.near in _AND_ONLY
        or any(undoes(order, clauses[j]) or comes_through(clause, clauses[j]) for j in ahead)
        or (len(ahead) == 1 and (_watches(clauses[ahead[0]], clause) or _speaks_of(order, clause, clauses[ahead[0]])))
        or (ahead and (is_parted or is_only_of(clause, order, clauses[ahead[0]])))
    ):
        for j in ahead:
            sides[j] = sides[k] if sides[k] in (HOLDS, FAILS) else "top"


def _watches(order: Clause, check: Clause) -> bool:
    """Whether an order is to go or stay with, or watch over, who or what a check behind it asks about; not to go with
    whoever goes out."""
    is_gone_with = order.task.type == "following" and (order.verb in _WATCHING or check.verb not in _SETTING_OUT)
    is_watch = is_gone_with or (order.task.type == "searching" and order.verb in _WATCHING)
    is_of_it = check.has_pronoun and not check.objects
    return is_watch and not order.is_forbidden and check.is_check and (is_of_it or check.names_same(order))


def _speaks_of(order: Clause, check: Clause, before: Clause) -> bool:
    """Whether a check asks if somebody whom an order speaks to does something, and the order before that is of a thing
    alone."""
    is_told = order.task.type == "informing" and bool(order.receivers) and not order.has_pronoun
    is_of_them = check.is_check and check.is_of_person and not (check.objects or check.said_state)
    is_apart = bool(before.objects) and bool(before.number) and not (before.receivers or before.has_pronoun)
    return is_told and is_of_them and is_apart


def guard_return(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is switched on "and off" when something is so, in one breath, is switched on at once ("turn the lamp on *and
    off again when Tom leaves*"); what is switched off and on is only if more is said of that ("off *for now* and on
    again when ...")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "task", "condition"):
        return
    order, back, check = clauses[k - 2 : k + 1]
    said = [indices[-1] for kind, indices in order.task.arguments if kind == "state" and len(indices)]
    is_apart = bool(said) and (order.wording.state == "on" or back.task.token - said[-1] > _AT_ONCE)
    is_back = back.verb in _SWITCHED and order.wording.state in _SWITCHED - {back.verb}
    is_behind = check.near == ("when",) and check.boundary == "none" and check.is_trailing
    if is_apart and is_back and is_behind and sides[k - 2 : k] == [">1+", ">1+"]:
        sides[k - 2] = sides[k] if sides[k] in ("top", HOLDS, FAILS) else "top"
