"""The states of one thing, told one by one: each is a condition of its own, asked where the ones before do not hold."""

from __future__ import annotations

import pytest
from annotated import clauses

from decomplex_bt.understanding.control_flow.roles import stated_roles
from decomplex_bt.understanding.control_flow.sides import stated_sides

THREE = (
    "If [the {thing}](1:object) [is](1:check_state) [{first}](1:state), [dust](2:change_state) [the shelf](2:object), "
    "if [it](3:object)'[s](3:check_state) [{second}](3:state), [get](4:taking) [the mop](4:object), and if "
    "[it](5:object)'[s](5:check_state) [{third}](5:state), [tell](6:informing) [me](6:recipient)."
)
ROLES = ("condition", "task", "mention", "task", "mention", "task")
SIDES = ("top", "<1+", "<1", "<1-", "<1", "<1-")


@pytest.mark.parametrize(
    ("thing", "first", "second", "third"),
    [
        ("stove", "hot", "lukewarm", "cold"),
        ("bucket", "full", "half full", "empty"),
        ("lamp", "on", "flickering", "off"),
        ("sign", "green", "amber", "red"),
    ],
)
def test_of_three_states_each_is_asked_where_those_before_do_not_hold(
    thing: str, first: str, second: str, third: str
) -> None:
    found = clauses(THREE.format(thing=thing, first=first, second=second, third=third))
    roles = stated_roles(found, ROLES)
    assert roles == ("condition", "task") * 3
    assert stated_sides(found, roles, SIDES) == ("top", "<1+", "<1-", "<1+", "<1-", "<1+")


@pytest.mark.parametrize(
    ("first", "second", "third"),
    [
        ("hot", "lukewarm", "hot"),  # said again
        ("wobbly", "useless", "cheap"),  # of one matter or not, who knows
    ],
)
def test_what_may_be_stated_again_or_beside_is_left_to_the_models(first: str, second: str, third: str) -> None:
    found = clauses(THREE.format(thing="stove", first=first, second=second, third=third))
    assert stated_roles(found, ROLES)[4] == "mention"


def test_another_matter_is_a_condition_of_its_own() -> None:
    found = clauses(THREE.format(thing="stove", first="hot", second="cold", third="dirty"))
    assert stated_roles(found, ROLES)[4] == "condition"


def test_what_is_called_for_behind_its_order_is_left_to_the_models() -> None:
    found = clauses(
        "If [the stove](1:object) [is](1:check_state) [hot](1:state), [dust](2:change_state) [the shelf](2:object), if "
        "[it](3:object)'[s](3:check_state) [lukewarm](3:state), [get](4:taking) [the mop](4:object), and "
        "[tell](5:informing) [me](5:recipient) if [it](6:object)'[s](6:check_state) [cold](6:state)."
    )
    roles = ("condition", "task", "mention", "task", "task", "mention")
    assert stated_roles(found, roles) == roles


@pytest.mark.parametrize(
    ("first", "second", "pronoun", "expected"),
    [
        ("green", "red", "it", "<1-"),
        ("green", "red", "that", "<1+"),
        ("green", "broken", "it", "<1+"),
        ("green", "green", "it", "<1+"),
    ],
)
def test_another_state_is_not_asked_where_the_thing_has_the_one_before(
    first: str, second: str, pronoun: str, expected: str
) -> None:
    found = clauses(
        f"If [the sign](1:object) [is](1:check_state) [{first}](1:state), [wait](2:motion), and if "
        f"[{pronoun}](3:object)'[s](3:check_state) [{second}](3:state), [tell](4:informing) [me](4:recipient)."
    )
    roles = ("condition", "task", "condition", "task")
    assert stated_sides(found, roles, ("top", "<1+", "<1+", "<1+"))[2] == expected


@pytest.mark.parametrize(("first", "expected"), [("the goats", "<1-"), ("the goat", "<1+")])
def test_some_of_them_is_of_those_and_of_no_single_thing(first: str, expected: str) -> None:
    found = clauses(
        f"If [{first}](1:object) [are](1:check_state) [asleep](1:state), [shut](2:change_state) [the gate](2:object), "
        "and if [one of them](3:object) [is](3:check_state) [awake](3:state), [tell](4:informing) [me](4:recipient)."
    )
    roles = ("condition", "task", "condition", "task")
    assert stated_sides(found, roles, ("top", "<1+", "<1+", "<1+"))[2] == expected


@pytest.mark.parametrize(
    ("asked", "role"), [("", "mention"), (" whether [he](1:object) is [well](1:state)", "condition")]
)
def test_the_first_of_three_states_is_what_a_check_before_asks(asked: str, role: str) -> None:
    thing = "" if asked else " on [Leo](1:object)"
    found = clauses(
        f"[Check](1:check_state){thing}{asked}. If [he](2:object)'[s](2:check_state) [awake](2:state), "
        "[call](3:informing) [me](3:recipient), if [he](4:object)'[s](4:check_state) [dozing](4:state), "
        "[wait](5:motion), and if [he](6:object)'[s](6:check_state) [asleep](6:state), "
        "[shut](7:change_state) [the door](7:object)."
    )
    roles = ("condition", "condition", "task", "mention", "task", "mention", "task")
    told = stated_roles(found, roles)
    assert told == ("condition", role, "task", "condition", "task", "condition", "task")
    sides = stated_sides(found, told, ("top", "<1+", "<1+", "<1+", "<1+", "<1+", "<1+"))
    assert (sides[1] == "<1") == (role == "mention")
    assert (sides[3], sides[5]) == ("<1-", "<1-")
