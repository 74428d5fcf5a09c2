"""Skills in the true world: what they bring about, and what they say where they cannot."""

from __future__ import annotations

import pytest
import yaml

from decomplex_bt.behaviour.embodiment import SkillStatus
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.approach import SkillError, drive_to, face
from decomplex_bt.envs.following import _look_for
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.looking import turn_round
from decomplex_bt.envs.navigation import wrap
from decomplex_bt.planning.belief import FINAL_REASONS
from decomplex_bt.planning.pddl import GroundAction

DOMAIN = load_domain("household")
# Something nobody does in these tests, so that no episode ends early.
NEVER = read_markup("[Turn](1:change_state) [on](1:state) [the fan](1:object).", DOMAIN.ontology, flow=[1])


class Try:
    """An episode without chance in which skills are carried out one after the other."""

    def __init__(self, *, house=None, **options):
        self.env = HouseholdEnv(NEVER, house=house)
        self.body = self.env.embodiment()
        self.observation, _ = self.env.reset(seed=1, options={"chance": False, **options})
        self.body.reset(self.observation)
        self.actions = []

    def do(self, step, *, max_steps=800):
        """The last tick of a skill, given as "move hallway_floor fridge kitchen"."""
        name, *objects = step.split()
        skill = self.body.skill(GroundAction(name, tuple(objects)))
        for _ in range(max_steps):
            tick = skill.tick(self.observation)
            if tick.status is not SkillStatus.RUNNING:
                return tick
            self.actions.append(tick.action)
            self.observation, *_ = self.env.step(tick.action)
        raise AssertionError(f"{step} did not end")

    def run(self, script):
        """Carries out a script to its end."""
        for action in script:
            self.observation, *_ = self.env.step(action)
            self.body.perceive(self.observation)

    def go(self, place, room):
        """Drives to a place from wherever the robot is; doors stand open."""
        senses = self.body.senses
        for doorway, spec in DOMAIN.house.doorways.items():
            if senses.room != "hallway" and set(spec.rooms) == {senses.room, "hallway"} and senses.room != room:
                self.do(f"move x {doorway} {senses.room}")
                self.do(f"pass {doorway} {senses.room} hallway")
        for doorway, spec in DOMAIN.house.doorways.items():
            if senses.room == "hallway" and set(spec.rooms) == {"hallway", room}:
                self.do(f"move x {doorway} hallway")
                self.do(f"pass {doorway} hallway {room}")
        return self.do(f"move x {place} {room}")

    def place(self, thing):
        world = self.env.world
        return world.geometry.names[world.place[world.geometry.row[thing]]]


OPEN = {"bedroom_door": "open", "bathroom_door": "open"}


def attempt(**options):
    return Try(**{**options, "states": {**OPEN, **options.get("states", {})}})


def test_a_thing_is_carried_from_one_room_to_another():
    t = attempt(placement={"milk": "fridge"}, states={"fridge": "closed"})
    t.go("fridge", "kitchen")
    for step in ("open-up fridge", "inspect fridge", "pick milk fridge"):
        assert t.do(step).status is SkillStatus.SUCCESS
    assert t.body.senses.held == "milk"
    assert t.go("desk", "study").status is SkillStatus.SUCCESS
    assert t.do("place milk desk").status is SkillStatus.SUCCESS
    assert t.place("milk") == "desk"


def test_tray_and_hand_change_over():
    t = attempt(placement={"milk": "kitchen_table"})
    t.go("kitchen_table", "kitchen")
    for step in ("pick milk kitchen_table", "stow milk slot_1"):
        t.do(step)
    assert (t.body.senses.held, t.body.senses.tray[0]) == (None, "milk")
    assert t.do("unstow milk slot_1").status is SkillStatus.SUCCESS
    assert t.body.senses.held == "milk"


def test_a_thing_on_the_floor_is_driven_up_to():
    t = attempt(placement={"ball": "study_floor"})
    t.go("study_floor", "study")
    t.do("inspect study_floor")
    assert t.do("pick ball study_floor").status is SkillStatus.SUCCESS
    assert t.place("ball") == "robot"


def test_what_somebody_has_taken_away_is_not_tried_again_but_looked_for():
    t = attempt(placement={"ball": "study_floor"})
    t.go("study_floor", "study")
    t.do("inspect study_floor")
    world = t.env.world
    row, bed = world.geometry.row["ball"], world.geometry.row["bed"]
    world.shift(row, bed, tuple(world.geometry.footprints[bed].reshape(2, 2).mean(axis=0).tolist()))
    tick = t.do("pick ball study_floor")
    assert tick.reason == "the ball is not there any more"
    assert sum(action["interact"] == Interaction.PICK for action in t.actions) == 1
    assert "study_floor" in t.body.senses.inspected
    assert "ball" not in t.body.senses.places


def test_slipped_grasps_are_tried_again_and_no_more_than_so_often():
    t = attempt(placement={"milk": "kitchen_table"})
    t.go("kitchen_table", "kitchen")
    t.env.world.grasp_slip = 1.0
    before = len(t.actions)
    tick = t.do("pick milk kitchen_table")
    assert tick.status is SkillStatus.FAILURE
    assert "slipped" in tick.reason
    assert len(t.actions) - before == 7
    t.env.world.grasp_slip = 0.5
    assert t.do("pick milk kitchen_table").status is SkillStatus.SUCCESS


def test_a_broken_device_is_a_reason_and_not_tried_again():
    t = attempt(broken=["tv"], states={"tv": "off"})
    t.go("tv", "living_room")
    before = len(t.actions)
    tick = t.do("switch-on tv")
    assert (tick.status, tick.reason) == (SkillStatus.FAILURE, "the tv is broken")
    assert len(t.actions) - before == 1


def test_what_is_switched_on_already_heats_nothing():
    t = attempt(states={"microwave": "closed"})
    t.env.world.set_state(t.env.world.geometry.row["microwave"], 0, 1)
    t.go("microwave", "kitchen")
    assert t.do("switch-on microwave").status is SkillStatus.SUCCESS
    assert t.do("heat soup microwave").status is SkillStatus.FAILURE


def test_a_closed_door_is_opened_passed_and_closed_behind():
    t = attempt(states={"bathroom_door": "closed"})
    t.do("move x bathroom_door hallway")
    for step in ("open-up bathroom_door", "pass bathroom_door hallway bathroom", "close-up bathroom_door"):
        assert t.do(step).status is SkillStatus.SUCCESS
    assert t.body.senses.room == "bathroom"
    assert t.env.world.closed_leaves == ("bathroom_door",)


def test_a_door_is_closed_from_its_threshold():
    t = attempt()
    t.env.world._robot.position = (5.8, 3.95)
    t.observation, *_ = t.env.step(t.body.rest())
    assert t.do("close-up bathroom_door").status is SkillStatus.SUCCESS


@pytest.mark.parametrize(
    ("step", "place", "pair", "value"),
    [
        ("close-up bedroom_door", "bedroom_door", "aperture", "closed"),
        ("open-up bathroom_door", "bathroom_door", "aperture", "open"),
        ("switch-off tv", "tv", "power", "off"),
    ],
)
def test_what_was_so_already_is_looked_at(step, place, pair, value):
    t = attempt(states={place: value})
    room = DOMAIN.room_of(place) or "hallway"
    t.go(place, room)
    t.run(face(t.body, place))
    heading = t.body.senses.pose.heading
    while abs(wrap(t.body.senses.pose.heading - heading)) < 2.8:
        t.run([t.body.drive(0.0, 1.0)])
    t.run([t.body.rest()] * 20)
    assert not t.body.senses.is_seen(place)

    assert t.do(step).status is SkillStatus.SUCCESS
    assert t.body.perceive(t.observation).states[(place, pair)] == value


@pytest.mark.parametrize("room", list(DOMAIN.house.rooms))
def test_a_floor_is_inspected_with_all_that_lies_there(room):
    t = attempt(placement={"ball": f"{room}_floor", "shoes": f"{room}_floor"})
    t.go(f"{room}_floor", room)
    assert t.do(f"inspect {room}_floor").status is SkillStatus.SUCCESS
    assert {"ball", "shoes"} <= t.body.senses.places.keys()


def test_a_spot_of_a_floor_that_cannot_be_got_to_is_left_out(monkeypatch):
    t = attempt()
    t.go("hallway_floor", "hallway")
    tried = []

    def refuse_the_first(body, cells, is_there, **others):
        tried.append(cells)
        if len(tried) == 1:
            raise SkillError("somebody stands in the way")
        yield from drive_to(body, cells, is_there, **others)

    monkeypatch.setattr("decomplex_bt.envs.looking.drive_to", refuse_the_first)
    assert t.do("inspect hallway_floor").status is SkillStatus.SUCCESS
    assert len(tried) > 1


def test_a_person_is_followed_to_a_room():
    t = attempt(people={"anna": "study"})
    t.go("study_floor", "study")
    t.do("inspect study_floor")
    t.do("move x anna study")
    assert t.do("say anna").status is SkillStatus.SUCCESS
    assert t.do("follow anna study kitchen", max_steps=1500).status is SkillStatus.SUCCESS
    assert t.body.senses.room == "kitchen"
    assert t.body.senses.room_of_person("anna") == "kitchen"


@pytest.mark.parametrize("room", ["bathroom", "study", "living_room"])
def test_a_leader_who_has_gone_through_another_door_is_found_again(room):
    t = attempt(people={"anna": "hallway", "tom": None, "guest": None, "relative": None})
    t.go("hallway_floor", "hallway")
    t.do("inspect hallway_floor")
    t.do("move x anna hallway")
    left, bottom, right, top = t.env.domain.house.rooms[room].rect
    put(t, "anna", ((left + right) / 2, (bottom + top) / 2))
    t.run(turn_round(t.body))
    assert t.body.senses.room_of_person("anna") == "hallway"
    t.run(_look_for(t.body, "anna", None))
    assert t.body.senses.is_seen("anna")
    assert t.body.senses.room_of_person("anna") == room


def put(t, person, spot):
    """Sets a person down somewhere else, as if they had walked there."""
    world = t.env.world
    row = world.geometry.row[person]
    world.start_walking(row).position = spot
    t.run([t.body.rest()])
    world.stop_walking(row)


def test_somebody_never_seen_is_nowhere_to_drive_to():
    t = attempt(people={"anna": "bathroom"}, states={"bathroom_door": "closed"})
    tick = t.do("move x anna bathroom")
    assert tick.status is SkillStatus.FAILURE
    assert tick.reason == "I do not know where anna is"


def test_a_robot_that_does_not_get_on_says_so(monkeypatch):
    t = attempt()
    t.go("kitchen_floor", "kitchen")
    world = t.env.world
    monkeypatch.setattr(world, "drive", lambda forward, turn: setattr(world, "steps", world.steps + 1))
    tick = t.do("move x fridge kitchen")
    assert "stuck" in tick.reason


def test_results_that_mean_failure_have_words():
    from decomplex_bt.envs.handling import WHY

    assert set(Result) - {Result.NONE, Result.OK} == set(WHY)
    assert not any(action["interact"] == Interaction.FINISH for action in attempt().actions)


@pytest.mark.parametrize("goal", ["", " [to the study](2:goal)"])
def test_who_is_asked_to_lead_on_is_the_one_who_was_followed(goal):
    """Somebody else may stand nearer by the time that who has led the way comes to a stand."""
    first = "[Follow](1:following) [Tom](1:object) [to the bedroom](1:goal)"
    told = read_markup(f"{first}, [follow](2:following) [Tom](2:object){goal}.", DOMAIN.ontology, flow=[1, 2])
    env = HouseholdEnv(told)
    for seed in (0, 6, 9, 10):
        people = {"tom": "kitchen", "user": "bedroom", "anna": "bedroom"}
        observation, info = env.reset(seed=seed, options={"noise": False, "people": people})
        oracle = env.policy("oracle", flow=told)
        oracle.reset(observation, info)
        while not (info["is_success"] or oracle.done):
            observation, *_, info = env.step(oracle.act(observation))
        assert info["is_success"], seed
        assert info["seconds"] < 100, seed


@pytest.mark.parametrize(("length", "status", "most"), [(16, SkillStatus.SUCCESS, 400), (30, SkillStatus.FAILURE, 600)])
def test_a_long_hall_is_driven_along_once(tmp_path, length, status, most):
    data = yaml.safe_load((DOMAIN.folder / "house.yaml").read_text())
    data["rooms"]["hallway"]["rect"][2] = length
    data["robot_start"] = {"hallway": 1}
    path = tmp_path / "house.yaml"
    path.write_text(yaml.safe_dump(data, sort_keys=False))
    tick = attempt(house=path).do("inspect hallway_floor", max_steps=most)
    assert tick.status is status
    assert status is SkillStatus.SUCCESS or any(final in tick.reason for final in FINAL_REASONS)
