"""The construction of a control flow from the arcs of its tasks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from decomplex_bt.flow import Do, Flow, If, Node, in_reading_order
from decomplex_bt.understanding.control_flow.arcs import (
    BOTH,
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
    return Flow(in_reading_order(Builder(arcs, wordings).build()))


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
                for each in (side, other_side(side)) if arc.attachment.endswith(BOTH) else (side,):
                    self.groups[group].sides[each].append(i)
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
        return side_of(self.flips[token] != (self.arcs[i].attachment[2:3] == "-"))

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
        outside: list[int] = []
        for i in members:
            group = self._around(i, members)
            for side in group.sides.values() if group else (outside,):
                side.append(i)
        return tuple(self._node(i) for i in self._arranged(outside))

    def _around(self, i: int, members: Sequence[int]) -> _Group | None:
        """The condition between whose mentions a task is done in any case, so on both sides of it: "check whether it is
        wet, then close the window. If it was wet, dry it". None where words tell of another order than the text's."""
        if i in self.groups or self.arcs[i].order != "keep" or self.wordings[i].orders:
            return None
        for group in (self.groups[j] for j in members if j in self.groups):
            mention = next((m for m in sorted(group.members) if m > i), None)
            if mention is None or group.first > i or len(self._parts(group)) > 1:
                continue
            later = [j for side in group.sides.values() for j in side if self._first_token(j) > mention]
            if later and not any(self.wordings[j].orders for j in (mention, *later)):
                return group
        return None

    def _node(self, i: int) -> Node:
        if i not in self.groups:
            return Do((i + 1, *(j + 1 for j in self.again.get(i, ()))))
        group = self.groups[i]
        numbers = tuple(j + 1 for j in group.members)
        parts = self._parts(group)
        if len(parts) > 1:
            return self._joined(parts)
        then, orelse = self._nodes(group.sides["then"]), self._nodes(group.sides["else"])
        return If(numbers, then, orelse) if then or orelse else Do(numbers)

    def _parts(self, group: _Group) -> list[tuple[_Group, str]]:
        """A condition and those joined to it ("if A and B", "if A or B or C"), each with the side on which the next one
        is asked, the last with the side that its clause states. A third one is joined where the second holds as it is
        stated; elsewhere it is a condition of its own ("if A or B, X; if neither, but C, Y")."""
        parts: list[tuple[_Group, str]] = []
        while True:
            stated = side_of(self.flips[group.first])
            alone = [(side, self.groups.get(inner[0])) for side, inner in group.sides.items() if len(inner) == 1]
            joined = [(side, inner) for side, inner in alone if inner and inner.join and (not parts or side == stated)]
            if not joined:
                return [*parts, (group, stated)]
            side, following = joined[0]
            parts.append((group, side))
            group = following

    def _joined(self, parts: Sequence[tuple[_Group, str]]) -> Node:
        """The node of a condition of several parts; what more than one branch has stands whole in each, which
        `in_reading_order` makes repeats of."""
        *outer, (last, stated) = parts
        met, unmet = self._nodes(last.sides[stated]), self._nodes(last.sides[other_side(stated)])
        for group, side in reversed(outer):
            unmet += self._nodes(group.sides[other_side(side)])
        node = _if(last, {stated: met, other_side(stated): unmet})
        for (group, side), (inner, _) in zip(reversed(outer), reversed(parts), strict=False):
            beside = unmet if inner.join == "and" else met
            on, off = (side, other_side(side)) if inner.join == "and" else (other_side(side), side)
            node = _if(group, {on: (node,), off: beside})
        return node

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


def _if(group: _Group, sides: dict[str, tuple[Node, ...]]) -> Node:
    numbers = tuple(j + 1 for j in group.members)
    then, orelse = sides["then"], sides["else"]
    return If(numbers, then, orelse) if then or orelse else Do(numbers)


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
