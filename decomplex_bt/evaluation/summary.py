"""The summary of an evaluation: a pure function of its rows."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from statistics import fmean, median
from typing import Any

from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.evaluation.row import OUTCOMES, STAGES, Row

_HEADER = (
    "agent", "instruction", "success over feasible", "met at start", "understood", "infeasible", "steps", "failures",
)  # fmt: skip
INFEASIBLE_WARNING = 0.4
"""Share of infeasible episodes of an instruction above which there is a warning."""


@dataclass(frozen=True, slots=True)
class BranchCount:
    """How often a condition came out true, false or undecided in feasible episodes; `task` is its number."""

    task: int
    true: int
    false: int
    undecided: int

    def to_json(self) -> dict[str, int]:
        return {"task": self.task, "true": self.true, "false": self.false, "undecided": self.undecided}


@dataclass(frozen=True, slots=True)
class Summary:
    """What rows come to: those of one agent, or of one instruction under one agent (`example`).

    `success` is over the feasible episodes, `infeasible` over those that ground. `understood`: readings that come to
    what the gold ones do, over the episodes of an agent that reads; `lucky`: successes of the others. `met_at_start`:
    nothing was left to do from the first, which is success as well, over the feasible episodes. `steps`,
    `sim_seconds`, `replans`: medians over the successes, None where there are none. `spl`: success weighted by path
    length, the mean over the feasible episodes, None where there are none. `branches`: of one instruction.
    `instructions`: one summary for each.
    """

    agent: str
    episodes: int
    outcomes: tuple[tuple[str, int], ...]
    success: Proportion
    infeasible: Proportion
    understood: Proportion
    lucky: int
    met_at_start: Proportion
    stages: tuple[tuple[str, int], ...]
    steps: float | None
    sim_seconds: float | None
    replans: float | None
    spl: float | None = None
    example: str | None = None
    branches: tuple[BranchCount, ...] = ()
    instructions: tuple[Summary, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        """What should make a reader doubt the figures, in words."""
        own = tuple(self._own_warnings()) if self.example is not None else ()
        return (*own, *(warning for part in self.instructions for warning in part.warnings))

    def _own_warnings(self) -> Iterable[str]:
        share = self.infeasible.value
        if share is not None and share > INFEASIBLE_WARNING:
            yield f"{self.example}: {share:.0%} of the episodes are infeasible"
        for branch in self.branches:
            if not (branch.true and branch.false):
                side = "true" if branch.false else "false" if branch.true else "decided"
                yield f"{self.example}: the condition of task {branch.task} was never {side}"

    def to_json(self) -> dict[str, Any]:
        """Plain values; the summaries of the instructions inside."""
        value: dict[str, Any] = {"agent": self.agent}
        if self.example is not None:
            value["example"] = self.example
        value |= {
            "episodes": self.episodes,
            "outcomes": dict(self.outcomes),
            "success": self.success.to_json(),
            "infeasible": self.infeasible.to_json(),
            "failures_by_stage": dict(self.stages),
            "understood": self.understood.to_json(),
            "lucky_successes": self.lucky,
            "met_at_start": self.met_at_start.to_json(),
            "median_steps": self.steps,
            "median_sim_seconds": self.sim_seconds,
            "median_replans": self.replans,
            "spl": self.spl,
        }
        if self.example is not None:
            value["branches"] = [branch.to_json() for branch in self.branches]
        else:
            value["warnings"] = list(self.warnings)
            value["instructions"] = [part.to_json() for part in self.instructions]
        return value


def summarise(rows: Iterable[Row]) -> tuple[Summary, ...]:
    """One summary for each agent, in the order in which agents and instructions first occur."""
    rows = tuple(rows)
    agents = _firsts(row.agent for row in rows)
    return tuple(_of_agent(agent, [row for row in rows if row.agent == agent]) for agent in agents)


def tabulate(summaries: Sequence[Summary]) -> str:
    """The summaries as a plain table, a line for each agent and instruction, the agents' totals first."""
    lines = [_HEADER, *(_cells(summary) for summary in summaries)]
    lines += [_cells(part) for summary in summaries for part in summary.instructions]
    return _aligned(lines)


def tabulate_conditions(summaries: Sequence[Summary]) -> str:
    """How often each condition came out true and false, a line for each agent and condition; "" for none."""
    lines: list[tuple[str, ...]] = [("agent", "condition", "true", "false", "undecided", "true of decided")]
    ends = []
    for summary in summaries:
        counts = [(part.example, branch) for part in summary.instructions for branch in part.branches]
        for example, branch in counts:
            share = Proportion(branch.true, branch.true + branch.false)
            numbers = map(str, (branch.true, branch.false, branch.undecided, share))
            lines.append((summary.agent, f"{example}, task {branch.task}", *numbers))
        if counts:
            both = sum(bool(branch.true and branch.false) for _, branch in counts)
            ends.append(f"{summary.agent}: both branches occurred for {both} of {len(counts)} conditions")
    return "\n".join((_aligned(lines), *ends)) if ends else ""


def _of_agent(agent: str, rows: Sequence[Row]) -> Summary:
    parts = tuple(
        _summary(agent, [row for row in rows if row.example == example], example=example)
        for example in _firsts(row.example for row in rows)
    )
    return _summary(agent, rows, instructions=parts)


def _summary(
    agent: str, rows: Sequence[Row], *, example: str | None = None, instructions: tuple[Summary, ...] = ()
) -> Summary:
    outcomes = Counter(row.outcome for row in rows)
    stages = Counter(row.stage for row in rows if row.stage is not None)
    successes = [row for row in rows if row.outcome == "success"]
    readings = [row.understood for row in rows if row.understood is not None]
    feasible = outcomes["success"] + outcomes["failure"]
    return Summary(
        agent=agent,
        episodes=len(rows),
        outcomes=tuple((outcome, outcomes[outcome]) for outcome in OUTCOMES),
        success=Proportion(outcomes["success"], feasible),
        infeasible=Proportion(outcomes["infeasible"], feasible + outcomes["infeasible"]),
        stages=tuple((stage, stages[stage]) for stage in STAGES),
        steps=_median([row.steps for row in successes]),
        sim_seconds=_median([row.sim_seconds for row in successes]),
        replans=_median([row.replans for row in successes]),
        spl=_mean([row.spl for row in rows if row.spl is not None]),
        understood=Proportion(sum(readings), len(readings)),
        lucky=sum(row.understood is False for row in successes),
        met_at_start=Proportion(sum(row.met_at_start for row in rows if row.is_feasible), feasible),
        example=example,
        branches=_branches(rows) if example is not None else (),
        instructions=instructions,
    )


def _branches(rows: Sequence[Row]) -> tuple[BranchCount, ...]:
    truths: dict[int, Counter[bool | None]] = {}
    for row in rows:
        for branch in row.branches if row.is_feasible else ():
            truths.setdefault(branch["task"], Counter())[branch["truth"]] += 1
    return tuple(BranchCount(task, c[True], c[False], c[None]) for task, c in sorted(truths.items()))


def _cells(summary: Summary) -> tuple[str, ...]:
    failures = ", ".join(f"{stage} {count}" for stage, count in summary.stages if count and stage != "infeasible")
    return (
        summary.agent,
        summary.example or "all",
        str(summary.success),
        _percent(summary.met_at_start),
        _percent(summary.understood),
        _percent(summary.infeasible),
        "-" if summary.steps is None else f"{summary.steps:.0f}",
        failures or "-",
    )


def _aligned(lines: Sequence[tuple[str, ...]]) -> str:
    widths = [max(len(line[column]) for line in lines) for column in range(len(lines[0]))]
    padded = [[cell.ljust(width) for cell, width in zip(line, widths, strict=True)] for line in lines]
    return "\n".join("  ".join(cells).rstrip() for cells in padded)


def _percent(share: Proportion) -> str:
    return "-" if share.value is None else f"{share.value:.0%}"


def _median(values: Sequence[float]) -> float | None:
    return round(float(median(values)), 3) if values else None


def _mean(values: Sequence[float]) -> float | None:
    return round(fmean(values), 4) if values else None


def _firsts(values: Iterable[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(values))
