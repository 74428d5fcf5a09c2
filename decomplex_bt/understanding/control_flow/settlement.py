"""Settlement: what the words make a condition of, where the arcs of a flow have a failed order or a plain wait."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.presence import SOME

_FAILING = frozenset(("bringing", "taking", "placing", "informing", "following"))
"""What cannot be done where who it is for, or what it is of, is not there."""
_POINTING = frozenset(("there", "here", "home"))
_GOING_ON = frozenset(("then", "after_that"))


def settle(flow: Flow, clauses: Sequence[Clause]) -> Flow:
    """The flow with two ways of English told as they are meant, whatever the arcs tell them as.

    An event that is waited for is a condition of what its sentence has done then: "once she's here, bring her the
    chair" is `{if: 1, then: [2]}`. Whether somebody is in, or something there, that an order cannot be carried out
    without, is asked ahead of it: "take it to Ann. If she's out, leave it here" is `{if: 2, then: [3], else: [1]}`.
    """
    if any(clause.is_event for clause in clauses):
        flow = Flow(_awaiting(flow.nodes, clauses))
    if any(clause.presence for clause in clauses):
        flow = Flow(_asking_ahead(flow.nodes, clauses))
    return flow


def _awaiting(nodes: Sequence[Node], clauses: Sequence[Clause]) -> tuple[Node, ...]:
    found: list[Node] = []
    waiting = list(nodes)
    while waiting:
        node = waiting.pop(0)
        if isinstance(node, If):
            then = node.then
            if clauses[node.task - 1].is_event and not node.orelse and _first(node) == node.task:
                while waiting and _waits(waiting[0], node.task, clauses, is_behind=False):
                    then = (*then, waiting.pop(0))  # "when it's hot, bring it, *and if you find a ladle, ...*"
            node = If(node.tasks, _awaiting(then, clauses), _awaiting(node.orelse, clauses))
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
    dependents = [_first(branch) for branch in (*node.then, *node.orelse)]
    if not mentions or not _is_needed(clauses[mentions[0] - 1], clauses[order - 1]):
        return node
    asked = clauses[mentions[0] - 1]
    behind = min((number for number in dependents if number > mentions[0]), default=0)
    if not behind:
        return node
    is_met = any(_first(branch) == behind for branch in node.then)
    said, other = (node.then, node.orelse) if is_met else (node.orelse, node.then)
    # what stands right behind a case hangs on it as it is stated
    then, orelse = (other, said) if asked.wording.is_negated else (said, other)
    done = Do((order,))
    return If(tuple(mentions), *(((done, *then), orelse) if asked.presence == "there" else (then, (done, *orelse))))


def _is_needed(clause: Clause, order: Clause) -> bool:
    """Whether a clause asks for no more than the presence of whom or what an order needs; not for the answer to what it
    asks somebody ("ask her if she's in. If she isn't, ...")."""
    kind = order.task.type
    is_kept = kind in _FAILING or (kind == "change_state" and clause.wording.is_of_rest)
    if not is_kept or not clause.presence or "unless" in clause.near or (order.question and clause.says_only_whether):
        return False
    if clause.is_of_nobody:
        return bool(order.receivers) and clause.places <= _POINTING
    is_of_same = not order.nouns.isdisjoint(clause.objects) or (order.has_pronoun and not order.objects)
    return is_of_same or SOME.issuperset(clause.objects)
