"""The heads on the encoder, in numpy: token vectors in, scores of labels, owners and control flow out.

The network in `network` is trained with the same formulas; a test holds the two to one another.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from decomplex_bt.errors import DataFileError
from decomplex_bt.understanding.encoder.labels import ROLES, may_point

Array = np.ndarray
FARTHEST = 10
"""Distances between tasks beyond this count as this."""
IMPOSSIBLE = -1e4


@dataclass(frozen=True, slots=True)
class FlowScores:
    """Scores of n tasks: `orders` (n, orders), `attachments` (n, 2n + 1): for task k and condition j the side as stated
    at 2j, the other at 2j + 1, the top last; `mentions` (n, n)."""

    orders: Array
    attachments: Array
    mentions: Array


class Heads:
    """The trained weights, from `heads.npz` (plain arrays). Raises `DataFileError` where they cannot be read."""

    def __init__(self, path: Path) -> None:
        try:
            with np.load(path, allow_pickle=False) as stored:
                names = [name for name in stored.files if stored[name].dtype.kind == "f"]
                self._weights = {name: stored[name].astype(np.float32) for name in names}
                self._task_features = {str(name): i for i, name in enumerate(stored["task_features"])}
                self._pair_features = {str(name): i for i, name in enumerate(stored["pair_features"])}
        except (OSError, ValueError, KeyError) as error:
            problem = f"no weights of the encoder ({error}); run `decomplex-bt train --encoder`"
            raise DataFileError(path, problem) from None

    def tasks(self, vectors: Array) -> Array:
        """(tokens, task labels)."""
        return self._linear("task", vectors)

    def typed(self, vectors: Array, types: Sequence[int]) -> Array:
        """The vectors with an embedding of each token's task label behind them."""
        return np.concatenate([vectors, self._weights["ttype.weight"][list(types)]], axis=1)

    def arguments(self, typed: Array) -> Array:
        """(tokens, argument labels)."""
        return self._linear("bio.2", _gelu(self._linear("bio.0", typed)))

    def owners(self, typed: Array, starts: Sequence[int], places: Sequence[int]) -> Array:
        """(argument starts, tasks): how well each task owns the argument that starts there."""
        offsets = np.array([[sum(p < i for p in places) - k for k in range(len(places))] for i in starts])
        return self._biaffine("owner", typed[list(starts)], typed[list(places)], offsets)[..., 0]

    def context(self, tasks: Array, names: Sequence[Sequence[str]]) -> tuple[Array, Array]:
        """Of every task its vector in context and the sum of its features' embeddings."""
        features = self._bags("tf.weight", self._task_features, names)
        nothing = np.zeros((1, tasks.shape[1]), np.float32)
        around = np.concatenate([np.vstack([nothing, tasks[:-1]]), tasks, np.vstack([tasks[1:], nothing])], axis=1)
        return _gelu(self._linear("mix.0", np.concatenate([around, features], axis=1))), features

    def roles(self, context: Array, features: Array) -> Array:
        """(tasks, roles)."""
        return self._linear("role", np.concatenate([context, features], axis=1))

    def flow(
        self, context: Array, features: Array, roles: Sequence[str], pairs: Sequence[Sequence[Sequence[str]]]
    ) -> FlowScores:
        """What the tasks hang on, their roles being known."""
        n = len(roles)
        role_vectors = self._weights["remb.weight"][[ROLES.index(role) for role in roles]]
        with_roles = np.concatenate([context, role_vectors], axis=1)
        offsets = np.arange(n)[None, :] - np.arange(n)[:, None]
        bags = self._bags("pf.weight", self._pair_features, [names for row in pairs for names in row]).reshape(n, n, -1)
        inputs = np.concatenate(
            [
                bags,
                np.broadcast_to(role_vectors[:, None], (n, n, role_vectors.shape[1])),
                np.broadcast_to(role_vectors[None], (n, n, role_vectors.shape[1])),
            ],
            axis=2,
        )
        pair = self._linear("patt.2", _gelu(self._linear("patt.0", inputs)))
        sides = self._biaffine("att", with_roles, with_roles, offsets) + pair[..., :2]
        mentions = self._biaffine("men", with_roles, with_roles, offsets)[..., 0] + pair[..., 2]
        possible = np.array([[may_point(roles, k, j) for j in range(n)] for k in range(n)])
        sides = np.where(possible[..., None], sides, IMPOSSIBLE)
        mentions = np.where(possible & (offsets < 0), mentions, IMPOSSIBLE)
        top = self._linear("top", with_roles)
        orders = self._linear("order", np.concatenate([context, features], axis=1))
        return FlowScores(orders, np.concatenate([sides.reshape(n, 2 * n), top], axis=1), mentions)

    def _linear(self, name: str, x: Array) -> Array:
        return x @ self._weights[f"{name}.weight"].T + self._weights[f"{name}.bias"]

    def _biaffine(self, name: str, x: Array, y: Array, offsets: Array) -> Array:
        a, b = _with_one(_gelu(self._linear(f"{name}.a", x))), _with_one(_gelu(self._linear(f"{name}.b", y)))
        scores = np.einsum("ih,ohk,jk->ijo", a, self._weights[f"{name}.u"], b, optimize=True)
        return scores + self._weights[f"{name}.dist.weight"][np.clip(offsets, -FARTHEST, FARTHEST) + FARTHEST]

    def _bags(self, name: str, known: Mapping[str, int], bags: Sequence[Sequence[str]]) -> Array:
        """The sum of the embeddings of the known names of each bag; row 0 of the table stands for nothing."""
        table = self._weights[name]
        rows = [[known[n] + 1 for n in names if n in known] for names in bags]
        return np.stack([table[row].sum(axis=0) if row else np.zeros(table.shape[1], np.float32) for row in rows])


def log_softmax(x: Array) -> Array:
    """Over the last axis."""
    shifted = x - x.max(axis=-1, keepdims=True)
    return shifted - np.log(np.exp(shifted).sum(axis=-1, keepdims=True))


def _gelu(x: Array) -> Array:
    """The tanh form of the Gaussian error linear unit."""
    return 0.5 * x * (1 + np.tanh(0.7978845608 * (x + 0.044715 * x**3)))


def _with_one(x: Array) -> Array:
    return np.concatenate([x, np.ones((len(x), 1), np.float32)], axis=1)
