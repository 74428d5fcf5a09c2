"""Feasibility: each cause by hand, and the exact check held against the planner in drawn worlds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from decomplex_bt.envs.doubles import DOMAIN, HandWorld, instruction, referent, task
from decomplex_bt.envs.feasibility import find_cause, plan_course
from decomplex_bt.envs.monitor import Monitor
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.ground_task import HERE, Referent
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.problem import make_problem
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner
from decomplex_bt.planning.symbolic import SymbolicState


def course(world, flow, *tasks):
    return plan_course(instruction(flow, *tasks), DOMAIN, world)


@pytest.mark.parametrize(
    ("world", "due", "kind", "entity"),
    [
        (HandWorld(), task(1, "taking", "keys"), "thing nowhere", "keys"),
        (HandWorld(), task(1, "searching", "keys"), "thing nowhere", "keys"),
        (HandWorld(), task(1, "check_state", "coffee", state="hot"), "thing nowhere", "coffee"),
        (HandWorld({"keys": "desk"}), task(1, "bringing", "keys", recipient="anna"), "person out", "anna"),
        (HandWorld(), task(1, "informing", recipient="tom"), "person out", "tom"),
        (HandWorld({"anna": "study"}), task(1, "informing", recipient=["anna", "tom"]), "person out", "tom"),
        (HandWorld(), task(1, "following", "anna", goal="kitchen"), "person out", "anna"),
        (HandWorld(broken={"tv"}), task(1, "change_state", "tv", state="on"), "device broken", "tv"),
        (
            HandWorld({"soup": "stove"}, broken={"oven", "microwave"}),
            task(1, "change_state", "soup", state="hot"),
            "device broken",
            "microwave",
        ),
        (HandWorld({"pen_1": "desk"}), task(1, "placing", "pen_1", goal="tv"), "goal not possible", "tv"),
        (HandWorld({"cup_1": "desk"}), task(1, "change_state", "cup_1", state="hot"), "goal not possible", "cup_1"),
    ],
    ids=lambda value: value.type if hasattr(value, "type") else None,
)
def test_causes(world, due, kind, entity):
    found = course(world, [1], due).cause
    assert (found.kind, found.entity, found.task) == (kind, entity, 1)


@pytest.mark.parametrize(
    ("world", "due"),
    [
        (HandWorld(), task(1, "searching", "keys", at=["desk"])),
        (HandWorld(), task(1, "check_state", "anna", state=HERE)),
        (HandWorld(broken={"tv"}), task(1, "change_state", "tv", state="off")),
        (HandWorld({"soup": "stove"}, broken={"oven"}), task(1, "change_state", "soup", state="hot")),
        (HandWorld({"cup_1": "desk"}, broken={"dishwasher"}), task(1, "change_state", "cup_1", state="clean")),
        (HandWorld({"pen_2": "desk"}), task(1, "taking", referent("pen_1", "pen_2"))),
    ],
    ids=lambda value: value.type if hasattr(value, "type") else None,
)
def test_what_can_be_done(world, due):
    assert course(world, [1], due).is_feasible


def test_what_is_due_where_somebody_is_out_must_be_possible_too():
    check = replace(task(1, "check_state", "anna", state=HERE), is_denied=True)
    found = course(HandWorld(), [{"if": 1, "then": [2]}], check, task(2, "informing", recipient="tom"))
    assert found.tasks == (1, 2)
    assert str(found.cause) == "task 2: tom is out"


def test_a_place_out_of_reach_is_named(monkeypatch):
    monkeypatch.setattr("decomplex_bt.envs.feasibility.is_reachable", lambda domain, name: name != "desk")
    found = course(HandWorld(), [1], task(1, "motion", goal="desk")).cause
    assert (found.kind, str(found)) == ("place not reachable", "task 1: desk cannot be reached")


@pytest.fixture
def out_of_reach(monkeypatch):
    """The desk, the wardrobe and the oven stand where the robot does not get to."""
    far = ("desk", "wardrobe", "oven")
    monkeypatch.setattr("decomplex_bt.envs.feasibility.is_reachable", lambda domain, name: name not in far)


CUP = referent("cup_1", "cup_2", phrase="the cup")
BOTH_CUPS = referent("cup_1", "cup_2", phrase="all the cups", is_all=True)


@pytest.mark.usefixtures("out_of_reach")
@pytest.mark.parametrize(
    ("places", "due", "place"),
    [
        ({"cup_1": "desk"}, task(1, "taking", CUP), "desk"),
        ({"cup_1": "desk"}, task(1, "bringing", CUP, recipient="user"), "desk"),
        ({"cup_1": "desk"}, task(1, "placing", CUP, goal="counter"), "desk"),
        ({"cup_1": "desk"}, task(1, "motion", goal="cup_1"), "desk"),
        ({"cup_1": "desk"}, task(1, "change_state", CUP, state="full"), "desk"),
        ({"cup_1": "desk", "cup_2": "counter"}, task(1, "bringing", BOTH_CUPS, recipient="user"), "desk"),
        ({"cup_1": "counter", "bread": "desk"}, task(1, "placing", CUP, goal="bread"), "desk"),
        ({"cup_1": "wardrobe"}, task(1, "searching", CUP), "wardrobe"),
        ({"cup_1": "wardrobe"}, task(1, "check_state", CUP, state="clean"), "wardrobe"),
        ({"rag": "desk"}, task(1, "change_state", "kitchen_table", state="clean"), "desk"),
    ],
    ids=lambda value: value.type if hasattr(value, "type") else None,
)
def test_a_thing_at_a_place_out_of_reach_is_out_of_reach(places, due, place):
    found = course(HandWorld(places), [1], due).cause
    assert (found.kind, found.entity) == ("place not reachable", place)


@pytest.mark.usefixtures("out_of_reach")
@pytest.mark.parametrize(
    ("places", "due"),
    [
        ({"cup_1": "desk", "cup_2": "counter"}, task(1, "bringing", CUP, recipient="user")),
        ({"cup_1": "user"}, task(1, "taking", CUP)),
        ({"cup_1": "anna", "anna": "study"}, task(1, "taking", CUP)),
        ({"cup_1": "robot"}, task(1, "placing", CUP, goal="counter")),
        ({"cup_1": "desk"}, task(1, "placing", CUP, goal="desk")),
        ({"cup_1": "desk"}, task(1, "change_state", CUP, state="dirty")),
        ({}, task(1, "change_state", "wardrobe", state="closed")),
        ({"cup_1": "desk"}, task(1, "searching", CUP)),
        ({"cup_1": "desk"}, task(1, "check_state", CUP, state="clean")),
        ({"rag": "desk", "cup_1": "desk"}, task(1, "check_state", CUP, state=HERE)),
    ],
    ids="another,user has it,anna has it,on the robot,there already,so already,closed,find,look,here".split(","),
)
def test_what_needs_no_place_out_of_reach_can_be_done(places, due):
    assert course(HandWorld(places), [1], due).is_feasible


@pytest.mark.usefixtures("out_of_reach")
def test_what_lies_in_an_open_wardrobe_out_of_reach_may_be_seen():
    world = HandWorld({"cup_1": "wardrobe"}, {("wardrobe", "aperture"): "open"})
    assert course(world, [1], task(1, "searching", CUP)).is_feasible


@pytest.mark.usefixtures("out_of_reach")
def test_whoever_cannot_get_to_a_thing_goes_on_with_what_is_due_then():
    tasks = task(1, "bringing", CUP, recipient="user"), task(2, "informing", recipient="user")
    found = course(HandWorld({"cup_1": "desk"}), [{"if": 1, "else": [2]}], *tasks)
    assert found.tasks == (1, 2)
    assert found.is_feasible


@pytest.mark.usefixtures("out_of_reach")
def test_nobody_carries_off_what_is_needed_to_where_the_robot_does_not_get_to():
    monitor = Monitor(instruction([1], task(1, "taking", CUP)), DOMAIN, HandWorld({"cup_1": "counter"}))
    assert monitor.can_lie("cup_1", "sink")
    assert not monitor.can_lie("cup_1", "desk")


def test_only_what_is_due_counts():
    flow = [{"if": 1, "then": [2], "else": [3]}]
    tasks = (
        task(1, "check_state", "tv", state="on"),
        task(2, "informing", recipient="anna"),
        task(3, "informing", recipient="user"),
    )
    off = course(HandWorld(), flow, *tasks)
    assert off.is_feasible
    assert off.tasks == (1, 3)
    assert [(branch.truth, branch.taken) for branch in off.branches] == [(False, "else")]
    on = course(HandWorld(states={("tv", "power"): "on"}), flow, *tasks)
    assert str(on.cause) == "task 2: anna is out"


def test_a_door_between_rooms_is_as_it_is():
    flow = [{"if": 1, "then": [2], "else": [3]}]
    tasks = (
        task(1, "check_state", "bathroom_door", state="open"),
        task(2, "informing", recipient="user"),
        task(3, "informing", recipient="anna"),
    )
    assert course(HandWorld(states={("bathroom_door", "aperture"): "open"}), flow, *tasks).is_feasible


def test_earlier_tasks_change_what_later_conditions_find():
    tasks = (
        task(1, "change_state", "tv", state="on"),
        task(2, "check_state", "tv", state="on"),
        task(3, "informing", recipient="user"),
        task(4, "informing", recipient="anna"),
    )
    assert course(HandWorld(), [1, {"if": 2, "then": [3], "else": [4]}], *tasks).tasks == (1, 2, 3)


def test_another_candidate_is_tried_where_the_first_leads_nowhere():
    mug = referent("mug_1", "mug_2", phrase="the mug")
    tasks = (
        task(1, "check_state", mug, state="clean"),
        task(2, "informing", recipient="anna"),
        task(3, "informing", recipient="user"),
    )
    world = HandWorld({"mug_1": "desk", "mug_2": "desk"}, {("mug_1", "cleanliness"): "clean"})
    assert course(world, [{"if": 1, "then": [2], "else": [3]}], *tasks).tasks == (1, 3)


def test_a_thing_told_by_a_state_that_none_has_is_nowhere():
    clean = Referent("the clean mug", ("mug_1",), where=(("cleanliness", "clean"),))
    cause = course(HandWorld({"mug_1": "desk"}), [1], task(1, "taking", clean)).cause
    assert str(cause) == "task 1: the clean mug is nowhere in the house"


PENS = referent("pen_1", "pen_2", phrase="two pens", count=2)
CUPS = referent("cup_1", "cup_2", phrase="two cups", count=2)
CLEAN_CUPS = Referent("two clean cups", ("cup_1", "cup_2"), count=2, where=(("cleanliness", "clean"),))


@pytest.mark.parametrize(
    ("world", "due", "entity"),
    [
        (HandWorld({"pen_1": "desk"}), task(1, "bringing", PENS, recipient="user"), "pen_2"),
        (HandWorld({"pen_2": "user"}), task(1, "bringing", PENS, recipient="user"), "pen_1"),
        (HandWorld({"cup_1": "kitchen_table"}), task(1, "placing", CUPS, goal="kitchen_table"), "cup_2"),
        (
            HandWorld({"cup_1": "desk", "cup_2": "desk"}, {("cup_1", "cleanliness"): "clean"}),
            task(1, "taking", CLEAN_CUPS),
            "two clean cups",
        ),
    ],
    ids=["elsewhere", "there already", "one is there", "one is otherwise"],
)
def test_two_of_a_kind_are_two_different_ones(world, due, entity):
    found = course(world, [1], due).cause
    assert (found.kind, found.entity) == ("thing nowhere", entity)


# -- against the planner ----------------------------------------------------------------------------------------------


def draw_world(rng: np.random.Generator) -> HandWorld:
    house = DOMAIN.house
    places = [name for name in house.places() if DOMAIN.kind(name).surface or DOMAIN.kind(name).inside]
    where = {thing: str(rng.choice(places)) if rng.random() < 0.75 else None for thing in house.things}
    rooms = list(house.rooms)
    where |= {person: str(rng.choice(rooms)) if rng.random() < 0.6 else None for person in house.people}
    where["user"] = "study"
    devices = [name for name in house.places() if DOMAIN.kind(name).is_device]
    states = {
        (name, pair): str(rng.choice(DOMAIN.kinds.state_pairs[pair].values))
        for name in (*house.places(), *(thing for thing in house.things if where[thing] is not None))
        for pair in DOMAIN.kind(name).states
    }
    broken = {name for name in devices if rng.random() < 0.4}
    states |= {(name, "power"): "off" for name in broken}
    return HandWorld(where, states, room=str(rng.choice(rooms)), broken=broken)


def planner_finds(world: HandWorld, goal: Atom) -> bool:
    domain = DOMAIN
    symbolic = SymbolicState(Belief(domain), world.room, places=dict(world.places), values=dict(world.states))
    things = domain.house.things
    forbidden = [GroundAction("switch-on", (device,)) for device in world.broken]
    forbidden += [GroundAction(name, (t, d)) for name in ("heat", "wash", "fill") for t in things for d in world.broken]
    return PyperplanPlanner().solve(make_problem(symbolic, [goal], forbidden=forbidden)).is_solved


CASES = [
    (task(1, "taking", "keys"), Atom("carried", ("keys",))),
    (task(1, "placing", "cup_1", goal="dishwasher"), Atom("lies", ("cup_1", "dishwasher"))),
    (task(1, "bringing", "coffee", recipient="anna"), Atom("has", ("anna", "coffee"))),
    (task(1, "change_state", "tv", state="on"), Atom("powered-on", ("tv",))),
    (task(1, "change_state", "tv", state="off"), Atom("powered-off", ("tv",))),
    (task(1, "change_state", "soup", state="hot"), Atom("hot", ("soup",))),
    (task(1, "change_state", "milk", state="cold"), Atom("cold", ("milk",))),
    (task(1, "change_state", "shirt", state="clean"), Atom("clean", ("shirt",))),
    (task(1, "change_state", "mug_1", state="clean"), Atom("clean", ("mug_1",))),
    (task(1, "change_state", "mug_1", state="full"), Atom("full", ("mug_1",))),
    (task(1, "change_state", "mug_1", state="empty"), Atom("empty", ("mug_1",))),
    (task(1, "change_state", "trash_can", state="empty"), Atom("empty", ("trash_can",))),
    (task(1, "change_state", "desk", state="clean"), Atom("clean", ("desk",))),
    (task(1, "change_state", "bedroom_window", state="open"), Atom("open", ("bedroom_window",))),
    (task(1, "informing", recipient="tom"), Atom("told", ("tom",))),
    (task(1, "motion", goal="bathroom"), Atom("in-room", ("bathroom",))),
]


@pytest.mark.parametrize(("due", "goal"), CASES, ids=[str(goal) for _, goal in CASES])
def test_a_task_can_be_done_if_and_only_if_there_is_a_plan(due, goal):
    rng = np.random.default_rng(7)
    verdicts = set()
    for _ in range(8):
        world = draw_world(rng)
        is_possible = find_cause(due, {}, DOMAIN, world) is None
        assert is_possible == planner_finds(world, goal)
        verdicts.add(is_possible)
    assert True in verdicts
