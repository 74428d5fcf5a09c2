"""What `info` says of an episode, and when: the verdict, the branches, the way driven and the shortest there was."""

from __future__ import annotations

from pathlib import Path

import gymnasium as gym
import numpy as np
import pytest
from py_trees.common import Status

import decomplex_bt
from decomplex_bt.corpus import read_corpus, read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.registration import HOUSEHOLD

ONTOLOGY = load_domain("household").ontology
EXAMPLES = read_corpus(Path(__file__).parents[2] / "benchmarks" / "class_sentences.yaml", ONTOLOGY)
KEYS = {
    "instruction",
    "seconds",
    "path_length",
    "shortest_length",
    "result",
    "events",
    "is_success",
    "judged_by",
    "goal_conditions_met",
    "goal_conditions_total",
    "branches",
    "violations",
    "unsettled",
    "feasible",
    "infeasible_cause",
    "moved_by_others",
}
REST = {"drive": np.zeros(2, dtype=np.float32), "interact": 0, "target": 0}


def markup(text, flow):
    return read_markup(text, ONTOLOGY, flow=flow)


CLOSE_AND_OPEN = markup(
    "[Close](1:change_state) [the bedroom window](1:object) and [open](2:change_state) [the kitchen window](2:object).",
    [1, 2],
)
TELL_OF_TV = markup(
    "[Turn](1:change_state) [on](1:state) [the tv](1:object). If you cannot, [tell](2:informing) [me](2:recipient).",
    [{"if": 1, "else": [2]}],
)
GO = markup("[Go](1:motion) [to the kitchen](1:goal).", [1])
TV = markup(
    "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) off.",
    [{"if": 1, "then": [2]}],
)


@pytest.mark.parametrize(("kitchen", "met", "unsettled"), [("open", 2, 0), ("closed", 1, 2)])
def test_what_holds_at_the_start_is_done_and_the_first_info_tells(kitchen, met, unsettled):
    env = gym.make(HOUSEHOLD, instruction=CLOSE_AND_OPEN)
    _, info = env.reset(seed=0, options={"states": {"bedroom_window": "closed", "kitchen_window": kitchen}})
    assert (info["goal_conditions_met"], info["goal_conditions_total"], info["unsettled"]) == (met, 2, unsettled)
    assert info["is_success"] is (met == 2)
    _, reward, terminated, _, _ = env.step(REST)
    assert (reward, terminated) == (float(met == 2), met == 2)


@pytest.mark.parametrize("is_broken", [True, False])
def test_whether_something_can_be_done_is_true_or_false_without_a_try(is_broken):
    env = gym.make(HOUSEHOLD, instruction=TELL_OF_TV)
    options = {"states": {"tv": "off"}, "broken": ["tv"] * is_broken, "noise": False}
    observation, info = env.reset(seed=0, options=options)
    assert info["branches"] == [
        {"task": 1, "truth": False if is_broken else None, "taken": "else" if is_broken else None}
    ]
    agent = env.unwrapped.policy("tree", flow=markup("[Tell](1:informing) [me](1:recipient) [hello](1:message).", [1]))
    agent.reset(observation, info)
    terminated = False
    while not terminated:
        observation, _, terminated, _, info = env.step(agent.act(observation))
    assert (info["is_success"], bool(info["violations"])) == (is_broken, not is_broken)


def play(env, example, seed, **options):
    observation, info = env.reset(seed=seed, options={"instruction": example, **options})
    agent = decomplex_bt.TreeAgent(env, flow=getattr(example, "instruction", example))
    agent.reset(observation, info)
    steps = []
    while True:
        action = agent.act(observation)
        observation, _, terminated, truncated, info = env.step(action)
        steps.append((action, info))
        if terminated or truncated:
            return agent, steps


@pytest.mark.parametrize("instruction", [GO, TV], ids=["go", "tv"])
def test_info_has_all_its_keys_in_every_step(instruction):
    env = HouseholdEnv(instruction)
    _, info = env.reset(seed=0)
    assert set(info) == KEYS | {"exempt"}
    for _ in range(5):
        assert set(env.step(REST)[4]) == KEYS


def test_info_follows_the_episode_through_its_branches():
    env = gym.make(HOUSEHOLD)
    _, steps = play(env, TV, 3, chance=False, states={"tv": "on"})
    first, last = steps[0][1], steps[-1][1]
    assert (first["goal_conditions_met"], first["goal_conditions_total"]) == (0, 2)
    assert (last["goal_conditions_met"], last["goal_conditions_total"]) == (2, 2)
    assert first["branches"] == [{"task": 1, "truth": None, "taken": None}]
    assert last["branches"] == [{"task": 1, "truth": True, "taken": "then"}]
    assert last["events"] == ["switch off tv: ok"]
    assert last["is_success"]
    assert last["feasible"]
    assert not last["violations"]


def test_a_violation_is_told_and_ends_the_episode():
    env = HouseholdEnv(
        markup(
            "[Switch](1:change_state) [the tv](1:object) on, then [close](2:change_state) [the fridge](2:object).",
            [1, 2],
        )
    )
    env.reset(seed=0, options={"chance": False, "states": {"fridge": "open", "tv": "off"}})
    env.world._robot.position = 0.9, 7.9
    env.step(REST)
    _, reward, terminated, _, info = env.step(
        {**REST, "interact": int(Interaction.CLOSE), "target": env.entities.index("fridge")}
    )
    assert (reward, terminated, info["is_success"]) == (0.0, True, False)
    assert len(info["violations"]) == 1
    assert "task 2" in info["violations"][0]


def test_what_cannot_be_done_is_infeasible_with_its_cause():
    env = HouseholdEnv(markup("[Bring](1:bringing) [me](1:recipient) [the apple](1:object).", [1]))
    _, info = env.reset(seed=0, options={"placement": {"apple": None}})
    assert info["feasible"] is False
    assert "apple" in info["infeasible_cause"]


def test_infos_are_the_callers_own():
    env = HouseholdEnv(TV)
    env.reset(seed=0)
    info = env.step(REST)[4]
    info["branches"].clear()
    info["events"].append("x")
    assert env.step(REST)[4]["branches"]
    assert env.step(REST)[4]["events"] == []


@pytest.mark.parametrize("index", [0, 2, 3, 5, 9])
def test_the_judge_is_at_most_one_step_late(index):
    prompt, asked = gym.make(HOUSEHOLD), gym.make(HOUSEHOLD)
    _, steps = play(prompt, EXAMPLES[index], index)
    asked.reset(seed=index, options={"instruction": EXAMPLES[index]})
    asked.unwrapped._episode.has_news = lambda: True
    ends = [any(asked.step(action)[2:4]) for action, _ in steps[:-2]]
    assert not any(ends)


def test_somebody_who_walks_into_the_goal_is_noticed_at_once():
    env = HouseholdEnv(markup("[Follow](1:following) [Anna](1:object) [to the kitchen](1:goal).", [1]))
    env.reset(seed=0, options={"chance": False, "people": {"anna": "hallway"}})
    world, row = env.world, env.entities.index
    env.world._robot.position = 2.2, 6.0  # in the kitchen already
    body = world.start_walking(row("anna"))
    body.position = 2.2, 5.25
    is_there = is_over = False
    while not is_there:
        assert not is_over
        body.velocity = 0.0, 0.3
        _, _, is_over, _, info = env.step(REST)
        is_there = body.position.y > 5.3
    assert info["is_success"]


# -- the loop of the README -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("index", [0, 3, 6])
def test_an_agent_knows_that_the_judge_was_first(index):
    agent, steps = play(gym.make(HOUSEHOLD), EXAMPLES[index], index)
    assert steps[-1][1]["is_success"]
    assert steps[-1][0]["interact"] != Interaction.FINISH
    assert agent.done
    assert agent.status == Status.SUCCESS
    assert not agent.failures


def test_an_agent_whose_time_is_up_is_done_and_has_failed_at_what_it_was_at():
    agent, steps = play(gym.make(HOUSEHOLD), GO, 0, chance=False, max_seconds=0.3)
    assert len(steps) == 3
    assert agent.done
    assert agent.status == Status.FAILURE
    (failure,) = agent.failures
    assert (failure.stage, failure.task, failure.words, failure.attempts) == ("execution", 1, (0, 2), 1)
    assert failure.action is not None
    assert failure.observed == "the time was up"
    assert agent.failures == (failure,)
    assert agent.not_attempted == ()


def test_a_condition_that_the_time_was_too_short_for_is_undecided():
    asked = markup(
        "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) "
        "[off](2:state), otherwise [go](3:motion) [to the study](3:goal). [Close](4:change_state) [the "
        "fridge](4:object).",
        [{"if": 1, "then": [2], "else": [3]}, 4],
    )
    agent, _ = play(gym.make(HOUSEHOLD), asked, 0, chance=False, max_seconds=0.3)
    assert agent.branches() == ((1, None, None),)
    assert [failure.task for failure in agent.failures] == [1]
    assert [(failure.task, failure.reason) for failure in agent.not_attempted] == [(4, "not attempted")]


def test_an_agent_forgets_that_the_time_of_the_last_episode_was_up():
    env = gym.make(HOUSEHOLD)
    agent, _ = play(env, GO, 0, chance=False, max_seconds=0.3)
    agent.reset(*env.reset(seed=0, options={"instruction": GO, "chance": False}))
    assert (agent.done, agent.status, agent.failures) == (False, Status.INVALID, ())


def test_an_agent_is_not_done_before():
    env = gym.make(HOUSEHOLD)
    observation, info = env.reset(seed=0, options={"instruction": GO, "chance": False})
    agent = decomplex_bt.TreeAgent(env, flow=GO)
    agent.reset(observation, info)
    assert not agent.done
    env.step(agent.act(observation))
    assert not agent.done
    assert agent.status == Status.RUNNING


# -- the shortest path ------------------------------------------------------------------------------------------------


def test_the_shortest_path_is_told_with_success_and_not_before():
    _, steps = play(gym.make(HOUSEHOLD), GO, 0, chance=False)
    assert all(info["shortest_length"] == -1 for _, info in steps[:-1])
    assert 0 < steps[-1][1]["shortest_length"] <= steps[-1][1]["path_length"] + 0.1


@pytest.mark.parametrize("index", range(0, 10, 3))
def test_no_drive_is_shorter_than_the_shortest_path(index):
    _, steps = play(gym.make(HOUSEHOLD), EXAMPLES[index], index + 10)
    info = steps[-1][1]
    if info["is_success"]:
        assert 0 <= info["shortest_length"] <= info["path_length"] + 0.2


def test_who_is_there_already_need_not_drive():
    env = HouseholdEnv(GO)
    env.reset(seed=0, options={"chance": False})
    env._episode.start.position[-1] = 2.2, 6.0
    env.world._robot.position = 2.2, 6.0
    assert env.step(REST)[4]["shortest_length"] == 0.0


def test_a_straight_way_is_as_long_as_it_is():
    env = HouseholdEnv(markup("[Go](1:motion) [to the study](1:goal).", [1]))
    env.reset(seed=0, options={"chance": False})
    env._episode.start.position[-1] = 8.4, 4.5
    env.world._robot.position = 8.4, 3.5
    assert env.step(REST)[4]["shortest_length"] == pytest.approx(0.6, abs=0.08)


def shortest(text, flow, at, **options):
    """The shortest path of an oracle that sets out from a point and has driven far too long already."""
    env = HouseholdEnv(markup(text, flow))
    env.reset(seed=0, options={"chance": False, **options})
    episode = env._episode
    env.world._robot.position = episode.start.position[-1] = at
    episode._path_length = 100.0
    observation, _, terminated, _, info = env.step(REST)
    oracle = env.policy("oracle")
    oracle.reset(observation, info)
    while not (terminated or oracle.done):
        observation, _, terminated, _, info = env.step(oracle.act(observation))
    assert info["is_success"]
    return info["shortest_length"]


ON_THE_COUCH, IN_THE_KITCHEN = (6.3, 7.6), (3.3, 7.15)
TO_THE_KITCHEN = "[go](2:motion) [to the kitchen](2:goal)"
APPLE_ON_DESK = "[Put](1:placing) [the apple](1:object) [on the desk](1:goal)"
TO_THE_HALLWAY = "[go](2:motion) [to the hallway](2:goal)"


def test_what_lies_where_it_is_to_go_needs_no_stop():
    alone = shortest("[Go](1:motion) [to the kitchen](1:goal).", [1], ON_THE_COUCH)
    there, away = (
        shortest(f"{APPLE_ON_DESK}, then {TO_THE_KITCHEN}.", [1, 2], ON_THE_COUCH, placement={"apple": place})
        for place in ("desk", "coffee_table")
    )
    assert there == pytest.approx(alone)
    assert away > alone + 4


def test_of_several_things_only_what_is_away_is_fetched():
    both = "[Put](1:placing) [the apple](1:object) and [the pan](1:object) [on the desk](1:goal)."
    pan = "[Put](1:placing) [the pan](1:object) [on the desk](1:goal)."
    placement = {"apple": "desk", "pan": "kitchen_table"}
    assert shortest(both, [1], ON_THE_COUCH, placement=placement) == pytest.approx(
        shortest(pan, [1], ON_THE_COUCH, placement=placement)
    )


def test_what_is_in_the_room_it_is_to_go_to_stays_where_it_is():
    bring = "[Bring](1:bringing) [the apple](1:object) [to the kitchen](1:goal)"
    take = "[take](2:taking) [it](2:object=the apple)"
    fetched = shortest("[Take](1:taking) [the apple](1:object).", [1], ON_THE_COUCH, placement={"apple": "stove"})
    assert shortest(f"{bring}, then {take}.", [1, 2], ON_THE_COUCH, placement={"apple": "stove"}) == pytest.approx(
        fetched
    )


def test_to_be_in_a_room_is_not_to_lie_on_its_floor():
    put = "[Put](1:placing) [the apple](1:object) [on the floor of the kitchen](1:goal)."
    alone = shortest("[Go](1:motion) [to the kitchen](1:goal).", [1], ON_THE_COUCH)
    assert shortest(put, [1], ON_THE_COUCH, placement={"apple": "kitchen_floor"}) == 0.0
    assert shortest(put, [1], ON_THE_COUCH, placement={"apple": "counter"}) > alone


@pytest.mark.parametrize(
    ("what", "is_near"),
    [
        ("the fridge](1:object) [is](1:check_state) [open](1:state)", False),
        ("the milk](1:object) [is](1:check_state) [in the fridge](1:location)", True),
    ],
)
def test_a_container_is_seen_from_afar_and_what_is_in_it_from_near(what, is_near):
    alone = shortest("[Go](1:motion) [to the hallway](1:goal).", [1], IN_THE_KITCHEN)
    told = f"If [{what}, {TO_THE_HALLWAY}."
    asked = shortest(
        told, [{"if": 1, "then": [2]}], IN_THE_KITCHEN, states={"fridge": "open"}, placement={"milk": "fridge"}
    )
    assert (asked > alone + 0.5) is is_near
    assert is_near or asked == pytest.approx(alone)


def test_what_is_found_elsewhere_than_where_it_is_looked_for_is_found():
    look = "[Look](1:searching) for [the apple](1:object) [on the bed](1:location)."
    assert shortest(look, [1], ON_THE_COUCH, placement={"apple": "coffee_table"}) == 0.0


PEOPLE = {"anna": "bedroom", "tom": "study", "guest": "kitchen", "relative": None}
WINDOWS = {name: "closed" for name in load_domain("household").house.furniture if "window" in name}


@pytest.mark.parametrize(
    ("text", "flow", "options"),
    [
        ("[Go](1:motion) [to the kitchen and the study](1:goal).", [1], {}),
        ("[Tell](1:informing) [everybody](1:recipient) [that it is late](1:message).", [1], {"people": PEOPLE}),
        (
            "If [any window](1:object) [is](1:check_state) [open](1:state), [close](2:change_state) "
            "[it](2:object=any window).",
            [{"if": 1, "then": [2]}],
            {"states": WINDOWS},
        ),
        ("[Turn](1:change_state) on [the oven](1:object).", [1], {"states": {"oven": ("on", "open")}}),
        (
            "If [the keys](1:object) [are](1:check_state) [on the table](1:location), [go](2:motion) "
            "[to the study](2:goal).",
            [{"if": 1, "then": [2]}],
            {"placement": {"keys": None}},
        ),
        (
            "If [the mug](1:object) [is](1:check_state) [dirty](1:state) [on the bed](1:location), [go](2:motion) "
            "[to the kitchen](2:goal).",
            [{"if": 1, "then": [2]}],
            {"placement": {"mug_1": "hallway_table", "mug_2": "hallway_table"}},
        ),
    ],
)
def test_where_all_are_meant_each_is_a_stop(text, flow, options):
    env = HouseholdEnv(markup(text, flow))
    observation, info = env.reset(seed=0, options={"chance": False, **options})
    oracle = env.policy("oracle")
    oracle.reset(observation, info)
    while not (info["is_success"] or oracle.done):
        observation, *_, info = env.step(oracle.act(observation))
    assert info["is_success"]
    assert 0.4 * info["path_length"] < info["shortest_length"] <= info["path_length"] + 0.2


def followed(text, flow, **options):
    """The last info of an oracle that follows, and the room it ends in."""
    env = HouseholdEnv(markup(text, flow))
    people = {"anna": "bedroom", "tom": None, "guest": None, "relative": None}
    observation, info = env.reset(seed=0, options={"chance": False, "people": people, **options})
    oracle = env.policy("oracle")
    oracle.reset(observation, info)
    while not (info["is_success"] or oracle.done):
        observation, *_, info = env.step(oracle.act(observation))
    assert info["is_success"]
    return info, env.truth().room


def test_who_leads_wherever_they_like_is_followed_there():
    """The same way as where the room is named, though who knows the world knows it from the first."""
    anywhere, room = followed("[Follow](1:following) [Anna](1:object).", [1])
    assert room != "bedroom"
    named = f"[Follow](1:following) [Anna](1:object) [to the {room.replace('_', ' ')}](1:goal)."
    there, _ = followed(named, [1])
    assert anywhere["shortest_length"] == pytest.approx(there["shortest_length"], abs=0.05)
    assert 0.5 * anywhere["path_length"] < anywhere["shortest_length"] <= anywhere["path_length"]


@pytest.mark.parametrize("goal", ["", " [to the kitchen](1:goal)"])
def test_who_has_led_the_way_is_spoken_to_where_they_went(goal):
    alone, _ = followed(f"[Follow](1:following) [Anna](1:object){goal}.", [1])
    tell = "[tell](2:informing) [her](2:recipient=Anna) [hello](2:message)"
    told, _ = followed(f"[Follow](1:following) [Anna](1:object){goal}, then {tell}.", [1, 2])
    assert told["shortest_length"] == pytest.approx(alone["shortest_length"], abs=0.6)
