"""The control flow read by a network beside the CRFs: what either finds likely is judged by both; stands in for
`FlowModel` in the chain of readings."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import exp, prod
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.understanding.control_flow.arcs import Arc
from decomplex_bt.understanding.control_flow.clause import MarkedTask
from decomplex_bt.understanding.control_flow.clauses import clauses_of
from decomplex_bt.understanding.control_flow.construction import flow_of
from decomplex_bt.understanding.control_flow.orders import stated_orders
from decomplex_bt.understanding.control_flow.roles import stated_roles
from decomplex_bt.understanding.control_flow.sides import stated_sides
from decomplex_bt.understanding.control_flow.structure import Chain, attachment_features, order_features, role_features
from decomplex_bt.understanding.crf import Crf, Features
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.dependencies import (
    FlowModel,
    FoundFlow,
    Varied,
    likeliest,
    varied,
)
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.encoder.heads import Array, log_softmax
from decomplex_bt.understanding.encoder.model import open_session, partial_run
from decomplex_bt.understanding.encoder.pieces import MAX_PIECES, Pieced, Pieces
from decomplex_bt.understanding.features import Observed

NETWORK_FILE, JUDGE_FILE, LABELS_FILE = "flow.onnx", "flow_judge.onnx", "flow_labels.json"
UNCERTAIN = 0.05
"""A label that the network finds less likely gives no other flow."""
MAX_VARIED_PLACES = 3
MAX_ROLES, MAX_ATTACHMENTS = 4, 6
"""How many ways to tell the roles are read on, and of all ways to attach the tasks then."""
LEAST = 1e-12
CRF_SHARE = 0.25
"""How much the CRFs count beside the network, which has learnt more: the weight of their logarithms in the mean."""

Label = Literal["role", "attachment", "order"]


def pieces_of(document: Document, tasks: Sequence[MarkedTask], pieces: Pieces, types: Sequence[str]) -> Pieced | None:
    """The pieces of a document with a mark of its type before each task; None where they are too many to be read."""
    marks = {task.token: pieces.mark(types.index(task.type)) for task in tasks}
    pieced = pieces.of([token.text for token in document.tokens], marks)
    return pieced if len(pieced.ids) < MAX_PIECES else None


class Labels(NamedTuple):
    """The labels that a flow network tells, in the order of its outputs."""

    roles: tuple[str, ...]
    attachments: tuple[str, ...]
    orders: tuple[str, ...]


def read_labels(folder: Path) -> Labels:
    """Those of the network in a folder. Raises `DataFileError`."""
    path = folder / LABELS_FILE
    try:
        stored = json.loads(path.read_text(encoding="utf-8"))
        return Labels(*(tuple(map(str, stored[name])) for name in Labels._fields))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ModelError(path, f"no labels of flows ({type(error).__name__})") from None


class FlowNetworkModel:
    """A trained flow network, from a folder. Raises `EncoderMissingError` and `DataFileError`."""

    def __init__(self, folder: Path, pieces: Pieces, ontology: Ontology) -> None:
        self._reader, self._judge = open_session(folder / NETWORK_FILE), open_session(folder / JUDGE_FILE)
        self._partly = partial_run()
        self._pieces, self._types = pieces, sorted(ontology.task_types)
        self.roles, self.attachments, self.orders = read_labels(folder)

    def read(self, document: Document, tasks: Sequence[MarkedTask]) -> Array | None:
        """The vectors of tasks, (1, tasks, size); None where the text is too long."""
        pieced = pieces_of(document, tasks, self._pieces, self._types)
        if pieced is None:
            return None
        ids = np.array([pieced.ids], np.int64)
        places = np.array([[pieced.firsts[task.token] for task in tasks]], np.int64)
        settled: Array = self._reader.run(None, {"ids": ids, "mask": np.ones_like(ids), "places": places})[0]
        return settled

    def judge(
        self, label: Label, settled: Array, roles: Sequence[Sequence[str]], attachments: Sequence[Sequence[str]]
    ) -> Array:
        """Of several ways to label the tasks, the log probabilities (ways, tasks, labels) of roles, of attachments
        given the roles, or of orders given both; what is not given to a label does not matter to it."""
        given = {
            "settled": np.repeat(settled, len(roles), axis=0),
            "roles": np.array([[_index(self.roles, name) for name in way] for way in roles], np.int64),
            "attachments": np.array(
                [[_index(self.attachments, name) for name in way] for way in attachments], np.int64
            ),
        }
        return log_softmax(self._judge.run([f"{label}_scores"], given, self._partly)[0])


class EncoderFlows:
    """Control flows by the CRFs and the network: their probabilities are the weighted geometric means of both."""

    def __init__(self, crfs: FlowModel, network: FlowNetworkModel) -> None:
        self._crfs, self._network = crfs, network

    def alternatives(self, observed: Observed, tasks: Sequence[MarkedTask]) -> tuple[FoundFlow, ...]:
        """Different control flows of tasks in text order, likeliest first, at most `dependencies.MAX_FLOWS`."""
        settled = self._network.read(observed.document, tasks) if len(tasks) > 1 else None
        if settled is None:
            return self._crfs.alternatives(observed, tasks)
        network, crfs = self._network, self._crfs
        clauses = clauses_of(observed, tasks)
        chain = Chain(observed, clauses)
        no_roles, no_places = [[network.roles[0]] * len(tasks)], [[network.attachments[0]] * len(tasks)]
        (table,) = network.judge("role", settled, no_roles, no_places)
        ways = _ways(crfs.roles, role_features(chain), table, network.roles)[:MAX_ROLES]
        roles = [stated_roles(clauses, way.labels) for way in ways]
        tables = network.judge("attachment", settled, roles, no_places * len(roles))
        attached = [
            (way, told, attachment)
            for way, told, table in zip(ways, roles, tables, strict=True)
            for attachment in _ways(crfs.attachments, attachment_features(chain, told), table, network.attachments)
        ]
        attached.sort(key=lambda chosen: -chosen[0].probability * chosen[2].probability)
        del attached[MAX_ATTACHMENTS:]
        places = [stated_sides(clauses, told, attachment.labels) for _, told, attachment in attached]
        tables = network.judge("order", settled, [told for _, told, _ in attached], places)
        found = []
        for (way, told, attachment), place, table in zip(attached, places, tables, strict=True):
            items = order_features(chain, told, place)
            for order in _ways(crfs.orders, items, table, network.orders):
                labels = zip(told, place, stated_orders(clauses, told, place, order.labels), strict=True)
                arcs = tuple(Arc(*each) for each in labels)
                chances = (way.probability, attachment.probability, order.probability)
                found.append(FoundFlow(flow_of(arcs, chain.wordings), arcs, clauses, chances))
        return likeliest(found)


def _ways(crf: Crf, items: Sequence[Features], table: Array, names: Sequence[str]) -> list[Varied]:
    """The labels of a sequence that the CRF or the network finds likely, by their weighted geometric mean, best first.

    `table`: the network's log probabilities (tasks, labels).
    """
    found = {way.labels: way.probability for way in varied(crf, items)}
    for labels in _variants(table, names):
        if labels not in found and set(labels) <= set(crf.labels):
            found[labels] = crf.probability(labels)
    ways = [
        Varied(labels, max(LEAST, chance) ** CRF_SHARE * _chance(table, names, labels) ** (1 - CRF_SHARE))
        for labels, chance in found.items()
    ]
    return sorted(ways, key=lambda way: (-way.probability, way.labels))


def _variants(table: Array, names: Sequence[str]) -> list[tuple[str, ...]]:
    """The network's likeliest labels, then those that differ from them in one uncertain place."""
    best = table.argmax(axis=1)
    found = [tuple(names[k] for k in best)]
    for place in np.argsort(table.max(axis=1), kind="stable")[:MAX_VARIED_PLACES]:
        second = int(np.argsort(-table[place], kind="stable")[1])
        if exp(table[place, second]) > UNCERTAIN:
            found.append((*found[0][:place], names[second], *found[0][place + 1 :]))
    return found


def _chance(table: Array, names: Sequence[str], labels: Sequence[str]) -> float:
    """The network's probability of labels; the least one for those it does not know."""
    known = [
        exp(row[names.index(label)]) if label in names else LEAST for row, label in zip(table, labels, strict=True)
    ]
    return max(LEAST, prod(known))


def _index(names: Sequence[str], name: str) -> int:
    """Of a label the CRFs alone know, the first one's: `_chance` makes such labels unlikely anyway."""
    return names.index(name) if name in names else 0
