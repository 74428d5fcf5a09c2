"""A tree in other forms: text, dot, Mermaid, JSON, BehaviorTree.CPP 4 XML; a recorder of what changes while it runs."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator
from typing import Any

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence as InOrder
from py_trees.visitors import VisitorBase

from decomplex_bt.behaviour.compiler import CompiledTree
from decomplex_bt.behaviour.conditional import IfThenElse
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import escaped
from decomplex_bt.planning.ground_task import GroundTask

ASCII = {
    Status.SUCCESS: "[x]", Status.FAILURE: "[!]", Status.RUNNING: "[*]", Status.INVALID: "[ ]",
    "sequence": "->", "condition": "?", "leaf": "-", "other": "+",
}  # fmt: skip
UNICODE = {
    Status.SUCCESS: "✓", Status.FAILURE: "✗", Status.RUNNING: "●", Status.INVALID: "○",
    "sequence": "→", "condition": "?", "leaf": "·", "other": "+",
}  # fmt: skip
_CHOICE = "names in the house: candidates between |, several phrases between ;, 'all of' or '2 of' before them"
PORTS = {
    "task": "number of the task in the instruction",
    "type": "type of the task",
    "condition": "true where the task is judged, and fails where it is false; false where it is to be done",
    "object": f"what it is about; {_CHOICE}",
    "location": f"where that is looked for or taken from; {_CHOICE}",
    "goal": f"where it ends; {_CHOICE}",
    "recipient": f"who gets or hears it; {_CHOICE}",
    "state": "the value wanted or checked; here and not here: whether it is there",
    "message": "what is said",
}
"""Of the action `PlannedTask`, with their meanings; a task has those of its arguments that it has."""
_MERMAID = {"sequence": ("[", "]"), "condition": ("{", "}"), "leaf": ("([", "])"), "other": ("{{", "}}")}
_COLOURS = {Status.SUCCESS: "#c8e6c9", Status.FAILURE: "#ffcdd2", Status.RUNNING: "#bbdefb", Status.INVALID: "#ffffff"}


def to_text(root: Behaviour, *, is_ascii: bool = False, show_status: bool = False) -> str:
    """The tree as indented lines, one for each node; with `show_status` also how it stands, and its feedback."""
    return "\n".join(_lines(root, "", 0, ASCII if is_ascii else UNICODE, show_status))


def to_dot(root: Behaviour) -> str:
    """The tree in Graphviz' dot language, coloured by status; `dot -Tsvg` draws it."""
    lines = ["digraph tree {", '  node [fontname="sans-serif", style=filled];', "  ordering=out;"]
    numbers = {id(node): number for number, (node, _) in enumerate(_walk(root))}
    for node, _ in _walk(root):
        shape = {"sequence": "box", "condition": "diamond", "leaf": "ellipse", "other": "hexagon"}[_family(node)]
        label = _label(node).replace("\\", "\\\\").replace('"', '\\"')
        lines.append(f'  n{numbers[id(node)]} [label="{label}", shape={shape}, fillcolor="{_COLOURS[node.status]}"];')
    for node, _ in _walk(root):
        for child, role in _children(node):
            label = f' [label="{role}"]' if role else ""
            lines.append(f"  n{numbers[id(node)]} -> n{numbers[id(child)]}{label};")
    return "\n".join([*lines, "}"]) + "\n"


def to_mermaid(root: Behaviour) -> str:
    """The tree as a Mermaid flowchart, coloured by status; many viewers of Markdown draw it."""
    lines = ["flowchart TD"]
    numbers = {id(node): number for number, (node, _) in enumerate(_walk(root))}
    for node, _ in _walk(root):
        left, right = _MERMAID[_family(node)]
        label = _label(node).replace("#", "#35;").replace('"', "#quot;")
        lines.append(f'  n{numbers[id(node)]}{left}"{label}"{right}')
    for node, _ in _walk(root):
        for child, role in _children(node):
            lines.append(f"  n{numbers[id(node)]} -->{f'|{role}|' if role else ''} n{numbers[id(child)]}")
    lines += [f"  style n{number} fill:{_COLOURS[node.status]}" for number, (node, _) in enumerate(_walk(root))]
    return "\n".join(lines) + "\n"


def to_json(root: Behaviour) -> dict[str, Any]:
    """A snapshot: for each node its type, name, role under an if-then-else, status, feedback and children; for a leaf
    its task with the arguments, and whether it stands as a condition."""
    return _snapshot(root, "")


def to_behaviortree_cpp(root: Behaviour) -> str:
    """The tree as XML that BehaviorTree.CPP 4 loads, once somebody registers the action `PlannedTask`.

    BehaviorTree.CPP's IfThenElse fails where the condition fails and the third child is missing; ours succeeds. So a
    missing branch is written out as AlwaysSuccess. What has no counterpart there: a condition that cannot be decided,
    which fails the whole here and runs the third child there. Raises `InputError` for a tree with nodes of other kinds
    than an instruction is compiled to: IfThenElse, sequences with memory (BehaviorTree.CPP's `Sequence`, which goes on
    with the child that is running) and leaves with a task.
    """
    document = ElementTree.Element("root", BTCPP_format="4", main_tree_to_execute="Instruction")
    tree = ElementTree.SubElement(document, "BehaviorTree", ID="Instruction")
    _append_xml(tree, root)
    models = ElementTree.SubElement(document, "TreeNodesModel")
    model = ElementTree.SubElement(models, "Action", ID="PlannedTask")
    for port, meaning in PORTS.items():
        ElementTree.SubElement(model, "input_port", name=port).text = meaning
    ElementTree.indent(document)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(document, encoding="unicode") + "\n"


class TraceRecorder(VisitorBase):
    """Takes down every change of a node's status or feedback, as `run --json` prints it.

    Add it to a tree's visitors. `clock` gives the simulated seconds, `tick` the number of the tick. Entries have the
    keys tick, sim_seconds, node (its place in the flow, as "0/then/1", "" of the whole; None of what was put into the
    tree besides), name, status, feedback and event ("started", "finished", "interrupted" or "changed"). Interrupted is
    what was RUNNING and was stopped, by a node of higher priority or from outside; that one which has finished is made
    ready to run again is no change.
    """

    def __init__(self, compiled: CompiledTree, clock: Callable[[], float], tick: Callable[[], int]) -> None:
        super().__init__(full=False)
        self.entries: list[dict[str, Any]] = []
        self._paths = {node: "/".join(map(str, path)) for path, node in compiled.nodes.items()}
        self._clock, self._tick = clock, tick
        self._last: dict[Behaviour, tuple[Status, str]] = {}

    def initialise(self) -> None:
        """Takes down what was stopped since the last tick."""
        self._note_interrupted()

    def finalise(self) -> None:
        """Takes down what this tick has stopped: nobody visits it, and it may be no part of the tree any more."""
        self._note_interrupted()

    def _note_interrupted(self) -> None:
        for behaviour, (status, _) in self._last.items():
            if status is Status.RUNNING and behaviour.status is Status.INVALID:
                self.run(behaviour)

    def run(self, behaviour: Behaviour) -> None:
        now = behaviour.status, behaviour.feedback_message
        before = self._last.get(behaviour, (Status.INVALID, ""))
        if now == before:
            return
        self._last[behaviour] = now
        self.entries.append(
            {
                "tick": self._tick(),
                "sim_seconds": round(self._clock(), 3),
                "node": self._paths.get(behaviour),
                "name": behaviour.name,
                "status": behaviour.status.value.lower(),
                "feedback": behaviour.feedback_message,
                "event": _event(before[0], now[0]),
            }
        )


def _event(before: Status, now: Status) -> str:
    if now == Status.INVALID:
        return "interrupted"
    if now != Status.RUNNING:
        return "finished"
    return "changed" if before == Status.RUNNING else "started"


def _family(node: Behaviour) -> str:
    if isinstance(node, IfThenElse):
        return "condition"
    if type(node) is InOrder and node.memory:
        return "sequence"
    return "other" if node.children else "leaf"


def _label(node: Behaviour) -> str:
    """The name; of a node that no instruction is compiled to, which needs telling what it is, with its type."""
    name = escaped(node.name)
    return f"{type(node).__name__}: {name}" if _family(node) == "other" else name


def _children(node: Behaviour) -> Iterator[tuple[Behaviour, str]]:
    """The children with their roles: "if", "then", "else" under an if-then-else, else ""."""
    roles = {}
    if isinstance(node, IfThenElse):
        roles = {id(node.condition): "if", id(node.then): "then", id(node.orelse): "else"}
    for child in node.children:
        yield child, roles.get(id(child), "")


def _task_of(node: Behaviour) -> GroundTask | None:
    """The task of a leaf; None for other nodes."""
    task = getattr(node, "task", None)
    return task if isinstance(task, GroundTask) else None


def _walk(node: Behaviour, role: str = "") -> Iterator[tuple[Behaviour, str]]:
    yield node, role
    for child, child_role in _children(node):
        yield from _walk(child, child_role)


def _lines(node: Behaviour, role: str, depth: int, signs: dict[Any, str], show_status: bool) -> Iterator[str]:
    parts = ["  " * depth + signs[_family(node)]]
    parts += [f"{role}:"] if role else []
    parts.append(_label(node))
    if show_status:
        parts.append(signs[node.status])
        parts += [f"({escaped(node.feedback_message)})"] if node.feedback_message and not node.children else []
    yield " ".join(parts)
    for child, child_role in _children(node):
        yield from _lines(child, child_role, depth + 1, signs, show_status)


def _snapshot(node: Behaviour, role: str) -> dict[str, Any]:
    value: dict[str, Any] = {"type": type(node).__name__, "name": node.name}
    if role:
        value["role"] = role
    if task := _task_of(node):
        value |= {"task": task.number, "task_type": task.type, "condition": bool(getattr(node, "is_condition", False))}
        value["arguments"] = {
            name: said if isinstance(said, str) else [referent.to_json() for referent in said]
            for name, said in task.arguments().items()
        }
    if isinstance(node, IfThenElse):
        value["truth"] = node.truth
    value |= {"status": node.status.value.lower(), "feedback": node.feedback_message}
    if node.children:
        value["children"] = [_snapshot(child, child_role) for child, child_role in _children(node)]
    return value


def _append_xml(parent: ElementTree.Element, node: Behaviour) -> None:
    if isinstance(node, IfThenElse):
        element = ElementTree.SubElement(parent, "IfThenElse", name=_printable(node.name))
        _append_xml(element, node.condition)
        for branch in (node.then, node.orelse):
            if branch is None:
                ElementTree.SubElement(element, "AlwaysSuccess", name="nothing was asked for")
            else:
                _append_xml(element, branch)
    elif type(node) is InOrder and node.memory:
        element = ElementTree.SubElement(parent, "Sequence", name=_printable(node.name))
        for child in node.children:
            _append_xml(element, child)
        if not node.children:
            ElementTree.SubElement(element, "AlwaysSuccess", name="nothing was asked for")
    elif (task := _task_of(node)) and not node.children:
        is_condition = getattr(node, "is_condition", False)
        attributes = {"ID": "PlannedTask", "name": _printable(node.name), "task": str(task.number), "type": task.type}
        attributes["condition"] = str(is_condition).lower()
        for name, said in task.arguments().items():
            text = said if isinstance(said, str) else ";".join(referent.choice for referent in said)
            attributes[name] = _printable(text)
        ElementTree.SubElement(parent, "Action", attributes)
    else:
        memory = " without memory" if isinstance(node, InOrder) and not node.memory else ""
        raise InputError(
            f"{node.name!r} is a {type(node).__name__}{memory}, for which the XML has no node; expected what an "
            "instruction is compiled to: IfThenElse, Sequence with memory, PlannedTask"
        )


def _printable(text: str) -> str:
    """The text with "?" for what XML 1.0 cannot hold."""
    return "".join(character if _is_xml(ord(character)) else "?" for character in text)


def _is_xml(code: int) -> bool:
    return code in (0x9, 0xA, 0xD) or 0x20 <= code < 0xD800 or 0xE000 <= code < 0xFFFE or code >= 0x10000
