"""What the outputs of the network for tasks and arguments stand for, in their order."""

from __future__ import annotations

from collections.abc import Sequence


def task_labels(types: Sequence[str]) -> tuple[str, ...]:
    """The labels of a token: `O`, then the task types of the ontology."""
    return ("O", *types)


def argument_labels(types: Sequence[str]) -> tuple[str, ...]:
    """The labels of a token inside an argument: `O`, then B and I of each argument type of the ontology."""
    return ("O", *(f"{prefix}-{name}" for name in types for prefix in "BI"))
