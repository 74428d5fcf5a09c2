"""What turns to the other case, or back: "if not ..., otherwise ...", "don't ... if ..., otherwise ..."."""

from __future__ import annotations

import pytest
from annotated import clauses

from decomplex_bt.understanding.control_flow.roles import stated_roles
from decomplex_bt.understanding.control_flow.sides import stated_sides

QUESTION = "[Is](1:check_state) [the rug](1:object) [dry](1:state)? "


@pytest.mark.parametrize(
    ("text", "sides"),
    [
        (
            "If not, [hang](2:placing) [it](2:object) [up](2:goal), otherwise [beat](3:change_state) [it](3:object).",
            "<1+",
        ),
        (
            "If not, [open](2:change_state) [the window](2:object). Otherwise, [beat](3:change_state) [it](3:object).",
            "<1+",
        ),
        ("If not, [hang](2:placing) [it](2:object), or else [beat](3:change_state) [it](3:object).", "<1+"),
        ("if not [hang](2:placing) [it](2:object) up else [beat](3:change_state) [it](3:object)", "<1+"),
        ("If so, [beat](2:change_state) [it](2:object); if not, [hang](3:placing) [it](3:object).", "<1-"),
        (
            "If not, [look](2:searching) [for another one](2:object), otherwise [tell](3:informing) [me](3:recipient).",
            "<1-",
        ),
    ],
)
def test_an_otherwise_behind_an_if_not_is_where_the_condition_holds(text: str, sides: str) -> None:
    found = clauses(QUESTION + text)
    assert stated_sides(found, ("condition", "task", "task"), ("top", "<1-", "<1-"))[2] == sides


def test_an_otherwise_behind_an_if_not_that_asks_for_nothing_is_where_the_condition_holds() -> None:
    found = clauses(QUESTION + "If not, leave it alone, otherwise [beat](2:change_state) [it](2:object).")
    assert stated_sides(found, ("condition", "task"), ("top", "<1-")) == ("top", "<1+")


@pytest.mark.parametrize(
    ("text", "role"),
    [
        (
            "[Start](1:change_state) [the mower](1:object), but if it [rains](2:check_state), don't "
            "[start](3:change_state) [it](3:object).",
            "again",
        ),
        (
            "Don't [start](1:change_state) [the mower](1:object) if it [rains](2:check_state), otherwise "
            "[start](3:change_state) [it](3:object).",
            "again",
        ),
        (
            "Don't [start](1:change_state) [the mower](1:object) if it [rains](2:check_state), otherwise "
            "[start](3:change_state) [the pump](3:object).",
            "task",
        ),
        (
            "Don't [give](1:bringing) [Lea](1:recipient) [the key](1:object). If it [rains](2:check_state), "
            "[give](3:bringing) [it](3:object) [to me](3:recipient).",
            "task",
        ),
    ],
)
def test_what_is_forbidden_in_one_case_and_ordered_in_the_other_is_one_order(text: str, role: str) -> None:
    assert stated_roles(clauses(text), ("task", "condition", "task"))[2] == role


def test_what_is_ordered_ahead_of_what_is_forbidden_of_another_thing_is_done_in_any_case() -> None:
    found = clauses(
        "[Light](1:change_state) [the stove](1:object), but don't [wake](2:change_state) [Ivo](2:object) if "
        "[he](3:object)'[s](3:check_state) [asleep](3:state)."
    )
    assert stated_sides(found, ("task", "task", "condition"), (">1-", ">1-", "top")) == ("top", ">1-", "top")


@pytest.mark.parametrize(
    ("again", "side"),
    [
        ("if [it](4:object)'[s](4:check_state) [cold](4:state)", "<1"),
        ("if [it](4:object)'[s](4:check_state) not [hot](4:state)", "<1"),
        ("if [it](4:object) [isn't](4:check_state) [there](4:location)", "<2"),
    ],
)
def test_of_two_conditions_the_one_whose_state_or_place_is_said_is_taken_up(again: str, side: str) -> None:
    found = clauses(
        "If [the pan](1:object) [is](1:check_state) [on the stove](1:location) and [it](2:object)'[s](2:check_state) "
        f"[hot](2:state), [fetch](3:taking) [the rice](3:object); {again}, [tell](5:informing) [me](5:recipient)."
    )
    for joint, attachment in (("condition", "<1+"), ("and", "<1+")):
        roles = stated_roles(found, ("condition", joint, "task", "mention", "task"))
        assert roles == ("condition", "condition", "task", "mention", "task")
        assert stated_sides(found, roles, ("top", attachment, "<1+", "<1", "<1+"))[3] == side


@pytest.mark.parametrize(
    ("question", "roles"),
    [
        ("[See](1:check_state) what [Ivo](1:object) is doing", ("task", "condition", "task")),
        ("[Check](1:check_state) how [Ivo](1:object) is", ("task", "condition", "task")),
        ("[See](1:check_state) if [Ivo](1:object) is [up](1:state)", ("condition", "mention", "task")),
    ],
)
def test_what_no_yes_or_no_answers_is_no_condition(question: str, roles: tuple[str, ...]) -> None:
    found = clauses(
        f"{question}, and if [he](2:object)'[s](2:check_state) [asleep](2:state), [shut](3:change_state) "
        "[the door](3:object)."
    )
    assert stated_roles(found, ("condition", "mention", "task")) == roles


@pytest.mark.parametrize(("says", "side"), [("isn't", "<1-"), ("is", "<1+")])
def test_what_is_done_if_it_is_not_is_done_where_the_check_proves_false(says: str, side: str) -> None:
    found = clauses(
        "[See](1:check_state) whether [the hatch](1:object) is [shut](1:state), and [oil](2:change_state) "
        f"[it](2:object) if [it](3:object) [{says}](3:check_state)."
    )
    assert stated_sides(found, ("condition", "task", "mention"), ("top", "<1+", "<1"))[1] == side


def test_what_is_done_if_she_does_is_done_in_the_case_of_the_order_ahead() -> None:
    text = (
        "[Leave](1:change_state) [the gate](1:object) [open](1:state) in case [Lea](2:object) [comes](2:check_state), "
        "and if [she](3:object) [{says}](3:check_state), [shut](4:change_state) [it](4:object)."
    )
    labels = ("task", "condition", "mention", "task"), (">1+", "top", "<1", "<1+")
    assert stated_sides(clauses(text.format(says="does")), *labels)[3] == "<1-"
    assert stated_sides(clauses(text.format(says="doesn't")), *labels)[3] == "<1+"


@pytest.mark.parametrize(
    ("text", "roles", "sides", "expected"),
    [
        (
            "[Open](1:change_state) [the hatch](1:object) if [it](2:object) [smells](2:check_state), "
            "[shut](3:change_state) [it](3:object) if [it](4:object) [does](4:check_state)n't.",
            ("task", "condition", "task", "mention"),
            (">1+", "top", "<1+", "<1"),
            "<1-",
        ),
        (
            "[Open](1:change_state) [the hatch](1:object) if [it](2:object) [smells](2:check_state), if "
            "[it](3:object) [does](3:check_state)n't, [shut](4:change_state) [it](4:object).",
            ("task", "condition", "mention", "task"),
            (">1+", "top", "<1", "<1+"),
            "<1+",  # the mention, stated again, is the other case by itself
        ),
    ],
)
def test_what_is_done_if_it_does_not_is_done_in_the_other_case(
    text: str, roles: tuple[str, ...], sides: tuple[str, ...], expected: str
) -> None:
    found = stated_sides(clauses(text), roles, sides)
    assert found[roles.index("task", 1)] == expected
