"""The whole experiment: every split of every protocol, in any number of processes, to estimates of every measure."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.processes import results
from decomplex_bt.reproduction.dataset import (
    PROTOCOLS,
    Dataset,
    KnownDocuments,
    Sample,
    Split,
    parse_samples,
    read_samples,
)
from decomplex_bt.reproduction.interval import Estimate, estimate
from decomplex_bt.reproduction.measurement import Measures, measure_interpreter, measure_paper
from decomplex_bt.reproduction.paper import Paper, read_paper
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer

Progress = Callable[[str], None]
UNBOUNDED = ("transitions/", "features/")
"""Keys of measures that are no shares."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How the experiment is run.

    `corpus`: default the domain's own. `huric`: a folder of HuRIC 2.1, or none. `repeats`: splits of each protocol for
    the paper's systems; `interpreter_repeats`: for our default interpreter, whose training takes ten times as long.
    """

    domain: str | Path = "household"
    corpus: Path | None = None
    huric: Path | None = None
    repeats: int = 5
    interpreter_repeats: int = 1
    seed: int = 0
    jobs: int = 1
    protocols: tuple[str, ...] = tuple(PROTOCOLS)

    def to_json(self) -> dict[str, Any]:
        return {
            "corpus": None if self.corpus is None else str(self.corpus),
            "huric": None if self.huric is None else str(self.huric),
            "repeats": self.repeats,
            "interpreter_repeats": self.interpreter_repeats,
            "seed": self.seed,
        }


@dataclass(frozen=True)
class ProtocolResult:
    """What a protocol gave. `tested` and `tested_complex`: instructions in all test parts together."""

    name: str
    description: str
    splits: tuple[Split, ...]
    tested: int
    tested_complex: int
    test_share: float
    estimates: Mapping[str, Estimate]
    values: Mapping[str, tuple[float, ...]]

    def difference(self, more: str, less: str) -> Estimate | None:
        """The difference of two measures, split by split; None where either was not measured."""
        if more not in self.values or less not in self.values:
            return None
        pairs = zip(self.values[more], self.values[less], strict=True)
        return estimate([a - b for a, b in pairs], test_share=self.test_share, bounds=(-1.0, 1.0))

    def to_json(self) -> dict[str, Any]:
        return {
            "description": self.description,
            "left_out": [split.left_out for split in self.splits],
            "tested": self.tested,
            "tested_complex": self.tested_complex,
            "measures": {key: self.estimates[key].to_json() for key in sorted(self.estimates)},
        }


@dataclass(frozen=True)
class Results:
    """All that was measured. `examples`: how the paper's example was understood, by "paper" and "interpreter"."""

    settings: Settings
    paper: Paper
    dataset: Dataset
    protocols: tuple[ProtocolResult, ...]
    examples: Mapping[str, str]


def run(settings: Settings, progress: Progress = lambda stage: None) -> Results:
    """Reads the data, parses it once, trains and measures; the same settings give the same numbers, whatever `jobs`.

    Raises `InputError` where data or settings cannot be used.
    """
    _check(settings)
    domain = load_domain(settings.domain)
    paper = read_paper()
    examples, singles_from = read_samples(settings.corpus or domain.folder / "corpus", domain, settings.huric)
    progress(f"parsing {len(examples)} instructions")
    dataset = parse_samples(examples, singles_from, domain, Parser(), [paper.example])
    rng = np.random.default_rng(settings.seed)
    splits = {name: PROTOCOLS[name][1](dataset.samples, settings.repeats, rng) for name in settings.protocols}
    example = Observed(dataset.documents[paper.example], Gazetteer.of(domain.lexicon, domain.kinds))
    jobs = _jobs(settings, splits)
    measured = _measure_all(jobs, dataset, settings, paper, example, progress)
    protocols = tuple(_result(name, splits[name], dataset, jobs, measured) for name in settings.protocols)
    examples_read: dict[str, str] = {job.kind: m.example for job, m in zip(jobs, measured, strict=True) if m.example}
    return Results(settings, paper, dataset, protocols, examples_read)


@dataclass(frozen=True, slots=True)
class _Job:
    protocol: str
    number: int
    kind: Literal["interpreter", "paper"]
    split: Split


def _check(settings: Settings) -> None:
    if settings.repeats < 1:
        raise InputError(f"--repeats {settings.repeats}: expected 1 or more")
    if not 0 <= settings.interpreter_repeats <= settings.repeats:
        raise InputError(f"--interpreter-repeats {settings.interpreter_repeats}: expected 0 to {settings.repeats}")
    if unknown := [name for name in settings.protocols if name not in PROTOCOLS]:
        raise InputError(f"unknown protocol {unknown[0]!r}; expected one of {', '.join(PROTOCOLS)}")


def _jobs(settings: Settings, splits: Mapping[str, Sequence[Split]]) -> list[_Job]:
    """The long ones first, so that no process waits for a late one at the end."""
    numbered = [(name, n, split) for name, some in splits.items() for n, split in enumerate(some)]
    long = [_Job(name, n, "interpreter", split) for name, n, split in numbered if n < settings.interpreter_repeats]
    return [*long, *(_Job(name, n, "paper", split) for name, n, split in numbered)]


def _measure_all(
    jobs: Sequence[_Job],
    dataset: Dataset,
    settings: Settings,
    paper: Paper,
    example: Observed,
    progress: Progress,
) -> list[Measures]:
    from joblib import delayed

    features, text = tuple(paper.features), paper.example

    def call(k: int, job: _Job) -> Any:
        train = [dataset.samples[i] for i in job.split.train]
        test = [dataset.samples[i] for i in job.split.test]
        is_first = job.number == 0 and job.protocol == settings.protocols[0]
        if job.kind == "paper":
            return delayed(measure_paper)(train, test, features, example if is_first else None)
        documents = KnownDocuments(dataset.documents, dataset.language_model)
        draws = np.random.default_rng([settings.seed, k])
        return delayed(measure_interpreter)(train, test, settings.domain, documents, text if is_first else None, draws)

    measured = []
    for k, measures in enumerate(results((call(k, job) for k, job in enumerate(jobs)), settings.jobs)):
        job = jobs[k]
        what = "default interpreter" if job.kind == "interpreter" else "the paper's systems"
        progress(f"{k + 1}/{len(jobs)}: {what}, left out: {job.split.left_out}")
        measured.append(measures)
    return measured


def _result(
    name: str, splits: Sequence[Split], dataset: Dataset, jobs: Sequence[_Job], measured: Sequence[Measures]
) -> ProtocolResult:
    values: dict[str, list[float]] = {}
    intervals: dict[str, tuple[float, float]] = {}
    for job, measures in zip(jobs, measured, strict=True):
        if job.protocol == name:
            intervals |= measures.intervals
            for key, value in measures.values.items():
                values.setdefault(key, []).append(value)
    share = sum(len(split.test) for split in splits) / sum(len(split.train) for split in splits)
    tested = [dataset.samples[i] for split in splits for i in split.test]
    return ProtocolResult(
        name,
        PROTOCOLS[name][0],
        tuple(splits),
        len(tested),
        sum(map(_is_complex, tested)),
        share,
        {key: _estimate(key, some, share, intervals.get(key)) for key, some in values.items()},
        {key: tuple(some) for key, some in values.items()},
    )


def _estimate(key: str, values: Sequence[float], share: float, within: tuple[float, float] | None) -> Estimate:
    bounds = None if key.startswith(UNBOUNDED) else (0.0, float("inf")) if key.endswith("/oer") else (0.0, 1.0)
    return estimate(values, test_share=share, bounds=bounds, within=within)


def _is_complex(sample: Sample) -> bool:
    return sample.is_complex
