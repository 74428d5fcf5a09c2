"""References read off the encoder: how well each phrase fills a gap by the meaning of both, beside what the log-linear
model of `coreference` knows of their forms and places."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.errors import DataFileError
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.affinity import Option
from decomplex_bt.understanding.coreference import ReferenceModel, choices_of
from decomplex_bt.understanding.dependencies import marked_tasks
from decomplex_bt.understanding.encoder.heads import log_softmax
from decomplex_bt.understanding.encoder.labels import task_labels
from decomplex_bt.understanding.encoder.model import EncoderModel
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gaps import Gap

SHARES_FILE = "shares.json"
SAID, UNSAID = "said", "unsaid"
LARGEST_SHARE = 3.0
"""The most that the encoder's score of a phrase may count beside the log-linear model's."""


class EncoderReferences:
    """The encoder's scores of the options of a gap; `shares`: how much they count, for words and for what is unsaid."""

    def __init__(self, model: EncoderModel, ontology: Ontology, shares: Mapping[str, float]) -> None:
        self._model = model
        self._types = task_labels(tuple(ontology.task_types))
        self._shares = shares

    def scores(self, observed: Observed, tasks: Mapping[int, str], gap: Gap, options: Sequence[Option]) -> list[float]:
        """What to add to the score of each option: 0 for the best phrase and for leaving the gap, less for the others.

        `tasks` maps token indices to task types.
        """
        share = self._shares[SAID if gap.word else UNSAID]
        if not share:
            return [0.0] * len(options)
        return [share * score for score in self.raw_scores(observed, tasks, gap, options)]

    def raw_scores(
        self, observed: Observed, tasks: Mapping[int, str], gap: Gap, options: Sequence[Option]
    ) -> list[float]:
        """As `scores`, all counted whole."""
        anchors = sorted({option.candidate.anchor for option in options if option.candidate is not None})
        if len(anchors) < 2:
            return [0.0] * len(options)
        types = [self._types.index(tasks.get(i, "O")) for i in range(len(observed.document))]
        heads = self._model.heads
        typed = heads.typed(self._model.vectors(observed.document), types)
        found = log_softmax(heads.references(typed, gap.position, anchors, sorted(tasks)))
        of_anchor = dict(zip(anchors, (found - found.max()).tolist(), strict=True))
        return [of_anchor[o.candidate.anchor] if o.candidate is not None else 0.0 for o in options]


def load_references(folder: Path, model: EncoderModel, ontology: Ontology) -> EncoderReferences:
    """With the shares from a folder of a trained encoder. Raises `DataFileError`."""
    path = folder / SHARES_FILE
    try:
        stored = json.loads(path.read_text(encoding="utf-8"))
        shares = {name: float(stored[name]) for name in (SAID, UNSAID)}
    except (OSError, ValueError, KeyError, TypeError) as error:
        problem = f"no shares of the encoder ({type(error).__name__}); run `decomplex-bt train --encoder`"
        raise DataFileError(path, problem) from None
    return EncoderReferences(model, ontology, shares)


def train_shares(
    folder: Path,
    model: EncoderModel,
    references: ReferenceModel,
    data: Sequence[tuple[Observed, Instruction]],
    ontology: Ontology,
) -> None:
    """Fits the shares on annotated instructions that neither model was trained on, by likelihood, and writes them."""
    import numpy as np
    from scipy.optimize import minimize_scalar

    encoder = EncoderReferences(model, ontology, {})
    tables: dict[str, list[tuple[np.ndarray, np.ndarray, np.ndarray]]] = {SAID: [], UNSAID: []}
    for observed, instruction in data:
        tasks = {task.token: task.type for task in marked_tasks(observed, instruction)}
        for choice in choices_of(observed, instruction, ontology):
            plain = np.array(references.scores(choice.options))
            added = np.array(encoder.raw_scores(observed, tasks, choice.gap, choice.options))
            tables[SAID if choice.gap.word else UNSAID].append((plain, added, np.array(choice.right)))

    def loss(share: float, name: str) -> float:
        total = 0.0
        for plain, added, right in tables[name]:
            chances = log_softmax(plain + share * added)
            total -= float(np.logaddexp.reduce(chances[right]))
        return total

    shares = {
        name: round(float(minimize_scalar(loss, bounds=(0, LARGEST_SHARE), args=(name,), method="bounded").x), 4)
        for name in (SAID, UNSAID)
    }
    (folder / SHARES_FILE).write_text(json.dumps(shares, indent=1) + "\n", encoding="utf-8")
