"""Generated houses hang together, have room for every type of task, and are lived in like the default one."""

from __future__ import annotations

import pickle
import re
import shutil
from pathlib import Path

import gymnasium as gym
import networkx as nx
import numpy as np
import pytest
import yaml

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.house import Doorway, Furniture, House, Item, Person, Room
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.chance import Draw
from decomplex_bt.envs.feasibility import find_cause
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.houses import MOST_ROOMS, SIZES, generate_house, generated_domain, with_house
from decomplex_bt.envs.reach import check_access, is_reachable
from decomplex_bt.envs.registration import HOUSEHOLD_LARGE, HOUSEHOLD_MEDIUM, HOUSEHOLD_SMALL
from decomplex_bt.envs.sensing import SensingConfig, Sensor
from decomplex_bt.envs.setting import setting_of
from decomplex_bt.envs.spots import MOST_STANDING, Spots
from decomplex_bt.envs.world import World, WorldConfig
from decomplex_bt.envs.world_truth import WorldTruth
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.planning.ground_task import HERE, GroundTask, Referent

DOMAIN = load_domain("household")
SEEDS = range(52)


def house_of(seed):
    return generate_house(DOMAIN, 2 + seed * 3 % (MOST_ROOMS - 1), seed)


def referent(*names):
    return Referent(names[0], tuple(names))


def truth_of(domain, seed=0):
    setting = setting_of(domain)
    draw, rng = Draw(setting.prior, setting.spots), np.random.default_rng(seed)
    draw.likeliest()
    draw.robot(None)
    world = World(
        setting.geometry,
        setting.prior,
        setting.spots,
        draw.start,
        config=WorldConfig(),
        noise=rng,
        whims=rng.random,
    )
    return WorldTruth(world, Sensor(world, SensingConfig()))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_house_is_connected_and_all_of_it_in_reach(seed):
    house = house_of(seed)
    rooms = nx.Graph()
    rooms.add_nodes_from(house.rooms)
    rooms.add_edges_from(doorway.rooms for doorway in house.doorways.values())
    assert len(house.rooms) == 2 + seed * 3 % (MOST_ROOMS - 1)
    assert nx.is_connected(rooms)
    domain = with_house(DOMAIN, house)
    check_access(domain, "house.yaml")
    assert all(is_reachable(domain, name) for name in (*house.rooms, *house.doorways, *house.places()))
    named = {entity for entities in domain.nouns.entities.values() for entity in entities}
    assert named >= {*house.rooms, *house.places(), *house.things, *house.people}


@pytest.mark.parametrize("seed", SEEDS)
def test_every_type_of_task_can_be_done(seed):
    domain = with_house(DOMAIN, house_of(seed))
    house, truth = domain.house, truth_of(domain)
    lying = [thing for thing in house.things if truth.place(thing) is not None]
    food = next(thing for thing in lying if "food" in domain.kind(thing).tags)
    device = next(name for name in house.furniture if domain.kind(name).is_device)
    surface = next(name for name in house.furniture if domain.kind(name).surface)
    box = next(name for name in house.furniture if domain.kind(name).inside and domain.kind(name).has_door)
    others = [person for person in house.people if truth.place(person) is not None and person != house.user]
    room, thing, user = referent(next(reversed(house.rooms))), referent(lying[0]), referent(house.user)
    tasks = [
        GroundTask(1, "motion", "go", goal=room),
        GroundTask(2, "searching", "look for", objects=(thing,), places=(referent(box),)),
        GroundTask(3, "taking", "take", objects=(thing,)),
        GroundTask(4, "placing", "put", objects=(thing,), goal=referent(surface)),
        GroundTask(5, "bringing", "bring", objects=(thing,), recipients=(user,)),
        GroundTask(6, "change_state", "turn on", objects=(referent(device),), state="on"),
        GroundTask(7, "change_state", "heat", objects=(referent(food),), state="hot"),
        GroundTask(8, "check_state", "is", objects=(thing,), places=(referent(box),), state=HERE),
        GroundTask(9, "following", "follow", objects=(referent(*others),), goal=room),
        GroundTask(10, "informing", "tell", recipients=(user,)),
    ]
    assert {task.type for task in tasks} == set(DOMAIN.ontology.task_types)
    assert [find_cause(task, {}, domain, truth) for task in tasks] == [None] * len(tasks)


def test_a_seed_makes_the_house():
    assert generate_house(DOMAIN, 9, 3) == generate_house(DOMAIN, 9, 3)
    assert generate_house(DOMAIN, 9, 3) != generate_house(DOMAIN, 9, 4)


@pytest.mark.parametrize("rooms", [1, 41])
def test_houses_of_other_sizes_are_refused(rooms):
    with pytest.raises(InputError, match="2 to 40"):
        generate_house(DOMAIN, rooms, 0)


@pytest.mark.parametrize("size", SIZES)
def test_the_spaces_of_a_size_hold_its_largest_houses(size):
    for seed in range(3):
        house = generate_house(DOMAIN, SIZES[size].rooms[1], seed)
        assert len(house.entities()) <= SIZES[size].rows
        assert max(Geometry(house, DOMAIN.kinds).bounds) <= SIZES[size].bounds


@pytest.mark.parametrize("identity", [HOUSEHOLD_SMALL, HOUSEHOLD_MEDIUM, HOUSEHOLD_LARGE])
def test_episodes_in_drawn_houses_stay_in_their_spaces(identity):
    env = gym.make(identity)
    houses = set()
    for seed in range(3):
        observation, _ = env.reset(seed=seed)
        assert observation in env.observation_space
        env.action_space.seed(seed)
        for _ in range(15):
            observation, _, terminated, truncated, _ = env.step({**env.action_space.sample(), "interact": seed + 1})
            assert observation in env.observation_space
            if terminated or truncated:
                break
        houses.add(env.unwrapped.domain.house.name)
    assert len(houses) == 3


def go(where):
    return read_markup(f"[Go](1:motion) [to the {where}](1:goal).", DOMAIN.ontology, flow=[1])


BRING = read_markup("[Bring](1:bringing) [me](1:recipient) [the plate](1:object).", DOMAIN.ontology, flow=[1])


@pytest.mark.parametrize("policy", ["tree", "oracle"])
@pytest.mark.parametrize(("identity", "seed"), [(HOUSEHOLD_SMALL, 1), (HOUSEHOLD_MEDIUM, 2), (HOUSEHOLD_LARGE, 3)])
def test_agents_live_in_any_house(identity, seed, policy):
    env = gym.make(identity, house_seed=seed)
    done = 0
    for k, instruction in enumerate((go("kitchen"), BRING)):
        observation, info = env.reset(seed=k, options={"instruction": instruction, "noise": False})
        agent = env.unwrapped.policy(policy, flow=instruction)
        agent.reset(observation, info)
        for _ in range(4000):
            observation, _, terminated, truncated, info = env.step(agent.act(observation))
            if terminated or truncated:
                break
        done += info["is_success"] or not info["feasible"]
    assert done == 2


def test_an_agent_moves_house_with_its_environment():
    env = gym.make(HOUSEHOLD_SMALL)
    agent = None
    for seed in (4, 9):
        observation, info = env.reset(seed=seed, options={"instruction": go("kitchen"), "house_seed": seed})
        agent = agent or decomplex_bt.TreeAgent(env, flow=go("kitchen"))
        agent.reset(observation, info)
        assert agent.session.belief.domain.house == generated_domain(DOMAIN, "small", seed).house
        while not agent.done:
            observation, _, _, _, info = env.step(agent.act(observation))
        assert info["is_success"]


def test_a_seed_of_a_house_stays_until_another_is_given():
    env = gym.make(HOUSEHOLD_SMALL)
    env.reset(seed=0, options={"house_seed": 5})
    first = env.unwrapped.domain.house
    env.reset()
    assert env.unwrapped.domain.house is first
    env.reset(options={"house_seed": 6})
    assert env.unwrapped.domain.house is not first


def test_without_a_seed_again_houses_are_drawn():
    env = gym.make("decomplex_bt/HouseholdSmall-v0", instruction="Go to the kitchen.").unwrapped

    def house(seed, **options):
        env.reset(seed=seed, options=options)
        return env.domain.house.name

    assert house(1, house_seed=3) == house(2)
    assert len({house(3, house_seed=None), house(4), house(5)}) > 1


def test_a_house_of_a_seed_is_that_of_the_environment_again():
    env = gym.make("decomplex_bt/HouseholdSmall-v0", instruction="Go to the kitchen.", house_seed=7).unwrapped
    env.reset(seed=0)
    first = env.domain.house.name
    env.reset(seed=1, options={"house_seed": 3})
    assert env.domain.house.name != first
    env.reset(seed=2, options={"house_seed": None})
    assert env.domain.house.name == first


def test_a_house_comes_from_a_file(tmp_path):
    house = generate_house(DOMAIN, 3, 0)
    path = tmp_path / "house.yaml"
    path.write_text(yaml.safe_dump(house.model_dump(mode="json"), sort_keys=False))
    env = HouseholdEnv(go("kitchen"), house=path)
    assert env.reset(seed=0)[0] in env.observation_space
    assert env.domain.house == house
    small = HouseholdEnv(go("kitchen"), size="small")
    small.reset(seed=0, options={"house": path})
    assert small.domain.house == house
    with pytest.raises(InputError, match="spaces are made for"):
        HouseholdEnv(go("kitchen"), house=path).reset(options={"house": str(DOMAIN.folder / "house.yaml")})


def test_a_copy_of_an_environment_finds_its_files_from_wherever_it_is(tmp_path, monkeypatch):
    shutil.copytree(DOMAIN.folder, tmp_path / "mine", ignore=shutil.ignore_patterns("corpus", "models"))
    monkeypatch.chdir(tmp_path)
    made = {
        "domain": HouseholdEnv(go("kitchen"), domain="mine/"),
        "house": HouseholdEnv(go("kitchen"), house="mine/house.yaml"),
        "option": HouseholdEnv(go("kitchen")),
    }
    for name, env in made.items():
        env.reset(seed=0, options={"house": "mine/house.yaml"} if name == "option" else None)
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    for env in made.values():
        assert pickle.loads(pickle.dumps(env)).inform() == env.inform()


def changed(*steps, to):
    """A change of a house's data: what the keys lead to becomes another value."""

    def change(data):
        *path, last = steps
        for key in path:
            data = data[key]
        if to is None:
            del data[last]
        else:
            data[last] = to

    return change


ATTIC = {"kind": "study", "rect": [20, 20, 25, 25]}


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (
            changed("rooms", "living_room", "rect", to=[4.4, 5.3, 440, 370]),
            r"rooms\.living_room: .*440 x 370 m, 162800 m².*may take up 4000 m².*metres",
        ),
        (changed("rooms", "attic", to={**ATTIC, "rect": [900, 0, 903, 3]}), r"rooms\.attic: .*903 x 9 m.*together"),
        (changed("rooms", "attic", to={**ATTIC, "rect": [1e9, 0, 2e9, 3]}), r"rooms\.attic\.rect: 2e\+09 m.*10000 m"),
        (changed("furniture", "fridge", "centre", to=[100, 100]), r"furniture\.fridge.*not within its room, kitchen"),
        (changed("furniture", "fridge", "centre", to=[4.4, 8.0]), r"furniture\.fridge.*not within its room, kitchen"),
        (changed("furniture", "kitchen_window", "centre", to=[3, 20]), r"furniture\.kitchen_window.*not within"),
        (changed("furniture", "fridge", "centre", to=[2.2, 7.1]), r"furniture\.fridge: it overlaps kitchen_table"),
        (changed("furniture", "fridge", "size", to=[0, 0]), r"furniture\.fridge\.size\.0.*greater than 0"),
        (changed("things", "robot", to={"kind": "pen"}), r"things\.robot.*stands twice.*the robot"),
        (changed("things", "kitchen_floor", to={"kind": "pen"}), r"things\.kitchen_floor.*the floor of kitchen"),
        (changed("things", "fridge", to={"kind": "pen"}), r"things\.fridge.*furniture\.fridge"),
        (changed("doorways", "kitchen_doorway", to=None), r"rooms\.kitchen: no way joins it"),
        (changed("doorways", "kitchen_doorway", "width", to=0.4), r"doorways\.kitchen_doorway.*cannot drive through"),
        (changed("doorways", "kitchen_doorway", "centre", to=[2.2, 6]), r"doorways\.kitchen_doorway.*common wall"),
        (changed("furniture", "kitchen_table", "centre", to=[2.2, 5.8]), r"doorways\.kitchen_doorway.*clear the way"),
        (changed("rooms", "attic", to=ATTIC), r"rooms\.attic: no way joins it"),
        (changed("rooms", "attic", to={**ATTIC, "rect": [1, 6, 2, 7]}), r"rooms\.attic: it overlaps kitchen"),
        (changed("rooms", "kitchen", "rect", to=[4.4, 5.3, 0, 9]), r"rooms\.kitchen\.rect.*x0 < x1"),
        (changed("rooms", "kitchen", "rect", to=[float("nan"), 5.3, 4.4, 9]), r"rooms\.kitchen\.rect\.0.*finite"),
        (changed("furniture", "fridge", "centre", to=[0.4, float("inf")]), r"furniture\.fridge\.centre\.1.*finite"),
        (changed("robot_start", to={"kitchen": 0}), r"robot_start.*all weights are 0"),
        (
            changed("people", "anna", "rooms", to={"attic": 1}),
            r"people\.anna\.rooms: unknown room 'attic'; known: kitchen,",
        ),
        (changed("furniture", "fridge", "kind", to="frige"), r"the kind 'frige' is unknown.*nearest known: fridge"),
        (
            changed("furniture", "fridge", "kind", to="pen"),
            r"the kind 'pen' is a thing; expected .* furniture or fixture",
        ),
        (changed("things", "apple", "kind", to="fridge"), r"things\.apple: the kind 'fridge' is a furniture; .* thing"),
        (changed("furniture", "fridge", "room", to="kitchn"), r"unknown room 'kitchn'; the nearest known: kitchen"),
        (changed("furniture", "drawer", "part_of", to="couter"), r"unknown 'couter'; the nearest known: counter"),
        (changed("furniture", "drawer", "part_of", to="drawer"), r"furniture\.drawer: it is part of itself"),
        (
            changed("furniture", "counter", "part_of", to="sink"),
            r"furniture\.counter: .* itself, by way of sink, counter",
        ),
        (changed("furniture", "drawer", "part_of", to="bed"), r"part of bed, which is in bedroom, another room"),
        (changed("furniture", "drawer", "part_of", to="fridge"), r"part of fridge and does not touch it"),
        (changed("things", "apple", "colour", to="rde"), r"apple\.colour: 'rde' is none .*nearest known: red"),
        (changed("furniture", "fridge", "side", to=["south"]), r"fridge\.side: there is no such key; .* sides, size"),
        (changed("furniture", "fridge", "sides", to=None), r"fridge\.sides: it is missing, and required"),
        (changed("colour", to="red"), r"colour: there is no such key; known: format, name, rooms"),
        (
            changed("doorways", "kitchen_doorway", "rooms", to=["hall", "kitchen"]),
            r"'hall'; the nearest known: hallway",
        ),
        (changed("rooms", "Den", to=ATTIC), r"rooms\.Den: 'Den' is no lower-case identifier; .* as in living_room"),
        (
            changed("people", "anna", to={"kind": "user", "rooms": {"study": 1}}),
            r"people\.anna: a second user.*first of the people, user",
        ),
        (changed("people", to={}), r"people: .*at least 1"),
        (changed("rooms", to={}), r"rooms: .*at least 1"),
        (
            changed("furniture", to={}),
            r"things\.pen_1: the house has none of the places of its kind \(desk, .*add one of them under furniture, "
            r"or give the thing its own, as in places: \{kitchen_floor: 1\}",
        ),
        (
            changed("things", "apple", to={"kind": "apple", "places": {"frige": 1}}),
            r"things\.apple\.places: 'frige' is no place .*the nearest known: fridge; add it under furniture",
        ),
        (
            changed("things", "apple", to={"kind": "apple", "places": {"tv": 1}}),
            r"things\.apple: nothing can lie .*'tv'",
        ),
    ],
)
def test_a_house_that_cannot_be_is_refused_naming_file_and_key(tmp_path, change, says):
    data = yaml.safe_load((DOMAIN.folder / "house.yaml").read_text())
    change(data)
    path = tmp_path / "house.yaml"
    path.write_text(yaml.safe_dump(data, sort_keys=False))
    with pytest.raises(DataFileError, match=says) as found:
        HouseholdEnv(go("kitchen"), house=path)
    assert found.value.path == str(path)


def test_a_hall_of_a_house_is_lived_in_without_delay():
    """Of a large floor no more spots are tried than of a smaller one, for each takes the longer the larger it is."""
    rooms = {"hall": Room(kind="living room", rect=(0, 0, 60, 60))}
    house = DOMAIN.house.model_copy(update={"rooms": rooms, "doorways": {}, "furniture": {}})
    spots = Spots(Geometry(house, DOMAIN.kinds))
    assert 500 < len(spots.standing(0)) <= MOST_STANDING


def test_the_house_of_a_folder_is_looked_over_as_well(tmp_path):
    for name in ("ontology.yaml", "kinds.yaml", "words.yaml", "goals.yaml", "domain.pddl"):
        shutil.copy(DOMAIN.folder / name, tmp_path)
    text = (DOMAIN.folder / "house.yaml").read_text().replace("[2.2, 5.3], width: 1.1", "[2.2, 5.3], width: 0.4")
    (tmp_path / "house.yaml").write_text(text)
    with pytest.raises(DataFileError, match=r"house\.yaml: doorways\.kitchen_doorway"):
        HouseholdEnv(go("kitchen"), domain=tmp_path)


def test_a_house_need_not_have_all_the_places_of_a_kind(tmp_path):
    data = yaml.safe_load((DOMAIN.folder / "house.yaml").read_text())
    del data["furniture"]["cupboard"]
    path = tmp_path / "house.yaml"
    path.write_text(yaml.safe_dump(data, sort_keys=False))
    env = HouseholdEnv(go("kitchen"), house=path)
    env.reset(seed=0)
    assert "cupboard" in DOMAIN.kinds.kinds["cup"].places
    rows, weights = env.setting.prior.places(env.entities.index("cup_1"))
    assert weights.sum() == pytest.approx(1)
    assert {env.entities[row] for row in rows[weights > 0] if row >= 0} >= {"dishwasher", "kitchen_table"}


def test_a_thing_that_is_never_there_needs_no_place(tmp_path):
    data = yaml.safe_load((DOMAIN.folder / "house.yaml").read_text())
    path = tmp_path / "house.yaml"
    things = {"apple": {"kind": "apple", "absent": 1}}
    path.write_text(yaml.safe_dump({**data, "furniture": {}, "things": things}, sort_keys=False))
    assert HouseholdEnv(go("kitchen"), house=path).reset(seed=0)[1]["feasible"]


def test_a_file_that_is_no_house_is_refused(tmp_path):
    path = tmp_path / "house.yaml"
    path.write_text("")
    with pytest.raises(DataFileError, match=r"the whole: Input should be a mapping \(got None\)"):
        HouseholdEnv(go("kitchen"), house=path)


MANUAL = Path(__file__).parents[2] / "docs" / "environment.md"


@pytest.mark.skipif(not MANUAL.exists(), reason="not the source tree")
def test_the_house_of_the_manual_is_lived_in(tmp_path):
    path = tmp_path / "house.yaml"
    path.write_text(re.search(r"```yaml\n(.*?)```", MANUAL.read_text(encoding="utf-8"), re.DOTALL)[1])
    assert HouseholdEnv(go("kitchen"), house=path).reset(seed=0)[1]["feasible"]


@pytest.mark.skipif(not MANUAL.exists(), reason="not the source tree")
@pytest.mark.parametrize("record", [House, Room, Doorway, Furniture, Item, Person])
def test_the_manual_has_every_key_of_a_house_and_whether_it_is_required(record):
    lines = MANUAL.read_text(encoding="utf-8").splitlines()
    sections = {Room: "rooms", Doorway: "doorways", Furniture: "furniture", Item: "things", Person: "people"}
    section, stated = "", {}
    for cells in ([cell.strip() for cell in line.split("|")] for line in lines if line.startswith("| ")):
        section = cells[1].strip("`") if len(cells) == 6 and cells[1] else section
        keys, required = cells[-4:-2]
        for key in re.findall(r"`(\w+)`", keys):
            stated[section if len(cells) == 6 else "", key] = required
    for key, field in record.model_fields.items():
        assert stated[sections.get(record, ""), key].startswith("yes" if field.is_required() else "no"), key


def test_the_shipped_house_is_in_order():
    check_access(DOMAIN, "house.yaml")


def test_a_house_without_things_is_lived_in(tmp_path):
    data = yaml.safe_load((DOMAIN.folder / "house.yaml").read_text())
    path = tmp_path / "house.yaml"
    path.write_text(yaml.safe_dump({**data, "things": {}}, sort_keys=False))
    env = HouseholdEnv(go("kitchen"), house=path)
    observation, info = env.reset(seed=0)
    agent = decomplex_bt.TreeAgent(env, flow=go("kitchen"))
    agent.reset(observation, info)
    while not agent.done:
        observation, _, _, _, info = env.step(agent.act(observation))
    assert info["is_success"]


def test_a_house_file_that_was_edited_is_read_anew(tmp_path):
    path, text = tmp_path / "house.yaml", (DOMAIN.folder / "house.yaml").read_text()
    path.write_text(text.replace("default house", "first  house"))
    env = HouseholdEnv(go("kitchen"), house=path)
    env.reset(seed=0)
    path.write_text(text.replace("default house", "second house"))
    env.reset(seed=0)
    assert env.domain.house.name == "first  house", "an environment stays in the house it was made in"
    assert HouseholdEnv(go("kitchen"), house=path).domain.house.name == "second house"
    env.reset(options={"house": path})
    assert env.domain.house.name == "second house"


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"house_seed": -1}, "from 0"),
        ({"house_seed": "x"}, "whole number"),
        ({"house": 3}, "path"),
        ({"house": "nowhere.yaml"}, "nowhere.yaml"),
        ({"house": "a", "house_seed": 1}, "exclude"),
    ],
    ids=str,
)
def test_houses_that_cannot_be_had_are_refused(options, says):
    with pytest.raises(ValueError, match=says):
        HouseholdEnv(size="small").reset(seed=0, options=options)


@pytest.mark.parametrize("options", [{"house_seed": 6, "balance": 7}, {"house": "nowhere.yaml"}], ids=str)
def test_a_refused_reset_moves_nobody(options):
    env = HouseholdEnv(go("kitchen"), size="small", house_seed=5)
    body = env.embodiment()
    observation, _ = env.reset(seed=0)
    house = env.domain.house
    with pytest.raises(InputError):
        env.reset(options=options)
    assert env.domain.house is house
    assert body.house is house
    assert np.array_equal(env.reset(seed=0)[0]["entities"], observation["entities"])
    assert env.domain.house is house


def test_a_house_from_a_file_has_no_seed():
    env = HouseholdEnv(go("kitchen"), house=DOMAIN.folder / "house.yaml")
    with pytest.raises(InputError, match="generates no houses"):
        env.reset(seed=0, options={"house_seed": 1})
    env.reset(seed=0)


def test_the_default_house_has_no_seed():
    with pytest.raises(InputError, match="generates no houses"):
        HouseholdEnv().reset(seed=0, options={"house_seed": 1})
    with pytest.raises(InputError, match="small, medium, large"):
        HouseholdEnv(size="vast")


@pytest.mark.parametrize(("size", "is_over"), [("small", True), ("large", False)])
def test_large_houses_take_longer(size, is_over):
    env = HouseholdEnv(BRING, size=size, house_seed=5)
    env.reset(seed=0)
    rest = {"drive": np.zeros(2, dtype=np.float32), "interact": 0, "target": 0}
    for _ in range(6000):  # 600 s
        *_, truncated, _ = env.step(rest)
    assert truncated is is_over
