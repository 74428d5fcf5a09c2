"""What comes of an order, or is needed for it: a condition or another order that speaks of that."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import FINDING, LEADING, Clause


def is_guard_of(clause: Clause, before: Clause) -> bool:
    """Whether it asks no more than whether the change before it is needed: "wash it if it's dirty", "fill it unless
    it's full", "turn the tv off if it's on"."""
    if before.task.type != "change_state" or not clause.is_check or clause.wording.state is None:
        return False
    is_needed = clause.wording.state in (before.effects if clause.wording.is_negated else before.needs)
    return is_needed and (clause.names_same(before) or (clause.has_pronoun and not clause.objects))


def is_cleared(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether condition `k` asks in a sentence of its own if something is shut or full that the order before carries
    something past or into, and all that is done in that case undoes this."""
    if k + 1 >= len(clauses) or (roles[k - 1], roles[k], roles[k + 1]) != ("task", "condition", "task"):
        return False
    order, check, remedy = clauses[k - 1 : k + 2]
    is_carried = order.task.type in ("placing", "bringing", "taking") and not order.is_forbidden
    is_asked = check.boundary in (".", ";") and check.near == ("if",) and check.is_check
    is_shut = check.wording.state in OBSTRUCTED and not check.wording.is_negated
    is_opened = check.wording.state == "locked" and remedy.verb == "open"
    is_undone = is_opened or check.wording.state in remedy.needs
    is_undone = is_undone and remedy.has_pronoun and not remedy.objects
    is_all = k + 2 == len(clauses) or clauses[k + 2].sentence != remedy.sentence
    return is_carried and is_asked and is_shut and is_undone and is_all and remedy.boundary == ","


def undoes(clause: Clause, before: Clause) -> bool:
    """Whether it takes back what the order before brings about: "light it" and "blow it out", "put it in the oven"
    and "take it out", "go there" and "come back"."""
    is_of_it = clause.names_same(before) or (clause.is_of_it and not clause.objects)
    one, other = before.task.type, clause.task.type
    if one == other == "change_state":  # but "turn it off and on again", "empty it and fill it" is done at a stretch
        is_renewed = not clause.ways.isdisjoint(("again", "back")) or "empty" in before.effects
        return is_of_it and not is_renewed and not before.effects.isdisjoint(clause.needs)
    is_return = not (clause.ways.isdisjoint(_RETURNING) or clause.nouns - _RETURNING)
    is_gone = one in LEADING and before.ways.isdisjoint(_RETURNING)
    if other == "motion" and is_return:
        return is_gone
    return is_of_it and ((one == "placing" and other == "taking") or (other in LEADING and is_return and is_gone))


def spares(clause: Clause, before: Clause) -> bool:
    """Whether it says to leave or keep a thing as it was before the order that changes it: "turn it off" and "leave it
    on"."""
    is_kept = clause.verb in _LEAVING and clause.task.type == "change_state" and clause.is_of_it and not clause.objects
    is_same = clause.number == before.number and not (clause.is_forbidden or before.is_forbidden)
    return is_kept and is_same and clause.wording.state in before.needs


def comes_through(clause: Clause, before: Clause) -> bool:
    """Whether what it asks is what the order before brings about: "fill it" and "it's full", "start it" and "it's
    done", "turn the oven on" and "it's hot", "let her out" and "she's back", "put them in the oven" and "when
    they're brown"."""
    is_of_thing = clause.names_same(before) or (clause.is_of_it and not clause.objects)
    is_sent = before.verb in _SENDING or before.task.type == "following" or "out" in before.ways
    if "back" in clause.ways and is_sent:
        return is_of_thing or (clause.is_of_somebody and not clause.objects)
    is_reached = clause.wording.state in before.effects and not clause.wording.is_negated
    is_over = clause.wording.state in _OVER or (clause.wording.state is None and clause.verb in _ENDING)
    is_worked = before.task.type == "placing" and not before.receivers.isdisjoint(WORKING) and "when" in clause.near
    if is_worked and clause.wording.state is not None and clause.number == before.number:
        return True
    is_heater = before.is_of_it or not _HEATERS.isdisjoint(before.objects[-1:])
    is_heated = clause.wording.state in _HEATED and is_heater
    is_run = "running" in before.effects and (is_over or (is_heated and not clause.wording.is_negated))
    return is_of_thing and (is_reached or is_run)


def asks_needless(clause: Clause, before: Clause) -> bool:
    """Whether it asks if what the order before brings about is so "already", which can only be asked ahead of it: "open
    the window. *If it's open already*, ..."."""
    is_of_it = clause.names_same(before) or (clause.has_pronoun and not clause.objects)
    is_reached = clause.wording.state in before.effects and not clause.wording.is_negated
    is_led = "if" in clause.near and "unless" not in clause.near and clause.boundary != "none"
    return (
        clause.says_already
        and clause.is_check
        and before.task.type == "change_state"
        and (is_of_it and is_reached and is_led and not before.is_forbidden)
    )


def is_only_of(clause: Clause, order: Clause, before: Clause) -> bool:
    """Whether it asks about the thing of an order alone, and not about that of the order before: "turn the tv off
    and water the fern if it's dry", "fold the shirts and hang up the socks if they're damp". What is fetched or
    turned on may be so for the sake of the other order."""
    are_two = bool(before.nouns) and bool(order.objects) and before.nouns.isdisjoint(order.objects)
    is_fetched = before.task.type in FINDING and order.task.type == "change_state"
    is_handed = any(kind in ("recipient", "goal") for kind, _ in before.task.arguments)
    is_prepared = (is_fetched and not is_handed) or "running" in before.effects
    is_of_it = is_guard_of(clause, order) or (clause.is_check and (clause.names_same(order) or clause.takes_up(order)))
    return are_two and is_of_it and not is_prepared


def is_against(order: Clause, clause: Clause) -> bool:
    """Whether an order is about what weather or light is seen to by: "turn on the lamp if it's dark"."""
    state = clause.wording.state or clause.verb
    return any(state in states and not things.isdisjoint(order.objects) for states, things in _AGAINST)


def turns_on_report(clause: Clause, report: Clause) -> str:
    """ "so" or "else", by which it is done in one case of what is to be told right ahead of it ("tell me if it's on
    and switch it off *if so*", "... and get some *if not*"); "" where it is not."""
    asking = {"whether", "if"} & {*clause.far, *clause.near}
    is_told = report.task.type == "informing" and bool(asking) and clause.sentence == report.sentence
    return clause.behind[-1] if is_told and clause.behind[-1:] in (("so",), ("else",)) else ""


def turns_on_answer(clause: Clause, question: Clause) -> bool:
    """Whether an "if so" opens it behind an order to ask what yes or no answers, or, where no mark parts it from that,
    an "if not": "ask him if he wants tea, *and if so*, make some"."""
    is_near = clause.sentence - question.sentence <= 1 and question.task.type == "informing"
    is_run_on = clause.turns == ("not",) and question.behind[-1:] == ("else",)
    return is_near and bool(question.question) and ("so" in (*clause.far, *clause.near) or is_run_on)


def answers_ring(clause: Clause, order: Clause) -> bool:
    """Whether it says that nobody answers where somebody was rung or knocked for: "ring the bell; *if nobody
    answers*, ..."."""
    is_answer = clause.is_of_nobody and clause.verb in _REACTING and clause.near[:1] == ("if",)
    return is_answer and order.verb in _RINGING


def is_answer_behind(clause: Clause, order: Clause, question: Clause) -> bool:
    """Whether it says, behind an order that hangs on it, how somebody answered what was asked right ahead of that: "ask
    him if he's cold, and bring him the shawl *if he is*"."""
    is_fitting = clause.verb == "do" or not question.question.isdisjoint((clause.verb, "'s"))
    is_bare = clause.says_only_whether and clause.is_of_somebody and clause.near == ("if",)
    is_behind = clause.boundary == "none" and clause.sentence == order.sentence == question.sentence
    return bool(question.question) and question.task.type == "informing" and is_fitting and is_bare and is_behind


def is_answer_to(clause: Clause, before: Clause, others: Sequence[Clause]) -> bool:
    """Whether it says how somebody answered what the task before asked ("ask Lea if she wants soap, and if she
    does, ..."), where that is in the same sentence, or the `others`, the conditions so far, are of things, or say how
    somebody is, which no "does" or "has" takes up ("if she's up, ask her if she wants tea. If she *does*, ...")."""
    is_fitting = clause.verb == "do" or not before.question.isdisjoint((clause.verb, "'s"))
    is_of_them = clause.is_of_somebody and not any(other.number == "many" for other in others)
    is_answer = clause.says_only_whether and bool(before.question) and is_fitting
    is_of_things = not any(other.is_of_somebody or other.may_be_of_person for other in others)
    is_told = clause.sentence == before.sentence and clause.is_of_somebody
    is_only_of_it = clause.verb in ("do", "have") and clause.is_of_somebody
    is_only_of_it = is_only_of_it and all(other.verb in _BEING for other in others)
    return is_answer and (is_told or is_only_of_it or (is_of_things and (clause.is_of_person or is_of_them)))


_AGAINST = tuple(
    (frozenset(states.split()), frozenset(things.split()))
    for states, things in (
        ("dark gloomy light bright", "lamp light lantern candle torch curtain blind shutter floodlight"),
        ("raining rain pouring snowing snow hailing drizzling stormy wet", "window laundry washing umbrella cushion "
         "door awning parasol skylight roof hatch chair towel clothes bike tarpaulin hood"),
        ("sunny shining hot warm bright stuffy", "blind curtain shutter awning fan parasol window aircon"),
        ("cold freezing chilly cool windy frosty", "heater heating fire radiator stove window door boiler blanket "
         "shutter"),
    )
)  # fmt: skip
"""What is seen to in which weather or light."""
_BEING = frozenset("be 's 're s".split())
OBSTRUCTED = frozenset(
    "full packed crammed crowded overflowing occupied taken use locked shut closed stuck jammed blocked obstructed "
    "service order".split()
)
"""States, by their last word, of a place that nothing can be put in or brought to: "full", "in use", "out of order"."""
_RINGING = frozenset("ring knock call phone buzz".split())
_REACTING = frozenset("answer open come reply respond react".split())
_LEAVING = frozenset(("leave", "keep"))
_SENDING = frozenset(("let", "send"))
_RETURNING = frozenset(("back", "home"))
_OVER = frozenset("done finished ready over complete through".split())
WORKING = frozenset("oven stove hob microwave toaster grill pan pot fridge freezer".split())
"""Places where a thing is put for what becomes of it there."""
_HEATED = frozenset("hot warm heated preheated".split())
_HEATERS = frozenset(
    "oven stove hob hotplate iron kettle grill barbecue heater heating radiator boiler griddle sauna".split()
)
"""What gets hot once it is switched on."""
_ENDING = frozenset("finish end stop boil beep".split())
