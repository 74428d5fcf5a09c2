"""Which task comes first where English settles it, and where it is left to the models."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from annotated import clauses

from decomplex_bt.understanding.control_flow.orders import stated_orders


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
