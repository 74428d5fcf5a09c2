"""Linear-chain CRFs: trained through sklearn-crfsuite, read at run time by pycrfsuite alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pycrfsuite

Features = dict[str, Any]
"""Of one item: feature name to a string, a truth value or a number (crfsuite's own dictionary form)."""


@dataclass(frozen=True, slots=True)
class Labelling:
    """A label sequence with the probability of each label at its place and of the whole sequence."""

    labels: tuple[str, ...]
    marginals: tuple[float, ...]
    probability: float


class Crf:
    """A trained model, read from a file of crfsuite's own format (no pickle)."""

    def __init__(self, path: Path) -> None:
        self._tagger = pycrfsuite.Tagger()
        self._tagger.open(str(path))
        self.labels: tuple[str, ...] = tuple(sorted(self._tagger.labels()))

    def label(self, items: Sequence[Features]) -> Labelling:
        """The likeliest label sequence for a sequence of items (empty for none)."""
        if not items:
            return Labelling((), (), 1.0)
        labels = self._tagger.tag(pycrfsuite.ItemSequence(items))
        marginals = tuple(map(self._tagger.marginal, labels, range(len(labels))))
        return Labelling(tuple(labels), marginals, self._tagger.probability(labels))

    def uncertain(self, labelling: Labelling, threshold: float) -> dict[int, tuple[tuple[str, float], ...]]:
        """Of the sequence labelled last: position to all labels above `threshold`, where more than one is."""
        found: dict[int, tuple[tuple[str, float], ...]] = {}
        for i, best in enumerate(labelling.marginals):
            if best >= 1 - threshold:
                continue
            marginals = [(label, self._tagger.marginal(label, i)) for label in self.labels]
            likely = tuple((label, marginal) for label, marginal in marginals if marginal > threshold)
            if len(likely) > 1:
                found[i] = likely
        return found

    def probability(self, labels: Sequence[str]) -> float:
        """The joint probability of labels for the sequence labelled last."""
        return float(self._tagger.probability(list(labels)))

    def marginal(self, label: str, position: int) -> float:
        """The probability of a label at a position of the sequence labelled last; 0 for a label never seen in
        training."""
        return float(self._tagger.marginal(label, position)) if label in self.labels else 0.0


@dataclass(frozen=True, slots=True)
class CrfParameters:
    """Training parameters of a CRF: L1 and L2 regularisation and the most iterations of L-BFGS."""

    c1: float = 0.05
    c2: float = 0.1
    max_iterations: int = 150
    all_transitions: bool = True


def train_crf(
    path: Path,
    sequences: Sequence[Sequence[Features]],
    labels: Sequence[Sequence[str]],
    parameters: CrfParameters = CrfParameters(),
) -> None:
    """Trains a CRF by L-BFGS and writes it to `path`; the same data gives the same file."""
    import sklearn_crfsuite

    model = sklearn_crfsuite.CRF(
        algorithm="lbfgs",
        c1=parameters.c1,
        c2=parameters.c2,
        max_iterations=parameters.max_iterations,
        all_possible_transitions=parameters.all_transitions,
        model_filename=str(path),
    )
    model.fit(sequences, labels)


def transition_weights(path: Path) -> dict[tuple[str, str], float]:
    """The learnt weight of every transition (from, to) of a model file (DeComplex, Table V)."""
    tagger = pycrfsuite.Tagger()
    tagger.open(str(path))
    return dict(tagger.info().transitions)
