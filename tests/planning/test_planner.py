"""Problems and plans: small, sensible, the same in every process, and pyperplan kept inside."""

from __future__ import annotations

import hashlib
import logging
import os
import subprocess
import sys
from dataclasses import replace

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.problem import Problem, belief_problem, fact_name, fact_of
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain()
PLANNER = PyperplanPlanner()
GOALS = (
    "(has user pen_1)",
    "(hot soup)",
    "(has user cup_1) (has user book_1)",
    "(clean counter)",
    "(followed user study)",
)


def belief(**percept: object) -> Belief:
    made = Belief(DOMAIN)
    made.update(Percept(**{"room": "kitchen", "places": {"user": "living_room"}, **percept}))  # type: ignore[arg-type]
    return made


def atoms(text: str) -> tuple[Atom, ...]:
    return tuple(Atom(words[0], tuple(words[1:])) for words in (part.split() for part in text.strip("()").split(") (")))


def solve(goal: str, **percept: object) -> PlanResult:
    return PLANNER.solve(belief_problem(belief(**percept), atoms(goal)))


def test_a_plan_goes_and_fetches() -> None:
    assert [step.name for step in solve("(has user pen_1)").steps] == [
        *("move", "pass", "move", "pass", "move", "pick"),
        *("move", "pass", "move", "pass", "move", "give"),
    ]


@pytest.mark.parametrize(
    ("goal", "length"),
    [
        ("(hot soup)", 7),
        ("(carried cup_1) (carried plate_1)", 5),
        ("(has user cup_1) (has user book_1)", 18),
        ("(inspected desk_drawer)", 7),
        ("(told user)", 6),
        ("(empty trash_can)", 2),
        ("(clean counter)", 3),
        ("(cold milk)", 3),
        ("(in-room study)", 4),
    ],
)
def test_plans_make_no_detours(goal: str, length: int) -> None:
    assert len(solve(goal).steps) == length


def test_a_check_ends_in_a_sensing_step() -> None:
    steps = solve(f"(known {fact_name('temperature', 'coffee')})").steps
    assert str(steps[-1]) == "(sense temperature__coffee coffee counter)"
    assert fact_of("temperature__coffee") == ("temperature", "coffee")


def test_what_holds_needs_no_step() -> None:
    result = solve("(carried pen_1)", held="pen_1")
    assert (result.status, result.steps) == (PlanStatus.SOLVED, ())


def test_a_closed_door_is_opened_on_the_way() -> None:
    names = [str(s) for s in solve("(at bed)", states={("bedroom_door", "aperture"): "closed"}).steps]
    assert names[3] == "(open-up bedroom_door)"


def test_a_full_hand_is_emptied_onto_the_tray_not_into_the_bin() -> None:
    steps = solve("(empty trash_can)", held="rag").steps
    assert [step.name for step in steps] == ["move", "stow", "drain-place"]


def test_the_problem_holds_only_what_the_goal_can_touch() -> None:
    problem = belief_problem(belief(near=frozenset({"fridge"})), atoms("(carried milk)"))
    assert dict(problem.objects) == {"milk": "thing", "fridge": "place", "kitchen_floor": "place", "kitchen": "room"}
    assert Atom("at", ("fridge",)) in problem.init


def test_forbidden_steps_are_in_no_plan() -> None:
    made = belief()
    made.failed(GroundAction("heat", ("soup", "microwave")), "broken")
    result = PLANNER.solve(belief_problem(made, atoms("(hot soup)")))
    assert str(result.steps[-1]) == "(heat soup oven)"
    made.failed(GroundAction("heat", ("soup", "oven")), "broken")
    result = PLANNER.solve(belief_problem(made, atoms("(hot soup)")))
    assert result.status is PlanStatus.UNSOLVABLE
    assert "(hot soup)" in result.reason


def test_the_same_problem_is_solved_once() -> None:
    planner = PyperplanPlanner()
    first = planner.solve(belief_problem(belief(), atoms("(hot soup)")))
    again = planner.solve(belief_problem(belief(), atoms("(hot soup)")))
    assert first.seconds > 0
    assert again.seconds == 0
    assert again.steps == first.steps


def test_a_search_without_end_is_a_timeout() -> None:
    result = PyperplanPlanner(max_evaluations=3).solve(belief_problem(belief(), atoms("(has user pen_1)")))
    assert result.status is PlanStatus.TIMEOUT


def test_the_root_logger_is_left_as_it_was(caplog: pytest.LogCaptureFixture) -> None:
    before = list(logging.getLogger().handlers)
    with caplog.at_level(logging.DEBUG):
        PyperplanPlanner().solve(belief_problem(belief(), atoms("(hot soup)")))
    assert logging.getLogger().handlers == before
    assert not caplog.records


def test_plans_are_the_same_under_any_hash_seed() -> None:
    digests = {
        subprocess.run(
            [sys.executable, __file__],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("0", "1", "77")
    }
    assert len(digests) == 1
    assert digests != {""}


def test_a_problem_is_its_text() -> None:
    problem = belief_problem(belief(), atoms("(told user)"))
    assert problem == belief_problem(belief(), atoms("(told user)"))
    assert isinstance(problem, Problem)
    assert problem.text.startswith("(define (problem task)")


if __name__ == "__main__":
    plans = "\n".join(str(solve(goal)) for goal in GOALS)
    print(hashlib.sha256(plans.encode()).hexdigest())


def test_a_problem_is_of_the_domain_that_it_is_given() -> None:
    problem = belief_problem(belief(), atoms("(at study_floor)"))
    assert "(:domain household)" in problem.text
    other = replace(problem, domain_pddl=problem.domain_pddl.replace("(domain household)", "(domain workshop)"))
    assert "(:domain workshop)" in other.text
    assert PLANNER.solve(other).is_solved


def test_plans_of_another_domain_are_not_remembered_for_this_one() -> None:
    problem = belief_problem(belief(), atoms("(at study_floor)"))
    planner = PyperplanPlanner()
    assert "move" in {step.name for step in planner.solve(problem).steps}
    other = replace(problem, domain_pddl=problem.domain_pddl.replace("(:action move", "(:action stroll"))
    assert "stroll" in {step.name for step in planner.solve(other).steps}
