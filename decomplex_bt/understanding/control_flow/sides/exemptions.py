"""Exemptions: what is ordered in any case, though a case told behind it has something done."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.openings import ITS
from decomplex_bt.understanding.control_flow.outcomes import is_cleared
from decomplex_bt.understanding.control_flow.sides.labels import CARRYING, FAILS, HOLDS, MOVING, PARTING, TURNING

_RETURNING = frozenset(("back", "home"))
_GOING = frozenset(("following", "motion"))
_SENT = frozenset(("bringing", "following", "motion"))
_LOSING = frozenset("drop spit spill lose eat finish drink swallow throw break".split())
"""Deeds by which somebody no longer has what they got."""
_ANOTHER = (frozenset(("another",)), frozenset(("one",)))
_MOVED = MOVING | {"change_state", "taking"}
_ROOMS = frozenset(
    "kitchen bathroom bedroom hall hallway study office garage room nursery laundry lounge cellar attic basement "
    "pantry shed terrace balcony garden patio ward".split()
)


def have_in_either_case(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is fetched is fetched where both of two opposite cases, told in a sentence of their own, say what is then
    done with it ("bring in some logs. *If they're wet*, leave them here; *if they're dry*, put them in the basket")."""
    if (roles[k - 1], roles[k]) != ("task", "condition") or sides[k - 1] != ">1-":
        return
    order, check = clauses[k - 1 : k + 1]
    second = next((j for j in range(k + 1, len(clauses)) if roles[j] != "task"), k + 1)
    if second + 1 >= len(clauses) or roles[second] != "mention" or check.boundary not in PARTING:
        return
    are_cases = check.near == ("if",) and clauses[second].near[-1:] == ("if",) and roles[second + 1] == "task"
    is_of_it = check.takes_up(order) or check.names_same(order)
    are_done = all(
        c.has_pronoun and not c.objects and c.task.type in _MOVED for c in (clauses[k + 1], clauses[second + 1])
    )
    if are_cases and is_of_it and are_done and order.task.type in CARRYING and not order.is_forbidden:
        sides[k - 1] = "top"


def go_along(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Who is to come with what was fetched comes with what is fetched *instead* of it, too ("get the lamp and *follow
    me to the barn*. If the lamp is dead, take a candle instead")."""
    if k < 2 or tuple(roles[k - 2 : k + 2]) != ("task", "task", "condition", "task"):
        return
    fetched, way, check, other = clauses[k - 2 : k + 2]
    is_way = way.task.type in _GOING and way.near == ("and",) and not (way.is_forbidden or fetched.is_forbidden)
    is_fetched = fetched.task.type in CARRYING and bool(fetched.objects) and fetched.sentence == way.sentence
    is_of_thing = check.names_same(fetched) or (check.is_of_it and not check.objects and check.number == fetched.number)
    is_led = check.boundary in PARTING | {"?"} and check.near == ("if",) and check.is_check and not check.places
    is_instead = other.task.type in CARRYING and "instead" in (*other.near, *other.behind) and bool(other.objects)
    is_instead = is_instead and not other.names_same(fetched) and not (other.receivers or other.has_pronoun)
    is_open = sides[k - 2] in (">1-", "top") and sides[k - 1 : k + 2] == [">1-", "top", HOLDS]
    if is_way and is_fetched and is_of_thing and is_led and is_instead and is_open:
        sides[k - 2 : k] = ">1-", "top"


def clear_way(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """An order is carried out though something is in its way that is then undone ("take the bin out. If the gate is
    locked, *unlock it*")."""
    if (sides[k - 1], sides[k]) == (">1-", "top") and (is_cleared(clauses, roles, k) or _is_emptied(clauses, roles, k)):
        sides[k - 1] = "top"


def _is_emptied(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether what stands where something is to be put is put elsewhere in its case ("put the plates on the table; if
    there are papers on the table, *put them in the box*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return False
    order, check, other = clauses[k - 1 : k + 2]
    is_in_way = check.says_there_is and bool(check.objects) and not check.wording.is_negated
    is_in_way = is_in_way and not check.places.isdisjoint(order.receivers) and order.nouns.isdisjoint(check.objects)
    is_led = check.boundary in PARTING and check.near[:1] == ("if",) and order.task.type in MOVING
    is_removed = other.task.type in CARRYING and other.is_of_it and other.number in ("", check.number)
    return is_in_way and is_led and is_removed and "instead" not in (*other.near, *other.behind)


def go_besides(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is fetched, brought or put somewhere is so though a sentence of its own tells a case of another thing, in
    which yet another thing is done, or nothing but said where something is ("take the coats up. If Nan is asleep,
    *close her door*", "... If the door is locked, *the key is in the drawer*")."""
    order, check = clauses[k - 1 : k + 1]
    is_behind = (roles[k - 1], roles[k]) == ("task", "condition") and check.boundary in (".", "!")
    is_led = is_behind and check.near[:1] == ("if",) and check.is_check
    if not is_led or sides[k - 1][:2] != ">1" or order.is_forbidden:
        return
    if check.ends_sentence and check.tells_where and not check.calls_off:
        sides[k - 1] = "top"
    if sides[k - 1] != ">1-":
        return
    if check.ends_sentence or k + 1 >= len(clauses) or roles[k + 1] != "task" or not check.objects:
        return
    if order.task.type not in CARRYING or (check.says_there_is and check.wording.is_negated):
        return
    known = order.nouns | order.places | order.receivers
    other = clauses[k + 1]
    is_apart = known.isdisjoint(check.nouns) and not other.has_pronoun and known.isdisjoint(other.nouns)
    is_other = other.task.type in ("change_state", "informing") and not {*other.far, *other.near} & TURNING
    if is_apart and is_other and "instead" not in other.behind and not check.is_of_weather:
        sides[k - 1] = "top"


def let_other_be(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is ordered is done though nothing is in a case but that another thing may be as it is ("wash the plates, and
    *if it's late, the pots can wait*"), and is not done where its own may ("mow the lawn, but *if it's wet, it can
    wait*")."""
    order, check = clauses[k - 1 : k + 1]
    is_behind = (roles[k - 1], roles[k]) == ("task", "condition") and check.ends_sentence and check.boundary != "none"
    is_led = {"if"} <= {*check.near} <= {"and", "but", "if", "there", "not"} and not order.is_forbidden
    if is_behind and is_led and check.lets_be and sides[k - 1] in ("top", ">1+", ">1-") and sides[k] == "top":
        is_own = check.lets_be in order.objects or check.lets_be in ITS
        sides[k - 1] = ">1-" if is_own else "top"


def put_elsewhere(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is put somewhere is so though a sentence of its own tells where something else is put that may turn up, or
    be hot still ("put the book on the shelf. If you see the pencil, *put it in the drawer*", "..., if the pan is still
    hot, *stand it on the tile*", "put the forks away. If the pan is dirty, *put it in the sink*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_led = check.boundary in (".", "!") and check.near == ("if",) and not check.wording.is_negated
    is_led = is_led and sides[k - 1 : k + 2] == [">1-", "top", HOLDS]
    is_led = is_led and (check.task.type == "searching" or _is_of_own_thing(check, order, other))
    are_put = {order.task.type, other.task.type} <= MOVING and bool(order.receivers) and bool(other.receivers)
    is_other = bool(check.objects) and not check.names_same(order) and other.has_pronoun and not other.objects
    is_apart = order.receivers.isdisjoint(other.receivers) and "instead" not in (*other.near, *other.behind)
    if is_led and are_put and is_other and is_apart and not order.is_forbidden:
        sides[k - 1] = "top"


def _is_of_own_thing(check: Clause, order: Clause, other: Clause) -> bool:
    """Whether it asks how the thing is that the order behind it takes up, and the one ahead does not: what is still hot
    is put where it can cool, and "it" is not "the forks"."""
    is_asked = check.is_check and bool(check.said_state) and not check.says_there_is and not check.is_of_weather
    is_one = other.number == check.number != "" and order.nouns.isdisjoint(check.objects)
    is_hot = check.says_still and check.wording.state == "hot"
    return is_asked and is_one and (is_hot or (bool(order.number) and order.number != other.number))


def fetch_for_both(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is fetched and then put in one place in a case, and "otherwise" in another, is fetched for either ("get the
    boots from the car and put them by the fire if they're wet; *otherwise put them in the hall*")."""
    if k < 2 or k + 1 >= len(clauses) or tuple(roles[k - 2 : k + 2]) != ("task", "task", "condition", "task"):
        return
    fetched, order, check, other = clauses[k - 2 : k + 2]
    is_fetched = fetched.task.type in ("taking", "bringing") and bool(fetched.objects) and order.near == ("and",)
    are_of_it = all(c.has_pronoun and not c.objects for c in (order, check, other))
    is_trailing = check.near == ("if",) and check.boundary == "none" and other.is_otherwise
    is_put = order.task.type == "placing" and other.task.type in _MOVED and fetched.sentence == check.sentence
    are_sides = sides[k - 2 : k] == [">1+", ">1+"] and sides[k + 1] == FAILS and sides[k] in ("top", HOLDS, FAILS)
    if is_fetched and are_of_it and is_trailing and is_put and are_sides and order.boundary == "none":
        sides[k - 2] = sides[k]


def spare_rest(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is done with one of several things in a case keeps nobody from what is ordered of them all ("put the glasses
    in the rack, but *if one of them is chipped*, throw it away")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_part = check.is_of_some or (check.is_check and check.is_of_any and "one" in check.thing)
    is_led = check.near[-1:] == ("if",) and sides[k - 1 : k + 2] == [">1-", "top", HOLDS]
    is_of_all = order.number == "many" or bool(order.thing & {"they", "them"})
    if is_part and is_led and is_of_all and other.has_pronoun and other.number != "many":
        sides[k - 1] = "top"


def do_back(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is put back in a case was taken before that was asked, and what is taken away again was given or put there
    ("take the book from the shelf, but if it's the wrong one, *put it back*", "give her a biscuit, but if she leaves
    it, *take it away*"); what is taken away of a thing that was made ready leaves that as it is ("set the table, but if
    Leo isn't coming, *take a plate away*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    types = (order.task.type, other.task.type)
    is_put_back = types == ("taking", "placing") and "back" in other.ways
    is_removed = types[0] in MOVING and types[1] == "taking" and other.removes and not other.objects
    is_lessened = types == ("change_state", "taking") and other.removes and bool(other.objects)
    is_lessened = is_lessened and order.nouns.isdisjoint(other.nouns)
    is_lessened = is_lessened and "instead" not in (*other.near, *other.behind)
    is_led = check.near == ("but", "if") and (other.has_pronoun or is_lessened)
    if (is_put_back or is_removed or is_lessened) and is_led and sides[k - 1 : k + 2] == [">1-", "top", HOLDS]:
        sides[k - 1] = "top"


def do_ahead_of_return(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """Who or what comes back in a case has been taken away before that was asked ("carry the jug to Ann; *if she's
    asleep, bring it back*", "take Max to school; *if it's shut, come home*"), and who gets another one for what they
    did with the first got that ("give her a pill; *if she drops it, give her another*")."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_led = "if" in check.near and {"and", "but", "if"}.issuperset({*check.near} - {"not"}) and check.is_check
    is_led = is_led and check.boundary in (*PARTING, ",", "!") and sides[k - 1 : k + 2] == [">1-", "top", HOLDS]
    if not is_led or order.is_forbidden or other.near or check.sentence != other.sentence:
        return
    is_away = order.task.type in _SENT and bool(order.receivers) and order.ways.isdisjoint(_RETURNING)
    is_away = is_away and order.places.isdisjoint(check.nouns)
    is_return = is_away and not other.ways.isdisjoint(_RETURNING) and not other.objects
    is_return = is_return and (other.task.type == "motion" or (other.task.type == "bringing" and other.is_of_it))
    is_done = check.is_of_it and check.verb in _LOSING and not check.wording.is_negated
    is_further = is_done and order.task.type == other.task.type == "bringing" and other.thing in _ANOTHER
    if is_return or is_further:
        sides[k - 1] = "top"


def have_in_hand(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What was picked up to do one thing with it, or in a case another, was picked up in either ("take the towel and
    fold it, *unless it's damp, in which case hang it up*")."""
    if k < 2 or k + 1 >= len(clauses) or tuple(roles[k - 2 : k + 2]) != ("task", "task", "condition", "task"):
        return
    taken, order, check, other = clauses[k - 2 : k + 2]
    is_one = taken.sentence == order.sentence == check.sentence == other.sentence
    is_taken = is_one and taken.task.type == "taking" and bool(taken.objects) and order.near == ("and",)
    are_of_it = all(c.has_pronoun and not c.objects for c in (order, check, other))
    is_turned = {sides[k - 1][-1:], sides[k + 1][-1:]} == {"+", "-"} and sides[k - 2] == sides[k - 1][:3]
    is_done = sides[k - 2][:2] == ">1" and other.task.type in MOVING | {"change_state"}
    if is_taken and are_of_it and is_turned and is_done:
        sides[k - 2] = "top"


def carry_in(clauses: Sequence[Clause], roles: Sequence[str], sides: list[str], k: int) -> None:
    """What is taken to a room is there before a case says where in it: "take the cup to the kitchen. If the dishwasher
    is on, *put it in the sink*", not "if the kitchen is locked, put it on the mat"."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return
    order, check, other = clauses[k - 1 : k + 2]
    is_taken = order.task.type == "bringing" and not _ROOMS.isdisjoint(order.receivers) and sides[k - 1] == ">1-"
    is_taken = is_taken and all(kind != "recipient" for kind, _ in order.task.arguments)
    is_put = other.task.type == "placing" and other.has_pronoun and not other.objects and bool(other.receivers)
    is_inside = is_put and _ROOMS.isdisjoint(other.receivers) and "instead" not in other.behind
    is_led = check.is_check and check.near[-1:] == ("if",) and not {*check.near} - {"and", "if"} and not other.near
    is_of_room = not check.nouns.isdisjoint(order.receivers) or check.is_of_weather or check.has_pronoun
    if is_taken and is_inside and is_led and not is_of_room and sides[k + 1] == HOLDS:
        sides[k - 1] = "top"
