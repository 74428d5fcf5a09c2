"""The derivation of arcs from an annotated control flow: what training learns from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.understanding.control_flow.arcs import (
    CONDITION_ROLES,
    ORDERS,
    TOP,
    Arc,
    Wording,
    flip_of,
    other_orders,
    other_side,
    side_of,
)
from decomplex_bt.understanding.control_flow.construction import Builder, flow_of


def arcs_of(flow: Flow, wordings: Sequence[Wording]) -> tuple[Arc, ...] | None:
    """The arcs that say this flow, or None where no arcs can (the inverse of `flow_of`)."""
    joints = list(_joints(flow))
    worded = [joint.inverted if wordings[joint.inner].joins not in ("", joint.role) else joint for joint in joints]
    ways = (worded, joints, [joint.inverted for joint in joints])
    for chosen in (way for k, way in enumerate(ways) if way not in ways[:k]):
        plain = _arcs_in_text_order(flow, wordings, chosen)
        if plain is None:
            continue
        for start in (*_with_joins(plain, wordings), plain):
            for arcs in _with_orders(_counting_joints_once(start), wordings):
                if flow_of(arcs, wordings) == flow:
                    return arcs
    return None


@dataclass(frozen=True, slots=True)
class _Joint:
    """Two conditions (from 0) that are parts of one, as tasks tell that stand in both: `inner` is asked on one side of
    `outer`, where that leaves the matter open. `beside`: the other side of `outer`; `shared`: the side of `inner` that
    repeats what stands there, "" where `beside` repeats what stands in `inner`. `role`: "and" or "or".

    "Unless A or B, X" is as much "if neither A nor B, X": what is joined by "and" on one side is by "or" on the other.
    """

    outer: int
    inner: int
    beside: str
    shared: str
    role: str

    @property
    def inverted(self) -> _Joint:
        return replace(self, role="or" if self.role == "and" else "and")


def _arcs_in_text_order(flow: Flow, wordings: Sequence[Wording], joints: Sequence[_Joint]) -> tuple[Arc, ...] | None:
    count = len(wordings)
    arcs = [Arc() for _ in range(count)]
    group_of: dict[int, int] = {}
    again: list[tuple[int, int]] = []
    for node, _ in flow.walk():
        if isinstance(node, If):
            for number in node.tasks:
                group_of[number - 1] = node.task - 1
        elif not node.is_repeat:
            again += [(number - 1, node.task - 1) for number in node.tasks[1:]]
    joins = {joint.inner: joint.role for joint in joints}
    # "if A or B, X": in the tree X is a child of A, in the text it follows B
    beside = {(joint.outer, joint.beside): (joint.inner, joint.shared) for joint in joints if joint.shared}
    for i, first in group_of.items():
        if i != first:
            arcs[i] = Arc("mention", _pointer(i, first, group_of) or TOP)
    targets: dict[int, tuple[str, int, str]] = {}  # pointer, token pointed at, side
    above = _above(flow)
    for node, parent in _with_parents(flow):
        if isinstance(node, Do) and node.is_repeat:
            continue
        i = node.task - 1
        if i in above and parent is not None and parent[0] == above[i][0]:
            parent = above[i][1]
        role = joins.get(i, "condition") if isinstance(node, If) else "task"
        arcs[i] = Arc(role)
        if parent is None:
            continue
        group, side = parent
        if role == "or":
            side = other_side(side)
        while role != "or" and (group, side) in beside:
            group, side = beside[group, side]
        pointer = _pointer(i, group, group_of)
        if pointer is None:
            return None
        targets[i] = (pointer, _pointed_at(i, group, pointer, group_of, count), side)
    for i, first in again:
        rank = sum(arcs[j].role == "task" and j not in dict(again) for j in range(first, i))
        arcs[i] = Arc("again", f"<{min(9, rank)}")
    flips = _flips_of(targets, group_of, wordings)
    for i, (pointer, token, side) in targets.items():
        arcs[i] = replace(arcs[i], attachment=pointer + ("-" if side_of(flips[token]) != side else "+"))
    return tuple(arcs)


def _with_parents(flow: Flow) -> Iterator[tuple[Node, tuple[int, str] | None]]:
    """Every node with the condition right above it, counted from 0, and the side of that."""
    for node, path in flow.paths():
        yield node, (path[-1][0] - 1, path[-1][1]) if path else None


def _above(flow: Flow) -> dict[int, tuple[int, tuple[int, str] | None]]:
    """Of the tasks that stand on both sides of a condition since they are done between two mentions of it: that
    condition, and where it stands itself, which is where the words have them."""
    found: dict[int, tuple[int, tuple[int, str] | None]] = {}
    for node, parent in _with_parents(flow):
        if isinstance(node, If):
            for task in _done(node.then) & _done(node.orelse):
                if node.task < task < max(node.tasks):
                    found[task - 1] = node.task - 1, parent
    return found


def _joints(flow: Flow) -> Iterator[_Joint]:
    for node, _ in flow.walk():
        if not isinstance(node, If):
            continue
        for beside, branch, other in (("else", node.then, node.orelse), ("then", node.orelse, node.then)):
            inner = branch[0] if len(branch) == 1 else None
            if not isinstance(inner, If):
                continue
            placed = {n.task for n, _ in Flow((inner,)).walk() if isinstance(n, Do) and not n.is_repeat}
            if placed & _done(other, repeats_only=True):
                yield _Joint(node.task - 1, inner.task - 1, beside, "", "and")
                continue
            sides = (("then", inner.then), ("else", inner.orelse))
            shared = next((side for side, ns in sides if _done(ns, repeats_only=True) & _done(other)), "")
            if shared:
                yield _Joint(node.task - 1, inner.task - 1, beside, shared, "or")


def _done(nodes: Sequence[Node], *, repeats_only: bool = False) -> set[int]:
    """The plain tasks of a branch itself, not of the conditions in it."""
    return {node.task for node in nodes if isinstance(node, Do) and (node.is_repeat or not repeats_only)}


def _pointer(i: int, group: int, group_of: dict[int, int]) -> str | None:
    """Direction and rank of the nearest token of `group` as seen from task `i`, left before right."""
    own = group_of.get(i) if group_of.get(i) == i else None
    for direction in "<>":
        tokens = range(i - 1, -1, -1) if direction == "<" else range(i + 1, max(group_of, default=-1) + 1)
        seen: list[int] = []
        for j in tokens:
            other = group_of.get(j)
            if other is None or other == own or other in seen:
                continue
            seen.append(other)
            if other == group:
                return f"{direction}{len(seen)}"
    return None


def _pointed_at(i: int, group: int, pointer: str, group_of: dict[int, int], count: int) -> int:
    """The token of `group` that a pointer of task `i` means: the nearest in its direction."""
    tokens = range(i - 1, -1, -1) if pointer[0] == "<" else range(i + 1, count)
    return next(j for j in tokens if group_of.get(j) == group)


def _flips_of(
    targets: Mapping[int, tuple[str, int, str]], group_of: dict[int, int], wordings: Sequence[Wording]
) -> dict[int, bool]:
    flips: dict[int, bool] = {}
    for token in sorted(group_of):
        group = group_of[token]
        used = {side for i, (_, j, side) in targets.items() if i < token and j < token and group_of[j] == group}
        flips[token] = flip_of(token, group, wordings, used)
    return flips


def _counting_joints_once(arcs: tuple[Arc, ...]) -> tuple[Arc, ...]:
    """The same arcs where pointers to the right, which so far count every condition, count joined ones as one."""
    builder = Builder(arcs, [Wording()] * len(arcs))
    builder.collect_groups()
    changed = list(arcs)
    for i, arc in enumerate(arcs):
        j = builder.find(i, arc.attachment, joints_once=False) if arc.attachment.startswith(">") else None
        if j is None:
            continue
        while builder.is_joined_by_next(j):
            j += 1
        own = builder.group_of.get(i)
        tokens = [m for m in range(i + 1, j + 1) if m in builder.group_of and not builder.is_joined_by_next(m)]
        groups = dict.fromkeys(builder.group_of[m] for m in tokens if builder.group_of[m] != own)
        rank = list(groups).index(builder.group_of[j]) + 1
        changed[i] = replace(arc, attachment=f">{min(9, rank)}{arc.attachment[-1]}")
    return tuple(changed)


def _with_joins(plain: tuple[Arc, ...], wordings: Sequence[Wording]) -> Iterator[tuple[Arc, ...]]:
    """The arcs with every condition that the words join to the one before it said to be joined, if there is one.

    Without an else the tree cannot tell a joint condition from a nested one; the words can.
    """
    joined = list(plain)
    for i in range(1, len(plain)):
        before, own = plain[i - 1], plain[i]
        is_nested = own.role == "condition" and before.role in CONDITION_ROLES and own.attachment[:2] == "<1"
        if wordings[i].joins and is_nested:
            place = "<1+" if wordings[i].joins == "or" else own.attachment
            joined[i] = Arc(wordings[i].joins, place, own.order)
    if tuple(joined) != plain:
        yield tuple(joined)


def _with_orders(arcs: tuple[Arc, ...], wordings: Sequence[Wording]) -> Iterator[tuple[Arc, ...]]:
    """The arcs with every small set of order labels: few labels first, and those that the words speak for."""
    yield arcs
    movable = [i for i, arc in enumerate(arcs) if arc.role not in ("mention", "again")]
    changes = [(i, order) for i in movable for order in ORDERS[1:]]
    roles, places = [arc.role for arc in arcs], [arc.attachment for arc in arcs]
    said = [{*wordings[i].orders, *other_orders(roles, places, wordings, i)} for i in range(len(arcs))]
    cost = {(i, order): 2 if order.removesuffix("+") in said[i] else 5 for i, order in changes}
    sets = [(change,) for change in changes]
    sets += [pair for pair in combinations(changes, 2) if pair[0][0] != pair[1][0]]  # type: ignore[misc]
    for chosen in sorted(sets, key=lambda labels: sum(cost[label] for label in labels)):
        changed = list(arcs)
        for i, order in chosen:
            changed[i] = replace(changed[i], order=order)
        yield tuple(changed)
