"""HuRIC 2.1, read: frames become tasks, frame elements arguments, by the rules in the domain's `huric.yaml`.

HuRIC says no control flow, no conditions and no referents. Flow: the tasks in text order. Referents: a pronoun means
the nearest thing named before it. Where HuRIC is inconsistent it is brought to the corpus' conventions: a place inside
a Theme ("the knife on the table") becomes an argument of its own, as does the place of a relative clause or of a
statement beside the command (frame Being_located), each at the nearest task; a Theme ends before its relative clause; a
copula is no part of a state; "to me" as Goal is a recipient; subjects are left out; "there 's" is written "there's"; a
verb with two frames ("go to the kitchen and then in the bathroom") is one task.
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from pydantic import model_validator

from decomplex_bt.corpus import Example
from decomplex_bt.domain.document import Record, read_record
from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.formats.annotation import annotated
from decomplex_bt.instruction import Argument, Span, Task

SUFFIX = ".hrc"
RULES_FILE = "huric.yaml"
PLACE, THEME = "place", "theme"


class FrameCase(Record):
    """How a frame is read where this case fits; see `huric.yaml`."""

    verbs: tuple[str, ...] = ()
    has: str | None = None
    stated: tuple[str, ...] = ()
    is_task: bool = True
    task: str | None = None
    elements: dict[str, str | None]
    split: tuple[str, ...] = ()


class Rules(Record):
    """`huric.yaml`."""

    format: int
    persons: tuple[str, ...]
    relatives: tuple[str, ...]
    copulas: tuple[str, ...]
    pronouns: tuple[str, ...]
    place_prepositions: tuple[str, ...]
    determiners: tuple[str, ...]
    told: dict[str, str]
    frames: dict[str, tuple[FrameCase, ...]]

    @model_validator(mode="after")
    def _check(self) -> Rules:
        for name, cases in self.frames.items():
            if not cases or cases[-1].verbs or cases[-1].has or cases[-1].stated:
                raise ValueError(f"the last case of frame {name!r} must fit whatever the others do not")
        return self


@dataclass(slots=True)
class _Element:
    """A frame element in token indices; `head` is its semantic head, its last token where HuRIC names none."""

    type: str
    tokens: range
    head: int


@dataclass(slots=True)
class _Frame:
    name: str
    verb: int
    elements: list[_Element]


@dataclass(slots=True)
class _Found:
    """A task in the making: arguments as (type, tokens)."""

    type: str
    verb: int
    arguments: list[tuple[str, range]] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class _Told:
    """A place told beside a command, with the verb it is told by and the thing that is there."""

    verb: int
    place: range
    theme: range | None


def read_huric(path: Path, domain: Domain) -> tuple[Example, ...]:
    """The examples of a `.hrc` file, or of all of them in a folder and below, sorted; the voice is a file's folder.

    Raises `DataFileError` where a file is no HuRIC 2.1, or has a frame or element that `huric.yaml` does not know.
    """
    rules = read_record(domain.folder / RULES_FILE, Rules)
    if not path.is_dir():
        return (_read(path, rules, domain),)
    files = sorted(path.rglob(f"*{SUFFIX}"))
    if not files:
        raise DataFileError(path, f"the folder holds no HuRIC file (*{SUFFIX})")
    examples: dict[tuple[str, str], Example] = {}
    for file in files:
        example = _read(file, rules, domain)
        if (example.voice, example.id) in examples:
            raise DataFileError(file, f"example {example.id!r}: this id stands twice in {example.voice!r}")
        examples[example.voice, example.id] = example
    return tuple(examples.values())


def _read(path: Path, rules: Rules, domain: Domain) -> Example:
    try:
        root = ElementTree.fromstring(path.read_bytes())
    except ElementTree.ParseError as error:
        raise DataFileError(path, f"not valid XML: {error}") from None
    except OSError as error:
        raise DataFileError(path, f"cannot be read: {error.strerror}") from None
    commands = root.findall("commands/command")
    if root.tag != "huricExample" or len(commands) != 1:
        raise DataFileError(path, f"expected a huricExample with one command, got {root.tag} with {len(commands)}")
    try:
        return _Command(commands[0], rules, domain).example(root.get("id") or path.stem, path)
    except InputError as error:
        raise DataFileError(path, str(error)) from None


class _Command:
    """One command on its way to an example."""

    def __init__(self, command: ElementTree.Element, rules: Rules, domain: Domain) -> None:
        self._rules = rules
        self._ontology = domain.ontology
        self._words = [_attribute(token, "surface") for token in command.findall("tokens/token")]
        self._lemmas = [token.get("lemma", "") for token in command.findall("tokens/token")]
        ids = [_attribute(token, "id") for token in command.findall("tokens/token")]
        self._index = {key: i for i, key in enumerate(ids)}
        self.text, self._spans = _joined(self._words)
        self._frames = sorted(map(self._frame, command.findall("semantics/frames/frame")), key=lambda f: f.verb)
        self._tasks: list[_Found] = []
        self._told: list[_Told] = []
        self._named: list[range] = []

    def example(self, name: str, path: Path) -> Example:
        for frame in self._frames:
            self._take(frame)
        for told in self._told:
            self._tell(told)
        tasks = [self._task(number, found) for number, found in enumerate(self._tasks, start=1)]
        instruction = annotated(self.text, tasks, [task.id for task in tasks], self._ontology)
        return Example(name, instruction, path.parent.name or "huric", f"HuRIC 2.1 {path.parent.name}/{path.stem}")

    def _frame(self, element: ElementTree.Element) -> _Frame:
        name = _attribute(element, "name")
        if name not in self._rules.frames:
            raise InputError(f"unknown frame {name!r}; {RULES_FILE} knows {', '.join(self._rules.frames)}")
        verbs = self._tokens(element.findall("lexicalUnit/token"), f"the lexical unit of {name}")
        elements = []
        for child in element.findall("frameElements/frameElement"):
            kind = _attribute(child, "type")
            tokens = self._tokens(child.findall("token"), f"{name}.{kind}")
            head = self._index.get(child.get("semanticHead", ""), tokens.stop - 1)
            elements.append(_Element(kind, tokens, head if head in tokens else tokens.stop - 1))
        return _Frame(name, verbs.start, elements)

    def _tokens(self, tokens: Sequence[ElementTree.Element], name: str) -> range:
        keys = [_attribute(token, "id") for token in tokens]
        unknown = [key for key in keys if key not in self._index]
        if unknown or not keys:
            raise InputError(f"{name} has {'no token' if not keys else f'the unknown token {unknown[0]!r}'}")
        places = [self._index[key] for key in keys]
        return range(min(places), max(places) + 1)

    def _take(self, frame: _Frame) -> None:
        case = self._case(frame)
        arguments: list[tuple[str, range]] = []
        places: list[range] = []
        theme: range | None = None
        for element in frame.elements:
            if element.type not in case.elements:
                known = ", ".join(case.elements)
                raise InputError(f"unknown element {element.type!r} of frame {frame.name}; {RULES_FILE} knows {known}")
            kind = case.elements[element.type]
            if kind == THEME:
                theme = element.tokens
            elif kind == PLACE:
                places.append(element.tokens)
            elif kind is not None:
                tokens, place = self._trimmed(element, is_split=element.type in case.split)
                arguments.append((kind, tokens))
                places += [place] if place else []
        if case.is_task:
            same = next((found for found in self._tasks if found.verb == frame.verb), None)
            if same is None:
                same = _Found(case.task or self._type_of(frame.name), frame.verb)
                self._tasks.append(same)
            same.arguments += _merged(arguments)
        for place in places:
            self._told.append(_Told(frame.verb, place, theme))
        if theme is not None and not self._refers(theme):
            self._named.append(theme)

    def _case(self, frame: _Frame) -> FrameCase:
        between = self._words[frame.verb - 1].lower() if frame.verb > 1 else ""
        subject = self._words[frame.verb - 2].lower() if frame.verb > 1 else ""
        for case in self._rules.frames[frame.name]:
            if case.verbs and self._lemmas[frame.verb] not in case.verbs:
                continue
            if case.has and case.has not in {element.type for element in frame.elements}:
                continue
            if case.stated and not (subject == "you" and between in case.stated):
                continue
            return case
        raise AssertionError("the last case fits")

    def _type_of(self, frame: str) -> str:
        for name, task_type in self._ontology.task_types.items():
            if frame in task_type.frames:
                return name
        raise InputError(f"no task type of the ontology lists the frame {frame!r}")

    def _trimmed(self, element: _Element, *, is_split: bool) -> tuple[range, range | None]:
        """The element's tokens without relative clause, and the place cut off behind its head."""
        tokens = element.tokens
        for i in tokens[1:]:
            if self._words[i].lower() in self._rules.relatives:
                tokens = range(tokens.start, i)
                break
        if is_split:
            for i in range(max(element.head, tokens.start) + 1, tokens.stop - 1):
                if self._words[i].lower() in self._rules.place_prepositions:
                    return range(tokens.start, i), range(i, tokens.stop)
        return tokens, None

    def _tell(self, told: _Told) -> None:
        """Gives a place to the nearest task at or before its verb, else to the first after it."""
        before = [found for found in self._tasks if found.verb <= told.verb]
        after = [found for found in self._tasks if found.verb > told.verb]
        if not before and not after:
            return
        found = before[-1] if before else after[0]
        if told.theme is not None and not self._refers(told.theme):
            found.arguments = [
                (kind, told.theme if kind == "object" and told.theme[0] in tokens else tokens)
                for kind, tokens in found.arguments
            ]
        kind = self._rules.told.get(found.type, "location")
        if kind in self._ontology.task_types[found.type].arguments:
            found.arguments.append((kind, told.place))

    def _task(self, number: int, found: _Found) -> Task:
        arguments: list[Argument] = []
        taken = {task.verb for task in self._tasks}
        for kind, tokens in sorted(found.arguments, key=lambda argument: argument[1].start):
            tokens = self._without_copula(tokens) if kind == "state" else tokens
            if not tokens or taken & set(tokens):
                continue
            taken |= set(tokens)
            kind = self._recipient(kind, tokens, found.type)
            span = Span(self._spans[tokens.start].start, self._spans[tokens.stop - 1].end)
            arguments.append(Argument(kind, self._value(kind, tokens, span), span))
        return Task(number, found.type, self._spans[found.verb], tuple(arguments))

    def _without_copula(self, tokens: range) -> range:
        while tokens and self._words[tokens.start].lower() in self._rules.copulas:
            tokens = tokens[1:]
        return tokens

    def _recipient(self, kind: str, tokens: range, task_type: str) -> str:
        is_person = len(tokens) <= 2 and self._words[tokens.stop - 1].lower() in self._rules.persons
        takes_one = "recipient" in self._ontology.task_types[task_type].arguments
        return "recipient" if kind == "goal" and is_person and takes_one else kind

    def _value(self, kind: str, tokens: range, span: Span) -> str:
        if kind in ("object", "location") and self._refers(tokens):
            before = [t for t in self._nameable(("object",), tokens) + self._named if t.stop <= tokens.start]
            before = before or self._nameable(("goal", "location"), tokens)
            if before:
                phrase = self._without_preposition(max(before, key=lambda t: t.start))
                return self.text[self._spans[phrase.start].start : self._spans[phrase.stop - 1].end]
        return span.of(self.text)

    def _nameable(self, kinds: Sequence[str], tokens: range) -> list[range]:
        """The arguments of these types before these tokens that are no pronouns."""
        arguments = [argument for found in self._tasks for argument in found.arguments]
        return [t for k, t in arguments if k in kinds and t.stop <= tokens.start and not self._refers(t)]

    def _without_preposition(self, tokens: range) -> range:
        for i in tokens:
            if self._words[i].lower() in self._rules.determiners:
                return range(i, tokens.stop)
        return tokens

    def _refers(self, tokens: range) -> bool:
        return len(tokens) <= 2 and self._words[tokens.stop - 1].lower() in self._rules.pronouns


def _joined(words: Sequence[str]) -> tuple[str, list[Span]]:
    """The words as a text with the span of each; what an apostrophe begins is written to the word before it."""
    text, spans = "", []
    for word in words:
        text += " " if text and not word.startswith("'") and word != "n't" else ""
        spans.append(Span(len(text), len(text) + len(word)))
        text += word
    return text, spans


def _merged(arguments: Sequence[tuple[str, range]]) -> list[tuple[str, range]]:
    """The arguments, of which neighbouring objects are one ("the remote" "for the television")."""
    merged: list[tuple[str, range]] = []
    for kind, tokens in sorted(arguments, key=lambda argument: argument[1].start):
        if merged and merged[-1][0] == kind == "object" and merged[-1][1].stop == tokens.start:
            merged[-1] = (kind, range(merged[-1][1].start, tokens.stop))
        else:
            merged.append((kind, tokens))
    return merged


def _attribute(element: ElementTree.Element, name: str) -> str:
    value = element.get(name)
    if not value:
        raise InputError(f"a <{element.tag}> has no {name!r}; is this HuRIC 2.1?")
    return value


def single_tasks(examples: Sequence[Example]) -> Iterator[Example]:
    """Those that hold exactly one task, as the DeComplex paper takes them (section IV-A)."""
    return (example for example in examples if len(example.instruction.tasks) == 1)
