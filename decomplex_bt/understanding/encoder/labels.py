"""What the network's outputs stand for, in their order, and the features that tasks and pairs of tasks bring along."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from decomplex_bt.understanding.arcs import CONDITION_ROLES, ORDERS
from decomplex_bt.understanding.clauses import Clause
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.structure import pair_features, role_features

ROLES = ("task", "condition", "mention", "and", "or", "again")
ORDER_LABELS = ORDERS
SIDES = "+-"


def task_labels(types: Sequence[str]) -> tuple[str, ...]:
    """The labels of a token: `O`, then the task types of the ontology."""
    return ("O", *types)


def argument_labels(types: Sequence[str]) -> tuple[str, ...]:
    """The labels of a token inside an argument: `O`, then B and I of each argument type of the ontology."""
    return ("O", *(f"{prefix}-{name}" for name in types for prefix in "BI"))


def task_names(observed: Observed, clauses: Sequence[Clause]) -> list[list[str]]:
    """For every task the names of its structural features that are there."""
    return [_names(item) for item in role_features(observed, clauses)]


def pair_names(clauses: Sequence[Clause]) -> list[list[list[str]]]:
    """For every two tasks (k, j) the names of the features of j as a condition of k; none on the diagonal."""
    count = range(len(clauses))
    return [[_names(pair_features(clauses, k, j)) if j != k else [] for j in count] for k in count]


def _names(item: Mapping[str, object]) -> list[str]:
    return [
        name if value is True or (isinstance(value, float) and value == 1.0) else f"{name}={value}"
        for name, value in item.items()
        if name not in _LEXICAL and value is not False and value != 0
    ]


_LEXICAL = frozenset(("bias", "lemma"))


def may_point(roles: Sequence[str], k: int, j: int) -> bool:
    """Whether task k may hang on task j: only on a condition, never on itself."""
    return j != k and roles[j] in CONDITION_ROLES
