"""Steps: an instruction that tells one thing after the other, told in another order."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.recombination.stretches import (
    Gerund,
    Part,
    Stretch,
    Telling,
    leaves_of,
    stretch_of,
    tree_of,
)

MOST_STEPS = 5


def reordered(observed: Observed, instruction: Instruction, source: int) -> Iterator[tuple[str, Telling]]:
    """Ways to tell the steps in another order, each with the name of its kind."""
    steps = steps_of(observed, instruction, source)
    if steps is None or not 2 <= len(steps) <= MOST_STEPS:
        return
    flow = tree_of(instruction.flow, source)
    first, last = steps[0], steps[-1]
    if len(steps) == 2 and len(last.tasks) == 1:
        for kind, parts in _two(first, last):
            yield kind, Telling(parts, flow)
    else:
        if len(steps) == 3:
            for kind, parts in _three(*steps):
                yield kind, Telling(parts, flow)
        rest = _sentences(steps[1:])
        for words in _AHEAD:
            yield "ahead", Telling((*rest, f" {words} ", first, "."), flow)
        if len(first.tasks) == 1:
            for words in _AHEAD_BEHIND:
                yield "ahead", Telling((*rest, " ", first, f" {words}."), flow)
    if len(last.tasks) == 1:
        others = _sentences(steps[:-1])
        for words in _AT_THE_END:
            yield "behind", Telling((last, f" {words}. ", *others), flow)
            yield "behind", Telling((last, f", but {words}. ", *others), flow)
        if last.base is not None:
            yield "behind", Telling(("The last thing to do is ", last, ". ", *others), flow)
            yield "behind", Telling(("Finish by ", Gerund(last), ". ", *others), flow)


_AHEAD = (
    "Before any of that,", "But before all that,", "Before you do any of this,", "Before anything else,",
    "But first of all,", "And before any of it,", "But before you start,", "First of all, though,",
)  # fmt: skip
_AHEAD_BEHIND = (
    "before any of that", "before all that", "first of all", "before you do anything else", "before you start",
    "before you begin", "before you start, though", "before you do either", "before you do any of it",
    "before you set off",
)  # fmt: skip
_AT_THE_END = ("at the very end", "last of all", "last", "when all the rest is done", "as the last thing")


def _two(a: Stretch, b: Stretch) -> Iterator[tuple[str, tuple[Part, ...]]]:
    """Ways to tell that `a` comes before `b`, which is one task."""
    for words in (". But before that, ", ". Before that, ", ". But first, ", ". But first ", ". Before you do, ",
                  ". First, though, ", ", but before that ", ", but first ", ", but before you do, ", "; before that, ",
                  " - but first "):  # fmt: skip
        yield "before", (b, words, a, ".")
    if len(a.tasks) == 1:
        for words in ("first", "first, though", "beforehand", "before you do", "before that", "before you do that"):
            yield "before", (b, ". ", a, f" {words}.")
            yield "before", (b, ", but ", a, f" {words}.")
    if b.base is not None:
        yield "clause", ("Before you ", b, ", ", a, ".")
        yield "clause", (a, " before you ", b, ".")
        yield "clause", (a, ", and only then ", b, ".")
        yield "gerund", ("Before ", Gerund(b), ", ", a, ".")
        yield "gerund", (a, " before ", Gerund(b), ".")
    if a.base is not None and len(a.tasks) == 1:
        yield "clause", (b, " after you ", a, ".")
        yield "clause", (b, ", but not before you ", a, ".")
        yield "gerund", (b, " after ", Gerund(a), ".")
        yield "gerund", (b, ", but only after ", Gerund(a), ".")
        yield "gerund", ("After ", Gerund(a), ", ", b, ".")


def _three(a: Stretch, b: Stretch, c: Stretch) -> Iterator[tuple[str, tuple[Part, ...]]]:
    """Ways to tell `a`, `b`, `c`, the second of which, where it is one task, is told before the first, or the third
    before the second."""
    if len(b.tasks) == 1:
        for then in (". Then ", ", and afterwards ", ". After that, ", ", then ", "; after that, "):
            yield "amid", (b, ", but first ", a, then, c, ".")
            yield "amid", (b, ", but before you do, ", a, then, c, ".")
            if b.base is not None:
                yield "amid", ("Before you ", b, ", ", a, then, c, ".")
                yield "amid", (a, " before you ", b, then, c, ".")
                yield "amid", ("Before ", Gerund(b), ", ", a, then, c, ".")
    if len(c.tasks) == 1:
        for words in (", but first ", ", but before you do, ", ", but before that, "):
            yield "late", (a, ". Then ", c, words, b, ".")
        if c.base is not None:
            yield "late", (a, ". Before you ", c, ", ", b, ".")
            yield "late", (a, ". ", b, " before you ", c, ".")
            yield "late", (a, ". Before ", Gerund(c), ", ", b, ".")
        if b.base is not None and len(b.tasks) == 1:
            yield "late", (a, ". Then ", c, ", but not before you ", b, ".")
            yield "late", (a, ". ", c, " after you ", b, ".")


def _sentences(steps: Sequence[Stretch]) -> list[Part]:
    parts: list[Part] = []
    for step in steps:
        parts += [" ", step, "."] if parts else [step, "."]
    return parts


def steps_of(observed: Observed, instruction: Instruction, source: int) -> list[Stretch] | None:
    """The steps in their order, each with its own entries of the flow; None where the instruction does not tell one
    thing after the other, or in words that speak of more than one step ("otherwise", "before")."""
    text = instruction.text
    flow = tree_of(instruction.flow, source)
    order = [leaf.number for leaf in leaves_of(flow)]
    if len(instruction.tasks) < 2 or _SPEAKS_OF_OTHERS.search(text) or order != sorted(order):
        return None
    entries = [frozenset(leaves_of([node])) for node in flow]
    steps: list[Stretch] = []
    start = held = 0
    for cut_start, cut_end in [*_cuts(observed, instruction), (len(text), len(text))]:
        numbers = {task.id for task in instruction.tasks if start <= task.span.start < cut_start}
        count = 0
        while held + count < len(entries) and {leaf.number for leaf in entries[held + count]} <= numbers:
            count += 1
        if numbers != {leaf.number for entry in entries[held : held + count] for leaf in entry}:
            continue
        if numbers:
            step = stretch_of(observed, instruction, source, start, cut_start)
            if step is None or not (step.base is not None or _OPENS.match(step.text)):
                return None
            steps.append(step)
        start, held = cut_end, held + count
    return steps if held == len(entries) else None


def _cuts(observed: Observed, instruction: Instruction) -> list[tuple[int, int]]:
    """The stretches of text between what may be steps."""
    document = observed.document
    found = [match.span() for match in _CUT.finditer(instruction.text)]
    places = {token.start: token.i for token in document.tokens}
    for task in instruction.tasks:
        i = first = places.get(task.span.start, 0)
        while i and document.tokens[first].tag in ("VB", "VBP") and document.tokens[i - 1].lower in ("and", ","):
            i -= 1
        if 0 < i < first:
            found.append((document.tokens[i - 1].end, task.span.start))
    apart: list[tuple[int, int]] = []
    for cut in sorted(found):
        if not apart or cut[0] >= apart[-1][1]:
            apart.append(cut)
    return apart


_CUT = re.compile(r"[.!?;](?: +|$)(?:(?:and )?(?:then|after that|next),? )?|,? (?:and )?then ", re.IGNORECASE)
_SPEAKS_OF_OTHERS = re.compile(
    r"\b(before|beforehand|after|afterwards|first|last|lastly|finally|once|until|till|instead|otherwise|else|unless|"
    r"either way|in any case|regardless|anyway|whichever|meanwhile|while|earlier|later|same|secondly|step)\b",
    re.IGNORECASE,
)
_OPENS = re.compile(r"(?:please|kindly|if (?:the|my|your|our|there|any|\w+'s)) ", re.IGNORECASE)
