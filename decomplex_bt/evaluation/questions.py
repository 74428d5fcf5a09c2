"""What questions pay: a user who knows what was meant answers them, and the flow is compared before and after."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.evaluation.metrics import has_same_flow
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.instruction import Doubt, Instruction
from decomplex_bt.understanding.doubt import doubt_of, resolved, said_when

THRESHOLDS = (0.0, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)


@dataclass(frozen=True, slots=True)
class AskingRow:
    """What comes of asking below a threshold: of how many instructions, how many answers helped to a choice, and how
    many flows are exactly right then."""

    threshold: float
    asked: Proportion
    answered: Proportion
    flow: Proportion

    def to_json(self) -> dict[str, Any]:
        return {
            "threshold": self.threshold,
            "asked": self.asked.to_json(),
            "answered": self.answered.to_json(),
            "flow_exact": self.flow.to_json(),
        }


def score_asking(
    predicted: Sequence[Instruction],
    gold: Sequence[Instruction],
    ontology: Ontology,
    *,
    thresholds: Sequence[float] = THRESHOLDS,
) -> tuple[AskingRow, ...]:
    """A row for each threshold, over readings of the same texts as the gold ones, in the same order."""
    pairs = list(zip(predicted, gold, strict=True))
    return tuple(_row(threshold, pairs, ontology) for threshold in thresholds)


def answer_by_gold(doubt: Doubt, reading: Instruction, gold: Instruction, ontology: Ontology) -> str | None:
    """The number of the choice under which the task stands as it does in the gold flow; None where none fits, or where
    the reading's tasks are not the right ones."""
    if [(t.span, t.type) for t in reading.tasks] != [(t.span, t.type) for t in gold.tasks]:
        return None
    meant = said_when(gold.flow, doubt.task, reading, ontology)
    return next((str(n) for n, choice in enumerate(doubt.choices, start=1) if choice.text == meant), None)


def _row(threshold: float, pairs: Sequence[tuple[Instruction, Instruction]], ontology: Ontology) -> AskingRow:
    asked = answered = right = 0
    for reading, gold in pairs:
        doubt = doubt_of(reading, ontology, threshold=threshold)
        after = reading
        if doubt is not None:
            answer = answer_by_gold(doubt, reading, gold, ontology)
            asked += 1
            answered += answer is not None
            after = reading if answer is None else resolved(reading, doubt, answer) or reading
        right += has_same_flow(after, gold)
    n = len(pairs)
    return AskingRow(threshold, Proportion(asked, n), Proportion(answered, asked), Proportion(right, n))
