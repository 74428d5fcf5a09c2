"""Control flow as one small label per task, and back: what a sequence model can predict, a tree can be built from.

Every task, in text order, has a role, an attachment and an order. The paper's four labels (DeComplex, Table I) say role
and branch; they cannot say to which condition a branch belongs, nesting, mentions, joint conditions or an order other
than that of the text. The labels here can:

role        `task`, `condition`, `mention` (of an earlier condition), `and` / `or` (a condition joined to the one
            before), `again` (a further mention of an unconditional task)
attachment  `top`, or direction, rank and side: `<1+` is the branch of the nearest condition to the left that follows
            when that clause holds *as it is stated*, `>1-` that of the nearest one to the right when it does not.
            Conditions count by groups of mentions; seen from the left, conditions joined by "and" / "or" count as one,
            their last. "As stated" includes the clause's own negation, so that `+` is the
            plain case after "if it is not there" too; the negation is a matter of grammar and handed in.
order       `keep` (text order), `before` (ahead of the sibling before it), `first` (ahead of all siblings),
            `after` (behind the siblings after it in its sentence, at least one), `last` (behind all siblings)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

from decomplex_bt.flow import Do, Flow, If, Node

CONDITION_ROLES = frozenset(("condition", "mention", "and", "or"))
JOINTS = frozenset(("and", "or"))
ORDERS = ("keep", "before", "after", "first", "last")
TOP = "top"


@dataclass(frozen=True, slots=True)
class Arc:
    """The three labels of one task."""

    role: str = "task"
    attachment: str = TOP
    order: str = "keep"


@dataclass(frozen=True, slots=True)
class Wording:
    """What the words of a task's clause say for certain: whether it is negated, a state it tests with its opposite, if
    any, the number of its sentence, the order labels that its own cues speak for ("before you ...": `after`), and the
    `and` or `or` that joins it to the clause before it without an "if" of its own. `is_contrary`: by its word alone it
    says that something failed or is not there ("if it sticks", "if she is gone")."""

    is_negated: bool = False
    state: str | None = None
    opposite: str | None = None
    sentence: int = 0
    orders: tuple[str, ...] = ()
    joins: str = ""
    is_contrary: bool = False

    def is_opposite_of(self, other: Wording) -> bool:
        return self.state is not None and self.opposite is not None and other.state == self.opposite

    def contradicts(self, first: Wording) -> bool:
        """Whether a mention, its negation aside, says the opposite of what it mentions: another state of the same
        thing (else why say it), or that it failed."""
        if self.state is not None and first.state is not None:
            return self.state != first.state
        return self.is_contrary and not first.is_contrary


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
    return Flow(_Builder(arcs, wordings).build())


def arcs_of(flow: Flow, wordings: Sequence[Wording]) -> tuple[Arc, ...] | None:
    """The arcs that say this flow, or None where no arcs can (the inverse of `flow_of`)."""
    plain = _arcs_in_text_order(flow, wordings)
    if plain is None:
        return None
    for start in (*_with_joins(plain, wordings), plain):
        for arcs in _with_orders(_counting_joints_once(start), wordings):
            if flow_of(arcs, wordings) == flow:
                return arcs
    return None


def is_flipped(mention: int, first: int, wordings: Sequence[Wording]) -> bool:
    """Whether a mention as stated is by grammar the opposite of its first mention without that one's negation."""
    flipped = wordings[mention].is_negated
    if mention != first and wordings[mention].contradicts(wordings[first]):
        flipped = not flipped
    return flipped


def _side(is_opposite: bool) -> str:
    return "else" if is_opposite else "then"


def _flip_of(token: int, first: int, wordings: Sequence[Wording], used: set[str]) -> bool:
    """`is_flipped`, but who states a condition again whose one side has its tasks already means the other side:
    "if it is dry, fold it; if it is damp, hang it up" needs no word list to know that damp is not dry."""
    flipped = is_flipped(token, first, wordings)
    if token != first and _side(flipped) in used and len(used) == 1:
        return not flipped
    return flipped


class _Builder:
    def __init__(self, arcs: Sequence[Arc], wordings: Sequence[Wording]) -> None:
        self.arcs = arcs
        self.wordings = wordings
        self.groups: dict[int, _Group] = {}
        self.group_of: dict[int, int] = {}
        self.again: dict[int, list[int]] = {}
        self.flips: dict[int, bool] = {}

    def build(self) -> tuple[Node, ...]:
        self._collect_groups()
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

    def _collect_groups(self) -> None:
        for i, arc in enumerate(self.arcs):
            if arc.role not in CONDITION_ROLES:
                continue
            found = self._find(i, arc.attachment, before_only=True) if arc.role == "mention" else None
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
                found = self._find(i, self.arcs[i].attachment) if self.group_of.get(i, i) == i else None
                if found is not None and found < token and self.group_of[found] == group:
                    used.add(self._side_of(i, found))
            self.flips[token] = _flip_of(token, group, self.wordings, used)

    def _side_of(self, i: int, token: int) -> str:
        return _side(self.flips[token] != self.arcs[i].attachment.endswith("-"))

    def _repeat_of(self, i: int) -> int | None:
        """The earlier plain task that task `i` mentions again: as many plain tasks back as the attachment's rank
        says."""
        earlier = [j for j in range(i - 1, -1, -1) if self.arcs[j].role == "task"]
        attachment = self.arcs[i].attachment
        rank = int(attachment[1]) if attachment != TOP else 1
        if not earlier:
            return None
        j = earlier[min(rank, len(earlier)) - 1]
        if i not in self.again.setdefault(j, []):
            self.again[j].append(i)
        return j

    def _find(
        self, i: int, attachment: str, *, before_only: bool = False, joints_once: bool = True
    ) -> int | None:
        """The condition token that an attachment of task `i` points at, or None."""
        if attachment == TOP:
            return None
        direction, rank = attachment[0], int(attachment[1])
        tokens = range(i - 1, -1, -1) if direction == "<" or before_only else range(i + 1, len(self.arcs))
        own = self.group_of.get(i)
        seen: list[int] = []
        for j in tokens:
            group = self.group_of.get(j)
            if group is None or group == own or group in seen or (
                joints_once and j > i and self._is_joined_by_next(j)
            ):
                continue
            seen.append(group)
            if len(seen) == rank:
                return j
        return None

    def _is_joined_by_next(self, j: int) -> bool:
        return j + 1 < len(self.arcs) and self.arcs[j + 1].role in JOINTS

    def _target(self, i: int) -> tuple[int, str] | None:
        arc = self.arcs[i]
        found = self._find(i, arc.attachment)
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
        other = _other(side)
        inner_stated = _side(self.flips[inner.first])
        inner_other = _other(inner_stated)
        met = self._nodes(inner.sides[inner_stated])
        unmet = (*self._nodes(inner.sides[inner_other]), *self._nodes(group.sides[other]))
        numbers, inner_numbers = tuple(j + 1 for j in group.members), tuple(j + 1 for j in inner.members)
        if inner.join == "and":
            nested = _if(inner_numbers, {inner_stated: met, inner_other: unmet})
            return _if(numbers, {side: (nested,), other: _repeats(unmet)})
        nested = _if(inner_numbers, {inner_stated: _repeats(met), inner_other: unmet})
        return _if(numbers, {side: met, other: (nested,)})

    def _arranged(self, members: list[int]) -> list[int]:
        """Siblings in the order of execution."""
        in_text = sorted(members, key=self._first_token)
        return _reorder(
            in_text, [self.arcs[i].order for i in in_text], [self.wordings[i].sentence for i in in_text]
        )

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


def _reorder(items: list[int], orders: Sequence[str], sentences: Sequence[int]) -> list[int]:
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


def _arcs_in_text_order(flow: Flow, wordings: Sequence[Wording]) -> tuple[Arc, ...] | None:
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
    joins = dict(_joins(flow, wordings))
    # "if A or B, X": in the tree X is a child of A, in the text it follows B
    alternatives = {
        (parent[0], _other(parent[1])): node.task - 1
        for node, parent in _with_parents(flow.nodes, None)
        if parent is not None and joins.get(node.task - 1) == "or"
    }
    for i, first in group_of.items():
        if i != first:
            arcs[i] = Arc("mention", _pointer(i, first, group_of) or TOP)
    targets: dict[int, tuple[str, int, str]] = {}  # pointer, token pointed at, side
    for node, parent in _with_parents(flow.nodes, None):
        if isinstance(node, Do) and node.is_repeat:
            continue
        i = node.task - 1
        role = joins.get(i, "condition") if isinstance(node, If) else "task"
        arcs[i] = Arc(role)
        if parent is None:
            continue
        group, side = parent
        if role == "or":
            side = _other(side)
        elif parent in alternatives:
            group = alternatives[parent]
            side = _side(is_flipped(group, group, wordings))
        pointer = _pointer(i, group, group_of)
        if pointer is None:
            return None
        targets[i] = (pointer, _pointed_at(i, group, pointer, group_of, count), side)
    for i, first in again:
        rank = sum(arcs[j].role == "task" and j not in dict(again) for j in range(first, i))
        arcs[i] = Arc("again", f"<{min(9, rank)}")
    flips = _flips_of(targets, group_of, wordings)
    for i, (pointer, token, side) in targets.items():
        arcs[i] = replace(arcs[i], attachment=pointer + ("-" if _side(flips[token]) != side else "+"))
    return tuple(arcs)


def _other(side: str) -> str:
    return "else" if side == "then" else "then"


def _with_parents(
    nodes: Sequence[Node], parent: tuple[int, str] | None
) -> Iterator[tuple[Node, tuple[int, str] | None]]:
    for node in nodes:
        yield node, parent
        if isinstance(node, If):
            yield from _with_parents(node.then, (node.task - 1, "then"))
            yield from _with_parents(node.orelse, (node.task - 1, "else"))


def _joins(flow: Flow, wordings: Sequence[Wording]) -> Iterator[tuple[int, str]]:
    """The conditions (from 0) joined to the one they lie in, told by the tasks that stand in both."""
    for node, _ in flow.walk():
        if not isinstance(node, If):
            continue
        for branch, other in ((node.then, node.orelse), (node.orelse, node.then)):
            inner = branch[0] if len(branch) == 1 else None
            if not isinstance(inner, If):
                continue
            inner_repeats = [n for n in (*inner.then, *inner.orelse) if isinstance(n, Do) and n.is_repeat]
            other_repeats = [n for n in other if isinstance(n, Do) and n.is_repeat]
            if other_repeats:
                yield inner.task - 1, "and"
            elif inner_repeats:
                yield inner.task - 1, "or"


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
        used = {
            side for i, (_, j, side) in targets.items() if i < token and j < token and group_of[j] == group
        }
        flips[token] = _flip_of(token, group, wordings, used)
    return flips


def _counting_joints_once(arcs: tuple[Arc, ...]) -> tuple[Arc, ...]:
    """The same arcs where pointers to the right, which so far count every condition, count joined ones as one."""
    builder = _Builder(arcs, [Wording()] * len(arcs))
    builder._collect_groups()
    changed = list(arcs)
    for i, arc in enumerate(arcs):
        j = builder._find(i, arc.attachment, joints_once=False) if arc.attachment.startswith(">") else None
        if j is None:
            continue
        while builder._is_joined_by_next(j):
            j += 1
        own = builder.group_of.get(i)
        tokens = [m for m in range(i + 1, j + 1) if m in builder.group_of and not builder._is_joined_by_next(m)]
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


def branch_orders(
    roles: Sequence[str], attachments: Sequence[str], wordings: Sequence[Wording], i: int
) -> tuple[str, ...]:
    """The order labels that the consequences of condition `i` speak for in its place: in "fetch the cup; if it is
    dirty, wash it first" it is the whole condition that comes first."""
    if roles[i] not in CONDITION_ROLES:
        return ()
    found: list[str] = []
    for m in range(i + 1, len(roles)):
        if roles[m] in CONDITION_ROLES or not attachments[m].startswith("<1"):
            break
        found += [order for order in wordings[m].orders if order in ("before", "first")]
    return tuple(dict.fromkeys(found))


def _with_orders(arcs: tuple[Arc, ...], wordings: Sequence[Wording]) -> Iterator[tuple[Arc, ...]]:
    """The arcs with every small set of order labels: few labels first, and those that the words speak for."""
    yield arcs
    movable = [i for i, arc in enumerate(arcs) if arc.role not in ("mention", "again")]
    changes = [(i, order) for i in movable for order in ORDERS[1:]]
    roles, places = [arc.role for arc in arcs], [arc.attachment for arc in arcs]
    said = [{*wordings[i].orders, *branch_orders(roles, places, wordings, i)} for i in range(len(arcs))]
    cost = {(i, order): 2 if order in said[i] else 5 for i, order in changes}
    sets = [(change,) for change in changes]
    sets += [pair for pair in combinations(changes, 2) if pair[0][0] != pair[1][0]]  # type: ignore[misc]
    for chosen in sorted(sets, key=lambda labels: sum(cost[label] for label in labels)):
        changed = list(arcs)
        for i, order in chosen:
            changed[i] = replace(changed[i], order=order)
        yield tuple(changed)
