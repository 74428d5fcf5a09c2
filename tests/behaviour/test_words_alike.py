"""Robot and judge take the same words alike: episodes in worlds in which it matters what a phrase means."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import gymnasium as gym
import pytest
from py_trees.common import Status

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain

DOMAIN = load_domain()
ENV = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
WINDOWS = ("kitchen_window", "living_room_window", "bedroom_window")


def episode(
    text: str, flow: list[Any], **options: Mapping[str, str | None]
) -> tuple[Status, dict[str, Any], list[str]]:
    """One episode of a marked text without noise: the agent's status, the last info, the places of things changed."""
    instruction = read_markup(text, DOMAIN.ontology, flow=flow)
    world = {"noise": False, "broken": [], **options}
    observation, info = ENV.reset(seed=1, options={"instruction": instruction, **world})
    agent = decomplex_bt.TreeAgent(ENV, flow=instruction)
    agent.reset(observation, {"instruction": info["instruction"]})
    events: list[str] = []
    cause = info["infeasible_cause"]
    while True:
        observation, _, terminated, truncated, info = ENV.step(agent.act(observation))
        events += info["events"]
        if terminated or truncated:
            return agent.status, {**info, "cause": cause}, events


@pytest.mark.parametrize(("state", "is_brought"), [("hot", True), ("cold", False)])
def test_the_hot_soup_is_not_the_cold_one(state: str, is_brought: bool) -> None:
    text = "[Bring](1:bringing) [me](1:recipient) [the hot soup](1:object)"
    status, info, events = episode(text, [1], placement={"soup": "stove"}, states={"soup": state})
    assert (info["is_success"], status is Status.SUCCESS, any("hand over" in e for e in events)) == (is_brought,) * 3
    assert (info["cause"] is None) == is_brought


@pytest.mark.parametrize("phrase", ["a clean pen", "the warm blanket"])
def test_a_state_that_cannot_be_is_asked_by_neither(phrase: str) -> None:
    status, info, _ = episode(f"[Bring](1:bringing) [me](1:recipient) [{phrase}](1:object)", [1])
    assert (info["is_success"], status) == (True, Status.SUCCESS)


@pytest.mark.parametrize("is_open", [(), ("bedroom_window",)])
def test_where_none_of_them_is_so_nothing_is_to_be_done(is_open: tuple[str, ...]) -> None:
    states = {name: "open" if name in is_open else "closed" for name in WINDOWS}
    text = "[Close](1:change_state) [all the open windows](1:object) and [go](2:motion) [to the kitchen](2:goal)"
    status, info, events = episode(text, [1, 2], states=states)
    assert (info["is_success"], status) == (True, Status.SUCCESS)
    assert sum("close" in event for event in events) == len(is_open)


def test_dirty_plates_that_are_clean_stay_where_they_are() -> None:
    text = (
        "[Put](1:placing) [all the dirty plates](1:object) [in the sink](1:goal), then [come](2:motion) [here](2:goal)"
    )
    places = {"plate_1": "cupboard", "plate_2": "kitchen_table"}
    status, info, events = episode(text, [1, 2], placement=places, states={"plate_1": "clean", "plate_2": "clean"})
    assert (info["is_success"], status) == (True, Status.SUCCESS)
    assert not any("plate" in event for event in events)


@pytest.mark.parametrize("places", [{"ball": "couch", "pen_1": "couch"}, {}])
def test_what_was_found_somewhere_is_brought_from_there(places: dict[str, str]) -> None:
    text = (
        "If [there](1:location=on the couch) [is](1:check_state) [anything](1:object), "
        "[bring](2:bringing) [it](2:object=anything) [to me](2:recipient), otherwise [tell](3:informing) "
        "[me](3:recipient)."
    )
    elsewhere = {
        **dict.fromkeys(("toy", "remote"), "basket"),
        **dict.fromkeys(("book_1", "book_2", "magazine"), "desk"),
        **dict.fromkeys(("pillow", "blanket"), "bed"),
    }
    status, info, _ = episode(text, [{"if": 1, "then": [2], "else": [3]}], placement={**elsewhere, **places})
    assert (info["is_success"], status) == (True, Status.SUCCESS)
    if places:
        assert info["branches"][0]["truth"] is True


@pytest.mark.parametrize("there", [(), ("anna",), ("anna", "tom")])
def test_everybody_in_a_room_is_who_is_there(there: tuple[str, ...]) -> None:
    text = "[Tell](1:informing) [everybody in the living room](1:recipient) [that it is late](1:message) and "
    text += "[go](2:motion) [to the kitchen](2:goal)"
    elsewhere = {"anna": "study", "tom": "study", "guest": "bedroom", "relative": "bathroom"}
    status, info, events = episode(text, [1, 2], people={**elsewhere, **dict.fromkeys(there, "living_room")})
    assert (info["is_success"], status) == (True, Status.SUCCESS)
    told = {name for name in elsewhere if any(f"say {name}" in event for event in events)}
    assert told == set(there)


def test_everybody_is_told_wherever_they_are() -> None:
    text = "[Tell](1:informing) [everybody](1:recipient) [that it is late](1:message)"
    status, info, events = episode(
        text, [1], people={"anna": "study", "tom": "bedroom", "guest": None, "relative": None}
    )
    assert (info["is_success"], status) == (True, Status.SUCCESS)
    assert all(any(f"say {name}" in event for event in events) for name in ("anna", "tom"))
