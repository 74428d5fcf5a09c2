"""Questions: what a message asks that has to be found out before it can be said ("whether the lamp is on")."""

from __future__ import annotations

import re

from decomplex_bt.instruction import Argument

_BE = r" (?:is|are)(?:n['\u2019]t| not)?(?: still| already| really)?"
_CONTRACTED = r"['\u2019](?:s|re)(?: not)?(?: still| already| really)?"
_THERE = re.compile(
    rf"(?:whether|if) there(?:{_BE}|{_CONTRACTED}) (?P<object>.+?)(?: (?P<location>(?:in|on|at|inside) .+))?$",
    re.IGNORECASE,
)
_SO = tuple(
    re.compile(rf"(?:whether|if) (?P<object>.+?){be} (?P<rest>.+)$", re.IGNORECASE) for be in (_BE, _CONTRACTED)
)
"""A contracted "is" only where no other is said: "if Anna's phone is on"."""
_WHERE = re.compile(r"where(?:['\u2019](?:s|re))? (?P<object>.+?)(?: (?:is|are))?$", re.IGNORECASE)
_WHAT = re.compile(
    r"wh(?:at|o)(?:['\u2019](?:s|re)| is| are)? (?:there )?(?P<location>(?:in|on|at|inside) .+)$", re.IGNORECASE
)
_HOW_MANY = re.compile(
    r"how (?:many|much) .+? (?:there )?(?:is|are) (?:there )?(?P<location>(?:in|on|at|inside) .+)$", re.IGNORECASE
)
_AT = re.compile(r"(?:in|on|at|inside|under|beside|next to|with) (?:the|my|your|her|his) ", re.IGNORECASE)
_TAIL = re.compile(r"(?: or not| now|[\s.,!?])+$")


def question_of(message: str) -> tuple[str, tuple[Argument, ...]] | None:
    """The type of the task that answers a message, with its arguments; None where the message is no question that
    somebody who looks can answer."""
    words = _TAIL.sub("", message.strip())
    if match := _THERE.match(words):
        return "check_state", _arguments(match, "object", "location")
    if match := next(filter(None, (pattern.match(words) for pattern in _SO)), None):
        kind = "location" if _AT.match(match["rest"]) else "state"
        return "check_state", (Argument("object", match["object"]), Argument(kind, match["rest"]))
    if match := _WHERE.match(words):
        return "searching", _arguments(match, "object")
    if match := _WHAT.match(words) or _HOW_MANY.match(words):
        return "searching", _arguments(match, "location")
    return None


def _arguments(match: re.Match[str], *names: str) -> tuple[Argument, ...]:
    return tuple(Argument(name, match[name]) for name in names if match[name])
