"""Labels are decoded within what can be, and sums made piece by piece are the sums."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from decomplex_bt.understanding.encoder.heads import MOST_SUMMED, Heads
from decomplex_bt.understanding.encoder.labels import argument_labels
from decomplex_bt.understanding.encoder.stages import best_path, steps

LABELS = argument_labels(("object", "goal"))


def decoded(*likeliest: dict[str, float]) -> list[str]:
    """The path for tokens that score these labels, and all others 0."""
    scores = np.array([[token.get(label, 0.0) for label in LABELS] for token in likeliest])
    return [LABELS[k] for k in best_path(scores, steps(LABELS))]


def test_an_inner_label_needs_a_beginning() -> None:
    assert decoded({"O": 2.0}, {"I-object": 3.0, "B-object": 2.0}, {"I-object": 3.0}) == ["O", "B-object", "I-object"]
    assert decoded({"I-goal": 3.0, "O": 1.0}) == ["O"]
    assert decoded({"B-object": 3.0}, {"I-goal": 3.0, "B-goal": 2.0}) == ["B-object", "B-goal"]


@pytest.mark.parametrize(
    ("second", "path"),
    [
        ({"B-object": 3.0, "I-object": 2.0}, ["B-object", "I-object"]),
        ({"B-object": 3.0, "O": 2.0}, ["B-object", "O"]),
        ({"B-object": 9.0}, ["O", "B-object"]),
        ({"B-goal": 3.0}, ["B-object", "B-goal"]),
    ],
)
def test_no_two_arguments_of_a_type_stand_side_by_side(second: dict[str, float], path: list[str]) -> None:
    assert decoded({"B-object": 3.0}, second) == path


def test_many_rows_are_multiplied_as_few(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    weight, bias = rng.normal(size=(64, 512)).astype(np.float32), rng.normal(size=64).astype(np.float32)
    np.savez(tmp_path / "heads.npz", **{"task.weight": weight, "task.bias": bias})
    vectors = rng.normal(size=(3 * MOST_SUMMED // weight.size + 1, 512)).astype(np.float32)
    assert np.allclose(Heads(tmp_path / "heads.npz").tasks(vectors), vectors @ weight.T + bias, atol=1e-3)
