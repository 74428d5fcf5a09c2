"""The default planner: pyperplan's search, contained.

pyperplan logs through the root logger, writes in lower case and walks sets of strings, so that its plans depend on
PYTHONHASHSEED. Here its root logging is silenced for the time of a call, and facts are numbered in sorted order before
the search: sets of small integers are walked in the same order in every process, and hash faster.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from typing import Any

from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.problem import Problem

WEIGHTS = (0.8, 2.0, 5.0)
"""Weights of the heuristic in A*, tried in turn: plans without detours first, and where that takes too long any plan.

The FF heuristic counts a way to and fro for each thing, so that with weight 1 things are fetched one by one.
"""
MAX_EVALUATIONS = 1600
"""States each search looks at before it is broken off (some 0.07 ms each)."""
CACHE_SIZE = 4096
"""Results kept; the oldest go first."""


class PyperplanPlanner:
    """Weighted A* with the FF heuristic, as pyperplan has them; results are cached by the texts of both files."""

    def __init__(self, *, max_evaluations: int = MAX_EVALUATIONS) -> None:
        self.max_evaluations = max_evaluations
        self._cache: dict[tuple[str, str, tuple[GroundAction, ...]], PlanResult] = {}

    def solve(self, problem: Problem) -> PlanResult:
        """A plan for the problem; from the cache if an equal problem was solved before."""
        key = (problem.domain_pddl, problem.text, problem.forbidden)
        found = self._cache.get(key)
        if found is not None:
            return replace(found, seconds=0.0)
        start = time.perf_counter()
        result = replace(self._search(problem), seconds=time.perf_counter() - start)
        if len(self._cache) >= CACHE_SIZE:
            del self._cache[next(iter(self._cache))]
        self._cache[key] = result
        return result

    def _search(self, problem: Problem) -> PlanResult:
        if set(problem.goal) <= set(problem.init):
            return PlanResult(PlanStatus.SOLVED)
        evaluations = 0
        with _quiet_root_logger():
            grounded = _number_facts(_ground(problem))
            for weight in WEIGHTS:
                counted = _Counted(grounded, self.max_evaluations)
                try:
                    plan = _astar(grounded, counted, weight)
                except _OutOfBudgetError:
                    evaluations += counted.limit
                    continue
                return _result(problem, plan, evaluations + counted.calls)
        reason = f"no plan found among {evaluations} states"
        return PlanResult(PlanStatus.TIMEOUT, reason=reason, evaluations=evaluations)


def _result(problem: Problem, plan: list[Any] | None, evaluations: int) -> PlanResult:
    if plan is None:
        goal = " ".join(map(str, problem.goal))
        return PlanResult(PlanStatus.UNSOLVABLE, reason=f"no plan reaches {goal}", evaluations=evaluations)
    steps = tuple(_read_step(operator.name) for operator in plan)
    return PlanResult(PlanStatus.SOLVED, steps, evaluations=evaluations)


class _OutOfBudgetError(Exception):
    """The search has looked at as many states as it may."""


class _Counted:
    """The FF heuristic with a limit to the number of its calls."""

    def __init__(self, grounded: Any, limit: int) -> None:
        from pyperplan.heuristics.relaxation import hFFHeuristic

        self.heuristic = hFFHeuristic(grounded)
        self.limit = limit
        self.calls = 0

    def __call__(self, node: Any) -> float:
        self.calls += 1
        if self.calls > self.limit:
            raise _OutOfBudgetError
        return float(self.heuristic(node))


def _astar(grounded: Any, heuristic: Any, weight: float) -> list[Any] | None:
    from pyperplan.search.a_star import weighted_astar_search

    plan: list[Any] | None = weighted_astar_search(grounded, heuristic, weight)
    return plan


@cache
def _parse_domain(text: str) -> Any:
    from pyperplan.pddl.parser import Parser

    parser = Parser("", probFile=None)
    parser.domInput = text
    return parser.parse_domain(read_from_file=False)


def _ground(problem: Problem) -> Any:
    """pyperplan's STRIPS task of the problem, without the forbidden steps, operators sorted by name."""
    from pyperplan.grounding import ground
    from pyperplan.pddl.parser import Parser

    parser = Parser("", probFile="")
    parser.probInput = problem.text
    grounded = ground(parser.parse_problem(_parse_domain(problem.domain_pddl), read_from_file=False))
    forbidden = {str(step).lower() for step in problem.forbidden}
    grounded.operators = sorted(
        (operator for operator in grounded.operators if operator.name not in forbidden),
        key=lambda operator: operator.name,
    )
    return grounded


def _number_facts(grounded: Any) -> Any:
    """The same task over integers instead of strings, numbered in the order of the strings."""
    from pyperplan.task import Operator, Task

    names = {name for operator in grounded.operators for name in operator.add_effects | operator.preconditions}
    number = {
        name: i for i, name in enumerate(sorted({*grounded.facts, *grounded.initial_state, *grounded.goals, *names}))
    }

    def numbers(facts: Iterable[str]) -> frozenset[int]:
        return frozenset(sorted(number[fact] for fact in facts))

    operators = [
        Operator(op.name, numbers(op.preconditions), numbers(op.add_effects), numbers(op.del_effects))
        for op in grounded.operators
    ]
    facts = dict.fromkeys(sorted(number.values()))
    return Task(grounded.name, facts, numbers(grounded.initial_state), numbers(grounded.goals), operators)


def _read_step(name: str) -> GroundAction:
    action, *objects = name.strip("()").split()
    return GroundAction(action, tuple(objects))


@contextmanager
def _quiet_root_logger() -> Iterator[None]:
    """Keeps pyperplan's messages away from the root logger, which its first message would give a handler."""
    root = logging.getLogger()
    handler = logging.NullHandler()
    root.addHandler(handler)

    def is_foreign(record: logging.LogRecord) -> bool:
        return "pyperplan" not in record.pathname

    root.addFilter(is_foreign)
    try:
        yield
    finally:
        root.removeFilter(is_foreign)
        root.removeHandler(handler)
