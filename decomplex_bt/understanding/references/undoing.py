"""Undoing: what is put right in a case is what that case is of ("wash the pan. If *the sink* is full, empty *it*"), or
what the contrary is done to in the other case."""

from __future__ import annotations

from decomplex_bt.instruction import Task
from decomplex_bt.understanding.changes import change
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate

_SET = frozenset("on off open close shut lock unlock bolt unbolt cover uncover plug unplug".split())
"""What is done and undone again, by its verb or the state that it brings about."""
_LOCKS = frozenset("open unlock lock unbolt bolt".split())
_SHUT = frozenset("locked bolted shut closed stuck jammed".split())
_KEYS = frozenset("key keycard code combination password pin fob crowbar screwdriver spanner oil can".split())
"""What something is opened with, or made to open."""
_TO_WHOLES = "water"
"""What is done to something for the state of its part: "the fern looks sad; if *the soil* is dry, water it"."""


def undone(context: Context, gap: Gap) -> range:
    """The words for what is in the state that a verb ends, right behind which it stands, where "it" names no thing;
    empty where there is none, or the order before is of the same verb."""
    if gap.type != "object" or gap.word not in ("it", "them") or gap.task.type != "change_state":
        return range(0)
    check = context.by_number.get(gap.task.id - 1)
    path = context.paths.get(gap.task.id, ())
    if check is None or check.type != "check_state" or not path or path[-1] != (check.id, "then"):
        return range(0)
    verb = context.lemmas[gap.task.id].split()[0]
    states = {a.value.lower().split()[-1] for a in check.arguments if a.type == "state"}
    if verb == _TO_WHOLES or states.isdisjoint(change(verb).ends):
        return range(0)
    document = context.observed.document
    tag = ("NN", "NNP") if gap.word == "it" else ("NNS",)
    named = [c for c in context.arguments(check.id, "object") if not c.mention]
    named = [c for c in named if c.shape in ("whole", "long") and document.tokens[c.head].tag in tag]
    is_thing = len(named) == 1 and kind_of(context, named[0]) not in ANIMATE
    return named[0].tokens if is_thing else range(0)


def is_means_of_it(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is only got for what a case is of, where that is unlocked, or locked again: "if *the safe* is
    locked, get the code from Ann and open *it*"."""
    verb = context.lemmas[gap.task.id].split()[0]
    if gap.type != "object" or gap.word != "it" or gap.task.type != "change_state" or verb not in _LOCKS:
        return False
    if candidate.type != "object" or context.types.get(candidate.owner) not in ("taking", "bringing"):
        return False
    if context.observed.document.tokens[candidate.head].lemma not in _KEYS:
        return False
    return any(
        side == "then" and check < candidate.owner < gap.task.id and _is_locked(context.by_number[check])
        for check, side in context.paths.get(gap.task.id, ())
    )


def _is_locked(check: Task) -> bool:
    return any(a.type == "state" and a.value.lower().split()[-1] in _SHUT for a in check.arguments)


def done_contrariwise(context: Context, gap: Gap) -> range:
    """The words for what the contrary is done to in the other case: "if the cat is in, shut *the hatch*, and if she's
    out, open *it*"; empty where there is none, or the case is of what has the state that the verb ends."""
    if gap.type != "object" or gap.word not in ("it", "them") or gap.task.type != "change_state":
        return range(0)
    done = _set_by(context, gap.task)
    before = context.by_number.get(gap.task.id - 1)
    asked = set() if before is None else {a.value.lower().split()[-1] for a in before.arguments if a.type == "state"}
    if not done or not asked.isdisjoint(change(done).ends):
        return range(0)
    contrary = [
        task
        for task in context.tasks
        if task.id < gap.task.id
        and task.type == "change_state"
        and context.relation(task.id, gap.task.id) == "exclusive"
        and _is_contrary(_set_by(context, task), done)
    ]
    objects = context.arguments(contrary[-1].id, "object") if contrary else []
    named = [c for c in objects if _is_of_number(context, gap, c) and kind_of(context, c) not in ANIMATE]
    return named[0].tokens if len(named) == 1 else range(0)


def _set_by(context: Context, task: Task) -> str:
    """The verb, or the state that an order names, of what can be undone again; "" for any other order."""
    states = [a.value.lower().split()[-1] for a in task.arguments if a.type == "state"]
    return next((word for word in (*states, context.lemmas[task.id].split()[0]) if word in _SET), "")


def _is_contrary(one: str, other: str) -> bool:
    return bool(change(one).ends_in & change(other).ends) and bool(change(other).ends_in & change(one).ends)


def _is_of_number(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is one thing for "it", or several for "them", by its noun or the word that stands for it."""
    if candidate.mention:
        return candidate.mention == gap.word
    tokens = context.observed.document.tokens
    is_plural = tokens[candidate.head].tag in ("NNS", "NNPS") or any(tokens[i].lower == "and" for i in candidate.tokens)
    return candidate.shape in ("whole", "long") and is_plural == (gap.word == "them")
