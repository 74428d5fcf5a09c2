"""The construction of a control flow from the arcs of its tasks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.understanding.arcs import (
    CONDITION_ROLES,
    JOINTS,
    TOP,
    Arc,
    Wording,
    flip_of,
    other_side,
    repeated,
    side_of,
)


@dataclass(slots=True)
class _Group:
    """A condition with its mentions while the tree is being built; all numbers count from 0."""

    first: int
    join: str = ""
    members: list[int] = field(default_factory=list)
    parent: tuple[int, str] | None = None
    sides: dict[str, list[int]] = field(default_factory=lambda: {"then": [], "else": []})


def flow_of(arcs: Sequence[Arc], wordings: Sequence[Wording]) -> Flow:
    """The control flow that these arcs say; total: an arc that points nowhere leads to the top."""
    return Flow(Builder(arcs, wordings).build())


class Builder:
    """Builds the tree of one instruction; all numbers count from 0."""

    def __init__(self, arcs: Sequence[Arc], wordings: Sequence[Wording]) -> None:
        self.arcs = arcs
        self.wordings = wordings
        self.groups: dict[int, _Group] = {}
        self.group_of: dict[int, int] = {}
        self.again: dict[int, list[int]] = {}
        self.flips: dict[int, bool] = {}

    def build(self) -> tuple[Node, ...]:
        self.collect_groups()
        self._collect_flips()
        top: list[int] = []
        for i, arc in enumerate(self.arcs):
            if arc.role == "again" and self._repeat_of(i) is not None:
                continue
            if i in self.group_of and self.group_of[i] != i:
                continue
            target = self._target(i)
            if target is None:
                top.append(i)
            else:
                group, side = target
                self.groups[group].sides[side].append(i)
        return self._nodes(top)

    def collect_groups(self) -> None:
        """Puts every condition and its mentions together."""
        for i, arc in enumerate(self.arcs):
            if arc.role not in CONDITION_ROLES:
                continue
            found = self.find(i, arc.attachment, before_only=True) if arc.role == "mention" else None
            if found is not None:
                first = self.group_of[found]
                self.groups[first].members.append(i)
                self.group_of[i] = first
            else:
                join = arc.role if arc.role in JOINTS else ""
                self.groups[i] = _Group(i, join, [i])
                self.group_of[i] = i

    def _collect_flips(self) -> None:
        """From left to right, since what a mention means depends on the branches that have tasks before it."""
        for token in sorted(self.group_of):
            group = self.group_of[token]
            used: set[str] = set()
            for i in range(token):
                found = self.find(i, self.arcs[i].attachment) if self.group_of.get(i, i) == i else None
                if found is not None and found < token and self.group_of[found] == group:
                    used.add(self._side_of(i, found))
            self.flips[token] = flip_of(token, group, self.wordings, used)

    def _side_of(self, i: int, token: int) -> str:
        return side_of(self.flips[token] != self.arcs[i].attachment.endswith("-"))

    def _repeat_of(self, i: int) -> int | None:
        """The earlier plain task that task `i` mentions again, which is noted."""
        j = repeated([arc.role for arc in self.arcs], [arc.attachment for arc in self.arcs], i)
        if j is None:
            return None
        if i not in self.again.setdefault(j, []):
            self.again[j].append(i)
        return j

    def find(self, i: int, attachment: str, *, before_only: bool = False, joints_once: bool = True) -> int | None:
        """The condition token that an attachment of task `i` points at, or None."""
        if attachment == TOP:
            return None
        direction, rank = attachment[0], int(attachment[1])
        tokens = range(i - 1, -1, -1) if direction == "<" or before_only else range(i + 1, len(self.arcs))
        own = self.group_of.get(i)
        seen: list[int] = []
        for j in tokens:
            group = self.group_of.get(j)
            if group is None or group == own or group in seen or (joints_once and j > i and self.is_joined_by_next(j)):
                continue
            seen.append(group)
            if len(seen) == rank:
                return j
        return None

    def is_joined_by_next(self, j: int) -> bool:
        """Whether the task behind `j` is a condition joined to it by "and" or "or"."""
        return j + 1 < len(self.arcs) and self.arcs[j + 1].role in JOINTS

    def _target(self, i: int) -> tuple[int, str] | None:
        arc = self.arcs[i]
        found = self.find(i, arc.attachment)
        if found is None:
            return None
        group = self.group_of[found]
        side = self._side_of(i, found)
        if i in self.groups:
            if self._is_above(i, group):
                return None
            self.groups[i].parent = (group, side)
        return group, side

    def _is_above(self, upper: int, lower: int) -> bool:
        """Whether group `upper` is `lower` or one of the groups that it lies in."""
        current: int | None = lower
        while current is not None:
            if current == upper:
                return True
            parent = self.groups[current].parent
            current = parent[0] if parent else None
        return False

    def _nodes(self, members: list[int]) -> tuple[Node, ...]:
        return tuple(self._node(i) for i in self._arranged(members))

    def _node(self, i: int) -> Node:
        if i not in self.groups:
            return Do((i + 1, *(j + 1 for j in self.again.get(i, ()))))
        group = self.groups[i]
        numbers = tuple(j + 1 for j in group.members)
        joined = self._joined(group)
        if joined is not None:
            return joined
        then, orelse = self._nodes(group.sides["then"]), self._nodes(group.sides["else"])
        return If(numbers, then, orelse) if then or orelse else Do(numbers)

    def _joined(self, group: _Group) -> Node | None:
        """The node of a condition that another is joined to ("if A and B", "if A or B"), or None."""
        for side in ("then", "else"):
            for j in group.sides[side]:
                inner = self.groups.get(j)
                if inner is None or not inner.join or len(group.sides[side]) != 1:
                    continue
                return self._join(group, side, inner)
        return None

    def _join(self, group: _Group, side: str, inner: _Group) -> Node:
        other = other_side(side)
        inner_stated = side_of(self.flips[inner.first])
        inner_other = other_side(inner_stated)
        met = self._nodes(inner.sides[inner_stated])
        unmet = (*self._nodes(inner.sides[inner_other]), *self._nodes(group.sides[other]))
        numbers, inner_numbers = tuple(j + 1 for j in group.members), tuple(j + 1 for j in inner.members)
        # what both branches have is read first in the "then" of the outer condition, wherever that leads
        if inner.join == "and":
            within, beside = (unmet, _repeats(unmet)) if side == "then" else (_repeats(unmet), unmet)
            nested = _if(inner_numbers, {inner_stated: met, inner_other: within})
            return _if(numbers, {side: (nested,), other: beside})
        within, beside = (_repeats(met), met) if side == "then" else (met, _repeats(met))
        nested = _if(inner_numbers, {inner_stated: within, inner_other: unmet})
        return _if(numbers, {side: beside, other: (nested,)})

    def _arranged(self, members: list[int]) -> list[int]:
        """Siblings in the order of execution."""
        in_text = sorted(members, key=self._first_token)
        return _reorder(in_text, [self.arcs[i].order for i in in_text], [self.wordings[i].sentence for i in in_text])

    def _first_token(self, i: int) -> int:
        if i not in self.groups:
            return i
        group = self.groups[i]
        inner = [self._first_token(j) for side in group.sides.values() for j in side]
        return min([*group.members, *inner])


def _if(numbers: tuple[int, ...], sides: dict[str, tuple[Node, ...]]) -> Node:
    then, orelse = sides["then"], sides["else"]
    return If(numbers, then, orelse) if then or orelse else Do(numbers)


def _repeats(nodes: Sequence[Node]) -> tuple[Node, ...]:
    """The plain tasks of a branch once more, as repeats; a nested condition is not repeated."""
    return tuple(Do((node.task,), is_repeat=True) for node in nodes if isinstance(node, Do))


def _alone(orders: Sequence[str], sentences: Sequence[int]) -> list[str]:
    """The order of each sibling by itself, where some take those after them along."""
    alone = list(orders)
    for i, order in enumerate(orders):
        if not order.endswith("+"):
            continue
        alone[i] = order[:-1]
        if i == 0:  # there is nothing to go ahead of, and what follows must not go ahead of this one
            continue
        for j in range(i + 1, len(orders)):
            if orders[j] != "keep" or sentences[j] != sentences[i]:
                break
            alone[j] = alone[i]
    return alone


def _reorder(items: list[int], orders: Sequence[str], sentences: Sequence[int]) -> list[int]:
    orders = _alone(orders, sentences)
    arranged: list[int] = []
    run: list[int] = []  # neighbours that all go before the sibling ahead of them, in text order
    for item, order in zip(items, orders, strict=True):
        if order == "before" and arranged:
            run.append(item)
            continue
        _insert_run(arranged, run)
        run = []
        arranged.append(item)
    _insert_run(arranged, run)
    order_of = dict(zip(items, orders, strict=True))
    sentence_of = dict(zip(items, sentences, strict=True))
    for item in [i for i in arranged if order_of[i] == "after"]:
        position = arranged.index(item)
        arranged.remove(item)
        end = position + 1
        while end < len(arranged) and sentence_of[arranged[end]] == sentence_of[item]:
            end += 1
        arranged.insert(end, item)
    first = [i for i in arranged if order_of[i] == "first"]
    last = [i for i in arranged if order_of[i] == "last"]
    middle = [i for i in arranged if order_of[i] not in ("first", "last")]
    return [*first, *middle, *last]


def _insert_run(arranged: list[int], run: list[int]) -> None:
    if run:
        arranged[-1:-1] = run
