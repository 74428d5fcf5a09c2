"""Exclusions: what of all that a task's objects name is left out ("all the lights except the one in the hall")."""

from __future__ import annotations

import re
from dataclasses import replace

from decomplex_bt.instruction import Argument, Instruction, Task

_EXCEPT = re.compile(
    r"[\s,]*\b(?:except(?:ing)?(?: for)?|apart from|other than|save for|"
    r"but not(?! (?:if|when|before|after|until|unless|yet|while)\b))\s+",
    re.IGNORECASE,
)
_END = re.compile(r"[.;!?,]|(?:\s+(?:and|then|but|or))*\s*$|\s+(?:if|unless)\b", re.IGNORECASE)
_ENDS_IN_ONE = re.compile(r"\bones?\s*$", re.IGNORECASE)
_ONE = re.compile(r"\bones?\b", re.IGNORECASE)


def without_exclusion(instruction: Instruction, task: Task) -> tuple[Task, str | None]:
    """The task without the words that tell what is left out, and those words; None where it leaves out nothing."""
    said = [argument.span for argument in task.arguments if argument.type == "object" and argument.span is not None]
    if not said:
        return task, None
    text = instruction.text
    end = min([t.span.start for t in instruction.tasks if t.span.start > said[0].start], default=len(text))
    match = _EXCEPT.search(text, said[0].start, end)
    if match is None:
        return task, None
    before = {a.type for a in task.arguments if a.span is None or a.span.start < match.start()}
    kept: list[Argument] = []
    for argument in task.arguments:
        span = argument.span
        if span is None or span.end <= match.start():
            kept.append(argument)
        elif span.start < match.start():
            kept.append(
                replace(argument, value=text[span.start : match.start()], span=replace(span, end=match.start()))
            )
        elif argument.type not in ("object", "location", *before) and not (
            argument.type == "source" and _ENDS_IN_ONE.search(text[match.end() : span.start])
        ):
            kept.append(argument)
            end = min(end, span.start)
    words = text[match.end() : end]
    words = words[: _END.search(words).start()]  # type: ignore[union-attr]  # it finds the end at the latest
    return replace(task, arguments=tuple(kept)), words.strip() or None


def excluded_phrase(words: str, noun: str, prepositions: tuple[str, ...]) -> str:
    """The words with the noun that they leave unsaid: "the one in the hall", "the bedroom one", "in the bath"."""
    if words.lower().split()[0] in prepositions:
        return f"the {noun} {words}"
    return _ONE.sub(noun, words)
