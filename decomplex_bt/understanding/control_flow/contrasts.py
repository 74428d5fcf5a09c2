"""How a condition stands to an earlier one: another state, place, thing or matter, or a further case."""

from __future__ import annotations

from decomplex_bt.understanding.control_flow.clause import AROUND, LEADING, PRESENT, Clause
from decomplex_bt.understanding.states import OPPOSITES, are_alike, are_apart, are_near
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS


def is_asked_again_after(clause: Clause, first: Clause) -> bool:
    """Whether it asks if something is *still* as the condition before has it, in the same words, when something was
    done about it: "if it's red, restart it. Still red?", not "if it's dry, fold it. If it's still damp, ..."."""
    is_same = (clause.wording.state or clause.verb) == (first.wording.state or first.verb)
    is_check = clause.task.type == "check_state"
    return is_check and clause.says_still and is_same and clause.wording.is_negated == first.wording.is_negated


def is_case_beside(clause: Clause, first: Clause) -> bool:
    """Whether it tests another state of what the other tests, as far as its words say: "if it's lukewarm" beside
    "if the soup is hot"."""
    state, other = clause.wording.state or "", first.wording.state or ""
    is_other_state = clause.said_state != first.said_state and not are_apart(state, other)
    verbs = {clause.verb, first.verb}
    is_same_verb = len(verbs) == 1 or verbs <= _BEING or (clause.is_wish and first.is_wish)
    is_one = not (clause.number and first.number) or clause.number == first.number
    # "that" may be another thing
    is_of_it = (clause.is_of_somebody or (clause.is_of_it and bool(clause.number))) and not clause.objects
    is_of_it = is_of_it or (clause.is_of_some and first.number != "one")
    is_same = is_one and (clause.names_same(first) or is_of_it) and not clause.is_of_weather
    return is_other_state and is_same_verb and (is_same or (clause.is_of_weather and first.is_of_weather))


def is_elsewhere_than(clause: Clause, first: Clause) -> bool:
    """Whether it asks if who or what the other looks for is in another place."""
    is_of_them = clause.names_same(first) or (clause.has_pronoun and not clause.objects)
    places, others = clause.places - {"in"} or clause.places, first.places - {"in"} or first.places
    are_places = clause.is_of_whereabouts and first.is_of_whereabouts and bool(places) and bool(others)
    are_stated = not clause.wording.is_negated and not first.wording.is_negated
    return is_of_them and are_places and are_stated and places.isdisjoint(others)


def is_rival_of(clause: Clause, first: Clause) -> bool:
    """Whether it asks what cannot be where the other holds: if it is another thing ("if it's the phone, ..., if
    it's the doorbell, ..."), if somebody answers or sits otherwise, or if something is so instead."""
    is_other = bool(clause.identified and first.identified) and clause.identified != first.identified
    is_one = clause.verb == first.verb and clause.verb in _ANSWERING
    is_other = is_other or (is_one and is_other_wish(clause, first))
    is_other = is_other or _is_other_posture(clause, first)
    are_stated = not (clause.wording.is_negated or first.wording.is_negated)
    return clause.is_check and are_stated and (is_other or clause.says_instead)


def _is_other_posture(clause: Clause, first: Clause) -> bool:
    """Whether it asks if somebody stands where the other asks if they sit: "if he's *sitting*, ..., if he's *on his
    feet*, ..."."""
    said, other = (_POSTURES.intersection((*c.said_state, c.verb, *c.places)) for c in (clause, first))
    is_same = clause.is_of_somebody or clause.names_same(first)
    return is_same and bool(said and other) and said.isdisjoint(other)


_POSTURES = frozenset("sitting seated standing lying kneeling sit stand lie feet".split())


def is_other_wish(clause: Clause, first: Clause) -> bool:
    """Whether it asks if the same one says or would have something else than the other asks: "if she says *tea*, ...,
    if she says *coffee*, ...", "if he asks for *juice*, ..., if he asks for *tea*, ..."."""
    verbs = {clause.verb, first.verb}
    is_same_verb = (len(verbs) == 1 and verbs <= _ANSWERING | _WISHING) or verbs <= _WISHING | {"want"}
    are_stated = clause.is_check and first.is_check and not (clause.wording.is_negated or first.wording.is_negated)
    is_same = clause.is_of_somebody or clause.names_same(first) or not (clause.objects and clause.said_state)
    said, other = (frozenset(c.said_state or c.objects) for c in (clause, first))
    is_other = bool(said - other and other - said) and "else" not in said
    return is_same_verb and are_stated and is_same and is_other and not (clause.says_answer or first.says_answer)


def _is_state_beside(clause: Clause, first: Clause) -> bool:
    """Whether it tests another state than the other, of the same, that is neither its opposite nor what is left where
    it does not hold: "if the drum is *done*, ...; if it's *empty*, ...", "if it's *raining*, ...; if it *snows*"."""
    state, other = clause.wording.state or "", first.wording.state or ""
    are_stated = not (clause.wording.is_negated or first.wording.is_negated) and clause.is_check and first.is_check
    is_other = are_near(state, other) or (are_apart(state, other) and not clause.says_still)
    return are_stated and is_other and not {*clause.far, *clause.near} & {"else", "fail", "so"}


def is_of_one_of_both(clause: Clause, first: Clause) -> bool:
    """Whether it asks after one alone of the things that the other looks for: "look for *flour and sugar*, and if we
    don't have any *sugar*, ..."."""
    is_sought = first.task.type == "searching" and len(set(first.objects)) > 1
    is_one = len(set(clause.objects)) == 1 and {*clause.objects} < {*first.objects}
    return clause.is_check and is_sought and is_one and "and" in first.thing


def _is_of_stock(clause: Clause, first: Clause) -> bool:
    """Whether it asks if there is none left in a place, where the other tests a state of what is used up: "if the paper
    is *running low*, put out two rolls, and if there are *none left in the cellar*, ..."."""
    if clause.said_state[:2] == ("out", "of") and first.says_there_is:
        return clause.is_check and clause.said_state[-1] not in first.objects  # "no red", "out of wine altogether"
    is_none = clause.is_check and clause.says_there_is and clause.wording.is_negated
    is_elsewhere = bool(clause.places - AROUND - _THERE) and not first.places
    return is_none and is_elsewhere and first.is_check and bool(first.said_state) and not first.says_there_is


def is_besides(clause: Clause, first: Clause) -> bool:
    """Whether it tests another state that the thing may be in as well, and that is not known to be on the scale of the
    other: "smoking" beside "on", not "cold" beside "hot"."""
    state, other = clause.wording.state or "", first.wording.state or ""
    are_stated = not (clause.wording.is_negated or first.wording.is_negated or clause.says_still)
    is_other = state != other and OPPOSITES.get(state) != other != "" and OPPOSITES.get(other) != state != ""
    is_free = not are_alike(state, other) or are_near(state, other)
    return are_stated and is_other and is_free and not {state, other} & PRESENT


def is_lack_of(clause: Clause, first: Clause) -> bool:
    """Whether it says that there is none at all of what the other tests a state of: "if the milk is cold, heat it. *If
    there's no milk*, ..."."""
    is_none = clause.is_check and clause.says_there_is and clause.wording.is_negated and not clause.places
    is_bare = is_none and clause.names_same(first) and clause.thing <= first.thing
    is_of_state = first.is_check and bool(first.said_state) and not (first.says_there_is or first.is_of_whereabouts)
    return is_bare and is_of_state


def is_other_degree(clause: Clause, first: Clause) -> bool:
    """Whether one says that something is too much so, and the other that it is too little: "if it's *too hot*, ...; if
    it's *too cold*, ...", "if it's *not hot enough*": it may be neither."""
    one, other = _degree(clause), _degree(first)
    is_contrary = one == other == "too" and clause.wording.state != first.wording.state
    return is_contrary or (bool(one and other) and one != other)


def is_other_end(clause: Clause, first: Clause) -> bool:
    """Whether that is of two states: "if it's *too cold*" beside "if it's *warm enough*", not "if it's *too warm*"."""
    states = (set(c.said_state) - _DEGREES for c in (clause, first))
    return is_other_degree(clause, first) and next(states).isdisjoint(next(states))


def _degree(clause: Clause) -> str:
    return next((word for word in clause.said_state if word in _DEGREES), "")


def _is_after_fall(clause: Clause, first: Clause) -> bool:
    """Whether it tests in what state a thing is that fell by the other: "if the jug has *fallen over*, ..., and if it's
    broken, ..."."""
    is_state = clause.is_check and clause.verb in _BEING and bool(clause.said_state) and not clause.wording.is_echo
    is_fall = first.is_check and first.verb in _FALLING and bool(first.number) and not first.said_state
    return is_state and is_fall and clause.wording.state not in PRESENT


def _is_of_deed(clause: Clause, first: Clause) -> bool:
    """Whether it tests how somebody or something is where the other asks if they do something, of which no state is the
    opposite: "if the neighbours *complain*, turn it down, and if they still aren't *happy*, ...", or if the one spoken
    to has finished."""
    is_state = clause.is_check and clause.verb in _BEING and bool(clause.said_state) and not clause.is_of_weather
    is_of_listener = first.verb == "finish" and not (first.objects or first.number or first.has_pronoun)
    is_deed = first.is_check and (first.verb in _DEEDS or is_of_listener) and not first.wording.is_negated
    return is_state and is_deed and not {*clause.far, *clause.near} & {"else", "fail", "so"}


def is_named_apart(clause: Clause, first: Clause) -> bool:
    """Whether both ask the same of two things of one kind that words tell apart: "if the *left window* is open, ..., if
    the *right window* is open, ..."."""
    is_kind = clause.objects[-1:] == first.objects[-1:] != ()
    are_apart_by = bool(clause.thing - first.thing) and bool(first.thing - clause.thing)
    is_same = clause.verb == first.verb and clause.wording.state == first.wording.state
    return clause.is_check and first.is_check and is_kind and are_apart_by and is_same


def is_opposite_of(clause: Clause, first: Clause) -> bool:
    """Whether it tests the opposite of an earlier condition, of the same thing by name: "if the tv is off, ..., if
    the tv is on, ...", or denies of "her" what that asks of somebody."""
    one, other = clause.wording, first.wording
    is_other_state = one.is_opposite_of(other) or other.is_opposite_of(one)
    is_doing = clause.verb == first.verb not in _BEING and {*clause.objects} <= {*first.objects}
    is_denied = (one.state is not None or is_doing) and one.state == other.state and one.is_negated != other.is_negated
    is_turned = is_denied or (is_other_state and one.is_negated == other.is_negated)
    is_same = clause.names_same(first) or (clause.says_answer and clause.is_of_somebody)
    is_somebody = first.may_be_of_person or not ANIMALS.isdisjoint(first.objects)
    is_same = is_same or (is_denied and clause.is_of_person and is_somebody)
    is_apart = is_of_other_place(clause, first) or is_other_degree(clause, first)
    return clause.is_check and first.is_check and is_turned and is_same and not is_apart


def is_of_other_place(clause: Clause, first: Clause) -> bool:
    """Whether both say where the thing is of which they test a state, and that is not one place: "the glass on the
    desk", "the glass on the shelf"."""
    is_of_state = clause.wording.state is not None and first.wording.state is not None
    places, others = clause.places - AROUND - _THERE, first.places - AROUND - _THERE
    return is_of_state and bool(places) and bool(others) and places.isdisjoint(others)


def joining_role(clause: Clause, before: Clause) -> str:
    """The role, "and" or "or", of a check that is joined to the one before it under the same "if" or "unless" ("if
    it is wet or the fan is off"), as parts are joined where both are as stated; "" where nothing settles that:
    unless it ends the sentence ("open it if it is dry and the fan is on"), the second of two that "and" joins may
    as well be a condition in the branch of the first."""
    if not clause.is_joined_check or not before.is_check or clause.sentence != before.sentence:
        return ""
    if clause.is_excepted:
        return clause.wording.joins
    is_bare = clause.boundary == "none" and clause.opening == (clause.wording.joins,)
    is_certain = is_bare and (clause.wording.joins == "or" or clause.ends_sentence)
    return clause.wording.joins if is_certain and not _IFS.isdisjoint(before.near) else ""


def is_other_case_than(clause: Clause, before: Clause) -> bool:
    """Whether it is a further case for what the other, which only says whether something is so, is said for ("if he
    isn't, *or if he's late*, ...")."""
    is_added = clause.near[:2] == ("or", "if") or clause.opening == ("or",)
    is_next = clause.sentence == before.sentence and clause.boundary in ("none", ",") and not clause.ends_sentence
    return is_added and is_next and clause.is_check and before.says_only_whether and "if" in before.near


def is_of_other_state(clause: Clause, first: Clause) -> bool:
    """Whether it tests a state that has nothing to do with the one that an order to check asks ("check if it is
    done, and if it's burnt, ...", but "if it's still wet": it is not done then)."""
    state, other = clause.wording.state, first.wording.state
    is_order = first.task.type == "check_state" and first.is_asked and not first.is_question
    if state is None or other is None or not is_order or (clause.says_still and other in _ENDS):
        return False
    return not clause.objects and clause.has_pronoun and are_apart(state, other)


def asks_of(clause: Clause, order: Clause, first: Clause) -> bool:
    """Whether it asks right behind an order after the state of what that is to be done with, and that is another
    thing, and another state, than the first asks ("is the tv on? ... close the window if *it's open*")."""
    state, other = clause.wording.state, first.wording.state
    is_behind = clause.boundary == "none" and clause.near[:1] == ("if",) and clause.has_pronoun and not clause.objects
    if not (is_behind and clause.is_check and state is not None and other is not None and are_apart(state, other)):
        return False
    is_own = bool(order.objects) and order.objects[-1] not in first.nouns  # "the bathroom light", "... door"
    return is_own and clause.sentence == order.sentence and "or" not in order.near


def asks_same_of_another(clause: Clause, first: Clause) -> bool:
    """Whether it asks of something that it names what the other asks of something else."""
    is_same = (clause.verb, clause.places) == (first.verb, first.places)
    is_same = is_same and clause.wording.state == first.wording.state
    is_other = bool(clause.objects) and bool(first.objects) and set(clause.objects).isdisjoint(first.objects)
    return clause.is_check and first.is_check and is_same and is_other and _NO_THINGS.isdisjoint(clause.objects)


def asks_for_what_had_state(clause: Clause, first: Clause) -> bool:
    """Whether it asks if something is missing, where the other tests another state of it."""
    is_of_state = any(kind == "state" for kind, _ in first.task.arguments)
    return clause.wording.state in _MISSING and is_of_state and first.wording.state not in PRESENT


def is_of_nobody_at(clause: Clause, first: Clause) -> bool:
    """Whether it asks if nobody is, or does, something, where the other tests a state of a thing that has nothing
    to do with who is there: "if the trunk is shut, ..., and if nobody is sleeping, ..."."""
    is_of_thing = first.task.type == "check_state" and bool(first.number) and first.wording.state is not None
    is_of_users = first.wording.state in _USED or not clause.nouns.isdisjoint(first.objects)
    return clause.is_check and clause.is_of_nobody and is_of_thing and not is_of_users


def is_apart_from(clause: Clause, order: Clause) -> bool:
    """Whether it asks if nobody is in a place, or uses something, that an order has nothing to do with."""
    known = order.nouns | order.places | order.receivers
    is_handed = order.task.type == "bringing" and bool(order.receivers)
    is_order = order.task.type in LEADING | {"change_state"}
    is_elsewhere = bool(clause.places) and clause.places.isdisjoint(known | _THERE) and not is_handed
    is_elsewhere = is_elsewhere or (bool(clause.places & _THERE) and order.task.type == "change_state")
    is_used = clause.said_state[:1] == ("using",) and clause.nouns.isdisjoint(known) and not clause.has_pronoun
    return is_order and clause.is_check and clause.is_of_nobody and (is_elsewhere or is_used)


def is_other_weather(clause: Clause, first: Clause) -> bool:
    """Whether both ask about the weather, and not after one and the same: "if it's dark, ..., and if it's raining"."""
    state, other = clause.wording.state, first.wording.state
    are_known = state is not None and other is not None and OPPOSITES.get(state) != other != state
    is_weather = clause.is_of_weather or (clause.is_of_it and not clause.objects)
    return first.is_of_weather and is_weather and are_known and clause.is_check and first.is_check


def is_of_other_matter(clause: Clause, first: Clause) -> bool:
    """Whether it has nothing to do with what the other asks: it asks about the weather, or if nobody is there, and
    that about a thing."""
    is_weather = clause.is_of_weather and clause.wording.state not in _LIT  # it is dark where the lamp is off, too
    is_other_weather = is_weather and first.task.type == "check_state" and not first.is_of_weather
    return is_other_weather or is_of_nobody_at(clause, first)


def is_of_another(clause: Clause, first: Clause) -> bool:
    """Whether its words say that it is no mention of an earlier condition: it is of another matter or of a thing
    elsewhere, or asks the same of another thing ("if there's no milk, ..., if there's no tea, ..."), or whether
    something is missing whose state the other tests, or it tests a state, and that of many things where the other
    is about one (or the other way round), or of what the other asks the place of."""
    own = {kind for kind, _ in clause.task.arguments}
    is_of_other = asks_same_of_another(clause, first) or is_of_other_matter(clause, first)
    if is_of_other or asks_for_what_had_state(clause, first) or is_of_other_place(clause, first):
        return True
    if (
        _is_of_stock(clause, first)
        or is_other_wish(clause, first)
        or _is_state_beside(clause, first)
        or _is_of_deed(clause, first)
        or is_lack_of(clause, first)
        or is_other_degree(clause, first)
        or _is_after_fall(clause, first)
        or _is_of_thing(clause, first)
        or _is_of_return(clause, first)
    ):
        return True
    if clause.task.type != "check_state" or first.task.type != "check_state" or "state" not in own:
        return False
    state, other = clause.wording.state, first.wording.state
    if state in PRESENT or set(clause.objects) & set(first.objects):
        return False
    if (
        state is not None
        and other is not None
        and (state == other or OPPOSITES.get(state) == other or OPPOSITES.get(other) == state)
    ):
        return False
    is_of_others = bool(clause.number and first.number) and clause.number != first.number
    return state not in _USED and (is_of_others or (first.asks_where and "location" not in own))


def _is_of_thing(clause: Clause, first: Clause) -> bool:
    """Whether it asks what an "it" does, where the other is about somebody: "if *Ann is in*, lock the gate, and if *it
    jams*, ..."."""
    is_of_deed = clause.is_check and clause.is_of_it and not clause.objects and not clause.said_state
    is_of_deed = is_of_deed and not (clause.says_only_whether or clause.says_still)
    is_other = clause.verb != first.verb and clause.verb not in _BEING and not clause.is_of_weather
    is_of_somebody = first.is_of_person or first.may_be_of_person or not PERSON_NOUNS.isdisjoint(first.objects[-1:])
    return is_of_deed and is_other and first.is_check and is_of_somebody


def _is_of_return(clause: Clause, first: Clause) -> bool:
    """Whether it asks if something is back of which the other says that it goes: "if *the power goes off*, ... If *it's
    not back* in an hour, ..."."""
    is_gone = first.is_check and first.verb in _GOING and not first.wording.is_negated
    return clause.is_check and clause.said_state[:1] == ("back",) and is_gone and not first.is_of_person


_ANSWERING = frozenset("say answer reply choose pick want prefer".split())
"""What somebody does or has one of at a time."""
_WISHING = frozenset("ask need fancy like".split())
_DEEDS = frozenset("complain ask call cry knock ring bark moan grumble shout scream protest insist beg".split())
_DEGREES = frozenset(("too", "enough"))
_GOING = frozenset("go fail drop cut trip".split())
_FALLING = frozenset("fall tip topple drop roll slip".split())
_IFS = frozenset(("if", "unless", "only_if"))
_BEING = frozenset(("be", "'s", "s"))
_ENDS = frozenset("done finished ready over cooked baked clean dry".split())
"""States that something comes to in the end: what is still otherwise has not."""
_USED = frozenset("free busy empty available occupied taken use unused vacant unoccupied deserted quiet loud".split())
"""States that tell whether somebody is there."""
_LIT = frozenset(("dark", "light"))
_MISSING = frozenset(("missing", "gone", "lost"))
_THERE = frozenset(("there", "here"))
_NO_THINGS = frozenset("none one some any drop".split())
