"""Which clauses are conditions of their own, parts of one, or mentions of an earlier one."""

from __future__ import annotations

import pytest
from annotated import clauses

from decomplex_bt.understanding.control_flow.contrasts import is_of_another
from decomplex_bt.understanding.control_flow.failures import finds_out, is_absence_of, is_failure_of
from decomplex_bt.understanding.control_flow.roles import stated_roles
from decomplex_bt.understanding.control_flow.sides import stated_sides
from decomplex_bt.understanding.interpreter import Interpreter

WET_OR_DARK = (
    "[it](2:object)['s](2:check_state) [wet](2:state) {} [the lamp](3:object) [is](3:check_state) [off](3:state)"
)
GO = "[Go](1:motion) [out](1:goal)"


@pytest.mark.parametrize(
    "markup",
    [
        # where it is, then how it is
        "[Check](1:check_state) whether [the boots](1:object) are [in the hall](1:location). If [they](2:object) "
        "[are](2:check_state) [muddy](2:state), [wash](3:change_state) [them](3:object).",
        # one timer, several scones
        "When [the timer](1:object) [rings](1:check_state), [open](2:change_state) [the oven](2:object). If "
        "[they](3:object)['re](3:check_state) [pale](3:state), [close](4:change_state) [it](4:object).",
    ],
)
def test_a_check_of_another_matter_is_a_condition_of_its_own(markup: str) -> None:
    found = clauses(markup)
    later = next(k for k in range(1, len(found)) if found[k].task.type == "check_state")
    assert is_of_another(found[later], found[0])
    roles = ["condition", *["task"] * (len(found) - 1)]
    roles[later] = "mention"
    assert stated_roles(found, roles)[later] == "condition"


@pytest.mark.parametrize(
    "markup",
    [
        "If [the boots](1:object) [are](1:check_state) [in the hall](1:location), [wash](2:change_state) "
        "[them](2:object). If [they](3:object)['re](3:check_state) [gone](3:state), [tell](4:informing) me.",
        "If [the boots](1:object) [are](1:check_state) [wet](1:state), [dry](2:change_state) [them](2:object). If "
        "[they](3:object)['re](3:check_state) [dry](3:state), [tell](4:informing) me.",
        # one guest, who is "they"
        "If [the guest](1:object) [is](1:check_state) [asleep](1:state), [close](2:change_state) [it](2:object). If "
        "[they](3:object)['re](3:check_state) [awake](3:state), [tell](4:informing) me.",
        # one window, "them"
        "If [the window](1:object) [is](1:check_state) [closed](1:state), [open](2:change_state) [it](2:object). If "
        "[they](3:object)['re](3:check_state) [open](3:state), [tell](4:informing) me.",
        "If [the drops](1:object) [are](1:check_state) [in it](1:location), [bring](2:bringing) [it](2:object). If "
        "[they](3:object) [are](3:check_state)n't, [tell](4:informing) me.",
        # where the lamp is off it is dark
        "If [the lamp](1:object) [is](1:check_state) [on](1:state), [shut](2:change_state) [the hatch](2:object). If "
        "[it](3:object)['s](3:check_state) [dark](3:state), [tell](4:informing) me.",
        # where guests are it is occupied
        "If there [are](1:check_state) [guests](1:object) [in the den](1:location), [tell](2:informing) me. "
        "If [it](3:object)['s](3:check_state) [unoccupied](3:state), [wash](4:change_state) [it](4:object).",
        # what is in it tells whether it is empty
        "If [the bath](1:object) [is](1:check_state) [empty](1:state), [fill](2:change_state) [it](2:object). If there"
        "['s](3:check_state) [water](3:object) [in it](3:location), [tell](4:informing) me.",
        # all that is said is that it does not
        "If [the guest](1:object) [rings](1:check_state), [open](2:change_state) [the hatch](2:object). If "
        "[it](3:object) [does](3:check_state)n't, [tell](4:informing) me.",
    ],
)
def test_what_says_the_same_again_or_its_opposite_stays_a_mention(markup: str) -> None:
    found = clauses(markup)
    assert not is_of_another(found[2], found[0])
    roles = ("condition", "task", "mention", "task")
    assert stated_roles(found, roles) == roles


@pytest.mark.parametrize(
    ("state", "expected"),
    [("burnt", ("task", "condition", "task")), ("raw", ("condition", "mention", "task"))],
)
def test_a_state_that_has_nothing_to_do_with_the_one_asked_is_a_condition_of_its_own(
    state: str, expected: tuple[str, ...]
) -> None:
    found = clauses(
        "[Check](1:check_state) if [the cake](1:object) is [done](1:state), and if [it](2:object)['s](2:check_state) "
        f"[{state}](2:state), [cover](3:change_state) [it](3:object)."
    )
    assert stated_roles(found, ("condition", "mention", "task")) == expected


@pytest.mark.parametrize(
    ("asked", "expected"),
    [
        ("[Check](1:check_state) that [the hatch](1:object) is [shut](1:state)", ("task", "condition", "task")),
        ("[See](1:check_state) whether [the hatch](1:object) is [locked](1:state)", ("task", "condition", "task")),
        # what is still muddy is not clean yet
        ("[Check](1:check_state) that [the hatch](1:object) is [dry](1:state)", ("condition", "mention", "task")),
        # a question, and what it is asked for
        ("[Is](1:check_state) [the hatch](1:object) [shut](1:state)", ("condition", "mention", "task")),
    ],
)
def test_what_is_still_so_is_of_another_matter_than_what_was_to_be_checked(
    asked: str, expected: tuple[str, ...]
) -> None:
    found = clauses(
        f"{asked}. If [it](2:object)['s](2:check_state) still [muddy](2:state), [wipe](3:change_state) [it](3:object)."
    )
    assert stated_roles(found, ("condition", "mention", "task")) == expected


@pytest.mark.parametrize(
    ("markup", "role", "expected"),
    [
        (f"{GO} if " + WET_OR_DARK.format("or") + ".", "task", "or"),
        (f"{GO} if " + WET_OR_DARK.format("and") + ".", "task", "and"),
        (f"{GO} unless " + WET_OR_DARK.format("or") + ".", "condition", "and"),
        # told ahead of the order, the second may lie in the branch of the first
        ("[Go](1:motion). If " + WET_OR_DARK.format("and") + ", [turn](4:motion) round.", "condition", "condition"),
        # behind a mark, it may be anything
        (f"{GO} if " + WET_OR_DARK.format(", and") + ".", "task", "task"),
        # an order to check
        (
            f"{GO} if [it](2:object)['s](2:check_state) [dry](2:state) and [check](3:check_state) that "
            "[the lamp](3:object) is [off](3:state).",
            "task",
            "task",
        ),
        # no "if" governs the first
        (
            f"{GO}: [it](2:object)['s](2:check_state) [dry](2:state) or [the lamp](3:object) [is](3:check_state) "
            "[off](3:state).",
            "task",
            "task",
        ),
    ],
)
def test_checks_under_one_if_are_one_condition_of_two_parts(markup: str, role: str, expected: str) -> None:
    found = clauses(markup)
    roles = ["task", "condition", role, *["task"] * (len(found) - 3)]
    assert stated_roles(found, roles)[2] == expected
    assert stated_roles(found, ["task", "task", role, *roles[3:]])[2] == role


@pytest.mark.parametrize(
    ("check", "is_found_out"),
    [
        ("[they](3:object)['re](3:check_state) not [there](3:location)", True),
        ("[they](3:object)['re](3:check_state) not [in the shed](3:location)", True),
        ("[they](3:object)['re](3:check_state) [there](3:location)", False),
        ("[they](3:object)['re](3:check_state) not [in the hall](3:location)", False),
        ("[Tom](3:object)['s](3:check_state) not [there](3:location)", False),
        ("[they](3:object)['re](3:check_state) not [clean](3:state)", False),
    ],
)
def test_that_something_is_not_there_tells_what_the_search_found_out(check: str, is_found_out: bool) -> None:
    found = clauses(
        "[Get](1:taking) [the tongs](1:object) [from the shed](1:source) and [hang](2:placing) [them](2:object) up. "
        f"If {check}, [call](4:informing) me."
    )
    assert finds_out(found[0], found[2]) == is_found_out
    roles = stated_roles(found, ["task", "task", "condition", "task"])
    assert roles == (
        ("condition", "task", "mention", "task") if is_found_out else ("task", "task", "condition", "task")
    )


@pytest.mark.parametrize(
    ("check", "is_absence"),
    [
        ("[she](2:object)['s](2:check_state) [out](2:state)", True),
        ("[she](2:object) [is](2:check_state)n't [home](2:location)", True),
        ("[she](2:object) [is](2:check_state) not [in](2:state)", True),
        ("[she](2:object)['s](2:check_state) [home](2:location)", False),
        ("[she](2:object)['s](2:check_state) [asleep](2:state)", False),
        ("[Tom](2:object)['s](2:check_state) [out](2:state)", False),
    ],
)
def test_that_somebody_is_out_tells_what_came_of_an_errand_to_them(check: str, is_absence: bool) -> None:
    found = clauses(
        f"[Take](1:bringing) [the soup](1:object) [to Ann](1:recipient). If {check}, [leave](3:placing) [it](3:object)."
    )
    assert is_absence_of(found[1], found[0]) == is_absence
    roles = stated_roles(found, ["task", "condition", "task"])
    assert roles == (("condition", "mention", "task") if is_absence else ("task", "condition", "task"))


@pytest.mark.parametrize(("given", "is_absence"), [("the tongs", False), ("the soup", True)])
def test_they_may_be_what_is_given(given: str, is_absence: bool) -> None:
    found = clauses(
        f"[Give](1:bringing) [{given}](1:object) [to the guests](1:recipient). If [they](2:object) "
        "[are](2:check_state)n't [there](2:location), [call](3:informing) me."
    )
    assert is_absence_of(found[1], found[0]) == is_absence


@pytest.mark.parametrize(
    ("order", "is_absence"),
    [
        ("[give](3:bringing) [it](3:object) [to Tom](3:recipient)", True),
        ("[leave](3:placing) [it](3:object) [with Tom](3:goal)", True),
        ("[open](3:change_state) [the door](3:object)", False),
    ],
)
def test_that_somebody_else_is_out_too_tells_what_came_of_the_errand_to_them(order: str, is_absence: bool) -> None:
    found = clauses(
        "[Take](1:bringing) [the cake](1:object) [to Lea](1:recipient). If [she](2:object) [is](2:check_state)n't "
        f"[in](2:location), {order}, and if [he](4:object) [is](4:check_state)n't [in](4:location) either, "
        "[call](5:informing) me."
    )
    roles = stated_roles(found, ("condition", "mention", "task", "mention", "task"))
    assert roles == ("condition", "mention", "condition" if is_absence else "task", "mention", "task")


def test_whether_somebody_is_in_is_asked_once() -> None:
    found = clauses(
        "If [Ann](1:object) [is](1:check_state) [home](1:location), [take](2:bringing) [her](2:recipient) [the soup]"
        "(2:object). If [she](3:object)['s](3:check_state) [out](3:state), [leave](4:placing) [it](4:object)."
    )
    roles = ("condition", "task", "mention", "task")
    assert stated_roles(found, roles) == roles


@pytest.mark.parametrize(
    ("check", "is_failure"),
    [
        ("[it](2:object) won't [open](2:check_state)", True),
        ("[it](2:object) doesn't [start](2:check_state)", True),
        ("[it](2:object) doesn't [come](2:check_state) [on](2:state)", True),
        ("[it](2:object) doesn't [turn](2:check_state) [green](2:state)", False),
        ("[the door](2:object) won't [open](2:check_state)", True),
        ("[a door](2:object) won't [open](2:check_state)", False),
        ("[it](2:object) still won't [open](2:check_state)", False),
        ("[it](2:object) won't [fit](2:check_state)", False),
        ("[the key](2:object) won't [turn](2:check_state)", False),
        ("[it](2:object) [starts](2:check_state)", False),
        ("[they](2:object) won't [open](2:check_state)", False),  # one door
        ("[it](2:object) doesn't [work](2:check_state) today", False),
        ("[it](2:object) doesn't [come](2:check_state)", False),
    ],
)
def test_that_it_does_not_do_so_tells_what_came_of_a_change(check: str, is_failure: bool) -> None:
    found = clauses(f"[Unlock](1:change_state) [the door](1:object). If {check}, [call](3:informing) me.")
    assert is_failure_of(found[1], found[0], found[0]) == is_failure
    roles = stated_roles(found, ["task", "condition", "task"])
    assert roles == (("condition", "mention", "task") if is_failure else ("task", "condition", "task"))


@pytest.mark.parametrize(
    ("order", "check", "is_failure"),
    [
        ("[switch](1:change_state) [on](1:state) [the fan](1:object)", "it's](2:check_state) [broken](2:state)", True),
        (
            "[turn](1:change_state) [the fan](1:object) [on](1:state)",
            "it's](2:check_state) out of [order](2:state)",
            True,
        ),
        (
            "[turn](1:change_state) [the fan](1:object) [on](1:state)",
            "it's](2:check_state) not [broken](2:state)",
            False,
        ),
        ("[turn](1:change_state) [the fan](1:object) [on](1:state)", "it's](2:check_state) [loud](2:state)", False),
        ("[turn](1:change_state) [the fan](1:object) [off](1:state)", "it's](2:check_state) [broken](2:state)", False),
    ],
)
def test_that_it_is_broken_tells_what_came_of_switching_it_on(order: str, check: str, is_failure: bool) -> None:
    check = check.replace("it's", "it](2:object) [is")
    found = clauses(f"{order}. If [{check}, [call](3:informing) me.")
    assert is_failure_of(found[1], found[0], found[0]) == is_failure


def test_that_a_thing_by_name_does_not_do_so_tells_of_what_was_done_to_it() -> None:
    """The trunk was asked about before: it is its unlocking that failed."""
    found = clauses(
        "If [the trunk](1:object) [is](1:check_state) [locked](1:state), [unlock](2:change_state) [it](2:object). If "
        "[the trunk](3:object) won't [open](3:check_state), [call](4:informing) me."
    )
    roles = stated_roles(found, ("condition", "task", "mention", "task"))
    assert roles == ("condition", "condition", "mention", "task")
    assert stated_sides(found, roles, ("top", "<1+", "<2", "<1+")) == ("top", "<1+", "<1", "<1+")


@pytest.mark.parametrize(("thing", "is_failure"), [("the machine", True), ("the bin", True), ("the radio", False)])
def test_that_where_things_were_put_does_not_start_tells_of_its_being_started(thing: str, is_failure: bool) -> None:
    place = "machine" if thing != "the bin" else "bin"
    found = clauses(
        f"[Put](1:placing) [the shirts](1:object) [in the old {place}](1:goal) and [start](2:change_state) "
        "[it](2:object). "
        f"If [{thing}](3:object) doesn't [start](3:check_state), [call](4:informing) me."
    )
    assert is_failure_of(found[2], found[1], found[0]) == is_failure


@pytest.mark.parametrize(
    ("first", "second", "role"),
    [
        ("is](1:check_state) [on](1:state)", "is](3:check_state) [off](3:state)", "mention"),
        ("is](1:check_state) [on](1:state)", "is](3:check_state) not [on](3:state)", "mention"),
        ("is](1:check_state) not [on](1:state)", "is](3:check_state) not [off](3:state)", "mention"),
        ("is](1:check_state) [on](1:state)", "is](3:check_state) not [off](3:state)", "condition"),
        ("is](1:check_state) [on](1:state)", "is](3:check_state) [loud](3:state)", "condition"),
    ],
)
def test_the_opposite_of_the_same_thing_is_the_other_side_of_one_condition(first: str, second: str, role: str) -> None:
    found = clauses(
        f"If [the fan](1:object) [{first}, [open](2:change_state) [the door](2:object). If [the fan](3:object) "
        f"[{second}, [close](4:change_state) [it](4:object)."
    )
    assert stated_roles(found, ("condition", "task", "condition", "task"))[2] == role


def test_the_opposite_of_another_thing_is_a_condition_of_its_own() -> None:
    found = clauses(
        "If [the fan](1:object) [is](1:check_state) [on](1:state), [open](2:change_state) [the door](2:object). If "
        "[the lamp](3:object) [is](3:check_state) [off](3:state), [close](4:change_state) [it](4:object)."
    )
    assert stated_roles(found, ("condition", "task", "condition", "task"))[2] == "condition"


@pytest.mark.parametrize(
    ("first", "second", "role"),
    [
        ("[on the desk](1:location)", "[on the sill](3:location)", "condition"),
        ("[in the den](1:location)", "[in the attic](3:location)", "condition"),
        ("[on the desk](1:location)", "[on the desk](3:location)", "mention"),
        ("[on the desk](1:location)", "", "mention"),
    ],
)
def test_the_opposite_of_a_thing_elsewhere_is_a_condition_of_its_own(first: str, second: str, role: str) -> None:
    found = clauses(
        f"If [the jar](1:object) {first} [is](1:check_state) [empty](1:state), [fill](2:change_state) [it](2:object). "
        f"If [the jar](3:object) {second} [is](3:check_state) [full](3:state), [empty](4:change_state) [it](4:object)."
    )
    for roles in (("condition", "task", "condition", "task"), ("condition", "task", "mention", "task")):
        assert stated_roles(found, roles)[2] == role


def test_what_an_order_hangs_on_behind_it_is_no_mention_of_the_state_of_something_else_of_the_same_room() -> None:
    found = clauses(
        "If [the attic window](1:object) [is](1:check_state) [shut](1:state), [switch](2:change_state) "
        "[the attic fan](2:object) [off](2:state) if [it](3:object) [is](3:check_state) [on](3:state)."
    )
    assert stated_roles(found, ("condition", "task", "mention"))[2] == "condition"


@pytest.mark.parametrize(
    "markup",
    [
        "If there [is](1:check_state) no [milk](1:object), [bring](2:bringing) [tea](2:object). If there "
        "[is](3:check_state) no [tea](3:object), [tell](4:informing) me.",
        "If [the cup](1:object) [is](1:check_state) [clean](1:state), [bring](2:bringing) [it](2:object). If "
        "[it](3:object)['s](3:check_state) [missing](3:state), [tell](4:informing) me.",
    ],
)
def test_the_same_of_another_thing_and_its_want_are_conditions_of_their_own(markup: str) -> None:
    found = clauses(markup)
    assert stated_roles(found, ("condition", "task", "mention", "task"))[2] == "condition"


ASKING = "If [the lamp](1:object) [is](1:check_state) [off](1:state), [ask](2:informing) [Ann](2:recipient) "


@pytest.mark.parametrize(
    ("question", "answer", "role"),
    [
        ("[whether she's reading](2:message)", "[she](3:object) [is](3:check_state)", "condition"),
        ("[if she wants tea](2:message)", "[she](3:object) [does](3:check_state)n't", "condition"),
        ("[if she wants tea](2:message)", "[she](3:object) [has](3:check_state)n't", "mention"),
        ("[if she's been told](2:message)", "[she](3:object) [has](3:check_state)n't", "condition"),
        ("[for a bulb](2:message)", "[she](3:object) [is](3:check_state)", "mention"),
        ("[whether she's reading](2:message)", "[it](3:object) [is](3:check_state)", "mention"),
        ("[if she wants tea](2:message)", "[she](3:object) [is](3:check_state) [out](3:state)", "mention"),
    ],
)
def test_how_somebody_answers_is_asked_where_the_question_is(question: str, answer: str, role: str) -> None:
    found = clauses(f"{ASKING}{question}, and if {answer}, [close](4:change_state) [the door](4:object).")
    roles = stated_roles(found, ("condition", "task", "mention", "task"))
    assert roles[2] == role
    side = "<1+" if role == "condition" else "<1"
    assert stated_sides(found, roles, ("top", "<1+", "<1", "<1+"))[2] == side


def test_an_answer_of_somebody_whose_whereabouts_were_asked_is_left_to_the_models() -> None:
    found = clauses(
        "If [Ann](1:object) [is](1:check_state) [in](1:state), [ask](2:informing) [her](2:recipient) [if she wants tea]"
        "(2:message), and if [she](3:object) [is](3:check_state)n't, [close](4:change_state) [the door](4:object)."
    )
    assert stated_roles(found, ("condition", "task", "mention", "task"))[2] == "mention"


def test_a_search_of_a_place_asks_after_nobody() -> None:
    found = clauses(
        "[Look](1:searching) [in the van](1:location). If [it](2:object) [is](2:check_state)n't [there](2:location), "
        "[ask](3:informing) [Ann](3:recipient) [if she has it](3:message), and if [she](4:object) "
        "[does](4:check_state), [close](5:change_state) [the door](5:object)."
    )
    roles = ("condition", "mention", "task", "mention", "task")
    assert stated_roles(found, roles) == ("condition", "mention", "task", "condition", "task")


def test_an_order_said_again_to_put_something_ahead_of_it_is_carried_out_once() -> None:
    found = clauses(
        "[Bring](1:bringing) [me](1:recipient) [the cup](1:object), and if [it](2:object) [is](2:check_state) "
        "[dirty](2:state), [wash](3:change_state) [it](3:object) before you [bring](4:bringing) [it](4:object)."
    )
    roles = stated_roles(found, ("task", "condition", "task", "task"))
    assert roles == ("task", "condition", "task", "again")
    assert stated_sides(found, roles, ("top", "top", "<1+", "<1+"))[3] == "<2"


@pytest.mark.parametrize("other", ["the plate", "the other one", "the blue one"])
def test_an_order_of_another_thing_is_no_repeat(other: str) -> None:
    found = clauses(
        "[Bring](1:bringing) [me](1:recipient) [the cup](1:object), but [wash](2:change_state) [it](2:object) before "
        f"you [bring](3:bringing) [{other}](3:object)."
    )
    assert stated_roles(found, ("task", "task", "task"))[2] == "task"


def test_what_was_asked_about_before_is_missed_by_that() -> None:
    """Where it is was asked before it was brought somewhere: that it is not there tells nothing of the bringing."""
    found = clauses(
        "[Look](1:searching) [for the tongs](1:object). If [they](2:object) [are](2:check_state) [there](2:location), "
        "[bring](3:bringing) [them](3:object) [to the patio](3:goal). If [they](4:object) [are](4:check_state) not "
        "[there](4:location), [tell](5:informing) me."
    )
    roles = ("condition", "mention", "task", "mention", "task")
    assert stated_roles(found, roles) == roles


def test_he_is_where_it_was_asked_he_was() -> None:
    found = clauses(
        "If [Tom](1:object) [is](1:check_state) [home](1:location), [tell](2:informing) [him](2:recipient) "
        "[the soup is on the stove](2:message). If [he](3:object) [is](3:check_state)n't [home](3:location), "
        "[wrap](4:change_state) [it](4:object)."
    )
    roles = ("condition", "task", "mention", "task")
    assert stated_roles(found, roles) == roles


def test_what_hangs_on_a_check_behind_it_is_not_what_it_tells_of() -> None:
    found = clauses(
        "[Take](1:taking) [the bag](1:object) [from the shed](1:source) if [it](2:object) [is](2:check_state)n't "
        "[there](2:location) any more."
    )
    assert finds_out(found[0], found[1])
    assert stated_roles(found, ["task", "condition"]) == ("task", "condition")


@pytest.mark.parametrize(
    ("first", "second", "role"),
    [
        (
            "[the trunk](1:object) [is](1:check_state) [shut](1:state)",
            "nobody [is](3:check_state) [asleep](3:state)",
            "condition",
        ),
        (
            "[the lamp](1:object) [is](1:check_state) [on](1:state)",
            "there['s](3:check_state) no one [in](3:location)",
            "condition",
        ),
        (
            "[the bath](1:object) [is](1:check_state) [free](1:state)",
            "nobody [is](3:check_state) [in](3:location)",
            "mention",
        ),
        (
            "[Anna](1:object) [is](1:check_state) [home](1:location)",
            "nobody [is](3:check_state) [home](3:location)",
            "mention",
        ),
        (
            "[the lamp](1:object) [is](1:check_state) [on](1:state)",
            "it['s](3:check_state) [raining](3:state)",
            "condition",
        ),
        ("it['s](1:check_state) [sunny](1:state)", "it['s](3:check_state) [raining](3:state)", "mention"),
    ],
)
def test_a_check_of_another_matter_is_no_mention(first: str, second: str, role: str) -> None:
    found = clauses(f"If {first}, [go](2:motion) [out](2:goal), and if {second}, [come](4:motion) [back](4:goal).")
    assert stated_roles(found, ("condition", "task", "mention", "task"))[2] == role


def test_an_order_to_check_is_no_condition_of_what_hangs_on_the_weather() -> None:
    found = clauses(
        "[See](1:check_state) if [the post](1:object) has [come](1:state). "
        "If it['s](2:check_state) [raining](2:state), [take](3:taking) [the umbrella](3:object)."
    )
    assert stated_roles(found, ("condition", "mention", "task")) == ("task", "condition", "task")


@pytest.mark.parametrize(
    ("order", "role"),
    [("[open](3:change_state) [it](3:object)", "task"), ("[get](3:bringing) [it](3:object)", "again")],
)
def test_what_is_of_another_type_says_no_order_again(order: str, role: str) -> None:
    found = clauses(f"[Close](1:change_state) it. [Fetch](2:bringing) [the crowbar](2:object) and {order} again.")
    assert stated_roles(found, ("condition", "task", "again"))[2] == role


def test_yes_and_no_are_the_sides_of_an_answer() -> None:
    found = clauses(
        "[Ask](1:informing) [Lea](1:recipient) [if she wants soap](1:message). If [she](2:object) "
        "[says](2:check_state) [yes](2:state), [bring](3:bringing) some, and if [she](4:object) "
        "[says](4:check_state) [no](4:state), [go](5:motion)."
    )
    stated = stated_roles(found, ("task", "condition", "task", "condition", "task"))
    assert stated == ("task", "condition", "task", "mention", "task")


def test_an_answer_is_no_mention_of_the_question() -> None:
    asked = clauses(
        "[Ask](1:informing) [Lea](1:recipient) [if she is in](1:message); if [she](2:object) "
        "[answers](2:check_state) no, [go](3:motion)."
    )
    assert stated_roles(asked, ("condition", "mention", "task")) == ("task", "condition", "task")


@pytest.mark.parametrize(("asked", "role"), [("is [on](1:state)", "condition"), ("is", "mention")])
def test_what_there_is_beside_is_no_mention_of_another_state(asked: str, role: str) -> None:
    found = clauses(
        f"[See](1:check_state) if [the grill](1:object) {asked}; if there [are](2:check_state) [clean "
        "forks](2:object), [bring](3:bringing) [me](3:recipient) [one](3:object)."
    )
    assert stated_roles(found, ("condition", "mention", "task"))[1] == role


def test_how_somebody_answers_what_they_are_asked_in_the_same_sentence_is_a_condition_of_its_own() -> None:
    found = clauses(
        "If [Leo](1:object) [is](1:check_state) [up](1:state), [ask](2:informing) [him](2:recipient) [whether he wants "
        "a bun](2:message), and if [he](3:object) [does](3:check_state), [fetch](4:taking) [one](4:object)."
    )
    assert stated_roles(found, ("condition", "task", "mention", "task"))[2] == "condition"


def test_what_an_answer_says_is_what_was_asked() -> None:
    instruction = Interpreter.load().interpret("If Nan's home, ask her if she's thirsty, and if she is, boil the milk.")
    assert instruction.task(3).value("state") == "thirsty"


@pytest.mark.parametrize(
    ("order", "place", "role"),
    [
        ("[Wash](1:change_state) [the pot](1:object)", "[in the attic](2:location)", "condition"),
        ("[Bring](1:bringing) [Ann](1:recipient) [the pot](1:object)", "[in the attic](2:location)", "mention"),
        ("[Take](1:bringing) [the pot](1:object) [to the attic](1:goal)", "[in the attic](2:location)", "mention"),
        ("[Take](1:bringing) [the pot](1:object) [to the attic](1:goal)", "[there](2:location)", "mention"),
        ("[Wash](1:change_state) [the pot](1:object)", "[there](2:location)", "condition"),
    ],
)
def test_that_nobody_is_in_a_place_is_no_failure_of_what_is_done_elsewhere(order: str, place: str, role: str) -> None:
    found = clauses(f"{order}. If nobody [is](2:check_state) {place}, [shut](3:change_state) [the gate](3:object).")
    roles = stated_roles(found, ("condition", "mention", "task"))
    assert roles == (("task" if role == "condition" else "condition"), role, "task")


@pytest.mark.parametrize(
    ("markup", "role"),
    [
        (
            "If [the modem](1:object) [is](1:check_state) [red](1:state), [restart](2:change_state) [it](2:object), "
            "and if [it](3:object)['s](3:check_state) still [red](3:state), [call](4:informing) [Tom](4:recipient).",
            "condition",
        ),
        (
            "If [the tea](1:object) [is](1:check_state) [hot](1:state), [bring](2:bringing) [it](2:object). If "
            "[it](3:object)['s](3:check_state) still [cold](3:state), [warm](4:change_state) [it](4:object).",
            "mention",
        ),
        (
            "If [the tea](1:object) [is](1:check_state) [hot](1:state), [bring](2:bringing) [it](2:object). If "
            "[it](3:object)['s](3:check_state) [hot](3:state), [tell](4:informing) [me](4:recipient).",
            "mention",
        ),
    ],
)
def test_whether_something_is_still_so_once_something_was_done_is_asked_anew(markup: str, role: str) -> None:
    assert stated_roles(clauses(markup), ("condition", "task", "mention", "task"))[2] == role


@pytest.mark.parametrize(
    ("order", "check", "roles"),
    [
        ("[Bring](1:bringing) [the torch](1:object)", "[it](2:object) doesn't [work](2:check_state)", "apart"),
        ("[Take](1:taking) [the key](1:object)", "[it](2:object) doesn't [fit](2:check_state)", "apart"),
        (
            "[Put](1:placing) [the fan](1:object) [there](1:goal)",
            "[it](2:object) doesn't [run](2:check_state)",
            "apart",
        ),
        ("[Turn](1:change_state) [the tv](1:object) on", "[it](2:object) doesn't [work](2:check_state)", "mention"),
        ("[Lift](1:taking) [the sofa](1:object)", "[it](2:object) doesn't [work](2:check_state)", "mention"),
        ("[Put](1:placing) [it](1:object) [there](1:goal)", "[it](2:object) doesn't [fit](2:check_state)", "mention"),
    ],
)
def test_whether_what_was_fetched_works_is_no_mention_of_the_fetching(order: str, check: str, roles: str) -> None:
    found = clauses(f"{order}. If {check}, [call](3:informing) [Ann](3:recipient).")
    expected = ("task", "condition", "task") if roles == "apart" else ("condition", "mention", "task")
    assert stated_roles(found, ("condition", "mention", "task")) == expected


@pytest.mark.parametrize(
    ("order", "role"),
    [
        ("[start](2:change_state) [it](2:object)", "task"),
        ("[load](2:change_state) [it](2:object)", "again"),
    ],
)
def test_another_change_of_the_same_thing_is_not_the_same_order_again(order: str, role: str) -> None:
    found = clauses(
        f"[Load](1:change_state) [the van](1:object), but don't {order} until [it](3:object)'s [dry](3:check_state)."
    )
    assert stated_roles(found, ("task", "again", "task"))[1] == role


@pytest.mark.parametrize(
    ("check", "state"), [("nothing [lights](2:check_state) up", None), ("[Max](2:object) [is](2:check_state) up", "up")]
)
def test_the_particle_of_a_verb_is_no_state(check: str, state: str | None) -> None:
    found = clauses(f"[Turn](1:change_state) [on](1:state) [the radio](1:object). If {check}, [call](3:informing) me.")
    assert found[1].wording.state == state
