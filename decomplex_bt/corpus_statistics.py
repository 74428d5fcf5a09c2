"""Statistics of a corpus: how many instructions and tasks, of which types, in which structures of control flow."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean, stdev
from typing import Any

from decomplex_bt.corpus import VOICES_FILE, Example, read_corpus, read_voices
from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import DataFileError, UnknownWordError
from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.instruction import Instruction
from decomplex_bt.planning.phrases import read_phrases, split_preposition

ENTITY_ARGUMENTS = ("object", "goal", "source", "location", "recipient")
"""Argument types whose values name something that is in a house, or is not."""
COMPLEX = "complex"


@dataclass(frozen=True, slots=True)
class Counts:
    """What is counted of some instructions.

    `tasks_sd`: sample standard deviation, 0 for fewer than two. `structures`: how many instructions have each of
    `STRUCTURES` at least once. `out_of_house`: share, from 0 to 1, of the phrases for things, places and people that
    name nothing in the domain's house.
    """

    instructions: int
    tasks: int
    tasks_mean: float
    tasks_sd: float
    task_types: Mapping[str, int]
    argument_types: Mapping[str, int]
    structures: Mapping[str, int]
    out_of_house: float

    def to_json(self) -> dict[str, Any]:
        return {
            "instructions": self.instructions,
            "tasks": self.tasks,
            "tasks_per_instruction": {"mean": round(self.tasks_mean, 3), "sd": round(self.tasks_sd, 3)},
            "task_types": dict(self.task_types),
            "argument_types": dict(self.argument_types),
            "structures": dict(self.structures),
            "out_of_house": round(self.out_of_house, 4),
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

    def __str__(self) -> str:
        columns = {"all": self.whole, **self.splits, **self.voices}
        rows: list[tuple[str, Callable[[Counts], str]]] = [
            ("instructions", lambda counts: str(counts.instructions)),
            ("tasks", lambda counts: str(counts.tasks)),
            ("tasks each, mean", lambda counts: f"{counts.tasks_mean:.2f}"),
            ("tasks each, sd", lambda counts: f"{counts.tasks_sd:.2f}"),
            ("not in the house", lambda counts: f"{counts.out_of_house:.0%}"),
        ]
        lines = [_row("", columns), *(_row(title, map(cell, columns.values())) for title, cell in rows)]
        for title, table in (
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
    return CorpusStatistics(
        count(examples, domain),
        {split: count(some, domain) for split, some in _grouped(examples, lambda e: split_of.get(e.voice, "")).items()},
        {voice: count(some, domain) for voice, some in _grouped(examples, lambda e: e.voice).items()},
    )


def count(examples: Sequence[Example], domain: Domain) -> Counts:
    """Counts these examples, of which there is at least one."""
    instructions = [example.instruction for example in examples]
    lengths = [len(instruction.tasks) for instruction in instructions]
    tasks = [task for instruction in instructions for task in instruction.tasks]
    arguments = [argument for task in tasks for argument in task.arguments]
    phrases = [argument.value for argument in arguments if argument.type in ENTITY_ARGUMENTS]
    unknown = sum(not _is_in_house(phrase, domain) for phrase in phrases)
    return Counts(
        instructions=len(instructions),
        tasks=len(tasks),
        tasks_mean=fmean(lengths),
        tasks_sd=stdev(lengths) if len(lengths) > 1 else 0.0,
        task_types=_counted(domain.ontology.task_types, (task.type for task in tasks)),
        argument_types=_counted(domain.ontology.argument_types, (argument.type for argument in arguments)),
        structures={name: sum(map(has, instructions)) for name, has in STRUCTURES.items()},
        out_of_house=unknown / len(phrases) if phrases else 0.0,
    )


def _is_in_house(phrase: str, domain: Domain) -> bool:
    """Whether a phrase names something that the domain's house has, or the user."""
    if split_preposition(phrase, domain)[1] in domain.lexicon.user_words:
        return True
    try:
        read_phrases(phrase, domain)
    except UnknownWordError:
        return False
    return True


def _nodes(instruction: Instruction) -> list[Node]:
    return [node for node, _ in instruction.flow.walk()]


def _conditions(instruction: Instruction) -> list[If]:
    return [node for node in _nodes(instruction) if isinstance(node, If)]


def _is_nested(instruction: Instruction) -> bool:
    return any(isinstance(node, If) and place != "top" for node, place in instruction.flow.walk())


def _has_mentions(instruction: Instruction) -> bool:
    return any(len(node.tasks) > 1 for node in _nodes(instruction))


def _has_repeat(instruction: Instruction) -> bool:
    return any(isinstance(node, Do) and node.is_repeat for node in _nodes(instruction))


def _is_out_of_order(instruction: Instruction) -> bool:
    """Whether steps come in another order than in the text; a condition said after its branch is not meant."""
    return any(order != sorted(order) for order in _orders(instruction.flow))


def _orders(flow: Flow) -> Iterable[list[int]]:
    yield [_earliest(node) for node in flow.nodes]
    for node, _ in flow.walk():
        if isinstance(node, If):
            yield [_earliest(child) for child in node.then]
            yield [_earliest(child) for child in node.orelse]


def _earliest(node: Node) -> int:
    if isinstance(node, Do):
        return node.task
    return min([*node.tasks, *(_earliest(child) for child in (*node.then, *node.orelse))])


STRUCTURES: Mapping[str, Callable[[Instruction], bool]] = {
    COMPLEX: lambda instruction: len(instruction.tasks) > 1,
    "with a condition": lambda instruction: bool(_conditions(instruction)),
    "with an else": lambda instruction: any(node.orelse for node in _conditions(instruction)),
    "with several conditions": lambda instruction: len(_conditions(instruction)) > 1,
    "with a nested condition": _is_nested,
    "with merged mentions": _has_mentions,
    "with a repeat": _has_repeat,
    "out of order": _is_out_of_order,
    "with a reference": lambda instruction: any(
        argument.span is not None and argument.value != argument.span.of(instruction.text)
        for task in instruction.tasks
        for argument in task.arguments
    ),
    "with an implied argument": lambda instruction: any(
        argument.span is None for task in instruction.tasks for argument in task.arguments
    ),
}
"""Structures by name, with what an instruction that has it looks like."""


def _grouped(examples: Sequence[Example], key: Callable[[Example], str]) -> dict[str, list[Example]]:
    groups: dict[str, list[Example]] = {}
    for example in examples:
        if name := key(example):
            groups.setdefault(name, []).append(example)
    return groups


def _counted(known: Iterable[str], found: Iterable[str]) -> dict[str, int]:
    counter = Counter(found)
    return {name: counter[name] for name in known}


def _row(title: str, cells: Iterable[str]) -> str:
    return f"{title:<26}" + "".join(f"{cell:>13}" for cell in cells)
