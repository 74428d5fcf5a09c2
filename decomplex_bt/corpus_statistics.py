"""Statistics of a corpus: how many instructions and tasks, of which types, in which structures of control flow."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean, stdev
from typing import Any, get_args

from decomplex_bt.corpus import VOICES_FILE, Example, Split, read_corpus, read_voices
from decomplex_bt.corpus_structures import COMPLEX, STRUCTURES
from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import DataFileError, ImpossibleGoalError, UnknownWordError
from decomplex_bt.instruction import Instruction
from decomplex_bt.planning.phrases import read_phrases
from decomplex_bt.planning.prepositions import split_preposition

__all__ = ["COMPLEX", "STRUCTURES", "CorpusStatistics", "Counts", "corpus_statistics", "count"]

ENTITY_ARGUMENTS = ("object", "goal", "source", "location", "recipient")
"""Argument types whose values name something that is in a house, or is not."""
_JOINTS = re.compile(r"\s*(?:,|;|&|\b(?:and|or|nor|plus|as well as)\b)\s*")
_AFTER_HEAD = re.compile(r"\s(?:of|that|which|who|whose|where|so that|because|if|to|for|with|without)\s.*$")
_NO_NOUNS = frozenset(
    "it its them they he him she her hers i me you your us we this that these those one ones another other others some "
    "any none all both each either everything anything something nothing everyone everybody someone somebody anyone "
    "anybody nobody myself yourself whoever whatever what mine yours same rest half first second third two three four "
    "five six there here in out up down off on back inside outside upstairs downstairs away home the a an".split()
)
"""Last words of a phrase that are no noun of their own: pronouns, numbers, adverbs."""


@dataclass(frozen=True, slots=True)
class Counts:
    """What is counted of some instructions.

    `tasks_sd`: sample standard deviation, 0 for fewer than two; `complex_mean`: mean tasks of those with two or more.
    `lengths`: how many instructions have so many tasks. `structures`: how many instructions have each of `STRUCTURES`
    at least once. `out_of_house`: share, from 0 to 1, of the phrases for things, places and people that name nothing in
    the domain's house; `unknown_nouns`: of their head nouns that are no word of the house, whatever their adjectives.
    """

    instructions: int
    tasks: int
    tasks_mean: float
    tasks_sd: float
    complex_mean: float
    lengths: Mapping[int, int]
    task_types: Mapping[str, int]
    argument_types: Mapping[str, int]
    structures: Mapping[str, int]
    out_of_house: float
    unknown_nouns: float

    def to_json(self) -> dict[str, Any]:
        return {
            "instructions": self.instructions,
            "tasks": self.tasks,
            "tasks_per_instruction": {
                "mean": round(self.tasks_mean, 3),
                "sd": round(self.tasks_sd, 3),
                "mean_of_complex": round(self.complex_mean, 3),
            },
            "instructions_by_tasks": {str(tasks): number for tasks, number in self.lengths.items()},
            "task_types": dict(self.task_types),
            "argument_types": dict(self.argument_types),
            "structures": dict(self.structures),
            "out_of_house": round(self.out_of_house, 4),
            "unknown_nouns": round(self.unknown_nouns, 4),
        }


@dataclass(frozen=True, slots=True)
class CorpusStatistics:
    """The counts of a whole corpus, by split and by voice (no splits without a `voices.yaml`)."""

    whole: Counts
    splits: Mapping[str, Counts]
    voices: Mapping[str, Counts]

    def to_json(self) -> dict[str, Any]:
        return {
            "all": self.whole.to_json(),
            "splits": {name: counts.to_json() for name, counts in self.splits.items()},
            "voices": {name: counts.to_json() for name, counts in self.voices.items()},
        }

    def voice_table(self) -> str:
        """A line for each voice, for all in the end: instructions, those of two or more tasks, tasks, their mean, and
        the shares of phrases and nouns not in the house."""
        lines = [f"{'voice':<14}{'instructions':>13}{'complex':>9}{'tasks':>8}{'each':>7}{'phrases':>9}{'nouns':>8}"]
        for name, counts in {**self.voices, "all": self.whole}.items():
            complex_ones = sum(number for tasks, number in counts.lengths.items() if tasks > 1)
            lines.append(
                f"{name:<14}{counts.instructions:>13}{complex_ones:>9}{counts.tasks:>8}{counts.tasks_mean:>7.2f}"
                f"{counts.out_of_house:>9.0%}{counts.unknown_nouns:>8.0%}"
            )
        return "\n".join([*lines, "", "phrases, nouns: the shares that are not in the house"])

    def __str__(self) -> str:
        columns = {"all": self.whole, **self.splits}
        rows: list[tuple[str, Callable[[Counts], str]]] = [
            ("instructions", lambda counts: str(counts.instructions)),
            ("tasks", lambda counts: str(counts.tasks)),
            ("tasks each, mean", lambda counts: f"{counts.tasks_mean:.2f}"),
            ("tasks each, sd", lambda counts: f"{counts.tasks_sd:.2f}"),
            ("tasks each, complex ones", lambda counts: f"{counts.complex_mean:.2f}"),
            ("tasks each, most", lambda counts: str(max(counts.lengths))),
            ("phrases not in the house", lambda counts: f"{counts.out_of_house:.0%}"),
            ("nouns not in the house", lambda counts: f"{counts.unknown_nouns:.0%}"),
        ]
        lines = [_row("", columns), *(_row(title, map(cell, columns.values())) for title, cell in rows)]
        for title, table in (
            ("instructions with so many tasks", "lengths"),
            ("structures", "structures"),
            ("task types", "task_types"),
            ("argument types", "argument_types"),
        ):
            lines += ["", title]
            for key in getattr(self.whole, table):
                lines.append(_row(f"  {key}", (str(getattr(counts, table).get(key, 0)) for counts in columns.values())))
        return "\n".join(lines)


def corpus_statistics(path: Path, domain: Domain) -> CorpusStatistics:
    """Counts a corpus file or folder. Raises `DataFileError` where it cannot be read."""
    examples = read_corpus(path, domain.ontology)
    if not examples:
        raise DataFileError(path, "there is no instruction in it")
    split_of: dict[str, str] = {}
    if (path / VOICES_FILE).is_file():
        split_of = {name: voice.split for name, voice in read_voices(path).items()}
    seen = [(example, _observe(example.instruction)) for example in examples]
    words = _Words(domain)
    by_split = _grouped(seen, lambda e: split_of.get(e.voice, ""))
    by_voice = _grouped(seen, lambda e: e.voice)
    return CorpusStatistics(
        _add([facts for _, facts in seen], domain, words),
        {split: _add(by_split[split], domain, words) for split in (*get_args(Split), "") if split in by_split},
        {voice: _add(facts, domain, words) for voice, facts in by_voice.items()},
    )


def count(examples: Sequence[Example], domain: Domain) -> Counts:
    """Counts these examples, of which there is at least one."""
    return _add([_observe(example.instruction) for example in examples], domain, _Words(domain))


@dataclass(frozen=True, slots=True)
class _Facts:
    """What is counted of one instruction; `phrases` are the values that may name something in a house."""

    task_types: tuple[str, ...]
    argument_types: tuple[str, ...]
    structures: frozenset[str]
    phrases: tuple[str, ...]


def _observe(instruction: Instruction) -> _Facts:
    arguments = [argument for task in instruction.tasks for argument in task.arguments]
    return _Facts(
        tuple(task.type for task in instruction.tasks),
        tuple(argument.type for argument in arguments),
        frozenset(name for name, has in STRUCTURES.items() if has(instruction)),
        tuple(argument.value for argument in arguments if argument.type in ENTITY_ARGUMENTS),
    )


def _add(facts: Sequence[_Facts], domain: Domain, words: _Words) -> Counts:
    lengths = [len(one.task_types) for one in facts]
    phrases = [phrase for one in facts for phrase in one.phrases]
    nouns = [noun for phrase in phrases for noun in words.nouns(phrase)]
    return Counts(
        instructions=len(facts),
        tasks=sum(lengths),
        tasks_mean=fmean(lengths),
        tasks_sd=stdev(lengths) if len(lengths) > 1 else 0.0,
        complex_mean=fmean([length for length in lengths if length > 1] or [0]),
        lengths=dict(sorted(Counter(lengths).items())),
        task_types=_counted(domain.ontology.task_types, (name for one in facts for name in one.task_types)),
        argument_types=_counted(domain.ontology.argument_types, (name for one in facts for name in one.argument_types)),
        structures=_counted(STRUCTURES, (name for one in facts for name in one.structures)),
        out_of_house=sum(not words.is_in_house(phrase) for phrase in phrases) / len(phrases) if phrases else 0.0,
        unknown_nouns=sum(not words.is_known(noun) for noun in nouns) / len(nouns) if nouns else 0.0,
    )


class _Words:
    """What the words of a house say about phrases; each phrase is looked at once."""

    def __init__(self, domain: Domain) -> None:
        self._domain = domain
        self._in_house: dict[str, bool] = {}
        self._nouns: dict[str, tuple[str, ...]] = {}

    def is_in_house(self, phrase: str) -> bool:
        """Whether a phrase names something that the domain's house has, or the user."""
        if phrase not in self._in_house:
            self._in_house[phrase] = self._find(phrase)
        return self._in_house[phrase]

    def nouns(self, phrase: str) -> tuple[str, ...]:
        """The head nouns of a phrase, in lower case: the last word of each part, before "of …" and clauses."""
        if phrase not in self._nouns:
            self._nouns[phrase] = tuple(self._heads(phrase))
        return self._nouns[phrase]

    def is_known(self, noun: str) -> bool:
        """Whether a word, or what it is the plural of, is a noun of the house."""
        entities, plurals = self._domain.nouns.lookup(noun)
        return bool(entities or plurals)

    def _find(self, phrase: str) -> bool:
        if split_preposition(phrase, self._domain)[1] in self._domain.lexicon.user_words:
            return True
        try:
            read_phrases(phrase, self._domain)
        except UnknownWordError:
            return False
        except ImpossibleGoalError:
            return True  # its words are known, whatever they ask for
        return True

    def _heads(self, phrase: str) -> Iterable[str]:
        rest = split_preposition(phrase, self._domain)[1]
        for part in _JOINTS.split(_AFTER_HEAD.sub("", rest)):
            words = self._before_place(part).split()
            while len(words) > 1 and words[-1] in self._domain.lexicon.determiners and not self.is_known(words[-1]):
                words.pop()
            noun = re.sub(r"'s?$", "", words[-1]) if words else ""
            if noun and noun not in _NO_NOUNS and not noun.isdigit():
                yield noun

    def _before_place(self, part: str) -> str:
        """A part of a phrase without the place that follows its noun ("the cup on the shelf")."""
        rest = split_preposition(part, self._domain)[1]
        words = rest.split()
        for i in range(1, len(words)):
            if split_preposition(" ".join(words[i:]), self._domain)[0] and words[i] not in ("back", "left"):
                return " ".join(words[:i])
        return rest


def _grouped(seen: Iterable[tuple[Example, _Facts]], key: Callable[[Example], str]) -> dict[str, list[_Facts]]:
    groups: dict[str, list[_Facts]] = {}
    for example, facts in seen:
        if name := key(example):
            groups.setdefault(name, []).append(facts)
    return groups


def _counted(known: Iterable[str], found: Iterable[str]) -> dict[str, int]:
    counter = Counter(found)
    return {name: counter[name] for name in known}


def _row(title: object, cells: Iterable[str]) -> str:
    return f"{title:<31}" + "".join(f"{cell:>12}" for cell in cells)
