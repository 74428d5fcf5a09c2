"""How far two annotations of the same instructions agree: labels, spans, control flow, values; where they differ."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from decomplex_bt.corpus import Example
from decomplex_bt.errors import InputError
from decomplex_bt.evaluation import metrics
from decomplex_bt.evaluation.metrics import F1, LanguageScores
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.instruction import Argument, Instruction, Span, Task

Pair = tuple[Instruction, Instruction]
Marks = Callable[[Instruction], Iterator[tuple[Span, str]]]
"""What is labelled in an instruction: spans, with their labels."""
OUTSIDE = "O"
_TOKEN = re.compile(r"\w+(?=n['’]t\b)|n['’]t\b|['’]\w+|\w+|[^\w\s]")


@dataclass(frozen=True, slots=True)
class Agreement:
    """Two annotations held against each other; every measure is the same with the two exchanged.

    `scores`: as of readings against gold ones. `task_kappa`, `argument_kappa`: Cohen's, over the labels of all tokens
    (types, and arguments in BIO), chance being each annotator's own shares; None where all tokens have one label.
    `complex_flow`: same tasks and same flow, of instructions with several tasks in either. `values`: of the arguments
    that both have (type, span, owner), those with the same value, upper and lower case alike. `implied`: arguments
    without words (owner, type and value).
    """

    instructions: int
    scores: LanguageScores
    task_kappa: float | None
    argument_kappa: float | None
    complex_flow: Proportion
    values: Proportion
    implied: F1

    def to_json(self) -> dict[str, Any]:
        return {
            "instructions": self.instructions,
            "tasks": self.scores.tasks.to_json(),
            "task_kappa": _rounded(self.task_kappa),
            "arguments": self.scores.arguments.to_json(),
            "argument_kappa": _rounded(self.argument_kappa),
            "dependencies": self.scores.dependencies.to_json(),
            "flow_identical": self.scores.flow.to_json(),
            "flow_identical_complex": self.complex_flow.to_json(),
            "values_identical": self.values.to_json(),
            "implied": self.implied.to_json(),
            "all_identical": self.scores.strict.to_json(),
        }

    def __str__(self) -> str:
        scores = self.scores
        rows = [
            ("instructions", str(self.instructions)),
            ("tasks, F1", f"{scores.tasks.overall.value:.3f}"),
            ("tasks, kappa", _shown(self.task_kappa)),
            ("arguments, F1", f"{scores.arguments.overall.value:.3f}"),
            ("arguments, kappa", _shown(self.argument_kappa)),
            ("dependencies, F1", f"{scores.dependencies.overall.value:.3f}"),
            ("flow identical", str(scores.flow)),
            ("flow identical, complex ones", str(self.complex_flow)),
            ("values identical", str(self.values)),
            ("implied arguments, F1", f"{self.implied.value:.3f}"),
            ("all identical", str(scores.strict)),
        ]
        return "\n".join(f"{title:<30}{value}" for title, value in rows)


@dataclass(frozen=True, slots=True)
class Disagreement:
    """Where two annotations of an instruction differ (in tasks, arguments, flow, values); a line each difference."""

    id: str
    kinds: tuple[str, ...]
    text: str
    differences: tuple[str, ...]

    def to_json(self) -> dict[str, Any]:
        return {"id": self.id, "kinds": list(self.kinds), "text": self.text, "differences": list(self.differences)}

    def __str__(self) -> str:
        return "\n  ".join([f"{self.id} ({', '.join(self.kinds)}): {self.text}", *self.differences])


def matched(first: Iterable[Example], second: Iterable[Example]) -> list[tuple[Example, Example]]:
    """The examples of both annotations by id, in the order of the second, which may be of fewer instructions.

    Raises `InputError` where the second has an id or a text that the first has not.
    """
    by_id = {example.id: example for example in first}
    pairs = []
    for other in second:
        one = by_id.get(other.id)
        if one is None:
            raise InputError(f"{other.id!r} is in the second annotation only; give a first one that has it")
        if one.instruction.text != other.instruction.text:
            raise InputError(
                f"{other.id!r}: the two annotations are of different texts, "
                f"{one.instruction.text!r} and {other.instruction.text!r}"
            )
        pairs.append((one, other))
    return pairs


def agreement(pairs: Sequence[Pair]) -> Agreement:
    """The agreement over pairs of annotations of the same texts."""
    several = [pair for pair in pairs if max(len(one.tasks) for one in pair) > 1]
    tasks = [labels for pair in pairs for labels in _token_labels(*pair, _task_labels, is_bio=False)]
    arguments = [labels for pair in pairs for labels in _token_labels(*pair, _argument_labels, is_bio=True)]
    common = [values for pair in pairs for values in _common_values(*pair)]
    implied = [(Counter(_implied(one)), Counter(_implied(other))) for one, other in pairs]
    return Agreement(
        instructions=len(pairs),
        scores=metrics.score([second for _, second in pairs], [first for first, _ in pairs]),
        task_kappa=kappa(tasks),
        argument_kappa=kappa(arguments),
        complex_flow=Proportion(sum(metrics.has_same_flow(*pair) for pair in several), len(several)),
        values=Proportion(sum(one == other for one, other in common), len(common)),
        implied=F1(
            sum((one & other).total() for one, other in implied),
            sum(other.total() for _, other in implied),
            sum(one.total() for one, _ in implied),
        ),
    )


def kappa(labels: Sequence[tuple[str, str]]) -> float | None:
    """Cohen's kappa of pairs of labels; None where chance alone agrees everywhere, or there are none."""
    if not labels:
        return None
    total = len(labels)
    observed = sum(one == other for one, other in labels) / total
    ours, theirs = Counter(one for one, _ in labels), Counter(other for _, other in labels)
    expected = sum(ours[label] * theirs[label] for label in sorted(ours)) / total**2
    return (observed - expected) / (1 - expected) if expected < 1 else None


def disagreements(pairs: Iterable[tuple[Example, Example]]) -> Iterator[Disagreement]:
    """The instructions whose annotations are not identical, with what is different."""
    for one, other in pairs:
        first, second = one.instruction, other.instruction
        found = {
            "tasks": list(_only(_spelt_tasks(first), _spelt_tasks(second))),
            "arguments": list(_only(_spelt_arguments(first), _spelt_arguments(second))),
            "flow": [] if metrics.has_same_flow(first, second) else list(_only([_spelt(first)], [_spelt(second)])),
            "values": [
                *(f"{a!r} / {b!r}" for a, b in _common_values(first, second) if a != b),
                *_only(_spelt_implied(first), _spelt_implied(second)),
            ],
        }
        kinds = tuple(kind for kind, differences in found.items() if differences)
        if kinds:
            yield Disagreement(one.id, kinds, first.text, tuple(line for kind in kinds for line in found[kind]))


def _task_labels(instruction: Instruction) -> Iterator[tuple[Span, str]]:
    return ((task.span, task.type) for task in instruction.tasks)


def _argument_labels(instruction: Instruction) -> Iterator[tuple[Span, str]]:
    return ((argument.span, argument.type) for _, argument in _arguments(instruction) if argument.span)


def _token_labels(first: Instruction, second: Instruction, spans: Marks, *, is_bio: bool) -> Iterator[tuple[str, str]]:
    """Both labels of every token; a token is cut where a mark of either annotation begins or ends inside it."""
    marked = [list(spans(first)), list(spans(second))]
    cuts = {edge for marks in marked for span, _ in marks for edge in (span.start, span.end)}
    for match in _TOKEN.finditer(first.text):
        edges = [match.start(), *sorted(cut for cut in cuts if match.start() < cut < match.end())]
        for start in edges:
            yield _label(start, marked[0], is_bio), _label(start, marked[1], is_bio)


def _label(position: int, marks: Sequence[tuple[Span, str]], is_bio: bool) -> str:
    for span, label in marks:
        if span.start <= position < span.end:
            return f"{'B' if position == span.start else 'I'}-{label}" if is_bio else label
    return OUTSIDE


def _arguments(instruction: Instruction) -> Iterator[tuple[Task, Argument]]:
    return ((task, argument) for task in instruction.tasks for argument in task.arguments)


def _common_values(first: Instruction, second: Instruction) -> Iterator[tuple[str, str]]:
    """The values, in lower case, of the arguments that both annotations have at the same words of the same task."""
    theirs = {(task.span, argument.type, argument.span): argument.value for task, argument in _arguments(second)}
    for task, argument in _arguments(first):
        value = theirs.get((task.span, argument.type, argument.span))
        if argument.span is not None and value is not None:
            yield _plain(argument.value), _plain(value)


def _implied(instruction: Instruction) -> Iterator[Hashable]:
    for task, argument in _arguments(instruction):
        if argument.span is None:
            yield task.span, argument.type, _plain(argument.value)


def _plain(value: str) -> str:
    return " ".join(value.lower().split())


def _spelt_tasks(instruction: Instruction) -> list[str]:
    return [f"{task.span.of(instruction.text)}:{task.type}" for task in instruction.tasks]


def _spelt_arguments(instruction: Instruction) -> list[str]:
    return [
        f"{task.span.of(instruction.text)}: {argument.type} [{argument.span.of(instruction.text)}]"
        for task, argument in _arguments(instruction)
        if argument.span
    ]


def _spelt_implied(instruction: Instruction) -> list[str]:
    return [
        f"{task.span.of(instruction.text)}: implied {argument.type} {_plain(argument.value)!r}"
        for task, argument in _arguments(instruction)
        if argument.span is None
    ]


def _spelt(instruction: Instruction) -> str:
    """The control flow on one line, with the verbs in place of numbers."""

    def words(numbers: Any) -> str:
        tasks = numbers if isinstance(numbers, list) else [numbers]
        return " = ".join(f"{number} {instruction.task(number).span.of(instruction.text)}" for number in tasks)

    def said(entries: list[Any]) -> str:
        return "[" + ", ".join(entry(one) for one in entries) + "]"

    def entry(one: Any) -> str:
        if isinstance(one, int):
            return words(one)
        if "same" in one:
            return f"same {words(one['same'])}"
        branches = [f"{side} {said(one[side])}" for side in ("then", "else") if side in one]
        return f"if {words(one['if'])}: {', '.join(branches)}"

    return said(instruction.flow.to_json())


def _only(first: Sequence[str], second: Sequence[str]) -> Iterator[str]:
    ours, theirs = Counter(first), Counter(second)
    yield from (f"first only:  {line}" for line in (ours - theirs).elements())
    yield from (f"second only: {line}" for line in (theirs - ours).elements())


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 4)


def _shown(value: float | None) -> str:
    return "no data" if value is None else f"{value:.3f}"
