"""What each choice of the interpreter gains: every row leaves one out, trains on the train voices and scores the
development voices.

    python benchmarks/ablation.py [--stages tasks arguments flow] [--json FILE]

Each stage is judged alone, with everything before it as annotated, and but for one row learnt from the texts without
their noised copies. Half an hour for tasks and arguments, ten minutes for the flow. The test voices are never read.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

import numpy as np

from decomplex_bt.corpus import read_corpus, read_voices
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding import arguments, dependencies, tasks
from decomplex_bt.understanding.damage import ENCODER_FOLDER
from decomplex_bt.understanding.disturbances import with_fillers
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.encoder.flows import EncoderFlows, FlowNetworkModel
from decomplex_bt.understanding.encoder.model import PIECES_FILE
from decomplex_bt.understanding.encoder.pieces import Pieces
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import has_encoder
from decomplex_bt.understanding.noise import edited, without_punctuation
from decomplex_bt.understanding.training import EDITS, observe

Pairs = list[tuple[Observed, Instruction]]


class Data(NamedTuple):
    """Annotated instructions: those learnt from, their copies for tasks and arguments and for the flow, and those
    scored. `network`: the shipped one, which has learnt from the same, if it can be run."""

    train: Pairs
    noised: Pairs
    for_flow: Pairs
    development: Pairs
    network: FlowNetworkModel | None


CUES = ("cue", "since", "reported", "near", "far", "behind", "governing", "turn", "between", "ahead", "type.ahead")
ROWS: dict[str, dict[str, tuple[str, ...]]] = {
    "tasks": {
        "verbs, nouns and states of the domain": ("sense", "particle", "lemma.particle", "noun", "state", "verb_"),
        "cues": ("cue", "since", "reported"),
        "parse": ("dep", "head", "child.", "above", "subject", "aux", "mark", "neg", "prt", "dative", "prep", "dobj"),
        "neighbouring words": ("-2:", "-1:", "1:", "2:"),
        "questions": ("question", "start.question"),
    },
    "arguments": {
        "nouns and states of the domain": ("noun", "state"),
        "cues": ("cue",),
        "parse": ("dep", "head", "governor", "path", "preposition"),
        "what separates token and task": ("before.separator", "after.separator", "separators"),
    },
    "flow": {
        "cues": CUES,
        "likeness to earlier checks": ("asked",),
        "what became of an action": ("outcome", "action1", "action2"),
        "what the words say of order": ("says.", "others.", "rest", "waits"),
        "order told elsewhere ('first' in a branch)": ("elsewhere",),
        "shared nouns and pronouns": ("link",),
        "replacement (... instead)": ("right.replaces",),
        "shape of the condition in its sentence": ("left.shape", "right.shape", "turn.shape"),
        "joint conditions": ("joins", "joint"),
        "questions": ("question", "left.question", "-1.question", "+1.question", "-2.question", "+2.question"),
        "task types": ("type", "left.type", "right.type", "role.type", "-1.type", "+1.type", "-2.type", "+2.type"),
    },
}
"""Of each stage the groups of features that can be left out, by the starts of their names."""


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--stages", nargs="+", choices=tuple(ROWS), default=list(ROWS))
    options.add_argument("--json", type=Path)
    chosen = options.parse_args()
    data = _data()
    rows = [row for stage in chosen.stages for row in STAGES[stage](data)]
    if chosen.json:
        chosen.json.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


def _data() -> Data:
    domain = load_domain("household")
    corpus = domain.folder / "corpus"
    parser, gazetteer = Parser(), Gazetteer.of(domain.lexicon, domain.kinds)
    splits: dict[str, list[Instruction]] = {"train": [], "development": []}
    for name, voice in read_voices(corpus).items():
        if voice.split in splits:
            splits[voice.split] += [e.instruction for e in read_corpus(corpus / f"{name}.yaml", domain.ontology)]
    rng = np.random.default_rng(0)

    def read(instructions: list[Instruction]) -> Pairs:
        return observe(instructions, parser, gazetteer)

    train = splits["train"]
    bare = read([edited(i, without_punctuation) for i in train])
    return Data(
        read(train),
        [pair for edit in EDITS for pair in read([edited(i, edit) for i in train])],
        [*bare, *read([with_fillers(i, rng) for i in train])],
        read(splits["development"]),
        _network(domain),
    )


def _network(domain: Domain) -> FlowNetworkModel | None:
    folder = domain.folder / "models"
    if not has_encoder(folder):
        return None
    return FlowNetworkModel(folder / ENCODER_FOLDER, Pieces(folder / ENCODER_FOLDER / PIECES_FILE), domain.ontology)


def _tasks(data: Data) -> Iterator[dict[str, Any]]:
    def score(train: Pairs) -> tuple[int, int, int]:
        with tempfile.TemporaryDirectory() as folder:
            tasks.train_tasks(Path(folder) / "tasks.crf", train)
            model = tasks.TaskModel(Path(folder) / "tasks.crf")
            found = [
                ({(t.token, t.type) for t in model.find(o)}, set(arguments.gold_tasks(o.document, i).items()))
                for o, i in data.development
            ]
        return _counts(found)

    yield _row("tasks", "nothing", _f1(score(data.train)))
    yield _row("tasks", "nothing, noised copies added", _f1(score([*data.train, *data.noised])))
    for name, starts in ROWS["tasks"].items():
        with _without(starts, (tasks, "task_features")):
            yield _row("tasks", name, _f1(score(data.train)))


def _arguments(data: Data) -> Iterator[dict[str, Any]]:
    def gold(observed: Observed, instruction: Instruction) -> set[tuple[str, int, range]]:
        marked = dependencies.marked_tasks(observed, instruction)
        return {(kind, task.token, tokens) for task in marked for kind, tokens in task.arguments}

    def score(train: Pairs, method: str | None = None) -> tuple[int, int, int]:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "arguments.crf"
            if method is None:
                arguments.train_arguments(path, train)
                find: Callable[..., Any] = arguments.ArgumentModel(path).find
            else:
                arguments.train_association(path, train, "naive")
                find = arguments.AssociationArguments(path, "naive").find
            found = [
                ({(a.type, a.owner, a.tokens) for a in find(o, arguments.gold_tasks(o.document, i))}, gold(o, i))
                for o, i in data.development
            ]
        return _counts(found)

    yield _row("arguments", "nothing", _f1(score(data.train)))
    yield _row("arguments", "nothing, noised copies added", _f1(score([*data.train, *data.noised])))
    yield _row("arguments", "owner in the label (naive association)", _f1(score(data.train, "naive")))
    for name, starts in ROWS["arguments"].items():
        with _without(starts, (arguments, "argument_features")):
            yield _row("arguments", name, _f1(score(data.train)))


def _flow(data: Data) -> Iterator[dict[str, Any]]:
    complex_ones = [(o, i) for o, i in data.development if len(i.tasks) > 1]

    def score(train: Pairs, network: FlowNetworkModel | None = None) -> dict[str, Any]:
        with tempfile.TemporaryDirectory() as folder:
            dependencies.train_flow(Path(folder), train)
            crfs = dependencies.FlowModel(Path(folder))
            model = crfs if network is None else EncoderFlows(crfs, network)
            right = sum(
                model.alternatives(o, dependencies.marked_tasks(o, i))[0].flow == i.flow for o, i in complex_ones
            )
        low, high = Proportion(right, len(complex_ones)).interval or (0.0, 1.0)
        return {"figure": right / len(complex_ones), "low": low, "high": high, "n": len(complex_ones)}

    extractors = [(dependencies, f"{name}_features") for name in ("role", "attachment", "order")]
    yield _row("flow", "nothing", score(data.train))
    yield _row("flow", "nothing, noised copies added", score([*data.train, *data.for_flow]))
    if data.network is not None:
        with_both = score([*data.train, *data.for_flow], data.network)
        yield _row("flow", "nothing, noised copies and the network added", with_both)
    for name, starts in ROWS["flow"].items():
        with _without(starts, *extractors):
            yield _row("flow", name, score(data.train))


STAGES = {"tasks": _tasks, "arguments": _arguments, "flow": _flow}


@contextmanager
def _without(starts: tuple[str, ...], *extractors: tuple[Any, str]) -> Iterator[None]:
    """Leaves out all features whose names start so, in training and in use. Raises `ValueError` if there were none."""
    left_out = 0
    with ExitStack() as stack:
        for module, name in extractors:
            whole = getattr(module, name)

            def reduced(*given: Any, whole: Callable[..., Any] = whole) -> Any:
                nonlocal left_out
                items = whole(*given)
                kept = [{k: v for k, v in item.items() if not k.startswith(starts)} for item in items]
                left_out += sum(map(len, items)) - sum(map(len, kept))
                return kept

            stack.enter_context(patch.object(module, name, reduced))
        yield
    if not left_out:
        raise ValueError(f"no feature's name starts with any of {starts}: the row would say nothing")


def _counts(found: Sequence[tuple[set[Any], set[Any]]]) -> tuple[int, int, int]:
    return (
        sum(len(ours & gold) for ours, gold in found),
        sum(len(ours) for ours, _ in found),
        sum(len(gold) for _, gold in found),
    )


def _f1(counts: tuple[int, int, int]) -> dict[str, Any]:
    right, ours, gold = counts
    return {"figure": 2 * right / (ours + gold), "n": gold}


def _row(stage: str, left_out: str, scored: dict[str, Any]) -> dict[str, Any]:
    interval = f" [{scored['low']:.3f}, {scored['high']:.3f}]" if "low" in scored else ""
    measure = "exact" if stage == "flow" else "F1"
    print(f"{stage:10} without {left_out:45} {measure} {scored['figure']:.3f}{interval} (n={scored['n']})", flush=True)
    return {"stage": stage, "left_out": left_out, **scored}


if __name__ == "__main__":
    main()
