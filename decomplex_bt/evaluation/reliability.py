"""Whether confidence is worth its number: of all that is believed this much, how much is right."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.metrics import has_same_flow
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.confidence import KINDS

BINS = 10


@dataclass(frozen=True, slots=True)
class Bin:
    """What is believed from `low` to under `high` (the last bin: to 1): the mean belief and what of it is right."""

    low: float
    high: float
    confidence: float | None
    right: Proportion

    def to_json(self) -> dict[str, Any]:
        confidence = None if self.confidence is None else round(self.confidence, 4)
        return {"from": self.low, "to": self.high, "confidence": confidence, "right": self.right.to_json()}


@dataclass(frozen=True, slots=True)
class Reliability:
    """Confidence against truth for one kind of belief, in bins of equal width."""

    kind: str
    bins: tuple[Bin, ...]

    @property
    def total(self) -> int:
        return sum(part.right.total for part in self.bins)

    @property
    def error(self) -> float | None:
        """Expected calibration error: the mean gap between belief and share right, each bin by what it holds."""
        if not self.total:
            return None
        gaps = (abs(b.confidence * b.right.total - b.right.count) for b in self.bins if b.confidence is not None)
        return sum(gaps) / self.total

    def to_json(self) -> dict[str, Any]:
        error = self.error
        return {
            "expected_calibration_error": None if error is None else round(error, 4),
            "total": self.total,
            "bins": [part.to_json() for part in self.bins],
        }


def reliability(predicted: Sequence[Instruction], gold: Sequence[Instruction]) -> tuple[Reliability, ...]:
    """The reliability of each of `KINDS`, over readings of the same texts as the gold ones, in the same order."""
    seen: dict[str, list[tuple[float, bool]]] = {kind: [] for kind in KINDS}
    for found, wanted in zip(predicted, gold, strict=True):
        for kind, confidence, is_right in judged(found, wanted):
            seen[kind].append((confidence, is_right))
    return tuple(Reliability(kind, tuple(_bins(believed))) for kind, believed in seen.items())


def judged(found: Instruction, wanted: Instruction) -> Iterator[tuple[str, float, bool]]:
    """Of everything believed of a reading its kind, its confidence and whether it is right.

    A task is right with its token and type, a dependency with its token and the paper's label, an argument with its
    words, type and owner (and with its referent, where it has one; an argument without words of its own is left out), a
    flow with all tasks.
    """
    types = {task.span: task.type for task in wanted.tasks}
    gold_labels, labels = wanted.flow.dependencies(), found.flow.dependencies()
    places = {task.span: gold_labels[task.id] for task in wanted.tasks if task.id in gold_labels}
    arguments = {(task.span, a.span, a.type): a.value for task in wanted.tasks for a in task.arguments}
    for task in found.tasks:
        yield "task", task.confidence, types.get(task.span) == task.type
        yield "dependency", task.dependency_confidence, places.get(task.span, "") == labels.get(task.id)
        for argument in task.arguments:
            if argument.span is not None:
                value = arguments.get((task.span, argument.span, argument.type))
                is_referring = argument.value != argument.span.of(found.text)
                is_right = value is not None and (not is_referring or _same(value, argument.value))
                yield "argument", argument.confidence, is_right
    yield "flow", found.confidence, has_same_flow(found, wanted)


def check_plot(path: Path) -> None:
    """Raises `InputError` where the picture cannot be drawn or written; before minutes of reading."""
    if find_spec("matplotlib") is None:
        raise InputError("--plot needs matplotlib; install it with: pip install 'decomplex-bt[plots]'")
    known = (".png", ".svg", ".pdf")
    if path.suffix.lower() not in known:
        raise InputError(f"--plot {path}: cannot write this kind of picture; expected one of {', '.join(known)}")
    if not path.parent.is_dir():
        raise InputError(f"--plot {path}: there is no folder {path.parent}; make it first")


def write_plot(measured: Sequence[Reliability], path: Path) -> None:
    """A picture of every reliability: what is right against what is believed, the area of a dot as many as it holds."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, all_axes = plt.subplots(1, len(measured), figsize=(3.2 * len(measured), 3.4), squeeze=False)
    for axes, one in zip(all_axes[0], measured, strict=True):
        axes.plot((0, 1), (0, 1), color="#9a9a9a", linewidth=1)
        for part in one.bins:
            ends = part.right.interval
            if part.confidence is None or part.right.value is None or ends is None:
                continue
            axes.vlines(part.confidence, *ends, color="#3f74b5", linewidth=1)
            size = 20 + 180 * part.right.total / one.total
            axes.scatter(part.confidence, part.right.value, s=size, color="#3f74b5", zorder=3, clip_on=False)
        error = "no data" if one.error is None else f"error {one.error:.3f}, n = {one.total}"
        axes.set(title=f"{one.kind}: {error}", xlabel="confidence", xlim=(0, 1), ylim=(0, 1), aspect="equal")
        axes.title.set_fontsize(9)
    all_axes[0][0].set_ylabel("share right")
    try:
        figure.savefig(path, dpi=120, bbox_inches="tight")
    except OSError as error:
        raise InputError(f"--plot {path}: cannot be written: {error.strerror}") from None
    finally:
        plt.close(figure)


def _same(value: str, other: str) -> bool:
    return value.lower().split() == other.lower().split()


def _bins(believed: Sequence[tuple[float, bool]]) -> Iterator[Bin]:
    for k in range(BINS):
        inside = [(c, right) for c, right in believed if min(int(c * BINS), BINS - 1) == k]
        mean = sum(c for c, _ in inside) / len(inside) if inside else None
        yield Bin(k / BINS, (k + 1) / BINS, mean, Proportion(sum(right for _, right in inside), len(inside)))
