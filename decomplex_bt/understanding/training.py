"""Training: from a corpus of annotated voices to a folder of models with a manifest."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, compress
from pathlib import Path

from decomplex_bt.corpus import Example, read_corpus, read_voices
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.arguments import gold_tasks, train_arguments
from decomplex_bt.understanding.coreference import train_references
from decomplex_bt.understanding.dependencies import train_flow
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.manifest import corpus_hash, write_manifest
from decomplex_bt.understanding.noise import edited, without_apostrophes, without_punctuation
from decomplex_bt.understanding.readings import Reading, load_stages, readings_of, train_readings
from decomplex_bt.understanding.tasks import train_tasks

Progress = Callable[[str], None]

EDITS = (without_punctuation, without_apostrophes)
"""The noised copies that tasks and arguments are trained on besides the text itself."""

FOLDS = 4
"""Into how many parts the voices are split to read every instruction by models that never saw its voice."""


@dataclass(frozen=True, slots=True)
class TrainingReport:
    """What was trained: the voices and examples used, the flows that no labels can say, where the models are."""

    voices: tuple[str, ...]
    examples: int
    flows_left_out: int
    folder: Path


def train(
    corpus: Path | None = None,
    output: Path | None = None,
    *,
    domain: str | Path | Domain = "household",
    progress: Progress = lambda stage: None,
) -> TrainingReport:
    """Trains all models on the voices of the splits "train" and "development" and writes them to `output`.

    `corpus` and `output` default to the domain's own folders. The test voices are never read. Nothing is written unless
    all models were trained. The same corpus and libraries give the same files. Raises `DataFileError`.
    """
    loaded = domain if isinstance(domain, Domain) else load_domain(domain)
    corpus = corpus or loaded.folder / "corpus"
    output = output or loaded.folder / "models"
    voices = [name for name, voice in read_voices(corpus).items() if voice.split != "test"]
    files = {f"{name}.yaml": (corpus / f"{name}.yaml").read_bytes() for name in voices}
    examples = [e for name in voices for e in read_corpus(corpus / f"{name}.yaml", loaded.ontology)]
    parser = Parser()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        left_out = train_models(folder, examples, loaded, parser, progress=progress)
        write_manifest(
            folder,
            loaded,
            corpus=corpus_hash(files),
            voices=voices,
            examples=len(examples),
            language_model=parser.model_name,
        )
        output.mkdir(parents=True, exist_ok=True)
        for file in sorted(folder.iterdir()):
            shutil.copyfile(file, output / file.name)
    return TrainingReport(tuple(voices), len(examples), left_out, output)


def train_models(
    folder: Path,
    examples: Sequence[Example],
    domain: Domain,
    parser: Parser,
    *,
    progress: Progress = lambda stage: None,
) -> int:
    """Trains every model on these examples into `folder`; gives the number of flows that no labels can say."""
    gazetteer = Gazetteer.of(domain.lexicon, domain.kinds)
    progress("parsing")
    texts = [example.instruction for example in examples]
    data = Corpus(
        tuple(example.voice for example in examples),
        tuple(observe(texts, parser, gazetteer)),
        tuple(tuple(observe([edited(text, edit) for text in texts], parser, gazetteer)) for edit in EDITS),
    )
    left_out = _train_stages(folder, data, progress)
    progress("references")
    train_references(folder / "references.crf", data.plain, domain.ontology)
    train_readings(folder / "readings.json", list(_choices(data, domain, progress)))
    return left_out


@dataclass(frozen=True)
class Corpus:
    """Parsed instructions with the voice of each, and their noised copies, one tuple an edit, in the same order."""

    voices: tuple[str, ...]
    plain: tuple[tuple[Observed, Instruction], ...]
    noised: tuple[tuple[tuple[Observed, Instruction], ...], ...]

    def only(self, kept: Sequence[bool]) -> Corpus:
        """The part at the places where `kept` is true."""
        return Corpus(
            tuple(compress(self.voices, kept)),
            tuple(compress(self.plain, kept)),
            tuple(tuple(compress(copies, kept)) for copies in self.noised),
        )


def _train_stages(folder: Path, data: Corpus, progress: Progress) -> int:
    # tasks and arguments gain from noised copies; the flow lives on punctuation and does not
    with_noise = [*data.plain, *chain.from_iterable(data.noised)]
    progress("tasks")
    train_tasks(folder / "tasks.crf", with_noise)
    progress("arguments")
    train_arguments(folder / "arguments.crf", with_noise)
    progress("flow")
    return train_flow(folder, data.plain)


def _choices(data: Corpus, domain: Domain, progress: Progress) -> Iterator[tuple[tuple[Reading, ...], int]]:
    """For every instruction that can be read right, its readings by stages that never saw its voice, and which is."""
    held_out = _folds(data.voices)
    for fold in range(max(held_out) + 1):
        progress(f"readings {fold + 1}/{max(held_out) + 1}")
        with tempfile.TemporaryDirectory() as scratch:
            _train_stages(Path(scratch), data.only([f != fold for f in held_out]), lambda stage: None)
            stages = load_stages(Path(scratch))
            for observed, instruction in data.only([f == fold for f in held_out]).plain:
                readings = readings_of(observed, stages, domain.ontology)
                right = _right(observed, instruction, readings)
                if right is not None:
                    yield readings, right


def _folds(voices: Sequence[str]) -> list[int]:
    """The fold of every example: whole voices, four folds; where there are too few voices, every other example."""
    names = sorted(set(voices))
    if len(names) < FOLDS:
        return [i % 2 for i in range(len(voices))]
    return [names.index(voice) % FOLDS for voice in voices]


def _right(observed: Observed, instruction: Instruction, readings: Sequence[Reading]) -> int | None:
    gold = gold_tasks(observed.document, instruction)
    return next((i for i, r in enumerate(readings) if {t.token: t.type for t in r.tasks} == gold), None)


def observe(
    instructions: Sequence[Instruction], parser: Parser, gazetteer: Gazetteer
) -> list[tuple[Observed, Instruction]]:
    """Every instruction with its parsed document."""
    documents = parser.parse_batch([instruction.text for instruction in instructions])
    return [(Observed(document, gazetteer), i) for document, i in zip(documents, instructions, strict=True)]
