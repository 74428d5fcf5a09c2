"""The agent: understands an instruction, compiles its tree, and ticks it against a Gymnasium environment."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, SupportsIndex

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence as InOrder
from py_trees.decorators import Decorator
from py_trees.trees import BehaviourTree

from decomplex_bt.behaviour.compiler import CompiledTree, compile_flow
from decomplex_bt.behaviour.conditional import IfThenElse, undecorated
from decomplex_bt.behaviour.embodiment import Embodiment
from decomplex_bt.behaviour.export import TraceRecorder
from decomplex_bt.behaviour.failure import Failure
from decomplex_bt.behaviour.planned_task import PlannedTask
from decomplex_bt.behaviour.session import Session
from decomplex_bt.behaviour.settling import Ask, check_ask, check_threshold, settle, understood, with_tasks
from decomplex_bt.corpus import Example
from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.sentences import say_task
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import Instruction, Task, check_instruction
from decomplex_bt.phrases import spoken
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.distribution import distributed
from decomplex_bt.planning.ground_task import HERE, GroundInstruction, GroundTask
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.planner import Planner
from decomplex_bt.planning.prior import Prior
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner
from decomplex_bt.understanding.doubt import THRESHOLD

LAST_TICKS = 3
"""Ticks in which an agent takes in with what the episode has ended; some things it believes only at second sight."""


@dataclass(frozen=True)
class _Episode:
    """What an agent goes by from one reset to the next."""

    instruction: Instruction
    grounded: GroundInstruction
    compiled: CompiledTree
    session: Session
    tree: BehaviourTree


class TreeAgent:
    """Carries an instruction out with a behaviour tree.

    `env`: an environment whose `embodiment()` makes a body; nothing else of it is used, and nothing of it is kept.
    `flow`: an annotated instruction (or corpus example) to go by instead of understanding the text. `ask`: answers a
    question for what the instruction does not say (None: such an instruction is an error), and for what was meant where
    its control flow is less certain than `threshold`, from 0 (never) to 1 (None: the likeliest is done). The answers
    are for the robot alone; whose judge has no reading but the robot's settles the instruction first (`settle`) and
    gives both the same. `planner`: solves the PDDL problems of all tasks (`planning.planner.Planner`; None: pyperplan).

    Raises `InputError` for an environment without a body, for a `flow` that is no instruction, and for an `ask`,
    `threshold` or `planner` that is none.

    After `reset`: `instruction`, `grounded`, `tree` (a `py_trees.trees.BehaviourTree`), `compiled` (tree and flow, node
    by node), `session`; before it they raise `RuntimeError`. While it runs: `status`, `failures` with the reasons of
    failed tasks, `not_attempted` with what was to come behind them. `done` is true once the agent has sent its last
    action, which ends the episode, or the episode has ended without it. An agent cannot be copied or pickled, for its
    skills are under way: that is a `TypeError`.
    """

    def __init__(
        self,
        env: Any,
        *,
        flow: Instruction | Example | None = None,
        ask: Ask | None = None,
        threshold: float = THRESHOLD,
        planner: Planner | None = None,
    ) -> None:
        self._body = _body_of(env)
        _check(ask, threshold, planner)
        self._planner = planner or PyperplanPlanner()
        self._flow = _annotated(flow)
        self._ask = ask
        self._threshold = threshold
        self._episode: _Episode | None = None
        self._running: PlannedTask | None = None
        self._has_finished = self._has_concluded = False

    def __reduce_ex__(self, protocol: SupportsIndex) -> Any:
        """Refuses copying and pickling."""
        raise TypeError(
            "a TreeAgent cannot be copied or pickled, for its skills are under way; make another of the environment, "
            "TreeAgent(env), and reset it with what the environment's reset returned"
        )

    # -- the Gymnasium loop -------------------------------------------------------------------------------------------

    def reset(self, observation: Any, info: Mapping[str, Any]) -> None:
        """Begins an episode: understands `info["instruction"]`, grounds it and compiles the tree.

        Raises `InputError` for an instruction without a known task and for what is no observation of the body's
        environment, `UnknownWordError`, `ImpossibleGoalError` and `MissingArgumentError` for what cannot be grounded in
        this house; the agent then stays as it was.
        """
        if self._flow is None and "instruction" not in info:
            raise InputError("info has no instruction; give the info that reset of the environment returned")
        domain = self._body.domain
        instruction = with_tasks(self._flow or understood(str(info["instruction"]), domain), domain)
        if self._ask is not None:
            instruction = settle(instruction, self._ask, domain=domain, threshold=self._threshold)
        grounded = ground(instruction, domain)
        compiled = compile_instruction(instruction, grounded, domain)
        self._body.reset(observation)  # the last that may refuse
        prior = Prior.of(domain).told(grounded.named_places(), domain).with_people(grounded.whereabouts(), domain)
        session = Session(self._body, Belief(domain, prior=prior), self._planner)
        tree = BehaviourTree(compiled.root)
        tree.setup(session=session)
        self._episode = _Episode(instruction, grounded, compiled, session, tree)
        self._has_finished = self._has_concluded = False
        self._running = None

    def act(self, observation: Any) -> Any:
        """The action for this observation: ticks the tree once. The last action is the one that ends the episode.

        A tree that goes on without saying what to do, as a `Retry` whose child has just failed, rests for this tick.

        Raises `InputError` for what is no observation of the body's environment.
        """
        begun = self._begun
        if self._has_finished or self._has_concluded:
            return self._body.finish()
        self._tick(begun, observation)
        if begun.tree.root.status is Status.RUNNING:
            return self._body.rest() if begun.session.action is None else begun.session.action
        self._has_finished = True
        return self._body.finish()

    def _tick(self, begun: _Episode, observation: Any) -> None:
        """Ticks the tree once; where all that comes of it is an action of the leaf that runs, only that leaf."""
        begun.session.begin_tick(observation)
        tree, leaf = begun.tree, self._running
        is_alone = leaf is not None and not _is_watched(tree) and _is_led_to(leaf, tree)
        if leaf is not None and is_alone and leaf.work():
            tree.count += 1
            return
        tree.tick()
        self._running = _running_leaf(tree)

    def _conclude(self) -> None:
        """Takes in with what the episode has ended, where it did so before the tree knew: what its last step did."""
        ended = getattr(self._body, "ended", None)
        if ended is None or self._has_concluded or self._episode is None:
            return
        self._has_concluded = True
        for _ in range(LAST_TICKS):
            if self._has_finished or self.tree.root.status in (Status.SUCCESS, Status.FAILURE):
                return
            self._tick(self._episode, ended)
        if getattr(self._body, "is_out_of_time", False) and self.tree.root.status is Status.RUNNING:
            self.session.is_out_of_time = True
            self._tick(self._episode, ended)

    # -- how it stands ------------------------------------------------------------------------------------------------

    @property
    def flow(self) -> Instruction | None:
        """The annotated instruction that it was given to go by; None where it understands the text itself."""
        return self._flow

    @property
    def instruction(self) -> Instruction:
        """What the agent goes by."""
        return self._begun.instruction

    @property
    def grounded(self) -> GroundInstruction:
        """The instruction in the house's names."""
        return self._begun.grounded

    @property
    def compiled(self) -> CompiledTree:
        """Tree and flow, node by node."""
        return self._begun.compiled

    @property
    def tree(self) -> BehaviourTree:
        """The tree that `act` ticks."""
        return self._begun.tree

    @property
    def session(self) -> Session:
        """What the leaves share: belief, bindings, plan counts."""
        return self._begun.session

    @property
    def plans(self) -> int:
        """Plans asked for in this episode."""
        return self.session.plans

    @property
    def replans(self) -> int:
        """Those of them that a task asked for because an earlier one had not brought it about."""
        return self.session.replans

    @property
    def _begun(self) -> _Episode:
        if self._episode is None:
            raise RuntimeError("call reset(observation, info) first")
        return self._episode

    @property
    def done(self) -> bool:
        """Whether the agent has sent its last action, or the episode has ended before it did.

        Where it has, the first look at this, `status`, `failures` or `branches()` ticks the tree with what was last
        observed, which nobody hands to `act` any more; further looks change nothing.
        """
        self._conclude()
        return self._has_finished or self._has_concluded

    @property
    def status(self) -> Status:
        """The status of the tree's root: INVALID before the first action, then RUNNING, in the end SUCCESS or FAILURE.

        With what the episode has ended is taken in. Where that was the time limit, the task at work fails, and the
        status is FAILURE. A tree that is still RUNNING then was interrupted by a violation, or by a judge who was
        content with less; which of the two, the judge alone knows.
        """
        self._conclude()
        if self._episode is None:
            return Status.INVALID
        status = self.tree.root.status  # RUNNING where a decorator, as `Retry`, would go on if it had the time
        return Status.FAILURE if status is Status.RUNNING and self.session.is_out_of_time else status

    @property
    def failures(self) -> tuple[Failure, ...]:
        """Why tasks failed, in order; empty where none did. A condition that is false is no failure."""
        self._conclude()
        return tuple(self.session.failures)

    @property
    def not_attempted(self) -> tuple[Failure, ...]:
        """The tasks that were still to come when a failed one ended the instruction, in order; empty where none did.

        Of a condition that was not reached it is the condition alone: nobody knows which of its branches was due.
        Raises `RuntimeError` before the first `reset`, as `failures` does.
        """
        root = self.tree.root
        return tuple(map(_not_attempted, _unreached(root))) if self.status is Status.FAILURE else ()

    def branches(self) -> tuple[tuple[int, bool | None, str | None], ...]:
        """The conditions judged so far, in order: the task, whether it held (None: undecided), the branch taken.

        Where decorators stand around the condition, whether the task held is what the task itself came to, and the
        branch the one that the tree took: under an `Inverter` that is the other one.

        Raises `RuntimeError` before the first `reset`, as `failures` does.
        """
        nodes = self.compiled.nodes
        self._conclude()
        judged = []
        for path, node in sorted(nodes.items()):
            if isinstance(node, IfThenElse) and node.condition.status in (Status.SUCCESS, Status.FAILURE):
                leaf, compiled = undecorated(node.condition), nodes[*path, "if"]
                if isinstance(leaf, PlannedTask):
                    judged.append((leaf.task.number, leaf.truth, node.taken))
                elif isinstance(compiled, PlannedTask):  # what stands in its place has no task of its own
                    judged.append((compiled.task.number, node.truth, node.taken))
        return tuple(judged)

    def record(self) -> TraceRecorder:
        """A recorder of all that changes in the tree from now on (`run --json`)."""
        session = self.session
        recorder = TraceRecorder(
            self.compiled, clock=lambda: session.belief.percept.seconds, tick=lambda: self.tree.count
        )
        self.tree.add_visitor(recorder)
        return recorder


def _body_of(env: Any) -> Embodiment:
    try:
        make_body: Callable[[], Embodiment] = env.get_wrapper_attr("embodiment")
    except AttributeError:
        name = env.spec.id if getattr(env, "spec", None) is not None else type(env).__name__
        raise InputError(
            f"{name} has no embodiment() to make a body of; give TreeAgent a household, as decomplex_bt/Household-v0"
        ) from None
    return make_body()


def _check(ask: Any, threshold: Any, planner: Any) -> None:
    if ask is not None:
        check_ask(ask)
    if planner is not None and not callable(getattr(planner, "solve", None)):
        raise InputError(f"planner is {planner!r}; expected something with a method solve(problem), or None")
    check_threshold(threshold)


def _annotated(flow: Any) -> Instruction | None:
    if flow is None:
        return None
    instruction = flow.instruction if isinstance(flow, Example) else flow
    if isinstance(instruction, Instruction):
        return check_instruction(instruction)
    raise InputError(f"flow is a {type(flow).__name__}; expected an annotated Instruction or a corpus Example")


def compile_instruction(instruction: Instruction, grounded: GroundInstruction, domain: Domain) -> CompiledTree:
    """The tree of a grounded instruction, its nodes named by sentences; it is set up with a session before it ticks."""
    instruction = distributed(instruction)
    tasks = {task.number: task for task in grounded.tasks}
    prepositions = domain.lexicon.prepositions
    names = {
        task.id: say_task(
            _as_spoken(task, instruction),
            domain.ontology,
            verb=instruction.verb_of(task).span.of(instruction.text),
            state=_spoken_state(tasks[task.id], task),
            prepositions=prepositions,
        )
        for task in instruction.tasks
    }
    return compile_flow(
        grounded.flow,
        names,
        lambda name, number, is_condition: PlannedTask(name, tasks[number], is_condition=is_condition),
        title=instruction.text,
    )


def _is_watched(tree: BehaviourTree) -> bool:
    """Whether somebody wants to know of every node that is ticked."""
    return bool(tree.visitors or tree.pre_tick_handlers or tree.post_tick_handlers)


def _running_leaf(tree: BehaviourTree) -> PlannedTask | None:
    """The leaf that runs, where nothing but its work comes of a tick."""
    leaf = tree.root.tip() if tree.root.status is Status.RUNNING else None
    return leaf if isinstance(leaf, PlannedTask) and _is_led_to(leaf, tree) else None


def _is_led_to(leaf: PlannedTask, tree: BehaviourTree) -> bool:
    """Whether a leaf runs and all nodes from the root of the tree, as it is now, to the leaf hand its status on and
    remember where they are."""
    if leaf.status is not Status.RUNNING:
        return False
    node: Any = leaf
    while node is not tree.root:
        above = node.parent
        is_passing = (type(above) is InOrder and above.memory) or isinstance(above, IfThenElse)
        if not is_passing or above.current_child is not node:
            return False
        node = above
    return True


def _unreached(node: Behaviour) -> Iterator[GroundTask]:
    """The tasks below a node that it never came to, without those of branches that its conditions did not lead to."""
    if isinstance(node, PlannedTask):
        if node.status is Status.INVALID:
            yield node.task
        return
    below: list[Behaviour] = []
    if isinstance(node, IfThenElse):
        below = [child for child in (node.condition, node.branch) if child is not None]
    elif isinstance(node, InOrder) or (isinstance(node, Decorator) and not _has_stopped(node)):
        below = node.children
    for child in below:
        yield from _unreached(child)


def _has_stopped(decorator: Decorator) -> bool:
    """Whether a decorator that was ticked has cut short what it stands around, as `Timeout` does."""
    return decorator.status is not Status.INVALID and decorator.decorated.status is Status.INVALID


def _not_attempted(task: GroundTask) -> Failure:
    return Failure("execution", task.number, task.span, action=None, expected="", observed="not attempted")


def _as_spoken(task: Task, instruction: Instruction) -> Task:
    """The task with its places as they are said where they are named."""
    places = ("goal", "source", "location")
    said = (replace(a, value=spoken(instruction, a, task)) if a.type in places else a for a in task.arguments)
    return replace(task, arguments=tuple(said))


def _spoken_state(grounded: GroundTask, task: Task) -> str | None:
    """The state as it belongs into a sentence; that something is there is said without a word, that it is not with one:
    "gone", "gone from the table", "not in the kitchen"."""
    if grounded.state != HERE or not grounded.is_denied:
        return None if grounded.state == HERE else grounded.state
    where = task.value("location")
    return "gone" if where is None or where.startswith(("from ", "out of ")) else "not"
