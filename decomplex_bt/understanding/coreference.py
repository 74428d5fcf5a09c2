"""Coreference: what pronouns, "one", "there" and unsaid arguments stand for (beyond DeComplex, section III-B).

The paper takes the noun of a preceding task. Here a log-linear model chooses among all phrases of the instruction,
earlier and later ones, and none, by their kind, number, role, distance and place in the flow; ours because no light
library resolves "one", "there" and ellipsis.
"""

from __future__ import annotations

import json
import math
from array import array
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.affinity import options_of
from decomplex_bt.understanding.references.asked_again import place_asked_before
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.deeds_asked import deed_asked_before
from decomplex_bt.understanding.references.gaps import PREDICATE, REFERRING, Gap, gap_of, unsaid_gaps
from decomplex_bt.understanding.references.options import Option
from decomplex_bt.understanding.references.pointing import shown
from decomplex_bt.understanding.references.spellings import filled, part_of
from decomplex_bt.understanding.references.switching import without_own_place

__all__ = ["REFERENCES_FILE", "REFERRING", "ReferenceModel", "train_references"]

Hints = Callable[[Gap, Sequence[Option]], Sequence[float]]
"""For a gap and its options, what to add to the score of each."""

REFERENCES_FILE = "references.json"
PENALTY = 0.5
"""Weight of the squared norm in the loss of `train_references`."""
RAREST = 2
"""Features seen less often in training are left out."""
SMALLEST = 0.08
"""Weights below are left out of the file: together they hardly change a probability."""


class ReferenceModel:
    """The trained model for referents and ellipses. Raises `DataFileError` where the file cannot be read."""

    def __init__(self, path: Path, ontology: Ontology) -> None:
        try:
            stored = json.loads(path.read_text(encoding="utf-8"))
            self._weights = {str(name): float(weight) for name, weight in stored.items()}
        except (OSError, ValueError, AttributeError, TypeError) as error:
            raise ModelError(path, f"no weights of references ({type(error).__name__})") from None
        self._ontology = ontology

    def resolve(
        self, observed: Observed, tasks: Sequence[Task], flow: Flow, hints: Hints | None = None
    ) -> tuple[Task, ...]:
        """The tasks with every referring argument's value resolved and unsaid arguments added, in text order.

        `hints`: what another model adds to the scores of a gap's options.
        """
        context = Context(observed, tasks, flow)
        resolved: list[Task] = []
        parts: dict[str, str] = {}  # "one of them" to "one of the plates"
        for task in tasks:
            arguments: list[Argument] = []
            for argument in task.arguments:
                gap = gap_of(observed.document, task, argument)
                if gap is not None:
                    option, probability = self._best(context, gap, hints)
                    if option.candidate is not None:
                        value = filled(observed.document, argument, gap, parts.get(option.text.lower(), option.text))
                        parts.update(part_of(observed.document, argument, gap, value))
                        argument = replace(argument, value=value, confidence=argument.confidence * probability)
                        context.mention(gap, option.candidate, option.text)
                    elif (thing := shown(context, gap)) is not None:
                        context.pool.append(thing)
                arguments.append(argument)
            arguments = without_own_place(observed.document, task, arguments)
            implied: list[Argument] = []
            said = {argument.value.lower() for argument in arguments}  # what is put is not where it is put
            for gap in unsaid_gaps(observed, task, self._ontology):
                if gap.type == "goal" and any(argument.type == "recipient" for argument in implied):
                    continue  # what somebody gets goes to no place besides
                asked = place_asked_before(context, gap, resolved) or deed_asked_before(context, gap, resolved)
                if asked is not None:
                    implied.append(asked)
                    continue
                option, probability = self._best(context, gap, hints, said)
                if option.candidate is not None:
                    value = parts.get(option.text.lower(), option.text)
                    implied.append(Argument(option.type, value, None, probability))
                    context.mention(gap, option.candidate, option.text)
            resolved.append(replace(task, arguments=(*implied, *arguments)))
        return tuple(resolved)

    def scores(self, options: Sequence[Option]) -> list[float]:
        """The model's own score of each option of a gap: unnormalised log probabilities."""
        weights = self._weights
        scores: list[float] = []
        shared: tuple[str, ...] = ()
        score = 0.0
        for option in options:
            if option.shared is not shared:  # else another spelling of the candidate before
                shared = option.shared
                score = sum([weights.get(feature, 0.0) for feature in shared])
            scores.append(sum([weights.get(feature, 0.0) for feature in option.own], score))
        return scores

    def _best(
        self, context: Context, gap: Gap, hints: Hints | None, excluded: Collection[str] = ()
    ) -> tuple[Option, float]:
        """The likeliest filling, none of the `excluded` ones; options with the same words share their probability."""
        options = [o for o in options_of(context, gap) if o.candidate is None or o.text.lower() not in excluded]
        if not options:
            return Option(None, "", "", ()), 1.0
        if gap.is_certain:
            options = [option for option in options if option.candidate is not None] or options
        scores = self.scores(options)
        if hints is not None:
            scores = [score + added for score, added in zip(scores, hints(gap, options), strict=True)]
        chosen, probability = likeliest(options, scores)
        return options[chosen], probability


def likeliest(options: Sequence[Option], scores: Sequence[float]) -> tuple[int, float]:
    """Which of a gap's options (at least one) fills it, by unnormalised log probabilities, and its probability; options
    with the same words share theirs."""
    highest = max(scores)
    chances: dict[tuple[str, str], float] = {}
    for option, score in zip(options, scores, strict=True):
        chances[option.key] = chances.get(option.key, 0.0) + math.exp(score - highest)
    best = max(chances, key=lambda key: chances[key])
    chosen = max((i for i, o in enumerate(options) if o.key == best), key=lambda i: scores[i])
    return chosen, chances[best] / sum(chances.values())


def train_references(path: Path, data: Sequence[tuple[Observed, Instruction]], ontology: Ontology) -> None:
    """Fits the weights by conditional logit on annotated instructions and writes them to `path`."""
    weights = _fitted(
        choice for observed, instruction in data for choice in choices_of(observed, instruction, ontology)
    )
    rounded = {name: round(weight, 3) for name, weight in sorted(weights.items())}
    kept = {name: weight for name, weight in rounded.items() if abs(weight) >= SMALLEST}
    path.write_text(json.dumps(kept, indent=0, ensure_ascii=False) + "\n", encoding="utf-8")


@dataclass(frozen=True, slots=True)
class Choice:
    """The options of an annotated gap, each with whether it is right."""

    gap: Gap
    options: list[Option]
    right: list[bool]


def choices_of(observed: Observed, instruction: Instruction, ontology: Ontology) -> Iterator[Choice]:
    """Every gap of an annotated instruction; gaps that no option fills rightly are left out."""
    document = observed.document
    said = [replace(t, arguments=tuple(a for a in t.arguments if a.span is not None)) for t in instruction.tasks]
    context = Context(observed, said, instruction.flow)
    for task, plain in zip(instruction.tasks, said, strict=True):
        gaps: list[tuple[Gap, dict[str, str]]] = []
        for argument in plain.arguments:
            gap = gap_of(document, plain, argument)
            if gap is not None:
                is_same = argument.span is not None and argument.value == argument.span.of(document.text)
                gaps.append((gap, {} if is_same else {argument.type: argument.value.lower()}))
        implied = {a.type: a.value.lower() for a in task.arguments if a.span is None}
        for gap in unsaid_gaps(observed, plain, ontology):
            types = ("state", "location") if gap.type == PREDICATE else (gap.type,)
            gaps.append((gap, {kind: implied[kind] for kind in types if kind in implied}))
        for gap, values in gaps:
            options = options_of(context, gap)
            right = [
                values.get(option.type) == option.text.lower() if option.candidate is not None else not values
                for option in options
            ]
            if any(right):
                if len(options) > 1:
                    yield Choice(gap, options, right)
                chosen = options[right.index(True)]
                if chosen.candidate is not None:
                    context.mention(gap, chosen.candidate, chosen.text)


def _fitted(choices: Iterable[Choice]) -> Mapping[str, float]:
    import numpy as np
    from scipy.optimize import minimize
    from scipy.sparse import csr_matrix

    number: dict[str, int] = {}
    columns, ends = array("i"), array("l", (0,))  # a corpus has tens of millions of features, its choices are not kept
    options: list[int] = []
    rights: list[bool] = []
    for choice in choices:
        options.append(len(choice.options))
        rights += choice.right
        for option in choice.options:
            columns.extend(number.setdefault(feature, len(number)) for feature in option.features)
            ends.append(len(columns))
    if not options:
        return {}
    counts = np.bincount(columns, minlength=len(number))
    names = [name for name, count in zip(number, counts, strict=True) if count >= RAREST]
    table = csr_matrix((np.ones(len(columns)), columns, ends), shape=(len(ends) - 1, len(number)))[:, counts >= RAREST]
    transposed = table.T.tocsr()
    sizes = np.array(options)
    starts = np.concatenate([[0], np.cumsum(sizes)[:-1]])
    right = np.array(rights)

    def loss(weights: np.ndarray) -> tuple[float, np.ndarray]:
        scores = table @ weights
        scores -= np.repeat(np.maximum.reduceat(scores, starts), sizes)
        raised = np.exp(scores)
        whole = np.add.reduceat(raised, starts)
        good = np.maximum(np.add.reduceat(raised * right, starts), 1e-300)
        difference = raised / np.repeat(whole, sizes) - raised * right / np.repeat(good, sizes)
        value = float(np.log(whole).sum() - np.log(good).sum()) + PENALTY * float(weights @ weights)
        return value, transposed @ difference + 2 * PENALTY * weights

    start = np.zeros(len(names))
    fitted = minimize(loss, start, jac=True, method="L-BFGS-B", options={"maxiter": 200, "ftol": 1e-7}).x
    return dict(zip(names, map(float, fitted), strict=True))
