"""Replies: what tells how an order or a question before it went."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.clauses import last_named
from decomplex_bt.understanding.control_flow.contrasts import is_asked_again_after
from decomplex_bt.understanding.control_flow.failures import (
    fails_behind,
    finds_out,
    is_absence_of,
    is_failure_of,
    is_kept_out,
    is_not_to_be_found,
    lacks_kind,
    lacks_too,
    tries_out,
)
from decomplex_bt.understanding.control_flow.outcomes import (
    answers_ring,
    comes_through,
    is_answer_behind,
    is_answer_to,
    turns_on_answer,
    turns_on_report,
)

_PARTING = frozenset((".", "!", ";"))
_ANSWERING = frozenset("answer pick reply respond".split())
_TAKING = frozenset(("refuse", "decline", "accept"))
"""What somebody does with what they are brought."""
_GOING_ON = frozenset(("keep", "continue"))
_MENDING = frozenset("change replace restart reset swap charge recharge fix repair refill".split())
"""After what it is asked anew if a thing works."""
_RINGING = frozenset("ring knock call buzz".split())
_TURNS = frozenset("if unless else fail so not then".split())
_SEEMING = frozenset("look smell taste feel seem".split())
_DOING = frozenset(("change_state", "placing", "taking", "bringing"))


def ask_again(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether something is still so, once something was done about it, is asked anew ("if it's red, restart it, and if
    it's *still red*, call Tom"), also behind an "if it is" that takes up what was asked, be that the one part of two
    ("if it's hot and the door is shut, ... If it's *still hot*, ...")."""
    is_after = clauses[k].says_still and clauses[k - 1].verb in _MENDING and clauses[k].is_check
    if is_after and roles[k - 1 : k + 1] == ["condition", "mention"]:  # "change the bulb, and if it still doesn't work"
        roles[k - 1 : k + 1] = "task", "condition"
    first = next((j for j in range(k - 1, -1, -1) if roles[j] != "task"), None)
    if roles[k] != "mention" or first is None or first == k - 1:
        return
    if clauses[first].wording.is_echo and roles[first] == "mention":  # "is it red? *If it is*, restart it, and if ..."
        first = next((j for j in range(first - 1, -1, -1) if roles[j] == "condition"), first)
    if roles[first] != "condition":
        return
    is_done = any(clauses[j].task.type in _DOING for j in range(first + 1, k))
    is_going_on = clauses[k].verb in _GOING_ON or "again" in clauses[k].ways
    is_going_on = is_going_on and clauses[k].has_pronoun and not clauses[k].wording.is_negated
    one, other = clauses[first].wording, clauses[k].wording
    is_later = one.is_negated and other.is_negated and one.state == other.state is not None and not other.is_echo
    is_later = is_later and clauses[k].near == ("and", "if") and roles[first + 1 : k] == ["task"] * (k - first - 1)
    if clauses[first].is_check and is_done and (is_going_on or is_later):  # "and if it keeps dripping, ..."
        roles[k] = "condition"
    parts = [first, *takewhile(lambda j: roles[j] in CONDITION_ROLES, range(first - 1, -1, -1))]
    if is_done and any(clauses[j].is_check and is_asked_again_after(clauses[k], clauses[j]) for j in parts):
        roles[k] = "condition"


def find_out(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What tells how something before it went is a mention of that, which is thereby a condition."""
    found_out = _found_out(clauses, roles, k) if roles[k] in CONDITION_ROLES else None
    if found_out is not None:
        roles[k] = "mention"
        roles[found_out] = "condition" if roles[found_out] == "task" else roles[found_out]


def turn_up(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That what was looked for turns up, or does not, tells how the look for it went, whatever was ordered in between
    ("look for my cap. *When it turns up*, bring it to me. *If it doesn't turn up*, ...")."""
    if roles[k] not in CONDITION_ROLES or not clauses[k].turns_up:
        return
    search = next((j for j in range(k - 1, -1, -1) if clauses[j].task.type == "searching"), None)
    if sought_twice(clauses, roles, k) is not None:
        roles[k - 1], roles[k] = _found_in(roles, k)
        return
    if search is None or clauses[search].is_forbidden or roles[search] not in ("task", "condition"):
        return
    between = range(search + 1, k)
    if any(roles[j] == "condition" and clauses[j].is_check and not clauses[j].turns_up for j in between):
        return
    for j in between:
        roles[j] = "task" if roles[j] == "condition" and not clauses[j].is_check else roles[j]
    roles[search], roles[k] = "condition", "mention"


def _found_out(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """What finds out what clause `k` tells of: the one before it, be it that who should get something is not there
    ("take it to Anna, and if she's out, ...") or that what was to be changed does not do so ("unlock it. If it won't
    open, ..."), or the one before that where what is between is done with what was found ("get it from the box and
    hang it up. If it isn't in the box, ...") or is done in that case ("look in the box, and tell me if it isn't
    there", "if it's locked, open it, and tell me if it won't open")."""
    before, clause = clauses[k - 1 : k + 1]
    earlier = [clauses[j] for j in range(k - 1) if roles[j] in CONDITION_ROLES]
    is_found = any(one.is_of_whereabouts or one.task.type == "searching" for one in earlier)
    is_own = before.task.type == "searching" or not is_found or not clause.places.isdisjoint(before.places)
    is_failure = is_failure_of(clause, before, last_named(clauses, k))
    is_outcome = (finds_out(before, clause) and is_own) or is_failure or lacks_kind(clause, before)
    is_lacking = roles[k] == "mention" and lacks_too(clause, before)
    if (is_outcome and not clause.is_trailing) or is_lacking:
        return k - 1
    if is_absence_of(clause, before) and not _is_asked_after(clause, before, earlier) and not clause.is_trailing:
        return k - 1
    if k > 1 and roles[k - 1] == "task" and finds_out(clauses[k - 2], clauses[k]):
        return k - 2 if clauses[k - 1].has_pronoun or clauses[k].boundary == "none" else None
    is_sought = clause.task.type == "searching" and any(one.task.type == "searching" for one in earlier)
    if k > 1 and roles[k - 1] == "task" and clause.is_trailing and not is_sought:
        return k - 2 if fails_behind(clause, clauses[k - 2], clauses[:k]) else None
    return None


def _is_asked_after(clause: Clause, before: Clause, earlier: Sequence[Clause]) -> bool:
    """Whether an earlier condition asks where the one is who, by `clause`, is not there for the errand `before`: then
    it is that one which `clause` mentions."""
    if clause.says_too and clause.is_of_person:
        return False  # "and if she isn't in *either*"
    checks = [one for one in earlier if one.is_of_whereabouts or one.wording.is_echo]
    checks = [one for one in checks if one.objects or one.may_be_of_person or one.is_of_person == clause.is_of_person]
    return any(not (before.receivers and one.objects) or not before.receivers.isdisjoint(one.objects) for one in checks)


def try_out(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether what was fetched or put somewhere does what it is for is no mention of the fetching ("bring me the torch.
    If *it doesn't work*, take the lamp")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if roles[k] != "mention" or first != k - 1 or roles[first] != "condition" or "mention" in roles[k + 1 :]:
        return
    if tries_out(clauses[k], clauses[first]):
        roles[first : k + 1] = "task", "condition"


def search_asked(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """A request to find something in the form of a question, behind which it is said where to look, is no condition
    ("can you find the tape? *Try the box first*, and if ...")."""
    asked, search = clauses[k - 1 : k + 1]
    is_asked = roles[k - 1] == "condition" and asked.task.type == search.task.type == "searching"
    is_next = search.sentence == asked.sentence + 1 and search.boundary == "?" and not {*search.near} & _TURNS
    if is_asked and is_next and not asked.wording.is_negated and "if" not in asked.near:
        roles[k - 1] = "task"


def come_about(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether a thing does what it was made to do tells how that went ("light the stove. *If it lights*, fine, if not,
    ...")."""
    order, clause = clauses[k - 1 : k + 1]
    is_same = clause.is_check and clause.verb == order.verb and clause.is_of_it and not clause.objects
    is_made = order.task.type == "change_state" and not order.is_forbidden and bool(order.objects)
    is_led = "if" in clause.near and clause.boundary != "none" and "unless" not in clause.near
    if is_same and is_made and is_led and roles[k - 1] == "task" and roles[k] == "condition":
        roles[k - 1 : k + 1] = "condition", "mention"


def search_within(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Where to look for what the sentence before, or the clause ahead of a comma, says to find is the same search
    ("find my keys. *Check the bag*, and if you can't find them, ...", "find my keys, they're not here, so *check the
    bag*. If ...")."""
    found, search = clauses[k - 1 : k + 1]
    is_same = search.sentence == found.sentence and search.boundary == ","
    is_told = tuple(roles[k - 1 : k + 2]) == ("task", "condition", "mention")
    are_searches = is_told or (roles[k - 1], roles[k]) == ("condition", "condition")
    are_searches = are_searches and found.task.type == search.task.type == "searching"
    is_next = is_same or search.sentence == found.sentence + 1
    is_next = is_next and not {*search.far, *search.near} - {"first", "please", "still"}
    pleas = 1 if is_same and found.near[:1] == ("please",) else 0  # "please find my keys, ..."
    is_bare = not (found.places or found.turns or found.near[pleas:])
    is_plain = search.boundary != "?" and not search.objects and is_bare
    if are_searches and is_next and is_plain and not search.wording.is_negated:
        roles[k - 1 : k + 1] = "condition", "mention"


def look_over(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """How what was looked for looks is asked anew ("look for the roast, and *if it looks done*, take it out")."""
    clause = clauses[k]
    is_look = clause.is_check and clause.verb in _SEEMING and bool(clause.said_state) and clause.boundary != "none"
    is_sought = roles[k - 1 : k + 1] == ["condition", "mention"] and clauses[k - 1].task.type == "searching"
    if is_look and is_sought and clause.has_pronoun and "mention" not in roles[k + 1 :]:
        roles[k - 1 : k + 1] = "task", "condition"


def wait(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What a "when" says to be so in the end is waited for where the order right before brings it about ("if the oven
    isn't hot, turn it on. *When it is hot*, put the cake in"), and where that hangs on a case behind it, that is asked
    in the same case ("start the dryer if Tom is home. *When it's done*, ...")."""
    clause, order = clauses[k], clauses[k - 1]
    is_when = roles[k] == "mention" and clause.near == ("when",) and clause.boundary != "none" and clause.is_check
    if is_when and roles[k - 1] == "task" and not clause.wording.is_negated and comes_through(clause, order):
        roles[k] = "task"
    if is_when and ends_of_case(clauses, roles, k):
        roles[k] = "condition"
    if roles[k] == "condition" and waits_out(clauses, roles, k):
        roles[k] = "task"


def come_to_be(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What is not so and is then said by a "when" behind an order to be so is waited for in that case ("if she hasn't
    eaten, text me *when she has*")."""
    if roles[k] in CONDITION_ROLES | {"task"} and comes_to_be(clauses, roles, k):
        roles[k] = "condition"


def comes_to_be(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether clause `k` says behind an order no more than that what is not so in the case of that order is so."""
    clause, order = clauses[k], clauses[k - 1]
    is_behind = clause.boundary == "none" and clause.near == ("when",) and clause.sentence == order.sentence
    is_echo = clause.is_check and clause.wording.is_echo and not clause.wording.is_negated
    check = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if check is None or check == k - 1 or not (is_behind and is_echo) or clauses[check].sentence != clause.sentence:
        return False
    return clauses[check].wording.is_negated and "if" in clauses[check].near and roles[k - 1] == "task"


def waits_out(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether clause `k` is what is waited for where it is not so: "if it isn't hot, wait. *As soon as it is*, ...",
    "if the bathroom is occupied, wait. *When it's free*, ..."."""
    check, clause = clauses[k - 1], clauses[k]
    is_next = roles[k - 1] == "condition" and clause.is_past_wait and clause.sentence == check.sentence + 1
    is_led = clause.near in (("when",), ("after",)) and clause.is_check and not clause.wording.is_negated
    one, other = clause.wording, check.wording
    is_reached = other.is_negated and (one.is_echo or one.state == other.state)
    is_reached = is_reached or (not other.is_negated and (one.is_opposite_of(other) or other.is_opposite_of(one)))
    is_same = clause.names_same(check) or (clause.has_pronoun and not clause.objects) or one.is_echo
    return is_next and is_led and is_reached and is_same


def suppose(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether it is who it might be is no mention of the ringing ("if the bell rings, ... It might be Tom. *If it is*,
    let him in")."""
    if roles[k] == "mention" and rings_before(clauses, roles, k) is not None:
        roles[k] = "condition"


def rings_before(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """The condition that asks if somebody rings or knocks, behind whose orders clause `k` asks if it is who it might
    be; else None."""
    clause = clauses[k]
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or roles[first] != "condition" or not clause.is_past_supposition:
        return None
    is_ring = clauses[first].is_check and clauses[first].verb in _RINGING and not clauses[first].wording.is_negated
    return first if is_ring and clause.says_only_whether and "if" in clause.near else None


def ends_of_case(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether clause `k` waits in the next sentence for what an order brings about that hangs on the case behind it, of
    which it says nothing: "start the dryer if Tom is home. *When it's done*, ..."."""
    if k < 2 or tuple(roles[k - 2 : k]) != ("task", "condition"):
        return False
    order, check, clause = clauses[k - 2 : k + 1]
    is_when = clause.near == ("when",) and clause.boundary != "none" and clause.sentence == order.sentence + 1
    is_behind = check.boundary == "none" and check.sentence == order.sentence and not clause.wording.is_negated
    return is_when and is_behind and clause.is_check and bool(clause.said_state) and comes_through(clause, order)


def miss_thing(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That what was to be fetched cannot be found tells of the order to fetch it, not of what was asked of the thing in
    between ("bring me the mug. If it's dirty, wash it. *If you can't find it*, ...")."""
    order = fetched_before(clauses, k)
    if order is None or roles[k] != "mention" or roles[order] not in ("task", "condition"):
        return
    if roles[order + 1] == "condition":
        roles[order] = "condition"
        roles[order + 2 : k] = ["task"] * (k - order - 2)


def fetched_before(clauses: Sequence[Clause], k: int) -> int | None:
    """The order that should fetch what by clause `k` cannot be found, behind which one case of the thing is told
    ("bring me the mug. *If it's dirty, wash it*. If you can't find it, ..."); else None."""
    check = k - 2
    while check > 0 and "if" not in clauses[check].near:
        check -= 1
    if check < 1 or clauses[check].boundary not in _PARTING or clauses[check].sentence == clauses[k].sentence:
        return None
    is_told = clauses[check].sentence == clauses[k - 1].sentence and not any(c.turns for c in clauses[check:k])
    return check - 1 if is_told and is_not_to_be_found(clauses[k], clauses[check - 1], clauses[check]) else None


def find_after_all(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That something is found tells of both places where it was looked for, not of the second alone ("look in the hall.
    If it isn't there, look in the car. *If you find it*, ...")."""
    if roles[k] in CONDITION_ROLES and sought_twice(clauses, roles, k) is not None and "mention" not in roles[k + 1 :]:
        roles[k - 1 : k + 1] = _found_in(roles, k)


def _found_in(roles: Sequence[str], k: int) -> tuple[str, str]:
    """The roles of the second of two searches and of clause `k`, that the thing is found: in either place, or, where a
    case hangs on it that a branch of its own could not repeat, asked once for both."""
    return ("task", "condition") if "condition" in roles[k + 1 :] else ("or", "mention")


def sought_twice(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """The first of two searches, the second right ahead of clause `k`, which says in a sentence of its own that the
    thing is found; else None."""
    clause, second = clauses[k], clauses[k - 1]
    is_found = clause.turns_up or (clause.task.type == "searching" and clause.is_of_it and not clause.objects)
    is_found = is_found and not clause.wording.is_negated
    is_led = clause.near in (("if",), ("when",), ("after",)) and clause.boundary in _PARTING and k + 1 < len(clauses)
    is_next = second.task.type == "searching" and second.sentence == clause.sentence - 1
    is_next = is_next and roles[k - 1] != "mention" and not clause.places  # not "if you find it there"
    first = next((j for j in range(k - 2, -1, -1) if roles[j] == "condition"), None)
    if first is None or not (is_found and is_led and is_next) or clauses[first].task.type != "searching":
        return None
    return first if all(roles[j] == "mention" for j in range(first + 1, k - 1)) else None


def miss(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That somebody is not there tells of the look for them, not of what is given or told them then ("find Tom and give
    him this. *If he isn't there*, ...")."""
    if k < 2 or roles[k] != "mention" or not clauses[k].says_absent or not clauses[k].is_of_person:
        return
    search, order = clauses[k - 2 : k]
    is_told = order.task.type in ("bringing", "informing") and order.near[-1:] == ("and",) and order.has_pronoun
    if search.task.type == "searching" and is_told and not order.receivers and search.may_be_of_person:
        roles[k - 2 : k] = "condition", "task"


def fit_in(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Whether a thing that was looked for fits where it is put then tells nothing of the look for it ("find the hat and
    put it in my bag. *If it won't fit*, ...")."""
    if k < 2 or tuple(roles[k - 1 : k + 1]) != ("task", "mention") or "mention" in roles[k + 1 :]:
        return
    search, put, clause = clauses[k - 2 : k + 1]
    is_of_it = clause.has_pronoun and not clause.objects and put.has_pronoun and not put.objects
    if search.task.type == "searching" and is_kept_out(clause, put) and clause.is_check and is_of_it:
        roles[k - 2 : k + 1] = "task", "task", "condition"


def answer(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What tells how somebody answered is no mention of a condition before the question; and "if he says no" or "if he
    refuses" none of the question."""
    order = replied_to(clauses, roles, k)
    if roles[k] == "mention" and order is not None:
        is_offer = clauses[order].task.type == "bringing"  # "offer her the tea, and if she refuses": not given then
        if roles[order] == "task" or not is_offer:
            roles[order], roles[k] = "task", "condition"
    if roles[k] == "condition" and _is_other_reply(clauses, roles, k):
        roles[k] = "mention"
    is_last = "mention" not in roles[k + 1 :]
    if roles[k - 1 : k + 1] == ["condition", "mention"] and is_last and answers_ring(clauses[k], clauses[k - 1]):
        roles[k - 1 : k + 1] = "task", "condition"
    if clauses[k].says_answer and clauses[k - 1].question and roles[k - 1 : k + 1] == ["condition", "mention"]:
        roles[k - 1 : k + 1] = "task", "condition"
    others = [clauses[j] for j in range(k - 1) if roles[j] in CONDITION_ROLES]
    if roles[k] == "mention" and others and is_answer_to(clauses[k], clauses[k - 1], others):
        roles[k] = "condition"
    is_behind = k > 1 and roles[k - 2 : k + 1] == ["task", "task", "mention"]
    if is_behind and is_answer_behind(clauses[k], clauses[k - 1], clauses[k - 2]):
        roles[k] = "condition"


def pick_up(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """That somebody answers tells how the call went that was to be made and has its other case told before ("ring Dad.
    No answer? Leave a note. *If he does pick up*, ...")."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES), None)
    if first is None or first == k - 1 or (roles[first], roles[k]) != ("condition", "condition"):
        return
    call, clause = clauses[first], clauses[k]
    is_answered = clause.is_check and clause.verb in _ANSWERING and clause.is_of_somebody and not clause.said_state
    if call.task.type == "informing" and not call.is_forbidden and is_answered and not clause.is_trailing:
        roles[k] = "mention"


def replied_to(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> int | None:
    """The order that clause `k` tells somebody's reply to ("if she's in, *ask her to come*, ... If she refuses, ..."):
    the last one to ask, tell or offer something, or to bring what they refuse, without a condition between; else
    None."""
    if not clauses[k].says_reply:
        return None
    order = k - 1
    while order > 0 and roles[order] == "task" and not _may_be_replied_to(clauses[order], clauses[k]):
        order -= 1
    is_near = clauses[k].sentence - clauses[order].sentence <= 1 and roles[order] in ("task", "condition")
    return order if order >= 0 and is_near and _may_be_replied_to(clauses[order], clauses[k]) else None


def _may_be_replied_to(order: Clause, reply: Clause) -> bool:
    is_brought = order.task.type == "bringing" and bool(order.receivers) and not order.is_forbidden
    return order.is_put_to_somebody or (is_brought and reply.verb in _TAKING)


def _is_other_reply(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether it tells the other of two replies: "if he agrees, ...; *if he refuses*, ..."."""
    first = next((j for j in range(k - 1, -1, -1) if roles[j] != "task"), k)
    one, other = clauses[first].wording, clauses[k].wording
    are_replies = clauses[k].says_reply and clauses[first].says_reply and first < k
    return are_replies and (one.is_contrary != one.is_negated) != (other.is_contrary != other.is_negated)


def ask_openly(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What no yes or no answers is no condition, so what is asked behind it is one of its own ("see what he's doing,
    and if he's asleep, ...")."""
    if clauses[k - 1].asks_open and roles[k - 1] == "condition":
        roles[k - 1] = "task"
        roles[k] = "condition" if roles[k] in CONDITION_ROLES else roles[k]


def report(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What is to be told is a condition of what is done in one case of it ("tell me if it's on and switch it off if
    so"), and so is what somebody is asked ("ask him if he wants tea, and if so, make some")."""
    if (roles[k - 1], roles[k]) != ("task", "task"):
        return
    if turns_on_report(clauses[k], clauses[k - 1]) or turns_on_answer(clauses[k], clauses[k - 1]):
        roles[k - 1] = "condition"


def lack_too(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """What somebody does not do or have "either" tells how the order right before went, as the same said of another one
    told of an order of its own ("call Tom. If he doesn't answer, call Ann. If *she doesn't answer either*, ...")."""
    clause, order = clauses[k], clauses[k - 1]
    is_too = clause.says_too and clause.wording.is_negated and clause.has_pronoun and roles[k] == "mention"
    first = next((j for j in range(k - 2, -1, -1) if roles[j] in CONDITION_ROLES), None)
    is_of_other = order.task.type in ("informing", "searching")
    is_of_other = is_of_other or (order.task.type == "bringing" and bool(order.receivers) and clause.is_of_person)
    if not is_too or first is None or roles[k - 1] != "task" or not is_of_other:
        return
    is_same = clauses[first].verb == clause.verb or (clause.verb == "do" and not clause.objects)
    if is_same and clauses[first].wording.is_negated:
        roles[k - 1 if roles[first] == "mention" else k] = "condition"


def do_in_vain(clauses: Sequence[Clause], roles: list[str], k: int) -> None:
    """Behind an order and its case an "if that doesn't help" or "if you can't" is of the order ("wash it if it's
    stained. *If that doesn't help*, ...")."""
    if tried_in_case(clauses, roles, k) and roles[k - 2] == "task":
        roles[k - 2] = "condition"


def tried_in_case(clauses: Sequence[Clause], roles: Sequence[str], k: int) -> bool:
    """Whether clause `k` is for where the order two before it fails, behind which its case is told, or says so."""
    if k < 2 or roles[k - 2] not in ("task", "condition") or roles[k - 1] != "condition":
        return False
    order, case, clause = clauses[k - 2 : k + 1]
    is_case = case.is_check and case.boundary == "none" and case.near in (("if",), ("unless",), ("if", "not"))
    is_case = is_case and case.sentence == order.sentence and not case.ability
    is_order = order.task.type in _DOING and not order.is_forbidden
    is_of_order = clause.ability == "denied" or clause.is_in_vain
    is_said = roles[k] == "mention" and is_failure_of(clause, order, last_named(clauses, k - 1))
    return is_case and is_order and ((is_of_order and roles[k] == "task") or is_said)
