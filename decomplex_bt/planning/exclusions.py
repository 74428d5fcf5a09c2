"""Exclusions: what a text says beside a task's objects about which of them are meant: those left out ("all the lights
except the one in the hall", "a mug that is not red"), those that are something ("the windows that are open").
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from decomplex_bt.instruction import Argument, Instruction, Task

_EXCEPT = re.compile(
    r"[\s,]*\b(?:(?:all )?(?:except(?:ing)?(?: for)?|excluding|apart from|aside from|other than|save for|but for)|"
    r"(?P<but>(?:all )?but(?= (?:the|my|our|your|his|her|that|those)\b))|"
    r"(?<=where )but(?= (?:in|on|at|by|under) )|"
    r"(?P<skip>(?:(?:and|but|just) )*(?:skip|omit|leave out)(?= (?:the|my|our|your|his|her|that|those)\b))|"
    r"but not(?! (?:if|when|before|after|until|unless|yet|while)\b)|"
    r"(?P<aside>(?:(?:and )?not|(?:but|just) leave)(?= (?:the|a|an|any|my|that|those)\b))|"
    r"(?P<clause>(?:that|which)(?: (?:is|are)(?:n['\u2019]t| not)|['\u2019](?:s|re) not)(?: yet)?))\s+",
    re.IGNORECASE,
)
_FRONTED = re.compile(
    r"(?:^|[.;!?,:])\s*(?:(?:and|but|then|so)\s+)?"
    r"(?:except(?:ing)?(?: for)?|excluding|apart from|aside from|save for)\s+(?P<words>[^.;!?,]+?)(?:,[^.;!?]*|\s*)$",
    re.IGNORECASE,
)
"""Ahead of the verb: "*except for the kitchen*, turn all the lights off"."""
_WHOLE = re.compile(r"\b(?:all|every\w*|any\w*|each|no|nothing|both)\b", re.IGNORECASE)
_BEING = re.compile(
    r",?\s+(?:that|which)(?:\s+(?:is|are)|['\u2019](?:s|re))(?:\s+(?:still|already|currently))?"
    r"\s+((?:switched |turned |plugged )?\w+)\b",
    re.IGNORECASE,
)
_IN_CASE = re.compile(r"[^.;!?,]*\b(?:if|unless|when)\b", re.IGNORECASE)
_WHERE_IT_IS = re.compile(r"\s+(?:where|as)\s.*$", re.IGNORECASE | re.DOTALL)
"""Behind "but leave the remote" alone: "except the one where Tom is" tells which."""
_END = re.compile(r"[.;!?,]|(?:\s+(?:and|then|but|or))*\s*$|\s+(?:if|unless)\b", re.IGNORECASE)
_JOINT = re.compile(r"\b(?:and|but|then|so)[\s,]*$", re.IGNORECASE)
_ENDS_IN_ONE = re.compile(r"\bones?\s*$", re.IGNORECASE)
_ONE = re.compile(r"\bones?\b", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Exclusion:
    """The words for what is left out. `is_aside`: they only set it against what is said ("the cup, not the mug"), so
    that they need not name anything."""

    words: str
    is_aside: bool = False


def without_exclusion(instruction: Instruction, task: Task) -> tuple[Task, Exclusion | None]:
    """The task without the words that tell what is left out, and these; None where it leaves out nothing."""
    said = [argument.span for argument in task.arguments if argument.type == "object" and argument.span is not None]
    if not said:
        return task, None
    text = instruction.text
    end = scope = min([t.span.start for t in instruction.tasks if t.span.start > said[0].start], default=len(text))
    match = next((m for m in _EXCEPT.finditer(text, said[0].start, end) if _is_left_out(text, said[0].start, m)), None)
    if match is None:
        return _without_fronted(instruction, task)
    dropped = {"object", "location", *(("state",) if match["clause"] else ())}
    dropped |= {a.type for a in task.arguments if a.span is None or a.span.start < match.start()}
    aside_end = match.end() + _END.search(text[match.end() : scope]).start()  # type: ignore[union-attr]
    kept: list[Argument] = []
    for argument in task.arguments:
        span = argument.span
        is_beyond = span is not None and span.start >= (aside_end if match["aside"] else scope)
        if span is None or span.end <= match.start() or is_beyond:
            kept.append(argument)
        elif span.start < match.start():
            kept.append(
                replace(argument, value=text[span.start : match.start()], span=replace(span, end=match.start()))
            )
        elif argument.type not in dropped and not (
            argument.type == "source" and _ENDS_IN_ONE.search(text[match.end() : span.start])
        ):
            kept.append(argument)
            end = min(end, span.start)
    words = text[match.end() : end]
    words = words[: _END.search(words).start()].strip()  # type: ignore[union-attr]  # it finds the end at the latest
    if match[0].split()[-1].lower() == "leave":
        words = _WHERE_IT_IS.sub("", words)
    if match["clause"] and len(words.split()) == 1:
        words = f"the {words} one"  # "that is not red"
    return replace(task, arguments=tuple(kept)), Exclusion(words, bool(match["aside"])) if words else None


def _without_fronted(instruction: Instruction, task: Task) -> tuple[Task, Exclusion | None]:
    """The same where that is said ahead of the verb, and behind the order before."""
    before = max((t.span.end for t in instruction.tasks if t.span.end <= task.span.start), default=0)
    match = _FRONTED.search(instruction.text[: task.span.start], before)
    if match is None:
        return task, None
    first, last = match.span("words")
    kept = tuple(a for a in task.arguments if a.span is None or not first <= a.span.start < last)
    return replace(task, arguments=kept), Exclusion(match["words"].strip())


def _is_left_out(text: str, start: int, match: re.Match[str]) -> bool:
    """Whether it leaves out something of what is named before it, and not of what an order behind it names ("open the
    curtains *and, except for the hall,* turn ..."); a "but" or "skip" of all ("every lamp but the one in the hall"),
    and what is skipped not in a case alone."""
    is_ahead = _JOINT.search(text, start, match.start()) is not None
    is_of_all = bool(match["but"] or match["skip"])
    is_in_case = match["skip"] is not None and _IN_CASE.match(text, match.end()) is not None
    return not (is_ahead or is_in_case) and (not is_of_all or _WHOLE.search(text, start, match.end()) is not None)


def with_clauses(instruction: Instruction, task: Task) -> Task:
    """The task with what a clause says its objects are taken into their words ("the windows" that are "open")."""
    for argument in task.arguments:
        span = argument.span
        if argument.type != "object" or span is None:
            continue
        match = _BEING.match(instruction.text, span.end)
        if match is None or any(span.end <= other.span.start < match.end() for other in instruction.tasks):
            continue
        others = [a for a in task.arguments if a.span is None or not match.start(1) <= a.span.start < match.end()]
        inside = [a.span.end for a in task.arguments if a not in others and a.span is not None]
        if max(inside, default=match.end()) <= match.end():  # else it says where they are
            longer = replace(argument, value=argument.value + match[0], span=replace(span, end=match.end()))
            task = replace(task, arguments=tuple(longer if a is argument else a for a in others))
    return task


def excluded_phrase(words: str, noun: str, prepositions: tuple[str, ...]) -> str:
    """The words with the noun that they leave unsaid: "the one in the hall", "the bedroom one", "in the bath"."""
    if words.lower().split()[0] in prepositions:
        return f"the {noun} {words}"
    return _ONE.sub(noun, words)
