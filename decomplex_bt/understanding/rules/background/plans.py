"""Plans: what a speaker means to do without help ("I want to bake a cake. If there are no eggs, ..."), which is no
order."""

from __future__ import annotations

from collections.abc import Mapping

from decomplex_bt.understanding.document import MARKS, Document

_SPEAKERS = frozenset(("i", "we"))
_BE = frozenset("am 'm m are 're re was were".split())
_WOULD = frozenset("'d d would 'll ll will".split())
_BETWEEN = frozenset("just really also now still so first then".split())
_COMING = frozenset("going gon about planning intending hoping plan intend mean hope decided".split())
"""What one is going, about or planning to do."""
_WISHING = frozenset("want like love wish".split())
_TO = frozenset(("to", "na", "ta"))
_CASES = frozenset(
    "if unless when whenever whether once before after until till while what where who how which that than as".split()
)
"""Behind one of these it is told when something is to be done, or what somebody is told."""
_OPENING = frozenset("if unless when once before after so and but".split())
_FOR_ONESELF = frozenset("have get see borrow be".split())
"""What one wants to do in that somebody brings or shows something: "I'd like to *have* my tea"."""
_OWN = frozenset(
    "bake cook fry roast barbecue grill brew make prepare watch read write draw paint print sew knit weave plant sow "
    "build play practise practice sing dance train exercise study work sleep nap rest lie sit eat dine drink show "
    "teach introduce surprise visit sell send mail post move redecorate decorate".split()
)
"""What people want to do by themselves; what is done to a device or a door they want done."""


def is_planned(document: Document, at: int, tasks: Mapping[int, str]) -> bool:
    """Whether the verb at token `at`, which is no check, is of what the speaker is about to do ("I'm going to bake
    later, so ..."), wants to do to the one spoken to ("I want to show you the cellar") or, where something else is
    among the `tasks`, wants to do alone ("I want to bake a cake. Get me the flour").

    Not "I want you to bake", "I'd like to have a pen", "I want to turn the lamp on".
    """
    tokens = document.tokens
    if tasks.get(at) == "check_state" or at < 2:
        return False
    wish = _wish(document, at)
    subject = None if wish is None else _subject(document, wish)
    if wish is None or subject is None or _is_told(document, subject, tasks):
        return False
    if tokens[wish].lower in _COMING:
        return tokens[at].lemma not in _FOR_ONESELF
    is_to_hearer = tokens[at + 1 : at + 2] != () and tokens[at + 1].lower in ("you", "u", "ya")
    if is_to_hearer and tokens[at].lemma not in _FOR_ONESELF:
        return True
    return tokens[at].lemma in _OWN and _has_others(document, at, tasks)


def _wish(document: Document, at: int) -> int | None:
    """The word ahead of a verb that says that one is going or wants to do it: "*going* to bake", "*wanna* bake"."""
    tokens = document.tokens
    if tokens[at - 1].lower == "wanna":
        return at - 1
    is_led = tokens[at - 1].lower in _TO and at > 1
    is_wish = is_led and (tokens[at - 2].lower in _COMING or tokens[at - 2].lemma in _WISHING)
    return at - 2 if is_wish else None


def _subject(document: Document, wish: int) -> int | None:
    """The "I" ahead of a wish, if it is the speaker who has it and tells it outright."""
    tokens, i = document.tokens, wish - 1
    while i >= 0 and tokens[i].lower in _BE | _WOULD | _BETWEEN:
        i -= 1
    is_own = i >= 0 and tokens[i].lower in _SPEAKERS and (i == 0 or tokens[i - 1].lower not in _CASES)
    return i if is_own else None


def _is_told(document: Document, subject: int, tasks: Mapping[int, str]) -> bool:
    """Whether it is what somebody is told: "tell Tom *I'm going to clean*"."""
    before = max((i for i in tasks if i < subject), default=None)
    if before is None or tasks[before] != "informing":
        return False
    return MARKS.isdisjoint(token.lower for token in document.tokens[before:subject])


def _has_others(document: Document, at: int, tasks: Mapping[int, str]) -> bool:
    """Whether something is asked for beside what is planned and what an "and" joins to it right behind."""
    return any(i != at and not _is_joined(document, at, i) for i in tasks)


def _is_joined(document: Document, at: int, other: int) -> bool:
    tokens = document.tokens
    between = [token.lower for token in tokens[at + 1 : other] if token.lower != "then"]
    return other > at and between[-1:] == ["and"] and MARKS.isdisjoint(between)


def plans(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The tokens of all plans, up to a mark or a case, in which no token is among the `tasks`: at most they tell where
    somebody is to go ("I want to show you *the cellar*, follow me")."""
    if document.words.isdisjoint(_SPEAKERS):
        return frozenset()
    found: set[int] = set()
    for at in range(1, len(document)):
        wish = _wish(document, at)
        start = None if wish is None else _subject(document, wish)
        if start is None or not is_planned(document, at, {**tasks, at: ""}):
            continue
        ends = (t.i for t in document.tokens[at:] if t.lower in MARKS | _OPENING or t.i in tasks)
        stop = next(ends, len(document))
        if not any(start <= i < stop for i in tasks):
            found.update(range(start, stop))
    return frozenset(found)
