"""Task dependency resolution: from the tasks of an instruction to its control flow (DeComplex, section III-D).

`FlowModel` is the default: three small CRFs in a row say role, attachment and order of every task (see `arcs`).
`PaperDependencies` is the paper's CRF over its four labels with the tree building of section III-E.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path

from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.control_flow.arcs import Arc
from decomplex_bt.understanding.control_flow.clause import Clause, MarkedTask
from decomplex_bt.understanding.control_flow.clauses import clauses_of
from decomplex_bt.understanding.control_flow.construction import flow_of
from decomplex_bt.understanding.control_flow.derivation import arcs_of
from decomplex_bt.understanding.control_flow.orders import stated_orders
from decomplex_bt.understanding.control_flow.roles import stated_roles
from decomplex_bt.understanding.control_flow.settlement import settle
from decomplex_bt.understanding.control_flow.sides import stated_sides
from decomplex_bt.understanding.control_flow.structure import (
    Chain,
    attachment_features,
    order_features,
    paper_features,
    role_features,
)
from decomplex_bt.understanding.crf import Crf, CrfParameters, Features, train_crf
from decomplex_bt.understanding.features import Observed

PARAMETERS = CrfParameters(c1=0.1, c2=1.0, max_iterations=150)
MODELS = ("roles", "attachments", "orders")


UNCERTAIN = 0.1
"""A label below this marginal probability gives no other flow."""
MAX_VARIED_PLACES = 2
MAX_FLOWS = 4


@dataclass(frozen=True, slots=True)
class Varied:
    """Labels of a sequence with their joint probability."""

    labels: tuple[str, ...]
    probability: float


@dataclass(frozen=True, slots=True)
class FoundFlow:
    """A control flow with the labels it was built from and the probabilities of roles, attachments and orders; `drawn`:
    as the labels alone draw it."""

    drawn: Flow
    arcs: tuple[Arc, ...] = ()
    clauses: tuple[Clause, ...] = ()
    probabilities: tuple[float, float, float] = (1.0, 1.0, 1.0)

    @property
    def flow(self) -> Flow:
        """The flow as it is meant: `drawn`, settled."""
        return settle(self.drawn, self.clauses)


class FlowModel:
    """The trained models of role, attachment and order, from `roles.crf`, `attachments.crf` and `orders.crf`."""

    def __init__(self, folder: Path) -> None:
        self.roles, self.attachments, self.orders = (Crf(folder / f"{name}.crf") for name in MODELS)

    def find(self, observed: Observed, tasks: Sequence[MarkedTask]) -> FoundFlow:
        """The likeliest control flow of tasks in text order."""
        return self.alternatives(observed, tasks)[0]

    def alternatives(self, observed: Observed, tasks: Sequence[MarkedTask]) -> tuple[FoundFlow, ...]:
        """Different control flows of tasks in text order, likeliest first, at most `MAX_FLOWS`."""
        if not tasks:
            return (FoundFlow(Flow()),)
        clauses = clauses_of(observed, tasks)
        chain = Chain(observed, clauses)
        found: list[FoundFlow] = []
        for roles in varied(self.roles, role_features(chain)):
            chained = stated_roles(clauses, roles.labels)
            for attachments in varied(self.attachments, attachment_features(chain, chained)):
                places = stated_sides(clauses, chained, attachments.labels)
                orders = self.orders.label(order_features(chain, chained, places))
                told = stated_orders(clauses, chained, places, orders.labels)
                arcs = tuple(Arc(*labels) for labels in zip(chained, places, told, strict=True))
                chances = (roles.probability, attachments.probability, orders.probability)
                found.append(FoundFlow(flow_of(arcs, chain.wordings), arcs, clauses, chances))
        return likeliest(found)


def varied(crf: Crf, items: Sequence[Features]) -> list[Varied]:
    """The likeliest labels of a sequence, then those that differ from them in one uncertain place."""
    best = crf.label(items)
    ways = [Varied(best.labels, best.probability)]
    uncertain = crf.uncertain(best, UNCERTAIN)
    for place in sorted(uncertain, key=lambda i: (best.marginals[i], i))[:MAX_VARIED_PLACES]:
        others = [(chance, label) for label, chance in uncertain[place] if label != best.labels[place]]
        labels = (*best.labels[:place], max(others)[1], *best.labels[place + 1 :])
        ways.append(Varied(labels, crf.probability(labels)))
    return ways


def likeliest(found: Sequence[FoundFlow]) -> tuple[FoundFlow, ...]:
    """Of flows drawn in several ways the likeliest way to each, best first, at most `MAX_FLOWS`."""
    best: dict[Flow, FoundFlow] = {}
    for flow in sorted(found, key=lambda flow: -prod(flow.probabilities)):
        best.setdefault(flow.drawn, flow)
    return tuple(best.values())[:MAX_FLOWS]


def train_flow(folder: Path, data: Sequence[tuple[Observed, Instruction]]) -> int:
    """Trains the three models on annotated documents, given their gold tasks and arguments, and writes them to
    `folder`.

    Gives the number of instructions left out because no labels can say their flow.
    """
    sequences: dict[str, list[list[dict[str, object]]]] = {name: [] for name in MODELS}
    labels: dict[str, list[list[str]]] = {name: [] for name in MODELS}
    left_out = 0
    for observed, instruction in data:
        if not instruction.tasks:
            continue
        clauses = clauses_of(observed, marked_tasks(observed, instruction))
        chain = Chain(observed, clauses)
        arcs = arcs_of(instruction.flow, chain.wordings)
        if arcs is None:
            left_out += 1
            continue
        roles = [arc.role for arc in arcs]
        attachments = [arc.attachment for arc in arcs]
        sequences["roles"].append(role_features(chain))
        sequences["attachments"].append(attachment_features(chain, roles))
        sequences["orders"].append(order_features(chain, roles, attachments))
        for name, values in zip(MODELS, (roles, attachments, [arc.order for arc in arcs]), strict=True):
            labels[name].append(values)
    for name in MODELS:
        train_crf(folder / f"{name}.crf", sequences[name], labels[name], PARAMETERS)
    return left_out


def marked_tasks(observed: Observed, instruction: Instruction) -> tuple[MarkedTask, ...]:
    """The tasks of an annotated instruction as the flow model sees them."""
    document = observed.document
    return tuple(
        MarkedTask(
            document.indices(task.span).start,
            task.type,
            tuple((a.type, document.indices(a.span)) for a in task.arguments if a.span is not None),
        )
        for task in instruction.tasks
    )


class PaperDependencies:
    """The paper's dependency CRF, with or without the task_type feature, and its tree with or without merging."""

    def __init__(self, path: Path, *, with_task_type: bool = True, with_merging: bool = True) -> None:
        self._crf = Crf(path)
        self.with_task_type = with_task_type
        self.with_merging = with_merging

    def label(self, observed: Observed, clauses: Sequence[Clause]) -> tuple[str, ...]:
        """One of the four labels of Table I for every task."""
        items = paper_features(observed, clauses, with_task_type=self.with_task_type)
        return self._crf.label(items).labels

    def find(self, observed: Observed, instruction: Instruction) -> Flow:
        """The control flow of an instruction's tasks (its own flow is not read)."""
        clauses = clauses_of(observed, marked_tasks(observed, instruction))
        return tree_of(self.label(observed, clauses), instruction, with_merging=self.with_merging)


def train_paper_dependencies(
    path: Path, data: Sequence[tuple[Observed, Instruction]], *, with_task_type: bool = True
) -> None:
    """Trains the paper's dependency CRF on annotated instructions and writes it to `path`."""
    items, labels = [], []
    for observed, instruction in data:
        if not instruction.tasks:
            continue
        clauses = clauses_of(observed, marked_tasks(observed, instruction))
        dependencies = instruction.flow.dependencies()
        items.append(paper_features(observed, clauses, with_task_type=with_task_type))
        labels.append([dependencies[task.id] for task in instruction.tasks])
    train_crf(path, items, labels, PARAMETERS)


@dataclass(slots=True)
class _OpenCondition:
    numbers: list[int]
    then: list[Node]
    orelse: list[Node]


def tree_of(labels: Sequence[str], instruction: Instruction, *, with_merging: bool = True) -> Flow:
    """The paper's control flow tree (section III-E): dependents go to the branch of the condition before them, of the
    next one where none precedes; conditions of one type without dissimilar argument values are merged."""
    conditions: list[_OpenCondition] = []
    top: list[_OpenCondition | int] = []
    waiting: list[tuple[int, str]] = []
    for task, label in zip(instruction.tasks, labels, strict=True):
        if label == "conditional":
            same = next((c for c in conditions if with_merging and _is_same(c, task.id, instruction)), None)
            if same is not None:
                same.numbers.append(task.id)
                condition = same
            else:
                condition = _OpenCondition([task.id], [], [])
                conditions.append(condition)
                top.append(condition)
            for number, waiting_label in waiting:
                _attach(condition, number, waiting_label)
            waiting = []
        elif label == "sequential":
            top.append(task.id)
        elif conditions and not waiting:
            _attach(conditions[-1], task.id, label)
        else:
            waiting.append((task.id, label))
    top.extend(number for number, _ in waiting)
    return Flow(tuple(_close(node) for node in top))


def _attach(condition: _OpenCondition, number: int, label: str) -> None:
    branch = condition.then if label == "dependent_positive" else condition.orelse
    branch.append(Do((number,)))


def _is_same(condition: _OpenCondition, number: int, instruction: Instruction) -> bool:
    """Of one type, and no argument type that both have with different values (section III-E)."""
    first, second = instruction.task(condition.numbers[0]), instruction.task(number)
    if first.type != second.type:
        return False
    return all(
        {value.lower() for value in first.values(kind)} == {value.lower() for value in second.values(kind)}
        for kind in {a.type for a in first.arguments} & {a.type for a in second.arguments}
    )


def _close(node: _OpenCondition | int) -> Node:
    if isinstance(node, int):
        return Do((node,))
    numbers = tuple(sorted(node.numbers))
    return If(numbers, tuple(node.then), tuple(node.orelse)) if node.then or node.orelse else Do(numbers)
