"""The control flow of an instruction as a py_trees tree that reads as the instruction does."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence as InOrder

from decomplex_bt.behaviour.conditional import IfThenElse
from decomplex_bt.domain.sentences import say_condition
from decomplex_bt.flow import Do, Flow, If, Node

FlowPath = tuple[int | str, ...]
"""Where in a flow's JSON form a node stands: `()` the whole, `(0,)` its first entry, `(0, "if")` that entry's
condition, `(0, "then")` a branch of several entries, `(0, "then", 1)` its second entry."""

LeafFactory = Callable[[str, int, bool], Behaviour]
"""Makes the leaf of a task: its name, the task's number, and whether it stands as a condition."""


@dataclass(frozen=True)
class CompiledTree:
    """A tree with the correspondence between its nodes and those of the flow, one to one."""

    root: Behaviour
    nodes: Mapping[FlowPath, Behaviour]


def compile_flow(flow: Flow, names: Mapping[int, str], make_leaf: LeafFactory, *, title: str) -> CompiledTree:
    """The tree of a flow: a sequence for a sequence, an if-then-else for a condition, a leaf for a task.

    `names`: the sentence of each task by number. Mentions of one task become one leaf, a repeated task another leaf of
    the same task. A branch of one entry is that entry. `title` names the root.
    """
    nodes: dict[FlowPath, Behaviour] = {}
    root = InOrder(title, memory=True, children=_compile_all(flow.nodes, names, make_leaf, nodes, ()))
    nodes[()] = root
    return CompiledTree(root, nodes)


def _compile_all(
    entries: Sequence[Node],
    names: Mapping[int, str],
    make_leaf: LeafFactory,
    nodes: dict[FlowPath, Behaviour],
    path: FlowPath,
) -> list[Behaviour]:
    return [_compile(entry, names, make_leaf, nodes, (*path, index)) for index, entry in enumerate(entries)]


def _compile(
    entry: Node, names: Mapping[int, str], make_leaf: LeafFactory, nodes: dict[FlowPath, Behaviour], path: FlowPath
) -> Behaviour:
    node: Behaviour
    if isinstance(entry, Do):
        node = make_leaf(names[entry.task], entry.task, False)
    else:
        node = _compile_condition(entry, names, make_leaf, nodes, path)
    nodes[path] = node
    return node


def _compile_condition(
    entry: If, names: Mapping[int, str], make_leaf: LeafFactory, nodes: dict[FlowPath, Behaviour], path: FlowPath
) -> IfThenElse:
    condition = make_leaf(names[entry.task], entry.task, True)
    nodes[*path, "if"] = condition
    branches: list[Behaviour | None] = []
    for side, title, entries in (("then", "then", entry.then), ("else", "otherwise", entry.orelse)):
        children = _compile_all(entries, names, make_leaf, nodes, (*path, side))
        if len(children) > 1:
            nodes[*path, side] = InOrder(title, memory=True, children=children)
            branches.append(nodes[*path, side])
        else:
            branches.append(children[0] if children else None)
    then, orelse = branches
    return IfThenElse(say_condition(names[entry.task]), condition=condition, then=then, orelse=orelse)
