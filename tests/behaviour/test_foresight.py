import pytest

from decomplex_bt.behaviour.foresight import leads_to_goal
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.problem import Problem

STEPS = (
    GroundAction("move", ("study_floor", "desk_drawer", "study")),
    GroundAction("open-up", ("desk_drawer",)),
    GroundAction("pick", ("pen_1", "desk_drawer")),
)
INIT = {"(at study_floor)", "(in-room study)", "(closed desk_drawer)", "(lies pen_1 desk_drawer)", "(hand-free)"}


def atom(text):
    predicate, *objects = text.strip("()").split()
    return Atom(predicate, tuple(objects))


def leads(init, steps=STEPS, goal="(holding pen_1)"):
    problem = Problem(load_domain("household").domain_pddl, (), tuple(sorted(map(atom, init))), (atom(goal),))
    return leads_to_goal(problem, steps)


def test_a_plan_leads_to_its_goal():
    assert leads(INIT)


@pytest.mark.parametrize(
    ("removed", "added"),
    [
        ("(lies pen_1 desk_drawer)", "(lies pen_1 desk)"),
        ("(closed desk_drawer)", "(open desk_drawer)"),
        ("(hand-free)", "(holding milk)"),
    ],
)
def test_a_changed_world_breaks_it(removed, added):
    assert not leads(INIT - {removed} | {added})


def test_the_rest_of_a_plan_counts_from_where_the_robot_is():
    on_the_way = INIT - {"(at study_floor)"} | {"(at desk)"}
    assert leads(on_the_way)
    assert leads(on_the_way - {"(closed desk_drawer)"} | {"(open desk_drawer)"}, STEPS[2:])


def test_a_step_that_needs_to_be_elsewhere_later_breaks_it():
    assert not leads(INIT, (STEPS[1], STEPS[0], STEPS[2], GroundAction("open-up", ("desk",))))


def test_no_steps_lead_to_a_goal_that_holds():
    assert leads(INIT, (), "(hand-free)")
    assert not leads(INIT, ())
