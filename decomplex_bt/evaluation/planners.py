"""The planner of an evaluation: one that solves problems, what makes such a one, or the default one."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any, TypeGuard

from decomplex_bt.errors import InputError, quoted
from decomplex_bt.planning.planner import Planner
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

Planning = Planner | Callable[[], Planner]
"""A planner, or what makes one."""


def check_planner(planner: Any) -> None:
    """Raises `InputError` for what neither is a planner nor makes one."""
    if planner is not None and not _is_planner(planner) and not callable(planner):
        raise InputError(
            f"planner is {quoted(planner)}; expected something with a method solve(problem), a function that makes "
            "one, or None"
        )


def planner_of(given: Planning | None) -> Planner:
    """The planner itself, the one that it makes, or for None the default one, the same for all of a thread.

    Raises `InputError` for what makes something else.
    """
    if given is None:
        return _DEFAULT.planner
    made: Any = given if _is_planner(given) or not callable(given) else given()
    if _is_planner(made):
        return made
    raise InputError(f"{quoted(given)} made {quoted(made)}; expected a planner, with a method solve(problem)")


def _is_planner(value: object) -> TypeGuard[Planner]:
    """Whether it solves problems; a class does not, it makes what does."""
    return not isinstance(value, type) and callable(getattr(value, "solve", None))


class _Default(threading.local):
    """The default planner of a thread."""

    def __init__(self) -> None:
        self.planner = PyperplanPlanner()


_DEFAULT = _Default()
