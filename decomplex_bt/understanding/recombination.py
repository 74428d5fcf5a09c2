"""Recombined copies of annotated instructions: the same tasks told in another order, the same condition in another
wording, so that a network learns what "before that" and "unless" mean whatever they are said of."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from decomplex_bt.flow import Flow, If, Node
from decomplex_bt.instruction import Instruction, Span
from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.features import Observed

Tree = list[Any]
"""A flow as its JSON, by the task numbers of the instruction it was taken from."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """Words of an instruction that keep together. `base`: where its first verb begins, if it is the first word and in
    its base form ("put"): then it may follow "before you". `tasks`: the numbers of its tasks."""

    start: int
    end: int
    tasks: tuple[int, ...]
    base: Span | None


@dataclass(frozen=True, slots=True)
class Telling:
    """A text in parts, and the flow that it means. Where a stretch is a gerund it is `(stretch, "ing")`."""

    parts: tuple[str | Stretch | tuple[Stretch, str], ...]
    flow: Tree


def recombined(observed: Observed, instruction: Instruction, rng: np.random.Generator) -> Instruction | None:
    """A copy that tells the same tasks otherwise; None where the instruction is of no kind that can be taken apart.

    The flow of the copy is what its words say, not always that of the instruction. Referents stay as they were.
    """
    tellings = [*_told_otherwise(observed, instruction), *_asked_otherwise(observed, instruction)]
    groups = {kind: [t for k, t in tellings if k == kind] for kind, _ in tellings}
    if not groups:
        return None
    kind = sorted(groups)[int(rng.integers(len(groups)))]
    return _composed(observed.document, instruction, groups[kind][int(rng.integers(len(groups[kind])))])


# Order


def _told_otherwise(observed: Observed, instruction: Instruction) -> Iterator[tuple[str, Telling]]:
    """Steps in the order of the text, told in another order."""
    units = _units(observed, instruction)
    if units is None or not 2 <= len(units) <= 5:
        return
    flow = instruction.flow.to_json()
    steps = [Telling((unit,), _of(flow, unit.tasks)) for unit in units]
    first, rest = units[0], units[1:]
    whole = [n for step in steps for n in step.flow]
    others = _sentences(rest)
    if len(rest) == 1 and len(rest[0].tasks) == 1:
        b = rest[0]
        for words in ("But before that, ", "Before that, ", "But first, ", "But first ", "Before you do, ", "First, though, "):
            yield "before", Telling((b, ". " + words, first, "."), whole)
        for words in (", but before that ", ", but first ", ", but before you do, ", "; before that, ", " - but first "):
            yield "before", Telling((b, words, first, "."), whole)
        if len(first.tasks) == 1:
            for words in (" first", " first, though", " beforehand", " before you do", " before that", " before you do that"):
                yield "before", Telling((b, ". ", first, words + "."), whole)
                yield "before", Telling((b, ", but ", first, words + "."), whole)
        if b.base:
            yield "clause", Telling(("Before you ", b, ", ", first, "."), whole)
            yield "clause", Telling((first, " before you ", b, "."), whole)
            yield "clause", Telling((first, ", and only then ", b, "."), whole)
            yield "gerund", Telling(("Before ", (b, "ing"), ", ", first, "."), whole)
            yield "gerund", Telling((first, " before ", (b, "ing"), "."), whole)
        if first.base and len(first.tasks) == 1:
            yield "clause", Telling((b, " after you ", first, "."), whole)
            yield "clause", Telling((b, ", but not before you ", first, "."), whole)
            yield "gerund", Telling((b, " after ", (first, "ing"), "."), whole)
            yield "gerund", Telling((b, ", but only after ", (first, "ing"), "."), whole)
            yield "gerund", Telling(("After ", (first, "ing"), ", ", b, "."), whole)
    else:
        for words in (
            "Before any of that, ", "But before all that, ", "Before you do any of this, ", "Before anything else, ",
            "But first of all, ", "And before any of it, ", "But before you start, ", "First of all, though, ",
        ):  # fmt: skip
            yield "ahead", Telling((*others, " " + words, first, "."), whole)
        if len(first.tasks) == 1:
            for words in (" before any of that", " before all that", " first of all", " before you do anything else"):
                yield "ahead", Telling((*others, " ", first, words + "."), whole)
    last, ahead = units[-1], units[:-1]
    if len(last.tasks) == 1 and len(whole) > 1:
        told = _sentences(ahead)
        for words in (" at the very end", " last of all", " last", " when all the rest is done", " as the last thing"):
            yield "behind", Telling((last, words + ". ", *told), whole)
            yield "behind", Telling((last, ", but" + words + ". ", *told), whole)
        if last.base:
            yield "behind", Telling(("The last thing to do is ", last, ". ", *told), whole)
            yield "behind", Telling(("Finish by ", (last, "ing"), ". Before that, ", *told), whole)


def _sentences(units: Sequence[Stretch]) -> list[str | Stretch]:
    """The units as sentences."""
    parts: list[str | Stretch] = []
    for k, unit in enumerate(units):
        parts += [" ", unit, "."] if k else [unit, "."]
    return parts


def _units(observed: Observed, instruction: Instruction) -> list[Stretch] | None:
    """The steps of an instruction, if it tells them one after the other: stretches of text, each with its own entries
    of the flow; None where words of order or of return speak of more than one."""
    text, document = instruction.text, observed.document
    flow = instruction.flow.to_json()
    if len(instruction.tasks) < 2 or _ORDER.search(text) or _numbers(flow) != sorted(_numbers(flow)):
        return None
    spans = [_numbers([node]) for node in flow]
    units: list[Stretch] = []
    start, held = 0, 0
    for cut in [*_cuts(document, instruction), (len(text), len(text))]:
        tasks = [t.id for t in instruction.tasks if start <= t.span.start < cut[0]]
        taken = 0
        while held + taken < len(spans) and set(spans[held + taken]) <= set(tasks):
            taken += 1
        if set(tasks) == {n for numbers in spans[held : held + taken] for n in numbers}:
            stretch = _stretch(document, instruction, start, cut[0], tasks) if tasks else None
            if tasks and (stretch is None or not _stands_alone(text[stretch.start : stretch.end], stretch)):
                return None
            units += [stretch] if stretch else []
            start, held = cut[1], held + taken
    return units if held == len(spans) else None


def _stands_alone(words: str, stretch: Stretch) -> bool:
    return stretch.base is not None or _OPENS.match(words) is not None


def _cuts(document: Document, instruction: Instruction) -> list[tuple[int, int]]:
    """The stretches of text between what may be steps."""
    found = [match.span() for match in _CUT.finditer(instruction.text)]
    places = {token.start: token.i for token in document.tokens}
    for task in instruction.tasks:
        i = first = places.get(task.span.start, 0)
        if document.tokens[i].tag not in ("VB", "VBP"):
            continue
        while i and document.tokens[i - 1].lower in ("and", ","):
            i -= 1
        if 0 < i < first:
            found.append((document.tokens[i - 1].end, task.span.start))
    ordered: list[tuple[int, int]] = []
    for cut in sorted(found):
        if not ordered or cut[0] >= ordered[-1][1]:
            ordered.append(cut)
    return ordered


_CUT = re.compile(r"[.!?;](?: +|$)(?:(?:and )?(?:then|after that|next),? )?|,? (?:and )?then ", re.IGNORECASE)
_ORDER = re.compile(
    r"\b(before|beforehand|after|afterwards|first|last|lastly|finally|once|until|till|instead|otherwise|else|unless|"
    r"either way|in any case|regardless|anyway|whichever|meanwhile|while|earlier|later|same|secondly|step)\b",
    re.IGNORECASE,
)
_OPENS = re.compile(r"(?:please|kindly|if (?:the|my|your|our|there|any|\w+'s)) ", re.IGNORECASE)


# Conditions


def _asked_otherwise(observed: Observed, instruction: Instruction) -> Iterator[tuple[str, Telling]]:
    """A condition with what follows from it, in other words."""
    found = _condition(observed, instruction)
    if found is None:
        return
    ahead, behind, node, c, x, y = found
    side, other = ("then", "else") if set(_numbers(node.get("then", []))) == set(x.tasks) else ("else", "then")
    means = {"if": node["if"], side: node[side]}
    text = instruction.text[c.start : c.end]
    is_plain = not re.search(r"n['’]t\b|\b(not|no|nothing|nobody|none|never)\b", text)

    def telling(kind: str, *parts: Any, flow: dict[str, Any] = means) -> tuple[str, Telling]:
        return kind, Telling((*ahead[0], *parts, *behind[0]), [*ahead[1], flow, *behind[1]])

    after = next((part for part in behind[0] if isinstance(part, Stretch)), None)
    if after is not None and after.base:
        for words in ("Either way, ", "In any case, ", "Whatever happens, ", "Whichever it is, "):
            told = ["If ", c, ", ", x, *(("; otherwise ", y) if y else ()), ". ", words, after, "."]
            yield "either way", Telling((*ahead[0], *told), [*ahead[1], node, *behind[1]])

    single = len(x.tasks) == 1  # "sweep the hall and wash it if it is dirty": both, or the last one? nobody can tell
    if y is None:
        if single:
            for words in (" if ", ", but only if ", " only if ", ", provided ", " as long as ", " provided that ", ", if "):
                yield telling("if", x, words, c, ".")
        yield telling("if", "If ", c, ", ", x, ".")
        yield telling("if", c, "? ", x, ".")
        yield telling("if", c, "? Then ", x, ".")
        if x.base:
            yield telling("only", "Only ", x, " if ", c, ".")
            if single:
                yield telling("only", "Don't ", x, " unless ", c, ".")
                yield telling("only", "Don't ", x, " if ", c, ".", flow={"if": node["if"], other: node[side]})
        if is_plain:
            flipped = {"if": node["if"], other: node[side]}
            yield telling("unless", "Unless ", c, ", ", x, ".", flow=flipped)
            if single:
                yield telling("unless", x, " unless ", c, ".", flow=flipped)
                yield telling("unless", x, ", unless ", c, ".", flow=flipped)
        return
    means[other] = node[other]
    for words in ("; otherwise ", ". Otherwise, ", ". If not, ", ", if not ", ", or else ", "; else ", "; if not, "):
        yield telling("else", "If ", c, ", ", x, words, y, ".")
        if single:
            yield telling("else", x, " if ", c, words, y, ".")
    for words in (". If not, ", ". Otherwise ", "; if not, "):
        yield telling("else", c, "? ", x, words, y, ".")
        if single:
            yield telling("else", x, " as long as ", c, words, y, ".")
    if is_plain:
        yield telling("unless", "Unless ", c, ", ", y, "; if so, ", x, ".")
    if len(y.tasks) > 1:
        return
    for words in (". If ", ". But if ", ", but if ", "; if ", ". Only if "):
        yield telling("instead", y, words, c, ", ", x, " instead.")
    if is_plain:
        yield telling("unless", y, ", unless ", c, ", in which case ", x, ".")
        yield telling("unless", y, " unless ", c, ", in which case ", x, ".")
        yield telling("unless", y, " unless ", c, "; if so, ", x, ".")


Around = tuple[tuple[str | Stretch, ...], Tree]


def _condition(
    observed: Observed, instruction: Instruction
) -> tuple[Around, Around, dict[str, Any], Stretch, Stretch, Stretch | None] | None:
    """A condition in sentences of its own: what is told before and after it, its node, its clause, what follows where
    it holds as stated, and what follows otherwise, if anything."""
    text, document = instruction.text, observed.document
    if _RETURN.search(text):
        return None
    flow = instruction.flow.to_json()
    for k, node in enumerate(flow):
        if not isinstance(node, dict) or not isinstance(node.get("if"), int):
            continue
        numbers = _numbers([node])
        if sorted(_numbers(flow)) != list(range(1, len(instruction.tasks) + 1)):
            return None
        before, after = _numbers(flow[:k]), _numbers(flow[k + 1 :])
        if any(n > min(numbers) for n in before) or any(n < max(numbers) for n in after):
            return None
        spans = [instruction.tasks[n - 1].span for n in numbers]
        first, last = min(spans).start, max(spans).end
        end = next((m.start() for m in _SENTENCE.finditer(text, last)), len(text))
        starts = [0, *(m.end() for m in _OPENING.finditer(text, 0, first))]
        start, found = next(((s, f) for s in reversed(starts) if (f := _split(text[s:end])) is not None), (0, None))
        if found is None:
            continue
        pieces = [Span(a + start, b + start) for a, b in found]
        c, x, *y = [
            _stretch(
                document, instruction, s.start, s.end, [t.id for t in instruction.tasks if s.start <= t.span.start < s.end]
            )
            for s in pieces
        ]
        if c is None or x is None or not c.tasks or c.tasks != (node["if"],) or (y and (y[0] is None or not y[0].tasks)):
            continue
        sides = [set(_numbers(node.get(side, []))) for side in ("then", "else")]
        wanted = [set(x.tasks), set(y[0].tasks) if y and y[0] else set()]
        if wanted not in (sides, sides[::-1]) or not wanted[0]:
            continue
        ahead = _stretch(document, instruction, 0, start, before)
        behind = _stretch(document, instruction, end, len(text), after)
        if (ahead is None and before) or (behind is None and after):
            continue
        return (
            ((ahead, ". ") if ahead and before else (), flow[:k]),
            ((" ", behind, ".") if behind and after else (), flow[k + 1 :]),
            node,
            c,
            x,
            y[0] if y else None,
        )
    return None


def _split(core: str) -> list[tuple[int, int]] | None:
    """Where in its sentences the condition stands, what follows from it, and what follows otherwise."""
    for pattern in (_IF_ELSE, _IF, _THEN_IF):
        match = pattern.fullmatch(core)
        if match:
            return [match.span(name) for name in ("c", "x", "y") if name in pattern.groupindex]
    return None


_SENTENCE = re.compile(r"[.!?;] +|[.!?;]$")
_OPENING = re.compile(r"[.!?;] +|,? (?:and|but) (?=if )|, (?=if )")
_CLAUSE = r"[^,.;!?]+"
_IF_ELSE = re.compile(
    rf"[Ii]f (?P<c>(?!so\b|not\b){_CLAUSE}), (?:then )?(?P<x>[^.;!?]+?)(?:[,;.] (?:otherwise|Otherwise|if not|If not|or else),? )"
    rf"(?P<y>[^.;!?]+)"
)
_IF = re.compile(rf"[Ii]f (?P<c>(?!so\b|not\b){_CLAUSE}), (?:then )?(?P<x>[^.;!?]+)")
_THEN_IF = re.compile(rf"(?P<x>[^.;!?]+?)(?<!but)(?<!not)(?<!and)(?<!or)(?<!see)(?<!check),? if (?P<c>(?!so\b|not\b){_CLAUSE})")
_RETURN = re.compile(
    r"\b(instead|unless|before|after|first|last|until|till|once|only|even|while|whether|in which case|that case|still|"
    r"too|either|anyway|regardless|also)\b|\bif\b.*\bif\b(?! not)",
    re.IGNORECASE | re.DOTALL,
)


# Text


def _stretch(
    document: Document, instruction: Instruction, start: int, end: int, tasks: Sequence[int]
) -> Stretch | None:
    """The words from `start` to `end`, without marks and spaces around; None where they do not keep together."""
    tokens = [t for t in document.tokens if start <= t.start and t.end <= end]
    while tokens and (not any(map(str.isalnum, tokens[-1].text)) or tokens[-1].lower in ("and", "but", "so")):
        tokens.pop()
    while tokens and not any(map(str.isalnum, tokens[0].text)):
        tokens.pop(0)
    if not tokens:
        return None
    span = Span(tokens[0].start, tokens[-1].end)
    own = [instruction.tasks[n - 1] for n in tasks]
    said = [task.span for task in own] + [a.span for task in own for a in task.arguments if a.span is not None]
    if any(not (span.start <= s.start and s.end <= span.end) for s in said):
        return None
    crossing = [
        a.span for t in instruction.tasks if t.id not in tasks for a in t.arguments if a.span is not None
    ]
    if any(s.start < span.end and span.start < s.end for s in crossing):
        return None
    opener = tokens[0]
    verb = next((t for t in tokens if own and t.start == own[0].span.start and t.tag in ("VB", "VBP")), None)
    if verb is not None and not _SAYS.search(instruction.text[span.start : verb.start]):
        if not any(span.start <= s.start < verb.start for s in said):
            opener, span = verb, Span(verb.start, span.end)  # without "could you" and its like
    is_base = opener is verb
    return Stretch(span.start, span.end, tuple(sorted(tasks)), Span(opener.start, opener.end) if is_base else None)


_SAYS = re.compile(r"\b(if|when|once|not|never|whether|who|what|which|until|as)\b|n['’]?t\b|[.!?;:]", re.IGNORECASE)


def _composed(document: Document, instruction: Instruction, telling: Telling) -> Instruction | None:
    """The text of a telling with its annotation; None where a verb has no gerund that we know."""
    text = ""
    moved: dict[int, int] = {}  # by how much the tasks of a stretch have moved
    grown: dict[int, int] = {}  # by how much the verb that opens a gerund has grown
    starts = {token.start: token for token in document.tokens}
    for part in telling.parts:
        if isinstance(part, str):
            text += part
            continue
        stretch, form = part if isinstance(part, tuple) else (part, "")
        words = instruction.text[stretch.start : stretch.end]
        if form and stretch.base is not None:
            verb = stretch.base.of(instruction.text)
            gerund = _gerund(verb)
            if gerund is None or len(stretch.tasks) != 1:
                return None
            words = gerund + words[len(verb) :]
            grown[stretch.tasks[0]] = len(gerund) - len(verb)
        opens = not text or text.rstrip()[-1:] in (".", "?", "!")
        if opens:
            words = words[:1].upper() + words[1:]
        elif not _is_name(starts[stretch.start]):
            words = words[:1].lower() + words[1:]
        for number in stretch.tasks:
            moved[number] = len(text) - stretch.start
        text += words
    text = text[:1].upper() + text[1:]
    if set(moved) != set(_numbers(telling.flow)):
        return None

    def carried(span: Span, number: int) -> Span:
        shift, extra = moved[number], grown.get(number, 0)
        verb = instruction.tasks[number - 1].span
        if span == verb:
            return Span(span.start + shift, span.end + shift + extra)
        return Span(span.start + shift + extra, span.end + shift + extra)

    kept = sorted((carried(t.span, t.id), t) for t in instruction.tasks if t.id in moved)
    numbers = {task.id: k for k, (_, task) in enumerate(kept, start=1)}
    tasks = tuple(
        replace(
            task,
            id=numbers[task.id],
            span=span,
            arguments=tuple(
                replace(a, span=carried(a.span, task.id) if a.span is not None else None) for a in task.arguments
            ),
        )
        for span, task in kept
    )
    return Instruction(text, tasks, Flow.from_json(_renumbered(telling.flow, numbers), task_count=len(tasks)))


def _is_name(token: Token) -> bool:
    return token.tag in ("NNP", "NNPS") or token.text == "I" or token.text[1:2].isupper()


def _gerund(verb: str) -> str | None:
    """The "-ing" form of a regular spelling."""
    if not re.fullmatch(r"[A-Za-z]+", verb):
        return None
    if re.search(r"[^aeiouy]e$|ue$", verb):
        return verb[:-1] + "ing"
    if re.fullmatch(r"[^aeiou]*[aeiou][bdgklmnprt]", verb, re.IGNORECASE) and not re.search(r"[aeiou]{2}.$", verb):
        return verb + verb[-1] + "ing"
    return verb + "ing"


def _numbers(tree: Sequence[Any]) -> list[int]:
    found: list[int] = []
    for node in tree:
        if isinstance(node, int):
            found.append(node)
        elif "same" in node:
            found += node["same"]
        else:
            conditions = node["if"] if isinstance(node["if"], list) else [node["if"]]
            found += [*conditions, *_numbers(node.get("then", [])), *_numbers(node.get("else", []))]
    return found


def _of(flow: Tree, tasks: Sequence[int]) -> Tree:
    return [node for node in flow if set(_numbers([node])) <= set(tasks)]


def _renumbered(tree: Tree, numbers: dict[int, int]) -> Tree:
    found: Tree = []
    for node in tree:
        if isinstance(node, int):
            found.append(numbers[node])
        elif "same" in node:
            found.append({"same": sorted(numbers[n] for n in node["same"])})
        else:
            conditions = node["if"]
            copy: dict[str, Any] = {
                "if": sorted(numbers[n] for n in conditions) if isinstance(conditions, list) else numbers[conditions]
            }
            copy |= {side: _renumbered(node[side], numbers) for side in ("then", "else") if side in node}
            found.append(copy)
    return found
