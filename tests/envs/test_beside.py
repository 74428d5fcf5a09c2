"""Tasks about who or what is beside somebody or something, what is fixed, and several things for one place: the robot
and the judge, who do not look at each other, agree."""

from __future__ import annotations

import gymnasium as gym
import pytest

import decomplex_bt  # noqa: F401 - registers the environments
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain

DOMAIN = load_domain("household")
SENTENCES = {
    "beside a thing": (
        "If [Anna](1:object) [is](1:check_state) [next to the laptop](1:location), [close](2:change_state) "
        "[the kitchen window](2:object), otherwise [open](3:change_state) [it](3:object=the kitchen window).",
        [{"if": 1, "then": [2], "else": [3]}],
    ),
    "with somebody": (
        "If [Anna](1:object) [is](1:check_state) [with Tom](1:location), [close](2:change_state) "
        "[the kitchen window](2:object), otherwise [open](3:change_state) [it](3:object=the kitchen window).",
        [{"if": 1, "then": [2], "else": [3]}],
    ),
    "a thing with somebody": (
        "If [the phone](1:object) [is](1:check_state) [with Anna](1:location), [close](2:change_state) "
        "[the fridge](2:object).",
        [{"if": 1, "then": [2]}],
    ),
    "what is fixed, in view before the next step": (
        "[Find](1:searching) [the couch](1:object), then [look](2:searching) [for the bedroom window](2:object), "
        "then [close](3:change_state) [the fridge](3:object).",
        [1, 2, 3],
    ),
    "some door": (
        "[Leave](1:motion) [the room](1:source) and [close](2:change_state) [the door](2:object).",
        [1, 2],
    ),
    "all on one of several": ("[Put](1:placing) [the pens](1:object) [on a table](1:goal).", [1]),
    "two in one of two": (
        "[Put](1:placing) [the knife and the fork](1:object) [in the drawer or on the counter](1:goal).",
        [1],
    ),
}


@pytest.fixture(scope="module")
def env():
    return gym.make("decomplex_bt/Household-v0")


def end_of(env, case, name, seed):
    """What is told at the end of an episode that goes by the annotation; None where nobody could do it."""
    text, flow = SENTENCES[case]
    asked = read_markup(text, DOMAIN.ontology, flow=flow)
    observation, info = env.reset(seed=seed, options={"instruction": asked, "noise": False})
    if not info["feasible"]:
        return None
    policy = env.unwrapped.policy(name, flow=asked, seed=seed)
    policy.reset(observation, info)
    terminated = truncated = False
    while not (terminated or truncated):
        observation, _, terminated, truncated, info = env.step(policy.act(observation))
    return info


@pytest.mark.parametrize("seed", [0, 1, 4, 6])
@pytest.mark.parametrize("name", ["tree", "oracle"])
@pytest.mark.parametrize("case", SENTENCES)
def test_robot_and_judge_agree(env, case, name, seed):
    info = end_of(env, case, name, seed)
    if info is None:
        pytest.skip("in this world nobody could")
    assert info["is_success"], info["branches"]


def test_a_door_found_shut_is_not_the_one_to_shut(env):
    # In this world the robot starts beside a shut door, with its back to it.
    info = end_of(env, "some door", "tree", 704)
    assert info["is_success"], info["events"]
