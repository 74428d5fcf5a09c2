"""What is to be done at a device is done there, by the robot and for the judge."""

from __future__ import annotations

from typing import Any

import gymnasium as gym
import pytest
from py_trees.common import Status

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain()
ENV = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
PLATE = "[Wash](1:change_state) [the white plate](1:object){}"


def episode(text: str, **options: Any) -> tuple[Status, dict[str, Any], str | None]:
    """One episode without noise: the agent's status, the last info, why it is not feasible."""
    instruction = read_markup(text, DOMAIN.ontology, flow=[1, 2] if "](2:" in text else [1])
    options = {"noise": False, "broken": [], **options}
    observation, info = ENV.reset(seed=1, options={"instruction": instruction, **options})
    agent = decomplex_bt.TreeAgent(ENV, flow=instruction)
    agent.reset(observation, {"instruction": info["instruction"]})
    cause = info["infeasible_cause"]
    while True:
        observation, _, terminated, truncated, info = ENV.step(agent.act(observation))
        if terminated or truncated:
            return agent.status, info, cause


def power_of(device: str) -> str:
    truth = ENV.unwrapped.truth()  # type: ignore[attr-defined]
    return truth.state(device, "power")


@pytest.mark.parametrize(
    ("words", "devices"),
    [
        ("", ("sink", "dishwasher")),
        (" [in the dishwasher](1:location)", ("dishwasher",)),
        (" [in the sink](1:location)", ("sink",)),
        (" [using the dishwasher](1:manner)", ("dishwasher",)),
        (" [in the kitchen](1:location)", ("sink", "dishwasher")),
        (" [with care](1:manner)", ("sink", "dishwasher")),
        (" [from the dishwasher](1:source)", ("sink", "dishwasher")),
        (" [next to the sink](1:location)", ("sink", "dishwasher")),
    ],
)
def test_what_is_named_is_what_may_be_used(words: str, devices: tuple[str, ...]) -> None:
    (task,) = ground(read_markup(PLATE.format(words), DOMAIN.ontology, flow=[1]), DOMAIN).tasks
    assert sorted(set(task.devices("plate_1", DOMAIN)) & {"sink", "dishwasher"}) == sorted(devices)


def test_things_are_filled_from_a_device() -> None:
    text = "[Fill](1:change_state) [the red mug](1:object) [from the sink](1:source)"
    (task,) = ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks
    assert "coffee_machine" not in task.devices("mug_1", DOMAIN)
    assert "sink" in task.devices("mug_1", DOMAIN)


@pytest.mark.parametrize("device", ["oven", "microwave"])
def test_a_thing_is_heated_where_it_is_to_be(device: str) -> None:
    text = f"[Heat](1:change_state) [the bread](1:object) [in the {device}](1:location)"
    status, info, _ = episode(text, placement={"bread": "counter"}, states={"bread": "cold"})
    assert (info["is_success"], status, power_of(device)) == (True, Status.SUCCESS, "on")


def test_where_the_device_is_broken_no_other_will_do() -> None:
    text = "[Heat](1:change_state) [the bread](1:object){}"
    world = {"placement": {"bread": "counter"}, "states": {"bread": "cold"}, "broken": ["oven"]}
    status, info, cause = episode(text.format(" [in the oven](1:location)"), **world)
    assert (info["is_success"], status is Status.SUCCESS) == (False, False)
    assert cause is not None
    assert "oven" in str(cause)
    status, info, cause = episode(text.format(""), **world)
    assert (info["is_success"], status, cause) == (True, Status.SUCCESS, None)


@pytest.mark.parametrize(
    ("text", "placement", "clean"),
    [
        ("[Wash](1:change_state) [the mugs](1:object) [in the sink](1:location)", ("counter", "kitchen_table"), True),
        ("[Wash](1:change_state) [both mugs](1:object) [in the sink](1:location)", ("sink", "kitchen_table"), True),
        ("[Wash](1:change_state) [everything](1:object) [in the sink](1:location)", ("sink", "kitchen_table"), False),
    ],
)
def test_all_are_brought_to_the_device(text: str, placement: tuple[str, str], clean: bool) -> None:
    mugs = dict(zip(("mug_1", "mug_2"), placement, strict=True))
    status, info, cause = episode(text, placement=mugs, states=dict.fromkeys(mugs, "dirty"))
    truth = ENV.unwrapped.truth()  # type: ignore[attr-defined]
    assert (cause, info["is_success"], status) == (None, True, Status.SUCCESS)
    assert (truth.state("mug_2", "cleanliness") == "clean") is clean


@pytest.mark.parametrize(("machine", "is_shut"), [("on", True), ("on", False), ("off", True), ("off", False)])
def test_what_is_started_runs_behind_its_door_with_what_was_put_in(machine: str, is_shut: bool) -> None:
    text = (
        "[Put](1:placing) [the shirt](1:object) [in the washing machine](1:goal) and [start](2:change_state) "
        "[it](2:object=the washing machine)."
    )
    states = {"washing_machine": (machine, "closed" if is_shut else "open"), "shirt": "dirty"}
    status, info, cause = episode(text, placement={"shirt": "bed"}, states=states)
    truth = ENV.unwrapped.truth()  # type: ignore[attr-defined]
    assert (cause, info["is_success"], status) == (None, True, Status.SUCCESS)
    assert (power_of("washing_machine"), truth.state("washing_machine", "aperture")) == ("on", "closed")
    assert truth.state("shirt", "cleanliness") == "clean"


def test_what_runs_behind_its_door_already_is_left_alone() -> None:
    states = {"washing_machine": ("on", "closed")}
    _, info, _ = episode("[Start](1:change_state) [the washing machine](1:object)", states=states)
    assert (info["is_success"], info["goal_conditions_met"]) == (True, 1)
