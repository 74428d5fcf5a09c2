"""A domain of one's own: fluents that actions bring about beside the household's, and goals that nothing fits."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.envs.skills import check_skills
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.planning.assumed_world import AssumedWorld
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.pursuit import PursuitStatus
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

DOMAIN = load_domain()
TYPE = """  rinsing:
    description: rinses
    arguments: [object]
    required: [[object]]
    questions: {object: "What should I rinse?"}
    says: "rinse {object}"
"""


def own(household_folder: Path, folder: Path, atoms: str) -> Domain:
    """The household with a task type `rinsing`, whose goal is about a fluent that the action `rinse` makes true."""
    for path in household_folder.glob("*.*"):
        shutil.copy(path, folder)
    for name, old, new in (
        ("ontology.yaml", "  informing:", f"{TYPE}  informing:"),
        ("goals.yaml", "  informing:", f"  rinsing:\n    - {{of: {{object: thing}}, atoms: [{atoms}]}}\n  informing:"),
        ("domain.pddl", "(told ?q - person)", "(told ?q - person) (rinsed ?t - thing)"),
        ("domain.pddl", r"(:action rinse.*?\(clean \?t\))", r"\1 (rinsed ?t)"),
    ):
        text = (folder / name).read_text(encoding="utf-8")
        text = (
            re.sub(old, new, text, flags=re.DOTALL) if name == "domain.pddl" and ":" in old else text.replace(old, new)
        )
        (folder / name).write_text(text, encoding="utf-8")
    return load_domain(folder)


def run(text: str, domain: Domain) -> tuple[PursuitStatus, list[str]]:
    task = ground(read_markup(text, domain.ontology, flow=[1]), domain).tasks[0]
    world = AssumedWorld.likely(domain)
    pursuit = world.run(task, Belief(domain), PyperplanPlanner(), {})
    return pursuit.status, [step.name for step in world.steps]


@pytest.mark.parametrize("atoms", ['"(rinsed {object})"', '"(rinsed {object})", "(carried {object})"'])
def test_what_an_action_makes_true_at_a_place_brings_the_place_into_the_plan(household_folder, tmp_path, atoms):
    status, steps = run("[Rinse](1:rinsing) [the mug](1:object).", own(household_folder, tmp_path, atoms))
    assert status is PursuitStatus.DONE
    assert steps[-1] == "rinse"


def test_a_task_that_no_goal_fits_names_the_goals(household_folder, tmp_path):
    domain = own(household_folder, tmp_path, '"(rinsed {object})"')
    with pytest.raises(
        InputError, match=r"no goal of rinsing with object: anna; goals\.yaml .* object: thing: add one"
    ):
        run("[Rinse](1:rinsing) [Anna](1:object).", domain)


def test_a_task_type_without_goals_says_so():
    with pytest.raises(InputError, match=r"no goal of polishing with object: desk; goals\.yaml has none"):
        DOMAIN.goals.fill("polishing", {"object": "desk"}, DOMAIN.has_type)


def test_a_domain_that_was_not_read_from_a_folder_is_checked_for_the_skills():
    text = DOMAIN.domain_pddl.replace("(?t - thing ?q - person)", "(?t - thing ?q - position)", 1)
    assert text != DOMAIN.domain_pddl
    with pytest.raises(DataFileError, match=r"domain\.pddl: action give: its parameters are \(thing, position\)"):
        check_skills(replace(DOMAIN, domain_pddl=text))
