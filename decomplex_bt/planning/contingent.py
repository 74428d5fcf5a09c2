"""The conditional plan: a plan for every task of a flow, from the state assumed on its branch (DeComplex, III-E).

Every task is pursued as it will be at run time, but in a world that is as it is assumed to be: things lie at their
likeliest places, a condition holds in its `then` branch and does not in its `else` branch, what is ordered is yet to be
done, and what earlier tasks have brought about stays so. Unlike in the paper, where a plan leads straight to a task's
goal, the looking around that a task takes is part of its plan. Tasks behind a condition are planned from the end of its
`then` branch.

What finds something out is planned up to the look that does, though at run time the answer may come into view before.
A check that is no condition is planned for either answer, and goes on from yes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from decomplex_bt.flow import If, Node
from decomplex_bt.instruction import escaped
from decomplex_bt.planning.assumed_world import AssumedWorld
from decomplex_bt.planning.assumptions import assume, assume_due
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.ground_task import FINDING_OUT, GroundInstruction, GroundTask
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.planner import Planner
from decomplex_bt.planning.prior import Prior
from decomplex_bt.planning.pursuit import Bindings, PursuitStatus


@dataclass(frozen=True, slots=True)
class TaskPlan:
    """The plan of one task. `reason` says why it fails where it is assumed to, "" where it is done.

    `otherwise`: of a check that is no condition, its plan where the answer is no, with the answer as its `reason`; both
    answers are as good.
    """

    task: int
    type: str
    phrase: str
    steps: tuple[GroundAction, ...]
    reason: str = ""
    otherwise: TaskPlan | None = None

    @property
    def senses(self) -> bool:
        """Whether it finds something out, and changes nothing."""
        return self.type in FINDING_OUT

    def to_json(self) -> dict[str, Any]:
        """Plain values, keys in this order; those that are false or empty are left out, but for the steps."""
        value: dict[str, Any] = {"task": self.task, "type": self.type, "phrase": self.phrase}
        value["steps"] = [str(step) for step in self.steps]
        value |= {"senses": True} if self.senses else {}
        value |= {"if_not": self.otherwise.to_json()} if self.otherwise is not None else {}
        return {**value, "reason": self.reason} if self.reason else value


@dataclass(frozen=True, slots=True)
class Choice:
    """A condition: its plan where it holds and where it does not, and what follows then."""

    holds: TaskPlan
    fails: TaskPlan
    then: tuple[PlanNode, ...] = ()
    orelse: tuple[PlanNode, ...] = ()

    def to_json(self) -> dict[str, Any]:
        return {
            "if": self.holds.to_json(),
            "then": [node.to_json() for node in self.then],
            "if_not": self.fails.to_json(),
            "else": [node.to_json() for node in self.orelse],
        }


PlanNode = TaskPlan | Choice


@dataclass(frozen=True, slots=True)
class ConditionalPlan:
    """The plans of all tasks of an instruction, in the shape of its flow."""

    text: str
    nodes: tuple[PlanNode, ...]

    def to_json(self) -> dict[str, Any]:
        return {"text": self.text, "plan": [node.to_json() for node in self.nodes]}

    def __str__(self) -> str:
        return "\n".join(_lines(self.nodes, ""))


def plan_conditionally(
    instruction: GroundInstruction, planner: Planner, *, world: AssumedWorld, belief: Belief | None = None
) -> ConditionalPlan:
    """The conditional plan of an instruction in an assumed world (not changed), with people where they are said to be;
    without `belief` nothing was seen."""
    domain, said = world.domain, instruction.whereabouts()
    belief = belief.copy() if belief is not None else Belief(domain, prior=Prior.of(domain).with_people(said, domain))
    world = world.copy()
    for people, wheres in said:
        if (room := domain.room_of(wheres[0])) is not None:
            world.settle_place(next((p for p in people if world.places.get(p) == room), people[0]), room)
    start = _Branch(instruction, planner, world, belief, {})
    return ConditionalPlan(instruction.text, start.plan(instruction.flow.nodes))


@dataclass
class _Branch:
    """How things stand on one branch while it is being planned."""

    instruction: GroundInstruction
    planner: Planner
    world: AssumedWorld
    belief: Belief
    bindings: Bindings

    def plan(self, nodes: Sequence[Node]) -> tuple[PlanNode, ...]:
        return tuple(self._plan(node) for node in nodes)

    def _plan(self, node: Node) -> PlanNode:
        task = self.instruction.task(node.task)
        if not isinstance(node, If) and not _has_two_answers(task):
            return self._pursue(task)
        other = self._fork()
        assume(self.world, self.belief, task, holds=True)
        assume(other.world, other.belief, task, holds=False)
        holds, fails = self._pursue(task), other._pursue(task)
        if not isinstance(node, If):
            return holds if holds.reason else replace(holds, otherwise=fails)
        return Choice(holds, fails, self.plan(node.then), other.plan(node.orelse))

    def _fork(self) -> _Branch:
        return _Branch(self.instruction, self.planner, self.world.copy(), self.belief.copy(), self.bindings)

    def _pursue(self, task: GroundTask) -> TaskPlan:
        before = len(self.world.steps)
        if task.type not in FINDING_OUT:
            assume_due(self.world, self.belief, task)
        finds_out = task.type in FINDING_OUT or task.question is not None
        pursuit = self.world.run(task, self.belief, self.planner, self.bindings, up_to_looks=finds_out)
        self.bindings = pursuit.bindings
        has_held = pursuit.status is PursuitStatus.DONE and pursuit.truth is not False
        steps = tuple(self.world.steps[before:])
        return TaskPlan(task.number, task.type, task.phrase, steps, "" if has_held else pursuit.reason)


def _has_two_answers(task: GroundTask) -> bool:
    """Whether a task is done once it is known whether something is so: a check, a search through certain places."""
    return task.type == "check_state" or (task.type == "searching" and bool(task.objects and task.places))


# -- in words ---------------------------------------------------------------------------------------------------------


def _lines(nodes: Sequence[PlanNode], pad: str) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, TaskPlan):
            yield from _task_lines(node, pad, "")
            if node.otherwise is not None:
                yield from _answer_lines(node.otherwise, pad, is_apart=node.otherwise.steps != node.steps)
            continue
        yield from _task_lines(node.holds, pad, "if ")
        if node.then:
            yield f"{pad}then"
            yield from _lines(node.then, pad + "  ")
        if node.fails.steps != node.holds.steps:
            yield from _task_lines(node.fails, pad, "if not ")
        if node.orelse:
            yield f"{pad}else"
            yield from _lines(node.orelse, pad + "  ")


def _task_lines(plan: TaskPlan, pad: str, word: str) -> Iterator[str]:
    note = f"   ; {plan.reason}" if plan.reason else ""
    yield pad + escaped(f"{word}[{plan.task}] {plan.phrase} ({plan.type}){note}")
    yield from (f"{pad}  {step}" for step in plan.steps)
    if not plan.steps and not plan.reason:
        yield f"{pad}  ; in view already, nothing to do" if plan.senses else f"{pad}  ; already so, nothing to do"


def _answer_lines(no: TaskPlan, pad: str, *, is_apart: bool) -> Iterator[str]:
    """What a check that is no condition comes to where the answer is no."""
    if is_apart:
        yield from _task_lines(no, pad, "or ")
    answers = f" (yes, or {no.reason})" if no.reason else ""
    yield pad + escaped(f"  ; a check: done with either answer{answers}")
