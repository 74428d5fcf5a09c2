"""The paper's figures, from `paper.yaml`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Literal

from pydantic import model_validator

from decomplex_bt.domain.document import Record, read_record

PAPER_FILE = Path(__file__).with_name("paper.yaml")


class PaperDataset(Record):
    """What the paper was measured on."""

    instructions: int
    complex: int
    tasks_mean: float
    tasks_sd: float
    task_labels: int
    argument_labels: int


class PaperTable(Record):
    """A table or figure of the paper. `values` maps rows to the paper's cells, `ours` more rows to what they are."""

    name: str
    title: str
    where: str
    key: str
    columns: tuple[str, ...]
    values: dict[str, tuple[float, ...]]
    ours: dict[str, str] = {}
    titles: dict[str, str] = {}
    better: Literal["higher", "lower", "neither"] = "higher"
    share: bool = True

    @model_validator(mode="after")
    def _check(self) -> PaperTable:
        for row, values in self.values.items():
            if len(values) != len(self.columns):
                raise ValueError(f"row {row!r} has {len(values)} values for {len(self.columns)} columns")
        return self

    def cells(self) -> Iterator[tuple[str, str, str, float | None]]:
        """Row, column, key of the measure and the paper's value (None in a row of ours), row by row."""
        for row in (*self.values, *self.ours):
            for i, column in enumerate(self.columns):
                value = self.values[row][i] if row in self.values else None
                yield row, column, f"{self.key}/{row}/{column}", value


class Claim(Record):
    """Something the paper concludes: the measure `more` is above the measure `less`, there by `paper`."""

    says: str
    more: str
    less: str
    paper: float


class VerdictLine(Record):
    """A measure that is held against the paper: of the paper's system, and of our default interpreter."""

    says: str
    key: str
    ours: str | None = None


class Paper(Record):
    """`paper.yaml`."""

    format: int
    dataset: PaperDataset
    labels: dict[str, str]
    features: dict[str, str]
    example: str
    tables: tuple[PaperTable, ...]
    titles: dict[str, str]
    claims: tuple[Claim, ...]
    verdicts: tuple[VerdictLine, ...]

    def value(self, key: str) -> tuple[float, PaperTable]:
        """The paper's figure for a measure with its table. Raises `KeyError` where the paper has none."""
        for table in self.tables:
            for _, _, cell, value in table.cells():
                if cell == key and value is not None:
                    return value, table
        raise KeyError(key)


def read_paper() -> Paper:
    """The paper's figures."""
    return read_record(PAPER_FILE, Paper)
