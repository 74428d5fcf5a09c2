"""How much understanding suffers from noise: the same instructions as they are and disturbed, side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np

from decomplex_bt.evaluation import metrics
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.instruction import Instruction, Span
from decomplex_bt.understanding.disturbances import DISTURBANCES

AS_THEY_ARE = "as they are"
RESAMPLES = 1000
"""How often the instructions are drawn anew for the interval of an F1."""
Track = Callable[[Iterable[Instruction], str], Iterable[Instruction]]


class Reader(Protocol):
    """What is measured; an `Interpreter` is one."""

    def interpret_batch(self, texts: Iterable[str], *, jobs: int = 1) -> Iterator[Instruction]:
        """The understood instructions, in order, read in so many processes."""

    def tokens(self, text: str) -> tuple[Span, ...]:
        """Where the tokens of a text stand."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """A figure with its 95 % interval."""

    value: float
    low: float
    high: float

    def to_json(self) -> dict[str, Any]:
        return {"value": round(self.value, 4), "interval": [round(self.low, 4), round(self.high, 4)]}


@dataclass(frozen=True, slots=True)
class NoiseRow:
    """The scores under one disturbance. `difference`: of flow exact match to the text as it is, over pairs."""

    name: str
    instructions: int
    tasks: Estimate
    arguments: Estimate
    dependencies: Estimate
    flow: Proportion
    strict: Proportion
    difference: Estimate

    def to_json(self) -> dict[str, Any]:
        return {
            "noise": self.name,
            "instructions": self.instructions,
            "tasks_f1": self.tasks.to_json(),
            "arguments_f1": self.arguments.to_json(),
            "dependencies_f1": self.dependencies.to_json(),
            "flow_exact": self.flow.to_json(),
            "strict": self.strict.to_json(),
            "flow_difference": self.difference.to_json(),
        }


def score_noise(
    reader: Reader,
    gold: Sequence[Instruction],
    *,
    seed: int = 0,
    jobs: int = 1,
    track: Track = lambda read, name: read,
) -> tuple[NoiseRow, ...]:
    """The scores of the instructions as they are, then under each of `DISTURBANCES`.

    Each disturbance draws from a stream of its own, so the rows do not depend on one another. A gold span that a
    disturbance left in the middle of a token is widened to the token: no reader could mark less. Raises `ValueError`
    for no instructions.
    """
    if not gold:
        raise ValueError("expected at least one instruction")
    rows: list[NoiseRow] = []
    plain: list[bool] = []
    streams = np.random.SeedSequence(seed).spawn(2 * len(DISTURBANCES) + 1)
    copies = {AS_THEY_ARE: list(gold)}
    for (name, disturb), stream in zip(DISTURBANCES.items(), streams, strict=False):
        rng = np.random.default_rng(stream)
        copies[name] = [on_tokens(disturb(instruction, rng), reader) for instruction in gold]
    for (name, wanted), stream in zip(copies.items(), reversed(streams), strict=False):
        texts = [instruction.text for instruction in wanted]
        found = list(track(reader.interpret_batch(texts, jobs=jobs), name))
        right = [metrics.has_same_flow(*pair) for pair in zip(found, wanted, strict=True)]
        plain = plain or right
        rows.append(_row(name, found, wanted, _difference(right, plain), np.random.default_rng(stream)))
    return tuple(rows)


def on_tokens(instruction: Instruction, reader: Reader) -> Instruction:
    """The instruction with every span widened to whole tokens of the reader."""
    tokens = reader.tokens(instruction.text)

    def widened(span: Span) -> Span:
        touched = [token for token in tokens if token.start < span.end and token.end > span.start]
        return Span(touched[0].start, touched[-1].end) if touched else span

    return replace(
        instruction,
        tasks=tuple(
            replace(
                task,
                span=widened(task.span),
                arguments=tuple(replace(a, span=widened(a.span) if a.span else None) for a in task.arguments),
            )
            for task in instruction.tasks
        ),
    )


def _row(
    name: str,
    found: Sequence[Instruction],
    wanted: Sequence[Instruction],
    difference: Estimate,
    rng: np.random.Generator,
) -> NoiseRow:
    each = [metrics.score([one], [other]) for one, other in zip(found, wanted, strict=True)]
    return NoiseRow(
        name,
        len(each),
        _f1([scores.tasks for scores in each], rng),
        _f1([scores.arguments for scores in each], rng),
        _f1([scores.dependencies for scores in each], rng),
        Proportion(sum(scores.flow.count for scores in each), len(each)),
        Proportion(sum(scores.strict.count for scores in each), len(each)),
        difference,
    )


def _f1(each: Sequence[metrics.LabelScores], rng: np.random.Generator) -> Estimate:
    """F1 over all instructions; the interval from instructions drawn anew, with replacement."""
    overall = [scores.overall for scores in each]
    counts = np.array([(2 * f1.right, f1.found + f1.wanted) for f1 in overall])
    drawn = counts[rng.integers(len(counts), size=(RESAMPLES, len(counts)))].sum(axis=1)
    values = np.where(drawn[:, 1] > 0, drawn[:, 0] / np.maximum(drawn[:, 1], 1), 1.0)
    low, high = np.percentile(values, (2.5, 97.5))
    right, both = counts.sum(axis=0)
    return Estimate(float(right / both) if both else 1.0, float(low), float(high))


def _difference(right: Sequence[bool], plain: Sequence[bool]) -> Estimate:
    """The mean of the paired differences, with the normal approximation of its interval."""
    differences = np.subtract(right, plain, dtype=float)
    mean, margin = float(differences.mean()), 1.96 * float(differences.std()) / math.sqrt(len(differences))
    return Estimate(mean, mean - margin, mean + margin)
