"""Argument identification: BIO labels over the argument types, each argument with the task that owns it.
 The default model says the owner in the label itself: `B-object<` belongs to the nearest task to the left, `I-state>`
to the nearest to the right, doubled (`<<`) to the second nearest. The paper's model (DeComplex, section III-B) has
plain BIO labels and a feature that associates each token with a task; which task, it finds by trying every split
between two tasks. That search, and its two baselines, are `AssociationArguments`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Literal

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.crf import Crf, CrfParameters, Features, Labelling, train_crf
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed, argument_features, plain_argument_features

OUTSIDE = "O"
PARAMETERS = CrfParameters(c1=0.03, c2=0.05, max_iterations=120)
FARTHEST_OWNER = 2
"""The rank of the farthest task that a label can name as owner."""

Method = Literal["none", "naive", "split"]


CERTAIN = 0.9
"""The confidence of an argument that no model found, but a rule."""


@dataclass(frozen=True, slots=True)
class FoundArgument:
    """An argument: its type, the token of the task that owns it, and its tokens; `confidence` is the mean marginal."""

    type: str
    owner: int
    tokens: range
    confidence: float


@dataclass(frozen=True, slots=True)
class FoundArguments:
    """All arguments of a document with the joint probability of all labels."""

    arguments: tuple[FoundArgument, ...]
    probability: float


class ArgumentModel:
    """The trained argument CRF whose labels say the owner."""

    def __init__(self, path: Path) -> None:
        self._crf = Crf(path)

    def find(self, observed: Observed, tasks: Mapping[int, str]) -> tuple[FoundArgument, ...]:
        """The arguments of a document, in text order; `tasks` maps token indices to task types."""
        return self.find_all(observed, tasks).arguments

    def find_all(self, observed: Observed, tasks: Mapping[int, str]) -> FoundArguments:
        """As `find`, with the joint probability of all labels."""
        if not tasks:
            return FoundArguments((), 1.0)
        labelling = self._crf.label(argument_features(observed, tasks))
        places = sorted(tasks)
        arguments = tuple(
            FoundArgument(label.rstrip("<>"), _owner(label, tokens, places), tokens, confidence)
            for label, tokens, confidence in _chunks(labelling)
        )
        return FoundArguments(arguments, labelling.probability)


class AssociationArguments:
    """The paper's argument CRF with one of its three ways to associate tokens with tasks (DeComplex, Table III)."""

    def __init__(self, path: Path, method: Method) -> None:
        self._crf = Crf(path)
        self.method = method

    def find(self, observed: Observed, tasks: Mapping[int, str]) -> tuple[FoundArgument, ...]:
        """The arguments of a document, in text order; `tasks` maps token indices to task types."""
        if not tasks:
            return ()
        association = naive_association(len(observed.document), sorted(tasks))
        base = plain_argument_features(observed)
        labelling = self._label(base, tasks, association)
        if self.method == "split":
            association, labelling = self._search(base, tasks, association, labelling)
        return tuple(
            FoundArgument(label, association[tokens.start], tokens, confidence)
            for label, tokens, confidence in _chunks(labelling)
        )

    def _label(self, base: Sequence[Features], tasks: Mapping[int, str], association: Sequence[int]) -> Labelling:
        return self._crf.label(_associated(base, tasks, association if self.method != "none" else None))

    def _search(
        self, base: Sequence[Features], tasks: Mapping[int, str], association: list[int], best: Labelling
    ) -> tuple[list[int], Labelling]:
        """Between each two tasks tries every split point and keeps the labelling of highest joint probability."""
        places = sorted(tasks)
        for left, right in pairwise(places):
            for split in range(left + 1, right):
                trial = [*association]
                trial[split:right] = [right] * (right - split)
                labelling = self._label(base, tasks, trial)
                if labelling.probability > best.probability:
                    association, best = trial, labelling
        return association, best


def naive_association(length: int, places: Sequence[int]) -> list[int]:
    """For every token the token of the task before it (of the first task, for tokens ahead of it)."""
    association, current = [], places[0]
    for i in range(length):
        if i in places:
            current = i
        association.append(current)
    return association


def gold_labels(document: Document, instruction: Instruction) -> list[str]:
    """BIO labels with owners (`B-object<`), from an annotation; a token of two spans keeps the first."""
    places = {task.id: document.indices(task.span).start for task in instruction.tasks}
    order = sorted(places.values())

    def suffix(owner: int, tokens: range) -> str:
        side = (
            order[: _position(order, tokens.start)][::-1]
            if owner < tokens.start
            else [p for p in order if p >= tokens.stop]
        )
        rank = side.index(owner) + 1 if owner in side else 1
        return ("<" if owner < tokens.start else ">") * min(rank, FARTHEST_OWNER)

    return _gold(document, instruction, places, suffix)


def plain_gold_labels(document: Document, instruction: Instruction) -> list[str]:
    """Plain BIO labels, as the paper has them, from an annotation."""
    places = {task.id: document.indices(task.span).start for task in instruction.tasks}
    return _gold(document, instruction, places, lambda owner, tokens: "")


def gold_association(document: Document, instruction: Instruction) -> list[int]:
    """For every token the token of the task that owns it; outside arguments as `naive_association`."""
    places = {task.id: document.indices(task.span).start for task in instruction.tasks}
    association = naive_association(len(document), sorted(places.values()))
    for task in instruction.tasks:
        for argument in task.arguments:
            if argument.span is not None:
                for i in document.indices(argument.span):
                    association[i] = places[task.id]
    return association


def train_arguments(path: Path, data: Sequence[tuple[Observed, Instruction]]) -> None:
    """Trains the default argument CRF on annotated documents, given their gold tasks, and writes it to `path`."""
    data = [(observed, instruction) for observed, instruction in data if instruction.tasks]
    train_crf(
        path,
        [argument_features(observed, gold_tasks(observed.document, instruction)) for observed, instruction in data],
        [gold_labels(observed.document, instruction) for observed, instruction in data],
        PARAMETERS,
    )


def train_association(path: Path, data: Sequence[tuple[Observed, Instruction]], method: Method) -> None:
    """Trains the paper's argument CRF. With "split" tokens are associated with the task that truly owns them."""
    items, labels = [], []
    for observed, instruction in data:
        if not instruction.tasks:
            continue
        tasks = gold_tasks(observed.document, instruction)
        association: Sequence[int] | None = None
        if method == "split":
            association = gold_association(observed.document, instruction)
        elif method == "naive":
            association = naive_association(len(observed.document), sorted(tasks))
        items.append(_associated(plain_argument_features(observed), tasks, association))
        labels.append(plain_gold_labels(observed.document, instruction))
    train_crf(path, items, labels, PARAMETERS)


def gold_tasks(document: Document, instruction: Instruction) -> dict[int, str]:
    """Token index to task type, from an annotation."""
    return {document.indices(task.span).start: task.type for task in instruction.tasks}


def _associated(
    base: Sequence[Features], tasks: Mapping[int, str], association: Sequence[int] | None
) -> list[Features]:
    """The base features with the paper's g (section III-B): at a task its own place is marked, elsewhere the type of
    the task that the token is associated with."""
    if association is None:
        return list(base)
    return [
        {
            **item,
            "g": "itself" if i in tasks else tasks[association[i]],
            "g.lower": f"{tasks[association[i]]}.{item['lower']}",
        }
        for i, item in enumerate(base)
    ]


def _gold(
    document: Document, instruction: Instruction, places: Mapping[int, int], suffix: Callable[[int, range], str]
) -> list[str]:
    labels = [OUTSIDE] * len(document)
    carriers = set(places.values())
    for task in instruction.tasks:
        for argument in task.arguments:
            if argument.span is None:
                continue
            tokens = document.indices(argument.span)
            if not tokens or any(labels[i] != OUTSIDE or i in carriers for i in tokens):
                continue
            ending = argument.type + suffix(places[task.id], tokens)
            for i in tokens:
                labels[i] = f"{'B' if i == tokens.start else 'I'}-{ending}"
    return labels


def _chunks(labelling: Labelling) -> list[tuple[str, range, float]]:
    """The labelled stretches: label without B/I, tokens, mean marginal. An I after another label begins a stretch."""
    chunks: list[tuple[str, range, float]] = []
    start, name = 0, ""
    for i, label in enumerate((*labelling.labels, OUTSIDE)):
        prefix, _, ending = label.partition("-")
        if prefix == "I" and ending == name:
            continue
        if name:
            confidence = sum(labelling.marginals[start:i]) / (i - start)
            chunks.append((name, range(start, i), confidence))
        start, name = i, ending
    return chunks


def _owner(label: str, tokens: range, places: Sequence[int]) -> int:
    """The task that a label's arrows point at; the nearest there is where they point past the last."""
    arrows = label[len(label.rstrip("<>")) :]
    left = [p for p in reversed(places) if p < tokens.start]
    right = [p for p in places if p >= tokens.stop]
    side, other = (left, right) if arrows.startswith("<") else (right, left)
    if side:
        return side[min(len(arrows), len(side)) - 1]
    return other[0] if other else places[0]


def _position(order: Sequence[int], token: int) -> int:
    return sum(place < token for place in order)
