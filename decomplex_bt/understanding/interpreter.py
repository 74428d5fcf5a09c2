"""The interpreter: text in, an understood `Instruction` out; the chain of all stages."""

from __future__ import annotations

import pickle
from collections import Counter
from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from importlib.util import find_spec
from itertools import islice
from pathlib import Path
from threading import Lock
from typing import TypeVar

from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.domain.verbs import sense_of
from decomplex_bt.errors import InputError, check_jobs, quoted
from decomplex_bt.flow import Flow
from decomplex_bt.hesitation import without_hesitation
from decomplex_bt.instruction import Alternative, Argument, Instruction, Span, Task
from decomplex_bt.processes import results
from decomplex_bt.understanding.advice import missing_arguments, warnings_of
from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.confidence import CALIBRATION_FILE, Belief, Calibration, belief_of, shrunk
from decomplex_bt.understanding.coreference import REFERENCES_FILE, Hints, ReferenceModel
from decomplex_bt.understanding.damage import ENCODER_FOLDER
from decomplex_bt.understanding.dependencies import FlowModel
from decomplex_bt.understanding.document import Document, Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.manifest import check_encoder, check_language, check_models
from decomplex_bt.understanding.readings import Reading, ReadingModel, load_stages, readings_of
from decomplex_bt.understanding.references.effects import with_effects, with_tries, without_outcomes
from decomplex_bt.understanding.references.errands import with_things_asked
from decomplex_bt.understanding.references.messages import with_messages
from decomplex_bt.understanding.references.unsaid_recipients import with_speaker
from decomplex_bt.understanding.references.weather import with_weather
from decomplex_bt.understanding.remainder import restored, without
from decomplex_bt.understanding.retelling import retold
from decomplex_bt.understanding.rules.cases.checks import naming
from decomplex_bt.understanding.rules.ellipses.likewise import CARRIERS
from decomplex_bt.understanding.rules.ellipses.pro_verbs import with_doings
from decomplex_bt.understanding.rules.orders.assurances import with_denied
from decomplex_bt.understanding.rules.spans.completion import answered, completed, reported, retracted
from decomplex_bt.understanding.rules.spans.levels import with_levels
from decomplex_bt.understanding.rules.spans.relatives import without_stated
from decomplex_bt.understanding.rules.speech.marks import marked
from decomplex_bt.understanding.rules.speech.repairs import repaired
from decomplex_bt.understanding.spelling import WORDS_FILE, Speller
from decomplex_bt.understanding.tasks import FoundTask

MAX_CHARACTERS = 2000
"""The longest instruction that is read [code points]."""

LIKELY = 0.5
"""The confidence from which on an argument stands beside a surer one of its type."""

MOST_REPAIRS = 3
"""How often what is left without repairs is looked through for further ones."""

CHUNK = 64
"""How many texts of a batch a process reads at a time."""

_Item = TypeVar("_Item")


class Interpreter:
    """Understands instructions of one domain with its trained models, for threads that share it one at a time."""

    def __init__(self, domain: Domain, models: Path, parser: Parser, *, encoder: bool = False) -> None:
        check_models(models, domain)
        self.domain = domain
        self._models, self._has_encoder = models, encoder
        self._parser = parser
        self._lock = Lock()  # since a CRF answers for the sequence that it labelled last
        self._gazetteer = Gazetteer.of(domain.lexicon, domain.kinds)
        folder = models
        if encoder:
            from decomplex_bt.understanding.encoder.stages import load_encoder

            folder = models / ENCODER_FOLDER
            check_encoder(models, folder)
            self._stages = load_encoder(folder, FlowModel(models), domain)
        else:
            self._stages = load_stages(models)
        self._readings = ReadingModel(folder / "readings.json")
        self._calibration = Calibration(folder / CALIBRATION_FILE)
        self._spelling = Speller(models / WORDS_FILE).meant
        self._references = ReferenceModel(models / REFERENCES_FILE, domain.ontology)
        for read in dict.fromkeys((models, folder)):  # last, since the parser may still be loading
            check_language(read, parser.model_name)

    @classmethod
    def load(
        cls, domain: str | Path | Domain = "household", *, models: str | Path | None = None, encoder: bool | None = None
    ) -> Interpreter:
        """The interpreter of a domain, by name, folder or value; `models` defaults to the domain's own.

        `encoder`: whether the pretrained encoder reads instead of the CRFs alone, right more often and slower; None: if
        its extra is installed and the folder of models has one. Loads spaCy and the models, about a second; the result
        is kept for the process. Raises `DataFileError` where the models are missing, damaged or made by other versions,
        `LanguageModelError` where spaCy's English model is, `EncoderMissingError` where the encoder's extra is,
        `InputError` for what is no domain, no folder, or no choice of an encoder.
        """
        if not isinstance(models, str | Path | None):
            raise InputError(f"models is {models!r}; expected a folder of trained models, or None")
        if not isinstance(encoder, bool | None):
            raise InputError(f"encoder is {encoder!r}; expected True, False, or None for where it is installed")
        parser = _parser()  # which goes on loading while all else is read
        loaded = domain if isinstance(domain, Domain) else load_domain(domain)
        folder = loaded.folder / "models" if models is None else Path(models)
        if encoder is None:
            encoder = has_encoder(folder)
        return _cached(folder, loaded, encoder) if models is None else cls(loaded, folder, parser, encoder=encoder)

    def interpret(self, text: str) -> Instruction:
        """The understood instruction. Text without a known task gives one without tasks and with a warning.

        Raises `InputError` for text that is empty, longer than `MAX_CHARACTERS` or no valid Unicode.
        """
        check_text(text)
        return self._understand(self._parser.parse(text, self._spelling))

    def interpret_batch(self, texts: Iterable[str], *, jobs: int = 1) -> Iterator[Instruction]:
        """As `interpret` for many texts, in order: lazily in this process, or after all texts are there in `jobs`
        processes (-1: one a core), each of which first loads the models (seconds, once).

        Raises `InputError` for a single text, an impossible number of jobs, and, when it comes to it, at the first
        unusable text; `check_text` tells beforehand.
        """
        if isinstance(texts, str) or not isinstance(texts, Iterable):
            raise InputError(f"texts is {quoted(texts)}; expected several texts, as in [text]; `interpret` reads one")
        check_jobs(jobs)
        return self._batch(texts, jobs)

    def _batch(self, texts: Iterable[str], jobs: int) -> Iterator[Instruction]:
        usable = _checked(texts, check_text)
        if jobs == 1:
            for document in self._parser.parse_batch(usable, spelling=self._spelling):
                yield self._understand(document)
            return
        from joblib import delayed

        waiting = iter(list(usable))
        chunks = iter(lambda: tuple(islice(waiting, CHUNK)), ())
        domain = pickle.dumps(self.domain)  # as it is here, and once: a process tells by it what it has loaded
        read = delayed(partial(_interpret_chunk, domain, self._models, self._has_encoder))
        for instructions in results(map(read, chunks), jobs):
            yield from instructions

    def tokens(self, text: str) -> tuple[Span, ...]:
        """Where the tokens of a text stand; every span of a reading begins and ends with one."""
        return self._parser.tokens(text)

    def _understand(self, document: Document) -> Instruction:
        with self._lock:
            return self._understood(document)

    def _understood(self, document: Document) -> Instruction:
        left = document
        places: Sequence[int] = range(len(document.text))
        plain = marked(document)
        if plain is not None:
            left, places = self._parser.parse(plain.text, self._spelling), plain.places
        for _ in range(MOST_REPAIRS):
            cut = repaired(left)
            if not cut:
                break
            rest = without(left, cut)
            left, places = self._parser.parse(rest.text, self._spelling), [places[place] for place in rest.places]
        observed = Observed(left, self._gazetteer)
        found = self._told_in_full(observed, self._read(observed))
        return found if left is document else restored(found, document.text, places, places)

    def _told_in_full(self, observed: Observed, found: Instruction) -> Instruction:
        """As found, or as its retelling is read where that has all the orders that it tells."""
        full = retold(observed, found)
        if full is None:
            return found
        known = {task.span.start for task in found.tasks}
        again = self._read(Observed(self._parser.parse(full.told.text, self._spelling), self._gazetteer))
        if len(again.tasks) < len(found.tasks) - full.merged + len(full.verbs.keys() - known):
            return found
        whole = restored(again, observed.document.text, full.told.places, full.told.turns, full.verbs)
        numbers = {task.span.start: task.id for task in whole.tasks}
        said = {carrier: numbers.get(verb, 0) for carrier, verb in full.verbs.items()}
        tasks = (replace(task, repeats=said.get(task.span.start, 0)) for task in whole.tasks)
        return replace(whole, tasks=tuple(self._with_state(whole, task) for task in tasks))

    def _with_state(self, instruction: Instruction, task: Task) -> Task:
        """A task that leaves its verb unsaid, with the state that the verb would have told ("open"); a "do the same"
        tells it as that verb does."""
        is_said = task.value("state") is not None or task.span.of(instruction.text).lower() in CARRIERS
        if not task.repeats or task.type != "change_state" or is_said:
            return task
        sense = sense_of(instruction.verb_of(task).span.of(instruction.text), (), self.domain.lexicon)
        if sense is None or sense.state is None:
            return task
        return replace(task, arguments=(*task.arguments, Argument("state", sense.state, None, task.confidence)))

    def _read(self, observed: Observed) -> Instruction:
        document = observed.document
        ranked = self._readings.ranked(readings_of(observed, self._stages, self.domain.ontology))
        reading, belief = ranked[0][0], belief_of(ranked)
        tasks = self._references.resolve(
            observed, self._tasks_of(document, reading, belief), reading.drawn, self._hints(observed, reading)
        )
        tasks = self._settled(document, with_doings(observed, tasks), reading.drawn)
        tasks = with_things_asked(document.text, tasks, reading.drawn, reading.flow)
        certainty = self._calibration.of("flow", belief.flow)
        return Instruction(
            text=document.text,
            tasks=tuple(map(_without_hesitations, tasks)),
            flow=reading.flow,
            missing=tuple(missing_arguments(observed, tasks, reading.flow, self.domain)),
            warnings=tuple(warnings_of(observed, tasks)),
            confidence=certainty,
            alternatives=tuple(
                Alternative(flow, shrunk(chance, belief.flow, certainty)) for flow, chance in belief.flows[1:]
            ),
        )

    def _settled(self, document: Document, tasks: Sequence[Task], flow: Flow) -> tuple[Task, ...]:
        """The tasks, their values as English settles them once it is known what words refer to."""
        tasks = with_denied(document, without_stated(document, tasks), self.domain.kinds)
        tasks = without_outcomes(document, with_effects(document, tasks, self.domain.lexicon), self.domain.lexicon)
        tasks = with_tries(document, tasks, flow, self.domain.lexicon)
        tasks = with_levels(document, with_weather(document, with_speaker(document, tasks), flow))
        return with_messages(document, tasks, flow)

    def _hints(self, observed: Observed, reading: Reading) -> Hints | None:
        if self._stages.references is None:
            return None
        return partial(self._stages.references.scores, observed, {task.token: task.type for task in reading.tasks})

    def _tasks_of(self, document: Document, reading: Reading, belief: Belief) -> list[Task]:
        certainty = self._calibration.of
        return [
            Task(
                number,
                task.type,
                document.span(task.token, task.token),
                self._arguments_of(document, reading, belief, task),
                certainty("task", belief.tasks[task.token]),
                certainty("dependency", belief.dependencies[task.token]),
            )
            for number, task in enumerate(reading.tasks, start=1)
        ]

    def _arguments_of(
        self, document: Document, reading: Reading, belief: Belief, of: FoundTask
    ) -> tuple[Argument, ...]:
        taken = {task.token for task in reading.tasks}.union(*(argument.tokens for argument in reading.arguments))
        own = [argument for argument in reading.arguments if argument.owner == of.token]
        chance = {argument.tokens.start: belief.arguments[argument] for argument in own}
        own = retracted(document, answered(document, of.token, own))
        if of.type == "informing":
            own = reported(own)
        elif of.type == "check_state":
            own = naming(document, of.token, own)
        chances = [self._calibration.of("argument", chance[argument.tokens.start]) for argument in own]
        found = [_argument(document, a, chance, taken) for a, chance in zip(own, chances, strict=True)]
        is_having = of.type == "check_state" and document.tokens[of.token].lemma in ("have", "get")
        is_somewhere = any(a.type == "location" for a in found)  # what has it is not where it is
        return without_rivals(found, document.tokens[of.token].start if is_having and is_somewhere else 0)


def check_text(text: str) -> None:
    """Raises `InputError` where `text` cannot be an instruction: no text, empty, too long, or no valid Unicode."""
    if not isinstance(text, str):
        raise InputError(f"the instruction is {quoted(text)}; expected a text such as 'Bring me a cup.'")
    if not text.strip():
        raise InputError("the instruction is empty; expected a sentence such as 'Bring me a cup.'")
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"the instruction has {len(text)} characters; expected at most {MAX_CHARACTERS}; split it")
    if any("\ud800" <= character <= "\udfff" for character in text):
        raise InputError("the instruction holds half of a surrogate pair; expected valid Unicode text")


def _argument(document: Document, argument: FoundArgument, confidence: float, taken: Container[int]) -> Argument:
    tokens = completed(document, argument.tokens, taken)
    span = document.span(tokens.start, tokens.stop - 1)
    return Argument(argument.type, span.of(document.text), span, confidence)


def _without_hesitations(task: Task) -> Task:
    return replace(
        task, arguments=tuple(replace(each, value=without_hesitation(each.value)) for each in task.arguments)
    )


def without_rivals(arguments: Sequence[Argument], check: int = 0) -> tuple[Argument, ...]:
    """The arguments of a task, of which it keeps two of one type only where both are likely: "the cup, and the plate,
    too" happens, but where one of the two is doubtful it is a misreading. Two each of two types ("the pan in the oven
    and the lid on the stove") are no rivals, nor are who has something and what that is, on both sides of a verb at the
    character `check` ("if *it* has *my name* on it")."""
    sides = {a.span.start < check for a in arguments if a.type == "object" and a.span is not None}
    if check and len(sides) > 1:
        others = without_rivals([argument for argument in arguments if argument.type != "object"])
        return (*(argument for argument in arguments if argument.type == "object"), *others)
    counts = Counter(argument.type for argument in arguments)
    if sum(count > 1 for count in counts.values()) > 1:
        return tuple(arguments)
    surest = {argument.type: argument for argument in sorted(arguments, key=lambda a: a.confidence)}
    return tuple(a for a in arguments if a.confidence >= LIKELY or a is surest[a.type])


def _checked(items: Iterable[_Item], check: Callable[[_Item], None]) -> Iterator[_Item]:
    for item in items:
        check(item)
        yield item


@lru_cache(maxsize=1)
def _parser() -> Parser:
    return Parser()


@lru_cache(maxsize=4)
def _cached(models: Path, domain: Domain, encoder: bool) -> Interpreter:
    return Interpreter(domain, models, _parser(), encoder=encoder)


@lru_cache(maxsize=2)
def _loaded_here(domain: bytes, models: Path, encoder: bool) -> Interpreter:
    """As `Interpreter.load` of a pickled domain, kept for a process that reads chunks of a batch."""
    return Interpreter.load(pickle.loads(domain), models=models, encoder=encoder)


def _interpret_chunk(domain: bytes, models: Path, encoder: bool, texts: tuple[str, ...]) -> list[Instruction]:
    return list(_loaded_here(domain, models, encoder).interpret_batch(texts))


def has_encoder(models: Path) -> bool:
    """Whether a folder of models has an encoder, and the packages that run it are installed."""
    return (models / ENCODER_FOLDER).is_dir() and all(find_spec(name) for name in ("onnxruntime", "tokenizers"))
