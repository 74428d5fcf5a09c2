"""Training: from a corpus of annotated voices to a folder of models with a manifest."""

from __future__ import annotations

import math
import os
import tempfile
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import chain, compress
from pathlib import Path

import numpy as np

from decomplex_bt.corpus import Example, Split, read_corpus, read_voices
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.instruction import Instruction
from decomplex_bt.processes import results
from decomplex_bt.understanding.arguments import gold_tasks, train_arguments
from decomplex_bt.understanding.confidence import KINDS, Belief, belief_of, train_calibration
from decomplex_bt.understanding.coreference import REFERENCES_FILE, ReferenceModel, train_references
from decomplex_bt.understanding.damage import ENCODER_FOLDER
from decomplex_bt.understanding.dependencies import FlowModel, marked_tasks, train_flow
from decomplex_bt.understanding.disturbances import DISTURBANCES, with_fillers
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.manifest import (
    FILES,
    LIBRARIES,
    MANIFEST_FILE,
    Manifest,
    check_language,
    check_models,
    corpus_hash,
    file_hash,
    write_manifest,
    write_manifest_of_references,
)
from decomplex_bt.understanding.noise import edited, without_apostrophes, without_punctuation
from decomplex_bt.understanding.readings import (
    Reading,
    ReadingModel,
    Stages,
    load_stages,
    readings_of,
    train_readings,
)
from decomplex_bt.understanding.recombination.copies import recombined
from decomplex_bt.understanding.spelling import WORDS_FILE, write_words
from decomplex_bt.understanding.tasks import train_tasks

Progress = Callable[[str], None]

EDITS = (without_punctuation, without_apostrophes)
"""The noised copies that tasks and arguments are trained on besides the text itself."""

DISTURBED = ("typing slips", "speech recogniser")
"""The disturbances in copies that the encoder alone is trained on."""

REHEARSED = 0.2
"""Share of the instructions that are gone over once more of which there are copies to learn from, too."""

KEPT = 3
"""One voice in so many is read by models that never saw it, to learn the choice among readings."""


@dataclass(frozen=True, slots=True)
class TrainingReport:
    """What was trained: the voices and examples used, the flows that no labels can say, where the models are.

    `held_out`: of the voices read by models that never saw them (a third of them; with the encoder those of
    "development"), how many instructions came out with exactly the right tasks and control flow, and of how many. Only
    the few weights of the choice among readings were fitted on them. Of fewer than three voices every other
    instruction is held out.
    """

    voices: tuple[str, ...]
    examples: int
    flows_left_out: int
    folder: Path
    held_out: Mapping[str, tuple[int, int]]


def train(
    corpus: Path | None = None,
    output: Path | None = None,
    *,
    domain: str | Path | Domain = "household",
    encoder: bool = False,
    references: bool = False,
    base: Path | None = None,
    rehearse: bool = False,
    force: bool = False,
    jobs: int = 1,
    progress: Progress = lambda stage: None,
) -> TrainingReport:
    """Trains the models on the voices of the splits "train" and "development" and writes them to `output`.

    `corpus` and `output` default to the domain's own folders. Models that lie there already are replaced only with
    `force`, but for the domain's own when they are made anew from its own corpus. `encoder`: trains the pretrained
    encoder instead, on the voices of "train", with those of "development" for the choice among readings, into the
    folder `encoder` of `output`; an hour and a quarter on two cores. `base`: a folder with a trained encoder to go on
    from, which learns the voices that it does not know and sees some of the domain's own that it knows again;
    `rehearse`: it goes once over all training voices instead, known or not.
    `references`: trains only what words refer to and which words are known, beside the models that lie in `output`
    already, in one process; a quarter of an hour; with another corpus from the domain's own voices as well. `jobs`:
    parts that need nothing of each other run in as many processes (two at most), -1 for one a core. The test voices are
    never read.
    No model is written unless all were trained. The same corpus, `base` and libraries give the same files, with any
    number of jobs. Raises `DataFileError`, `TrainerMissingError` where the extra `train` is not installed, and, before
    anything is trained, `InputError` where the models would replace others or cannot be written, where `base` knows
    all voices and is not to `rehearse` them, where there is no `base` or no training voice to do so, or where
    `references` have no models to go with.
    """
    if references and (encoder or rehearse or base is not None):
        raise InputError("references are trained by themselves; leave out --encoder, --from and --rehearse")
    if rehearse and base is None:
        raise InputError("nothing but what is trained already can be rehearsed; tell where it lies with --from")
    loaded = domain if isinstance(domain, Domain) else load_domain(domain)
    own_corpus, own_models = loaded.folder / "corpus", loaded.folder / "models"
    corpus, output = corpus or own_corpus, output or own_models
    target = output / ENCODER_FOLDER if encoder else output
    is_own = corpus.resolve() == own_corpus.resolve()
    is_renewed = is_own and output.resolve() == own_models.resolve()
    splits: dict[str, Split] = {name: v.split for name, v in read_voices(corpus).items() if v.split != "test"}
    files = {f"{name}.yaml": (corpus / f"{name}.yaml").read_bytes() for name in splits}
    examples = [e for name in splits for e in read_corpus(corpus / f"{name}.yaml", loaded.ontology)]
    known = set[str]()
    if references:
        before = _models_beside(output, loaded)
        if not is_own:
            own_voices = read_voices(own_corpus)
            splits, examples = _with_own(splits, examples, own_voices, own_corpus, loaded)
    if base is not None:
        if not encoder:
            raise InputError(f"nothing but the encoder goes on from trained models; leave {base} out, or add --encoder")
        known = _learnt(base, loaded)
        if not is_own:
            splits, examples = _with_own(splits, examples, known, own_corpus, loaded)
        if rehearse and "train" not in splits.values():
            raise InputError(f"{corpus} has no training voice to go over; add one")
        if not rehearse and all(name in known for name, split in splits.items() if split == "train"):
            raise InputError(f"the encoder in {base} knows every training voice of {corpus}; add one, or --rehearse")
    parser = Parser()
    with _scratch_in(output, target, may_replace=force or is_renewed) as folder:
        if references:
            check_language(output, parser.model_name)
            progress("parsing")
            data = observe([e.instruction for e in examples], parser, Gazetteer.of(loaded.lexicon, loaded.kinds))
            _train_references(folder, data, loaded, progress)
            write_manifest_of_references(folder, before, tuple(splits))
            _put_in_place(folder, target)
            return TrainingReport(tuple(splits), len(examples), 0, target, {})
        if encoder:
            for_choice = {name for name, split in splits.items() if split == "development"}
            left_out, held_out = train_with_encoder(
                folder,
                examples,
                for_choice,
                loaded,
                parser,
                base=base,
                known=known,
                rehearse=rehearse,
                jobs=jobs,
                progress=progress,
            )
        else:
            left_out, held_out = train_models(folder, examples, loaded, parser, jobs=jobs, progress=progress)
        write_manifest(
            folder,
            loaded,
            corpus=corpus_hash(files),
            voices=(*splits, *sorted(known - splits.keys())),
            examples=len(examples),
            base=None if base is None else file_hash(base / MANIFEST_FILE),
            language_model=parser.model_name,
            libraries=(*LIBRARIES, "torch", "onnxruntime") if encoder else LIBRARIES,
        )
        _put_in_place(folder, target)
    return TrainingReport(tuple(splits), len(examples), left_out, target, held_out)


def _learnt(base: Path, domain: Domain) -> set[str]:
    """The voices that a trained encoder has learnt from. Raises `InputError` where there is none to go on from."""
    from decomplex_bt.understanding.encoder.stages import FOLDER_FILES

    try:
        return set(check_models(base, domain, models=(), files=FOLDER_FILES).voices)
    except DataFileError as error:
        shipped = domain.folder / "models" / ENCODER_FOLDER
        raise InputError(
            f"--from {base}: holds no encoder to go on from ({error.path}: {error.problem}); give the folder of one, "
            f"as the domain's own, {shipped}"
        ) from None


def _models_beside(output: Path, domain: Domain) -> Manifest:
    """The manifest of the models that references are trained for, which may be all but those. Raises `InputError` where
    there are none, and `DataFileError` where they do not fit."""
    if not (output / MANIFEST_FILE).exists():
        raise InputError(f"{output} holds no models, which references go with; copy some there, or train them first")
    return check_models(output, domain, files=sorted({*FILES} - {REFERENCES_FILE, WORDS_FILE}))


def _with_own(
    splits: Mapping[str, Split], examples: Sequence[Example], known: Container[str], own_corpus: Path, domain: Domain
) -> tuple[dict[str, Split], list[Example]]:
    """Another corpus with what is known of the domain's own behind it. Raises `InputError` where a voice is in both."""
    own = read_voices(own_corpus)
    if both := sorted(splits.keys() & own.keys()):
        raise InputError(f"{both[0]!r} is a voice of the domain's own corpus, too; give yours another name")
    taken = {name: voice.split for name, voice in own.items() if voice.split != "test" and name in known}
    others = [e for name in taken for e in read_corpus(own_corpus / f"{name}.yaml", domain.ontology)]
    return {**splits, **taken}, [*examples, *others]


@contextmanager
def _scratch_in(output: Path, target: Path, *, may_replace: bool) -> Iterator[Path]:
    """A folder within `output`, on its disk and gone afterwards. Raises `InputError` where nothing can be written, or
    nothing may be."""
    try:
        if not may_replace and (target / MANIFEST_FILE).exists():
            raise InputError(
                f"{target} holds models already; name another folder with --output, or replace them with --force"
            )
        output.mkdir(parents=True, exist_ok=True)
        if target.exists() and not target.is_dir():
            raise NotADirectoryError(None, "it is a file")
        scratch = tempfile.TemporaryDirectory(dir=output, prefix=".training-")
    except OSError as error:
        raise InputError(f"{target}: cannot write there: {error.strerror}; give another folder") from None
    with scratch as folder:
        yield Path(folder)


def _put_in_place(folder: Path, target: Path) -> None:
    """Moves all files of a folder. The manifest goes first and comes last: without it no half of two folders is ever
    loaded, whatever stops this."""
    target.mkdir(exist_ok=True)
    (target / MANIFEST_FILE).unlink(missing_ok=True)
    for file in sorted(folder.iterdir(), key=lambda file: (file.name == MANIFEST_FILE, file.name)):
        os.replace(file, target / file.name)


def train_models(
    folder: Path,
    examples: Sequence[Example],
    domain: Domain,
    parser: Parser,
    *,
    jobs: int = 1,
    progress: Progress = lambda stage: None,
) -> tuple[int, Mapping[str, tuple[int, int]]]:
    """Trains every model but the encoder on these examples into `folder`; gives the number of flows that no labels can
    say, and what `TrainingReport` tells of the voices held out."""
    from joblib import delayed

    data = _corpus(examples, domain, parser, progress)
    is_kept = _is_kept(data.voices)
    others, kept = data.only([not kept for kept in is_kept]), data.only(is_kept)
    recombinations = _recombinations(data.plain, domain, parser)
    parts = (
        delayed(_train_stages)(folder, data, recombinations, progress),
        delayed(_read_by_others)(others, kept, domain, progress),
    )
    left_out, held_out = results(iter(parts), jobs)
    _train_references(folder, data.plain, domain, progress)
    return left_out, _train_choice(folder, held_out)


def _train_references(
    folder: Path, pairs: Sequence[tuple[Observed, Instruction]], domain: Domain, progress: Progress
) -> None:
    """What words refer to, and which words are known."""
    progress("references")
    train_references(folder / REFERENCES_FILE, pairs, domain.ontology)
    write_words(folder / WORDS_FILE, (observed.document for observed, _ in pairs))


def train_with_encoder(
    folder: Path,
    examples: Sequence[Example],
    for_choice: Container[str],
    domain: Domain,
    parser: Parser,
    *,
    base: Path | None = None,
    known: Container[str] = (),
    rehearse: bool = False,
    jobs: int = 1,
    progress: Progress = lambda stage: None,
) -> tuple[int, Mapping[str, tuple[int, int]]]:
    """Trains the encoder and the flow network into `folder`; the voices in `for_choice` only teach the choice among
    readings and its confidence. `base`: a folder with trained ones to go on from, which have learnt from the voices in
    `known`, or, to `rehearse`, go once over all. Gives what `train_models` does."""
    from joblib import delayed

    from decomplex_bt.understanding.encoder.fitting import REHEARSAL, Lessons
    from decomplex_bt.understanding.encoder.flow_training import train_flow_network
    from decomplex_bt.understanding.encoder.model import EncoderModel
    from decomplex_bt.understanding.encoder.referents import train_share
    from decomplex_bt.understanding.encoder.stages import encoder_stages
    from decomplex_bt.understanding.encoder.training import FURTHER, train_encoder

    taught = [e for e in examples if e.voice not in for_choice]
    fresh, seen = _rehearsed(taught) if rehearse else _new(taught, known, FURTHER.epochs * FURTHER.known)
    data = _corpus([*fresh, *(e for e in examples if e.voice in for_choice)], domain, parser, progress)
    learnt = data.only([voice not in for_choice for voice in data.voices])
    kept = data.only([voice in for_choice for voice in data.voices])
    again = observe(seen, parser, Gazetteer.of(domain.lexicon, domain.kinds))
    disturbed = _disturbed(learnt.plain, domain, parser)
    recombinations = _recombinations(learnt.plain, domain, parser)
    noised = [*chain.from_iterable(learnt.noised), *learnt.filled, *disturbed]
    for_flow = [*learnt.for_flow()[len(learnt.plain) :], *disturbed]
    plain, reminders = ([*learnt.plain, *again], []) if rehearse else (learnt.plain, again)
    pace = REHEARSAL if rehearse else None
    with tempfile.TemporaryDirectory() as scratch:  # models that, like the encoder, never saw the voices kept back
        calls = (
            delayed(fitted)(folder, lessons, domain.ontology, base=base, pace=pace, progress=progress)
            for fitted, lessons in (
                (train_encoder, Lessons(plain, noised, recombinations, reminders)),
                (train_flow_network, Lessons(plain, for_flow, recombinations, reminders)),
            )
        )
        flow = delayed(train_flow)(Path(scratch), [*learnt.for_flow(), *again, *recombinations])
        path = Path(scratch) / REFERENCES_FILE
        references = delayed(train_references)(path, [*learnt.plain, *again], domain.ontology)
        *_, left_out, _ = results(chain(calls, (flow, references)), jobs)
        model = EncoderModel(folder)
        progress("readings")
        stages = encoder_stages(folder, model, FlowModel(Path(scratch)), domain.ontology)
        held_out = _train_choice(folder, list(_held(kept, stages, domain)))
        train_share(folder, model, ReferenceModel(path, domain.ontology), kept.plain, domain.ontology)
    return left_out, held_out


def _new(
    examples: Sequence[Example], known: Container[str], most_seen: float
) -> tuple[list[Example], list[Instruction]]:
    """The examples of voices that are not known, and instructions of others, drawn by chance, to be seen again: at most
    so many for each new one."""
    fresh = [e for e in examples if e.voice not in known]
    seen = [e.instruction for e in examples if e.voice in known]
    most = int(most_seen * len(fresh))
    if len(seen) > most:
        seen = [seen[i] for i in sorted(np.random.default_rng(0).choice(len(seen), most, replace=False))]
    return fresh, seen


def _rehearsed(examples: Sequence[Example]) -> tuple[list[Example], list[Instruction]]:
    """All examples in two: those, drawn by chance, of which copies are made, and the instructions of the others."""
    count = math.ceil(REHEARSED * len(examples))
    drawn = set(np.random.default_rng(0).choice(len(examples), count, replace=False).tolist())
    return (
        [e for i, e in enumerate(examples) if i in drawn],
        [e.instruction for i, e in enumerate(examples) if i not in drawn],
    )


def _disturbed(
    pairs: Sequence[tuple[Observed, Instruction]], domain: Domain, parser: Parser
) -> list[tuple[Observed, Instruction]]:
    """A copy of every instruction for each of `DISTURBED`."""
    rng = np.random.default_rng(0)
    copies = [DISTURBANCES[name](instruction, rng) for name in DISTURBED for _, instruction in pairs]
    return observe(copies, parser, Gazetteer.of(domain.lexicon, domain.kinds))


def _recombinations(
    pairs: Sequence[tuple[Observed, Instruction]], domain: Domain, parser: Parser
) -> list[tuple[Observed, Instruction]]:
    """Recombined copies, of nothing but these instructions."""
    copies = recombined(pairs, np.random.default_rng(0))
    return observe(copies, parser, Gazetteer.of(domain.lexicon, domain.kinds))


def _corpus(examples: Sequence[Example], domain: Domain, parser: Parser, progress: Progress) -> Corpus:
    gazetteer = Gazetteer.of(domain.lexicon, domain.kinds)
    progress("parsing")
    texts = [example.instruction for example in examples]
    rng = np.random.default_rng(0)
    return Corpus(
        tuple(example.voice for example in examples),
        tuple(observe(texts, parser, gazetteer)),
        tuple(tuple(observe([edited(text, edit) for text in texts], parser, gazetteer)) for edit in EDITS),
        tuple(observe([with_fillers(text, rng) for text in texts], parser, gazetteer)),
    )


@dataclass(frozen=True, slots=True)
class Held:
    """An annotated instruction with its readings by stages that never saw it (nor its voice, see `_is_kept`)."""

    voice: str
    observed: Observed
    instruction: Instruction
    readings: tuple[Reading, ...]

    def right(self) -> int | None:
        """The reading with the right tasks and flow; else the first with the right tasks; else None."""
        gold = gold_tasks(self.observed.document, self.instruction)
        right = [i for i, r in enumerate(self.readings) if {t.token: t.type for t in r.tasks} == gold]
        exact = [i for i in right if self.readings[i].flow == self.instruction.flow]
        return next(iter([*exact, *right]), None)


def _train_choice(folder: Path, held_out: Sequence[Held]) -> Mapping[str, tuple[int, int]]:
    """The weights of readings and the calibration of confidences; gives what was read right of each voice."""
    rights = [(held.readings, held.right()) for held in held_out]
    train_readings(folder / "readings.json", [(readings, right) for readings, right in rights if right is not None])
    model = ReadingModel(folder / "readings.json")
    seen: dict[str, list[tuple[float, bool]]] = {kind: [] for kind in KINDS}
    by_voice: dict[str, tuple[int, int]] = {}
    for held in held_out:
        ranked = model.ranked(held.readings)
        for kind, chance, is_right in judged(held.observed, held.instruction, ranked[0][0], belief_of(ranked)):
            seen[kind].append((chance, is_right))
        right, count = by_voice.get(held.voice, (0, 0))
        by_voice[held.voice] = (right + seen["flow"][-1][1], count + 1)
    train_calibration(folder / "calibration.json", seen)
    return by_voice


def judged(
    observed: Observed, instruction: Instruction, reading: Reading, belief: Belief
) -> Iterator[tuple[str, float, bool]]:
    """Of everything believed of a reading its kind, how much it is believed, and whether it is right."""
    marked = marked_tasks(observed, instruction)
    gold = {task.token: task.type for task in marked}
    numbers = {task.token: instruction.flow.dependencies().get(k, "") for k, task in enumerate(marked, start=1)}
    arguments = {(kind, task.token, tokens) for task in marked for kind, tokens in task.arguments}
    labels = reading.flow.dependencies()
    for k, task in enumerate(reading.tasks, start=1):
        yield "task", belief.tasks[task.token], gold.get(task.token) == task.type
        yield "dependency", belief.dependencies[task.token], numbers.get(task.token) == labels.get(k)
    for argument, chance in belief.arguments.items():
        yield "argument", chance, (argument.type, argument.owner, argument.tokens) in arguments
    yield "flow", belief.flow, {t.token: t.type for t in reading.tasks} == gold and reading.flow == instruction.flow


@dataclass(frozen=True)
class Corpus:
    """Parsed instructions with the voice of each, and copies in the same order: noised ones, one tuple an edit, and
    ones with fillers."""

    voices: tuple[str, ...]
    plain: tuple[tuple[Observed, Instruction], ...]
    noised: tuple[tuple[tuple[Observed, Instruction], ...], ...]
    filled: tuple[tuple[Observed, Instruction], ...]

    def for_flow(self) -> list[tuple[Observed, Instruction]]:
        """What the flow is learnt from: the texts, and their copies without punctuation and with fillers."""
        return [*self.plain, *self.noised[EDITS.index(without_punctuation)], *self.filled]

    def only(self, kept: Sequence[bool]) -> Corpus:
        """The part at the places where `kept` is true."""
        return Corpus(
            tuple(compress(self.voices, kept)),
            tuple(compress(self.plain, kept)),
            tuple(tuple(compress(copies, kept)) for copies in self.noised),
            tuple(compress(self.filled, kept)),
        )


def _train_stages(
    folder: Path, data: Corpus, recombinations: Sequence[tuple[Observed, Instruction]], progress: Progress
) -> int:
    """Trains the CRFs, that of the flow on recombined copies, too; gives the number of flows that no labels can say."""
    with_noise = [*data.plain, *chain.from_iterable(data.noised)]
    progress("tasks")
    train_tasks(folder / "tasks.crf", with_noise)
    progress("arguments")
    train_arguments(folder / "arguments.crf", with_noise)
    progress("flow")
    return train_flow(folder, [*data.for_flow(), *recombinations])


def _read_by_others(others: Corpus, data: Corpus, domain: Domain, progress: Progress) -> list[Held]:
    """The instructions of `data` with their readings by stages trained on `others`."""
    progress("readings")
    with tempfile.TemporaryDirectory() as scratch:
        recombinations = _recombinations(others.plain, domain, Parser())  # a parser is not sent to another process
        _train_stages(Path(scratch), others, recombinations, lambda stage: None)
        return list(_held(data, load_stages(Path(scratch)), domain))


def _held(data: Corpus, stages: Stages, domain: Domain) -> Iterator[Held]:
    for voice, (observed, instruction) in zip(data.voices, data.plain, strict=True):
        yield Held(voice, observed, instruction, readings_of(observed, stages, domain.ontology))


def _is_kept(voices: Sequence[str]) -> list[bool]:
    """Whether the voice of each example is kept back: every third, by name; every other example of too few voices."""
    names = sorted(set(voices))
    if len(names) < KEPT:
        return [i % 2 == 0 for i in range(len(voices))]
    return [names.index(voice) % KEPT == 0 for voice in voices]


def observe(
    instructions: Sequence[Instruction], parser: Parser, gazetteer: Gazetteer
) -> list[tuple[Observed, Instruction]]:
    """Every instruction with its parsed document."""
    documents = parser.parse_batch([instruction.text for instruction in instructions])
    return [(Observed(document, gazetteer), i) for document, i in zip(documents, instructions, strict=True)]
