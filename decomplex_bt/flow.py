"""The control flow of an instruction: a frozen tree over task numbers that reads, compares and prints itself.

The JSON form (corpus files, `parse`): a list is a sequence; an entry is a task's number, `{"same": [N, M]}` or
`{"if": N | [N, M, ...], "then": [...], "else": [...]}`. DeComplex, section III-E, calls the same thing the control
flow graph; nesting, order and repeated tasks go beyond the paper.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from decomplex_bt.errors import InputError

DEPENDENCIES = ("conditional", "dependent_positive", "dependent_negative", "sequential")
"""The paper's four dependency labels (DeComplex, Table I)."""


@dataclass(frozen=True, slots=True)
class Do:
    """A task to be done.

    Several numbers are mentions of one and the same task, of which the first is executed. With `is_repeat` the single
    number names a task that stands in another branch too, where only one of the two can run.
    """

    __pydantic_config__ = {"extra": "forbid"}  # read from a mapping, it is told from an `If` by its keys
    tasks: tuple[int, ...]
    is_repeat: bool = False

    @property
    def task(self) -> int:
        """The number that is executed."""
        return self.tasks[0]

    def to_json(self) -> Any:
        return self.task if len(self.tasks) == 1 and not self.is_repeat else {"same": list(self.tasks)}


@dataclass(frozen=True, slots=True)
class If:
    """A condition with what follows when it holds (`then`) and when it fails (`orelse`).

    `tasks` are mentions of one condition in text order; the first is executed, and `then` follows when the first,
    without its negation, holds. At least one branch is not empty.
    """

    __pydantic_config__ = {"extra": "forbid"}
    tasks: tuple[int, ...]
    then: tuple[Node, ...] = ()
    orelse: tuple[Node, ...] = ()

    @property
    def task(self) -> int:
        """The number that is executed."""
        return self.tasks[0]

    def to_json(self) -> Any:
        value: dict[str, Any] = {"if": self.task if len(self.tasks) == 1 else list(self.tasks)}
        if self.then:
            value["then"] = [node.to_json() for node in self.then]
        if self.orelse:
            value["else"] = [node.to_json() for node in self.orelse]
        return value


Node = Do | If
FlowPath = tuple[tuple[int, str], ...]
"""The conditions above a node, outermost first: of each the number and the side, "then" or "else"."""


@dataclass(frozen=True, slots=True)
class Flow:
    """A sequence of nodes; equal flows mean the same control flow (`from_json` brings any spelling to normal form)."""

    nodes: tuple[Node, ...] = ()

    @classmethod
    def from_json(cls, value: Any, *, task_count: int | None = None) -> Flow:
        """Reads the JSON form.

        With `task_count`, every number from 1 to it must occur exactly once, besides repeats (`{"same": [N]}`).
        Raises `InputError` where the form or the numbers are wrong, naming the entry.
        """
        try:
            flow = cls(_read_sequence(value))
            flow._check_numbers(task_count)
            return cls(in_reading_order(flow.nodes))
        except RecursionError:
            raise InputError("flow: lists and branches lie in each other too deep to be read") from None

    def to_json(self) -> list[Any]:
        """The JSON form in normal form: one number under "if" is a number, empty branches are left out."""
        return [node.to_json() for node in self.nodes]

    def walk(self) -> Iterator[tuple[Node, str]]:
        """Every node with its place, depth first, `then` before `else`: place is "top", "then" or "else"."""
        for node, path in self.paths():
            yield node, path[-1][1] if path else "top"

    def paths(self) -> Iterator[tuple[Node, FlowPath]]:
        """Every node, depth first, `then` before `else`, with the conditions under which it stands."""
        yield from _paths(self.nodes, ())

    def numbers(self) -> tuple[int, ...]:
        """All task numbers in the order of the tree, repeats left out."""
        return tuple(
            number for node, _ in self.walk() if not (isinstance(node, Do) and node.is_repeat) for number in node.tasks
        )

    def mentions(self) -> frozenset[int]:
        """The numbers that are not executed themselves, for they speak of another task again ("if that fails")."""
        executed = {node.task for node, _ in self.walk()}
        return frozenset(number for node, _ in self.walk() for number in node.tasks if number not in executed)

    def neighbours(self) -> Iterator[tuple[int, int]]:
        """The numbers of every two tasks of which the second is carried out right after the first; behind a condition
        what follows where it holds."""
        yield from _neighbours(self.nodes)

    def dependencies(self) -> dict[int, str]:
        """The paper's label of every task (DeComplex, Table I), derived from where it stands."""
        of_place = {"top": "sequential", "then": "dependent_positive", "else": "dependent_negative"}
        labels: dict[int, str] = {}
        for node, place in self.walk():
            label = "conditional" if isinstance(node, If) else of_place[place]
            for number in node.tasks:
                labels.setdefault(number, label)
        return labels

    def renumbered(self, numbers: Mapping[int, int]) -> Flow:
        """The same flow with `numbers` giving the new number of each task."""
        return Flow(in_reading_order(_renumbered(self.nodes, numbers)))

    def describe(self, names: Mapping[int, str]) -> str:
        """The tree as indented lines, with `names` giving a phrase for each task number."""
        return "\n".join(_describe(self.nodes, names, 0))

    def __str__(self) -> str:
        return self.describe({number: f"task {number}" for number in self.numbers()})

    def _check_numbers(self, task_count: int | None) -> None:
        placed: dict[int, FlowPath] = {}
        repeats: list[tuple[int, FlowPath]] = []
        for node, path in self.paths():
            if isinstance(node, Do) and node.is_repeat:
                repeats.append((node.task, path))
                continue
            for number in node.tasks:
                if number in placed:
                    raise InputError(
                        f"flow: task {number} occurs twice; a task occurs once (write {{same: [{number}]}} to repeat "
                        "it in another branch)"
                    )
                placed[number] = path
        for number, path in repeats:
            if number not in placed:
                raise InputError(f"flow: {{same: [{number}]}} repeats a task that stands nowhere before it")
            if not _exclusive(placed[number], path):
                raise InputError(
                    f"flow: {{same: [{number}]}} would run task {number} twice; a repeat must stand in another branch"
                )
        if task_count is not None:
            _check_complete(set(placed), task_count)


def _neighbours(nodes: Sequence[Node]) -> Iterator[tuple[int, int]]:
    for i, node in enumerate(nodes):
        following = node.then if isinstance(node, If) else nodes[i + 1 :]
        if following:
            yield node.task, following[0].task
        if isinstance(node, If):
            yield from _neighbours(node.then)
            yield from _neighbours(node.orelse)


def in_reading_order(nodes: Sequence[Node]) -> tuple[Node, ...]:
    """The nodes with every task whole where it is read first, `then` before `else`, and as a repeat where it is read
    again; a condition is not repeated."""
    wholes: dict[int, Do] = {}
    for node, _ in _paths(nodes, ()):
        if isinstance(node, Do) and not node.is_repeat:
            wholes.setdefault(node.task, node)
    return _ordered(nodes, wholes, set())


def _ordered(nodes: Sequence[Node], wholes: Mapping[int, Do], seen: set[int]) -> tuple[Node, ...]:
    found: list[Node] = []
    for node in nodes:
        if isinstance(node, Do):
            found.append(Do((node.task,), is_repeat=True) if node.task in seen else wholes[node.task])
            seen.add(node.task)
        elif node.task not in seen:
            seen.add(node.task)
            then, orelse = _ordered(node.then, wholes, seen), _ordered(node.orelse, wholes, seen)
            found.append(If(node.tasks, then, orelse) if then or orelse else Do(node.tasks))
    return tuple(found)


def _renumbered(nodes: Sequence[Node], numbers: Mapping[int, int]) -> tuple[Node, ...]:
    def of(node: Node) -> Node:
        tasks = tuple(sorted(numbers[number] for number in node.tasks))
        if isinstance(node, Do):
            return Do(tasks, node.is_repeat)
        return If(tasks, _renumbered(node.then, numbers), _renumbered(node.orelse, numbers))

    return tuple(map(of, nodes))


def _check_complete(placed: set[int], task_count: int) -> None:
    expected = set(range(1, task_count + 1))
    if placed - expected:
        raise InputError(f"flow: there is no task {min(placed - expected)}; the text marks tasks 1 to {task_count}")
    if expected - placed:
        raise InputError(f"flow: task {min(expected - placed)} is marked in the text but does not occur in the flow")


def _read_sequence(value: Any) -> tuple[Node, ...]:
    if not isinstance(value, Sequence) or isinstance(value, str):
        raise InputError(f"flow: expected a list of entries, got {value!r}")
    return tuple(_read_node(entry) for entry in value)


def _read_node(entry: Any) -> Node:
    if isinstance(entry, int) and not isinstance(entry, bool):
        return Do((_read_number(entry),))
    if not isinstance(entry, Mapping):
        raise InputError(
            f"flow: an entry is a task number, {{same: [...]}} or {{if: ..., then: ..., else: ...}}, got {entry!r}"
        )
    keys = set(entry)
    if keys == {"same"}:
        numbers = _read_numbers(entry["same"])
        return Do(numbers, is_repeat=len(numbers) == 1)
    if "if" not in keys or keys - {"if", "then", "else"}:
        raise InputError(f"flow: expected the keys if, then, else (or same alone), got {sorted(map(str, keys))}")
    tasks = _read_numbers(entry["if"])
    then = _read_sequence(entry.get("then") or [])
    orelse = _read_sequence(entry.get("else") or [])
    if not then and not orelse:
        raise InputError(f"flow: the condition {list(tasks)} has neither then nor else; write the plain number instead")
    return If(tasks, then, orelse)


def _read_number(value: Any) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or value < 1:
        raise InputError(f"flow: expected a task number (1, 2, ...), got {value!r}")
    return value


def _read_numbers(value: Any) -> tuple[int, ...]:
    numbers = tuple(_read_number(v) for v in (value if isinstance(value, Sequence) else [value]))
    if not numbers or list(numbers) != sorted(set(numbers)):
        raise InputError(f"flow: expected task numbers in text order, each once, got {value!r}")
    return numbers


def _paths(nodes: Sequence[Node], path: FlowPath) -> Iterator[tuple[Node, FlowPath]]:
    for node in nodes:
        yield node, path
        if isinstance(node, If):
            yield from _paths(node.then, (*path, (node.task, "then")))
            yield from _paths(node.orelse, (*path, (node.task, "else")))


def _exclusive(first: FlowPath, second: FlowPath) -> bool:
    sides = dict(first)
    return any(task in sides and sides[task] != side for task, side in second)


def _describe(nodes: Sequence[Node], names: Mapping[int, str], depth: int) -> Iterator[str]:
    pad = "  " * depth
    for node in nodes:
        label = " = ".join(f"[{number}] {names.get(number, '?')}" for number in node.tasks)
        if isinstance(node, Do):
            yield f"{pad}{label}"
            continue
        yield f"{pad}if {label}"
        if node.then:
            yield f"{pad}then"
            yield from _describe(node.then, names, depth + 1)
        if node.orelse:
            yield f"{pad}else"
            yield from _describe(node.orelse, names, depth + 1)
