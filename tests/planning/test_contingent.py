"""The conditional plan: a plan for each task from the state assumed on its branch."""

from __future__ import annotations

from dataclasses import replace

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.planning.assumed_world import AssumedWorld
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.contingent import Choice, ConditionalPlan, TaskPlan, plan_conditionally
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.prior import Prior
from decomplex_bt.planning.problem import Problem
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain()
COFFEE = (
    "If [the coffee](1:object) [is](1:check_state) [hot](1:state) [bring](2:bringing) [me](2:recipient) "
    "[it](2:object=the coffee), otherwise [heat](3:change_state) [it](3:object=the coffee). "
    "Then [go](4:motion) [to the study](4:goal)."
)


def plan(text: str, flow: list) -> ConditionalPlan:
    grounded = ground(read_markup(text, DOMAIN.ontology, flow=flow), DOMAIN)
    return plan_conditionally(grounded, PyperplanPlanner(), world=AssumedWorld.likely(DOMAIN))


def test_each_branch_is_planned_from_what_it_assumes() -> None:
    made = plan(COFFEE, [{"if": 1, "then": [2], "else": [3]}, 4])
    choice, last = made.nodes
    assert isinstance(choice, Choice)
    (bring,), (heat,) = choice.then, choice.orelse
    assert isinstance(bring, TaskPlan)
    assert isinstance(heat, TaskPlan)
    assert str(bring.steps[-1]) == "(give coffee user)"
    assert str(heat.steps[-1]) == "(heat coffee microwave)"
    assert choice.fails.reason == "the coffee is not hot"
    assert isinstance(last, TaskPlan)
    assert str(last.steps[0]) == "(move user living_room_doorway living_room)"


def test_what_is_said_to_be_somewhere_is_assumed_to_be_there() -> None:
    text = (
        "If [the cup](1:object) [is](1:check_state) [empty](1:state) [on the kitchen table](1:location), "
        "[fill](2:change_state) [it](2:object=the cup), otherwise [wash](3:change_state) [it](3:object=the cup)."
    )
    made = plan(text, [{"if": 1, "then": [2], "else": [3]}])
    (choice,) = made.nodes
    assert isinstance(choice, Choice)
    assert choice.fails.reason == "the cup is not empty"
    assert "(pick cup_1 kitchen_table)" in str(made)


@pytest.mark.parametrize(("who", "rooms"), [("Tom", ["living_room"]), ("Tom in the bathroom", ["bathroom"])])
def test_somebody_is_looked_for_first_where_they_are_said_to_be(who: str, rooms: list[str]) -> None:
    (tell,) = plan(f"[Tell](1:informing) [{who}](1:recipient) [hello](1:message)", [1]).nodes
    assert isinstance(tell, TaskPlan)
    assert [step.objects[2] for step in tell.steps if step.name == "pass" and step.objects[2] != "hallway"] == rooms


def test_who_is_not_where_they_are_said_to_be_is_looked_for_elsewhere() -> None:
    text = "[Tell](1:informing) [Tom in the bathroom](1:recipient) [hello](1:message)"
    grounded = ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN)
    belief = Belief(DOMAIN, prior=Prior.of(DOMAIN).with_people(grounded.whereabouts(), DOMAIN))
    inside = AssumedWorld.likely(DOMAIN)
    inside.places["tom"] = "study"
    told = inside.run(grounded.tasks[0], belief, PyperplanPlanner(), {})
    assert told.truth is True
    rooms = [step.objects[2] for step in inside.steps if step.name == "pass"]
    assert rooms.index("bathroom") < rooms.index("study")


def test_an_action_as_condition_fails_where_the_world_does_not_allow_it() -> None:
    text = "[Turn](1:change_state) on [the tv](1:object); if you cannot, [tell](2:informing) [me](2:recipient)"
    (choice,) = plan(text, [{"if": 1, "else": [2]}]).nodes
    assert isinstance(choice, Choice)
    assert choice.holds.reason == ""
    assert "broken" in choice.fails.reason


def test_it_says_itself_as_text_and_json() -> None:
    made = plan(COFFEE, [{"if": 1, "then": [2], "else": [3]}, 4])
    text = str(made)
    assert "if [1]" in text
    assert "else\n  [3] heat the coffee (change_state)" in text
    value = made.to_json()
    assert value["plan"][0]["then"][0]["steps"][-1] == "(give coffee user)"
    assert list(value["plan"][0]) == ["if", "then", "if_not", "else"]


def test_a_task_that_takes_no_step_says_why():
    text = "[Go](1:motion) [to the kitchen](1:goal) and [go](2:motion) [to the kitchen](2:goal)."
    assert str(plan(text, [1, 2])).splitlines()[-2:] == [
        "[2] go to the kitchen (motion)",
        "  ; already so, nothing to do",
    ]


def test_a_check_is_planned_up_to_its_look_and_for_either_answer():
    text = "[Check](1:check_state) if [the tv](1:object) is [on](1:state); [go](2:motion) [to the study](2:goal)."
    made = plan(text, [1, 2])
    check, go = made.to_json()["plan"]
    assert check["steps"][-1] == check["if_not"]["steps"][-1] == "(sense-place power__tv tv)"
    assert check["senses"] is True
    assert "reason" not in check
    assert check["if_not"]["reason"] == "the tv is not on"
    assert "senses" not in go
    assert "  ; a check: done with either answer (yes, or the tv is not on)" in str(made).splitlines()


def test_where_the_answers_part_both_ways_to_look_are_planned():
    text = "[Seek](1:searching) [the keys](1:object) [in the drawer](1:location)."
    said = str(plan(text, [1])).splitlines()
    assert said[0] == "[1] Seek the keys in the drawer (searching)"
    assert "or [1] Seek the keys in the drawer (searching)   ; the keys are not there" in said
    assert said.count("  (inspect drawer)") == 2
    assert said.count("  (inspect desk_drawer)") == 1


def test_what_must_be_found_has_one_end():
    (search,) = plan("[Look](1:searching) for [the pen](1:object).", [1]).nodes
    assert isinstance(search, TaskPlan)
    assert search.steps[-1].name == "inspect"
    assert search.otherwise is None


def test_a_condition_is_planned_up_to_its_look():
    text = "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) off."
    (choice,) = plan(text, [{"if": 1, "then": [2]}]).nodes
    assert isinstance(choice, Choice)
    assert str(choice.holds.steps[-1]) == str(choice.fails.steps[-1]) == "(sense-place power__tv tv)"


def test_what_is_in_view_from_the_first_takes_no_step():
    text = "[Check](1:check_state) whether [the front door](1:object) is [open](1:state)."
    assert "  ; in view already, nothing to do" in str(plan(text, [1])).splitlines()


def test_what_is_told_is_looked_at_first():
    text = "[Tell](1:informing) [me](1:recipient) [whether the tv is on](1:message)."
    (told,) = plan(text, [1]).nodes
    assert isinstance(told, TaskPlan)
    steps = [str(step) for step in told.steps]
    assert steps.index("(sense-place power__tv tv)") < steps.index("(say user)")


def test_an_action_that_nobody_simulates_is_named_as_the_reason():
    domain = replace(DOMAIN, domain_pddl=DOMAIN.domain_pddl.replace("(:action say", "(:action shout"))
    text = "[Tell](1:informing) [Anna](1:recipient) [that dinner is ready](1:message)."
    grounded = ground(read_markup(text, domain.ontology, flow=[1]), domain)

    with pytest.raises(InputError, match="an action that the robot has no skill for"):
        plan_conditionally(grounded, PyperplanPlanner(), world=AssumedWorld.likely(domain))


class GivesUp:
    def solve(self, problem: Problem) -> PlanResult:
        return PlanResult(PlanStatus.TIMEOUT, reason="slow")


def test_a_planner_that_gives_up_is_named_as_the_reason():
    grounded = ground(read_markup("[Take](1:taking) [the apple](1:object).", DOMAIN.ontology, flow=[1]), DOMAIN)
    (plan,) = plan_conditionally(grounded, GivesUp(), world=AssumedWorld.likely(DOMAIN)).nodes
    assert isinstance(plan, TaskPlan)
    assert "timeout: slow" in plan.reason
    assert "nowhere" not in plan.reason
