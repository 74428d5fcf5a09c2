"""What a conditional plan assumes: orders are due, and its steps follow on one another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.assumed_world import AssumedWorld
from decomplex_bt.planning.contingent import Choice, PlanNode, TaskPlan, plan_conditionally
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner
from decomplex_bt.planning.schemas import ground_atoms, read_schemas

DOMAIN = load_domain()


def nodes(text: str, flow: list[Any], world: AssumedWorld | None = None) -> tuple[PlanNode, ...]:
    grounded = ground(read_markup(text, DOMAIN.ontology, flow=flow), DOMAIN)
    return plan_conditionally(grounded, PyperplanPlanner(), world=world or AssumedWorld.likely(DOMAIN)).nodes


def steps(text: str, world: AssumedWorld | None = None) -> list[str]:
    (plan,) = nodes(text, [1], world)
    assert isinstance(plan, TaskPlan)
    return [str(step) for step in plan.steps]


@pytest.mark.parametrize(
    ("text", "step"),
    [
        ("[Turn](1:change_state) [off](1:state) [the tv](1:object).", "(switch-off tv)"),
        ("[Close](1:change_state) [the window](1:object).", "(close-up kitchen_window)"),
        ("[Empty](1:change_state) [the trash can](1:object).", "(drain-place trash_can)"),
        ("[Wash](1:change_state) [the dirty plates](1:object).", "(rinse plate_2 sink)"),
        ("[Put](1:placing) [the milk](1:object) [in the fridge](1:goal).", "(place milk fridge)"),
        ("[Follow](1:following) [Anna](1:object) [to the kitchen](1:goal).", "(follow anna study kitchen)"),
        ("[Take](1:taking) [the pen](1:object) [from the bed](1:source).", "(pick pen_1 bed)"),
    ],
)
def test_what_is_ordered_is_yet_to_be_done(text: str, step: str) -> None:
    assert step in steps(text)


def test_all_of_what_is_ordered_is_yet_to_be_done() -> None:
    done = steps("[Close](1:change_state) [all the windows](1:object).")
    assert [step for step in done if "close-up" in step] == [
        f"(close-up {room}_window)" for room in ("kitchen", "living_room", "bedroom")
    ]


def test_what_was_told_of_a_world_stays_so() -> None:
    world = AssumedWorld.likely(DOMAIN)
    world.settle("tv", "power", "off")
    assert not any(
        "switch" in step for step in steps("[Turn](1:change_state) [off](1:state) [the tv](1:object).", world)
    )


def test_what_a_task_before_has_brought_about_is_not_done_again() -> None:
    text = (
        "[Turn](1:change_state) [off](1:state) [the tv](1:object), then [turn](2:change_state) [off](2:state) "
        "[the tv](2:object)."
    )
    first, second = nodes(text, [1, 2])
    assert isinstance(first, TaskPlan)
    assert isinstance(second, TaskPlan)
    assert str(first.steps[-1]) == "(switch-off tv)"
    assert second.steps == ()


def test_what_a_condition_says_is_so_in_its_branch() -> None:
    text = (
        "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) "
        "[on](2:state)."
    )
    (choice,) = nodes(text, [{"if": 1, "then": [2]}])
    assert isinstance(choice, Choice)
    (turn,) = choice.then
    assert isinstance(turn, TaskPlan)
    assert not any("switch" in str(step) for step in turn.steps)


TEXTS = {
    "[Bring](1:bringing) [me](1:recipient) [the phone](1:object).": [1],
    "[Bring](1:bringing) [me](1:recipient) [the cup, the apple, the pen and the book](1:object).": [1],
    "[Put](1:placing) [the apple](1:object) [in the fridge](1:goal), then [go](2:motion) [to the study](2:goal).": [
        1,
        2,
    ],
    "[Heat](1:change_state) [the soup](1:object) and [tell](2:informing) [Tom](2:recipient).": [1, 2],
    "If [Anna](1:object) [is](1:check_state) [in the study](1:location), [tell](2:informing) [her](2:recipient=Anna) "
    "[that dinner is ready](2:message), otherwise [close](3:change_state) [all the windows](3:object).": [
        {"if": 1, "then": [2], "else": [3]}
    ],
    "[Look](1:searching) [in the cupboard](1:location) [for the keys](1:object). If you cannot find them, "
    "[follow](2:following) [Tom](2:object).": [{"if": 1, "else": [2]}],
}


@pytest.mark.parametrize(("text", "flow"), TEXTS.items())
def test_steps_can_be_done_one_after_the_other_from_where_the_robot_is(text: str, flow: list[Any]) -> None:
    world = AssumedWorld.likely(DOMAIN)
    start = {Atom("at", (world.at,)), Atom("in-room", (world.room,))}
    paths = list(ways(nodes(text, flow, world), []))
    assert paths
    assert any(step.name == "move" for path in paths for step in path)
    for path in paths:
        follow(path, start)


def ways(plans: Sequence[PlanNode], before: list[GroundAction]) -> Iterator[list[GroundAction]]:
    """Every way through a conditional plan, as the steps that it takes."""
    if not plans:
        yield before
        return
    first, *rest = plans
    if isinstance(first, TaskPlan):
        yield from ways(rest, [*before, *first.steps])
        return
    for way in ways(first.then, [*before, *first.holds.steps]):  # whatever follows is planned from here
        yield from ways(rest, way)
    yield from ways(first.orelse, [*before, *first.fails.steps])


def follow(path: Sequence[GroundAction], start: set[Atom]) -> None:
    """Has every step find the robot where its precondition wants it."""
    state = set(start)
    for step in path:
        schema = read_schemas(DOMAIN.domain_pddl)[step.name]
        needed = {atom for atom in ground_atoms(schema.preconditions, step) if atom.predicate in ("at", "in-room")}
        assert needed <= state, step
        state -= set(ground_atoms(schema.deletes, step))
        state |= {atom for atom in ground_atoms(schema.adds, step) if atom.predicate in ("at", "in-room")}


def test_who_is_said_to_be_somewhere_is_not_supposed_to_be_elsewhere() -> None:
    text = (
        "[Follow](1:following) [Anna](1:object) [to the kitchen](1:goal), then [give](2:bringing) "
        "[Anna in the kitchen](2:recipient) [the apple](2:object)."
    )
    walk, _ = nodes(text, [1, 2])
    assert isinstance(walk, TaskPlan)
    assert not any("study" in str(step) for step in walk.steps)
