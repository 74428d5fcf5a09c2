"""The leaf of a task: finds out what to bring about, plans it, carries the plan out step by step, and plans again."""

from __future__ import annotations

from typing import Any

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from decomplex_bt.behaviour.embodiment import Skill, SkillStatus
from decomplex_bt.behaviour.failure import Failure, Stage
from decomplex_bt.behaviour.session import Fingerprint, Session
from decomplex_bt.planning.ground_task import GroundTask
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.planner import PlanStatus
from decomplex_bt.planning.pursuit import Pursuit, PursuitStatus, pursue

MAX_PLANS = 60
"""Plans for one task after which the leaf gives up: each place searched takes one or two."""
MAX_ROUNDS = 30
"""Decisions within one tick; only a planner and a belief that contradict each other need so many."""
PATIENCE_TICKS = 5
"""Ticks to wait for the effect of a finished plan to be perceived."""

COMMITTED = ("follow", "tag-along")
"""Actions under way that are not given up for what is believed meanwhile: a person who leads the way is lost from sight
now and then, and not where they were."""
OUT_OF_TIME = "the time was up"
UNDECIDABLE_TYPES = ("check_state", "searching")
"""Types of tasks that, given up, are neither true nor false as a condition."""


class PlannedTask(Behaviour):
    """One task of an instruction as a leaf.

    As a plain step it succeeds when the task is done. As a condition it succeeds when the task is true and fails when
    it is false; where it is neither, it fails with `is_undecided`. Construct it from plain values; `setup` hands it the
    session. A tick asks the belief what is due, plans where needed, and ticks one skill: at most one action a tick.
    """

    def __init__(self, name: str, task: GroundTask, *, is_condition: bool = False) -> None:
        super().__init__(name)
        self.task = task
        self.is_condition = is_condition
        self._session: Session | None = None
        self._said: Any = None
        self._outcome: Status | None = None
        self._clear()

    # -- the four hooks of py_trees -----------------------------------------------------------------------------------

    def setup(self, **kwargs: Any) -> None:
        """Takes the `session`. Raises `KeyError` without one."""
        self._session = kwargs["session"]

    def initialise(self) -> None:
        """The task has become due: forgets the last run."""
        self._clear()
        self._since = self.session.belief.tick

    def update(self) -> Status:
        """A tick's work, unless `work` has done it for this tick."""
        outcome = self._outcome
        self._outcome = None
        return self._work() if outcome is None else outcome

    def work(self) -> bool:
        """Does a tick's work ahead of the tick of the tree, for a leaf that is RUNNING; whether it goes on as before.

        Then nothing in the tree changes by being ticked. Else the tree is to be ticked, and learns of what came of it.
        """
        shown = self.feedback_message
        self._outcome = self._work()
        if self._outcome is not Status.RUNNING or shown != self.feedback_message:
            return False
        self._outcome = None
        return True

    def _work(self) -> Status:
        session = self.session
        if session.belief.tick == 0:
            raise RuntimeError(
                f"{self.name!r} was ticked before there was an observation; call agent.act(observation), "
                "or agent.session.begin_tick(observation) before each agent.tree.tick()"
            )
        if session.is_out_of_time:
            self.feedback_message = OUT_OF_TIME
            return self._fail("execution", self.step, OUT_OF_TIME)
        for _ in range(MAX_ROUNDS):
            # The skill first: that its step is done must be known before the plan is looked at again.
            action = self._tick_skill() if self._skill is not None else None
            if self._revision != session.belief.revision:
                status = self._consider()
                if status is not None:
                    return status
            if self._skill is None:
                action = self._go_on()
            if action is not None:
                session.action = self._said = action
                return Status.RUNNING
        session.action = session.embodiment.rest()
        return Status.RUNNING

    def terminate(self, new_status: Status) -> None:
        """Stops the skill at once; interrupted, the body comes to rest unless somebody else has use for it."""
        action = self._drop_plan()
        is_free = action is not None and (self.session.action is None or self.session.action is self._said)
        if new_status == Status.INVALID and is_free:
            self.session.action = action

    # -- what is seen from outside ------------------------------------------------------------------------------------

    @property
    def session(self) -> Session:
        if self._session is None:
            raise RuntimeError(f"{self.name!r} was ticked before setup(session=...)")
        return self._session

    @property
    def step(self) -> GroundAction | None:
        """The step of the plan that is being carried out."""
        return self._steps[self._position] if self._position < len(self._steps) else None

    # -- one tick's work ----------------------------------------------------------------------------------------------

    def _clear(self) -> None:
        self._outcome = None
        self.is_undecided = False
        self.truth: bool | None = None
        self.feedback_message = ""
        self._since = 0
        self._revision = -1
        self._pursuit = Pursuit(PursuitStatus.ONGOING)
        self._has_plan = False
        self._steps: tuple[GroundAction, ...] = ()
        self._known: Fingerprint = ()
        self._goal: tuple[Atom, ...] = ()
        self._position = 0
        self._skill: Skill | None = None
        self._said = None
        self._waited = 0
        self._attempts = 0
        self._last_problem: tuple[GroundAction | None, str] = (None, "")

    def _consider(self) -> Status | None:
        """Asks what the task needs by what is believed now; the leaf's status if the task is over."""
        session = self.session
        self._revision = session.belief.revision
        pursuit = pursue(self.task, session.belief, session.bindings, since=self._since)
        if pursuit.status is not PursuitStatus.DONE and self._is_committed():
            return None
        self._pursuit = pursuit
        session.bindings = pursuit.bindings
        if pursuit.status is not PursuitStatus.ONGOING:
            return self._finish(pursuit)
        if self._attempts >= MAX_PLANS:
            is_open = self.task.type in UNDECIDABLE_TYPES or session.belief.unanswered(self._goal, since=self._since)
            truth = None if is_open else False
            reason = f"gave up after {self._attempts} plans: {self._last_problem[1] or pursuit.doing}"
            return self._finish(Pursuit(PursuitStatus.FAILED, truth=truth, reason=reason))
        if self._has_plan and (pursuit.goal_atoms != self._goal or not self._still_works()):
            self._drop_plan()
        return None

    def _go_on(self) -> Any:
        """Plans if need be and begins the next step; its first action, None where the belief has to be asked again."""
        if not self._has_plan and not self._make_plan():
            return None
        step = self.step
        if step is None:
            return self._await_effect()
        self._skill = self.session.embodiment.skill(step)
        return self._tick_skill()

    def _make_plan(self) -> bool:
        session = self.session
        if self._goal != self._pursuit.goal_atoms:
            self._goal, self._last_problem = self._pursuit.goal_atoms, (None, "")
        result = session.plan(self._goal, self.task.forbidden)
        self._attempts += 1
        session.replans += self._attempts > 1
        if result.status is not PlanStatus.SOLVED:
            is_final = result.status.is_final
            if self._last_problem[0] is None or not is_final:
                self._last_problem = (None, str(result))
            session.belief.give_up(self._goal, str(result), is_final=is_final)
            return False
        self._has_plan, self._steps, self._position, self._waited = True, tuple(result.steps), 0, 0
        self._known = session.fingerprint(self._steps)
        self._show()
        return True

    def _tick_skill(self) -> Any:
        """Ticks the skill; its action while it runs, None when it has ended, which the belief is told."""
        assert self._skill is not None
        session = self.session
        tick = self._skill.tick(session.observation)
        if tick.status is SkillStatus.RUNNING:
            return tick.action
        step, self._skill = self._steps[self._position], None
        if tick.status is SkillStatus.SUCCESS:
            self._position += 1
            session.belief.succeeded(step)
            self._show()
        else:
            self._last_problem = (step, tick.reason)
            session.belief.failed(step, tick.reason)
            self._drop_plan()
        return None

    def _await_effect(self) -> Any:
        """The plan is through and the task is not: waits for the effect to be perceived, then plans again."""
        if self._waited < PATIENCE_TICKS:
            self._waited += 1
            return self.session.embodiment.rest()
        last = self._steps[-1] if self._steps else None
        self._last_problem = (last, "its effect did not show")
        if last is None:
            reason = "what was planned for holds already, and the task is not done"
            self._last_problem = (None, reason)
            self.session.belief.give_up(self._goal, reason)
        else:
            self.session.belief.failed(last, "its effect did not show")
        self._drop_plan()
        return None

    def _is_committed(self) -> bool:
        return self._skill is not None and self.step is not None and self.step.name in COMMITTED

    def _still_works(self) -> bool:
        """Whether the rest of the plan still leads to the goal; looked into when something it is about has changed."""
        known = self.session.fingerprint(self._steps)
        if known == self._known:
            return True
        self._known = known
        return self.session.still_works(self._goal, self._steps[self._position :])

    def _drop_plan(self) -> Any:
        """Forgets the plan; the action that ends its running skill, None if there was none."""
        skill, self._skill = self._skill, None
        self._has_plan, self._steps, self._position, self._waited = False, (), 0, 0
        return skill.stop() if skill is not None else None

    def _finish(self, pursuit: Pursuit) -> Status:
        self.truth = pursuit.truth
        is_good = pursuit.truth is True if self.is_condition else pursuit.status is PursuitStatus.DONE
        if is_good:
            self.feedback_message = "done"
            return Status.SUCCESS
        self.feedback_message = pursuit.reason
        if self.is_condition and pursuit.truth is False:
            return Status.FAILURE
        step, problem = self._last_problem
        has_tried = step is not None and not pursuit.gave_up
        observed = pursuit.reason or problem or "nothing is left to try"
        if not has_tried and not pursuit.gave_up and problem not in observed:
            observed += f"; the planner: {problem}"
        return self._fail("execution" if has_tried else "planning", step if has_tried else None, observed)

    def _fail(self, stage: Stage, action: GroundAction | None, observed: str) -> Status:
        """Takes down why the task failed; as a condition it is then neither true nor false."""
        self.is_undecided = self.is_condition
        expected = " ".join(str(atom) for atom in self._goal)
        self.session.failures.append(
            Failure(stage, self.task.number, self.task.span, action, expected, observed, self._attempts)
        )
        return Status.FAILURE

    def _show(self) -> None:
        step = self.step
        if step is not None:
            self.feedback_message = f"{step} ({self._position + 1} of {len(self._steps)}): {self._pursuit.doing}"
