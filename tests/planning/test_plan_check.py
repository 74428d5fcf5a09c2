"""What planners give is checked whole, once, before anything is done by it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.plan_check import checked
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.problem import belief_problem

DOMAIN = load_domain("household")
PROBLEM = belief_problem(Belief(DOMAIN), [Atom("powered-on", ("tv",))])
SWITCH = GroundAction("switch-on", ("tv",))


def plan(*steps):
    return PlanResult(PlanStatus.SOLVED, steps)


def test_a_plan_stays_as_it_is():
    result = replace(plan(GroundAction("move", ("hallway_floor", "tv", "living_room")), SWITCH), evaluations=7)
    assert checked(result, PROBLEM, DOMAIN) == result


@pytest.mark.parametrize("make", [list, iter, lambda steps: (step for step in steps)])
def test_the_steps_may_come_in_any_form_once(make):
    result = replace(plan(), steps=make([SWITCH]))
    assert checked(result, PROBLEM, DOMAIN) == plan(SWITCH)


def test_objects_in_a_list_can_be_remembered():
    (step,) = checked(plan(replace(SWITCH, objects=["tv"])), PROBLEM, DOMAIN).steps
    assert hash(step) == hash(SWITCH)


@pytest.mark.parametrize(
    ("result", "reason"),
    [
        (None, "the planner gave None, no PlanResult"),
        (replace(plan(SWITCH), status="solved"), "the status is 'solved'; expected a PlanStatus, as PlanStatus.SOLVED"),
        (replace(plan(), steps=None), "the steps are None; expected GroundActions, in their order"),
        (replace(plan(), steps="(switch-on tv)"), "the steps are '(switch-on tv)'; expected GroundActions"),
        (plan("(switch-on tv)"), "a step is '(switch-on tv)'; expected a GroundAction of a name and the names of"),
        (plan(GroundAction("switch-on", "tv")), "a step is GroundAction(name='switch-on', objects='tv'); expected"),
        (plan(GroundAction("switch-on", (3,))), "a step is GroundAction(name='switch-on', objects=(3,)); expected"),
        (plan(GroundAction("SWITCH-ON", ("tv",))), "(SWITCH-ON tv) is no action of this domain; one is 'chill'"),
        (plan(GroundAction("switch-on")), "(switch-on) has 0 objects; switch-on takes 1"),
        (plan(GroundAction("switch-on", ("moon",))), "(switch-on moon) is about 'moon', which is no object of this"),
        (plan(GroundAction("switch-on", ("study",))), "(switch-on study) has 'study', of the type 'room', in place of"),
        (plan(GroundAction("pick", ("tv", "apple"))), "(pick tv apple) has 'tv', of the type 'place', in place of a"),
        (plan(), "the plan has no steps, and (powered-on tv) does not hold yet"),
    ],
)
def test_what_cannot_be_carried_out_is_unsupported(result, reason):
    found = checked(result, PROBLEM, DOMAIN)
    assert (found.status, found.steps) == (PlanStatus.UNSUPPORTED, ())
    assert found.reason.startswith(reason)


def test_a_forbidden_step_is_unsupported():
    problem = replace(PROBLEM, forbidden=(SWITCH,))
    found = checked(plan(SWITCH), problem, DOMAIN)
    assert str(found) == "unsupported: (switch-on tv) must not be in the plan: it is one of problem.forbidden"


def test_without_a_step_what_holds_already_is_reached():
    problem = replace(PROBLEM, goal=PROBLEM.init[:1])
    assert checked(plan(), problem, DOMAIN) == plan()


def test_where_there_is_no_plan_its_steps_are_not_looked_at():
    given_up = PlanResult(PlanStatus.TIMEOUT, reason="slow")
    assert checked(replace(given_up, steps=None), PROBLEM, DOMAIN) == given_up
