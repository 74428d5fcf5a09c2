"""What a clause says for certain: what an "unless" governs, what it echoes, what it misses, what hangs on it."""

from __future__ import annotations

import pytest
from annotated import clauses
from readings import flow

from decomplex_bt.understanding.control_flow.failures import finds_out
from decomplex_bt.understanding.interpreter import Interpreter

WET_OR_DARK = (
    "[it](2:object)['s](2:check_state) [wet](2:state) {} [the lamp](3:object) [is](3:check_state) [off](3:state)"
)
GO = "[Go](1:motion) [out](1:goal)"


@pytest.mark.parametrize(
    ("markup", "joins", "is_negated"),
    [
        (f"{GO} unless " + WET_OR_DARK.format("or") + ".", "and", True),
        (f"{GO} unless " + WET_OR_DARK.format("and") + ".", "or", True),
        (f"{GO} except if " + WET_OR_DARK.format("or if") + ".", "and", True),
        (f"{GO} if " + WET_OR_DARK.format("or") + ".", "or", False),
        (f"{GO} unless " + WET_OR_DARK.format("and if") + ".", "", False),
        # behind what the one before says
        (
            f"{GO} unless [it](2:object)['s](2:check_state) [after six](2:state) or [the lamp](3:object) "
            "[is](3:check_state) [off](3:state).",
            "and",
            True,
        ),
        # with a consequence of its own
        (f"{GO} unless " + WET_OR_DARK.format("or if") + " [turn](4:motion) round.", "", False),
        # in another sentence
        (f"{GO} unless " + WET_OR_DARK.format(". And") + ".", "", False),
        # an order to check
        (
            f"{GO} unless [it](2:object)['s](2:check_state) [wet](2:state) and [see](3:check_state) if "
            "[the lamp](3:object) is [off](3:state).",
            "and",
            False,
        ),
        # what "unless" governs is no check
        (
            f"{GO} unless you can [find](2:searching) [Tom](2:object) or [the lamp](3:object) [is](3:check_state) "
            "[off](3:state).",
            "or",
            False,
        ),
    ],
)
def test_an_unless_governs_all_that_is_joined_under_it(markup: str, joins: str, is_negated: bool) -> None:
    wording = clauses(markup)[2].wording
    assert (wording.joins, wording.is_negated) == (joins, is_negated)


def test_an_unless_governs_a_third_check_and_what_an_or_if_adds_where_it_opens_the_sentence() -> None:
    third = " or [the fan](4:object) [is](4:check_state) [on](4:state)."
    assert clauses(f"{GO} unless " + WET_OR_DARK.format("or") + third)[3].is_excepted
    first = "Unless [it](1:object)['s](1:check_state) [wet](1:state) or if [the lamp](2:object) [is](2:check_state) "
    assert clauses(first + "[off](2:state), [turn](3:motion) round.")[1].is_excepted


@pytest.mark.parametrize(
    ("words", "is_echo"),
    [
        ("[he](3:object) [is](3:check_state)", True),
        ("[it](3:object) [does](3:check_state)", True),
        ("[he](3:object) [is](3:check_state)n't", False),
        ("[he](3:object) [is](3:check_state) [asleep](3:state)", False),
        ("[the cat](3:object) [is](3:check_state)", False),
    ],
)
def test_an_echo_affirms_and_says_no_more(words: str, is_echo: bool) -> None:
    markup = (
        "Don't [lock](1:change_state) [the door](1:object) unless [Dad](2:object) [is](2:check_state) "
        f"[home](2:location). If {words}, [tell](4:informing) me."
    )
    assert clauses(markup)[2].wording.is_echo == is_echo


@pytest.mark.parametrize(
    ("check", "is_found_out"),
    [
        ("[the tongs](2:object) [are](2:check_state)n't [there](2:location)", True),
        ("[the tongs](2:object) [are](2:check_state) not [in the shed](2:location)", True),
        ("[the tongs](2:object) [are](2:check_state) [there](2:location)", False),
        ("[the peg](2:object) [is](2:check_state)n't [there](2:location)", False),
        ("[the long tongs](2:object) [are](2:check_state)n't [there](2:location)", True),
        ("[tongs](2:object) [are](2:check_state)n't [there](2:location)", False),
    ],
)
def test_what_was_to_be_fetched_may_be_missed_by_its_name(check: str, is_found_out: bool) -> None:
    found = clauses(
        f"[Get](1:taking) [the tongs](1:object) [from the shed](1:source). If {check}, [call](3:informing) me."
    )
    assert finds_out(found[0], found[1]) == is_found_out


@pytest.mark.parametrize(
    ("opening", "covers"),
    [
        ("All this only if", "+"),
        ("All of that assuming", "+"),
        ("But none of it if", "-"),
        ("Skip all that if", "-"),
        ("All that unless", "-"),
        ("Only if", ""),
        ("Close this all the time if", ""),
    ],
)
def test_a_condition_may_say_that_all_hangs_on_it(opening: str, covers: str) -> None:
    found = clauses(
        f"[Take](1:taking) [the bag](1:object). {opening} [the gate](2:object) [is](2:check_state) [open](2:state)."
    )
    assert found[1].covers == covers


@pytest.mark.parametrize(
    ("words", "is_contrary"),
    [
        ("we [are](2:check_state) out", True),
        ("we've [run](2:check_state) out of it", True),
        ("[they](2:object) have all [gone](2:check_state)", True),
        ("we [are](2:check_state) out in the garden", False),
        ("[they](2:object) have [gone](2:check_state) cold", False),
        ("[he](2:object) has [run](2:check_state) out of the house", False),
    ],
)
def test_what_is_used_up_is_not_there(words: str, is_contrary: bool) -> None:
    found = clauses(f"[See](1:check_state) if there are [rolls](1:object), and if {words}, [call](3:informing) Ann.")
    assert found[1].wording.is_contrary == is_contrary


@pytest.mark.parametrize(
    "text",
    [
        "Look on the shelf, and if the jam isn't there, call Kim.",
        "Look in the shed, and if the stick isn't there, call Kim.",
        "Look in the shed and the hall, and if the jam is in neither, call Kim.",
    ],
)
def test_a_thing_with_a_name_like_a_failure_says_none(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 2], "else": [3]}]


def test_a_thing_that_sticks_fails(interpreter: Interpreter) -> None:
    assert flow(interpreter, "Open the drawer. If it sticks, call Kim.") == [{"if": [1, 2], "else": [3]}]
