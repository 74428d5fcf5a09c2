"""The household robot's body: it keeps the contract of all bodies, and its percepts say what the observation says."""

from __future__ import annotations

import numpy as np
import pytest

from decomplex_bt.behaviour.contract import EmbodimentContract
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.embodiment import HouseholdEmbodiment
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.interface import COLUMNS, Interaction
from decomplex_bt.envs.senses import RECALL
from decomplex_bt.planning.pddl import GroundAction

DOMAIN = load_domain("household")
# Something that none of the steps below does, and that is not done at the start: no episode ends early.
TELL = read_markup("[Tell](1:informing) [Tom](1:recipient) [hello](1:message).", DOMAIN.ontology, flow=[1])
STEPS = """
move hallway_floor fridge kitchen; pass kitchen_doorway hallway kitchen; follow user living_room kitchen
tag-along user; open-up fridge; close-up bedroom_door; switch-on tv; switch-off tv; pick milk fridge
place milk fridge; stow milk slot_1; unstow milk slot_1; give milk user; receive milk user; heat milk microwave
wash cup_1 dishwasher; chill milk fridge; rinse cup_1 sink; fill cup_1 sink; drain cup_1 sink
drain-place trash_can; wipe desk rag; inspect hallway_floor
sense temperature__milk milk fridge; sense-held temperature__milk milk; sense-given temperature__milk milk user
sense-place power__tv tv; say user
"""


class TestHouseholdEmbodiment(EmbodimentContract):
    def make(self):
        env = HouseholdEnv(TELL)
        return env, env.embodiment()

    def steps(self, body):
        words = [step.split() for step in STEPS.strip().replace("\n", ";").split(";")]
        return [GroundAction(name, tuple(objects)) for name, *objects in words]

    def pose(self, observation):
        return observation["robot"][:3]


class Table:
    """Observations made by hand: everything unseen but what is said."""

    def __init__(self):
        self.names = DOMAIN.house.entities()
        self.entities = np.zeros((len(self.names), len(COLUMNS)), dtype=np.float32)
        self.entities[:, COLUMNS.index("place") :] = -1
        self.entities[:, COLUMNS.index("inspected")] = 0
        self.body = HouseholdEmbodiment(DOMAIN)
        self.set("user", x=8.0, y=8.0)

    def set(self, name, *, place=None, **columns):
        row = self.entities[self.names.index(name)]
        if place is not None:
            columns["place"] = self.names.index(place)
        for column, value in columns.items():
            row[COLUMNS.index(column)] = value

    def percept(self, *, at=(2.2, 4.6), held=(), result=0, seconds=0.0):
        rows = [self.names.index(name) if name else -1 for name in held]
        observation = {
            "robot": np.array([*at, 0.0, 0.0, 0.0], dtype=np.float32),
            "held": np.array((rows + [-1] * 5)[:5], dtype=np.int16),
            "entities": self.entities.copy(),
            "result": result,
            "seconds": np.array([seconds], dtype=np.float32),
        }
        return self.body.perceive(observation)


@pytest.fixture
def table():
    return Table()


def test_what_is_seen_gets_its_names(table):
    table.set("milk", visible=1, x=2.5, y=8.6, place="counter", temperature=0)
    table.set("fridge", visible=1, aperture=1)
    table.set("counter", visible=1, inspected=1)
    percept = table.percept(held=("pen_1", "", "cup_2"), result=3, seconds=1.5)
    assert percept.room == "hallway"
    assert percept.places["milk"] == "counter"
    assert percept.states == {("milk", "temperature"): "cold", ("fridge", "aperture"): "open"}
    assert percept.inspected == {"counter"}
    assert (percept.held, percept.tray) == ("pen_1", (None, "cup_2", None, None))
    assert (percept.result, percept.seconds) == ("not possible", 1.5)


def test_near_is_what_is_within_a_metre_in_the_same_room(table):
    assert table.percept(at=(1.8, 4.7)).near == {"kitchen_doorway", "hallway_floor"}
    # the bedroom's wardrobe is as near, behind the wall
    assert "wardrobe" not in table.percept(at=(1.0, 4.3)).near


def test_the_user_is_known_and_others_only_when_seen(table):
    table.set("anna", visible=1, x=1.0, y=1.0)
    assert table.percept().places == {"user": "living_room", "anna": "bedroom"}


def test_a_person_out_of_view_is_still_there_while_the_floor_counts_as_inspected(table):
    table.set("anna", visible=1, x=6.0, y=8.0)
    table.set("living_room_floor", inspected=1)
    table.percept(at=(6.0, 7.0))
    table.set("anna", visible=0, x=0, y=0)
    assert table.percept(at=(6.0, 7.0), seconds=0.1).places["anna"] == "living_room"
    table.set("fridge", visible=1)
    assert "anna" not in table.percept(at=(6.0, 7.0), seconds=RECALL + 1).places


def test_nothing_new_is_the_same_object(table):
    table.set("milk", visible=1, x=2.5, y=8.6, place="counter")
    first = table.percept(seconds=0.0)
    second = table.percept(seconds=0.1)
    assert second.places is first.places
    assert second.states is first.states
    table.set("milk", place="fridge")
    assert table.percept(seconds=0.2).places["milk"] == "fridge"


def test_finish_is_an_interaction_of_its_own(table):
    assert table.body.finish()["interact"] == Interaction.FINISH
    assert not table.body.rest()["drive"].any()
