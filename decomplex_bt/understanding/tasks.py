"""Task identification: a CRF that gives every token a task type or O (DeComplex, section III-A)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.crf import Crf, CrfParameters, train_crf
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed, task_features

OUTSIDE = "O"
PARAMETERS = CrfParameters(c1=0.02, c2=0.05, max_iterations=120)


@dataclass(frozen=True, slots=True)
class FoundTask:
    """A token that carries a task; `confidence` is the marginal probability of its type."""

    token: int
    type: str
    confidence: float


class TaskModel:
    """The trained task CRF."""

    def __init__(self, path: Path) -> None:
        self._crf = Crf(path)

    def find(self, observed: Observed) -> tuple[FoundTask, ...]:
        """The tasks of a document in text order."""
        labelling = self._crf.label(task_features(observed))
        return tuple(
            FoundTask(i, label, confidence)
            for i, (label, confidence) in enumerate(zip(labelling.labels, labelling.marginals, strict=True))
            if label != OUTSIDE
        )


def gold_labels(document: Document, instruction: Instruction) -> list[str]:
    """The label of every token, from an annotation."""
    labels = [OUTSIDE] * len(document)
    for task in instruction.tasks:
        for i in document.indices(task.span):
            labels[i] = task.type
            break
    return labels


def train_tasks(path: Path, data: Sequence[tuple[Observed, Instruction]]) -> None:
    """Trains the task CRF on annotated documents and writes it to `path`."""
    train_crf(
        path,
        [task_features(observed) for observed, _ in data],
        [gold_labels(observed.document, instruction) for observed, instruction in data],
        PARAMETERS,
    )
