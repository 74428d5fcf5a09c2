from __future__ import annotations

from dataclasses import replace

from decomplex_bt.envs import tested
from decomplex_bt.envs.balance import PersonTest, PlaceTest, StateTest, Whereabouts, WorksTest
from decomplex_bt.envs.doubles import DOMAIN, instruction, referent, task
from decomplex_bt.planning.ground_task import HERE


def derive(flow, *tasks):
    return tested.tests_of(instruction(flow, *tasks), DOMAIN)


def test_a_chain_of_searches_is_one_test_with_a_stage_for_each():
    flow = [{"if": [1, 2], "else": [{"if": 3, "else": [4]}]}]
    tasks = (
        task(1, "searching", "keys", at=["coffee_table"]),
        task(2, "check_state", "keys", state=HERE),
        task(3, "searching", "keys", at=["wardrobe"]),
        task(4, "informing", recipient="user"),
    )
    assert derive(flow, *tasks) == (PlaceTest(("keys",), (("coffee_table",), ("wardrobe",))),)


def test_a_chain_ends_before_a_search_beside_something_that_may_be_anywhere():
    flow = [{"if": 1, "else": [{"if": 2, "else": [3]}]}]
    last = task(3, "informing", recipient="user")
    first, beside = task(1, "searching", "keys", at=["coffee_table"]), task(2, "searching", "keys", at=["pillow"])
    assert derive(flow, first, beside, last) == (PlaceTest(("keys",), (("coffee_table",),)),)
    assert derive([{"if": 2, "else": [3]}], beside, last) == ()


def test_what_is_fixed_is_named_though_it_cannot_turn_up_elsewhere():
    tasks = task(1, "check_state", "heater", state=HERE), task(2, "informing", recipient="user")
    assert derive([{"if": 1, "then": [2]}], *tasks) == (PlaceTest(("heater",), ((),)),)


def test_a_search_in_a_room_is_a_test_of_all_its_places():
    flow = [{"if": 1, "then": [2]}]
    tasks = task(1, "searching", "keys", at=["bathroom"]), task(2, "taking", "keys")
    (test,) = derive(flow, *tasks)
    assert test.stages == (
        ("bathroom_shelf", "washing_machine", "medicine_cabinet", "laundry_basket", "bathroom_floor"),
    )


def test_candidates_of_a_checked_phrase_agree():
    mug = referent("mug_1", "mug_2", phrase="the mug")
    tasks = task(1, "check_state", mug, state="dirty"), task(2, "change_state", mug, state="clean")
    assert derive([{"if": 1, "then": [2]}], *tasks) == (StateTest(("mug_1", "mug_2"), "cleanliness", "dirty"),)


MUG = referent("mug_1", "mug_2", phrase="the mug")
DIRTY = ("cleanliness", "dirty")
THEN = [{"if": 1, "then": [2]}]
LAST = task(2, "informing", recipient="user")


def test_the_state_by_which_a_thing_is_told_is_tested_with_its_place():
    dirty = replace(MUG, where=(DIRTY,), is_any=True)
    there, anywhere = (task(1, "check_state", dirty, at=at, state=HERE) for at in (["desk"], []))
    assert derive(THEN, there, LAST) == (PlaceTest(("mug_1", "mug_2"), (("desk",),), (DIRTY,)),)
    assert derive(THEN, anywhere, LAST) == (PlaceTest(("mug_1", "mug_2"), ((),), (DIRTY,)),)
    search = task(1, "searching", dirty, at=["desk"])
    assert derive(THEN, search, LAST) == (PlaceTest(("mug_1", "mug_2"), (("desk",),), (DIRTY,)),)


def test_the_state_of_what_is_said_to_be_somewhere_is_tested_with_its_place():
    check = task(1, "check_state", MUG, at=["desk"], state="dirty")
    said = PlaceTest(("mug_1", "mug_2"), (("desk",),), (DIRTY,), is_said_there=True)
    assert derive(THEN, check, LAST) == (said,)
    one = replace(check, objects=(replace(MUG, is_any=True),))
    assert derive(THEN, one, LAST) == (replace(said, is_said_there=False),)


def test_what_is_asked_of_one_in_another_state_is_no_link_of_the_chain():
    flow = [{"if": 1, "else": [{"if": 2, "else": [3]}]}]
    checks = [task(n, "check_state", MUG, at=["desk"], state=state) for n, state in ((1, "dirty"), (2, "full"))]
    first, second = derive(flow, *checks, task(3, "informing", recipient="user"))
    assert (first.where, second.where) == ((DIRTY,), (("fill", "full"),))


def test_what_is_fixed_is_tested_by_its_state_alone():
    windows = referent("kitchen_window", "bedroom_window", phrase="an open window", is_any=True)
    check = task(1, "check_state", replace(windows, where=(("aperture", "open"),)), at=["kitchen"], state=HERE)
    assert derive(THEN, check, LAST) == (StateTest(("kitchen_window",), "aperture", "open"),)


def test_beside_what_may_be_anywhere_the_state_alone_is_tested():
    check = task(1, "check_state", MUG, at=["pillow"], state="dirty")
    assert derive(THEN, check, LAST) == (StateTest(("mug_1", "mug_2"), "cleanliness", "dirty"),)


def in_room(deed, person, room):
    who = referent(person)
    return replace(deed, whereabouts=((who, referent(room)),))


def test_where_somebody_is_said_to_be_is_no_question():
    bring = in_room(task(1, "bringing", "book_1", recipient="tom"), "tom", "desk")
    assert derive([1], bring) == (Whereabouts(("tom",), ("study",)),)
    later = in_room(task(2, "informing", recipient="tom"), "tom", "kitchen")
    assert derive([1, 2], bring, later) == (Whereabouts(("tom",), ("study",)),)


def test_what_is_asked_of_somebody_is_not_said():
    tell = in_room(task(2, "informing", recipient="tom"), "tom", "kitchen")
    home, there = (task(1, "check_state", "tom", at=at, state=HERE) for at in ([], ["study"]))
    assert derive(THEN, home, tell) == (PersonTest(("tom",)), Whereabouts(("tom",), ("kitchen",)))
    assert derive(THEN, there, tell) == (PersonTest(("tom",), ("study",)),)


def test_an_action_as_condition_hangs_on_what_it_needs():
    tasks = (
        task(1, "change_state", "tv", state="on"),
        task(2, "bringing", "milk", recipient="anna"),
        task(3, "change_state", "soup", state="hot"),
        task(4, "check_state", "anna", state=HERE),
        task(5, "taking", "cup_1"),
    )
    flow = [{"if": 1, "else": [{"if": 2, "else": [{"if": 3, "else": [{"if": 4, "then": [5]}]}]}]}]
    assert derive(flow, *tasks) == (
        WorksTest(("tv",)),
        PlaceTest(("milk",), ((),)),
        PersonTest(("anna",)),
        PlaceTest(("soup",), ((),)),
        WorksTest(("microwave", "oven")),
    )


def test_conditions_in_both_branches_and_after_them_are_tested():
    names = "tv", "radio", "fan", "heater"
    checks = [task(number, "check_state", name, state="on") for number, name in enumerate(names, start=1)]
    others = [task(number, "informing", recipient="user") for number in (5, 6, 7)]
    flow = [
        {"if": 1, "then": [{"if": 2, "then": [5]}], "else": [{"if": 3, "then": [6]}]},
        {"if": 4, "then": [7]},
    ]
    assert [test.entities for test in derive(flow, *checks, *others)] == [("tv",), ("radio",), ("fan",), ("heater",)]
