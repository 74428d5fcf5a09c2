"""Persons: what "he", "she" and "they" cannot be, for how it is asked about or was called before."""

from __future__ import annotations

from decomplex_bt.instruction import Task
from decomplex_bt.understanding.references.agreement import is_of_other_gender
from decomplex_bt.understanding.references.chunks import is_child
from decomplex_bt.understanding.references.context import ANIMATE, GROUPS, Context, kind_of
from decomplex_bt.understanding.references.fitness import VESSELS, WITH_HOURS
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import ANIMALS

_OF_THINGS = frozenset(
    "on off open closed shut ajar locked unlocked lit unlit empty full flat broken cracked chipped torn ripped blown "
    "faulty jammed ripe boiled baked charged plugged unplugged".split()
)
"""States that nobody is in."""
_CALLING = frozenset("ring call phone knock buzz come arrive visit appear".split()) | {"turn up", "show up"}
_WAKING = frozenset("wake waken rouse".split())
_LIVING = frozenset("awake asleep sleeping hungry thirsty crying tired sleepy ill poorly sick upset".split())
_PLANTS = frozenset("plant flower rose fern tulip herb tomato".split())
"""What may be thirsty and is no animal."""
_ASKED_FOR = frozenset(("which", "what"))
_FROM_WHERE = frozenset("from at in on of".split())


def is_no_somebody(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "him" cannot mean a candidate since that is a vessel or in a state of things ("if *the torch* is flat,
    give him the lantern"), is one of those that were asked for ("ask her which coat she likes. If it's *the duffel*,
    ...") or goes to somebody in the same order ("if it's *the duffel*, take it to her"), or was called "her" before;
    nor "them" where several are told something, and nobody was named ("is *the porch* empty? Otherwise tell them to
    go"). Of a trough it may be said that "she's low"."""
    group = GROUPS.get(gap.word, "")
    is_told = group == "they" and gap.type == "recipient" and gap.task.type == "informing"
    if group not in ("he", "she") and not is_told:
        return False
    if _goes(context, gap, candidate) or _was_meant_otherwise(context, gap, candidate):
        return True
    tokens = context.observed.document.tokens
    head = tokens[candidate.head]
    if not candidate.mention and tokens[candidate.tokens.stop - 1].tag == "POS":
        return True  # "the dentist's" is where the dentist is
    if _is_spoken_past(context, gap, candidate):
        return True
    if kind_of(context, candidate) in ANIMATE or head.lemma in ANIMALS:
        return False
    if is_told and _is_stated_place(context, candidate):
        return True
    if candidate.task_type != "check_state" or (is_told and _may_be_told(context, candidate)):
        return False
    if is_told and (context.observed.gazetteer.category(head.lemma) or candidate.type == "location"):
        return True
    check = context.by_number[candidate.owner]
    if candidate.type == "object" and not candidate.mention:
        states = {a.value.lower() for a in check.arguments if a.type == "state"}
        is_given = head.text.islower() and gap.task.type != "check_state"
        return is_given and (head.lemma in VESSELS or not states.isdisjoint(_OF_THINGS))
    return _is_of_choice(context, candidate.owner)


def _is_spoken_past(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is an animal, where somebody else was named who can be told or asked something: "feed *Tom's
    cat* and ask him if he wants soup"."""
    document = context.observed.document
    is_animal = document.tokens[candidate.head].lemma in ANIMALS and not is_child(document, candidate.tokens)
    if (gap.type, gap.task.type) != ("recipient", "informing") or not is_animal:
        return False
    named = (c for c in context.pool if c.tokens.stop <= gap.position and not is_of_other_gender(document, gap, c))
    return any(
        kind_of(context, c) in ("person", "name") and document.tokens[c.head].lemma not in ANIMALS for c in named
    )


def is_whence(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "him" cannot mean a candidate since it only tells where somebody is or comes from: "the farmer from
    *Holt*"."""
    before = context.observed.document.tokens[max(0, candidate.tokens.start - 1)]
    if GROUPS.get(gap.word) not in ("he", "she") or candidate.mention or before.lower not in _FROM_WHERE:
        return False
    return any(
        whole.tokens.start <= whole.head < candidate.tokens.start and candidate.tokens.stop <= whole.tokens.stop
        for whole in context.pool
        if not whole.mention and kind_of(context, whole) in ANIMATE
    )


def is_lifeless(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a thing where only somebody can be meant, and is named: nobody wakes *the lights* of the
    kids' room, or asks if they are hungry."""
    if (GROUPS.get(gap.word), gap.type) != ("they", "object"):
        return False
    states = {a.value.lower() for a in gap.task.arguments if a.type == "state"}
    is_lived = gap.task.type == "check_state" and not states.isdisjoint(_LIVING)
    if not is_lived and context.lemmas[gap.task.id].split()[0] not in _WAKING:
        return False
    head = context.observed.document.tokens[candidate.head].lemma
    is_thing = bool(context.observed.gazetteer.category(head)) and head not in ANIMALS | _PLANTS
    is_thing = is_thing and kind_of(context, candidate) not in ANIMATE
    return is_thing and any(kind_of(context, other) in ANIMATE for other in context.pool)


def _is_of_choice(context: Context, check: int) -> bool:
    """Whether a check asks which of some things it is: "ask her *which coat* she likes. If *it*'s the duffel, ..."."""
    tokens = context.observed.document.tokens
    asked = context.arguments(check, "object")
    return any(tokens[c.tokens.start].lower in _ASKED_FOR or c.text.split()[0].lower() in _ASKED_FOR for c in asked)


def _is_stated_place(context: Context, candidate: Candidate) -> bool:
    """Whether a candidate is a room that somebody is or is not in, as a statement has it: "nobody's in *the office*, is
    there? If there is, ask them to leave"."""
    tokens = context.observed.document.tokens
    is_inside = candidate.tokens.start > 0 and tokens[candidate.tokens.start - 1].lower in ("in", "inside")
    is_room = context.observed.gazetteer.category(tokens[candidate.head].lemma) == "room"
    return not candidate.owner and is_room and is_inside


def _may_be_told(context: Context, candidate: Candidate) -> bool:
    """Whether those at a place may be told something ("if *the bakery* is shut, ..."), or somebody was named."""
    head = context.observed.document.tokens[candidate.head]
    return head.lemma in WITH_HOURS or any(kind_of(context, c) in ANIMATE for c in context.pool)


def _was_meant_otherwise(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a "she" that is settled already means a candidate, which then is neither "he" nor "them": "is *the nurse*
    here? Ask *her* to look at Ivo and tell *him* ...". A "she" that no task has is for `agreement`."""
    called = {"he", "she"}.intersection(context.mentions.get(candidate.text.lower(), ()))
    return bool(called) and GROUPS.get(gap.word) not in called


def asks_who_calls(context: Context, check: Task) -> bool:
    """Whether a check may ask who it is that calls, since one ahead of it asks if somebody does: "if the vicar rings,
    show him in. If *it's* the tuner, ..."."""
    callings = (task for task in context.tasks if task.id < check.id and task.type == "check_state")
    return any(
        not {context.lemmas[task.id], context.lemmas[task.id].split()[0]}.isdisjoint(_CALLING) for task in callings
    )


def _goes(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what goes to somebody in the order that the word stands in."""
    moved = context.arguments(gap.task.id, "object")
    return gap.type == "recipient" and any(c.text.lower() == candidate.text.lower() for c in moved)
