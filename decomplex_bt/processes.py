"""Calls that several processes work off."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import suppress
from typing import Any


def results(calls: Iterable[Any], jobs: int) -> Iterator[Any]:
    """What the calls, made by joblib's `delayed`, give: in their order, as it comes, from `jobs` processes (-1: one a
    core; 1: none besides this one).

    No more calls are taken than the processes work at. Where the caller has seen enough, or fails, these are waited
    for: joblib would kill their processes, and then what it shares with them is at times reported as leaked on
    standard error while Python ends.
    """
    from joblib import Parallel

    is_wanted = True

    def wanted() -> Iterator[Any]:
        for call in calls:
            if not is_wanted:
                return
            yield call

    found = Parallel(n_jobs=jobs, return_as="generator", pre_dispatch="n_jobs", batch_size=1)(wanted())
    try:
        for result in found:  # noqa: UP028 - `yield from` would close `found`
            yield result
    except GeneratorExit:
        is_wanted = False
        with suppress(Exception):  # of a call whose result nobody waits for
            deque(found, maxlen=0)
        raise
