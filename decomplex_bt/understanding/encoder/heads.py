"""The heads on the encoder, in numpy: token vectors in, scores of labels, owners and referents out.

The network in `network` is trained with the same formulas; a test holds the two to one another.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from decomplex_bt.understanding.damage import ModelError

Array = np.ndarray
FARTHEST = 10
"""Distances between tasks beyond this count as this."""
IMPOSSIBLE = -1e4
MOST_SUMMED = 1 << 18
"""Multiplications in a product of matrices that OpenBLAS leaves to one thread."""


class Heads:
    """The trained weights, from `heads.npz` (plain arrays). Raises `DataFileError` where they cannot be read."""

    def __init__(self, path: Path) -> None:
        try:
            with np.load(path, allow_pickle=False) as stored:
                self.weights = {name: stored[name].astype(np.float32) for name in stored.files}
        except (OSError, ValueError) as error:
            raise ModelError(path, f"no weights of the encoder ({error})") from None

    def tasks(self, vectors: Array) -> Array:
        """(tokens, task labels)."""
        return self._linear("task", vectors)

    def typed(self, vectors: Array, types: Sequence[int]) -> Array:
        """The vectors with an embedding of each token's task label behind them."""
        return np.concatenate([vectors, self.weights["ttype.weight"][list(types)]], axis=1)

    def arguments(self, typed: Array) -> Array:
        """(tokens, argument labels)."""
        return self._linear("bio.2", _gelu(self._linear("bio.0", typed)))

    def owners(self, typed: Array, starts: Sequence[int], places: Sequence[int]) -> Array:
        """(argument starts, tasks): how well each task owns the argument that starts there."""
        before = np.searchsorted(np.sort(places), starts)  # how many of the tasks
        offsets = before[:, None] - np.arange(len(places))
        return self._biaffine("owner", typed[list(starts)], typed[list(places)], offsets)[..., 0]

    def references(self, typed: Array, gap: int, anchors: Sequence[int], places: Sequence[int]) -> Array:
        """(anchors,): how well the phrase at each anchor fills the gap at a token; `places`: the tasks' tokens."""
        before = sum(p < gap for p in places)
        offsets = np.array([[before - sum(p < anchor for p in places) for anchor in anchors]])
        return self._biaffine("refer", typed[[gap]], typed[list(anchors)], offsets)[0, :, 0]

    def _linear(self, name: str, x: Array) -> Array:
        return _product(x, self.weights[f"{name}.weight"].T) + self.weights[f"{name}.bias"]

    def _biaffine(self, name: str, x: Array, y: Array, offsets: Array) -> Array:
        a, b = _with_one(_gelu(self._linear(f"{name}.a", x))), _with_one(_gelu(self._linear(f"{name}.b", y)))
        scores = a @ self.weights[f"{name}.u"] @ b.T  # (labels, x, y)
        distances = np.clip(offsets, -FARTHEST, FARTHEST) + FARTHEST
        return np.moveaxis(scores, 0, -1) + self.weights[f"{name}.dist.weight"][distances]


def _product(x: Array, y: Array) -> Array:
    """The product of two matrices, a few rows at a time: as one it would be shared out among threads, which takes
    longer than the sum itself, and ten times as long where another process works on the other cores."""
    rows = max(1, MOST_SUMMED // y.size)
    if len(x) <= rows:
        return x @ y
    return np.concatenate([x[i : i + rows] @ y for i in range(0, len(x), rows)])


def log_softmax(x: Array) -> Array:
    """Over the last axis."""
    shifted = x - x.max(axis=-1, keepdims=True)
    return shifted - np.log(np.exp(shifted).sum(axis=-1, keepdims=True))


def _gelu(x: Array) -> Array:
    """The tanh form of the Gaussian error linear unit."""
    return 0.5 * x * (1 + np.tanh(0.7978845608 * (x + 0.044715 * (x * x * x))))  # a quarter of what a power takes


def _with_one(x: Array) -> Array:
    return np.concatenate([x, np.ones((len(x), 1), np.float32)], axis=1)
