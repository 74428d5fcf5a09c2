"""Where one was sent to see whether there is something, and which room one goes into."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.planning.ground_task import GroundTask
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain()
SENT = "[Go](1:motion) [to the kitchen](1:goal)"


def check(text: str, flow: list[object]) -> GroundTask:
    return ground(read_markup(text, DOMAIN.ontology, flow=flow), DOMAIN).tasks[1]


@pytest.mark.parametrize(
    ("text", "places"),
    [
        (f"{SENT} and [see](2:check_state) if there's [any milk](2:object)", ["kitchen"]),
        (f"{SENT}, then [check](2:check_state) whether there are [any plates](2:object)", ["kitchen"]),
        (f"{SENT} and [see](2:check_state) that there is [a cup](2:object) [on the desk](2:location)", ["desk"]),
        (f"{SENT}. [Check](2:check_state) whether there is [a cup](2:object)", []),
        (f"{SENT} and [see](2:check_state) if [Tom](2:object) is [home](2:location)", []),
        ("[Go](1:motion) [to the fridge](1:goal), [see](2:check_state) if there's [a pen](2:object)", []),
    ],
)
def test_what_is_asked_for_where_one_was_sent_is_looked_for_there(text: str, places: list[str]) -> None:
    assert [name for place in check(text, [1, 2]).places for name in place.candidates] == places


def test_who_is_sent_in_a_case_alone_looks_everywhere() -> None:
    text = f"{SENT} if there [is](2:check_state) [any milk](2:object)"
    assert not check(text, [{"if": 2, "then": [1]}]).places


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("If [the bedroom door](1:object) [is](1:check_state) [open](1:state), [go](2:motion) [in](2:goal)", "bedroom"),
        ("[Knock](1:informing) [at the study door](1:goal), then [go](2:motion) [inside](2:direction)", "study"),
        ("[Open](1:change_state) [the door to the bathroom](1:object) and [enter](2:motion)", "bathroom"),
        ("[Go](1:motion) [to the bedroom door](1:goal) and [go](2:motion) [in](2:goal)", "bedroom"),
    ],
)
def test_who_goes_in_goes_where_the_door_leads(text: str, room: str) -> None:
    goal = check(text, [{"if": 1, "then": [2]}]).goal
    assert goal is not None
    assert goal.candidates == (room,)


def test_nobody_goes_into_what_has_only_a_lid() -> None:
    with pytest.raises(InputError, match="'in' names nothing"):
        check("[Open](1:change_state) [the oven door](1:object) and [go](2:motion) [in](2:goal)", [1, 2])
