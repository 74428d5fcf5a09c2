"""Levels: the small words that say a state where the verb leaves it open ("turn the radio *down*", "is there any milk
*left*?")."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from decomplex_bt.instruction import Argument, Task, in_text_order
from decomplex_bt.understanding.document import MARKS, Document

_TURNING = frozenset("turn crank nudge notch whack".split())
"""What is done to a knob or a volume, so that "up" and "down" say where it ends."""
_SHIFTING = frozenset("bump kick knock".split())
"""The same, where it is said how far: "bump it *up a notch*"."""
_PULLING = frozenset("pull let draw".split())
_PULLED = frozenset(
    "blind blinds curtain curtains shutter shutters shade shades grille screen awning door it them".split()
)
_EXTINGUISHING = frozenset(("put", "turn"))
_BURNING = frozenset(
    "light lights lamp lamps lantern lanterns candle candles fire fires torch cigarette stove flame it them".split()
)
_DEGREES = (("a", "little"), ("a", "bit"), ("a", "notch"), ("a", "touch"), ("a", "tad"))
_OTHER_CLAUSES = frozenset("so while because until till when if unless before after".split())
_BEHIND_LEFT = frozenset("in on at for over inside from under of to by and or then if".split())


def with_levels(document: Document, tasks: Sequence[Task]) -> tuple[Task, ...]:
    """The tasks with the states that such words tell, which are no part of a phrase."""
    said = {j for task in tasks for a in task.arguments if a.span is not None for j in document.indices(a.span)}
    starts = [document.indices(task.span).start for task in tasks]
    ends = [*starts[1:], len(document)]
    return tuple(
        _with_level(document, task, start, end, said) for task, start, end in zip(tasks, starts, ends, strict=False)
    )


def _with_level(document: Document, task: Task, start: int, end: int, said: Collection[int]) -> Task:
    words = _own_words(document, start, end, is_order=task.type == "change_state")
    if task.type == "check_state":
        is_placed = any(a.type == "location" and a.span is not None for a in task.arguments)
        found = None if is_placed else _rest(document, words, said)  # "left in the tin" says where
    elif task.type == "change_state":
        found = _level(document, start, words, said)
    else:
        return task
    if found is None:
        return task
    told = task.argument("state")
    if told is None:
        span = document.span(found.start, found.stop - 1)
        state = Argument("state", span.of(document.text), span, task.confidence)
        return replace(task, arguments=in_text_order((*task.arguments, state)))
    if task.type == "check_state" or told.span is None or document.indices(told.span).start != found.start + 1:
        return task
    span = document.span(found.start, document.indices(told.span).stop - 1)  # "turn it *down to two*"
    longer = replace(told, value=span.of(document.text), span=span)
    return replace(task, arguments=tuple(longer if a is told else a for a in task.arguments))


def _own_words(document: Document, start: int, end: int, *, is_order: bool) -> range:
    """The words behind a verb up to the next mark or task, of an order up to the next verb or clause."""
    for j in range(start + 1, end):
        token = document.tokens[j]
        is_other = token.pos in ("VERB", "AUX") or token.lower in _OTHER_CLAUSES
        if token.text in MARKS or (is_order and is_other):
            return range(start + 1, j)
    return range(start + 1, end)


def _level(document: Document, verb: int, words: range, said: Collection[int]) -> range | None:
    """An "up" or "down" behind a verb of turning, with how far, and the "out" of a light."""
    lemma = document.tokens[verb].lemma
    moved = {document.tokens[j].lower for j in words}
    wanted = {"up", "down"} if lemma in _TURNING | _SHIFTING or (lemma in _PULLING and moved & _PULLED) else set()
    wanted |= {"out"} if lemma in _EXTINGUISHING and moved & _BURNING else set()
    for j in words:
        token = document.tokens[j]
        if token.lower not in wanted or j in said:
            continue
        if token.tag not in ("RP", "RB", "IN") or _leads_on(document, j, words):
            return None
        behind = tuple(t.lower for t in document.tokens[j + 1 : j + 3])
        is_told_how_far = behind in _DEGREES and j + 2 in words
        if lemma in _SHIFTING and not is_told_how_far and behind[:1] != ("to",):
            return None
        return range(j, j + 3 if is_told_how_far else j + 1)
    return None


def _leads_on(document: Document, particle: int, words: range) -> bool:
    """Whether a particle belongs to where somebody is ("turn it off *up there*")."""
    behind = document.tokens[particle + 1] if particle + 1 in words else None
    return behind is not None and behind.lower in ("here", "there", "stairs")


def _rest(document: Document, words: range, said: Collection[int]) -> range | None:
    """The "left" of what there is, or somebody has, still some of."""
    for j in words:
        if document.tokens[j].lower != "left" or j in said:
            continue
        behind = document.tokens[j + 1] if j + 1 in words else None
        is_of_rest = j - 1 in said or document.tokens[j - 1].lower in ("there", "any", "none", "some", "one")
        is_over = behind is not None and behind.lower == "over"
        if is_of_rest and (behind is None or behind.lower in _BEHIND_LEFT or behind.tag == "IN"):
            return range(j, j + 1 + is_over)
        return None
    return None
