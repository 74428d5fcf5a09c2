"""A planner that gives up shows nothing; one that finds that there is no plan does."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.pursuit import Pursuit, PursuitStatus, pursue

DOMAIN = load_domain()
DONE, FAILED = PursuitStatus.DONE, PursuitStatus.FAILED
HALL = Percept(room="hallway")
DO = "[Turn](1:change_state) [on](1:state) [the tv](1:object)"
BRING = "[Bring](1:bringing) [me](1:recipient) [the apple](1:object)"
FIND = "[Find](1:searching) [the apple](1:object)"
LOOK = "[Look](1:searching) [on the desk and the couch](1:location) for [the milk](1:object)"
ALL_ON = "[Are](1:check_state) [all the lamps](1:object) [on](1:state)"


def give_up(text: str, *, is_final: bool, percept: Percept = HALL, reason: str = "timeout: slow") -> Pursuit:
    """How a task ends whose goals are all given up, one after the other."""
    (task,) = ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks
    belief = Belief(DOMAIN)
    for _ in range(4):
        belief.update(percept)
    while (pursuit := pursue(task, belief, {}, since=0)).status is PursuitStatus.ONGOING:
        belief.give_up(pursuit.goal_atoms, reason, is_final=is_final)
    return pursuit


@pytest.mark.parametrize("text", [DO, BRING, FIND])
def test_what_no_plan_was_found_for_is_neither_true_nor_false(text):
    assert (give_up(text, is_final=True).status, give_up(text, is_final=True).truth) == (FAILED, False)
    pursuit = give_up(text, is_final=False)
    assert (pursuit.status, pursuit.truth, pursuit.gave_up) == (FAILED, None, True)


def test_what_was_not_looked_for_is_not_said_to_be_nowhere():
    assert "nowhere to be found" in give_up(FIND, is_final=True).reason
    reason = give_up(FIND, is_final=False).reason
    assert reason.startswith("the planner gave up on (inspected ")
    assert reason.endswith(" more: timeout: slow")
    assert give_up(DO, is_final=False).reason == "the planner gave up on (powered-on tv): timeout: slow"


def test_that_nothing_is_there_is_no_answer_where_nobody_could_look():
    text = "[Is](1:check_state) [the apple](1:object) [there](1:state=here)"
    assert (give_up(text, is_final=True).status, give_up(text, is_final=True).truth) == (DONE, False)
    assert (give_up(text, is_final=False).status, give_up(text, is_final=False).truth) == (FAILED, None)


def test_a_search_of_some_of_the_places_is_no_answer_where_a_planner_gave_up_on_the_others():
    on_desk = Percept(room="study", inspected=frozenset({"desk"}))
    assert (give_up(LOOK, is_final=True, percept=on_desk).truth) is False
    assert (give_up(LOOK, is_final=False, percept=on_desk).truth) is None


@pytest.mark.parametrize(("value", "truth"), [("on", None), ("off", False)])
def test_of_all_that_are_asked_about_one_that_is_not_so_is_an_answer(value, truth):
    lamp = next(name for name in DOMAIN.house.places() if DOMAIN.house.furniture[name].kind == "lamp")
    seen = Percept(room="hallway", states={(lamp, "power"): value})
    assert give_up(ALL_ON, is_final=False, percept=seen).truth is truth


def test_of_a_goal_that_has_a_part_for_which_there_is_no_plan_there_is_none():
    apple, milk = Atom("has", ("user", "apple")), Atom("has", ("user", "milk"))
    belief = Belief(DOMAIN)
    belief.update(HALL)
    belief.give_up((apple, milk), "timeout", is_final=False)
    assert belief.unanswered((apple, milk), since=0) == "timeout"
    assert belief.unanswered((apple, milk), since=belief.tick + 1) is None
    belief.give_up((milk,), "unsolvable")
    assert belief.unanswered((apple, milk), since=0) is None
    assert belief.unanswered((milk,), since=0) is None
