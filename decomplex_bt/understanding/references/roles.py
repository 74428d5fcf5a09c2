"""Roles: what a word cannot mean for what it is in its task: what is looked for is no place to look, a thing is not
shown in, and nobody is the door that they are at."""

from __future__ import annotations

from decomplex_bt.instruction import Task
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.fitness import WITH_HOURS
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.identity import identity_of
from decomplex_bt.understanding.references.phrases import Candidate

_HANDLING = frozenset(("bringing", "taking", "placing"))
ELSEWHERE = frozenset("it them 'em em they that those this these him he she her".split())
"""Words that never mean another argument of their own task: in "put it on the table" it is not the table."""
_FIXED = frozenset("floor wall ceiling ground lawn pavement porch".split())
_FROM = frozenset("off of from".split())
_LEAVING = frozenset(("leave", "keep"))
_MOVING = frozenset(("bringing", "placing"))
_AGAIN = frozenset(("back", "again"))
_AT = frozenset("in at on by under".split())
_WHERE = frozenset(("goal", "source", "recipient"))
_OF_THINGS = frozenset("dry wet damp soaked heavy light broken ripe stale".split())
"""States that say how something is to be handled."""
_FOLDING = frozenset("fold iron hang wear peel eat drink".split())
"""What is done to what can be lifted."""
_OF_ROOMS = frozenset("vacuum hoover mop sweep dust tidy".split())
"""What is done to rooms and things, and may have no object."""


def is_within(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "there" would be inside the very thing that is there: "wipe the sink and empty *the bin* in there", "pack
    *the kite*, and if it isn't there, ..."."""
    is_own = candidate.owner == gap.task.id and candidate.type == "object" and not candidate.mention
    is_where = gap.word == "there" and gap.type == "location" and gap.task.type == "check_state"
    if is_where and candidate.type == "object" and not is_own and _is_own_object(context, gap, candidate):
        return True
    is_living = kind_of(context, candidate) in ANIMATE  # nor inside somebody who was spoken of before
    return gap.word == "there" and (is_own != is_living if gap.preposition == "in" else is_own and not is_living)


def _is_own_object(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what the task of a gap is about, by a word that refers to it."""
    own = (c for c in context.arguments(gap.task.id, "object") if c.mention)
    return any(c.text.lower() == candidate.text.lower() for c in own)


def is_where_from(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether something would be carried "there" from where the order before takes it: "Ann is in the yard. Get the rug
    off *the sofa* and take it out *there*"; it may well be put back."""
    is_goal = gap.word == "there" and gap.type == "goal" and gap.task.type in ("bringing", "placing")
    order = gap.task.id - 1
    is_source = (candidate.owner, candidate.type) == (order, "source") and not candidate.mention
    if not is_goal or not is_source or context.types.get(order) != "taking" or context.lemmas[gap.task.id] == "leave":
        return False
    tokens = context.observed.document.tokens
    verb = context.observed.document.indices(gap.task.span).start
    words = {token.lower for token in tokens[verb : gap.tokens.stop + 1]}
    taken, moved = ({c.text.lower() for c in context.arguments(number, "object")} for number in (order, gap.task.id))
    ahead = (c for c in context.pool if c.tokens.stop <= candidate.tokens.start)
    is_other = any(c.tokens.start and tokens[c.tokens.start - 1].lower in _AT for c in ahead)
    first = candidate.tokens.start
    is_taken_away = bool(taken & moved) and first > 0 and tokens[first - 1].lower in _FROM
    return words.isdisjoint(_AGAIN) and is_taken_away and is_other


def is_where_else(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether something would be left "there" where it is put in the other case: "if the coat is wet, hang it in *the
    bath*; if not, leave it *there*"; nor is that where it is itself, or somebody."""
    verb = context.lemmas[gap.task.id].split()[0]
    if gap.word != "there" or gap.type != "goal" or verb not in _LEAVING:
        return False
    left = {c.text.lower() for c in context.arguments(gap.task.id, "object")}
    elsewhere = {
        c.owner
        for c in context.pool
        if c.task_type in _MOVING
        and c.type == "object"
        and c.text.lower() in left
        and context.relation(c.owner, gap.task.id) == "exclusive"
    }
    if candidate.text.lower() in left or kind_of(context, candidate) in ANIMATE:
        return bool(elsewhere)
    return candidate.type == "goal" and not candidate.mention and candidate.owner in elsewhere


def is_sought(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what is looked for, where the word tells a place to look: "it should be on the sofa, but
    if it isn't, look under *it*"."""
    is_place = gap.task.type == "searching" and gap.type == "location" and gap.word in ("it", "them")
    if not is_place or candidate.type != "object" or candidate.task_type not in ("searching", "check_state"):
        return False
    is_missed = context.relation(candidate.owner, gap.task.id).startswith("condition.else")
    return is_missed and any(c.type in ("location", "source") and c.tokens.stop <= gap.position for c in context.pool)


def is_led(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a thing, where somebody is shown the way: "take *their coats* and show *them* in"; nor is
    anybody mopped, where that is left unsaid."""
    is_thing = candidate.type == "object" and candidate.task_type in _HANDLING and not candidate.mention
    if gap.task.type == "following" and gap.type == "object" and gap.word in ELSEWHERE:
        return is_thing and kind_of(context, candidate) not in ANIMATE
    is_cleaned = gap.type == "object" and not gap.word and context.lemmas[gap.task.id] in _OF_ROOMS
    return is_cleaned and kind_of(context, candidate) in ANIMATE


def is_nobody(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a thing, where it is asked who somebody is: "get *the door*, and if *it*'s the plumber,
    ..."."""
    document = context.observed.document
    if gap.task.type != "check_state" or gap.type != "object" or gap.word != "it" or candidate.mention:
        return False
    identity = identity_of(document, document.indices(gap.task.span).start)
    is_who = identity is not None and identity.is_pronoun(document) and identity.is_of_person(document)
    return is_who and kind_of(context, candidate) not in ANIMATE and candidate.type in ("object", "location", "goal")


def is_immovable(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a room or a floor, which is neither moved nor folded, nor what a condition asks of that is
    then moved or folded: "pick up the rug from *the floor*. If *it*'s dry, fold it"."""
    noun = context.observed.document.tokens[candidate.head].lemma
    is_room = noun in _FIXED | WITH_HOURS or context.observed.gazetteer.category(noun) == "room"
    if gap.word != "it" or gap.type != "object" or not is_room:
        return False
    order = gap.task
    if gap.task.type == "check_state":
        if not any(a.type == "state" and a.value.lower().split()[-1] in _OF_THINGS for a in gap.task.arguments):
            return False  # "if the office is closed, slip it under the door"
        behind = context.by_number.get(gap.task.id + 1)
        is_governed = (gap.task.id, "then") in context.paths.get(gap.task.id + 1, ())
        if behind is None or not is_governed or not _is_of_it(context, behind):
            return False
        order = behind
    is_moved = order.type in _HANDLING and any(a.type in _WHERE for a in order.arguments)
    return is_moved or context.lemmas[order.id].split()[0] in _FOLDING


def _is_of_it(context: Context, task: Task) -> bool:
    said = (a.span.of(context.observed.document.text) for a in task.arguments if a.type == "object" and a.span)
    return any(text.lower() == "it" for text in said)


def is_called_in(context: Context, candidate: Candidate) -> bool:
    """Whether a candidate is somebody who is got on account of what was asked of another one: "if he's in pain, get
    *the nurse*"."""
    is_got = candidate.type == "object" and context.lemmas.get(candidate.owner, "").split()[:1] in (["get"], ["fetch"])
    return is_got and candidate.task_type in ("taking", "following", "bringing")
