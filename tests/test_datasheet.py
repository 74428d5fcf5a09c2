"""The corpus' datasheet: every figure in its tables and of its agreement is what the command prints."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from decomplex_bt.cli import main

SHEET = Path(__file__).parent.parent / "docs" / "corpus.md"
pytestmark = pytest.mark.skipif(not SHEET.exists(), reason="the documentation is not installed")


def printed(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, list[str]]:
    """What a command prints: the cells of each line by its title."""
    assert main(["corpus", *arguments]) == 0
    lines = [re.split(r"\s{2,}", line.strip()) for line in capsys.readouterr().out.splitlines()]
    return {title: cells for title, *cells in lines if cells}


def tables() -> dict[str, list[str]]:
    """The cells of every row of the datasheet's tables by the row's title."""
    lines = SHEET.read_text(encoding="utf-8").splitlines()
    rows = [line.strip("| ").split(" | ") for line in lines if line.startswith("| ")]
    return {title.strip("` "): [cell.strip().replace(" %", "%") for cell in cells] for title, *cells in rows}


def test_the_counts_are_those_of_the_corpus(household_folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    counted = printed(capsys, "stats", str(household_folder / "corpus"))
    said = tables()
    for title, cells in counted.items():
        if title in said and title != "all":
            assert said[title] == cells[:4], title
    columns = ["all", *counted["all"]]
    for voice in columns[4:]:
        told = [counted[title][columns.index(voice)] for title in ("instructions", "complex", "tasks each, mean")]
        assert said[voice][1:4] == told, voice
    assert {"instructions", "complex", "nouns not in the house", "verbless condition", "informing"} <= set(said)


def test_the_agreement_is_that_of_the_two_annotations(capsys: pytest.CaptureFixture[str]) -> None:
    found = printed(capsys, "agreement")
    said = tables()
    for title in ("tasks, F1", "tasks, kappa", "arguments, F1", "flow identical", "flow identical, complex ones"):
        assert said[title][-1] == " ".join(found[title]).replace(" %", "%"), title
