"""Calibrated confidence: how often a task, argument, dependency or flow is right that is believed this much.

What one stage believes of itself is too much or too little. So each belief is what the ranked readings agree on, put
through a logistic curve (Platt scaling) fitted on voices that no stage was trained on.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from decomplex_bt.flow import Flow
from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.readings import Reading

KINDS = ("task", "argument", "dependency", "flow")
CALIBRATION_FILE = "calibration.json"
MAX_OTHER_FLOWS = 5


@dataclass(frozen=True, slots=True)
class Belief:
    """How much is believed of the best reading. `tasks` and `dependencies` by the task's token; `flows`: all flows that
    its tasks were read with, likeliest first, the chosen one first."""

    tasks: Mapping[int, float]
    arguments: Mapping[FoundArgument, float]
    dependencies: Mapping[int, float]
    flow: float
    flows: tuple[tuple[Flow, float], ...]


def belief_of(ranked: Sequence[tuple[Reading, float]]) -> Belief:
    """What the readings of a document agree on, each weighing as much as its probability; the first is the chosen."""
    best = ranked[0][0]
    tasks = dict.fromkeys((t.token for t in best.tasks), 0.0)
    types = {t.token: t.type for t in best.tasks}
    arguments = dict.fromkeys(best.arguments, 0.0)
    dependencies = dict.fromkeys(tasks, 0.0)
    labels = _labels(best)
    flows: dict[Flow, float] = {best.flow: 0.0}
    for reading, chance in ranked:
        found = {t.token: t.type for t in reading.tasks}
        owned = {(a.type, a.owner, a.tokens): a.confidence for a in reading.arguments}
        theirs = _labels(reading)
        for token in tasks:
            tasks[token] += chance * (found.get(token) == types[token])
            dependencies[token] += chance * (theirs.get(token) == labels[token])
        for argument in arguments:
            arguments[argument] += chance * owned.get((argument.type, argument.owner, argument.tokens), 0.0)
        if found == types:
            flows[reading.flow] = flows.get(reading.flow, 0.0) + chance
    certain = {t.token: t.confidence for t in best.tasks}
    return Belief(
        {token: math.sqrt(chance * certain[token]) for token, chance in tasks.items()},
        arguments,
        dependencies,
        flows[best.flow],
        tuple(flows.items())[:1] + tuple(sorted(list(flows.items())[1:], key=lambda item: -item[1]))[:MAX_OTHER_FLOWS],
    )


def shrunk(chance: float, chosen: float, certainty: float) -> float:
    """The chance of another flow, brought to scale once that of the chosen one, `chosen`, has become `certainty`.

    None gets likelier than it was: where less is believed of the chosen one, others shrink with it, since what takes
    its place is mostly no flow that was thought of; where more is, they share what that leaves.
    """
    if certainty < chosen:
        return chance * certainty / chosen
    return chance * (1.0 - certainty) / (1.0 - chosen) if chosen < 1.0 else 0.0


def _labels(reading: Reading) -> dict[int, str]:
    """The paper's label of every task, by its token."""
    labels = reading.flow.dependencies()
    return {task.token: labels.get(number, "sequential") for number, task in enumerate(reading.tasks, start=1)}


class Calibration:
    """The fitted curves, from a JSON file. Raises `DataFileError` where they do not fit `KINDS`."""

    def __init__(self, path: Path) -> None:
        try:
            stored = json.loads(path.read_text(encoding="utf-8"))
            self._curves = {kind: (float(stored[kind][0]), float(stored[kind][1])) for kind in KINDS}
        except (OSError, ValueError, KeyError, TypeError, IndexError) as error:
            raise ModelError(path, f"no calibration ({type(error).__name__})") from None

    def of(self, kind: str, chance: float) -> float:
        """The chance that what is believed this much is right."""
        slope, shift = self._curves[kind]
        return 1.0 / (1.0 + math.exp(-(slope * _logit(chance) + shift)))


def train_calibration(path: Path, seen: Mapping[str, Sequence[tuple[float, bool]]]) -> None:
    """Fits the curves to what was believed of each kind and whether it was right, and writes them to `path`."""
    curves = {kind: _fitted(seen.get(kind, ())) for kind in KINDS}
    path.write_text(json.dumps(curves, indent=1) + "\n", encoding="utf-8")


def _fitted(seen: Sequence[tuple[float, bool]]) -> tuple[float, float]:
    """Slope and shift of the logistic curve of least log loss; a little weight keeps the slope near 1."""
    import numpy as np
    from scipy.optimize import minimize

    if len({right for _, right in seen}) < 2:
        return 1.0, 0.0
    x = np.array([_logit(chance) for chance, _ in seen])
    y = np.array([right for _, right in seen], float)

    def loss(curve: np.ndarray) -> float:
        z = curve[0] * x + curve[1]
        return float(np.mean(np.logaddexp(0.0, z) - y * z) + 1e-4 * (curve[0] - 1.0) ** 2)

    slope, shift = minimize(loss, np.array([1.0, 0.0]), method="L-BFGS-B", bounds=[(0.05, 5.0), (-5.0, 5.0)]).x
    return round(float(slope), 5), round(float(shift), 5)


def _logit(chance: float) -> float:
    clipped = min(max(chance, 1e-6), 1 - 1e-6)
    return math.log(clipped / (1 - clipped))
