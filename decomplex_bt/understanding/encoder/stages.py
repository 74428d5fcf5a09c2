"""Tasks and arguments read off the encoder; they take the places of `TaskModel` and `ArgumentModel` in the chain of
readings, and `flows` that of `FlowModel`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import product
from math import prod
from pathlib import Path

import numpy as np

from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.understanding.arguments import FoundArgument, FoundArguments
from decomplex_bt.understanding.confidence import CALIBRATION_FILE
from decomplex_bt.understanding.dependencies import FlowModel
from decomplex_bt.understanding.encoder.flows import (
    JUDGE_FILE,
    LABELS_FILE,
    NETWORK_FILE,
    EncoderFlows,
    FlowNetworkModel,
)
from decomplex_bt.understanding.encoder.heads import IMPOSSIBLE, Array, log_softmax
from decomplex_bt.understanding.encoder.labels import argument_labels, task_labels
from decomplex_bt.understanding.encoder.model import ENCODER_FILE, HEADS_FILE, PIECES_FILE, EncoderModel
from decomplex_bt.understanding.encoder.referents import SHARE_FILE, load_references
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.manifest import check_models
from decomplex_bt.understanding.readings import Stages
from decomplex_bt.understanding.tasks import MAX_ALTERNATIVES, MAX_UNCERTAIN_TOKENS, UNCERTAIN, FoundTask, FoundTasks

FOLDER_FILES = (
    ENCODER_FILE,
    HEADS_FILE,
    PIECES_FILE,
    NETWORK_FILE,
    JUDGE_FILE,
    LABELS_FILE,
    SHARE_FILE,
    "readings.json",
    CALIBRATION_FILE,
)
"""What a folder of a trained encoder holds."""


def load_encoder(folder: Path, flows: FlowModel, domain: Domain) -> Stages:
    """The stages from a folder of a trained encoder. Raises `DataFileError` and `EncoderMissingError`."""
    check_models(folder, domain, models=(), files=FOLDER_FILES)
    model = EncoderModel(folder)
    stages = encoder_stages(folder, model, flows, domain.ontology)
    return replace(stages, references=load_references(folder, model, domain.ontology))


def encoder_stages(folder: Path, model: EncoderModel, flows: FlowModel, ontology: Ontology) -> Stages:
    """As `load_encoder`, but for references."""
    network = FlowNetworkModel(folder, model.pieces, ontology)
    return Stages(EncoderTasks(model, ontology), EncoderArguments(model, ontology), EncoderFlows(flows, network))


class EncoderTasks:
    """Task sets from the network's label of each token; stands in for `TaskModel`."""

    def __init__(self, model: EncoderModel, ontology: Ontology) -> None:
        self._model = model
        self._labels = task_labels(tuple(ontology.task_types))

    def alternatives(self, observed: Observed) -> tuple[FoundTasks, ...]:
        """The likeliest task sets, best first: all ways to label the least certain tokens."""
        chances = np.exp(log_softmax(self._model.heads.tasks(self._model.vectors(observed.document))))
        best = chances.argmax(axis=1)
        order = sorted(range(len(best)), key=lambda i: (chances[i, best[i]], i))
        places = [i for i in order if (chances[i] > UNCERTAIN).sum() > 1][:MAX_UNCERTAIN_TOKENS]
        certain = prod(float(chances[i, best[i]]) for i in range(len(best)) if i not in places)
        found = []
        for chosen in product(*(np.flatnonzero(chances[i] > UNCERTAIN) for i in places)):
            labels = best.copy()
            labels[places] = chosen
            probability = certain * prod(float(chances[i, k]) for i, k in zip(places, chosen, strict=True))
            tasks = tuple(FoundTask(i, self._labels[k], float(chances[i, k])) for i, k in enumerate(labels) if k)
            found.append(FoundTasks(tasks, probability))
        found.sort(key=lambda alternative: -alternative.probability)
        return tuple(found[:MAX_ALTERNATIVES])


class EncoderArguments:
    """Arguments from the network's BIO labels, each with its likeliest owner; stands in for `ArgumentModel`."""

    def __init__(self, model: EncoderModel, ontology: Ontology) -> None:
        self._model = model
        self._types = task_labels(tuple(ontology.task_types))
        self._labels = argument_labels(tuple(ontology.argument_types))
        self._allowed = steps(self._labels)

    def find_all(self, observed: Observed, tasks: Mapping[int, str]) -> FoundArguments:
        """The arguments of a document, in text order, with the joint probability of all labels and owners."""
        if not tasks:
            return FoundArguments((), 1.0)
        heads = self._model.heads
        places = sorted(tasks)
        types = [self._types.index(tasks.get(i, "O")) for i in range(len(observed.document))]
        typed = heads.typed(self._model.vectors(observed.document), types)
        scores = log_softmax(heads.arguments(typed))
        labels = best_path(scores, self._allowed)
        chances = np.exp(scores[np.arange(len(labels)), labels])
        starts = [i for i, k in enumerate(labels) if self._labels[k][0] == "B"]
        owners = np.exp(log_softmax(heads.owners(typed, starts, places))) if starts else np.zeros((0, 1))
        found = []
        for start, owner in zip(starts, owners, strict=True):
            name, stop = self._labels[labels[start]][2:], start + 1
            while stop < len(labels) and self._labels[labels[stop]] == f"I-{name}":
                stop += 1
            confidence = float(chances[start:stop].mean() * owner.max())
            found.append(FoundArgument(name, places[int(owner.argmax())], range(start, stop), confidence))
        return FoundArguments(tuple(found), float(chances.prod() * owners.max(axis=1).prod()))


def steps(labels: Sequence[str]) -> Array:
    """The score of each label (columns) behind each other (rows): 0, or `IMPOSSIBLE` for an I without its B or I before
    it, and for a B right behind its own type: no two arguments of a type stand side by side."""
    return np.array([[_step(before, label) for label in labels] for before in labels])


def _step(before: str, label: str) -> float:
    is_same = label[2:] == before[2:]
    return 0.0 if label == "O" or is_same == (label[0] == "I") else IMPOSSIBLE


def best_path(scores: Array, allowed: Array) -> list[int]:
    """The likeliest labels for scores (tokens, labels), the first of which is "O", by allowed `steps` (Viterbi)."""
    best = scores[0] + allowed[0]
    back = []
    for row in scores[1:]:
        steps = best[:, None] + allowed
        back.append(steps.argmax(axis=0))
        best = steps.max(axis=0) + row
    path = [int(best.argmax())]
    for pointers in reversed(back):
        path.append(int(pointers[path[-1]]))
    return path[::-1]
