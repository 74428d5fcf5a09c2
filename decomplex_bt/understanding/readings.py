"""Readings: several ways to read an instruction, ranked by how well tasks, arguments and flow go together.

The model of tasks is unsure of a token in most instructions, and one wrong task breaks the flow. So its likeliest task
sets are each read to the end, and a small linear model chooses: it knows what no single stage does, for example that an
"if" without a condition in its clause, or a condition without anything that makes it one, is probably a misreading.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.flow import Flow, If
from decomplex_bt.understanding.arguments import ArgumentModel, FoundArgument, FoundArguments
from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.dependencies import FlowModel, FoundFlow, MarkedTask
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.options import Option
from decomplex_bt.understanding.references.phrases import is_pronoun
from decomplex_bt.understanding.rules.amendments import amended
from decomplex_bt.understanding.rules.facts import corrected
from decomplex_bt.understanding.rules.orders.prohibitions import forbidden, put_off
from decomplex_bt.understanding.rules.orders.uses import uses
from decomplex_bt.understanding.rules.speech.withdrawals import Withdrawals, withdrawals_of
from decomplex_bt.understanding.tasks import FoundTask, FoundTasks, TaskModel

FEATURES = (
    "tasks", "arguments", "roles", "attachments", "orders", "task_count", "uncovered_cue", "shared_cue",
    "uncued_condition", "cued_task", "missing_argument", "idle_sentence", "idle_verb", "stranded_else",
    "bare_task", "checks", "idle_condition", "nested", "late_branch", "other_object", "other_state",
)  # fmt: skip
"""What a reading is judged by: the log probabilities of the stages, then counts; see `_features`."""


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read an instruction; `drawn` and `flow` are those of its `FoundFlow`. `features` in the order of
    `FEATURES`."""

    tasks: tuple[FoundTask, ...]
    arguments: tuple[FoundArgument, ...]
    flow: Flow
    drawn: Flow
    features: tuple[float, ...]


class TaskStage(Protocol):
    """What finds the tasks."""

    def alternatives(self, observed: Observed) -> tuple[FoundTasks, ...]:
        """The likeliest task sets, best first."""


class ArgumentStage(Protocol):
    """What finds the arguments of tasks."""

    def find_all(self, observed: Observed, tasks: Mapping[int, str]) -> FoundArguments:
        """The arguments; `tasks` maps token indices to task types."""


class FlowStage(Protocol):
    """What finds the control flow of tasks."""

    def alternatives(self, observed: Observed, tasks: Sequence[MarkedTask]) -> tuple[FoundFlow, ...]:
        """The likeliest flows, best first."""


class ReferenceStage(Protocol):
    """What knows more of references than their forms and places."""

    def scores(self, observed: Observed, tasks: Mapping[int, str], gap: Gap, options: Sequence[Option]) -> list[float]:
        """What to add to the score of each option of a gap; `tasks` maps token indices to task types."""


@dataclass(frozen=True, slots=True)
class Stages:
    """The trained models that a reading goes through."""

    tasks: TaskStage
    arguments: ArgumentStage
    flows: FlowStage
    references: ReferenceStage | None = None


def load_stages(folder: Path) -> Stages:
    """The stages from a folder of trained models."""
    return Stages(TaskModel(folder / "tasks.crf"), ArgumentModel(folder / "arguments.crf"), FlowModel(folder))


class ReadingModel:
    """The trained weights; reads them from a JSON file. Raises `DataFileError` where they do not fit `FEATURES`."""

    def __init__(self, path: Path) -> None:
        try:
            stored = json.loads(path.read_text(encoding="utf-8"))
            self._weights = tuple(float(stored[name]) for name in FEATURES)
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise ModelError(path, f"no weights of readings ({type(error).__name__})") from None

    def ranked(self, readings: Sequence[Reading]) -> list[tuple[Reading, float]]:
        """The readings (at least one) with their probabilities, likeliest first."""
        scores = [sum(w * f for w, f in zip(self._weights, r.features, strict=True)) for r in readings]
        highest = max(scores)
        total = sum(math.exp(score - highest) for score in scores)
        order = sorted(range(len(readings)), key=lambda i: -scores[i])
        return [(readings[i], math.exp(scores[i] - highest) / total) for i in order]


def readings_of(observed: Observed, stages: Stages, ontology: Ontology) -> tuple[Reading, ...]:
    """All readings of a document, that of the likeliest tasks first, of each set of tasks the likeliest flow first."""
    withdrawals = withdrawals_of(observed)
    gone = withdrawals.tokens.union(forbidden(observed), (use.verb for use in uses(observed.document)))
    alternatives = stages.tasks.alternatives(observed)
    ordered = put_off(observed.document)
    whole = [found for found in alternatives if ordered <= {task.token for task in found.tasks}]
    return tuple(
        reading
        for found in _settled(observed, whole or alternatives, gone, ontology)
        for reading in _read(observed, found, withdrawals, stages, ontology)
    )


def _settled(
    observed: Observed, alternatives: Sequence[FoundTasks], gone: frozenset[int], ontology: Ontology
) -> Iterator[FoundTasks]:
    """The task sets with what is settled by facts and without the tokens that are `gone`: taken back, forbidden, or no
    orders; each set once, the likelier one."""
    seen: set[tuple[tuple[int, str], ...]] = set()
    for found in alternatives:
        kept = tuple(task for task in found.tasks if task.token not in gone)
        # Idioms are no exception: "don't have a look".
        tasks = tuple(t for t in corrected(observed, kept, ontology.task_types) if t.token not in gone)
        key = tuple((task.token, task.type) for task in tasks)
        if key not in seen:
            seen.add(key)
            yield FoundTasks(tasks, found.probability)


def train_readings(path: Path, choices: Sequence[tuple[Sequence[Reading], int]]) -> None:
    """Fits the weights by conditional logit and writes them to `path`.

    `choices`: the readings of an instruction and the index of the right one. They must come from stages that were not
    trained on the instruction, or the weights would trust the stages too much.
    """
    import numpy as np
    from scipy.optimize import minimize

    tables = [(np.array([r.features for r in readings]), right) for readings, right in choices if len(readings) > 1]

    def loss(weights: np.ndarray) -> tuple[float, np.ndarray]:
        total, gradient = PENALTY * float(weights @ weights), 2 * PENALTY * weights
        for table, right in tables:
            scores = table @ weights
            scores -= scores.max()
            chances = np.exp(scores) / np.exp(scores).sum()
            total -= float(np.log(chances[right]))
            gradient = gradient + chances @ table - table[right]
        return total, gradient

    start = np.array([1.0] + [0.0] * (len(FEATURES) - 1))
    fitted = minimize(loss, start, jac=True, method="L-BFGS-B").x if tables else start
    path.write_text(
        json.dumps({name: round(float(w), 6) for name, w in zip(FEATURES, fitted, strict=True)}, indent=1) + "\n",
        encoding="utf-8",
    )


PENALTY = 0.5
"""Weight of the squared norm in the loss of `train_readings`."""


def _read(
    observed: Observed, found: FoundTasks, withdrawals: Withdrawals, stages: Stages, ontology: Ontology
) -> Iterator[Reading]:
    types = {task.token: task.type for task in found.tasks}
    arguments = amended(observed, types, withdrawals, stages.arguments.find_all(observed, types))
    marked = [
        MarkedTask(t.token, t.type, tuple((a.type, a.tokens) for a in arguments.arguments if a.owner == t.token))
        for t in found.tasks
    ]
    counts = _Counts.of(observed, marked, ontology)
    for flow in stages.flows.alternatives(observed, marked):
        logs = [math.log(max(p, 1e-12)) for p in (found.probability, arguments.probability, *flow.probabilities)]
        features = (*logs, *_features(observed, marked, flow, counts))
        yield Reading(found.tasks, arguments.arguments, flow.flow, flow.drawn, features)


@dataclass(frozen=True, slots=True)
class _Counts:
    """What the tasks of a reading tell of it whatever its flow; all but the sets are among `FEATURES`.

    `cued`: the tokens of tasks that a cue makes conditions, `checks`: those of checks.
    """

    cued: frozenset[int]
    checks: frozenset[int]
    uncovered: int
    shared: int
    lacking: int
    idle: int
    idle_verbs: int
    bare: int

    @classmethod
    def of(cls, observed: Observed, tasks: Sequence[MarkedTask], ontology: Ontology) -> _Counts:
        document = observed.document
        places = {task.token for task in tasks}
        uncovered = shared = 0
        cued: set[int] = set()
        for cue in observed.cues:
            if cue.name not in _OPENING:
                continue
            inside = [i for i in _clause_after(observed, cue.last) if i in places]
            uncovered += not inside
            shared += len(inside) > 1
            cued.update(inside[:1])
        in_arguments = {i for task in tasks for _, tokens in task.arguments for i in tokens}
        kinds = [{kind for kind, _ in task.arguments} for task in tasks]
        required = [ontology.task_types[task.type].required for task in tasks]
        return cls(
            cued=frozenset(cued),
            checks=frozenset(t.token for t in tasks if t.type == "check_state"),
            uncovered=uncovered,
            shared=shared,
            lacking=sum(len(r) > 0 and not said & set(r[0]) for said, r in zip(kinds, required, strict=True)),
            idle=len(set(document.sentences) - {document.sentences[i] for i in places}),
            idle_verbs=sum(
                token.tag in ("VB", "VBP")
                and token.dep in ("ROOT", "conj", "ccomp", "advcl")
                and bool(observed.senses[token.i])
                and token.i not in places
                and token.i not in in_arguments
                for token in document.tokens
            ),
            bare=sum(not said & _WHAT_AND_WHERE for said in kinds),
        )


def _features(observed: Observed, tasks: Sequence[MarkedTask], flow: FoundFlow, counts: _Counts) -> tuple[float, ...]:
    """The counts among `FEATURES`, in their order."""
    conditions = {t.token for t, arc in zip(tasks, flow.arcs, strict=True) if arc.role in CONDITION_ROLES}
    uncued = sum(i not in counts.cued and not observed.question[i] and i in counts.checks for i in conditions)
    opposite = any(arc.attachment.endswith("-") for arc in flow.arcs) or any("fail" in c.far for c in flow.clauses)
    stranded = any(cue.name in ("else", "fail") for cue in observed.cues) and not opposite and not conditions
    branching = [(node, place) for node, place in flow.drawn.walk() if isinstance(node, If)]
    return (
        float(len(tasks)),
        float(counts.uncovered),
        float(counts.shared),
        float(uncued),
        float(len(counts.cued - conditions)),
        float(counts.lacking),
        float(counts.idle),
        float(counts.idle_verbs),
        float(stranded),
        float(counts.bare),
        float(len(counts.checks)),
        float(len(conditions) - sum(len(node.tasks) for node, _ in branching)),
        float(sum(place != "top" for _, place in branching)),
        float(sum(arc.attachment[:2] in ("<2", "<3", ">2") for arc in flow.arcs)),
        float(sum(_differ(observed, tasks, node.tasks, "object") for node, _ in branching)),
        float(sum(_differ(observed, tasks, node.tasks, "state") for node, _ in branching)),
    )


def _differ(observed: Observed, tasks: Sequence[MarkedTask], mentions: Sequence[int], kind: str) -> bool:
    """Whether mentions of one condition name different things, or states that are no opposites."""
    document, named = observed.document, set()
    for number in mentions:
        for argument, tokens in tasks[number - 1].arguments:
            if argument == kind and not is_pronoun(document, tokens):
                word = document.tokens[tokens.stop - 1]
                named.add(observed.gazetteer.pairs.get(word.lower, word.lemma) if kind == "state" else word.lemma)
    return len(named) > 1


_OPENING = frozenset(("if", "only_if", "unless"))
_WHAT_AND_WHERE = frozenset(("object", "goal", "location", "message", "recipient", "source", "direction"))
_END = frozenset((".", "?", "!", ";", ",", ":"))


def _clause_after(observed: Observed, cue: int) -> range:
    """The tokens after a cue up to the next punctuation mark, or to the next cue that opens a clause."""
    opening = {c.first for c in observed.cues if c.name in _OPENING}
    i = cue + 1
    while i < len(observed.document) and observed.document.tokens[i].text not in _END and i not in opening:
        i += 1
    return range(cue + 1, i)
