"""The leaf against scripted skills, a scripted planner and scripted decisions; the belief is the real one."""

from dataclasses import dataclass, field

import pytest
from py_trees.common import Status

from decomplex_bt.behaviour import planned_task
from decomplex_bt.behaviour.embodiment import SkillStatus, SkillTick
from decomplex_bt.behaviour.planned_task import MAX_PLANS, PlannedTask
from decomplex_bt.behaviour.session import Session
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.ground_task import GroundTask
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.pursuit import Pursuit, PursuitStatus

TASK = GroundTask(3, "taking", "take a pen", span=(4, 8))
GOAL = (Atom("holding", ("pen_1",)),)
MOVE = GroundAction("move", ("hallway_floor", "desk", "study"))
PICK = GroundAction("pick", ("pen_1", "desk"))
ONGOING = Pursuit(PursuitStatus.ONGOING, GOAL, doing="take the pen")
DONE = Pursuit(PursuitStatus.DONE, truth=True)


class ScriptedSkill:
    """Runs `ticks` ticks, then ends well, or with `reason`."""

    def __init__(self, step, ticks=1, reason=""):
        self.step, self.left, self.reason, self.stopped = step, ticks, reason, False

    def tick(self, observation):
        if self.left > 0:
            self.left -= 1
            return SkillTick(SkillStatus.RUNNING, f"do {self.step.name}")
        return SkillTick(SkillStatus.FAILURE if self.reason else SkillStatus.SUCCESS, "rest", self.reason)

    def stop(self):
        self.stopped = True
        return "rest"


@dataclass
class ScriptedBody:
    domain: object
    reasons: dict = field(default_factory=dict)
    ticks: int = 1
    made: list = field(default_factory=list)

    def skill(self, step):
        reasons = self.reasons.get(step.name, [])
        self.made.append(ScriptedSkill(step, self.ticks, reasons.pop(0) if reasons else ""))
        return self.made[-1]

    def perceive(self, observation):
        return Percept(room="hallway", places=observation or {})

    def rest(self):
        return "rest"


@dataclass
class ScriptedPlanner:
    results: list
    asked: int = 0

    def solve(self, problem):
        self.asked += 1
        return self.results.pop(0) if len(self.results) > 1 else self.results[0]


def plan(*steps):
    return PlanResult(PlanStatus.SOLVED, steps)


@pytest.fixture
def make(monkeypatch):
    """Makes a leaf in a session; `decide(belief)` stands in for what the task needs next."""

    def build(decide, results=(plan(MOVE, PICK),), *, is_condition=False, task=TASK, **body):
        monkeypatch.setattr(planned_task, "pursue", lambda task, belief, bindings, since: decide(belief))
        domain = load_domain("household")
        session = Session(ScriptedBody(domain, **body), Belief(domain), ScriptedPlanner(list(results)))
        leaf = PlannedTask("take a pen", task, is_condition=is_condition)
        leaf.setup(session=session)
        return leaf, session

    return build


def run(leaf, session, observations=(None,) * 30):
    """Ticks the leaf until it ends; the actions it sent."""
    actions = []
    for observation in observations:
        session.begin_tick(observation)
        leaf.tick_once()
        if leaf.status != Status.RUNNING:
            break
        actions.append(session.action)
    return actions


def after(count):
    """Decides that the task is done once so many steps have succeeded."""

    def decide(belief):
        return DONE if getattr(belief, "count", 0) >= count else ONGOING

    return decide


def count_successes(session):
    note = session.belief.succeeded

    def succeeded(step):
        session.belief.count = getattr(session.belief, "count", 0) + 1
        note(step)

    session.belief.succeeded = succeeded


def test_it_carries_out_the_plan_one_action_a_tick_and_says_where_it_is(make):
    leaf, session = make(after(2), ticks=2)
    count_successes(session)
    session.begin_tick(None)
    leaf.tick_once()
    assert leaf.feedback_message == "(move hallway_floor desk study) (1 of 2): take the pen"
    assert run(leaf, session) == ["do move", "do pick", "do pick"]
    assert leaf.status == Status.SUCCESS
    assert session.planner.asked == 1


def test_a_task_that_is_done_already_sends_no_action(make):
    leaf, session = make(lambda belief: DONE)
    assert run(leaf, session) == []
    assert leaf.status == Status.SUCCESS
    assert session.action is None


def test_a_failed_step_is_told_to_the_belief_and_planned_again(make):
    leaf, session = make(after(3), reasons={"pick": ["it slipped"]})
    count_successes(session)
    assert run(leaf, session) == ["do move", "do pick", "do move", "do pick"]
    assert leaf.status == Status.SUCCESS
    assert (session.plans, session.replans) == (2, 1)


def test_a_contradicted_belief_stops_the_skill_and_plans_again(make):
    leaf, session = make(lambda belief: ONGOING, ticks=50)
    on_desk, on_couch = {"pen_1": "desk"}, {"pen_1": "couch"}
    run(leaf, session, [on_desk, on_desk, on_couch])
    assert session.planner.asked == 2
    assert [skill.stopped for skill in session.embodiment.made] == [True, False]


def test_what_does_not_matter_to_the_plan_leaves_it_alone(make):
    leaf, session = make(lambda belief: ONGOING, ticks=50)
    run(leaf, session, [{"pen_1": "desk"}, {"pen_1": "desk", "milk": "counter"}])
    assert session.planner.asked == 1


def test_a_new_goal_drops_the_plan(make):
    goals = {True: ONGOING, False: Pursuit(PursuitStatus.ONGOING, (Atom("inspected", ("desk",)),))}
    leaf, session = make(lambda belief: goals[belief.place_of("milk") is None], ticks=50)
    run(leaf, session, [{}, {"milk": "counter"}])
    assert session.planner.asked == 2


def test_without_a_plan_the_goal_is_given_up_and_the_failure_says_why(make):
    def decide(belief):
        reason = belief.given_up(GOAL, since=0)
        return Pursuit(PursuitStatus.FAILED, truth=False, reason=reason) if reason else ONGOING

    leaf, session = make(decide, [PlanResult(PlanStatus.UNSOLVABLE, reason="no way in")])
    assert run(leaf, session) == []
    assert leaf.status == Status.FAILURE
    (failure,) = session.failures
    assert (failure.stage, failure.task, failure.words, failure.action) == ("planning", 3, (4, 8), None)
    assert failure.observed == "unsolvable: no way in"
    assert failure.attempts == 1


@pytest.mark.parametrize(
    ("result", "said"),
    [
        (
            PlanResult(PlanStatus.TIMEOUT, reason="30 s are over"),
            "no way was found; the planner: timeout: 30 s are over",
        ),
        (PlanResult(PlanStatus.UNSUPPORTED), "no way was found; the planner: unsupported"),
        (
            PlanResult(PlanStatus.SOLVED, (GroundAction("pick", ("moon", "tv")),)),
            "no way was found; the planner: unsupported: (pick moon tv) is about 'moon', which is no object of this "
            "problem",
        ),
        (
            PlanResult(PlanStatus.SOLVED, (GroundAction("switch-on", ()),)),
            "no way was found; the planner: unsupported: (switch-on) has 0 objects; switch-on takes 1",
        ),
        ("a plan", "no way was found; the planner: unsupported: the planner gave 'a plan', no PlanResult"),
    ],
)
def test_what_the_planner_says_is_in_the_failure_whatever_the_task_makes_of_it(make, result, said):
    def decide(belief):
        is_over = belief.given_up(GOAL, since=0) is not None
        return Pursuit(PursuitStatus.FAILED, truth=False, reason="no way was found") if is_over else ONGOING

    leaf, session = make(decide, [result])
    run(leaf, session)
    assert [failure.observed for failure in session.failures] == [said]


def test_a_failed_step_is_in_the_failure(make):
    def decide(belief):
        is_over = bool(belief.blocked())
        return Pursuit(PursuitStatus.FAILED, truth=False, reason="the tv is broken") if is_over else ONGOING

    leaf, session = make(decide, reasons={"pick": ["it is broken"]})
    run(leaf, session)
    (failure,) = session.failures
    assert (failure.stage, failure.action, failure.expected) == ("execution", PICK, "(holding pen_1)")
    assert failure.to_json()["reason"] == "the tv is broken (expected: (holding pen_1))"


@pytest.mark.parametrize(
    ("pursuit", "is_condition", "status", "is_undecided", "failures"),
    [
        (Pursuit(PursuitStatus.DONE, truth=True), True, Status.SUCCESS, False, 0),
        (Pursuit(PursuitStatus.DONE, truth=False), True, Status.FAILURE, False, 0),
        (Pursuit(PursuitStatus.FAILED, truth=False), True, Status.FAILURE, False, 0),
        (Pursuit(PursuitStatus.FAILED, truth=None, reason="unseen"), True, Status.FAILURE, True, 1),
        (Pursuit(PursuitStatus.DONE, truth=False), False, Status.SUCCESS, False, 0),
        (Pursuit(PursuitStatus.FAILED, truth=None, reason="unseen"), False, Status.FAILURE, False, 1),
    ],
)
def test_as_a_condition_it_is_true_false_or_undecided(make, pursuit, is_condition, status, is_undecided, failures):
    leaf, session = make(lambda belief: pursuit, is_condition=is_condition)
    run(leaf, session)
    assert (leaf.status, leaf.is_undecided, len(session.failures)) == (status, is_undecided, failures)


def test_interrupted_it_stops_the_skill_and_comes_to_rest(make):
    leaf, session = make(lambda belief: ONGOING, ticks=50)
    run(leaf, session, [None])
    session.begin_tick(None)
    leaf.stop(Status.INVALID)
    assert session.embodiment.made[0].stopped
    assert session.action == "rest"


def test_it_does_not_plan_for_ever(make):
    leaf, session = make(lambda belief: ONGOING, reasons={"move": ["blocked"] * 1000})
    run(leaf, session, [None] * (3 * MAX_PLANS))
    assert leaf.status == Status.FAILURE
    assert session.planner.asked == MAX_PLANS
    assert "gave up" in session.failures[0].observed


@pytest.mark.parametrize(("status", "is_undecided"), [(PlanStatus.TIMEOUT, True), (PlanStatus.UNSOLVABLE, False)])
def test_a_condition_that_no_plan_was_found_for_is_false_only_where_there_is_none(make, status, is_undecided):
    leaf, session = make(lambda belief: ONGOING, [PlanResult(status)], is_condition=True)
    run(leaf, session, [None] * (3 * MAX_PLANS))
    assert (leaf.status, leaf.is_undecided, len(session.failures)) == (Status.FAILURE, is_undecided, is_undecided)


def test_a_plan_without_effect_counts_as_a_failed_step(make):
    failed = []
    leaf, session = make(lambda belief: ONGOING)
    session.belief.failed = lambda step, reason: failed.append((step.name, reason))
    actions = run(leaf, session, [None] * 10)
    assert actions[:3] == ["do move", "do pick", "rest"]
    assert failed[0] == ("pick", "its effect did not show")


def test_ticked_before_an_observation_it_says_what_comes_first(make):
    leaf, session = make(after(2))
    with pytest.raises(RuntimeError, match=r"begin_tick\(observation\) before each agent\.tree\.tick"):
        leaf.tick_once()
    session.begin_tick(None)
    leaf.tick_once()
    assert leaf.status == Status.RUNNING


def test_ticked_before_setup_it_says_so():
    with pytest.raises(RuntimeError, match="setup"):
        PlannedTask("take a pen", TASK).tick_once()
