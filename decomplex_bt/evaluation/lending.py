"""The planner of an evaluation, lent to its workers: each process, and each thread, is to have it once."""

from __future__ import annotations

import os
import threading
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import count
from typing import Any

from decomplex_bt.evaluation.planners import Planning, planner_of
from decomplex_bt.planning.planner import Planner

_NUMBERS = count()


@dataclass(frozen=True)
class Lent:
    """A planner, or what makes one, on its way to other processes; called, it gives the one of this thread.

    A copy of it comes with each handful of episodes: the first is kept, with all that its planner remembers.
    """

    number: tuple[int, int]
    given: Any = field(compare=False)

    def __call__(self) -> Planner:
        return _WORKER.kept(self)


def lend(planner: Planning | None) -> Lent | None:
    """The planner as workers share it."""
    return None if planner is None else Lent((os.getpid(), next(_NUMBERS)), planner)


class _Worker(threading.local):
    """What a thread has of its own: planners remember, and need not bear to be asked by two at once."""

    def __init__(self) -> None:
        self.kept = lru_cache(maxsize=2)(lambda lent: planner_of(lent.given))


_WORKER = _Worker()
