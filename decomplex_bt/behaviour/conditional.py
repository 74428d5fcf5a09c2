"""The if-then-else composite, which py_trees does not have."""

from __future__ import annotations

import uuid
from collections.abc import Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite
from py_trees.decorators import Decorator, Inverter

_ROLES = ("condition", "then", "orelse")
_NO_ROLE = "{!r} is neither condition nor branch of {!r}; replace one of these, or construct the node anew"


class IfThenElse(Composite):
    """Runs `then` where the condition succeeds and `orelse` where it fails.

    | condition | then | orelse | this node | which children are ticked |
    |---|---|---|---|---|
    | RUNNING | any | any | RUNNING | the condition |
    | SUCCESS | RUNNING, SUCCESS, FAILURE | any | the status of `then` | condition, then `then` |
    | SUCCESS | missing | any | SUCCESS | the condition |
    | FAILURE | any | RUNNING, SUCCESS, FAILURE | the status of `orelse` | condition, then `orelse` |
    | FAILURE | any | missing | SUCCESS: nothing was asked for | the condition |
    | FAILURE, `is_undecided` | any | any | FAILURE, with the condition's reason | the condition |

    `orelse` runs when the condition fails, never when `then` fails. The condition is judged once, when the node is
    reached, and its outcome (`truth`) stays until the node is entered anew: there is memory, always. A condition that
    can tell "no" from "cannot be known" has an attribute `is_undecided`; where that is true, its FAILURE is neither,
    nor is what a decorator makes of it by handing it on or turning it round.
    Stopped from outside (INVALID) it has judged nothing. Its children can be replaced and its branches removed; further
    ones have no role here and are refused with `TypeError`.

    This differs from BehaviorTree.CPP's IfThenElse in one row: with the third child missing, that one fails where the
    condition fails. The XML export therefore writes the missing branch out.
    """

    def __init__(
        self,
        name: str,
        *,
        condition: Behaviour,
        then: Behaviour | None = None,
        orelse: Behaviour | None = None,
    ) -> None:
        super().__init__(name, [child for child in (condition, then, orelse) if child is not None])
        self.condition = condition
        self.then = then
        self.orelse = orelse
        self.truth: bool | None = None

    @property
    def branch(self) -> Behaviour | None:
        """The branch that the condition led to; None before, or where that branch is missing."""
        return None if self.truth is None else self.then if self.truth else self.orelse

    @property
    def taken(self) -> str | None:
        """Which one that is, "then" or "else"; None where there is none."""
        branch = self.branch
        return None if branch is None else "then" if branch is self.then else "else"

    def insert_child(self, child: Behaviour, index: int) -> uuid.UUID:
        raise TypeError(_NO_ROLE.format(child.name, self.name))

    def prepend_child(self, child: Behaviour) -> uuid.UUID:
        raise TypeError(_NO_ROLE.format(child.name, self.name))

    def add_child(self, child: Behaviour) -> uuid.UUID:
        if hasattr(self, "orelse"):
            raise TypeError(_NO_ROLE.format(child.name, self.name))
        return super().add_child(child)  # the constructor's

    def replace_child(self, child: Behaviour, replacement: Behaviour) -> None:
        index = self.children.index(child)
        role = next(role for role in _ROLES if getattr(self, role) is child)
        is_current = self.current_child is child
        super().remove_child(child)
        super().insert_child(replacement, index)
        setattr(self, role, replacement)
        self.current_child = replacement if is_current else self.current_child

    def remove_child(self, child: Behaviour) -> int:
        if child is self.condition:
            raise TypeError(f"{self.name!r} is nothing without its condition {child.name!r}; replace it instead")
        role = next((role for role in _ROLES if getattr(self, role) is child), None)
        index = super().remove_child(child)
        if role is not None:
            setattr(self, role, None)
        return index

    def remove_all_children(self) -> None:
        self.remove_child(self.condition)  # which is refused

    def terminate(self, new_status: Status) -> None:
        if new_status is Status.INVALID:
            self.truth = None

    def tick(self) -> Iterator[Behaviour]:
        if self.status != Status.RUNNING:
            self._enter()
        if self.current_child is None:  # it was removed while it ran
            self.stop(Status.SUCCESS)
            yield self
            return
        if self.current_child is self.condition:
            yield from self.condition.tick()
            if self.condition.status == Status.RUNNING:
                self.status = Status.RUNNING
                yield self
                return
            outcome = self._judge()
            if outcome is not None:
                self.stop(outcome)
                yield self
                return
        assert self.current_child is not None
        yield from self.current_child.tick()
        self.feedback_message = self.current_child.feedback_message
        if self.current_child.status == Status.RUNNING:
            self.status = Status.RUNNING
        else:
            self.stop(self.current_child.status)
        yield self

    def _enter(self) -> None:
        for child in self.children:
            if child.status != Status.INVALID:
                child.stop(Status.INVALID)
        self.current_child = self.condition
        self.truth = None
        self.feedback_message = ""
        self.initialise()

    def _judge(self) -> Status | None:
        """Takes the condition's outcome down and moves on to its branch; the final status where there is none."""
        if _is_undecided(self.condition):
            self.feedback_message = f"cannot be decided: {undecorated(self.condition).feedback_message}"
            return Status.FAILURE
        self.truth = self.condition.status == Status.SUCCESS
        branch = self.branch
        if branch is None:
            self.feedback_message = "nothing was asked for in this case"
            return Status.SUCCESS
        self.current_child = branch
        return None


def undecorated(node: Behaviour) -> Behaviour:
    """The node that decorators stand around; itself where none does."""
    while isinstance(node, Decorator):
        node = node.decorated
    return node


def _is_undecided(condition: Behaviour) -> bool:
    """Whether a condition that has ended has come out neither way.

    The opposite of what cannot be known cannot be known either. A decorator that makes another status of it, such as
    FailureIsSuccess, has decided.
    """
    if isinstance(condition, Decorator):
        is_handed_on = condition.status == condition.decorated.status or isinstance(condition, Inverter)
        return is_handed_on and _is_undecided(condition.decorated)
    return condition.status == Status.FAILURE and getattr(condition, "is_undecided", False)
