"""Values that a caller gives, by name: checked, and made plain where they are numpy's. All raise `InputError`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import isfinite
from numbers import Integral, Real
from typing import Any

import numpy as np

from decomplex_bt.errors import InputError, among

Aliases = Callable[[str], Iterable[str]]
"""The names that a word of everyday language may stand for."""


def number(name: str, value: Any, low: float = 0.0, high: float | None = None) -> float:
    """A number from `low` to `high`; without `high` a finite one."""
    if _is_number(value, Real) and low <= value and _is_up_to(value, high):
        return float(value)
    raise InputError(f"{name} is {value!r}; expected a number from {low:g}{_up_to(high)}")


def positive(name: str, value: Any, high: float | None = None) -> float:
    """A number above 0, up to `high`; without `high` a finite one."""
    if _is_number(value, Real) and value > 0 and _is_up_to(value, high):
        return float(value)
    raise InputError(f"{name} is {value!r}; expected a number above 0{_up_to(high)}")


def whole(name: str, value: Any, low: int = 0, high: int | None = None) -> int:
    if _is_number(value, Integral) and value >= low and (high is None or value <= high):
        return int(value)
    raise InputError(f"{name} is {value!r}; expected a whole number from {low}{_up_to(high)}")


def flag(name: str, value: Any) -> bool:
    if isinstance(value, bool | np.bool_):
        return bool(value)
    raise InputError(f"{name} is {value!r}; expected True or False")


def choice(name: str, value: Any, choices: Sequence[str]) -> str:
    """One of a few."""
    if isinstance(value, str) and value in choices:
        return str(value)
    raise InputError(f"{name} is {value!r}; expected one of {', '.join(choices)}")


def known(
    name: str,
    value: Any,
    choices: Sequence[str],
    expected: str,
    aliases: Aliases | None = None,
    *,
    listed_by: str = "",
) -> str:
    """One of many, of which an error names the nearest.

    `expected` says what they are; `aliases`: those that an everyday word stands for; `listed_by`: what has them all.
    """
    if isinstance(value, str) and value in choices:
        return str(value)
    meant = [] if aliases is None else [choice for choice in aliases(str(value)) if choice in choices]
    hint = (
        f"; the nearest known: {', '.join(meant)}" if meant else among(value if isinstance(value, str) else "", choices)
    )
    raise InputError(f"{name}: {value!r} is no {expected}{hint}{f'; {listed_by} has them all' if listed_by else ''}")


def several(name: str, value: Any, expected: str) -> tuple[Any, ...]:
    """What a list, or anything else to go through but a text or a mapping, holds."""
    is_scalar = isinstance(value, str | bytes | Mapping) or (isinstance(value, np.ndarray) and not value.shape)
    if isinstance(value, Iterable) and not is_scalar:
        return tuple(value)
    raise InputError(f"{name} is {value!r}; expected {expected}")


def plain(value: Any) -> Any:
    """The same, with Python's own numbers and lists for those of numpy: what JSON keeps."""
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return value.tolist() if isinstance(value, np.generic | np.ndarray) else value


def _is_number(value: Any, kind: type) -> bool:
    return isinstance(value, kind) and not isinstance(value, bool)


def _is_up_to(value: Any, high: float | None) -> bool:
    return isfinite(value) if high is None else value <= high


def _up_to(high: float | None) -> str:
    return "" if high is None else f" to {high:g}"
