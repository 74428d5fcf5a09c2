"""Settlement: what the words make a condition of, where the arcs of a flow have a failed order or a plain wait."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.understanding.control_flow.clause import Clause

_FAILING = frozenset(("bringing", "taking", "placing", "informing", "following"))
"""What cannot be done where who it is for, or what it is of, is not there."""
_GOING_ON = frozenset(("then", "after_that"))


def settle(flow: Flow, clauses: Sequence[Clause]) -> Flow:
    """The flow with two ways of English told as they are meant, whatever the arcs tell them as.

    An event that is waited for is a condition of what its sentence has done then: "once she's here, bring her the
    chair" is `{if: 1, then: [2]}`. Whether somebody is in, or something there, that an order cannot be carried out
    without, is asked ahead of it: "take it to Ann. If she's out, leave it here" is `{if: 2, then: [3], else: [1]}`.
    """
    if any(clause.is_event for clause in clauses):
        flow = Flow(_awaiting(flow.nodes, clauses))
    if any(clause.asks_presence for clause in clauses):
        flow = Flow(_asking_ahead(flow.nodes, clauses))
    return flow


def _awaiting(nodes: Sequence[Node], clauses: Sequence[Clause]) -> tuple[Node, ...]:
    found: list[Node] = []
    waiting = list(nodes)
    while waiting:
        node = waiting.pop(0)
        if isinstance(node, If):
            node = If(node.tasks, _awaiting(node.then, clauses), _awaiting(node.orelse, clauses))
            while _goes_on(node, waiting, clauses):
                node = If(node.tasks, (*node.then, waiting.pop(0)))
        elif not node.is_repeat and len(node.tasks) == 1 and clauses[node.task - 1].is_event:
            is_behind = bool(waiting) and _first(waiting[0]) < node.task  # "close it *once it's gone*"
            behind = 0
            while behind < len(waiting) and _waits(waiting[behind], node.task, clauses, is_behind=is_behind):
                behind += 1
            if behind:
                node = If(node.tasks, _awaiting(waiting[:behind], clauses))
                del waiting[:behind]
            elif clauses[node.task - 1].boundary == "none" and found and isinstance(found[-1], Do):
                node = If(node.tasks, (found.pop(),))  # "close the window *once it's gone*"
        found.append(node)
    return tuple(found)


def _goes_on(event: If, waiting: Sequence[Node], clauses: Sequence[Clause]) -> bool:
    """Whether the sentence that an event opens goes on with the next of what is `waiting` ("when it's hot, bring it,
    *and if you find a ladle, bring that too*")."""
    is_leading = clauses[event.task - 1].is_event and not event.orelse and _first(event) == event.task
    return is_leading and bool(waiting) and _waits(waiting[0], event.task, clauses, is_behind=False)


def _waits(node: Node, event: int, clauses: Sequence[Clause], *, is_behind: bool) -> bool:
    """Whether what is done next waits for an event: what its sentence orders, but past an event that `is_behind` an
    order only what goes on with that ("put it away once it's cold, *then tell me*", not "*and wash the pan*")."""
    first = _first(node)
    clause = clauses[first - 1]
    if clause.sentence != clauses[event - 1].sentence:
        return False
    if first < event or not is_behind:
        return True
    return isinstance(node, Do) and (clause.has_pronoun or not _GOING_ON.isdisjoint((*clause.far, *clause.near)))


def _first(node: Node) -> int:
    """The first task of a node in text order."""
    if isinstance(node, Do):
        return node.task
    return min(node.task, *map(_first, (*node.then, *node.orelse)))


def _asking_ahead(nodes: Sequence[Node], clauses: Sequence[Clause]) -> tuple[Node, ...]:
    found: list[Node] = []
    for node in nodes:
        if isinstance(node, If):
            node = If(node.tasks, _asking_ahead(node.then, clauses), _asking_ahead(node.orelse, clauses))
            node = _asked_ahead(node, clauses)
        found.append(node)
    return tuple(found)


def _asked_ahead(node: If, clauses: Sequence[Clause]) -> If:
    """A condition on how an order went as one on what it needs, where its next mention asks for that."""
    order, *mentions = node.tasks
    if not mentions:
        return node
    asked, kind = mentions[0], clauses[order - 1].task.type
    clause = clauses[asked - 1]
    is_kept = kind in _FAILING or (kind == "change_state" and clause.wording.is_of_rest)
    is_reply = bool(clauses[order - 1].question) and clause.says_only_whether  # "ask her if she's in. If she isn't"
    if not is_kept or not clause.asks_presence or "unless" in clause.near or is_reply:
        return node
    dependents = [_first(branch) for branch in (*node.then, *node.orelse)]
    behind = [number for number in dependents if number > asked]
    if not behind:
        return node
    is_met = any(_first(branch) == min(behind) for branch in node.then)
    done, rest = (Do((order,)), *node.then), node.orelse
    # what stands right behind a case hangs on it as it is stated
    return If(tuple(mentions), *((done, rest) if is_met != clause.wording.is_negated else (rest, done)))
