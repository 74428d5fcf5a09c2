"""Pursuit: tasks carried to their end in an assumed world, by what the robot has seen."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.assumed_world import AssumedWorld
from decomplex_bt.planning.belief import ROBOT, Belief
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.pursuit import Pursuit, PursuitStatus, pursue
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain()
PLANNER = PyperplanPlanner()
DONE, FAILED = PursuitStatus.DONE, PursuitStatus.FAILED


def world(
    places: Mapping[str, str | None] | None = None,
    values: Mapping[tuple[str, str], str] | None = None,
    broken: str = "",
) -> AssumedWorld:
    """The likely world with some of it otherwise; a place of None is nowhere."""
    made = AssumedWorld.likely(DOMAIN)
    for name, place in (places or {}).items():
        made.places.pop(name, None)
        if place is not None:
            made.places[name] = place
    made.values.update(values or {})
    made.broken = frozenset(broken.split())
    return made


def run(text: str, inside: AssumedWorld, flow: list | None = None) -> list[Pursuit]:
    """Pursues all tasks of a marked text one after the other."""
    count = text.count("](") and max(int(part.split(":")[0]) for part in text.split("](")[1:])
    grounded = ground(read_markup(text, DOMAIN.ontology, flow=flow or list(range(1, count + 1))), DOMAIN)
    belief, bindings, results = Belief(DOMAIN), {}, []
    for task in grounded.tasks:
        results.append(inside.run(task, belief, PLANNER, bindings))
        bindings = results[-1].bindings
    return results


def names(inside: AssumedWorld) -> list[str]:
    return [str(step) for step in inside.steps]


def bound(pursuit: Pursuit) -> dict[str, tuple[str, ...]]:
    return {referent.phrase: entities for referent, entities in pursuit.bindings.items()}


def test_what_lies_where_a_landmark_may_be_does_not_lie_beside_it():
    text = "[Is](1:check_state) [the phone](1:object) [on the charger](1:location) [there](1:state=here)"
    apart = world({"phone": "nightstand", "charger": "desk_drawer"})
    assert run(text, apart)[0].truth is False
    beside = world({"phone": "nightstand", "charger": "nightstand"})
    assert run(text, beside)[0].truth is True


FIND_PEN = "[Find](1:searching) [a pen](1:object) and [give](2:bringing) [it](2:object=a pen) [to Anna](2:recipient)"


def test_a_search_goes_on_until_the_thing_is_seen_and_binds_the_phrase() -> None:
    inside = world({"pen_1": None, "pen_2": "nightstand"})
    found, given = run(FIND_PEN, inside)
    assert (found.status, found.truth, bound(found)["a pen"]) == (DONE, True, ("pen_2",))
    assert (given.status, inside.places["pen_2"]) == (DONE, "anna")


def test_a_search_without_a_place_fails_when_nothing_is_left_to_try() -> None:
    found, _ = run(FIND_PEN, world({"pen_1": None, "pen_2": None}))
    assert (found.status, found.truth) == (FAILED, False)
    assert "nowhere to be found" in found.reason


LOOK_IN_FRIDGE = "[Look](1:searching) [in the fridge](1:location) for [the milk](1:object)"


@pytest.mark.parametrize(("place", "truth"), [("fridge", True), ("counter", False), (None, False)])
def test_a_search_of_a_place_is_done_either_way(place: str | None, truth: bool) -> None:
    inside = world({"milk": place})
    (looked,) = run(LOOK_IN_FRIDGE, inside)
    assert (looked.status, looked.truth) == (DONE, truth)
    assert "(open-up fridge)" in names(inside)


def test_a_place_that_cannot_be_looked_into_leaves_the_answer_open() -> None:
    inside = world()
    inside.refused = frozenset(("open-up",))
    (looked,) = run(LOOK_IN_FRIDGE, inside)
    assert (looked.status, looked.truth) == (FAILED, None)
    assert "open-up fridge" in looked.reason


def test_looking_into_a_room_looks_at_everything_in_it() -> None:
    inside = world()
    (looked,) = run("[Look](1:searching) [in the bathroom](1:location)", inside)
    assert looked.status is DONE
    opened = {step for step in names(inside) if step.startswith("(open-up")}
    assert opened == {"(open-up washing_machine)", "(open-up medicine_cabinet)"}


@pytest.mark.parametrize(
    ("said", "truth"),
    [
        ("[is](1:check_state) [a tv](1:object) [in the living room](1:location)", True),
        ("[is](1:check_state) [a tv](1:object) [in the kitchen](1:location)", False),
        ("[are](1:check_state) [lamps](1:object) [in the bedroom](1:location)", True),
        ("[is](1:check_state) [a radio](1:object) [on the counter](1:location)", True),
        ("[is](1:check_state) [a kitchen light](1:object) [here](1:location)", True),
        ("[Look](1:searching) for [a heater](1:object) [in the bathroom](1:location)", False),
    ],
)
def test_where_something_fixed_is_the_map_tells(said: str, truth: bool) -> None:
    inside = world()
    (looked,) = run(said, inside)
    assert (looked.status, looked.truth) == (DONE, truth)
    assert not names(inside)


def test_a_search_for_something_fixed_goes_there_and_opens_nothing() -> None:
    inside = world()
    (looked,) = run("[Look](1:searching) for [the radio](1:object) [in the kitchen](1:location)", inside)
    assert (looked.status, looked.truth) == (DONE, True)
    assert not [step for step in names(inside) if step.startswith("(open-up")]


BRING_BALL = "[Bring](1:bringing) [me](1:recipient) [the ball](1:object) [from the box](1:source). "
LOOK = "[Open](1:change_state) [the drawer](1:object) and [look](2:searching) [for a pen](2:object). "
TELL = "[tell](3:informing) [me](3:recipient)"
LEAVE = "[go](4:motion) [to the kitchen](4:goal)"


@pytest.mark.parametrize(
    "mention",
    [
        "If [it](2:object=the ball)['s](2:check_state) not [there](2:location=in the box), ",
        "If you can't [find](2:searching) [it](2:object=the ball) [there](2:location=the desk), ",
    ],
)
@pytest.mark.parametrize(("place", "truth"), [("box", True), ("couch", False)])
def test_where_it_is_asked_to_be_a_thing_is_brought_from_there_alone(mention: str, place: str, truth: bool) -> None:
    inside = world({"ball": place})
    pursuit = run(BRING_BALL + mention + TELL, inside, [{"if": [1, 2], "else": [3]}])[0]
    assert pursuit.truth is truth
    assert (inside.places["ball"] == "user") is truth


def test_a_source_that_is_not_asked_about_is_where_to_look_first() -> None:
    inside = world({"ball": "couch"})
    text = BRING_BALL + "If you can't [find](2:searching) [it](2:object=the ball), " + TELL
    assert run(text, inside, [{"if": [1, 2], "else": [3]}])[0].truth is True


@pytest.mark.parametrize(("place", "truth"), [("drawer", True), ("couch", False)])
def test_a_search_looks_where_its_mention_says(place: str, truth: bool) -> None:
    text = LOOK + "If [it](3:object=a pen)['s](3:check_state) [there](3:location=the drawer), " + LEAVE
    inside = world({"pen_1": place, "pen_2": None})
    assert run(text, inside, [1, {"if": [2, 3], "then": [4]}])[1].truth is truth


def test_two_things_are_brought_in_one_go() -> None:
    inside = world()
    (brought,) = run("[Bring](1:bringing) [me](1:recipient) [the cup and the plate](1:object)", inside)
    assert brought.status is DONE
    assert sum(step.startswith("(pass living_room_doorway") for step in names(inside)) == 1


def test_what_somebody_is_to_get_is_had_before_they_are_looked_for() -> None:
    inside = world({"letter": "hallway_table", "tom": "bedroom"})
    assert run("[Bring](1:bringing) [the letter](1:object) [to Tom](1:recipient)", inside)[0].status is DONE
    steps = [step.name for step in inside.steps]
    assert steps.index("pick") < steps.index("pass")


def test_what_cannot_all_be_carried_at_once_is_brought_all_the_same() -> None:
    things = [f"{kind}_{number}" for kind in ("cup", "mug", "plate") for number in (1, 2)]
    inside = world({**dict.fromkeys(things, "counter"), "tom": "bedroom"})
    text = "[Bring](1:bringing) [all the cups, all the mugs and all the plates](1:object) [to Tom](1:recipient)"
    assert run(text, inside)[0].status is DONE
    assert {inside.places[thing] for thing in things} == {"tom"}


def test_the_clean_one_is_brought_not_the_dirty_one() -> None:
    values = {("mug_1", "cleanliness"): "dirty", ("mug_2", "cleanliness"): "clean"}
    inside = world({"mug_1": "counter", "mug_2": "desk"}, values)
    (brought,) = run("[Bring](1:bringing) [me](1:recipient) [a clean mug](1:object)", inside)
    assert (brought.status, bound(brought)["a clean mug"]) == (DONE, ("mug_2",))


@pytest.mark.parametrize("state", ["clean", "dirty"])
def test_only_those_at_the_place_are_asked_about(state: str) -> None:
    inside = world({"plate_1": "counter", "plate_2": "desk"}, {("plate_1", "cleanliness"): state})
    text = "[Are](1:check_state) [the plates](1:object) [on the counter](1:location) [clean](1:state)"
    (checked,) = run(text, inside)
    assert (checked.status, checked.truth) == (DONE, state == "clean")


CUPS = {("cup_1", "fill"): "empty", ("cup_2", "fill"): "empty"}


@pytest.mark.parametrize("phrase", ["the cup", "the cups", "a cup"])
@pytest.mark.parametrize("places", [("cupboard", "coffee_table"), (None, None)])
def test_a_cup_elsewhere_is_not_the_one_on_the_table(phrase: str, places: tuple[str | None, str | None]) -> None:
    inside = world(dict(zip(("cup_1", "cup_2"), places, strict=True)), CUPS)
    text = f"[Is](1:check_state) [{phrase}](1:object) [on the kitchen table](1:location) [empty](1:state)"
    (check,) = run(text, inside)
    assert (check.status, check.truth) == (DONE, False)
    assert "open-up" not in [step.name for step in inside.steps]


@pytest.mark.parametrize("state", ["full", "empty"])
def test_of_two_cups_the_one_on_the_table_is_asked_about(state: str) -> None:
    inside = world({"cup_1": "coffee_table", "cup_2": "kitchen_table"}, {**CUPS, ("cup_2", "fill"): state})
    text = "[Is](1:check_state) [the cup](1:object) [on the kitchen table](1:location) [empty](1:state)"
    (check,) = run(text, inside)
    assert check.truth is (state == "empty")
    assert bound(check)["the cup"] == ("cup_2",)


def test_a_place_that_cannot_be_looked_at_leaves_the_state_of_what_is_there_open() -> None:
    inside = world({"cup_1": None, "cup_2": None})
    inside.refused = frozenset(("open-up",))
    text = "[Is](1:check_state) [the cup](1:object) [in the cupboard](1:location) [empty](1:state)"
    (check,) = run(text, inside)
    assert (check.status, check.truth) == (FAILED, None)


def test_all_the_dirty_ones_are_washed() -> None:
    values = {(f"plate_{i}", "cleanliness"): "dirty" for i in (1, 2)}
    inside = world({"plate_1": "kitchen_table", "plate_2": "sink"}, values)
    (washed,) = run("[Wash](1:change_state) [the dirty plates](1:object)", inside)
    assert washed.status is DONE
    assert {inside.values[f"plate_{i}", "cleanliness"] for i in (1, 2)} == {"clean"}


WINDOWS = ("kitchen_window", "living_room_window", "bedroom_window")


def windows(*open_ones: str) -> dict[tuple[str, str], str]:
    return {(name, "aperture"): "open" if name in open_ones else "closed" for name in WINDOWS}


@pytest.mark.parametrize("window", WINDOWS)
def test_of_several_windows_the_one_that_is_open_is_closed(window: str) -> None:
    inside = world(values=windows(window))
    (closed,) = run("[Close](1:change_state) [the window](1:object)", inside)
    assert (closed.status, bound(closed)) == (DONE, {"the window": (window,)})
    assert names(inside)[-1] == f"(close-up {window})"


def test_of_two_that_are_open_one_is_closed() -> None:
    inside = world(values=windows("kitchen_window", "bedroom_window"))
    assert run("[Close](1:change_state) [the window](1:object)", inside)[0].status is DONE
    assert sum(step.name == "close-up" for step in inside.steps) == 1


def test_where_all_are_so_there_is_nothing_to_change() -> None:
    inside = world(values=windows())
    assert run("[Close](1:change_state) [the window](1:object)", inside)[0].status is DONE
    assert "close-up" not in [step.name for step in inside.steps]


def test_the_window_that_was_asked_about_is_the_one_that_is_closed() -> None:
    inside = world(values=windows("bedroom_window"))
    inside.room, inside.at = "kitchen", "kitchen_floor"
    question = "[Check](1:check_state) [the window](1:object) [open](1:state)"
    check, close = run(f"{question}. [Close](2:change_state) [the window](2:object)", inside)
    assert (check.truth, close.status) == (False, DONE)
    assert bound(close)["the window"] == ("kitchen_window",)


@pytest.mark.parametrize(("phrase", "washed"), [("the mug", True), ("a mug", False), ("the mug on the counter", False)])
def test_the_mug_that_is_to_be_washed_is_a_dirty_one(phrase: str, washed: bool) -> None:
    values = {("mug_1", "cleanliness"): "clean", ("mug_2", "cleanliness"): "dirty"}
    inside = world({"mug_1": "counter", "mug_2": "desk"}, values)
    inside.room, inside.at = "kitchen", "kitchen_floor"
    assert run(f"[Wash](1:change_state) [{phrase}](1:object)", inside)[0].status is DONE
    assert (inside.values["mug_2", "cleanliness"] == "clean") is washed


def test_where_the_other_one_is_nowhere_the_clean_mug_will_do() -> None:
    inside = world({"mug_1": "counter", "mug_2": None}, {("mug_1", "cleanliness"): "clean"})
    assert run("[Wash](1:change_state) [the mug](1:object)", inside)[0].status is DONE
    assert "pick" not in [step.name for step in inside.steps]


def test_all_the_lights_are_switched_off() -> None:
    lights = ("kitchen_light", "bedroom_light", "bathroom_light", "living_room_lamp", "bedroom_lamp")
    inside = world(values={(light, "power"): "on" for light in lights})
    (switched,) = run("[Turn](1:change_state) off [all the lights](1:object)", inside)
    assert switched.status is DONE
    assert {inside.values[light, "power"] for light in lights} == {"off"}


def test_everything_at_a_place_is_what_is_there() -> None:
    inside = world()
    there = sorted(name for name, place in inside.places.items() if place == "kitchen_table")
    (put,) = run("[Put](1:placing) [everything on the kitchen table](1:object) [on the couch](1:goal)", inside)
    assert put.status is DONE
    assert sorted(name for name, place in inside.places.items() if place == "couch" and name in there) == there
    assert sorted(bound(put)["everything on the kitchen table"]) == there


@pytest.mark.parametrize(("drink", "place"), [("water", "sink"), ("hot coffee", "coffee_machine")])
def test_a_thing_is_filled_where_there_is_what_it_is_filled_with(drink: str, place: str) -> None:
    inside = world({"mug_1": "counter"}, {("mug_1", "fill"): "empty"})
    run(f"[Fill](1:change_state) [the red mug](1:object) [with {drink}](1:manner)", inside)
    assert names(inside)[-1] == f"(fill mug_1 {place})"


@pytest.mark.parametrize(
    ("power", "aperture", "steps"),
    [
        ("on", "open", ["close-up"]),
        ("off", "open", ["close-up", "switch-on"]),
        ("off", "closed", ["switch-on"]),
        ("on", "closed", []),
    ],
)
def test_a_device_with_a_door_is_shut_to_run(power: str, aperture: str, steps: list[str]) -> None:
    inside = world(values={("oven", "power"): power, ("oven", "aperture"): aperture})
    (start,) = run("[Turn](1:change_state) on [the oven](1:object)", inside)
    assert start.status is DONE
    assert [step.name for step in inside.steps if step.name not in ("move", "pass")] == steps


def test_a_device_with_a_door_is_turned_off_with_the_door_as_it_is() -> None:
    inside = world(values={("oven", "power"): "on", ("oven", "aperture"): "open"})
    run("[Turn](1:change_state) off [the oven](1:object)", inside)
    assert [step.name for step in inside.steps if step.name not in ("move", "pass")] == ["switch-off"]


def test_another_device_is_tried_when_one_is_broken() -> None:
    inside = world(broken="microwave")
    (heated,) = run("[Heat](1:change_state) [the soup](1:object)", inside)
    assert heated.status is DONE
    assert names(inside)[-1] == "(heat soup oven)"


def test_a_broken_device_is_given_up_with_the_reason() -> None:
    (switched,) = run("[Turn](1:change_state) on [the tv](1:object)", world(broken="tv"))
    assert (switched.status, switched.truth) == (FAILED, False)
    assert "(switch-on tv): broken" in switched.reason


def test_a_thing_that_slips_is_tried_again_and_then_another_is_taken() -> None:
    inside = world({"pen_1": "desk", "pen_2": "desk"})
    inside.slippery = frozenset(("pen_1",))
    (taken,) = run("[Take](1:taking) [a pen](1:object)", inside)
    assert (taken.status, bound(taken)["a pen"], inside.places["pen_2"]) == (DONE, ("pen_2",), ROBOT)


@pytest.mark.parametrize(("value", "truth"), [("hot", True), ("cold", False)])
def test_a_state_is_seen_and_judged(value: str, truth: bool) -> None:
    inside = world(values={("coffee", "temperature"): value})
    (checked,) = run("if [the coffee](1:object) [is](1:check_state) [hot](1:state)", inside)
    assert (checked.status, checked.truth) == (DONE, truth)


def test_the_state_of_a_thing_that_is_nowhere_is_neither() -> None:
    (checked,) = run("if [the coffee](1:object) [is](1:check_state) [hot](1:state)", world({"coffee": None}))
    assert (checked.status, checked.truth) == (FAILED, None)


def test_what_was_seen_before_the_task_became_due_is_looked_at_again() -> None:
    inside = world(values={("kitchen_window", "aperture"): "open"})
    first = "[Go](1:motion) [to the kitchen](1:goal). [Go](2:motion) [to the study](2:goal). "
    *_, checked = run(first + "if [the kitchen window](3:object) [is](3:check_state) [open](3:state)", inside)
    assert checked.truth is True
    assert names(inside)[-1].startswith("(pass kitchen_doorway hallway kitchen")


@pytest.mark.parametrize(("room", "truth"), [("study", True), (None, False)])
def test_whether_somebody_is_home_is_found_out_room_by_room(room: str | None, truth: bool) -> None:
    (checked,) = run("[Is](1:check_state) [Anna](1:object) [home](1:state)?", world({"anna": room}))
    assert (checked.status, checked.truth) == (DONE, truth)


@pytest.mark.parametrize(("room", "truth"), [("study", False), (None, True)])
@pytest.mark.parametrize(
    "check", ["[Is](1:check_state) [Anna](1:object) [out](1:state)?", "has [Anna](1:object) [left](1:check_state)?"]
)
def test_whether_somebody_is_out_is_the_opposite_of_their_being_home(check: str, room: str | None, truth: bool) -> None:
    (checked,) = run(check, world({"anna": room}))
    assert (checked.status, checked.truth) == (DONE, truth)


def test_somebody_is_told_where_they_are() -> None:
    inside = world({"anna": "bedroom"})
    (told,) = run("[Tell](1:informing) [Anna](1:recipient) [that dinner is ready](1:message)", inside)
    assert told.status is DONE
    assert names(inside)[-1] == "(say anna)"


@pytest.mark.parametrize(
    ("message", "looked_at"),
    [
        ("whether the fan is on", "bedroom"),
        ("if there is milk in the fridge", "fridge"),
        ("where the ball is", "study"),
        ("what's in the wardrobe", "wardrobe"),
        ("how many mugs there are in the dishwasher", "dishwasher"),
        ("whether the ball is in the box or not", "study"),
    ],
)
def test_what_is_asked_for_is_looked_at_before_it_is_told(message: str, looked_at: str) -> None:
    inside = world({"ball": "box", "user": "bathroom"})
    told = run(f"[Tell](1:informing) [me](1:recipient) [{message}](1:message)", inside)[0]
    assert told.status is DONE
    assert any(looked_at in step.objects for step in inside.steps[:-1])
    assert inside.steps[-1].name == "say"


@pytest.mark.parametrize("message", ["that the fan is on", "whether it is ready", "dinner is ready", "if you can"])
def test_what_nobody_can_see_is_told_at_once(message: str) -> None:
    text = f"[Tell](1:informing) [me](1:recipient) [{message}](1:message)"
    assert ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks[0].question is None


def test_saying_it_for_one_task_is_not_saying_it_for_the_next() -> None:
    inside = world()
    run(
        "[Tell](1:informing) [me](1:recipient) [a](1:message), [tell](2:informing) [me](2:recipient) [b](2:message)",
        inside,
    )
    assert names(inside).count("(say user)") == 2


def test_somebody_is_followed_to_a_room() -> None:
    inside = world({"anna": "study"})
    (followed,) = run("[Follow](1:following) [Anna](1:object) [to the kitchen](1:goal)", inside)
    assert followed.status is DONE
    assert (inside.room, inside.places["anna"]) == ("kitchen", "kitchen")


def test_who_is_followed_to_a_piece_of_furniture_is_led_to_its_room_and_the_robot_goes_up_to_it() -> None:
    inside = world({"anna": "study"})
    (followed,) = run("[Walk](1:following) [Anna](1:object) [to the armchair](1:goal)", inside)
    assert followed.status is DONE
    assert inside.places["anna"] == "living_room"
    assert names(inside)[-1].startswith("(move")
    assert "armchair" in names(inside)[-1]


def test_who_may_be_followed_to_any_room_is_in_the_same_one() -> None:
    inside = world({"anna": "study"})
    (followed,) = run("[Follow](1:following) [Anna](1:object) [to her room](1:goal)", inside)
    assert followed.status is DONE
    assert inside.room == inside.places["anna"]


def test_who_is_out_cannot_be_told() -> None:
    (told,) = run("[Tell](1:informing) [my mother](1:recipient) [hello](1:message)", world({"relative": None}))
    assert (told.status, told.truth) == (FAILED, False)


def test_a_goal_that_holds_is_done_at_once() -> None:
    inside = world({"user": "hallway", "pen_1": "user", "pen_2": None})
    (brought,) = run("[Bring](1:bringing) [me](1:recipient) [a pen](1:object)", inside)
    assert (brought.status, inside.steps) == (DONE, [])


def test_a_task_type_of_ones_own_needs_a_goal_template_only() -> None:
    belief = Belief(DOMAIN)
    inside = world()
    belief.update(inside.percept())
    task = ground(read_markup("[Go](1:motion) [to the desk](1:goal)", DOMAIN.ontology, flow=[1]), DOMAIN).tasks[0]
    other: Any = type(task)(1, "motion", "go", goal=task.goal)
    assert [str(atom) for atom in pursue(other, belief, {}, since=1).goal_atoms] == ["(at desk)"]


@pytest.mark.parametrize(("place", "status"), [("bathroom_shelf", DONE), (None, FAILED)])
def test_something_to_wipe_with_is_looked_for_first(place: str | None, status: PursuitStatus) -> None:
    inside = world({"rag": place}, {("coffee_table", "cleanliness"): "dirty"})
    (cleaned,) = run("[Wipe](1:change_state) [the coffee table](1:object)", inside)
    assert cleaned.status is status
    assert (names(inside)[-1] == "(wipe coffee_table rag)") == (place is not None)


def test_of_two_asked_for_the_one_there_is_will_not_do() -> None:
    inside = world({"cup_2": None})
    (brought,) = run("[Bring](1:bringing) [me](1:recipient) [two cups](1:object)", inside)
    assert (brought.status, brought.reason) == (FAILED, "'two cups' are nowhere to be found")


@pytest.mark.parametrize(("second", "is_so"), [("full", True), ("empty", False)])
def test_two_of_a_kind_are_so_if_both_are(second: str, is_so: bool) -> None:
    fills = {("cup_1", "fill"): "full", ("cup_2", "fill"): second}
    inside = world({"cup_1": "coffee_table", "cup_2": "counter"}, fills)
    (checked,) = run("Check if [two cups](1:object) [are](1:check_state) [full](1:state)", inside)
    assert (checked.status, checked.truth) == (DONE, is_so)
    assert bound(checked).get("two cups") == (("cup_1", "cup_2") if is_so else None)


def test_a_thing_is_put_beside_another_that_is_looked_for() -> None:
    inside = world({"laptop": "bed"})
    (put,) = run("[Put](1:placing) [the red book](1:object) [next to the laptop](1:goal)", inside)
    assert (put.status, inside.places["book_1"]) == (DONE, "bed")


@pytest.mark.parametrize(
    ("thing", "goal", "place"),
    [
        ("the magazine", "on the shelf", "bookshelf"),
        ("the red book", "on the shelf", "bookshelf"),
        ("the glasses", "on the shelf", "bathroom_shelf"),
        ("the white cup", "in the cupboard", "cupboard"),
        ("the medicine", "in the cupboard", "medicine_cabinet"),
        ("the letter", "on the table", "hallway_table"),
        ("the magazine", "on the bathroom shelf", "bathroom_shelf"),
        ("the magazine", "on the shelf in the bathroom", "bathroom_shelf"),
    ],
)
def test_of_places_by_one_word_a_thing_is_put_where_such_things_are(thing: str, goal: str, place: str) -> None:
    places = {"magazine": "couch", "book_1": "couch", "cup_1": "counter", "medicine": "nightstand", "letter": "desk"}
    inside = world(places)
    assert run(f"[Put](1:placing) [{thing}](1:object) [{goal}](1:goal)", inside)[0].status is DONE
    assert next(step for step in inside.steps if step.name == "place").objects[1] == place


def test_what_lies_at_any_place_of_the_word_is_put_there_already() -> None:
    inside = world({"magazine": "bathroom_shelf"})
    inside.room, inside.at = "bathroom", "bathroom_floor"
    assert run("[Put](1:placing) [the magazine](1:object) [on the shelf](1:goal)", inside)[0].status is DONE
    assert not inside.steps


def test_a_thing_is_laid_down_on_the_floor_where_it_is_to_be() -> None:
    inside = world({"shoes": "wardrobe", "bag": "bed"})
    text = "[Put](1:placing) [the shoes and the bag](1:object) [next to the front door](1:goal)"
    assert run(text, inside)[0].status is DONE
    assert {inside.places["shoes"], inside.places["bag"]} == {"hallway_floor"}
    moves = [step for step in inside.steps if step.name in ("move", "pick", "place")]
    assert [step.name for step in moves[-3:]] == ["move", "place", "place"]
    assert moves[-3].objects[1] == "front_door"
    there = world({"shoes": "hallway_floor"})
    assert run(text.replace(" and the bag", ""), there)[0].status is DONE
    assert "place" not in [step.name for step in there.steps]


def test_what_cannot_be_got_to_does_not_keep_a_thing_from_the_floor() -> None:
    task = ground(
        read_markup("[Put](1:placing) [the shoes](1:object) [by the front door](1:goal)", DOMAIN.ontology, flow=[1]),
        DOMAIN,
    ).tasks[0]
    inside, belief = world({"shoes": "hallway_table"}), Belief(DOMAIN)
    belief.update(inside.percept())
    belief.give_up((Atom("at", ("front_door",)),), "somebody stands there")
    assert pursue(task, belief, {}, since=0).goal_atoms == (Atom("lies", ("shoes", "hallway_floor")),)


def test_somebody_is_followed_wherever_they_go() -> None:
    inside = world()
    (followed,) = run("[Follow](1:following) [me](1:object)", inside)
    assert followed.status is DONE
    assert names(inside)[-1] == "(tag-along user)"


@pytest.mark.parametrize(
    ("places", "is_so"),
    [
        ({"plate_1": "sink", "plate_2": "cupboard"}, True),
        ({"plate_1": "sink", "plate_2": "sink"}, True),
        ({"plate_1": "counter", "plate_2": "cupboard"}, False),
    ],
)
def test_there_are_some_where_one_is_wherever_the_others_are(places: dict[str, str], is_so: bool) -> None:
    values = {("plate_1", "cleanliness"): "dirty", ("plate_2", "cleanliness"): "dirty"}
    inside = world(places, values)
    (checked,) = run("[Are](1:check_state) there [dirty plates](1:object) [in the sink](1:location)", inside)
    assert (checked.status, checked.truth) == (DONE, is_so)
    if is_so:
        assert set(bound(checked)["dirty plates"]) == {name for name, place in places.items() if place == "sink"}


def test_what_was_picked_up_before_the_rest_was_seen_is_of_all_as_well() -> None:
    inside = world({"plate_1": "dishwasher", "plate_2": "dishwasher"})
    grounded = ground(
        read_markup(
            "[Take](1:taking) [the plates](1:object) [out of the dishwasher](1:source)", DOMAIN.ontology, flow=[1]
        ),
        DOMAIN,
    )
    belief = Belief(DOMAIN)
    taken = inside.run(grounded.tasks[0], belief, PLANNER, {})
    assert set(bound(taken)["the plates"]) == {"plate_1", "plate_2"}
    held = [name for name in ("plate_1", "plate_2") if belief.place_of(name) == ROBOT]
    again = pursue(grounded.tasks[0], belief, {}, since=0)
    assert held
    assert (again.status, set(bound(again)["the plates"])) == (DONE, set(held))


def test_all_stay_all_when_one_of_them_is_not_so() -> None:
    inside = world({}, {("cup_1", "cleanliness"): "dirty", ("cup_2", "cleanliness"): "dirty"})
    text = "if [the cups](1:object) [are](1:check_state) [clean](1:state), "
    text += "else [wash](2:change_state) [them](2:object=the cups)"
    checked, washed = run(text, inside)
    assert (checked.truth, washed.status) == (False, DONE)
    assert {inside.values[f"cup_{i}", "cleanliness"] for i in (1, 2)} == {"clean"}


@pytest.mark.parametrize("is_remembered", [True, False])
def test_who_was_in_a_room_a_moment_ago_is_there_once_it_was_looked_over(is_remembered: bool) -> None:
    """A floor counts as looked over by what was in view a moment ago, and so does who was seen there."""
    marked = "[Is](1:check_state) [Anna](1:object) [in the living room](1:location)"
    task = ground(read_markup(marked, DOMAIN.ontology, flow=[1]), DOMAIN).tasks[0]
    belief = Belief(DOMAIN)
    floor = frozenset((DOMAIN.house.floor_of("living_room"),))
    belief.update(Percept(room="living_room", places={"anna": "living_room"}))
    remembered = {"anna": "living_room"} if is_remembered else {}
    for seconds in (1.0, 2.0, 3.0):
        belief.update(
            Percept("living_room", places=remembered, unseen=frozenset(remembered), inspected=floor, seconds=seconds)
        )
    found = pursue(task, belief, {}, since=2)
    assert (found.status, found.truth) == (DONE, is_remembered)


def test_a_place_that_was_handled_is_meant_from_then_on() -> None:
    close = "[Close](1:change_state) [the drawer](1:object) and "
    text = close + "[bring](2:bringing) [me](2:recipient) [the pen](2:object) [from it](2:source=the drawer)"
    inside = world({"pen_1": "desk_drawer", "pen_2": "drawer"})
    closed, brought = run(text, inside)
    handled = bound(closed)["the drawer"]
    assert {"desk_drawer": ("pen_1",), "drawer": ("pen_2",)}[handled[0]] == bound(brought)["the pen"]


def test_a_place_where_a_thing_was_put_is_meant_from_then_on() -> None:
    text = "[Put](1:placing) [the cup](1:object) [on the table](1:goal)"
    (put,) = run(text, world())
    assert len(bound(put)["the table"]) == 1


def test_several_places_are_gone_to_one_by_one() -> None:
    inside = world()
    (gone,) = run("[Go](1:motion) [to the kitchen and the bathroom](1:goal)", inside)
    assert gone.status is DONE
    assert {room for step in names(inside) for room in ("kitchen", "bathroom") if room in step} == {
        "kitchen",
        "bathroom",
    }


def test_each_who_is_named_is_told() -> None:
    text = "[Tell](1:informing) [Anna and Tom](1:recipient) [that I left](1:message)"
    inside = world({"anna": "study", "tom": "kitchen"})
    assert run(text, inside)[0].status is DONE
    assert {"(say anna)", "(say tom)"} <= {str(step) for step in inside.steps}
    assert run(text, world({"anna": None, "tom": "kitchen"}))[0].status is FAILED


@pytest.mark.parametrize(
    ("phrase", "values", "truth"),
    [
        ("either the tv or the radio", {("radio", "power"): "on"}, True),
        ("the tv or the radio", {("tv", "power"): "on"}, True),
        ("neither the tv nor the radio", {}, False),
    ],
)
def test_of_alternatives_any_will_do(phrase: str, values: dict[tuple[str, str], str], truth: bool) -> None:
    inside = world(values={("tv", "power"): "off", ("radio", "power"): "off", **values})
    (checked,) = run(f"if [{phrase}](1:object) [is](1:check_state) [on](1:state)", inside)
    assert checked.truth is truth


@pytest.mark.parametrize(
    "name", ["question", "presence", "places", "bare", "user", "named", "found", "meant", "tidying"]
)
def test_a_task_type_of_ones_own_may_have_any_name(name):
    ontology = DOMAIN.ontology.model_copy(
        update={"task_types": {**DOMAIN.ontology.task_types, name: DOMAIN.ontology.task_types["placing"]}}
    )
    goals = DOMAIN.goals.model_copy(update={"goals": {**DOMAIN.goals.goals, name: DOMAIN.goals.goals["placing"]}})
    domain = replace(DOMAIN, ontology=ontology, goals=goals)
    text = f"[Put](1:{name}) [the keys](1:object) [on the bed](1:goal)."
    (task,) = ground(read_markup(text, ontology, flow=[1]), domain).tasks
    assert (task.type, task.objects[0].candidates) == (name, ("keys",))
    inside = world({"keys": "counter"})
    assert inside.run(task, Belief(domain), PLANNER, {}).status is DONE
    assert inside.places["keys"] == "bed"
