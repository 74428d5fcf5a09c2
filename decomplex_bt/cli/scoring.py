"""What `corpus score` measures, as text and as JSON: one part for each thing asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, get_args

from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.corpus import Example
    from decomplex_bt.domain.ontology import Ontology
    from decomplex_bt.evaluation.metrics import LanguageScores
    from decomplex_bt.evaluation.proportion import Proportion
    from decomplex_bt.evaluation.questions import AskingRow
    from decomplex_bt.evaluation.reliability import Reliability
    from decomplex_bt.evaluation.robustness import Estimate, NoiseRow


class Part(Protocol):
    """A part of the result; its text is what `str` gives."""

    def to_json(self) -> dict[str, Any]:
        """Its keys of the one object that is printed."""


@dataclass(frozen=True)
class Scores:
    """How well is understood, by complexity."""

    groups: Mapping[str, tuple[int, LanguageScores]]

    def to_json(self) -> dict[str, Any]:
        return {name: {"instructions": n, **part.to_json()} for name, (n, part) in self.groups.items()}

    def __str__(self) -> str:
        return "\n".join(line for name, (n, part) in self.groups.items() for line in self._lines(name, n, part))

    def _lines(self, name: str, n: int, part: LanguageScores) -> Iterator[str]:
        yield f"{name}: {n} instructions"
        yield (
            f"  F1: tasks {part.tasks.overall.value:.3f}, arguments {part.arguments.overall.value:.3f}, "
            f"dependencies {part.dependencies.overall.value:.3f}"
        )
        yield f"  control flow exactly right: {part.flow}; and all argument values: {part.strict}"
        yield f"  ordering error rate: {part.oer:.3f}"


@dataclass(frozen=True)
class Noise:
    """The same instructions under noise, side by side."""

    rows: Sequence[NoiseRow]

    def to_json(self) -> dict[str, Any]:
        return {"noise": [row.to_json() for row in self.rows]}

    def __str__(self) -> str:
        scores = ("tasks F1", "arguments F1", "dependencies F1", "flow right", "and all values", "flow, change")
        n = self.rows[0].instructions if self.rows else 0
        lines = [
            (
                row.name,
                *(_f1(estimate) for estimate in (row.tasks, row.arguments, row.dependencies)),
                _share(row.flow),
                _share(row.strict),
                _points(row.difference),
            )
            for row in self.rows
        ]
        return f"under noise: n = {n} in each row, with 95 % intervals\n{_table((('noise', *scores), *lines))}"


@dataclass(frozen=True)
class Calibration:
    """Confidence against what is right."""

    measured: Sequence[Reliability]

    def to_json(self) -> dict[str, Any]:
        return {"calibration": {one.kind: one.to_json() for one in self.measured}}

    def __str__(self) -> str:
        blocks = []
        for one in self.measured:
            error = "no data" if one.error is None else f"expected calibration error {one.error:.3f}"
            rows = [
                (f"{b.low:.1f} to {b.high:.1f}", "" if b.confidence is None else f"{b.confidence:.3f}", str(b.right))
                for b in one.bins
            ]
            header = ("confidence", "mean", "right")
            blocks.append(f"confidence in each {one.kind}: n = {one.total}, {error}\n{_table((header, *rows))}")
        return "\n\n".join(blocks)


@dataclass(frozen=True)
class Asking:
    """What questions pay."""

    rows: Sequence[AskingRow]

    def to_json(self) -> dict[str, Any]:
        return {"questions": [row.to_json() for row in self.rows]}

    def __str__(self) -> str:
        header = ("ask below", "asked", "of these answered", "flow right")
        rows = [
            (f"{row.threshold:.1f}", _share(row.asked), _share(row.answered), _share(row.flow)) for row in self.rows
        ]
        n = self.rows[0].flow.total if self.rows else 0
        return f"with at most one question each: n = {n}, with 95 % intervals\n{_table((header, *rows))}"


def examples_of(path: Path, split: str | None, ontology: Ontology) -> tuple[Example, ...]:
    """The examples of a corpus, or of one split of a folder. Raises `InputError` for an unknown split, and where there
    is nothing to score."""
    from decomplex_bt.corpus import Split, read_corpus, read_split

    if split is None:
        examples = read_corpus(path, ontology)
    elif split not in get_args(Split):
        raise InputError(f"--split {split}: no such split; expected one of {', '.join(get_args(Split))}")
    elif not path.is_dir():
        raise InputError(f"--split {split}: {path} is no folder with voices; give the folder, or leave --split out")
    else:
        examples = read_split(path, ontology, split)  # type: ignore[arg-type]
    if not examples:
        raise InputError(f"{path}: holds no instruction to score{f' in the split {split}' if split else ''}")
    return examples


def _f1(estimate: Estimate) -> str:
    return f"{estimate.value:.3f} [{estimate.low:.3f}, {estimate.high:.3f}]"


def _share(share: Proportion) -> str:
    if share.value is None or share.interval is None:
        return "no data"
    low, high = share.interval
    return f"{share.value:.1%} [{low:.1%}, {high:.1%}]"


def _points(estimate: Estimate) -> str:
    """A difference of shares in percentage points."""
    return f"{100 * estimate.value:+.1f} [{100 * estimate.low:+.1f}, {100 * estimate.high:+.1f}]"


def _table(rows: Sequence[Sequence[str]]) -> str:
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join(
        ("  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))).rstrip() for row in rows
    )
