"""Scopes: how far a condition reaches among the orders around it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.contrasts import (
    asks_same_of_another,
    is_besides,
    is_elsewhere_than,
    is_lack_of,
    is_of_other_matter,
    is_other_degree,
    is_other_end,
    is_other_weather,
    is_other_wish,
    is_rival_of,
)
from decomplex_bt.understanding.control_flow.outcomes import answers_ring, comes_through
from decomplex_bt.understanding.control_flow.roles.replies import ends_of_case, waits_out
from decomplex_bt.understanding.control_flow.sides.labels import (
    FAILS,
    HOLDS,
    PARTING,
    TURNING,
    beside,
    goes_on,
)

_IFS = frozenset(("if", "when"))
_ENDING = frozenset((".", "?", "!"))
_ALL = frozenset(("everything", "anything", "all"))
_GOING_ON = frozenset(("and", "but", "can"))
_WANTING = frozenset("cold hungry thirsty tired sleepy bored lonely hot peckish chilly".split())
"""States in which somebody wants something, of which one keeps none from another."""
_CALLING = frozenset("call ring phone knock buzz come arrive text message visit".split())
_RUNG = frozenset("doorbell bell phone door intercom buzzer".split())
"""What rings without telling who it is."""


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
    is_turned = bool(clauses[first].turns) or "fail" in leading  # not "unless I say *otherwise*, ..."
    if is_own and is_turned and not CONDITION_ROLES.isdisjoint(roles[:first]):
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
    if is_added and is_other_weather(clause, clauses[first]) and first < k - 1 and sides[k] == HOLDS:
        sides[k] = beside(sides[first])
    if not is_of_other_matter(clause, clauses[first]):
        return
    if first == k - 1:
        sides[k] = HOLDS
    elif sides[k - 1] in (HOLDS, FAILS) and sides[k - 1] != sides[k]:
        sides[k] = "top"


def wait_for(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done when something is so that is only waited for is done where that is ("turn it on if it's off, then
    run a bath, and *when it's ready* tell me"); in any case, where that is what the order before was for ("if the oven
    isn't hot, turn it on. *When it is hot*, put the pie in")."""
    awaited, clause = clauses[k - 1], clauses[k]
    is_awaited = (roles[k - 1], roles[k]) == ("task", "task") and awaited.is_check and "when" in awaited.near
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if is_awaited and first is not None and first < k - 2 and awaited.boundary in PARTING:
        one, other = clauses[first].wording, awaited.wording
        is_same = one.state == other.state or one.is_opposite_of(other) or other.is_opposite_of(one)
        if is_same and comes_through(awaited, clauses[k - 2]) and sides[k - 1][:2] == "<1":
            sides[k - 1] = beside(sides[first])
    is_next = clause.sentence == awaited.sentence and not clause.near and not clause.far
    if is_awaited and is_next and sides[k - 1] == "top" and sides[k] in (HOLDS, FAILS):
        sides[k] = "top"


def wait_till_over(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done once a case is over is done in any case ("if he's asleep, leave the lamp on. *Once he's awake, turn
    it off*")."""
    awaited, clause = clauses[k - 1], clauses[k]
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    is_awaited = (roles[k - 1], roles[k]) == ("task", "task") and awaited.is_check and awaited.boundary in PARTING
    if first is None or first == k - 2 or not is_awaited or awaited.near not in (("when",), ("after",)):
        return
    one, other = clauses[first].wording, awaited.wording
    is_over = other.is_opposite_of(one) or (other.is_contrary and not one.is_contrary)
    is_over = is_over and awaited.has_pronoun and clause.sentence == awaited.sentence and not clause.near
    if is_over and sides[k] == sides[k - 1] in (HOLDS, FAILS):
        sides[k - 1] = sides[k] = beside(sides[first])


def ask_anew(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A question of its own about another thing, behind what was done in a case, or behind another that nothing goes
    by, is asked in any case ("Window open? Close it. *Baby awake?* Feed her", "is the kettle on? *Are the cups clean?*
    If they are, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[k] != "condition" or sides[k][:2] != "<1":
        return
    is_echoed = k + 1 < len(clauses) and roles[k + 1] == "mention" and clauses[k + 1].says_only_whether
    if roles[k - 1] != "task" and not (roles[k - 1] == "condition" and is_echoed):
        return
    is_plain = clause.is_question and not (clause.far or clause.near) and clause.boundary in _ENDING
    known = {word for before in clauses[first:k] for word in (*before.nouns, *before.thing)}
    is_of_other = bool(clause.thing) and not clause.has_pronoun and known.isdisjoint(clause.thing)
    if is_plain and is_of_other and clauses[first].is_question:
        sides[k] = "top"


def turn_away(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What a sentence with a "now" or the like opens hangs on no condition before ("if Ann asks, I'm out. *Now bring me
    the tea*"), nor is it asked in one ("*separately*, if it's dry, ...")."""
    if clauses[k].is_new_matter and sides[k][:2] == ">1":  # "third, close it *unless it's closed already*"
        asked = next((j for j in range(k + 1, len(clauses)) if roles[j] == "condition"), k)
        is_own = asked > k and clauses[asked].sentence == clauses[k].sentence
        sides[asked] = "top" if is_own and sides[asked] in (HOLDS, FAILS) else sides[asked]
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
    give it to her, but if she's at lunch, ..."), and so is a "but" of other weather; whether it is another thing, or is
    so instead, or so in too low a degree and not too high a one, never where the first holds ("if it's the phone, ...,
    *if it's the doorbell*, ..."); that they ask for more, in any case."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[first], roles[k]) != ("condition", "condition"):
        return
    check = clauses[first]
    if first == k - 1 and not (is_other_end(clause, check) and clause.sentence != check.sentence):
        return  # but "Is it warm enough? *If it's too cold*, heat it." is asked of the other side
    is_led = not _IFS.isdisjoint(clause.near) and clause.boundary != "none" and "or" not in clause.near
    is_rival = is_rival_of(clause, check) or is_other_degree(clause, check)
    if is_led and is_rival and clause.says_instead and clause.near == ("and", "if"):  # and no exception: "but if"
        sides[first + 1 : k] = [HOLDS if side in (">1+", ">1-") else side for side in sides[first + 1 : k]]
    if is_led and is_rival and sides[k] == HOLDS:
        sides[k] = FAILS
    elif is_led and is_other_wish(clause, check) and sides[k] == HOLDS:
        sides[k] = beside(sides[first])
    is_contrast = is_elsewhere_than(clause, check) or is_other_weather(clause, check)
    if not {"but", "if"} <= {*clause.far, *clause.near} or not is_contrast:
        return
    if sides[k] in (HOLDS, "top") and all(sides[j] in (HOLDS, ">1+", ">1-") for j in range(first + 1, k)):
        sides[first + 1 : k] = [HOLDS] * (k - first - 1)
        sides[k] = FAILS


def contrast(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """A "but if" that asks the same of somebody or something else is asked where the first does not hold ("if Ann is
    home, give her the letter, *but if Tom is home*, ..."), one that asks what another one does in any case
    ("if the dog barks, ..., *but if the cat miaows*, ...")."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or (roles[first], roles[k]) != ("condition", "condition"):
        return
    check, between = clauses[first], range(first + 1, k)
    is_there = clause.says_there_is and bool(check.identified) and not clause.is_of_nobody
    is_led = clause.near == ("but", "if", *["there"] * is_there) and clause.boundary == ","
    is_led = is_led and check.near[-1:] == ("if",)
    is_one = check.sentence == clause.sentence and all(sides[j] in (HOLDS, ">1-", ">1+") for j in between)
    if not (is_led and is_one) or sides[k] not in (HOLDS, FAILS) or check.wording.is_negated:
        return
    is_rival = asks_same_of_another(clause, check) or (clause.asks_who and check.asks_who) or is_there
    is_other = bool(clause.objects) and check.nouns.isdisjoint(clause.nouns) and clause.verb != check.verb
    is_other = is_other and not (clause.has_pronoun or clause.places or clause.is_of_weather)
    is_other = is_other and not (check.said_state or clause.said_state) and "be" not in (clause.verb, check.verb)
    if is_rival or is_other:
        for j in between:
            sides[j] = HOLDS
        sides[k] = FAILS if is_rival else beside(sides[first])


def ask_alike(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is asked alike of something else is asked whether the case before holds or not ("if the vet calls, bring me
    the phone, *and if the salesman calls*, ...", "if there is a parcel, bring it in; *should there be letters*, ..."),
    and what it is where it is not the other ("if it's Ann, ..., *if it's Tom*, ..."); not what is so "as well"."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or (roles[first], roles[k], sides[k]) != ("condition", "condition", HOLDS):
        return
    check, between = clauses[first], range(first + 1, k)
    is_led = "if" in clause.near and clause.boundary != "none" and {"if", "and", "there"}.issuperset(clause.near)
    is_plain = not ("also" in clause.behind or clause.says_still or check.wording.is_negated or clause.has_pronoun)
    is_plain = is_plain and not clause.wording.is_negated and all(sides[j] == HOLDS for j in between)
    if not (is_led and is_plain) or any(not clauses[j].nouns.isdisjoint(clause.nouns) for j in between):
        return
    are_there = clause.says_there_is and (check.says_there_is or check.is_of_whereabouts)
    is_placed = any(kind == "location" for kind, _ in clause.task.arguments)  # not "if there's money *in it*"
    are_there = are_there and (bool(clause.places) or not is_placed) and clause.places <= check.places
    are_there = are_there and check.nouns.isdisjoint(clause.objects)
    if are_there or (asks_same_of_another(clause, check) and clause.verb != "be"):
        sides[k] = beside(sides[first])
    elif asks_same_of_another(clause, check) and clause.identified and check.identified:
        sides[k] = FAILS


def identify(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Whether it is somebody else than the one who is excepted is asked beside that ("open unless it's the salesman.
    *If it's the courier*, ...")."""
    first, clause = clauses[k - 1], clauses[k]
    is_next = (roles[k - 1], roles[k]) == ("condition", "condition") and clause.boundary in PARTING
    is_apart = clause.asks_who and first.asks_who and "unless" in first.near and set(clause.objects) != {*first.objects}
    if is_next and is_apart and clause.near == ("if",) and sides[k] in (HOLDS, FAILS):
        sides[k] = beside(sides[k - 1])


def tell_who(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Who it is that calls is asked where somebody does ("if the bell rings, ... *If it's Tom*, ..."), and whether it
    is somebody else where the one who was named does not ("if my mother calls, ... *If it's my boss*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[first], roles[k]) != ("condition", "condition") or first == k - 1:
        return
    clause, check = clauses[k], clauses[first]
    is_led = bool(clause.identified) and {*clause.near} <= {"if", "when", "and", "but"} and not clause.is_trailing
    is_call = check.is_check and check.verb in _CALLING and not check.wording.is_negated and "unless" not in check.near
    if is_led and is_call and not clause.wording.is_negated and sides[k] in ("top", HOLDS, FAILS):
        sides[k] = HOLDS if _RUNG.issuperset(check.objects) else FAILS


def lack(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """That there is none of what a case tests a state of is asked besides it, and the orders of that are of no other
    ("if the milk is warm, give it to the cat. *If there's no milk*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[first], roles[k]) != ("condition", "condition") or first == k - 1:
        return
    if is_lack_of(clauses[k], clauses[first]) and clauses[k].boundary in PARTING:
        sides[first + 1 : k] = [HOLDS if side[:2] == ">1" else side for side in sides[first + 1 : k]]
        sides[k] = beside(sides[first]) if sides[k] == HOLDS else sides[k]


def leave_rest(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with everything else than what a case spoke of, in a clause of its own, is done in any case ("if
    there's a letter, bring it; *leave everything else* on the mat", "if there's anything for me, bring it. Bin *the
    rest*"), and so is what a comma adds to its sentence where only what the case found was seen to ("if any cup is
    cracked, bring it here, *and put the rest away*"), not "if the shopping has come, put the milk away and leave
    the rest"."""
    clause = clauses[k]
    is_all = "else" in clause.thing and not _ALL.isdisjoint(clause.thing)
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), k)
    is_of_some = not _ALL.isdisjoint(clauses[first].thing) and clause.objects == ("rest",)
    is_rest = roles[k] == "task" and (is_all or is_of_some)
    if is_rest and clause.boundary in PARTING and sides[k] == HOLDS:
        sides[k] = "top"
    is_found = clauses[first].names_any or (is_all and clauses[first].says_there_is)  # not "the rest" of a cake
    is_of_it = first == k - 2 and clauses[k - 1].has_pronoun and not clauses[k - 1].objects and is_found
    is_left = (
        roles[k] == "task"
        and (is_all or clause.objects == ("rest",))
        and _GOING_ON.issuperset({*clause.near} - ({"else"} if is_all else set()))
    )
    is_set_off = clause.boundary in (",", *PARTING) and not clauses[first].wording.is_negated
    if is_left and is_of_it and is_set_off and sides[k] in (HOLDS, FAILS):
        sides[k] = beside(sides[first])


def ask_besides(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What else is the matter with a thing is asked in any case, where nothing but that was spoken of since ("if the
    stove is on, turn it off. *If it's smoking*, open the hatch")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or (roles[first], roles[k]) != ("condition", "condition") or first == k - 1:
        return
    clause, check, between = clauses[k], clauses[first], clauses[first + 1 : k]
    is_led = clause.boundary in PARTING and clause.near == ("if",) and check.near[-1:] == ("if",) and not clause.far
    is_state = clause.is_check and check.is_check and len(clause.said_state) == len(check.said_state) == 1
    is_state = is_state and "also" not in clause.behind and not any(later.turns for later in clauses[k:])
    is_of_it = clause.is_of_it and not clause.objects and clause.number == check.number == "one" and bool(check.objects)
    is_one = is_of_it and all(c.has_pronoun or not c.objects or c.names_same(check) for c in between)
    if is_led and is_state and is_one and is_besides(clause, check) and sides[k] in (HOLDS, FAILS):
        sides[k] = beside(sides[first])


def wait_in_case(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What an order in a case is to come to is waited for in that case ("start the dryer if Tom is home. *When it's
    done*, ...")."""
    if roles[k] == "condition" and ends_of_case(clauses, roles, k) and sides[k - 2] in (">1+", ">1-"):
        sides[k] = f"<1{sides[k - 2][2:]}"


def wait_out(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is waited for in a case is so after that in any, and what follows is done then ("if it isn't hot, wait. *As
    soon as it is*, bring it", "if it isn't hot, wait a minute. *Then bring it*")."""
    clause, before = clauses[k], clauses[k - 1]
    first = k - 1
    if k > 1 and roles[k - 1] == "task" and waits_out(clauses, roles, k - 1):
        first, sides[k - 1] = k - 2, HOLDS
    is_then = clause.is_past_wait and clause.near[:1] == ("then",) and clause.sentence == before.sentence + 1
    is_awaited = first < k - 1 and clause.sentence == before.sentence
    if roles[first] != "condition" or not (is_then or is_awaited):
        return
    for j in range(k, len(clauses)):
        if not (j == k or goes_on(clauses, roles, sides, j, clause.sentence)) or sides[j] not in (HOLDS, FAILS):
            return
        sides[j] = beside(sides[first])


def ask_of_needs(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Whether somebody wants something else as well is asked in any case ("if she's cold, bring her a shawl, *and if
    she's hungry*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or roles[k] != "condition":
        return
    clause, check = clauses[k], clauses[first]
    is_led = clause.near == ("and", "if") and check.near[-1:] == ("if",) and sides[k] in (HOLDS, FAILS)
    is_led = is_led and "also" not in clause.behind
    is_same = (
        clause.is_of_somebody and not clause.objects and not (clause.wording.is_negated or check.wording.is_negated)
    )
    said, other = frozenset(clause.said_state), frozenset(check.said_state)
    head = next((j for j in range(first, -1, -1) if roles[j] == "condition"), first)
    if is_led and is_same and said & _WANTING and other & _WANTING and not said & other:
        sides[k] = beside(sides[head])


def do_too(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done "too" in a further case is so whether the case before held or not ("if the bike is there, bring it,
    if the scooter is there, bring that *too*"), and comes on top of an order ("sweep the yard, *then, if it's dry*, the
    porch *too*")."""
    if k + 1 < len(clauses) and tuple(roles[k - 1 : k + 2]) == ("task", "condition", "task"):
        clause, order = clauses[k], clauses[k + 1]
        is_next = "then" in (*clause.far, *clause.near) and clauses[k - 1].sentence == clause.sentence == order.sentence
        if is_next and "also" in (*order.near, *order.behind) and sides[k + 1] == HOLDS and sides[k - 1][:2] == ">1":
            sides[k - 1] = "top"
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or k + 1 >= len(clauses) or (roles[k], roles[k + 1]) != ("condition", "task"):
        return
    clause, order = clauses[k], clauses[k + 1]
    leading = {*clause.near} - ({"not"} if clause.is_of_nobody else set())
    is_plain = {"and", "if"} >= leading >= {"if"} and not {*clause.far} & TURNING
    is_too = "also" in (*order.near, *order.behind) and order.sentence == clause.sentence == clauses[k - 1].sentence
    is_other = bool(clause.objects) and clause.thing != clauses[first].thing
    if is_plain and is_too and is_other and sides[k] == FAILS:
        sides[k] = beside(sides[first])
    asked = first - 1  # "is it on? If it is, ...", not "..., if it isn't, ... and if it's raining, ... as well"
    is_answered = first > 0 and (roles[asked], roles[first], sides[asked]) == ("condition", "mention", "top")
    is_answered = is_answered and not clause.has_pronoun and not clause.names_same(clauses[asked])
    if is_plain and is_too and is_answered:
        sides[k] = "top"


def be_too_much(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """That something is too heavy for it is asked where it cannot be done ("if you can lift the box, carry it up, *and
    if it's too heavy*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or (roles[first], roles[k]) != ("condition", "condition"):
        return
    clause, check = clauses[k], clauses[first]
    is_too = clause.said_state[:1] == ("too",) and not clause.wording.is_negated and "if" in clause.near
    if is_too and check.ability == "asked" and clause.has_pronoun and sides[k] == HOLDS:
        sides[k] = FAILS


def answer_ring(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """That nobody answers is asked where somebody was rung or knocked for ("if the door is shut, ring the bell; *if
    nobody answers*, ...")."""
    if (roles[k - 1], roles[k]) == ("task", "condition") and answers_ring(clauses[k], clauses[k - 1]):
        sides[k] = sides[k - 1] if sides[k - 1] in ("top", HOLDS, FAILS) else sides[k]
