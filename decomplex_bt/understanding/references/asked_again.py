"""Repeated: conditions that are said again are about what they were about before, and about nothing that is first named
where they hold or do not."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import DENYING, PREDICATE, Gap, gap_of, is_bare_being
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.references.roles import ELSEWHERE

_THERE = "there"
_SOMEBODY = frozenset("he him she her".split())
_PRO_VERBS = frozenset("has have had does do did will would can could".split())
_SAYING_LITTLE = frozenset("be have do get go come look seem feel say want need like can will 's see check".split())
"""Verbs that different things may well do one after the other."""
_PLACES = frozenset(("location", "source", "goal"))
_ALREADY = frozenset(("already", "now"))
_TOO = frozenset(("too", "also", "either"))
_NEAR = 3
"""Within so many words around a "there" stands what tells that it is the end of an order [tokens]."""


def asked_before(context: Context, gap: Gap) -> int:
    """The check, by its number, that an "if it is" or "if it has" takes up: "is *the stew* still warm? Bring me a plate
    if *it* is", or that asks for the same deed: "wait until *the timer* rings. When *it* rings, ..."; 0 where there is
    none."""
    if gap.type != "object" or gap.word not in ELSEWHERE or gap.task.type != "check_state":
        return 0
    if (same := _asking_alike(context, gap)) and _has_object(context, same, is_living=gap.word in _SOMEBODY):
        return same
    first = context.first.get(gap.task.id, gap.task.id)
    if first >= gap.task.id or context.types.get(first) != "check_state":
        return 0
    document, verb = context.observed.document, context.observed.document.indices(gap.task.span).start
    is_bare = is_bare_being(document, verb) or is_pro_verb(document, verb)
    return first if is_bare and _has_object(context, first, is_living=gap.word in _SOMEBODY) else 0


def _asking_alike(context: Context, gap: Gap) -> int:
    """The nearest check before that asks whether something does the same, by its number; 0 where there is none, or
    where several ask it of different things."""
    verb = context.lemmas[gap.task.id]
    if verb.split()[0] in _SAYING_LITTLE or any(a.type == "state" for a in gap.task.arguments):
        return 0
    checks = [t.id for t in context.tasks if t.id < gap.task.id and t.type == "check_state"]
    alike = [number for number in checks if context.lemmas[number] == verb]
    things = {value.lower() for number in alike for value in context.by_number[number].values("object")}
    return alike[-1] if alike and len(things - ELSEWHERE) <= 1 else 0


def is_pro_verb(document: Document, verb: int) -> bool:
    """Whether a verb stands for what was asked, and no more: "make the tea if it *has*", "if he *doesn't*, ..."."""
    behind = next((token for token in document.tokens[verb + 1 :] if token.lower not in DENYING), None)
    return document.tokens[verb].lower in _PRO_VERBS and (behind is None or behind.text in MARKS)


def place_asked_before(context: Context, gap: Gap, before: Sequence[Task]) -> Argument | None:
    """Where something was asked to be that an "if it is" takes up, where a word stood for that place: "open the tin.
    Are the keys *in it*? If they are, ..."; None where a state was asked, or the place was named."""
    first = next((task for task in before if task.id == context.first.get(gap.task.id)), None)
    document = context.observed.document
    if gap.type != PREDICATE or first is None or not is_bare_being(document, gap.position):
        return None
    asked = [argument for argument in first.arguments if argument.type in ("state", "location")]
    if first.type != "check_state" or len(asked) != 1 or asked[0].type != "location":
        return None
    is_referring = asked[0].span is not None and gap_of(document, first, asked[0]) is not None
    is_resolved = is_referring and asked[0].span is not None and asked[0].value != asked[0].span.of(document.text)
    return Argument("location", asked[0].value, None, asked[0].confidence) if is_resolved else None


def is_of_own_branch(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is first named in an order that the condition decides which a check says again: "look in the
    loft. If the cat is out, carry the basket to *the cellar*; if she's still *there*, ...". Where something is
    "already" it is to go, and where no place was spoken of before, that may be the one."""
    first = context.first.get(gap.task.id, gap.task.id)
    if first >= gap.task.id or gap.task.type != "check_state" or candidate.mention:
        return False
    is_place = gap.type == "location" and gap.word == _THERE and _is_of_place_before(context, gap, first)
    is_thing = gap.type == "object" and gap.word in ELSEWHERE and _has_object(context, first)
    return (is_place or is_thing) and context.relation(candidate.owner, gap.task.id) == "governed"


def _is_of_place_before(context: Context, gap: Gap, first: int) -> bool:
    """Whether a place was spoken of before the condition or in it, and it is not asked if something is by now where it
    is to go: "if they're *already* in there"."""
    tokens, start = context.observed.document.tokens, max(0, gap.tokens.start - _NEAR)
    is_done = any(token.lower in _ALREADY for token in tokens[start : gap.tokens.stop + _NEAR])
    return not is_done and any(0 < c.owner <= first and c.type in _PLACES for c in context.pool)


def is_other_again(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a check asks if something else is in the same state, too, and a candidate is what it was asked of before:
    "if the blue bin is full, use the green one, and if *that*'s full as well, ..."."""
    if gap.type != "object" or gap.word not in ELSEWHERE or gap.task.type != "check_state":
        return False
    states = _states(gap.task)
    tokens, verb = context.observed.document.tokens, context.observed.document.indices(gap.task.span).start
    end = next((t.i for t in tokens[verb:] if t.text in MARKS), len(tokens))
    words = [token.lower for token in tokens[verb:end]]
    if not states or not (_TOO & set(words) or words[-2:] == ["as", "well"]):
        return False
    before = (task for task in context.tasks if task.id < gap.task.id and task.type == "check_state")
    asked = (c for task in before if _states(task) == states for c in context.arguments(task.id, "object"))
    return any(tokens[c.head].i == candidate.head or c.text.lower() == candidate.text.lower() for c in asked)


def _states(task: Task) -> set[str]:
    return {argument.value.lower() for argument in task.arguments if argument.type == "state"}


def _has_object(context: Context, number: int, *, is_living: bool = False) -> bool:
    """Whether a task is about something that was named or, where that is asked, about somebody."""
    named = context.arguments(number, "object")
    return any(not is_living or kind_of(context, c) in ANIMATE for c in named)
