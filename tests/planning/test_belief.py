"""Belief: what looks teach, and what two looks in vain unteach."""

from __future__ import annotations

import numpy as np

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.belief import MAX_ATTEMPTS, Belief
from decomplex_bt.planning.pddl import Atom, GroundAction
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.prior import Prior

DOMAIN = load_domain()
EMPTY = Percept(room="study")


def look(belief: Belief, percept: Percept, times: int = 2) -> Belief:
    for _ in range(times):
        belief.update(percept)
    return belief


def test_an_unseen_thing_may_be_where_its_kind_tends_to_be() -> None:
    belief = look(Belief(DOMAIN), EMPTY)
    assert belief.place_of("pen_1") is None
    assert belief.likely_places("pen_1")[0][0] == "desk"


def test_a_place_looked_at_in_vain_is_no_longer_likely() -> None:
    belief = look(Belief(DOMAIN), Percept(room="study", inspected=frozenset({"desk"})))
    assert "desk" not in dict(belief.likely_places("pen_1"))


def test_what_an_instruction_names_is_looked_at_last() -> None:
    prior = Prior.of(DOMAIN).told({"remote": ("fridge", "bathroom"), "anna": ("washing_machine",)}, DOMAIN)
    belief = look(Belief(DOMAIN, prior=prior), EMPTY)
    places = [place for place, _ in belief.likely_places("remote")]
    assert places[0] == Belief(DOMAIN).likely_places("remote")[0][0]
    assert {"fridge", "bathroom_floor", "washing_machine"} <= set(places)
    assert "fridge" not in dict(Belief(DOMAIN).likely_places("remote"))
    assert places.index("fridge") > places.index("coffee_table")
    assert "bathroom_floor" in dict(belief.likely_places("anna"))


def test_one_look_may_miss_a_thing() -> None:
    seen = Percept(room="study", places={"pen_1": "desk"}, inspected=frozenset({"desk"}))
    missed = Percept(room="study", inspected=frozenset({"desk"}))
    belief = look(Belief(DOMAIN), seen)
    belief.update(missed)
    assert belief.place_of("pen_1") == "desk"
    belief.update(missed)
    assert belief.place_of("pen_1") is None


def test_a_thing_out_of_sight_stays_where_it_was() -> None:
    belief = look(Belief(DOMAIN), Percept(room="study", places={"pen_1": "desk"}))
    look(belief, Percept(room="kitchen"))
    assert (belief.place_of("pen_1"), belief.room_of("pen_1")) == ("desk", "study")


def test_what_is_carried_is_with_the_robot_and_goes_where_it_is_put() -> None:
    belief = look(Belief(DOMAIN), Percept(room="study", held="pen_1", tray=("keys", None, None, None)))
    assert belief.room_of("keys") == "study"
    assert belief.carried("pen_1") == belief.tick
    belief.update(Percept(room="study", places={"pen_1": "desk_drawer"}))
    belief.succeeded(GroundAction("place", ("pen_1", "desk_drawer")))
    assert belief.place_of("pen_1") == "desk_drawer"


def test_what_gets_hot_behind_a_closed_door_is_believed_hot_but_was_not_seen() -> None:
    belief = look(Belief(DOMAIN), EMPTY)
    belief.succeeded(GroundAction("heat", ("soup", "microwave")))
    assert belief.state("soup", "temperature") == "hot"
    assert belief.state_seen("soup", "temperature") == -1


def test_the_revision_tells_news_from_the_same_again() -> None:
    percept = Percept(room="study", places={"pen_1": "desk"}, states={("desk", "cleanliness"): "dirty"})
    belief = look(Belief(DOMAIN), percept, times=3)
    before = belief.revision
    look(belief, percept)
    assert belief.revision == before
    belief.update(Percept(room="study", places={"pen_1": "desk"}, states={("desk", "cleanliness"): "clean"}))
    assert belief.revision == before + 1
    assert belief.state_changed("desk", "cleanliness") == belief.tick


def test_steps_that_fail_too_often_or_for_good_are_blocked() -> None:
    belief = look(Belief(DOMAIN), EMPTY)
    pick, switch = GroundAction("pick", ("pen_1", "desk")), GroundAction("switch-on", ("tv",))
    for _ in range(MAX_ATTEMPTS - 1):
        belief.failed(pick, "slipped")
    belief.failed(switch, "broken")
    assert list(belief.blocked()) == [switch]
    belief.failed(pick, "slipped")
    assert set(belief.blocked()) == {pick, switch}


def test_a_person_who_is_not_where_they_were_may_be_in_any_room_not_looked_into_since() -> None:
    belief = look(Belief(DOMAIN), Percept(room="study", places={"anna": "hallway", "pen_1": "desk"}))
    belief.failed(GroundAction("move", ("hallway_floor", "anna", "hallway")), "anna is not there any more")
    belief.failed(GroundAction("pick", ("pen_1", "desk")), "the pen 1 is not there any more")
    assert belief.place_of("anna") is None
    assert belief.place_of("pen_1") == "desk"
    assert {place for place, _ in belief.likely_places("anna")} == {f"{room}_floor" for room in DOMAIN.house.rooms}
    look(belief, Percept(room="bathroom", inspected=frozenset({"bathroom_floor"})), times=2)
    assert "bathroom_floor" not in dict(belief.likely_places("anna"))


def test_a_person_never_seen_is_where_the_house_says() -> None:
    belief = look(Belief(DOMAIN), EMPTY)
    assert {place for place, _ in belief.likely_places("guest")} == {
        "living_room_floor",
        "kitchen_floor",
        "hallway_floor",
    }


def test_giving_up_counts_for_the_task_that_did() -> None:
    belief = look(Belief(DOMAIN), EMPTY)
    goal = (Atom("inspected", ("desk",)),)
    belief.give_up(goal, "no way")
    assert belief.given_up(goal, since=0) == "no way"
    assert belief.given_up(goal, since=belief.tick + 1) is None


def test_it_prints_as_a_table() -> None:
    text = str(look(Belief(DOMAIN), Percept(room="study", held="pen_1", places={"user": "kitchen"})))
    assert "holding pen_1" in text
    assert "pencil" in text
    assert "? desk 0.40" in text


def test_somebody_whose_place_is_known_was_not_therefore_seen() -> None:
    belief = look(Belief(DOMAIN), Percept(room="study", places={"user": "kitchen"}, unseen=frozenset({"user"})))
    assert belief.place_of("user") == "kitchen"
    assert belief.seen("user") < 0
    belief.update(Percept(room="kitchen", places={"user": "kitchen"}))
    assert belief.seen("user") == belief.tick


def test_what_is_put_off_while_nothing_is_new_makes_no_difference() -> None:
    rng = np.random.default_rng(0)
    rooms, things, places = ("study", "kitchen"), ("pen_1", "keys", "cup_1"), ("desk", "study_floor", "robot")
    percept, quick, thorough = EMPTY, Belief(DOMAIN), Belief(DOMAIN)
    for _ in range(3000):
        change = int(rng.integers(12))
        if change == 0:
            seen = {thing: places[rng.integers(2)] for thing in things if rng.random() < 0.5}
            percept = percept._replace(places=seen, unseen=frozenset(name for name in seen if rng.random() < 0.3))
        elif change == 1:
            percept = percept._replace(inspected=frozenset(p for p in places[:2] if rng.random() < 0.5))
        elif change == 2:
            percept = percept._replace(states={("desk", "cleanliness"): ("clean", "dirty")[rng.integers(2)]})
        elif change == 3:
            percept = percept._replace(near=frozenset(p for p in places[:2] if rng.random() < 0.5))
        elif change == 4:
            percept = percept._replace(room=rooms[rng.integers(2)])
        elif change == 5:
            percept = percept._replace(held=(None, "keys")[rng.integers(2)])
        quick.update(percept)
        thorough.update(percept._replace(places=dict(percept.places), states=dict(percept.states)))
        if rng.random() < 0.1:
            for belief in (quick, thorough):
                belief.succeeded(GroundAction("place", ("pen_1", "desk")))
        assert quick.revision == thorough.revision
        if rng.random() < 0.2:
            assert times(quick) == times(thorough)


def times(belief: Belief) -> tuple[object, ...]:
    names = ("pen_1", "keys", "cup_1", "desk", "study_floor", "study", "kitchen")
    asked = (belief.seen, belief.visited, belief.inspected, belief.carried, belief.place_of)
    return str(belief), belief.state_seen("desk", "cleanliness"), [[ask(name) for ask in asked] for name in names]
