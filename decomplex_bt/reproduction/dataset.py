"""The data of the experiments: single-task and complex instructions, each parsed once, and how they are split.

The paper mixes single-task instructions of HuRIC with complex ones of its authors (section IV-A). Here it is HuRIC's
where it is given, else those of our own corpus, and our own complex ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from statistics import fmean, stdev
from typing import Any

import numpy as np

from decomplex_bt.corpus import Example, read_corpus, read_voices
from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import InputError
from decomplex_bt.flow import If
from decomplex_bt.formats.huric import read_huric, single_tasks
from decomplex_bt.understanding.document import Document, Parser, Spelling
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.noise import edited
from decomplex_bt.understanding.training import EDITS

FOLDS = 5
"""A fifth is for testing, as in the paper; voices are dealt out to as many parts."""
LEAST = 2 * FOLDS
"""Complex instructions below which nothing can be measured."""


@dataclass(frozen=True)
class Sample:
    """An annotated instruction, parsed."""

    example: Example
    observed: Observed

    @property
    def is_complex(self) -> bool:
        return len(self.example.instruction.tasks) > 1


@dataclass(frozen=True)
class Dataset:
    """All samples; `singles_from` says whose the single-task ones are. `documents`: every text's parse, noised copies
    included."""

    samples: tuple[Sample, ...]
    singles_from: str
    language_model: str
    documents: dict[str, Document]

    @property
    def complex(self) -> tuple[Sample, ...]:
        return tuple(sample for sample in self.samples if sample.is_complex)

    def dependents(self) -> list[tuple[Sample, int, int]]:
        """Every task in a branch with the condition it depends on: sample, number of the task, of the condition."""
        return [
            (sample, child.task, node.tasks[0])
            for sample in self.complex
            for node, _ in sample.example.instruction.flow.walk()
            if isinstance(node, If)
            for child in (*node.then, *node.orelse)
        ]

    def to_json(self) -> dict[str, Any]:
        lengths = [len(sample.example.instruction.tasks) for sample in self.complex]
        labels = [label for s in self.complex for label in s.example.instruction.flow.dependencies().values()]
        return {
            "instructions": len(self.samples),
            "complex": len(lengths),
            "singles": len(self.samples) - len(lengths),
            "singles_from": self.singles_from,
            "voices": len({sample.example.voice for sample in self.samples}),
            "tasks_mean": round(fmean(lengths), 3),
            "tasks_sd": round(stdev(lengths), 3),
            "labels": {label: labels.count(label) for label in sorted(set(labels))},
        }


@dataclass(frozen=True, slots=True)
class Split:
    """Sample numbers to train on and to test on; `left_out` names what the test part is."""

    train: tuple[int, ...]
    test: tuple[int, ...]
    left_out: str


class KnownDocuments(Parser):
    """A parser that remembers: the texts handed in cost nothing, and the language model is loaded only for
    others (the copies with fillers, which are drawn for each training anew)."""

    def __init__(self, documents: dict[str, Document], model_name: str) -> None:
        self._documents = documents
        self._model_name = model_name

    @cached_property
    def _parser(self) -> Parser:
        return Parser()

    @property
    def model_name(self) -> str:
        return self._model_name

    def parse(self, text: str, spelling: Spelling | None = None) -> Document:
        return next(self.parse_batch([text], spelling=spelling))

    def parse_batch(self, texts: Any, *, batch_size: int = 128, spelling: Spelling | None = None) -> Iterator[Document]:
        asked = list(texts)
        unknown = list(dict.fromkeys(text for text in asked if text not in self._documents))
        documents = self._parser.parse_batch(unknown, spelling=spelling) if unknown else ()
        parsed = dict(zip(unknown, documents, strict=True))
        return (self._documents[text] if text in self._documents else parsed[text] for text in asked)


def read_samples(corpus: Path, domain: Domain, huric: Path | None) -> tuple[tuple[Example, ...], str]:
    """The examples of all voices that `voices.yaml` lists, and whose the single-task ones are.

    With `huric` our own instructions of one task give way to HuRIC's. Raises `InputError` where there are too few.
    """
    ours = [e for voice in read_voices(corpus) for e in read_corpus(corpus / f"{voice}.yaml", domain.ontology)]
    complex_ones = [example for example in ours if len(example.instruction.tasks) > 1]
    if len(complex_ones) < LEAST:
        raise InputError(f"{corpus} has {len(complex_ones)} instructions of several tasks; at least {LEAST} are needed")
    if huric is None:
        return (*single_tasks(ours), *complex_ones), "our own corpus"
    singles = list(single_tasks(read_huric(huric, domain)))
    if not singles:
        raise InputError(f"{huric} holds no command with one task; expected HuRIC 2.1")
    return (*singles, *complex_ones), "HuRIC 2.1"


def parse_samples(
    examples: Sequence[Example], singles_from: str, domain: Domain, parser: Parser, more: Sequence[str] = ()
) -> Dataset:
    """Parses every text once, and `more` ones, with the noised copies that the default interpreter is trained on."""
    texts = dict.fromkeys(more)
    for example in examples:
        texts[example.instruction.text] = None
        texts |= {edited(example.instruction, edit).text: None for edit in EDITS}
    documents = dict(zip(texts, parser.parse_batch(texts), strict=True))
    gazetteer = Gazetteer.of(domain.lexicon, domain.kinds)
    samples = tuple(Sample(e, Observed(documents[e.instruction.text], gazetteer)) for e in examples)
    return Dataset(samples, singles_from, parser.model_name, documents)


def random_splits(samples: Sequence[Sample], repeats: int, rng: np.random.Generator) -> list[Split]:
    """The paper's protocol: 80 % to train on, single-task and complex instructions each, as often as `repeats`."""
    groups = [[i for i, s in enumerate(samples) if s.is_complex == is_complex] for is_complex in (False, True)]
    splits = []
    for number in range(1, repeats + 1):
        test: set[int] = set()
        for group in groups:
            test |= {group[i] for i in rng.permutation(len(group))[: len(group) // FOLDS]}
        splits.append(_split(len(samples), test, f"random fifth {number}"))
    return splits


def voice_splits(samples: Sequence[Sample], repeats: int, rng: np.random.Generator) -> list[Split]:
    """The stricter protocol: whole voices are left out, dealt to `FOLDS` parts of about equal numbers of complex
    instructions; every `FOLDS` splits leave each voice out once.

    Raises `InputError` where there are fewer than two voices.
    """
    voices = sorted({sample.example.voice for sample in samples})
    if len(voices) < 2:
        raise InputError("there is only one voice; leaving out voices needs two at least")
    splits: list[Split] = []
    while len(splits) < repeats:
        for part in _deal([voices[i] for i in rng.permutation(len(voices))], samples):
            test = {i for i, sample in enumerate(samples) if sample.example.voice in part}
            splits.append(_split(len(samples), test, ", ".join(sorted(part))))
    return splits[:repeats]


PROTOCOLS: dict[str, tuple[str, Callable[[Sequence[Sample], int, np.random.Generator], list[Split]]]] = {
    "random": ("random 80/20 splits, as in the paper", random_splits),
    "voice": ("whole voices left out", voice_splits),
}
"""Protocols by name, with what they are."""


def _deal(voices: Sequence[str], samples: Sequence[Sample]) -> list[set[str]]:
    """Voices to parts: each to the part with the fewest complex instructions so far; a voice without any to the part
    with the fewest instructions."""
    parts: list[set[str]] = [set() for _ in range(min(FOLDS, len(voices)))]
    sizes = [(0, 0)] * len(parts)
    for voice in voices:
        own = [sample.is_complex for sample in samples if sample.example.voice == voice]
        k = min(range(len(parts)), key=lambda j: (sizes[j][0] if any(own) else 0, sizes[j][1]))
        parts[k].add(voice)
        sizes[k] = (sizes[k][0] + sum(own), sizes[k][1] + len(own))
    return [part for part in parts if part]


def _split(size: int, test: set[int], left_out: str) -> Split:
    return Split(tuple(i for i in range(size) if i not in test), tuple(sorted(test)), left_out)
