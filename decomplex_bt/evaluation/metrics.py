"""How well instructions are understood: tasks, arguments, dependencies and control flow against gold ones."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.evaluation.tree_distance import Forest, Tree, edit_distance, forest_size
from decomplex_bt.flow import DEPENDENCIES, If, Node
from decomplex_bt.instruction import Instruction, Task


@dataclass(frozen=True, slots=True)
class F1:
    """Precision, recall and their harmonic mean, from counts; 1 where nothing was to be found and nothing was."""

    right: int
    found: int
    wanted: int

    @property
    def precision(self) -> float:
        return self.right / self.found if self.found else float(not self.wanted)

    @property
    def recall(self) -> float:
        return self.right / self.wanted if self.wanted else float(not self.found)

    @property
    def value(self) -> float:
        both = self.found + self.wanted
        return 2 * self.right / both if both else 1.0

    def to_json(self) -> dict[str, Any]:
        shares = {"f1": self.value, "precision": self.precision, "recall": self.recall}
        return {**{name: round(share, 4) for name, share in shares.items()}, "support": self.wanted}


@dataclass(frozen=True, slots=True)
class LabelScores:
    """The F1 of each label, in the order of the labels' names, over all of them and weighted by how many there are."""

    by_label: tuple[tuple[str, F1], ...]

    @property
    def overall(self) -> F1:
        """Over all labels together (micro)."""
        parts = [score for _, score in self.by_label]
        return F1(sum(p.right for p in parts), sum(p.found for p in parts), sum(p.wanted for p in parts))

    @property
    def weighted(self) -> float:
        """The mean of the labels' F1, each weighted by its support."""
        support = sum(score.wanted for _, score in self.by_label)
        return sum(score.value * score.wanted for _, score in self.by_label) / support if support else 1.0

    def of(self, label: str) -> F1:
        """The F1 of a label; that of nothing for one that never occurred."""
        return dict(self.by_label).get(label, F1(0, 0, 0))

    def to_json(self) -> dict[str, Any]:
        return {
            **self.overall.to_json(),
            "weighted_f1": round(self.weighted, 4),
            "by_label": {label: score.to_json() for label, score in self.by_label},
        }


@dataclass(frozen=True, slots=True)
class LanguageScores:
    """Understanding against gold.

    `tasks`: token and type. `arguments`: span, type and owner, of those that have words. `dependencies`: the paper's
    four labels at the right token. `flow`: instructions with the same tasks and the same flow; `strict`: and all
    argument values, upper and lower case alike. `ordering_errors`, `nodes`: edits of the control-flow trees and the
    nodes of the gold ones.
    """

    tasks: LabelScores
    arguments: LabelScores
    dependencies: LabelScores
    flow: Proportion
    strict: Proportion
    ordering_errors: int
    nodes: int

    @property
    def oer(self) -> float:
        """Ordering Error Rate: (S + D + I) / N over all instructions together (DeComplex, section IV-D)."""
        return self.ordering_errors / self.nodes if self.nodes else float(self.ordering_errors > 0)

    def to_json(self) -> dict[str, Any]:
        return {
            "tasks": self.tasks.to_json(),
            "arguments": self.arguments.to_json(),
            "dependencies": self.dependencies.to_json(),
            "flow_exact": self.flow.to_json(),
            "strict": self.strict.to_json(),
            "oer": round(self.oer, 4),
        }


def score(predicted: Sequence[Instruction], gold: Sequence[Instruction]) -> LanguageScores:
    """The scores of readings against gold ones of the same texts, in the same order.

    Raises `ValueError` where lengths or texts differ.
    """
    pairs = list(zip(predicted, gold, strict=True))
    for found, wanted in pairs:
        if found.text != wanted.text:
            raise ValueError(f"readings of different texts: {found.text!r} and {wanted.text!r}")
    return LanguageScores(
        tasks=_labels(pairs, _task_items),
        arguments=_labels(pairs, _argument_items),
        dependencies=_labels(pairs, _dependency_items, always=DEPENDENCIES),
        flow=Proportion(sum(has_same_flow(*pair) for pair in pairs), len(pairs)),
        strict=Proportion(sum(is_same(*pair) for pair in pairs), len(pairs)),
        ordering_errors=sum(ordering_errors(*pair) for pair in pairs),
        nodes=sum(forest_size(flow_forest(wanted)) for _, wanted in pairs),
    )


def score_by_complexity(
    predicted: Sequence[Instruction], gold: Sequence[Instruction]
) -> dict[str, tuple[int, LanguageScores]]:
    """Number and scores of all instructions, of simple, complex and long ones; empty groups are left out."""
    pairs = list(zip(predicted, gold, strict=True))
    groups = {
        "all": pairs,
        "one task or none": [pair for pair in pairs if len(pair[1].tasks) < 2],
        "complex": [pair for pair in pairs if len(pair[1].tasks) >= 2],
        "above five tasks": [pair for pair in pairs if len(pair[1].tasks) > 5],
    }
    return {
        name: (len(group), score([found for found, _ in group], [wanted for _, wanted in group]))
        for name, group in groups.items()
        if group
    }


def has_same_flow(found: Instruction, wanted: Instruction) -> bool:
    """Whether two readings have the same tasks (token and type) and the same control flow."""
    return _typed_tokens(found) == _typed_tokens(wanted) and found.flow == wanted.flow


def is_same(found: Instruction, wanted: Instruction) -> bool:
    """Whether two readings also have the same argument values, upper and lower case alike."""
    return has_same_flow(found, wanted) and all(
        _values(one) == _values(other) for one, other in zip(found.tasks, wanted.tasks, strict=True)
    )


def ordering_errors(found: Instruction, wanted: Instruction) -> int:
    """Substitutions, deletions and insertions of nodes that turn the found control-flow tree into the wanted one."""
    return edit_distance(flow_forest(found), flow_forest(wanted))


def flow_forest(instruction: Instruction) -> Forest:
    """The control flow as trees: a node for each task that is executed, under a condition what depends on it.

    A node is told by its token, its type and the side it stands on; merged mentions are one node.
    """
    return tuple(_flow_tree(node, instruction, "top") for node in instruction.flow.nodes)


def _flow_tree(node: Node, instruction: Instruction, side: str) -> Tree:
    task = instruction.task(node.task)
    label = (side, task.span, task.type)
    if not isinstance(node, If):
        return Tree(label)
    branches = [("then", child) for child in node.then] + [("else", child) for child in node.orelse]
    return Tree(label, tuple(_flow_tree(child, instruction, place) for place, child in branches))


Pairs = Iterable[tuple[Instruction, Instruction]]
Items = Callable[[Instruction], Iterator[tuple[str, Hashable]]]
"""What is counted in a reading: pairs of a label and what it stands at."""


def _labels(pairs: Pairs, items: Items, *, always: Iterable[str] = ()) -> LabelScores:
    right: Counter[str] = Counter()
    found: Counter[str] = Counter()
    wanted: Counter[str] = Counter()
    for mine, gold in pairs:
        have, want = Counter(items(mine)), Counter(items(gold))
        for counter, counted in ((right, have & want), (found, have), (wanted, want)):
            for (label, _), count in counted.items():
                counter[label] += count
    labels = sorted({*found, *wanted, *always})
    return LabelScores(tuple((label, F1(right[label], found[label], wanted[label])) for label in labels))


def _task_items(instruction: Instruction) -> Iterator[tuple[str, Hashable]]:
    return ((task.type, task.span) for task in instruction.tasks)


def _argument_items(instruction: Instruction) -> Iterator[tuple[str, Hashable]]:
    for task in instruction.tasks:
        for argument in task.arguments:
            if argument.span is not None:
                yield argument.type, (task.span, argument.span)


def _dependency_items(instruction: Instruction) -> Iterator[tuple[str, Hashable]]:
    labels: Mapping[int, str] = instruction.flow.dependencies()
    return ((labels[task.id], task.span) for task in instruction.tasks if task.id in labels)


def _typed_tokens(instruction: Instruction) -> list[tuple[int, str, Hashable]]:
    return [(task.id, task.type, task.span) for task in instruction.tasks]


def _values(task: Task) -> list[tuple[str, str]]:
    return sorted((argument.type, " ".join(argument.value.lower().split())) for argument in task.arguments)
