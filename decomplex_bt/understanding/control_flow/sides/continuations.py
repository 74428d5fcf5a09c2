"""Continuations: an order of another matter behind an order and its case, which is carried out in any case."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.outcomes import WORKING, is_against
from decomplex_bt.understanding.control_flow.sides.labels import (
    FAILS,
    HOLDS,
    OPENING,
    PARTING,
    TURNING,
    VESSELS,
    beside,
    goes_on,
)

_ADDING = (("and",), ("and", "please"))
_LISTING = ((), *_ADDING)
_OPENING_ANEW = frozenset(("and", "please", "then", "also"))
_HOLDERS = VESSELS | WORKING | {"lid", "packet", "bottle", "wrapper", "cup", "mug", "glass", "plate", "bin", "rest"}
"""What a thing is in or on, or comes with, that is seen to where the thing is: "if it's sour, pour it away, and rinse
the *bottle*"."""
_NEW = frozenset("new fresh clean other another spare".split())
_SHELTERED = frozenset(("covered", "closed", "locked"))
_OWNING = frozenset("his her its their".split())


def turn_to_chore(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "and" behind a comma does with another thing is done in any case where the case before it only asks how
    the thing of its own order is, if nobody is there, or about the weather ("shut the blind if it's raining, *and dust
    the piano*"), not what the same weather calls for ("..., *and bring the laundry in*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "condition", "task") or sides[k - 2][:2] != ">1":
        return
    order, check, clause = clauses[k - 2 : k + 1]
    is_first = k == 2 or clauses[k - 3].sentence != order.sentence
    is_behind = order.sentence == check.sentence == clause.sentence and check.near[:1] == ("if",) and check.is_check
    is_listed = clause.boundary == "," and _is_listed(clauses, k) and TURNING.isdisjoint({*clause.far} - {"not"})
    if is_first and is_behind and is_listed and _asks_no_more(check, order) and _is_unrelated(clause, order, check):
        _take_beside(clauses, roles, sides, k, sides[k - 1])


def turn_from_answer(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an "and" behind a comma does with another thing is done whatever was found out, where the order before it
    hangs on an "if it is" behind it ("is the tap on? Turn it off if it is, *and dust the piano*"); with the same thing,
    or where the answer is about somebody, in its case ("see if Ann is up. Bring her tea if she is, *and open the
    blinds*")."""
    if k < 3 or tuple(roles[k - 3 : k + 1]) != ("condition", "task", "mention", "task"):
        return
    asked, order, echo, clause = clauses[k - 3 : k + 1]
    is_behind = echo.wording.is_echo and {"if"} <= {*echo.near} <= {"if", "there"} and echo.boundary == "none"
    is_asked = asked.is_asked and not asked.wording.is_negated and sides[k - 2] == HOLDS
    is_listed = clause.boundary == "," and _is_listed(clauses, k) and TURNING.isdisjoint({*clause.far} - {"not"})
    is_one = order.sentence == echo.sentence == clause.sentence
    if not (is_behind and is_asked and is_listed and is_one) or sides[k] != HOLDS:
        return
    if (asked.number or asked.is_of_weather) and _is_unrelated(clause, order, asked):
        _take_beside(clauses, roles, sides, k, sides[k - 3])
        return
    for j in range(k, len(clauses)):
        if sides[j] != HOLDS or not (j == k or goes_on(clauses, roles, sides, j, clause.sentence)):
            return
        sides[j] = FAILS  # a mention whose side has its orders already means the other one (`arcs.flip_of`)


def begin_anew(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence of its own does with another thing, behind an order and its case that are put as a question, is
    done in any case ("could you shut the blind if it's raining? *Dust the piano*", "shut it if it's open, will you? ...
    ")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "condition", "task") or sides[k - 2][:2] != ">1":
        return
    order, check, clause = clauses[k - 2 : k + 1]
    is_behind = order.sentence == check.sentence == clause.sentence - 1 and not OPENING.isdisjoint(check.near)
    is_next = clause.boundary == "?" and _OPENING_ANEW.issuperset(clause.near) and check.is_check
    is_plain = TURNING.isdisjoint({*clause.far} - {"not"}) and not clause.has_pronoun and bool(clause.nouns)
    if is_behind and is_next and is_plain and not _is_part(clause):
        _take_beside(clauses, roles, sides, k, sides[k - 1])


def ask_of_own_thing(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is asked of another thing behind its own order is asked in any case where the case before it only has that
    undone which it asks ("if the tap is on, turn it off, and shut the hatch *if it's open*"), not what is done with it
    "too"."""
    if k < 3 or tuple(roles[k - 3 : k + 1]) != ("condition", "task", "task", "condition"):
        return
    first, undone, order, check = clauses[k - 3 : k + 1]
    is_one = first.sentence == undone.sentence == order.sentence == check.sentence and "if" in first.near
    is_undone = is_one and _undoes(undone, first) and sides[k - 2] == HOLDS
    is_own = check.near in (("if",), ("unless",)) and (check.takes_up(order) or check.names_same(order))
    is_added = order.near in _ADDING and not order.far and "also" not in order.behind and check.is_check
    known = first.nouns | undone.nouns
    is_other = not order.has_pronoun and bool(order.objects) and known.isdisjoint(order.nouns)
    if is_undone and is_own and is_added and is_other and sides[k - 1][:2] == ">1" and sides[k] == HOLDS:
        sides[k] = beside(sides[k - 3])


def allow_besides(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence of its own lets be done with another thing than a case and its one order spoke of is done in any
    ("if the jug is chipped, bin it; *the cups can go in the rack*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("condition", "task", "task") or sides[k] not in (HOLDS, FAILS):
        return
    check, order, clause = clauses[k - 2 : k + 1]
    is_let = clause.boundary in PARTING and clause.near == ("can",) and not clause.far
    is_one = "if" in check.near and order.has_pronoun and not order.objects and sides[k - 1] == HOLDS
    if is_let and is_one and bool(check.objects) and _is_unrelated(clause, order, check):
        _take_beside(clauses, roles, sides, k, sides[k - 2])


def set_apart(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What stands ahead of a "but" is done in any case where that orders something of another thing, with its own case
    right behind it ("draw the blinds *but* put out the lamp *if nobody's in the den*"), not the like of it where that
    is not to be had ("bring the tea *but* bring the cocoa *if there's no tea*")."""
    if k < 2 or tuple(roles[k - 2 : k + 1]) != ("task", "task", "condition") or sides[k - 2][:2] != ">1":
        return
    before, order, check = clauses[k - 2 : k + 1]
    is_one = before.sentence == order.sentence == check.sentence and order.near == ("but",)
    is_own = check.boundary == "none" and check.near in (("if",), ("if", "not"), ("unless",)) and check.ends_sentence
    is_other = bool(before.objects) and bool(order.objects) and not order.has_pronoun
    is_other = is_other and before.thing.isdisjoint(order.thing | check.thing) and before.verb != order.verb
    if is_one and is_own and is_other and sides[k - 1][:2] == ">1" and not before.is_forbidden:
        sides[k - 2] = sides[k] if sides[k] in (HOLDS, FAILS) else "top"


def _undoes(order: Clause, check: Clause) -> bool:
    """Whether an order only ends the state of what a check right before it asks: "if it's on, *turn it off*"."""
    is_ended = check.wording.state in (order.effects if check.wording.is_negated else order.needs)
    return is_ended and (order.names_same(check) or (order.is_of_it and not order.objects))


def _is_listed(clauses: Sequence[Clause], k: int) -> bool:
    """Whether an "and" adds an order to the one before, or leads to the end of the list that it begins."""
    later = clauses[k + 1 : k + 2]
    is_begun = not clauses[k].near and bool(later) and later[0].boundary == "," and later[0].near in _ADDING
    return clauses[k].near in _ADDING or (is_begun and later[0].sentence == clauses[k].sentence)


def _asks_no_more(check: Clause, order: Clause) -> bool:
    """Whether it asks how the thing of an order is, or what somebody does with "it", if nobody is there, or about the
    weather."""
    is_of_it = check.takes_up(order) or (check.names_same(order) and not check.says_there_is)
    is_of_it = is_of_it or (check.said_state[-1:] == ("it",) and not check.is_of_it)
    is_stated = check.wording.state is not None or bool(check.said_state)
    return check.is_of_weather or check.is_of_nobody or (is_of_it and is_stated)


def _is_unrelated(clause: Clause, order: Clause, check: Clause) -> bool:
    """Whether an order has nothing to do with another one and its case: it names another thing, does something else
    with it, and neither that weather nor anybody spoken of before calls for it."""
    known = order.nouns | check.nouns | order.thing | check.thing
    is_named = bool(clause.objects) and not clause.has_pronoun and known.isdisjoint(clause.nouns)
    is_alike = clause.verb == order.verb or (check.is_of_weather and _is_called_for(clause, check))
    is_more = "also" in clause.behind or clause.task.type == "informing" or order.is_forbidden or clause.is_forbidden
    return is_named and not (is_alike or is_more or _is_part(clause))


def _is_part(clause: Clause) -> bool:
    """Whether its thing may well be a part of another one, or stand in for it: "the lid", "a new bag", "her coat"."""
    return not _HOLDERS.isdisjoint(clause.objects) or not (_OWNING | _NEW).isdisjoint(clause.thing)


def _is_called_for(clause: Clause, weather: Clause) -> bool:
    """Whether an order may be one that the weather calls for: all but chores that neither cover nor close anything."""
    is_chore = clause.task.type == "change_state" and _SHELTERED.isdisjoint(clause.effects)
    return not is_chore or is_against(clause, weather)


def _take_beside(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int, outer: str) -> None:
    """Sets an order in a case, and what is listed on behind it in its sentence, beside that case."""
    side = sides[k]
    for j in range(k, len(clauses)):
        is_next = j == k or (goes_on(clauses, roles, sides, j, clauses[k].sentence) and clauses[j].near in _LISTING)
        if side not in (HOLDS, FAILS) or sides[j] != side or not is_next:
            return
        sides[j] = beside(outer)
