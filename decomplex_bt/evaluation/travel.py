"""Travel to other processes: of the planner, which each of them is to have once, and of what cannot be sent there."""

from __future__ import annotations

import os
import pickle
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import count
from typing import Any

from decomplex_bt.errors import InputError, quoted
from decomplex_bt.evaluation.planners import Planning, planner_of
from decomplex_bt.planning.planner import Planner

_NUMBERS = count()


@dataclass(frozen=True)
class Lent:
    """A planner, or what makes one, on its way to other processes; called, it gives the one of this process.

    A copy of it comes with each handful of episodes: the first is kept, with all that its planner remembers.
    """

    number: tuple[int, int]
    given: Any = field(compare=False)

    def __call__(self) -> Planner:
        return _kept(self)


def lend(planner: Planning | None) -> Lent | None:
    """The planner as processes share it."""
    return None if planner is None else Lent((os.getpid(), next(_NUMBERS)), planner)


def check_travels(name: str, value: Any, *, remedy: str) -> None:
    """Raises `InputError` for what other processes cannot be given."""
    from joblib import wrap_non_picklable_objects

    sent = wrap_non_picklable_objects([value])  # as joblib sends it, which would make a subclass of a class alone
    try:
        pickle.dumps(sent)
    except Exception as error:  # whatever the pickling of a value may raise
        what = f"{name} is {quoted(value)}, which other processes cannot be given"
        raise InputError(f"{what}: {error}; {remedy}") from None


@lru_cache(maxsize=2)
def _kept(lent: Lent) -> Planner:
    return planner_of(lent.given)
