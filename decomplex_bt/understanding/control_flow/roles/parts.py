"""Parts: whether a check is a part of the condition before it, a mention of it, or a condition of its own."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, JOINTS, Wording
from decomplex_bt.understanding.control_flow.clause import FINDING, LEADING, PRESENT, Clause
from decomplex_bt.understanding.control_flow.contrasts import (
    is_apart_from,
    is_elsewhere_than,
    is_named_apart,
    is_of_another,
    is_of_one_of_both,
    is_of_other_matter,
    is_of_other_state,
    is_opposite_of,
    is_other_case_than,
    is_other_degree,
    joining_role,
)
from decomplex_bt.understanding.control_flow.outcomes import is_guard_of
from decomplex_bt.understanding.cue_phrases import WISHING

_HAVING = frozenset(("have", "get", "be"))
_WANTING = WISHING | {"need"}
_NONE_OF = frozenset(("one", "any"))
_STANDING_FOR = frozenset("none one any some more left drop bit lot answer sign reply".split())
"""What there is that may be what was named, or an answer to it, in other words."""


def join(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Checks under one "if" or "unless" are one condition of several parts, and so are a mention of one and a further
    case ("if he isn't, or if he's late, ...", "if not, or if he's late, ..."); an order to check is none of them
    ("close it if it's open and *see if the heating is on*"). What somebody cannot do is never ordered ("if it's locked
    *and you can't open it*, ...")."""
    is_closed = clauses[k].ends_sentence or clauses[k + 1].boundary != "none"  # not "if you cant fetch the ladder"
    if roles[k] == "task" and clauses[k].is_unable and is_closed:
        is_joined = clauses[k].wording.joins and roles[k - 1] in CONDITION_ROLES and not clauses[k].far
        is_led = not {"if", "whether"}.isdisjoint(clauses[k].near)
        roles[k] = clauses[k].wording.joins if is_joined else "condition" if is_led else roles[k]
    if roles[k - 1] in CONDITION_ROLES:
        roles[k] = joining_role(clauses[k], clauses[k - 1]) or roles[k]
    is_order = clauses[k].is_asked and not clauses[k].is_question and clauses[k].task.type == "check_state"
    if roles[k] in JOINTS and is_order and clauses[k - 1].is_check:
        roles[k] = "condition" if "mention" in roles[k + 1 :] else "task"
    if roles[k - 1] == "mention" and roles[k] in CONDITION_ROLES and is_other_case_than(clauses[k], clauses[k - 1]):
        roles[k] = "or"
    if roles[k] == "condition" and roles[:k] == ["condition", *["task"] * (k - 1)] and clauses[k].is_added_to_otherwise:
        roles[k] = "or"


def part(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """A check whose words are of another matter than those of all conditions before it is no mention of one, but a
    condition of its own; and then what an order to check asks is asked of nothing ("check if it is done, and if it's
    burnt, ..."). So is what is asked behind one of several orders of a case if that is needed ("is he home? If he is,
    pour the tea *and warm it if it's cold*, then ...")."""
    clause, before = clauses[k], clauses[k - 1]
    is_bare = roles[k] == "mention" and roles[k - 1] == "condition" and "mention" not in roles[k + 1 :]
    is_order_to_check = is_bare and before.is_asked and is_of_other_matter(clause, before)
    firsts = [clauses[j] for j in range(k) if roles[j] == "condition"]
    if is_order_to_check or (is_bare and is_of_other_state(clause, before)):
        roles[k - 1 : k + 1] = "task", "condition"
    elif roles[k] == "mention" and (
        (firsts and all(is_of_another(clause, first) for first in firsts)) or guards_own_order(clauses, roles, k)
    ):
        roles[k] = "condition"
    last = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), k)
    if roles[k] == "mention" and roles[last] == "mention" and is_named_apart(clause, clauses[last]):
        roles[k] = "condition"


def guards_own_order(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether clause `k` is a condition of the order right ahead alone, which is not the first of its case: "if he's
    home, pour the tea and warm it *if it's cold*". It asks whether that order is needed, or in what state a thing is
    that the orders of the case were the first to name. No condition before may ask of the same state, or leave open
    what it asks."""
    clause, order = clauses[k], clauses[k - 1]
    if k < 3 or clause.boundary != "none" or clause.near not in (("if",), ("unless",)):
        return False
    is_listed = tuple(roles[k - 2 : k]) == ("task", "task") and clauses[k - 2].sentence == clause.sentence
    last = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if not is_listed or last is None or clauses[last].sentence != clause.sentence or "if" not in clauses[last].near:
        return False
    firsts = [clauses[j] for j in range(k) if roles[j] in CONDITION_ROLES]
    state = clause.wording.state
    is_open = any(c.leaves_open and not c.is_question for c in firsts)
    is_other = state is not None and all(state not in (c.wording.state, c.wording.opposite) for c in firsts)
    named = next((clauses[j] for j in range(k - 1, last, -1) if clauses[j].objects), None)
    is_new = named is not None and all(frozenset(named.objects).isdisjoint(c.nouns) for c in firsts)
    is_own = is_guard_of(clause, order) or (is_new and clause.is_of_it and order.task.type == "change_state")
    return is_other and not is_open and is_own


def look_over(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """In what state a place is where something may be looked for is no outcome of a look at it ("check the oven. *If
    it's on*, turn it off")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first != k - 1 or (roles[first], roles[k]) != ("condition", "mention"):
        return
    search, clause = clauses[first], clauses[k]
    is_bare = search.task.type == "searching" and not search.objects and not search.has_pronoun and bool(search.places)
    is_of_state = clause.is_check and clause.wording.state is not None and clause.wording.state not in PRESENT
    if is_bare and is_of_state and clause.is_of_it and not clause.objects:
        roles[first : k + 1] = "task", "condition"


_TAKEN = frozenset(("occupied", "taken", "engaged"))
"""How a place is where somebody is."""
_RAINLESS = frozenset(("dry", "fine"))
"""How it is when it is not raining."""


def oppose(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What tests the opposite of the condition before, of the same thing, is a mention of it, be that thing an "it" in
    both, with no other one named between ("bring it in if it's wet, and *leave it out when it's dry*")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[k] != "condition" or {"if", "when"}.isdisjoint(clause.near):
        return
    before, between = clauses[first], clauses[first + 1 : k]
    is_of_it = clause.is_of_same_it(before) and bool(between) and not any(one.objects for one in between)
    is_turned = clause.wording.is_opposite_of(before.wording) or before.wording.is_opposite_of(clause.wording)
    is_turned = is_turned and not (clause.wording.is_negated or before.wording.is_negated)
    is_next = clause.boundary == "none" and clause.sentence == before.sentence and not is_other_degree(clause, before)
    is_weather = before.is_of_weather and not clause.objects and (clause.is_of_it or not clause.has_pronoun)
    is_rainless = not _RAINLESS.isdisjoint(clause.said_state[:1])  # "if it's dry out"
    is_weather = is_weather and is_rainless and (bool(between) or before.is_question)
    is_weather = is_weather and before.wording.state == "raining" and not clause.says_still
    are_stated = not (clause.wording.is_negated or before.wording.is_negated)
    if is_opposite_of(clause, before) or (is_of_it and is_turned and is_next) or (is_weather and are_stated):
        roles[k] = "mention"


def be_occupied(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That a place is occupied says that somebody is there ("is anybody in the study? ... *If it's occupied*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] not in ("condition", "mention") or roles[k] != "condition":
        return
    clause, check = clauses[k], clauses[first]
    is_taken = clause.is_check and clause.is_of_it and not clause.objects and clause.wording.state in _TAKEN
    if is_taken and check.wording.is_of_anybody and bool(check.places):
        roles[k] = "mention"


def lack(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That there is none of what an order in a case needs is no mention of that case, which tests how a thing is ("if
    the lamp is broken, change the bulb, and *if you don't have one*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or (roles[first], roles[k]) != ("condition", "mention"):
        return
    clause, check = clauses[k], clauses[first]
    is_none = clause.wording.is_negated and clause.verb in _HAVING and not _NONE_OF.isdisjoint(clause.thing)
    is_none = is_none and not clause.objects and "if" in clause.near and not clause.says_too
    is_of_state = check.is_check and bool(check.said_state) and check.number == "one" and not check.says_there_is
    is_done = any(clauses[j].task.type != "informing" for j in range(first + 1, k))
    if is_none and is_of_state and is_done and not check.is_of_whereabouts and check.wording.state not in PRESENT:
        roles[k] = "condition"


def lack_ordered(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That there is none of what is to be fetched in a case tells of the order to fetch it, not of the case ("if Lea is
    thirsty, bring her a juice, and *if there isn't any*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] != "condition" or roles[k] not in ("mention", "condition"):
        return
    clause, order, check = clauses[k], clauses[k - 1], clauses[first]
    is_fetched = roles[k - 1] == "task" and order.task.type in FINDING and not (order.is_forbidden or order.turns)
    is_supply = check.says_there_is or check.is_of_whereabouts or check.is_of_any or check.verb == "have"
    is_case = check.is_check and (bool(check.said_state) or check.verb in _WANTING) and not is_supply
    is_named = check.wording.state in PRESENT or bool(clause.places) or not {"if"} <= {*clause.near}
    if is_fetched and is_case and not is_named and clause.sentence - order.sentence <= 1 and _is_lacking(clause, order):
        roles[k - 1 : k + 1] = "condition", "mention"


def _is_lacking(clause: Clause, order: Clause) -> bool:
    """Whether it says that there is none of what an order names: "if there are none left", "if we don't have any", "if
    we're out of it"."""
    is_none = clause.wording.is_negated and clause.verb in _HAVING and not clause.says_too
    is_none = is_none and clause.boundary != "none" and not clause.is_of_person
    of_what = (clause.said_state[2:] if clause.said_state[:2] == ("out", "of") else ()) or ("it",)
    is_same = of_what[-1] in ("it", "them") or any(of_what[-1].startswith(noun) for noun in order.nouns)
    is_out = clause.wording.is_contrary and clause.said_state[:1] == ("out",) and is_same and not clause.is_of_person
    is_of_some = not _NONE_OF.isdisjoint(clause.thing) or (
        clause.says_there_is and not (clause.objects or clause.thing)
    )
    return clause.is_check and ((is_none and is_of_some) or is_out)


def ask_of_person(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What somebody does not do, right behind an order about it, is no mention of what something else does not do ("if
    the alarm doesn't ring, wake Tom, and call me *if he doesn't get up*")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[k] != "mention" or roles[first] != "condition" or "mention" in roles[k + 1 :]:
        return
    clause, check = clauses[k], clauses[first]
    is_behind = clause.boundary == "none" and clause.near[:1] == ("if",) and clause.is_of_person and clause.is_check
    is_of_thing = check.is_check and check.verb != clause.verb and not check.is_of_somebody and bool(check.objects)
    is_named = any(clauses[j].may_be_of_person and clauses[j].objects for j in range(first + 1, k))
    if is_behind and is_of_thing and is_named and check.number:
        roles[k] = "condition"


def look_after(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What an order to check leaves open is asked right behind it ("check on the baby. *If she's crying*, ...")."""
    clause, check = clauses[k], clauses[k - 1]
    is_asked = clause.is_check and clause.has_pronoun and not clause.objects and bool(clause.said_state)
    is_open = not check.is_question and check.leaves_open and roles[k - 1] in ("condition", "task")
    if is_asked and is_open and clause.near == ("if",) and roles[k] == "condition":
        roles[k - 1 : k + 1] = ["condition", "mention"]


def take_up(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Where one of two conditions that "and" joins is spoken of again alone, the second is asked where the first
    holds."""
    part = taken_up(clauses, roles, k)
    if part is not None:
        second = part if roles[part] == "and" else part + 1
        roles[second] = "condition" if roles[second] == "and" else roles[second]


def taken_up(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """Of two conditions that "and" joins the one that mention `k`, which names nothing, is of: the one that asks for
    its state, or the opposite, or, where it says "there", for a place ("if he is in his room and he's awake, ...; *if
    he's asleep*, ...", "...; *if he isn't there*, ..."); else None."""
    clause = clauses[k]
    second = next((j for j in range(k - 1, 0, -1) if roles[j] != "task"), 0)
    first = second - 1
    if first < 0 or roles[first] != "condition" or roles[second] not in ("condition", "and") or roles[k] != "mention":
        return None
    if clauses[second].wording.joins != "and":
        return None
    if clause.objects:  # "if *the blinds* are open, ..."
        named = [j for j in (first, second) if clause.names_same(clauses[j])]
        is_one = len(named) == 1 and _are_of_one_state(clauses[named[0]].wording, clause.wording)
        return named[0] if is_one and clause.wording.state is not None else None
    if not clause.has_pronoun:
        return None
    if clause.wording.state is not None:
        fitting = [j for j in (first, second) if _are_of_one_state(clauses[j].wording, clause.wording)]
    else:
        fitting = [j for j in (first, second) if clauses[j].is_of_whereabouts and "there" in clause.places]
    return fitting[0] if len(fitting) == 1 else None


def _are_of_one_state(one: Wording, other: Wording) -> bool:
    return one.state == other.state or one.is_opposite_of(other) or other.is_opposite_of(one)


def name_other(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether there is something that was not spoken of is no mention of what state another thing is in ("check whether
    the timer is on; if *there are five minutes* left, ..."), but what is in a thing tells whether it is empty ("if the
    bath is empty, ...; if *there's still water in it*, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] != "mention" or first is None or not (clause.says_there_is and clauses[first].said_state):
        return
    if clauses[first].wording.state == "empty":
        return
    named = {noun for before in clauses[:k] for noun in (*before.nouns, *before.thing)}
    if clause.objects and named.isdisjoint(clause.objects) and _STANDING_FOR.isdisjoint(clause.objects):
        roles[k] = "condition"


def find_nobody(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That nobody is in a place is no failure of an order that has nothing to do with it ("wash the pan. If nobody is
    in the study, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] != "mention" or first is None or not is_apart_from(clauses[k], clauses[first]):
        return
    roles[k] = "condition"
    if roles[first] == "condition" and "mention" not in roles[first + 1 :]:
        roles[first] = "task"


def find_other(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That something cannot be found which was not spoken of is no failure of an order that looks for nothing ("wash
    the pan. If you can't find *the phone*, ..."), nor the other side of its case ("lock it if it's shut. If you can't
    find *the key*, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    is_found = roles[k] == "mention" and clause.task.type == "searching" and not clause.has_pronoun
    if first is None or roles[first] != "condition" or not (is_found and clause.objects):
        return
    order = clauses[first]
    known = {noun for before in clauses[:k] for noun in (*before.nouns, *before.thing)} | _STANDING_FOR
    is_case = order.is_check and bool(order.said_state) and order.is_trailing
    if not (is_case or order.task.type in LEADING | {"change_state"}) or not known.isdisjoint(clause.objects):
        return
    roles[k] = "condition"
    if "mention" not in roles[first + 1 :] and not is_case:
        roles[first] = "task"


def miss_anywhere(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That something cannot be found is asked where it is in neither of two places ("if it's in the hall, bring it, if
    it's in the car leave it, *and if you can't find it*, ...")."""
    if missed_anywhere(clauses, roles, k) is not None:
        roles[k - 1 : k + 1] = "condition", "condition"


def missed_anywhere(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """The first of two places of one thing that are asked, the second right ahead of clause `k`, which says that it
    cannot be found; else None."""
    clause, second = clauses[k], clauses[k - 1]
    is_missed = clause.task.type == "searching" and clause.wording.is_negated and clause.is_of_it
    first = next((j for j in range(k - 2, -1, -1) if roles[j] == "condition"), None)
    if first is None or not (is_missed and "if" in clause.near and k + 1 < len(clauses)) or clauses[first].is_asked:
        return None
    is_second = second.is_check and "if" in second.near and is_elsewhere_than(second, clauses[first])
    is_plain = all(role == "task" for role in roles[first + 1 : k - 1]) and "mention" not in roles[k + 1 :]
    return first if is_second and is_plain else None


def lack_one(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That there is none of one of two things does not tell how the look for both went ("look for flour and sugar, *and
    if we don't have any sugar*, ...")."""
    is_mention = roles[k - 1 : k + 1] in (["condition", "mention"], ["condition", "condition"])
    if is_mention and "mention" not in roles[k + 1 :] and is_of_one_of_both(clauses[k], clauses[k - 1]):
        roles[k - 1 : k + 1] = "task", "condition"


def find_neither(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Of two things to be found out one does where it is said in which case neither holds, or either ("is it in the
    hall? Is it in the shed? *If neither*, ...")."""
    if are_asked_of_both(clauses, k) and roles[k - 1] in CONDITION_ROLES:
        roles[k] = "or"


def are_asked_of_both(clauses: Sequence[Clause], k: int) -> bool:
    """Whether clause `k` and the one before say what is to be found out, and the one behind is for where neither holds,
    or either; where to look for what the one before says to find is no second thing ("find my cap. *Look in the hall or
    in the shed*. If it's in neither, ...")."""
    first, second = clauses[k - 1 : k + 1]
    are_searches = first.task.type == second.task.type == "searching"
    if are_searches and not (first.places or second.objects):
        return False
    is_of_both = k + 1 < len(clauses) and bool(clauses[k + 1].of_both)
    return is_of_both and first.is_finding_out and (second.is_finding_out or second.is_check)


def tell_of_both(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Of two things that are to be checked somebody is told whatever they are ("check whether the door is shut and the
    stove is off, *and tell me*")."""
    if roles[k] == "task" and "mention" not in roles[k + 1 :] and is_told_of_both(clauses, k):
        roles[k - 2 : k] = "task", "task"


def is_told_of_both(clauses: Sequence[Clause], k: int) -> bool:
    """Whether it only says to tell somebody, right behind an order to check two things, set off by a comma."""
    if k < 2:
        return False
    first, second, report = clauses[k - 2 : k + 1]
    are_checked = first.is_asked and not first.is_question and "whether" in first.behind
    are_checked = are_checked and second.near[:2] == ("whether", "and") and second.boundary == "none"
    is_told = report.task.type == "informing" and report.near == ("and",) and report.boundary == ","
    return are_checked and is_told and report.sentence == first.sentence
