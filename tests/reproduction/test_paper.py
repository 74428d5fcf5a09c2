"""The paper's figures are complete and hang together."""

from __future__ import annotations

import pytest

from decomplex_bt.flow import DEPENDENCIES
from decomplex_bt.reproduction.paper import read_paper
from decomplex_bt.reproduction.systems import LABELLERS, METHODS


def test_every_verdict_and_claim_has_its_figures() -> None:
    paper = read_paper()
    for line in paper.verdicts:
        assert paper.value(line.key)
    for claim in paper.claims:
        difference = paper.value(claim.more)[0] - paper.value(claim.less)[0]
        assert difference == pytest.approx(claim.paper, abs=0.011)


def test_every_system_has_a_row() -> None:
    tables = {table.name: table for table in read_paper().tables}
    assert set(tables["arguments"].values) == set(METHODS)
    assert set(tables["dependencies"].values) == {f"{d}/{s}" for d in (*DEPENDENCIES, "weighted") for s in LABELLERS}
    assert set(tables["exact"].values) == set(tables["oer"].values)
    assert set(tables["transitions"].values) == set(tables["transitions"].columns) == set(DEPENDENCIES)


def test_f1_is_what_precision_and_recall_make_it() -> None:
    table = next(table for table in read_paper().tables if table.name == "dependencies")
    for row, (precision, recall, f1) in table.values.items():
        if not row.startswith("weighted"):
            assert f1 == pytest.approx(2 * precision * recall / (precision + recall), abs=0.015), row
