from __future__ import annotations

import gymnasium as gym
import pytest

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.baselines import see_moved
from decomplex_bt.envs.sensing import FIRST_STATE, PLACE, VISIBLE
from decomplex_bt.errors import InputError

DOMAIN = load_domain("household")
KEYS = read_markup(
    "If you [find](1:searching) [my keys](1:object) [on the desk](1:location), "
    "[bring](2:bringing) [them](2:object=my keys).",
    DOMAIN.ontology,
    flow=[{"if": 1, "then": [2]}],
)
GO = read_markup("[Go](1:motion) [to the kitchen](1:goal).", DOMAIN.ontology, flow=[1])
START = {"placement": {"keys": "desk"}, "people": {"user": "study"}, "noise": False, "balance": 0.0}


@pytest.fixture(scope="module")
def env():
    return gym.make("decomplex_bt/Household-v0")


def run(env, name, *, seed=0, max_seconds=60.0, **options):
    observation, info = env.reset(
        seed=seed, options={"instruction": KEYS, "max_seconds": max_seconds, **START, **options}
    )
    policy = env.unwrapped.policy(name, flow=KEYS, seed=seed)
    policy.reset(observation, info)
    actions = []
    while True:
        action = policy.act(observation)
        actions.append((tuple(action["drive"].tolist()), action["interact"], action["target"]))
        observation, _, terminated, truncated, info = env.step(action)
        if terminated or truncated:
            return info, actions, policy


@pytest.mark.parametrize("name", ["tree", "oracle"])
def test_those_who_go_by_the_instruction_succeed(env, name):
    info, _, policy = run(env, name)
    assert info["is_success"], [str(failure) for failure in policy.failures]
    assert policy.plans >= 1
    assert info["path_length"] > 1.0


def test_the_oracle_knows_what_is_nowhere_without_looking(env):
    pen = read_markup(
        "[Find](1:searching) [a pencil](1:object), or else [tell](2:informing) [me](2:recipient).",
        DOMAIN.ontology,
        flow=[{"if": 1, "else": [2]}],
    )
    lengths = {}
    for name in ("tree", "oracle"):
        options = {"instruction": pen, "placement": {"pencil": None}, "people": {"user": "study"}, "balance": 0.0}
        observation, info = env.reset(seed=3, options=options)
        policy = env.unwrapped.policy(name, flow=pen)
        policy.reset(observation, info)
        terminated = truncated = False
        while not (terminated or truncated):
            observation, _, terminated, truncated, info = env.step(policy.act(observation))
        assert info["is_success"], (name, info, policy.failures)
        lengths[name] = info["path_length"]
    assert lengths["oracle"] < lengths["tree"]


@pytest.mark.parametrize("room", [None, "study"])
@pytest.mark.parametrize("name", ["tree", "oracle"])
def test_who_is_out_is_found_out(env, name, room):
    asked = read_markup(
        "If [Anna](1:object) [is](1:check_state) [out](1:state), [close](2:change_state) [the curtains](2:object) "
        "[in the bedroom](2:location), else [tell](3:informing) [her](3:recipient=Anna) [hello](3:message).",
        DOMAIN.ontology,
        flow=[{"if": 1, "then": [2], "else": [3]}],
    )
    observation, info = env.reset(seed=5, options={"instruction": asked, "people": {"anna": room}, "balance": 0.0})
    policy = env.unwrapped.policy(name, flow=asked)
    policy.reset(observation, info)
    terminated = truncated = False
    while not (terminated or truncated):
        observation, _, terminated, truncated, info = env.step(policy.act(observation))
    assert info["is_success"], (info, policy.failures)
    assert info["branches"][0]["truth"] == (room is None)


def test_of_two_lamps_the_oracle_takes_the_one_that_works(env):
    asked = read_markup(
        "[Tell](1:informing) [Anna](1:recipient) [hello](1:message), and if [the lamp](2:object) [is](2:check_state) "
        "[off](2:state), [switch](3:change_state) [it](3:object=the lamp) [on](3:state).",
        DOMAIN.ontology,
        flow=[1, {"if": 2, "then": [3]}],
    )
    states = {"living_room_lamp": "off", "bedroom_lamp": "off"}
    options = {"instruction": asked, "broken": ["bedroom_lamp"], "states": states, "people": {"anna": "bedroom"}}
    observation, info = env.reset(seed=2, options={**options, "noise": False, "balance": 0.0})
    policy = env.unwrapped.policy("oracle", flow=asked)
    policy.reset(observation, info)
    terminated = truncated = False
    while not (terminated or truncated):
        observation, _, terminated, truncated, info = env.step(policy.act(observation))
    assert info["is_success"], (info, policy.failures)


def test_of_several_lights_the_oracle_takes_one_that_is_off_and_works(env):
    asked = read_markup("[Switch](1:change_state) [the light](1:object) [on](1:state).", DOMAIN.ontology, flow=[1])
    off, on = ("kitchen_light", "bedroom_light"), ("bathroom_light", "living_room_lamp", "bedroom_lamp")
    states = {**dict.fromkeys(off, "off"), **dict.fromkeys(on, "on")}
    options = {"instruction": asked, "broken": ["kitchen_light"], "states": states, "noise": False}
    observation, info = env.reset(seed=2, options=options)
    policy = env.unwrapped.policy("oracle", flow=asked)
    policy.reset(observation, info)
    terminated = truncated = False
    while not (terminated or truncated):
        observation, _, terminated, truncated, info = env.step(policy.act(observation))
    assert info["is_success"], (info, policy.failures)


def test_of_two_cups_the_oracle_takes_the_one_that_need_not_be_filled(env):
    asked = read_markup(
        "If [the cup](1:object) [is](1:check_state) [dirty](1:state), [rinse](2:change_state) [it](2:object=the cup). "
        "Then [fill](3:change_state) [the cup](3:object) [at the coffee machine](3:location).",
        DOMAIN.ontology,
        flow=[{"if": 1, "then": [2]}, 3],
    )
    states = {"cup_1": ["clean", "full"], "cup_2": ["dirty", "empty"]}
    options = {"instruction": asked, "broken": ["coffee_machine"], "states": states, "noise": False, "balance": 0.0}
    observation, info = env.reset(seed=2, options=options)
    policy = env.unwrapped.policy("oracle", flow=asked)
    policy.reset(observation, info)
    terminated = truncated = False
    while not (terminated or truncated):
        observation, _, terminated, truncated, info = env.step(policy.act(observation))
    assert info["feasible"]
    assert info["is_success"], (info, policy.failures)


def test_the_oracle_knows_where_things_are_that_others_have_moved(env):
    umbrella = read_markup("[Bring](1:bringing) [me](1:recipient) [the umbrella](1:object).", DOMAIN.ontology, flow=[1])
    moved = 0
    for seed in (5, 8, 13, 26, 39):  # by what it knew of the start alone, it gave up in each
        observation, info = env.reset(seed=seed, options={"instruction": umbrella, "meddling": 6.0})
        policy = env.unwrapped.policy("oracle", flow=umbrella)
        policy.reset(observation, info)
        is_over = False
        while not is_over:
            observation, _, terminated, truncated, info = env.step(policy.act(observation))
            is_over = terminated or truncated
        assert info["is_success"], (seed, [str(failure) for failure in policy.failures])
        moved += info["moved_by_others"]
    assert moved >= 5


def test_what_the_oracle_is_told_of_a_moved_thing_is_its_place_alone(env):
    observation, _ = env.reset(seed=0, options={"instruction": GO, "placement": {"cup_1": "kitchen_table"}})
    unwrapped = env.unwrapped
    row, places = unwrapped.entities.index("cup_1"), unwrapped.world.place.copy()
    table = unwrapped.entities.index("coffee_table")
    before = observation["entities"].copy()
    unwrapped.world.shift(
        row, table, tuple(unwrapped.world.geometry.footprints[table].reshape(2, 2).mean(axis=0).tolist())
    )
    told = see_moved(unwrapped, observation, places)["entities"]
    assert (told[row, VISIBLE], told[row, PLACE]) == (1, table)
    assert (told[row, FIRST_STATE:] == before[row, FIRST_STATE:]).all()
    others = [other for other in range(len(told)) if other != row]
    assert (told[others] == before[others]).all()


def test_idle_gives_up_at_once(env):
    info, actions, _ = run(env, "idle")
    assert not info["is_success"]
    assert len(actions) == 1


def test_random_is_the_same_for_the_same_seed_and_never_finishes(env):
    first, second = (run(env, "random", max_seconds=5.0)[1] for _ in range(2))
    assert first == second
    assert len(first) == 50
    assert run(env, "random", seed=1, max_seconds=1.0)[1] != first[:10]


def test_an_unknown_agent_is_named_with_the_known_ones(env):
    with pytest.raises(InputError, match="'clever'; known: tree, oracle, random, idle"):
        env.unwrapped.policy("clever")


@pytest.mark.parametrize("name", ["tree", "oracle", "random", "idle"])
def test_flat_spaces_are_for_other_policies(name):
    with pytest.raises(InputError, match="make Household-v0"):
        gym.make("decomplex_bt/HouseholdFlat-v0").unwrapped.policy(name)


@pytest.mark.parametrize("wrapped", [True, False])
def test_the_tree_agent_says_what_it_needs_to_see(wrapped):
    env = gym.make(f"decomplex_bt/Household{'' if wrapped else 'Flat'}-v0", instruction=KEYS)
    env = gym.wrappers.FlattenObservation(env) if wrapped else env
    agent = decomplex_bt.TreeAgent(env, flow=KEYS)
    with pytest.raises(InputError, match="was given a ndarray"):
        agent.reset(*env.reset(seed=0))


def test_random_handles_what_is_in_the_house_of_now():
    env = gym.make("decomplex_bt/HouseholdSmall-v0", instruction=GO).unwrapped
    env.reset(seed=0, options={"house_seed": 1})
    policy, fewer = env.policy("random"), len(env.entities)
    observation, info = env.reset(options={"house_seed": 0})
    policy.reset(observation, info)
    assert fewer < len(env.entities)
    assert fewer <= max(policy.act(observation)["target"] for _ in range(500)) < len(env.entities)
