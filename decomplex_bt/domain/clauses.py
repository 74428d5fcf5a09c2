"""The clause around a verb, and what its small words say of a check whatever else is in it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from decomplex_bt.instruction import Span

WEATHER = frozenset(
    "rain snow hail pour drizzle raining rains rained snowing snows snowed hailing hails pouring pours drizzling "
    "bucketing chucking teeming tipping pelting siling lashing thundering sunny windy foggy stormy dark "
    "weekend monday tuesday wednesday thursday friday saturday sunday".split()
)
"""What "it" is where it names nothing."""
AIR = frozenset(
    "hot cold warm freezing chilly cool icy stuffy airless humid muggy draughty drafty smoky quiet silent noisy loud "
    "bright light dark gloomy".split()
)
"""What it may be like somewhere."""
WHERE = frozenset("in inside out outside outdoors indoors upstairs downstairs here there".split())
"""What begins where it is so."""
PARTS = frozenset("middle centre center".split())
"""Where a thing is hot or cold."""
_MARKS = re.compile(r"[.,;:!?]")
_NOBODY = re.compile(r"\b(nobody|no[- ]?one)\b", re.IGNORECASE)
_ANYTHING = re.compile(r"\b(nothing|anything|something)\b", re.IGNORECASE)
_THERE = re.compile(
    r"\bthere('s|\u2019s|s| is| are| be| was| were| ai)(n['\u2019]?t)?\b"
    r"|^\W*(is|are|was|were|ai)(n['\u2019]?t)? there (?=\w)",
    re.IGNORECASE,
)


def clause_around(text: str, verb: Span, verbs: Iterable[Span]) -> str:
    """The words around a verb, with it: from the mark or the last of the other `verbs` before it to the next one."""
    others = [other for other in verbs if other != verb]
    start = max([other.end for other in others if other.end <= verb.start], default=0)
    end = min([other.start for other in others if other.start >= verb.end], default=len(text))
    return f"{_MARKS.split(text[start : verb.start])[-1]}{verb.of(text)}{_MARKS.split(text[verb.end : end])[0]}"


def is_of_nobody(clause: str) -> bool:
    """Whether it is of nobody's being there ("if nobody is in the kitchen"), so that it asks of anybody's."""
    return _NOBODY.search(clause) is not None


def is_of_anything(clause: str) -> bool:
    """Whether it is of something's being there that it does not name ("if there is nothing in the box")."""
    return _ANYTHING.search(clause) is not None


def asks_presence(clause: str) -> bool:
    """Whether it asks only if something is there ("see if there's any milk", "is there any milk")."""
    return _THERE.search(clause) is not None


def is_of_weather(clause: str) -> bool:
    """Whether it is of the weather or the day ("if it's raining", "should it snow"), or of what it is like somewhere
    ("if it's stuffy in here"), so that "it" names nothing."""
    words = re.findall(r"[a-z]+", clause.lower())
    if "it" not in words and "its" not in words:
        return False
    return not WEATHER.isdisjoint(words) or any(is_air(words[i:]) for i in range(len(words)))


def is_air(words: Sequence[str]) -> bool:
    """Whether words (lower case) begin by saying what it is like somewhere: "cold in here", "dark enough outside"."""
    behind = words[2:] if words[1:2] == ["enough"] else words[1:]
    return bool(behind) and words[0] in AIR and behind[0] in WHERE and PARTS.isdisjoint(behind[1:3])
