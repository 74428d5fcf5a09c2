"""The sentences that stand for their class: where they can be carried out they are, and every branch comes up."""

from __future__ import annotations

from pathlib import Path

import pytest

from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.evaluation.monte_carlo import evaluate
from decomplex_bt.evaluation.summary import summarise

CORPUS = Path(__file__).parents[2] / "benchmarks" / "class_sentences.yaml"
EXAMPLES = read_corpus(CORPUS, load_domain("household").ontology)


@pytest.mark.parametrize("agent", ["tree", "oracle"])
def test_a_few_worlds(agent):
    rows = evaluate(EXAMPLES, episodes=2, agent=agent, reading="gold")
    assert [(row.example, row.seed, row.cause) for row in rows if row.outcome == "failure"] == []


@pytest.mark.slow
def test_twenty_worlds_each():
    rows = evaluate(EXAMPLES, episodes=20, reading="gold", jobs=-1)
    assert [(row.example, row.seed, row.cause) for row in rows if row.outcome != "success" and row.is_feasible] == []
    (summary,) = summarise(rows)
    assert summary.warnings == ()
    for instruction in summary.instructions:
        for branch in instruction.branches:
            assert min(branch.true, branch.false) > 0, instruction.example
            assert branch.undecided == 0, instruction.example
