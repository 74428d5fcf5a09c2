"""References read off the encoder: how well a phrase fits a word that refers by the meaning of both, beside what the
log-linear model of `coreference` knows of their forms and places."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.coreference import ReferenceModel, choices_of
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.dependencies import marked_tasks
from decomplex_bt.understanding.encoder.heads import log_softmax
from decomplex_bt.understanding.encoder.labels import task_labels
from decomplex_bt.understanding.encoder.model import EncoderModel
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.options import Option

SHARE_FILE = "share.json"
LARGEST_SHARE = 3.0
"""The most that the encoder's score of a phrase may count beside the log-linear model's."""


class EncoderReferences:
    """The encoder's scores of what a word may refer to; `share`: how much they count. What is left unsaid has no word
    to compare; there they gained nothing."""

    def __init__(self, model: EncoderModel, ontology: Ontology, share: float) -> None:
        self._model = model
        self._types = task_labels(tuple(ontology.task_types))
        self._share = share

    def scores(self, observed: Observed, tasks: Mapping[int, str], gap: Gap, options: Sequence[Option]) -> list[float]:
        """What to add to the score of each option: 0 for the best phrase and for leaving the gap, less for the others.

        `tasks` maps token indices to task types.
        """
        if not gap.word:
            return [0.0] * len(options)
        anchors = sorted({option.candidate.anchor for option in options if option.candidate is not None})
        if len(anchors) < 2:
            return [0.0] * len(options)
        types = [self._types.index(tasks.get(i, "O")) for i in range(len(observed.document))]
        heads = self._model.heads
        typed = heads.typed(self._model.vectors(observed.document), types)
        found = heads.references(typed, gap.position, anchors, sorted(tasks))
        of_anchor = dict(zip(anchors, (self._share * (found - found.max())).tolist(), strict=True))
        return [of_anchor[o.candidate.anchor] if o.candidate is not None else 0.0 for o in options]


def load_references(folder: Path, model: EncoderModel, ontology: Ontology) -> EncoderReferences:
    """With the share from a folder of a trained encoder. Raises `DataFileError`."""
    path = folder / SHARE_FILE
    try:
        share = float(json.loads(path.read_text(encoding="utf-8"))["references"])
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ModelError(path, f"no share of the encoder ({type(error).__name__})") from None
    return EncoderReferences(model, ontology, share)


def train_share(
    folder: Path,
    model: EncoderModel,
    references: ReferenceModel,
    data: Sequence[tuple[Observed, Instruction]],
    ontology: Ontology,
) -> None:
    """Fits the share on annotated instructions that neither model was trained on, by likelihood, and writes it."""
    import numpy as np
    from scipy.optimize import minimize_scalar

    encoder = EncoderReferences(model, ontology, 1.0)
    tables: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    for observed, instruction in data:
        tasks = {task.token: task.type for task in marked_tasks(observed, instruction)}
        for choice in choices_of(observed, instruction, ontology):
            if choice.gap.word:
                plain = np.array(references.scores(choice.options))
                added = np.array(encoder.scores(observed, tasks, choice.gap, choice.options))
                tables.append((plain, added, np.array(choice.right)))

    def loss(share: float) -> float:
        chances = [log_softmax(plain + share * added)[right] for plain, added, right in tables]
        return -sum(float(np.logaddexp.reduce(fitting)) for fitting in chances)

    share = float(minimize_scalar(loss, bounds=(0, LARGEST_SHARE), method="bounded").x) if tables else 0.0
    (folder / SHARE_FILE).write_text(json.dumps({"references": round(share, 4)}) + "\n", encoding="utf-8")
