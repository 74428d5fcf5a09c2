"""What planning costs: a plan among 30 things, the same among 1,000, and one decision of a pursuit.

Run it with `python benchmarks/planning.py`. Read the ratios, not the figures: all are measured in one run, interleaved.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import replace

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.house import Item
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.pddl import Atom
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.problem import belief_problem
from decomplex_bt.planning.pursuit import pursue
from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

REPEATS = 30
"""Rounds; each measures every row once."""
GOAL = (Atom("has", ("user", "pen_1")),)
"""A plan of twelve steps through three rooms and two doorways."""
KEPT = ("pen_1", "pen_2", "cup_1", "cup_2", "rag")


def domain_with(count: int) -> Domain:
    """The household with this many things: some of its own, the rest books."""
    household = load_domain()
    things = {name: household.house.things[name] for name in KEPT}
    things |= {f"volume_{i}": Item(kind="book") for i in range(count - len(things))}
    return replace(household, house=household.house.model_copy(update={"things": things}))


def belief_of(domain: Domain) -> Belief:
    belief = Belief(domain)
    for _ in range(2):
        belief.update(Percept(room="kitchen", places={"user": "living_room"}))
    return belief


def measure(rows: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Median seconds of each row over interleaved rounds, the first round left out."""
    seconds: dict[str, list[float]] = {name: [] for name in rows}
    for _ in range(REPEATS + 1):
        for name, run in rows.items():
            start = time.perf_counter()
            run()
            seconds[name].append(time.perf_counter() - start)
    return {name: statistics.median(values[1:]) for name, values in seconds.items()}


def main() -> None:
    few, many = (belief_of(domain_with(count)) for count in (30, 1000))
    household = belief_of(load_domain())
    text = "[Bring](1:bringing) [me](1:recipient) [the cup and the plate](1:object)"
    task = ground(read_markup(text, household.domain.ontology, flow=[1]), household.domain).tasks[0]
    cached = PyperplanPlanner()
    rows: dict[str, Callable[[], object]] = {
        "plan, 30 things around": lambda: PyperplanPlanner().solve(belief_problem(few, GOAL)),
        "plan, 1,000 things around": lambda: PyperplanPlanner().solve(belief_problem(many, GOAL)),
        "plan, 30 things, from the cache": lambda: cached.solve(belief_problem(few, GOAL)),
        "one decision of a pursuit": lambda: pursue(task, household, {}, since=0),
        "one look taken in": lambda: household.update(household.percept),
    }
    found = measure(rows)
    for name, value in found.items():
        print(f"{name:34} {1e3 * value:9.3f} ms")
    print(f"ratio of 1,000 things to 30: {found['plan, 1,000 things around'] / found['plan, 30 things around']:.2f}")


if __name__ == "__main__":
    main()
