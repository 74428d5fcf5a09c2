"""Training of the flow network: fine-tunes a pretrained encoder on annotated control flows and exports it."""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.control_flow.arcs import ORDERS, ROLES, Arc
from decomplex_bt.understanding.control_flow.clause import MarkedTask
from decomplex_bt.understanding.control_flow.clauses import clauses_of, wordings_of
from decomplex_bt.understanding.control_flow.derivation import arcs_of
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.dependencies import marked_tasks
from decomplex_bt.understanding.encoder.export import export, weights_of
from decomplex_bt.understanding.encoder.fitting import Lessons, Pace, fit, padded, precision
from decomplex_bt.understanding.encoder.flows import (
    JUDGE_FILE,
    LABELS_FILE,
    NETWORK_FILE,
    Labels,
    pieces_of,
    read_labels,
)
from decomplex_bt.understanding.encoder.pieces import Pieced, Pieces
from decomplex_bt.understanding.encoder.pretrained import begin
from decomplex_bt.understanding.features import Observed

PACE = Pace(epochs=4, noised=0.4, recombined=0.2, encoder_rate=1e-4, heads_rate=5e-4)
FURTHER = Pace(epochs=4, noised=0.4, recombined=0.2, known=1.0, encoder_rate=8e-5, heads_rate=3e-4, kept=0.25)
"""For a network that goes on from a trained one."""

Pair = tuple[Observed, Instruction]
Learnable = tuple[Observed, tuple[MarkedTask, ...], tuple[Arc, ...]]
"""An instruction, its tasks, and the labels that say its flow."""


@dataclass(frozen=True, slots=True)
class FlowSample:
    """One instruction: its pieces, where its tasks are marked, and their labels as indices (role, attachment,
    order)."""

    pieced: Pieced
    places: tuple[int, ...]
    labels: tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]


def train_flow_network(
    folder: Path,
    lessons: Lessons[Pair],
    ontology: Ontology,
    *,
    base: Path | None = None,
    pace: Pace | None = None,
    seed: int = 0,
    progress: Callable[[str], None] = lambda stage: None,
) -> None:
    """Fine-tunes the network, given tasks and arguments as annotated, and writes it with its labels to `folder`.
    `base`: a folder with a trained one to go on from.

    About 35 ms for each example and epoch on one core that has bfloat16, three times as long on others.
    The same data, seed, libraries and kind of processor give the same files. Raises `TrainerMissingError`.
    """
    found = [_learnable(pairs) for pairs in (lessons.plain, lessons.noised, lessons.recombined, lessons.known)]
    attachments = {arc.attachment for _, _, arcs in chain.from_iterable(found) for arc in arcs}
    before = () if base is None else read_labels(base).attachments
    names = Labels(ROLES, (*before, *sorted(attachments - {*before})), ORDERS)
    network, pretrained = _begun(names, seed)
    pieces, types = Pieces(pretrained / "tokenizer.json"), sorted(ontology.task_types)
    samples = Lessons(*(_samples(each, pieces, types, names) for each in found))
    if base is not None:
        _load(network, base, names)
    fit(network, samples, _loss, pace or (PACE if base is None else FURTHER), random.Random(seed), progress)
    write_flow_network(network, names, folder)


def read_flow_network(folder: Path, names: Labels) -> Any:
    """A trained network as it was before it was exported, as near as 8 bits come; attachments that it does not know,
    the last ones of `names`, are untrained. Raises `DataFileError` where it is none or its other labels are others,
    `TrainerMissingError`."""
    network, _ = _begun(names, 0)
    _load(network, folder, names)
    return network


def write_flow_network(network: Any, names: Labels, folder: Path) -> None:
    """Writes a network for the run time, and its labels."""
    _export(network, folder)
    (folder / LABELS_FILE).write_text(json.dumps(names._asdict()) + "\n", encoding="utf-8")


def _begun(names: Labels, seed: int) -> tuple[Any, Path]:
    """An untrained network on the pretrained encoder, and the folder of the latter."""
    encoder, pretrained = begin(seed)
    from decomplex_bt.understanding.encoder.flow_network import FlowNetwork, FlowSizes

    return FlowNetwork(encoder, FlowSizes(encoder.config.hidden_size, *map(len, names))), pretrained


def _learnable(pairs: Sequence[Pair]) -> list[Learnable]:
    """The instructions with an order to learn, whose flow the labels can say."""
    found = []
    for observed, instruction in pairs:
        marked = marked_tasks(observed, instruction)
        arcs = arcs_of(instruction.flow, wordings_of(clauses_of(observed, marked))) if len(marked) > 1 else None
        if arcs is not None:
            found.append((observed, marked, arcs))
    return found


def _samples(
    learnable: Sequence[Learnable],
    pieces: Pieces,
    types: Sequence[str],
    names: Labels,
) -> list[FlowSample]:
    found = []
    for observed, marked, arcs in learnable:
        pieced = pieces_of(observed.document, marked, pieces, types)
        if pieced is None:
            continue
        labels = (
            tuple(names.roles.index(arc.role) for arc in arcs),
            tuple(names.attachments.index(arc.attachment) for arc in arcs),
            tuple(names.orders.index(arc.order) for arc in arcs),
        )
        found.append(FlowSample(pieced, tuple(pieced.firsts[task.token] for task in marked), labels))
    return found


def _loss(network: Any, batch: Sequence[FlowSample]) -> Any:
    import torch
    from torch.nn import functional

    from decomplex_bt.understanding.encoder.network import IGNORED

    width, count = max(len(s.pieced.ids) for s in batch), max(len(s.places) for s in batch)
    ids = torch.tensor([padded(s.pieced.ids, width, 0) for s in batch])
    mask = torch.tensor([padded([1] * len(s.pieced.ids), width, 0) for s in batch])
    absent = torch.tensor([padded([0] * len(s.places), count, 1) for s in batch]).bool()
    wanted = [torch.tensor([padded(s.labels[i], count, IGNORED) for s in batch]) for i in range(3)]
    with precision():  # the heads stay in single precision
        vectors = network.read(ids, mask, torch.tensor([padded(s.places, count, 0) for s in batch]))
    settled = network.settle(vectors.float(), absent)
    scores = network.judge(settled, wanted[0].clamp(min=0), wanted[1].clamp(min=0), absent)
    losses = [
        functional.cross_entropy(found.flatten(0, 1), right.flatten(), ignore_index=IGNORED, reduction="sum")
        for found, right in zip(scores, wanted, strict=True)
    ]
    return sum(losses) / len(batch)


def _load(network: Any, base: Path, names: Labels) -> None:
    """Gives a network the weights of a trained one; attachments that it does not know, the last ones, keep their own.
    Raises `DataFileError` where its other labels are others."""
    import torch

    before = read_labels(base)
    if (before.roles, before.orders) != (names.roles, names.orders):
        raise ModelError(base / LABELS_FILE, "the network was trained with other labels of flows")
    weights = network.state_dict()
    for file in (NETWORK_FILE, JUDGE_FILE):
        for name, value in weights_of(base / file).items():
            weights[name.removeprefix("network.")][: len(value)] = torch.tensor(value)
    network.load_state_dict(weights)


def _export(network: Any, folder: Path) -> None:
    """The network as two graphs: one reads an instruction, the other judges labels, many ways in one run."""
    import torch

    class Reader(torch.nn.Module):
        def __init__(self) -> None:
            super().__init__()
            self.network = network

        def forward(self, ids: torch.Tensor, mask: torch.Tensor, places: torch.Tensor) -> torch.Tensor:
            settled: torch.Tensor = self.network.settle(self.network.read(ids, mask, places))
            return settled

    class Judge(torch.nn.Module):
        def __init__(self) -> None:
            super().__init__()
            self.network = network

        def forward(
            self, settled: torch.Tensor, roles: torch.Tensor, attachments: torch.Tensor
        ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
            found: tuple[torch.Tensor, torch.Tensor, torch.Tensor] = self.network.judge(settled, roles, attachments)
            return found

    pieces, tasks = torch.ones(1, 8, dtype=torch.long), torch.ones(1, 3, dtype=torch.long)
    along = {0: "batch", 1: "pieces"}, {0: "batch", 1: "tasks"}
    export(
        Reader(),
        (pieces, pieces, tasks),
        folder / NETWORK_FILE,
        inputs={"ids": along[0], "mask": along[0], "places": along[1]},
        outputs=("settled",),
    )
    vectors = torch.zeros(2, 3, network.role.embedding_dim)
    export(
        Judge(),
        (vectors, tasks.expand(2, 3), tasks.expand(2, 3)),
        folder / JUDGE_FILE,
        inputs={"settled": along[1], "roles": along[1], "attachments": along[1]},
        outputs=("role_scores", "attachment_scores", "order_scores"),
    )
