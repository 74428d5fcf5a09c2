"""Which task comes first where English settles it, and where it is left to the models."""

from __future__ import annotations

import pytest
from annotated import clauses
from readings import flow

from decomplex_bt.understanding.control_flow.orders import stated_orders
from decomplex_bt.understanding.interpreter import Interpreter

WAX = "[Fetch](1:taking) [the wax](1:object) [from the shed](1:source)"
CAR = "[polish](2:change_state) [the car](2:object)"


@pytest.mark.parametrize(
    ("event", "side", "expected"),
    [
        ("after you have [swept](2:change_state) [it](2:object)", "top", "before"),
        ("once [sweeping](2:change_state) [it](2:object)", "top", "before"),
        ("after you have [swept](2:change_state) [it](2:object)", "<1+", "keep"),
        ("before you [sweep](2:change_state) [it](2:object)", "top", "keep"),
    ],
)
def test_what_is_done_before_something_is_asked_goes_ahead_of_it(event: str, side: str, expected: str) -> None:
    found = clauses(
        f"If [the yard](1:object) [is](1:check_state) [icy](1:state) {event}, [call](3:informing) [Ann](3:recipient)."
    )
    orders = stated_orders(found, ("condition", "task", "task"), ("top", side, "<1+"), ("keep",) * 3)
    assert orders == ("keep", expected, "keep")


def test_all_that_is_done_before_something_is_asked_goes_ahead_of_it() -> None:
    found = clauses(
        "If [the yard](1:object) [is](1:check_state) [icy](1:state) after you have [swept](2:change_state) and "
        "[hosed](3:change_state) [it](3:object), [call](4:informing) [Ann](4:recipient)."
    )
    roles, sides = ("condition", "task", "task", "task"), ("top", "top", "top", "<1+")
    assert stated_orders(found, roles, sides, ("keep",) * 4) == ("keep", "before", "before", "keep")


@pytest.mark.parametrize(
    ("after", "expected"),
    [
        ("in that case [lay](3:placing) [a sheet](3:object) down first", "before"),
        ("but first [lay](3:placing) [a sheet](3:object) down", "before"),
        ("but [bring](3:bringing) [the sheets](3:object) first", "before"),
        ("but first [lay](3:placing) [a sheet](3:object) down and call Ann", "before"),
        ("and [lay](3:placing) [a sheet](3:object) down", "keep"),
    ],
)
def test_what_is_done_first_in_the_same_case_goes_ahead(after: str, expected: str) -> None:
    found = clauses(
        f"[Drain](1:change_state) [the boiler](1:object) if [it](2:object) [is](2:check_state) full, {after}."
    )
    roles, sides = ("task", "condition", "task"), (">1+", "top", "<1+")
    assert stated_orders(found, roles, sides, ("keep",) * 3) == ("keep", "keep", expected)
    assert stated_orders(found, roles, (">1+", "top", "<1-"), ("keep",) * 3)[2] == "keep"


def test_what_is_to_be_done_first_takes_along_what_is_joined_to_it() -> None:
    found = clauses(
        "[Drain](1:change_state) [the boiler](1:object) if [it](2:object) [is](2:check_state) [full](2:state), but "
        "first [lay](3:placing) [a sheet](3:object) down and [fold](4:change_state) [it](4:object)."
    )
    roles, sides = ("task", "condition", "task", "task"), (">1+", "top", "<1+", "<1+")
    assert stated_orders(found, roles, sides, ("keep",) * 4)[2:] == ("before+", "keep")


@pytest.mark.parametrize(
    ("first", "second", "thing", "expected"),
    [
        (WAX, CAR, "the shed", "first"),
        ("[Rinse](1:change_state) [the jug](1:object)", "[put](2:placing) [it](2:object) away", "the jug", "first"),
        (WAX, CAR, "the car", "keep"),
        (WAX, CAR, "the wax", "keep"),
    ],
)
def test_what_clears_the_way_to_the_first_order_goes_ahead_of_all(
    first: str, second: str, thing: str, expected: str
) -> None:
    found = clauses(
        f"{first} and {second}; if [{thing}](3:object) [is](3:check_state) [wet](3:state), "
        "[tell](4:informing) Ann first."
    )
    roles, sides = ("task", "task", "condition", "task"), ("top", "top", "top", "<1+")
    assert stated_orders(found, roles, sides, ("keep",) * 4)[2] == expected


PUMP = "[Start](1:change_state) [the pump](1:object)"
FULL = "[the pool](2:object) [is](2:check_state) [full](2:state)"


@pytest.mark.parametrize(
    ("second", "expected"),
    [
        (f", wait until {FULL}", "keep"),
        (f" and then wait there till {FULL}", "keep"),
        (f" and hang on until {FULL}", "keep"),
        (f", but wait until {FULL}", "before"),
        (f" but first wait until {FULL}", "before"),
        (f" no sooner than {FULL}", "before"),
        (" but [shut](2:change_state) [the gate](2:object)", "keep"),
        (" but [shut](2:change_state) [the gate](2:object) first", "before"),
        (" but before that [shut](2:change_state) [the gate](2:object)", "before"),
        (" but [shut](2:change_state) [the gate](2:object) before you begin", "before"),
        (" but [shut](2:change_state) [the gate](2:object) beforehand", "before"),
        (f", though not yet: wait till {FULL}", "before"),
    ],
)
def test_waits_and_contrasts_keep_the_order_of_the_text(second: str, expected: str) -> None:
    found = clauses(f"{PUMP}{second} and [fetch](3:bringing) [the towels](3:object).")
    orders = stated_orders(found, ("task",) * 3, ("top",) * 3, ("keep", "before", "keep"))
    assert orders == ("keep", expected, "keep")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Beat the cream until it's stiff, then chill it.", [1, 2, 3]),
        ("Rinse the rice until it's clean and bring it here.", [1, 2, 3]),
        ("Search the boxes one after another until you find the tape and then hand it to me.", [1, 2, 3]),
        ("Don't warm the pie until Lea is home.", [2, 1]),
        ("Never open the hatch till the pump is off.", [2, 1]),
        ("Feeding the hens can wait until you've swept the yard.", [2, 1]),
    ],
)
def test_what_is_done_until_something_is_so_comes_before_that(
    interpreter: Interpreter, text: str, expected: object
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Fill the pool, but check the gate is shut before Kim gets in.", [1, 2]),
        ("Light the stove, but open the hatch before she comes.", [1, 2]),
        ("Run the shower, but check it isn't too hot before Dad gets in.", [1, 2]),
        ("Light the stove, but open the hatch before you start.", [2, 1]),
    ],
)
def test_what_is_due_before_others_act_need_not_come_first(
    interpreter: Interpreter, text: str, expected: object
) -> None:
    assert flow(interpreter, text) == expected
