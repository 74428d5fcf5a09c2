"""Tasks, arguments and control flow read off the encoder, each with what the CRF of that stage says weighed in.

They take the places of `TaskModel`, `ArgumentModel` and `FlowModel` in the chain of readings.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import product
from math import exp, log, prod
from pathlib import Path

import numpy as np

from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.flow import Flow
from decomplex_bt.understanding.arcs import CONDITION_ROLES, TOP, Arc, flow_of, pointer_to
from decomplex_bt.understanding.arguments import FoundArgument, FoundArguments
from decomplex_bt.understanding.clauses import Clause, MarkedTask, clauses_of, wordings_of
from decomplex_bt.understanding.dependencies import (
    MAX_VARIED_PLACES,
    MODELS,
    FlowModel,
    FoundFlow,
    Varied,
    chained_roles,
    likeliest,
)
from decomplex_bt.understanding.dependencies import UNCERTAIN as UNCERTAIN_LABEL
from decomplex_bt.understanding.encoder.heads import IMPOSSIBLE, Array, FlowScores, log_softmax
from decomplex_bt.understanding.encoder.labels import (
    ORDER_LABELS,
    ROLES,
    SIDES,
    argument_labels,
    pair_names,
    task_labels,
    task_names,
)
from decomplex_bt.understanding.encoder.model import ENCODER_FILE, HEADS_FILE, PIECES_FILE, EncoderModel
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.manifest import FILES, check_models
from decomplex_bt.understanding.readings import Stages
from decomplex_bt.understanding.structure import attachment_features, order_features, role_features
from decomplex_bt.understanding.tasks import MAX_ALTERNATIVES, MAX_UNCERTAIN_TOKENS, UNCERTAIN, FoundTask, FoundTasks

CRF_ROLES, CRF_ATTACHMENTS, CRF_ORDERS = 0.5, 0.5, 0.5
"""How much the log probabilities of the CRFs count beside those of the network; chosen on the development voices."""


def load_encoder(folder: Path, domain: Domain, language_model: str) -> Stages:
    """The stages from a folder of a trained encoder. Raises `DataFileError` and `EncoderMissingError`."""
    check_models(folder, domain, language_model, models=MODELS, files=(*FILES, ENCODER_FILE, HEADS_FILE, PIECES_FILE))
    return encoder_stages(folder, domain.ontology)


def encoder_stages(folder: Path, ontology: Ontology) -> Stages:
    """As `load_encoder`, for a folder that has no manifest yet."""
    model = EncoderModel(folder)
    flows = EncoderFlow(model, FlowModel(folder), ontology)
    return Stages(EncoderTasks(model, ontology), EncoderArguments(model, ontology), flows)


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
            tasks = tuple(
                FoundTask(i, self._labels[k], float(chances[i, k])) for i, k in enumerate(labels) if k
            )
            found.append(FoundTasks(tasks, probability))
        found.sort(key=lambda alternative: -alternative.probability)
        return tuple(found[:MAX_ALTERNATIVES])


class EncoderArguments:
    """Arguments from the network's BIO labels, each with its likeliest owner; stands in for `ArgumentModel`."""

    def __init__(self, model: EncoderModel, ontology: Ontology) -> None:
        self._model = model
        self._types = task_labels(tuple(ontology.task_types))
        self._labels = argument_labels(tuple(ontology.argument_types))
        self._allowed = np.array([[_following(before, label) for label in self._labels] for before in self._labels])

    def find_all(self, observed: Observed, tasks: Mapping[int, str]) -> FoundArguments:
        """The arguments of a document, in text order, with the joint probability of all labels and owners."""
        if not tasks:
            return FoundArguments((), 1.0)
        heads = self._model.heads
        places = sorted(tasks)
        types = [self._types.index(tasks.get(i, "O")) for i in range(len(observed.document))]
        typed = heads.typed(self._model.vectors(observed.document), types)
        scores = log_softmax(heads.arguments(typed))
        labels = _best_path(scores, self._allowed)
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


def _following(before: str, label: str) -> float:
    """The score of a label behind another: an I needs its B or I."""
    return 0.0 if label[0] != "I" or label[2:] == before[2:] else IMPOSSIBLE


def _best_path(scores: Array, allowed: Array) -> list[int]:
    """The likeliest sequence of labels in which no I stands without its B (Viterbi)."""
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


class EncoderFlow:
    """The control flow from the network's roles, pointers and orders, and the CRFs'; stands in for `FlowModel`."""

    def __init__(self, model: EncoderModel, crfs: FlowModel, ontology: Ontology) -> None:
        self._model = model
        self._crfs = crfs
        self._types = task_labels(tuple(ontology.task_types))

    def alternatives(self, observed: Observed, tasks: Sequence[MarkedTask]) -> tuple[FoundFlow, ...]:
        """Different control flows of tasks in text order, likeliest first, at most `MAX_FLOWS`."""
        if not tasks:
            return (FoundFlow(Flow()),)
        heads = self._model.heads
        clauses = clauses_of(observed, tasks)
        vectors = self._model.vectors(observed.document)[[task.token for task in tasks]]
        typed = heads.typed(vectors, [self._types.index(task.type) for task in tasks])
        context, features = heads.context(typed, task_names(observed, clauses))
        pairs = pair_names(clauses)
        wordings = wordings_of(clauses)
        found = []
        for roles in _varied(self._roles(observed, clauses, heads.roles(context, features))):
            chained = chained_roles(clauses, roles.labels)
            scores = heads.flow(context, features, chained, pairs)
            for attachments in _varied(self._attachments(observed, clauses, chained, scores)):
                orders = self._orders(observed, clauses, chained, attachments.labels, scores)
                arcs = tuple(Arc(*labels) for labels in zip(chained, attachments.labels, orders.labels, strict=True))
                chances = (roles.probability, attachments.probability, orders.probability)
                found.append(FoundFlow(flow_of(arcs, wordings), arcs, clauses, chances))
        return likeliest(found)

    def _roles(self, observed: Observed, clauses: Sequence[Clause], scores: Array) -> list[Scores]:
        self._crfs.roles.label(role_features(observed, clauses))
        found: list[Scores] = []
        for row, chances in zip(log_softmax(scores), self._crfs.roles.marginals(len(clauses)), strict=True):
            weighed = _weighed(dict(zip(ROLES, row, strict=True)), chances, CRF_ROLES)
            if not any(_best(before) in CONDITION_ROLES for before in found):
                del weighed["mention"]  # nothing to mention yet
            found.append(weighed)
        return found

    def _attachments(
        self, observed: Observed, clauses: Sequence[Clause], roles: Sequence[str], scores: FlowScores
    ) -> list[Scores]:
        n = len(roles)
        self._crfs.attachments.label(attachment_features(observed, clauses, roles))
        chances = self._crfs.attachments.marginals(n)
        mentions, targets = log_softmax(scores.mentions), log_softmax(scores.attachments)
        found: list[Scores] = [{TOP: 0.0}] * n
        group_of = {k: k for k in range(n) if roles[k] in CONDITION_ROLES}
        for k in range(n):
            conditions = [j for j in group_of if j < k]
            if roles[k] == "mention" and conditions:
                options = _summed((pointer_to(k, j, group_of), float(mentions[k, j])) for j in conditions)
                found[k] = _weighed(options, chances[k], CRF_ATTACHMENTS)
                best = _best(found[k])
                group_of[k] = group_of[next(j for j in conditions[::-1] if pointer_to(k, j, group_of) == best)]
        for k in range(n):
            if roles[k] == "again":
                found[k] = {name: log(chance + FLOOR) for name, chance in chances[k].items() if name[0] == "<"}
            elif roles[k] != "mention":
                pointed = [
                    (pointer_to(k, j, group_of) + sign, float(targets[k, 2 * j + s]))
                    for j in group_of
                    if j != k and group_of[j] != k
                    for s, sign in enumerate(SIDES)
                ]
                options = _summed([(TOP, float(targets[k, -1])), *pointed])
                found[k] = _weighed(options, chances[k], CRF_ATTACHMENTS)
        return found

    def _orders(
        self,
        observed: Observed,
        clauses: Sequence[Clause],
        roles: Sequence[str],
        attachments: Sequence[str],
        scores: FlowScores,
    ) -> Varied:
        self._crfs.orders.label(order_features(observed, clauses, roles, attachments))
        said = self._crfs.orders.marginals(len(clauses))
        rows = [
            _weighed(dict(zip(ORDER_LABELS, row, strict=True)), chances, CRF_ORDERS)
            for row, chances in zip(log_softmax(scores.orders), said, strict=True)
        ]
        return _varied(rows)[0]


Scores = dict[str, float]
"""Of one task each possible label's score, a log probability up to a constant."""


def _varied(rows: Sequence[Scores]) -> list[Varied]:
    """The best label of every row, then those that differ from them in one uncertain place."""
    labels = tuple(map(_best, rows))
    chances = [_chance(row, label) for row, label in zip(rows, labels, strict=True)]
    whole = prod(chances)
    ways = [Varied(labels, whole)]
    for place in sorted(range(len(rows)), key=lambda i: (chances[i], i))[:MAX_VARIED_PLACES]:
        others = {label: score for label, score in rows[place].items() if label != labels[place]}
        if others and _chance(rows[place], _best(others)) > UNCERTAIN_LABEL:
            other = _best(others)
            chance = whole / chances[place] * _chance(rows[place], other)
            ways.append(Varied((*labels[:place], other, *labels[place + 1 :]), chance))
    return ways


def _summed(options: Iterable[tuple[str, float]]) -> dict[str, float]:
    """The log probability of each label, over all the ways to it."""
    total: dict[str, float] = {}
    for label, score in options:
        total[label] = float(np.logaddexp(total[label], score)) if label in total else score
    return total


def _weighed(scores: Mapping[str, float], chances: Mapping[str, float], weight: float) -> dict[str, float]:
    return {label: score + weight * log(chances.get(label, 0.0) + FLOOR) for label, score in scores.items()}


def _best(scores: Mapping[str, float]) -> str:
    return max(scores, key=lambda name: scores[name])


def _chance(scores: Mapping[str, float], label: str) -> float:
    """The probability of a label among all."""
    return 1.0 / sum(exp(min(50.0, score - scores[label])) for score in scores.values())


FLOOR = 1e-4
"""A label that a CRF has never seen is unlikely, not impossible."""
