"""Task identification: a CRF that gives every token a task type or O (DeComplex, section III-A)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.crf import Crf, CrfParameters, train_crf
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed, task_features

OUTSIDE = "O"
PARAMETERS = CrfParameters(c1=0.2, c2=0.05, max_iterations=150)

UNCERTAIN = 0.06
"""A label below this marginal probability is no alternative."""
MAX_UNCERTAIN_TOKENS = 4
MAX_ALTERNATIVES = 8


@dataclass(frozen=True, slots=True)
class FoundTask:
    """A token that carries a task; `confidence` is the marginal probability of its type."""

    token: int
    type: str
    confidence: float


@dataclass(frozen=True, slots=True)
class FoundTasks:
    """A set of tasks in text order with the joint probability of all labels."""

    tasks: tuple[FoundTask, ...]
    probability: float


class TaskModel:
    """The trained task CRF."""

    def __init__(self, path: Path) -> None:
        self._crf = Crf(path)

    def alternatives(self, observed: Observed) -> tuple[FoundTasks, ...]:
        """The likeliest task sets, best first, at most `MAX_ALTERNATIVES`: all ways to label the least certain
        tokens."""
        labelling = self._crf.label(task_features(observed))
        uncertain = self._crf.uncertain(labelling, UNCERTAIN)
        places = sorted(uncertain, key=lambda i: (labelling.marginals[i], i))[:MAX_UNCERTAIN_TOKENS]
        found: list[FoundTasks] = []
        for chosen in product(*(uncertain[i] for i in places)):
            labels, marginals = list(labelling.labels), list(labelling.marginals)
            for i, (label, marginal) in zip(places, chosen, strict=True):
                labels[i], marginals[i] = label, marginal
            found.append(FoundTasks(_tasks(labels, marginals), self._crf.probability(labels)))
        found.sort(key=lambda alternative: -alternative.probability)
        return tuple(found[:MAX_ALTERNATIVES])

    def find(self, observed: Observed) -> tuple[FoundTask, ...]:
        """The tasks of a document in text order."""
        labelling = self._crf.label(task_features(observed))
        return _tasks(labelling.labels, labelling.marginals)


def _tasks(labels: Sequence[str], marginals: Sequence[float]) -> tuple[FoundTask, ...]:
    return tuple(
        FoundTask(i, label, confidence)
        for i, (label, confidence) in enumerate(zip(labels, marginals, strict=True))
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
