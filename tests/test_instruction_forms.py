"""Annotations whose parts do not fit each other are refused wherever one is taken."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import gymnasium as gym
import pytest

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.flow import Do, Flow
from decomplex_bt.instruction import Instruction, Span, check_instruction
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain()
GOOD = read_markup(
    "[Close](1:change_state) [the window](1:object) and [open](2:change_state) [the oven](2:object)",
    DOMAIN.ontology,
    flow=[1, 2],
)
FIRST, SECOND = GOOD.tasks


@pytest.mark.parametrize(
    ("changes", "problem"),
    [
        ({"tasks": (FIRST, replace(SECOND, id=-7))}, "numbers"),
        ({"tasks": (*GOOD.tasks, *GOOD.tasks)}, "numbers"),
        ({"tasks": (FIRST, replace(SECOND, repeats=9))}, "repeats"),
        ({"tasks": (FIRST, replace(SECOND, span=Span(3, 10**400)))}, "no words"),
        ({"tasks": (FIRST, replace(SECOND, span=Span(-7, 2)))}, "no words"),
        ({"flow": Flow()}, "does not occur"),
        ({"flow": Flow((Do((1,)), Do((2,)), Do((3,))))}, "3"),
        ({"flow": Flow((Do(()),))}, "without a task"),
        ({"flow": None}, "flow None"),
        ({"text": 3}, "text 3"),
    ],
)
def test_what_does_not_fit_is_refused(changes: dict[str, Any], problem: str) -> None:
    broken: Instruction = replace(GOOD, **changes)
    with pytest.raises(InputError, match=problem):
        check_instruction(broken)
    env = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
    with pytest.raises(InputError, match=problem):
        env.reset(seed=0, options={"instruction": broken})
    with pytest.raises(InputError, match=problem):
        decomplex_bt.TreeAgent(env, flow=broken)


def test_a_type_that_there_is_not_is_refused() -> None:
    with pytest.raises(InputError, match="has the type 'x'"):
        ground(replace(GOOD, tasks=(replace(FIRST, type="x"), SECOND)), DOMAIN)


def test_what_fits_stays_as_it_is() -> None:
    assert check_instruction(GOOD) is GOOD
