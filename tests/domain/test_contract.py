"""The contract of domain.pddl with the code: its tables say what the code relies on, and what breaks it is refused."""

from __future__ import annotations

import ast
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from decomplex_bt.domain.contract import ACTIONS, FLUENTS, OBJECT_TYPES, POSITION
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.domain.pddl import pddl_parameters, pddl_predicates, pddl_types
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.skills import SKILLS
from decomplex_bt.errors import DataFileError

DOMAIN = load_domain()
FILES = ("ontology.yaml", "kinds.yaml", "house.yaml", "words.yaml", "goals.yaml", "domain.pddl")
ROOT = Path(__file__).parents[2]


@pytest.fixture
def folder(household_folder: Path, tmp_path: Path) -> Path:
    for name in FILES:
        shutil.copy(household_folder / name, tmp_path / name)
    return tmp_path


def edit(folder: Path, file: str, old: str, new: str) -> None:
    """Replaces what a pattern matches, everywhere; a dot matches an end of line, too."""
    text, count = re.subn(old, new, (folder / file).read_text(encoding="utf-8"), flags=re.DOTALL)
    assert count
    (folder / file).write_text(text, encoding="utf-8")


# -- what is refused --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("domain.pddl", r"\(:action pick.*?\n\n", "", r"domain\.pddl: there is no action pick, .*; keep the name"),
        ("domain.pddl", r"\(:action move.*?\n\n", "", r"domain\.pddl: there is no action move"),
        ("domain.pddl", r":action say\b", ":action tell", r"no action say, .*\(told \.\.\.\), a goal of goals\.yaml"),
        (
            "domain.pddl",
            r":action sense-given",
            ":action see-given",
            r"no action sense-given.*nearest known: see-given",
        ),
        ("domain.pddl", r":action chill", ":action cool", r"no action chill, .*kinds\.fridge\.cools"),
        ("domain.pddl", r":action switch-off", ":action unplug", r"no action switch-off, .*kinds\.dishwasher"),
        ("domain.pddl", r":action drain-place", ":action tip", r"no action drain-place, .*kinds\.trash can"),
        ("domain.pddl", "hand-free", "gripper-free", r"domain\.pddl: :predicates: there is no \(hand-free\)"),
        ("domain.pddl", "within", "inside-of", r"there is no \(within \?position \?room\), which planning goes by"),
        (
            "domain.pddl",
            r"\(slot-free \?s - slot\)",
            "(slot-free ?s ?t)",
            r"action stow: \(slot-free \?s\) has 1 objects",
        ),
        ("domain.pddl", r"place person", "spot person", r"unknown type 'place'"),
        ("domain.pddl", r"\bslot\b( fact| *\)|\))", r"bay\1", r":types: there is no 'slot'; .*keep these names"),
        ("domain.pddl", r"doorway - position\)", "doorway - position device - place)", None),
        ("domain.pddl", r"thing slot", "thing - position slot", r"'room' is one of 'position'; expected"),
        ("domain.pddl", r"(give.*?\?q - person)", r"\1 ?r - room", r"action give: .*\(thing, person, room\); expected"),
        (
            "domain.pddl",
            r"pick(\s+:parameters \()\?t - thing \?p - place",
            r"pick\1?p - place ?t - thing",
            r"pick: its",
        ),
        ("domain.pddl", r"open-up(\s+:parameters \()\?p - position", r"open-up\1?p - place", None),
        (
            "domain.pddl",
            r"switch-on(\s+:parameters \()\?p - position",
            r"switch-on\1?p ?q - position",
            r"switch-on: its",
        ),
        ("domain.pddl", r"(tag-along.*?:precondition )\(and \(at \?q\)\)", r"\1()", r"tag-along: .*write \(and\)"),
        ("domain.pddl", r"(tag-along.*?:precondition )\(and \(at \?q\)\)", r"\1(and)", None),
        ("domain.pddl", r"\(not \(cold \?t\)\) \(hot \?t\)", "(not (cold ?t))", r"action heat: its effect lacks \(hot"),
        ("goals.yaml", r'"on": powered-on', '"on": powered-off', r"goals\.yaml: fluents: 'on' and 'off' are both"),
        (
            "goals.yaml",
            r'"on": powered-on, "off": powered-off',
            '"on": powered-off, "off": powered-on',
            r"action switch-on: its effect lacks \(powered-off \.\.\.\).*'on'.*goals\.yaml",
        ),
        ("goals.yaml", r"taking:\n[^\n]*", "taking: []", r"goals\.yaml: goals\.taking: List should have at least 1"),
    ],
)
def test_what_breaks_the_contract_is_refused(folder: Path, file: str, old: str, new: str, message: str | None) -> None:
    edit(folder, file, old, new)
    if message is None:
        load_domain(folder)
        return
    with pytest.raises(DataFileError, match=message):
        load_domain(folder)


def test_a_type_that_no_object_is_of_is_refused(folder: Path) -> None:
    edit(folder, "domain.pddl", r"doorway - position\)", "doorway - position device - place)")
    edit(folder, "domain.pddl", r"(:action heat\s+:parameters \(\?t - thing \?p -) place", r"\1 device")
    with pytest.raises(
        DataFileError, match=r"action heat: \?p is of the type 'device', which no object ever is.*place"
    ):
        load_domain(folder)


def test_a_goal_for_a_type_that_no_object_is_of_is_refused(folder: Path) -> None:
    edit(folder, "domain.pddl", r"doorway - position\)", "doorway - position device - place)")
    edit(folder, "goals.yaml", "location: place", "location: device")
    with pytest.raises(DataFileError, match=r"goals\.searching: location is of the type 'device', which no object"):
        load_domain(folder)


def test_a_fluent_that_planning_writes_is_not_called_otherwise(folder: Path) -> None:
    edit(folder, "domain.pddl", r"\(open \?p - position\)", "(open ?p - position) (ajar ?p - position)")
    edit(folder, "goals.yaml", r"fluents: \{", "fluents: {open: ajar, ")
    with pytest.raises(DataFileError, match=r"fluents\.open: planning goes by \(open \?object\)"):
        load_domain(folder)


def test_types_between_and_above_those_of_objects_are_known(folder: Path) -> None:
    edit(folder, "domain.pddl", "place person doorway - position", "place site - position doorway person - site")
    domain = load_domain(folder)
    assert domain.has_type("user", "site")
    assert domain.has_type("user", POSITION)
    assert not domain.has_type("desk", "site")


def test_what_no_goal_and_no_kind_asks_for_may_be_left_out(folder: Path) -> None:
    for action in ("stow", "unstow"):
        edit(folder, "domain.pddl", rf"\(:action {action}\b.*?\n\n", "")
    assert "stow" not in pddl_parameters(load_domain(folder).domain_pddl)


def test_a_fluent_of_an_ability_goes_with_the_kinds_that_have_it(folder: Path) -> None:
    edit(folder, "domain.pddl", r"\(wipes \?t - thing \?p - place\) ", "")
    edit(folder, "domain.pddl", r"\(:action wipe\b.*?\n\n", "")
    with pytest.raises(DataFileError, match=r"there is no \(wipes \?thing \?place\), which planning goes by"):
        load_domain(folder)
    edit(folder, "kinds.yaml", r"wipes: \[wipeable\], ", "")
    assert "wipe" not in pddl_parameters(load_domain(folder).domain_pddl)


# -- what the tables say ----------------------------------------------------------------------------------------------


def test_the_household_has_what_the_tables_say() -> None:
    parameters = {name: tuple(of for _, of in pairs) for name, pairs in pddl_parameters(DOMAIN.domain_pddl).items()}
    assert parameters == ACTIONS
    values = {DOMAIN.goals.fluent(value) for pair in DOMAIN.kinds.state_pairs.values() for value in pair.values}
    predicates = pddl_predicates(DOMAIN.domain_pddl)
    assert {name: predicates[name] for name in predicates if name in FLUENTS or name not in values} == FLUENTS
    assert set(pddl_types(DOMAIN.domain_pddl).supers) == {*OBJECT_TYPES, POSITION}


def test_there_is_a_skill_for_every_action() -> None:
    assert SKILLS.keys() == ACTIONS.keys()


def test_the_household_has_all_states_of_the_world() -> None:
    assert tuple(DOMAIN.kinds.state_pairs) == STATE_PAIRS


def literals(*calls: str) -> Iterator[str]:
    """The names that stand as the first argument of such calls in planning and in the simulation."""
    for node in nodes():
        if isinstance(node, ast.Call) and ast.unparse(node.func) in calls:
            yield from (part.value for part in node.args[:1] if isinstance(part, ast.Constant))


def compared(what: str) -> Iterator[str]:
    """The names that such an expression is compared with there."""
    for node in nodes():
        if isinstance(node, ast.Compare) and ast.unparse(node.left).endswith(what):
            yield from (part.value for part in ast.walk(node) if isinstance(part, ast.Constant))


def nodes() -> Iterator[ast.AST]:
    for path in (*ROOT.glob("decomplex_bt/planning/*.py"), *ROOT.glob("envs/*.py")):
        yield from ast.walk(ast.parse(path.read_text(encoding="utf-8")))


def test_planning_names_no_fluent_that_the_contract_leaves_out() -> None:
    named = {*literals("Atom", "self._was_noted"), *compared("predicate")}
    assert {"lies", "hand-free", "told", "known"} <= named
    assert named <= FLUENTS.keys()


def test_planning_names_no_action_that_the_contract_leaves_out() -> None:
    named = {*literals("GroundAction"), *compared("step.name")}
    assert {"give", "pass"} <= named
    assert named <= ACTIONS.keys()
