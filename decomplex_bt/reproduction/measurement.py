"""One split: the paper's systems trained on its one part and measured on the other; our default interpreter likewise.

A measure is a number under a key such as `arguments/split/f1`; the keys are those of `paper.yaml`.
"""

from __future__ import annotations

import tempfile
from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain
from pathlib import Path

import numpy as np

from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.evaluation.metrics import F1, LabelScores, flow_forest, has_same_flow, ordering_errors
from decomplex_bt.evaluation.tree_distance import forest_size
from decomplex_bt.flow import DEPENDENCIES, Flow
from decomplex_bt.instruction import Instruction
from decomplex_bt.reproduction.dataset import KnownDocuments, Sample
from decomplex_bt.reproduction.interval import bootstrap, wilson
from decomplex_bt.reproduction.systems import LABELLERS, MERGED, METHODS, PaperSystem, train_paper_system
from decomplex_bt.understanding.arguments import FoundArgument, gold_tasks, plain_gold_labels
from decomplex_bt.understanding.dependencies import FlowModel, marked_tasks, train_flow, tree_of
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.manifest import corpus_hash, write_manifest
from decomplex_bt.understanding.training import train_models

OUTSIDE = "O"


@dataclass(slots=True)
class Measures:
    """Numbers by key, with what this one split says of their intervals, where that was asked for.

    `example`: what the paper's example (Fig. 1) was understood as, where it was asked for.
    """

    values: dict[str, float] = field(default_factory=dict)
    intervals: dict[str, tuple[float, float]] = field(default_factory=dict)
    example: str = ""

    def add_share(self, key: str, right: Iterable[bool]) -> None:
        """The share of instructions that are right."""
        outcomes = list(right)
        self.values[key] = sum(outcomes) / len(outcomes) if outcomes else 1.0
        if interval := wilson(outcomes):
            self.intervals[key] = interval


def measure_paper(train: Sequence[Sample], test: Sequence[Sample], features: Sequence[str], example: Observed | None
                  ) -> Measures:  # fmt: skip
    """Trains and measures the paper's systems, its baselines among them."""
    measures = Measures()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        data = [(sample.observed, sample.example.instruction) for sample in train]
        system = train_paper_system(folder, data)
        train_flow(folder, [pair for pair in data if len(pair[1].tasks) > 1])
        complex_ones = [sample for sample in test if sample.is_complex]
        _measure_tasks(measures, system, test)
        _measure_arguments(measures, system, test)
        _measure_dependencies(measures, system, FlowModel(folder), complex_ones)
        _measure_flows(measures, system, complex_ones)
        for (before, after), weight in system.transitions().items():
            measures.values[f"transitions/{before}/{after}"] = weight
        for name, (count, size) in system.feature_weights(features).items():
            measures.values |= {f"features/{name}/weights": count, f"features/{name}/size": size}
        if example is not None:
            measures.example = str(system.understand(example))
    return measures


def measure_interpreter(
    train: Sequence[Sample],
    test: Sequence[Sample],
    domain: str | Path,
    documents: KnownDocuments,
    example: str | None,
    rng: np.random.Generator,
) -> Measures:
    """Trains our default interpreter as `decomplex-bt train` does, and measures it.

    The intervals are by bootstrap over the test instructions, Wilson's for shares of them.
    """
    measures = Measures()
    with tempfile.TemporaryDirectory() as scratch:
        interpreter = _trained(Path(scratch), train, load_domain(domain), documents)
        read = [interpreter.interpret(sample.example.instruction.text) for sample in test]
        if example is not None:
            measures.example = str(interpreter.interpret(example))
    gold = [sample.example.instruction for sample in test]
    labels = [plain_gold_labels(s.observed.document, found) for s, found in zip(test, read, strict=True)]
    _score_labels(measures, "arguments/interpreter", labels, test)
    wanted = [_placed(plain_gold_labels(s.observed.document, s.example.instruction)) for s in test]
    scored: dict[str, tuple[list[Items], list[Items], Callable[[LabelScores], float]]] = {
        "tasks/interpreter/f1": ([_task_items(i) for i in gold], [_task_items(i) for i in read], _weighted_f1),
        "arguments/interpreter/f1": ([*wanted], [_placed(found) for found in labels], _weighted_f1),
        "owners/interpreter/f1": ([_owned_items(i) for i in gold], [_owned_items(i) for i in read], _micro_f1),
    }
    for key, (theirs, ours, summary) in scored.items():

        def measure(
            drawn: Sequence[int],
            theirs: list[Items] = theirs,
            ours: list[Items] = ours,
            summary: Callable[[LabelScores], float] = summary,
        ) -> float:
            return summary(label_scores([theirs[i] for i in drawn], [ours[i] for i in drawn]))

        measures.values[key] = measure(range(len(test)))
        measures.intervals[key] = bootstrap(measure, len(test), rng)
    _measure_interpreted_flows(
        measures, [(r, g) for s, r, g in zip(test, read, gold, strict=True) if s.is_complex], rng
    )
    return measures


def _measure_interpreted_flows(
    measures: Measures, pairs: Sequence[tuple[Instruction, Instruction]], rng: np.random.Generator
) -> None:
    _score_flows(measures, "flow/interpreter", pairs)
    measures.add_share("tasks all right/interpreter", (_typed(found) == _typed(wanted) for found, wanted in pairs))
    errors = [ordering_errors(found, wanted) for found, wanted in pairs]
    nodes = [forest_size(flow_forest(wanted)) for _, wanted in pairs]
    if pairs:
        measures.intervals["flow/interpreter/oer"] = bootstrap(
            lambda drawn: sum(errors[i] for i in drawn) / sum(nodes[i] for i in drawn), len(pairs), rng
        )


def _weighted_f1(scores: LabelScores) -> float:
    return scores.weighted


def _micro_f1(scores: LabelScores) -> float:
    return scores.overall.value


def weighted(scores: LabelScores) -> tuple[float, float, float]:
    """Precision, recall and F1, each the mean over the labels weighted by their support, as the paper averages."""
    support = sum(score.wanted for _, score in scores.by_label)
    if not support:
        return 1.0, 1.0, 1.0
    precision = sum(score.precision * score.wanted for _, score in scores.by_label) / support
    recall = sum(score.recall * score.wanted for _, score in scores.by_label) / support
    return precision, recall, scores.weighted


Items = Sequence[tuple[str, Hashable]]
"""Of one instruction: pairs of a label and what it stands at."""


def label_scores(gold: Sequence[Items], found: Sequence[Items]) -> LabelScores:
    """The scores of every label over all instructions, which both lists hold in the same order."""
    right: Counter[str] = Counter()
    have: Counter[str] = Counter()
    want: Counter[str] = Counter()
    for wanted, mine in zip(gold, found, strict=True):
        theirs, ours = Counter(wanted), Counter(mine)
        for counter, items in ((want, theirs), (have, ours), (right, theirs & ours)):
            for (label, _), count in items.items():
                counter[label] += count
    labels = sorted({*want, *have})
    return LabelScores(tuple((label, F1(right[label], have[label], want[label])) for label in labels))


def _trained(folder: Path, train: Sequence[Sample], domain: Domain, documents: KnownDocuments) -> Interpreter:
    train_models(folder, [sample.example for sample in train], domain, documents)
    voices = sorted({sample.example.voice for sample in train})
    write_manifest(
        folder,
        domain,
        corpus=corpus_hash({}),
        voices=voices,
        examples=len(train),
        language_model=documents.model_name,
    )
    return Interpreter(domain, folder, documents)


def _measure_tasks(measures: Measures, system: PaperSystem, test: Sequence[Sample]) -> None:
    """Token by token, weighted over the labels but O (section IV-B)."""
    gold = [list(_named(gold_tasks(s.observed.document, s.example.instruction))) for s in test]
    found = [list(_named(system.find_tasks(s.observed))) for s in test]
    measures.values["tasks/crf/f1"] = label_scores(gold, found).weighted
    measures.add_share(
        "tasks all right/crf",
        (sorted(g) == sorted(f) for s, g, f in zip(test, gold, found, strict=True) if s.is_complex),
    )


def _measure_arguments(measures: Measures, system: PaperSystem, test: Sequence[Sample]) -> None:
    """Table III: the same labels for the whole instruction; F1 of BIO labels, weighted; both after the tasks found."""
    for method in METHODS:
        model = system.arguments[method]
        found = [model.find(s.observed, system.find_tasks(s.observed)) for s in test]
        given = [model.find(s.observed, gold_tasks(s.observed.document, s.example.instruction)) for s in test]
        for name, arguments in ((method, found), (f"{method}, gold tasks", given)):
            labels = [_bio(len(s.observed.document), a) for s, a in zip(test, arguments, strict=True)]
            _score_labels(measures, f"arguments/{name}", labels, test)
        gold = [_owned_items(s.example.instruction) for s in test]
        read = [_owned_found(s.observed, a) for s, a in zip(test, found, strict=True)]
        measures.values[f"owners/{method}/f1"] = label_scores(gold, read).overall.value


def _measure_dependencies(measures: Measures, system: PaperSystem, flows: FlowModel, test: Sequence[Sample]) -> None:
    """Table IV: labels of the annotated tasks of complex instructions."""
    gold: list[tuple[str, ...]] = []
    found: dict[str, list[tuple[str, ...]]] = {name: [] for name in (*LABELLERS, "flow model")}
    for sample in test:
        instruction = sample.example.instruction
        gold.append(_labels(instruction.flow, instruction))
        for labeller in LABELLERS:
            found[labeller].append(system.label(sample.observed, instruction, labeller))
        flow = flows.find(sample.observed, marked_tasks(sample.observed, instruction)).flow
        found["flow model"].append(_labels(flow, instruction))
    numbered = [[(label, k) for k, label in enumerate(labels)] for labels in gold]
    for name, sequences in found.items():
        scores = label_scores(numbered, [[(label, k) for k, label in enumerate(labels)] for labels in sequences])
        rows = {label: scores.of(label) for label in DEPENDENCIES}
        for label, score in rows.items():
            _add_row(measures, f"dependencies/{label}/{name}", (score.precision, score.recall, score.value))
        _add_row(measures, f"dependencies/weighted/{name}", weighted(scores))


def _measure_flows(measures: Measures, system: PaperSystem, test: Sequence[Sample]) -> None:
    """Fig. 3: from text to control flow; and how far it goes with annotated tasks, and with annotated labels too."""
    pairs: dict[str, list[tuple[Instruction, Instruction]]] = {}
    for sample in test:
        gold = sample.example.instruction
        read = system.read(sample.observed)
        for name, flow in system.flows(sample.observed, read).items():
            pairs.setdefault(name, []).append((replace(read, flow=flow), gold))
        given = system.flows(sample.observed, gold)[f"crf{MERGED}"]
        pairs.setdefault(f"crf{MERGED}, gold tasks", []).append((replace(gold, flow=given), gold))
        tree = tree_of(_labels(gold.flow, gold), gold)
        pairs.setdefault(f"gold labels{MERGED}", []).append((replace(gold, flow=tree), gold))
    for name, both in pairs.items():
        _score_flows(measures, f"flow/{name}", both)


def _score_flows(measures: Measures, key: str, pairs: Sequence[tuple[Instruction, Instruction]]) -> None:
    measures.add_share(f"{key}/exact", (has_same_flow(found, gold) for found, gold in pairs))
    nodes = sum(forest_size(flow_forest(gold)) for _, gold in pairs)
    measures.values[f"{key}/oer"] = sum(ordering_errors(found, gold) for found, gold in pairs) / max(nodes, 1)


def _score_labels(measures: Measures, key: str, labels: Sequence[Sequence[str]], test: Sequence[Sample]) -> None:
    gold = [plain_gold_labels(s.observed.document, s.example.instruction) for s in test]
    measures.add_share(f"{key}/exact", (list(g) == list(f) for g, f in zip(gold, labels, strict=True)))
    scores = label_scores([_placed(g) for g in gold], [_placed(f) for f in labels])
    measures.values[f"{key}/f1"] = scores.weighted


def _add_row(measures: Measures, key: str, row: tuple[float, float, float]) -> None:
    measures.values |= {f"{key}/{column}": v for column, v in zip(("precision", "recall", "f1"), row, strict=True)}


def _labels(flow: Flow, instruction: Instruction) -> tuple[str, ...]:
    dependencies = flow.dependencies()
    return tuple(dependencies[task.id] for task in instruction.tasks)


def _bio(length: int, arguments: Sequence[FoundArgument]) -> list[str]:
    labels = [OUTSIDE] * length
    for argument in arguments:
        for i in argument.tokens:
            labels[i] = f"{'B' if i == argument.tokens.start else 'I'}-{argument.type}"
    return labels


def _placed(labels: Sequence[str]) -> list[tuple[str, Hashable]]:
    return [(label, i) for i, label in enumerate(labels) if label != OUTSIDE]


def _named(tasks: Mapping[int, str]) -> Iterable[tuple[str, Hashable]]:
    return ((kind, token) for token, kind in tasks.items())


def _typed(instruction: Instruction) -> list[tuple[str, Hashable]]:
    return [(task.type, task.span) for task in instruction.tasks]


def _task_items(instruction: Instruction) -> Items:
    return [(task.type, task.span.start) for task in instruction.tasks]


def _owned_items(instruction: Instruction) -> Items:
    owned = ([(a.type, (task.span.start, a.span)) for a in task.arguments if a.span] for task in instruction.tasks)
    return list(chain.from_iterable(owned))


def _owned_found(observed: Observed, arguments: Sequence[FoundArgument]) -> Items:
    document = observed.document
    return [
        (a.type, (document.tokens[a.owner].start, document.span(a.tokens.start, a.tokens.stop - 1))) for a in arguments
    ]
