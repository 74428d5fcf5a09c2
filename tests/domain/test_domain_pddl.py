"""domain.pddl: opposites stay opposite under every action, and goals, effects and actions agree."""

from __future__ import annotations

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.domain.pddl import pddl_predicates, pddl_sections
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.schemas import read_schemas, values_after

DOMAIN = load_domain()
ACTIONS = {str(action[0]): action for action in pddl_sections(DOMAIN.domain_pddl)[":action"]}
STATE_PAIRS = [tuple(map(DOMAIN.goals.fluent, pair.values)) for pair in DOMAIN.kinds.state_pairs.values()]


def part(action: tuple, key: str) -> list[tuple[str, ...]]:
    """The literals of an action's precondition or effect, without the leading `and`."""
    return list(action[action.index(key) + 1][1:])


def effects(action: tuple) -> tuple[set[tuple[str, ...]], set[tuple[str, ...]]]:
    literals = part(action, ":effect")
    return {lit for lit in literals if lit[0] != "not"}, {lit[1] for lit in literals if lit[0] == "not"}


@pytest.mark.parametrize("name", sorted(ACTIONS))
def test_effects_keep_both_members_of_a_pair_complementary(name: str) -> None:
    adds, deletes = effects(ACTIONS[name])
    for first, second in STATE_PAIRS:
        for one, other in ((first, second), (second, first)):
            assert {atom[1:] for atom in adds if atom[0] == one} == {atom[1:] for atom in deletes if atom[0] == other}


@pytest.mark.parametrize("name", sorted(ACTIONS))
def test_the_hand_is_free_or_holds_one_thing(name: str) -> None:
    adds, deletes = effects(ACTIONS[name])
    assert any(a[0] == "holding" for a in adds) == any(d[0] == "hand-free" for d in deletes)
    assert any(d[0] == "holding" for d in deletes) == any(a[0] == "hand-free" for a in adds)


@pytest.mark.parametrize("name", sorted(ACTIONS))
def test_a_thing_is_in_one_place(name: str) -> None:
    """What is taken away from where a thing is comes back as another: lying, held, on the tray, with a person."""
    adds, deletes = effects(ACTIONS[name])
    where = ("lies", "holding", "on-tray", "has")
    assert sum(a[0] in where for a in adds) == sum(d[0] in where for d in deletes)


@pytest.mark.parametrize("name", sorted(ACTIONS))
def test_preconditions_are_positive_and_predicates_declared(name: str) -> None:
    signatures = pddl_predicates(DOMAIN.domain_pddl)
    for literal in part(ACTIONS[name], ":precondition"):
        assert literal[0] != "not"
        assert len(signatures[literal[0]]) == len(literal) - 1
    adds, deletes = effects(ACTIONS[name])
    assert all(len(signatures[atom[0]]) == len(atom) - 1 for atom in adds | deletes)


def test_schemas_and_values_after_say_what_the_effects_say() -> None:
    assert sorted(read_schemas(DOMAIN.domain_pddl)) == sorted(ACTIONS)
    heated = values_after(GroundAction("heat", ("soup", "microwave")), DOMAIN)
    assert heated == {("soup", "temperature"): "hot", ("microwave", "power"): "on"}
    assert values_after(GroundAction("move", ("desk", "box", "study")), DOMAIN) == {}


def test_every_goal_can_be_reached_by_some_action() -> None:
    added = {atom[0] for action in ACTIONS.values() for atom in effects(action)[0]}
    for task_type, templates in DOMAIN.goals.goals.items():
        for template in templates:
            for predicate, *_ in template.parts():
                assert predicate == "{state}" or predicate in added, (task_type, predicate)
    assert {DOMAIN.goals.fluent(v) for p in DOMAIN.kinds.state_pairs.values() for v in p.values} - added == {"dirty"}
