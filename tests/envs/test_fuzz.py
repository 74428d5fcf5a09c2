"""Whatever is done and asked for: no crash, no NaN, nothing lost, nothing outside the house or its space."""

from __future__ import annotations

from contextlib import suppress
from functools import cache

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.options import KEYS
from decomplex_bt.errors import DecomplexError, InputError

DOMAIN = load_domain("household")
HOUSE = DOMAIN.house
TELL = read_markup("[Tell](1:informing) [Anna](1:recipient) [hello](1:message).", DOMAIN.ontology, flow=[1])
PLACES = [name for name in HOUSE.places() if DOMAIN.kind(name).surface or DOMAIN.kind(name).inside]
DEVICES = [name for name in HOUSE.places() if DOMAIN.kind(name).is_device]
BOUNDED = settings(
    max_examples=25, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck), database=None
)

shares = st.floats(-1.5, 1.5, width=32)
actions = st.fixed_dictionaries(
    {
        "drive": st.tuples(shares, shares).map(lambda pair: np.array(pair, dtype=np.float32)),
        "interact": st.sampled_from([int(act) for act in Interaction if act is not Interaction.FINISH]),
        "target": st.integers(0, 10_000),
    }
)
bursts = st.tuples(actions, st.integers(1, 12))
options = st.fixed_dictionaries(
    {},
    optional={
        "placement": st.dictionaries(st.sampled_from(list(HOUSE.things)), st.sampled_from([None, *PLACES]), max_size=4),
        "people": st.dictionaries(
            st.sampled_from(list(HOUSE.people)[1:]), st.sampled_from([None, *HOUSE.rooms]), max_size=4
        ),
        "broken": st.lists(st.sampled_from(DEVICES), max_size=3, unique=True),
        "balance": st.floats(0, 0.5),
        "noise": st.booleans(),
        "chance": st.booleans(),
        "max_seconds": st.floats(0.1, 1000),
        "reward": st.sampled_from(["success", "progress"]),
    },
)


@cache
def env_of(size):
    """One for all examples: making one takes longer than what is tried in it."""
    return HouseholdEnv(TELL, size=size)


def check(env, observation, info, reward=0.0):
    assert observation in env.observation_space
    for key in ("robot", "entities", "seconds"):
        assert np.isfinite(observation[key]).all()
    assert np.isfinite(reward)
    world, geometry = env.world, env.world.geometry
    x0, y0, x1, y1 = geometry.bounds
    is_here = world.is_somewhere.copy()
    is_here[: geometry.place_count] = False
    at = world.position[is_here]
    assert np.isfinite(at).all()
    assert ((at >= (x0 - 0.3, y0 - 0.3)) & (at <= (x1 + 0.3, y1 + 0.3))).all(), "nothing leaves the house"
    things = list(geometry.thing_rows)
    held = [row for row in (world.held, *world.tray) if row >= 0]
    assert len(set(held)) == len(held)
    assert all(world.place[row] == geometry.robot_row for row in held)
    assert (world.place[things] == geometry.robot_row).sum() == len(held), "in hand or on the tray"
    assert ((world.place[things] >= 0) == world.is_somewhere[things]).all(), "nothing is lost, and nothing turns up"
    assert 0 <= info["goal_conditions_met"] <= info["goal_conditions_total"]


@settings(BOUNDED, max_examples=150)
@given(st.integers(0, 2**31), options, st.lists(bursts, max_size=14))
def test_whatever_is_done(seed, chosen, sequence):
    env = env_of(None)
    try:
        observation, info = env.reset(seed=seed, options=chosen)
    except InputError as error:
        assume("no room left" not in str(error))
        raise
    check(env, observation, info)
    for action, times in sequence:
        action = {**action, "target": action["target"] % len(env.entities)}
        for _ in range(times):
            observation, reward, terminated, truncated, info = env.step(action)
            check(env, observation, info, reward)
            if terminated or truncated:
                return


@settings(BOUNDED, max_examples=8)
@given(st.integers(0, 50), st.integers(0, 9), st.lists(bursts, max_size=8))
def test_whatever_is_done_in_another_house(seed, house, sequence):
    env = env_of("small")
    observation, info = env.reset(seed=seed, options={"house_seed": house})
    check(env, observation, info)
    for action, times in sequence:
        action = {**action, "target": action["target"] % 128}
        for _ in range(times):
            observation, reward, terminated, truncated, info = env.step(action)
            check(env, observation, info, reward)
            if terminated or truncated:
                return


scalars = st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=8))
values = st.one_of(
    scalars,
    st.lists(st.one_of(st.text(max_size=5), st.floats()), max_size=3),
    st.dictionaries(st.sampled_from(["pan", "anna", "tv", "x"]), scalars, max_size=2),
)


@settings(BOUNDED, max_examples=80)
@given(st.dictionaries(st.one_of(st.sampled_from(KEYS[3:]), st.text(max_size=12)), values, max_size=3))
def test_options_of_all_sorts_are_taken_or_refused_in_words(junk):
    with suppress(DecomplexError):
        env_of(None).reset(seed=0, options=junk)


@settings(BOUNDED, max_examples=40)
@given(st.text(min_size=1, max_size=20).filter(lambda key: key not in KEYS))
def test_unknown_option_keys_are_refused(key):
    with pytest.raises(InputError, match="unknown reset option"):
        env_of(None).reset(seed=0, options={key: 1})


@settings(BOUNDED, max_examples=60)
@given(st.one_of(scalars, st.dictionaries(st.sampled_from(["drive", "interact", "target"]), values)))
def test_actions_of_all_sorts_are_taken_or_refused_in_words(junk):
    env = env_of(None)
    env.reset(seed=0)
    with suppress(InputError):
        env.step(junk)
