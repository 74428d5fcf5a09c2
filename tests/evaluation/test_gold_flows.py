"""A sample of `decomplex-bt evaluate domains/household/corpus --grounded --reading gold`, small enough for every push.

The whole of it, and what came of it, is in docs/environment.md.
"""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.evaluation.monte_carlo import Setup, evaluate_agents, those_that_ground
from decomplex_bt.evaluation.report import failure_lines
from decomplex_bt.evaluation.summary import summarise

DOMAIN = load_domain("household")
EVERY = 8
"""Of the instructions that ground, one in so many is in the sample."""
DISTURBED = Setup(grasp_slip=0.1, missed_detection=0.1, meddling=2.0)


@pytest.fixture(scope="module")
def sample():
    grounded = those_that_ground(read_corpus(DOMAIN.folder / "corpus", DOMAIN.ontology), DOMAIN)
    assert len(grounded) >= 150
    return grounded[::EVERY]


def test_oracle_and_tree_carry_out_every_feasible_gold_flow(sample):
    rows = evaluate_agents(sample, ("oracle", "tree"), episodes=2, reading="gold", setup=Setup(noise=False))
    assert list(failure_lines(rows)) == []
    for summary in summarise(rows):
        assert summary.success.total > len(sample)


def test_the_tree_copes_with_slips_misses_and_somebody_else(sample):
    rows = evaluate_agents(sample, ("tree",), episodes=2, seed=50, reading="gold", setup=DISTURBED)
    (summary,) = summarise(rows)
    assert any(row.moved_by_others for row in rows)
    assert summary.success.value >= 0.93, list(failure_lines(rows))


@pytest.mark.parametrize("name", ["otis-037", "piet-034", "wilma-029"])
def test_a_place_that_somebody_stands_before_is_reached_from_beside_them(name):
    examples = read_corpus(DOMAIN.folder / "corpus" / f"{name.partition('-')[0]}.yaml", DOMAIN.ontology)
    (asked,) = (example for example in examples if example.id == name)
    rows = evaluate_agents([asked], ("oracle", "tree"), seed=511, episodes=1, reading="gold")
    assert [row.outcome for row in rows] == ["success", "success"]
