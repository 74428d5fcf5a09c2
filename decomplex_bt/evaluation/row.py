"""One episode of an evaluation as a row: what was asked, where, of whom, and what came of it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, fields
from typing import Any, Literal

Outcome = Literal["success", "failure", "infeasible", "ungroundable"]
Stage = Literal["understanding", "grounding", "planning", "execution", "infeasible"]
OUTCOMES: tuple[Outcome, ...] = ("success", "failure", "infeasible", "ungroundable")
STAGES: tuple[Stage, ...] = ("understanding", "grounding", "planning", "execution", "infeasible")


@dataclass(frozen=True, slots=True)
class Row:
    """One episode.

    `example`: the id in the corpus. `seed`: of the world. `reading`: who understood the instruction for the agent,
    "gold" or "own". `judged_by`: whose flow the judge went by, "gold" or "interpreted"; `flow`: that flow, which also
    set the balance, so that a row and a run with this seed and flow are the same world. `stage`, `cause`: where and why
    it went wrong, None for a success. `steps`: of control. `sim_seconds`, `path_length`: simulated seconds, metres
    driven. `shortest_length`: metres of the shortest path there was, None without a success. `spl`: success weighted by
    path length, `shortest_length` over the longer of the two, 1 where both are 0 or nothing was left to do; 0 for a
    failure, None for what was infeasible or did not ground. `understood`: whether the agent's reading comes to what the
    gold one does in this house, None for an agent that reads nothing; a wrong reading may still succeed where what it
    gets wrong never comes due. `goals_met`, `goals_total`: tasks and conditions due. `met_at_start`: nothing was left
    to do, as where what is to be turned on is on; a success as well. `branches`: one mapping (task, truth, taken) for
    each condition reached, in order. `moved_by_others`: things that somebody else has moved. `failures`: those the
    agent knows of, as `run --json` prints them.
    """

    example: str
    seed: int
    agent: str
    reading: str
    judged_by: str
    flow: tuple[Any, ...]
    outcome: Outcome
    stage: Stage | None = None
    cause: str | None = None
    steps: int = 0
    sim_seconds: float = 0.0
    path_length: float = 0.0
    shortest_length: float | None = None
    spl: float | None = None
    plans: int = 0
    replans: int = 0
    understood: bool | None = None
    goals_met: int = 0
    goals_total: int = 0
    met_at_start: bool = False
    branches: tuple[Mapping[str, Any], ...] = ()
    violations: tuple[str, ...] = ()
    moved_by_others: int = 0
    failures: tuple[Mapping[str, Any], ...] = ()

    @property
    def is_feasible(self) -> bool:
        return self.outcome in ("success", "failure")

    def to_json(self) -> dict[str, Any]:
        """Plain values, in the order of the fields."""
        return {field.name: _plain(getattr(self, field.name)) for field in fields(self)}


def row_lines(rows: Iterable[Row]) -> Iterator[str]:
    """The rows as JSON lines."""
    return (json.dumps(row.to_json(), ensure_ascii=False) + "\n" for row in rows)


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(entry) for entry in value]
    return dict(value) if isinstance(value, Mapping) else value
