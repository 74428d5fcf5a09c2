"""Monte-Carlo: instructions times drawn worlds, each an episode, judged by the corpus' gold flow.

All episodes are fixed before the first one runs, so that no figure depends on which of them were quick; rows come out
in that order, and are the same for any number of processes. Environments are reached through their Gymnasium id alone.
"""

from __future__ import annotations

import atexit
import gc
import logging
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, Literal

import gymnasium as gym

import decomplex_bt
from decomplex_bt.corpus import Example
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import InputError, check_jobs, is_whole
from decomplex_bt.evaluation.blame import Blame, blame_reading, blame_run
from decomplex_bt.evaluation.row import Outcome, Row
from decomplex_bt.instruction import Instruction
from decomplex_bt.planning.planner import Planner
from decomplex_bt.processes import results

AGENTS = ("tree", "oracle", "random", "idle")
"""The policies an environment offers; only "tree" understands text, the others are given the gold flow."""
READERS = ("tree", "oracle")
"""Those that go by a reading of the instruction."""
Maker = Callable[[Any], Any]
"""Makes, of an environment, a policy of one's own: `reset(observation, info)` and `act(observation)`, and `failures`,
`plans`, `replans` where it has them. With several processes it must be a function that can be pickled."""
Agents = Sequence[str | Maker] | Mapping[str, str | Maker]
"""Policies by what they are called themselves, or by the names that the rows are to have."""
CHUNK = 5
"""Episodes that a process takes at once; few, so that none is left with the slow ones."""
Progress = Callable[[int, int], None]
"""Told after each episode how many of how many are done."""
ReadingSource = Literal["own", "gold"]
_HIGHEST = {"balance": 0.5, "max_seconds": float("inf"), "grasp_slip": 1.0, "missed_detection": 1.0, "meddling": 60.0}
"""The highest value of each number of a `Setup`, as the reset options have it; the lowest is 0."""

logger = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Setup:
    """What all episodes of an evaluation have in common.

    `domain`: name or folder. `balance` in [0, 0.5], `max_seconds` of simulated time: None as the environment has them.
    `noise`: slips and misses, as the house has them, or with the probabilities `grasp_slip` and `missed_detection`.
    `meddling`: things that somebody else moves in a minute of simulated time, on average, from 0 to 60.
    Raises `InputError` for a number out of its range, and for what is none of these.
    """

    env_id: str = "decomplex_bt/Household-v0"
    domain: str | Path = "household"
    balance: float | None = None
    max_seconds: float | None = None
    noise: bool = True
    grasp_slip: float | None = None
    missed_detection: float | None = None
    meddling: float | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.env_id, str):
            raise InputError(f"env_id is {self.env_id!r}; expected the id of an environment, as in {Setup.env_id!r}")
        if not isinstance(self.domain, str | Path):
            raise InputError(f"domain is {self.domain!r}; expected the name of a shipped one or a folder")
        for name, highest in _HIGHEST.items():
            value = getattr(self, name)
            is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
            if value is not None and not (is_number and 0.0 <= value <= highest):
                raise InputError(f"{name} is {value!r}; expected a number from 0 to {highest:g}")
        if not isinstance(self.noise, bool):
            raise InputError(f"noise is {self.noise!r}; expected True or False")

    def options(self) -> dict[str, Any]:
        """The reset options that they come to."""
        options = {
            "balance": self.balance,
            "max_seconds": self.max_seconds,
            "noise": self.noise,
            "grasp_slip": self.grasp_slip,
            "missed_detection": self.missed_detection,
            "meddling": self.meddling,
        }
        return {key: value for key, value in options.items() if value is not None}


@dataclass(frozen=True, slots=True)
class Episode:
    """One episode to be run. `reading`: how the agent is to understand it; None with `problem`: it could not. `maker`:
    of a policy that the environment does not offer."""

    example: str
    gold: Instruction
    seed: int
    agent: str
    source: ReadingSource
    reading: Instruction | None
    problem: str | None = None
    maker: Maker | None = None


def evaluate(
    examples: Sequence[Example],
    *,
    episodes: int = 20,
    seed: int = 0,
    jobs: int = 1,
    agent: str | Maker = "tree",
    reading: ReadingSource = "own",
    setup: Setup | None = None,
    progress: Progress | None = None,
) -> tuple[Row, ...]:
    """The rows of `episodes` worlds for every example, world k with seed `seed + k`.

    `agent`: the name of a policy, or what makes one of the environment (`Maker`), which the rows name as it is named.
    `reading`: whether the tree agent understands the text itself or is given the gold flow. `jobs`: processes, -1 for
    one a core; joblib's `parallel_config` chooses another backend. Raises `InputError` for options that make no sense.
    """
    return evaluate_agents(
        examples,
        (agent,),
        episodes=episodes,
        seed=seed,
        jobs=jobs,
        reading=reading,
        setup=setup,
        progress=progress,
    )


def evaluate_agents(
    examples: Sequence[Example],
    agents: Agents = ("tree", "oracle", "random"),
    *,
    episodes: int = 20,
    seed: int = 0,
    jobs: int = 1,
    reading: ReadingSource = "own",
    setup: Setup | None = None,
    progress: Progress | None = None,
) -> tuple[Row, ...]:
    """As `evaluate` for several agents in the same worlds, or for a mapping of names to them; of the rows,
    `summary.tabulate(summary.summarise(rows))` shows them beside each other.

    Raises `InputError` also where one is named twice, for its episodes would count as twice as many, or as a policy of
    the environment is without being it.
    """
    check_jobs(jobs)
    setup = Setup() if setup is None else setup
    if not isinstance(setup, Setup):
        raise InputError(f"setup is {setup!r}; expected a Setup, or None")
    by_name = _by_name(agents)
    domain = load_domain(setup.domain)
    planned = [
        episode
        for name, agent in by_name.items()
        for episode in plan_episodes(
            examples, episodes=episodes, seed=seed, agent=agent, name=name, reading=reading, domain=domain
        )
    ]
    return tuple(run_episodes(planned, setup, jobs=jobs, progress=progress))


def _by_name(agents: Any) -> Mapping[str, Any]:
    """The agents by the names that the rows have. Raises `InputError`."""
    if isinstance(agents, Mapping):
        return agents
    if isinstance(agents, str) or not isinstance(agents, Iterable):
        raise InputError(f"agents is {agents!r}; expected a sequence of names, as in ({agents!r},)")
    by_name: dict[str, Any] = {}
    for agent in agents:
        name = _name_of(agent)
        if name in by_name:
            raise InputError(
                f"the agent {name!r} is named twice; name each once, in a mapping if need be, as in {{'mine': ...}}"
            )
        by_name[name] = agent
    return by_name


def those_that_ground(examples: Sequence[Example], domain: Domain) -> tuple[Example, ...]:
    """The examples whose gold flow asks for what there is in the domain's house."""
    from decomplex_bt.planning.grounding import ground

    def grounds(example: Example) -> bool:
        try:
            ground(example.instruction, domain)
        except InputError:
            return False
        return bool(example.instruction.tasks)

    return tuple(example for example in examples if grounds(example))


def plan_episodes(
    examples: Sequence[Example],
    *,
    episodes: int,
    seed: int,
    agent: str | Maker,
    domain: Domain,
    name: str | None = None,
    reading: ReadingSource = "own",
) -> tuple[Episode, ...]:
    """All episodes, fixed. Every text is understood here, once and in a batch. `name`: of the agent, in the rows; None:
    as it is named. Raises `InputError`."""
    name = _name_of(agent) if name is None else name
    _check_agent(name, agent)
    if not is_whole(episodes) or episodes < 1:
        raise InputError(f"episodes is {episodes!r}; expected at least one world for each instruction")
    if not is_whole(seed) or seed < 0:
        raise InputError(f"seed is {seed!r}; expected a whole number from 0")
    if reading not in ("own", "gold"):
        raise InputError(f"reading is {reading!r}; expected 'own' or 'gold'")
    _check_examples(examples)
    source: ReadingSource = reading if agent == "tree" else "gold"
    readings = _understand(examples, domain) if source == "own" else [example.instruction for example in examples]
    return tuple(
        Episode(
            example.id,
            example.instruction,
            int(seed) + world,
            name,
            source,
            found if isinstance(found, Instruction) else None,
            None if isinstance(found, Instruction) else found,
            None if isinstance(agent, str) else agent,
        )
        for example, found in zip(examples, readings, strict=True)
        for world in range(episodes)
    )


def _name_of(agent: Any) -> str:
    return agent if isinstance(agent, str) else getattr(agent, "__name__", type(agent).__name__)


def _check_agent(name: Any, agent: Any) -> None:
    if not callable(agent) and agent not in AGENTS:
        raise InputError(
            f"there is no agent {agent!r}; known: {', '.join(AGENTS)}; or a function that makes one of an environment"
        )
    if not isinstance(name, str) or not name:
        raise InputError(f"an agent is named {name!r}; expected a text")
    if name != agent and (name in AGENTS or isinstance(agent, str)):
        raise InputError(
            f"{name!r} names an agent that is {agent!r}; the names {', '.join(AGENTS)} are those of the environment's "
            "own policies, which have no others; give yours another, as in {'mine': ...}"
        )


def _check_examples(examples: Any) -> None:
    if not isinstance(examples, Sequence) or isinstance(examples, str):
        raise InputError(
            f"examples is a {type(examples).__name__}; expected corpus Examples, as `read_corpus` gives them"
        )
    if not examples:
        raise InputError("the corpus holds no example; give one with at least one instruction")
    if odd := next((example for example in examples if not isinstance(example, Example)), None):
        raise InputError(
            f"examples holds a value of type {type(odd).__name__}; expected corpus Examples, as `read_corpus` gives "
            "them, or Example(id, instruction) of an annotated Instruction"
        )


def run_episodes(
    planned: Sequence[Episode], setup: Setup, *, jobs: int = 1, progress: Progress | None = None
) -> Iterator[Row]:
    """The rows of the episodes, in their order, as they come."""
    from joblib import delayed

    size = 1 if jobs == 1 else CHUNK
    chunks = [planned[start : start + size] for start in range(0, len(planned), size)]
    done = 0
    for rows in results((delayed(_run_chunk)(chunk, setup) for chunk in chunks), jobs):
        for row in rows:
            done += 1
            if progress is not None:
                progress(done, len(planned))
            yield row


def run_episode(episode: Episode, setup: Setup) -> Row:
    """One episode from reset to verdict, as a row."""
    env, planner, _ = _bench(setup)
    try:
        observation, info = env.reset(seed=episode.seed, options={"instruction": episode.gold, **setup.options()})
    except InputError as error:
        return _row(episode, "ungroundable", cause=("grounding", str(error)))
    ended = partial(_ended, episode, met_at_start=bool(info["is_success"]))
    misread = _misreading(episode, setup)
    if episode.reading is None:
        return ended(info, misread)
    make = _maker_of(episode, env, planner)
    steps, is_over, truncated = 0, False, False
    try:
        policy = make()
        try:
            policy.reset(observation, info)
        except InputError as error:
            return ended(info, misread or ("grounding", str(error)))
        while not is_over:
            observation, _, terminated, truncated, info = env.step(policy.act(observation))
            steps += 1
            is_over = terminated or truncated
        failures = tuple(failure.to_json() for failure in getattr(policy, "failures", ()))
        counts: dict[str, Any] = {name: getattr(policy, name, 0) for name in ("plans", "replans")}
    except Exception as error:  # one broken episode must not lose the others
        logger.exception("%s, seed %d: the episode broke off", episode.example, episode.seed)
        broke: Blame = ("execution", f"broke off: {type(error).__name__}: {error}")
        return ended(info, broke, steps=steps, understood=misread is None)
    found = None
    if not info["is_success"]:
        found = misread or blame_run(failures, info["violations"], is_truncated=truncated)
    counts["understood"] = misread is None
    return ended(info, found, steps=steps, failures=failures, **counts)


def _maker_of(episode: Episode, env: gym.Env[Any, Any], planner: Planner) -> Callable[[], Any]:
    """What makes the episode's policy."""
    if episode.maker is not None:
        return partial(episode.maker, env)
    offered = env.get_wrapper_attr("policy")
    return partial(offered, episode.agent, flow=episode.reading, planner=planner, seed=episode.seed)


def _misreading(episode: Episode, setup: Setup) -> Blame | None:
    """What is wrong with the agent's reading; None where nothing is, or where it reads nothing."""
    if episode.reading is None:
        return "understanding", episode.problem or "not understood"
    if episode.source == "gold":
        return None
    return _compared(episode.reading, episode.gold, setup)


@lru_cache(maxsize=64)
def _compared(reading: Instruction, gold: Instruction, setup: Setup) -> Blame | None:
    return blame_reading(reading, gold, load_domain(setup.domain))


def _understand(examples: Sequence[Example], domain: Domain) -> list[Instruction | str]:
    """The agent's own reading of every text; where a text cannot be read at all, why."""
    from decomplex_bt.understanding.interpreter import Interpreter, check_text

    problems: dict[str, str] = {}
    for example in examples:
        try:
            check_text(example.instruction.text)
        except InputError as error:
            problems[example.id] = str(error)
    usable = [example for example in examples if example.id not in problems]
    interpreter = Interpreter.load(domain)
    read = interpreter.interpret_batch(example.instruction.text for example in usable)
    readings = dict(zip((example.id for example in usable), read, strict=True))
    return [readings.get(example.id) or problems[example.id] for example in examples]


def _run_chunk(episodes: Iterable[Episode], setup: Setup) -> list[Row]:
    return [run_episode(episode, setup) for episode in episodes]


@lru_cache(maxsize=2)
def _bench(setup: Setup) -> tuple[gym.Env[Any, Any], Planner, Domain]:
    """A process' environment, its planner (for its cache) and the domain."""
    from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

    assert decomplex_bt  # importing it registers the ids
    env = gym.make(setup.env_id, domain=setup.domain)
    return env, PyperplanPlanner(), load_domain(setup.domain)


@atexit.register
def _clear_away() -> None:
    """Frees the worlds while pymunk can still free its own."""
    _bench.cache_clear()
    gc.collect()


def _ended(
    episode: Episode,
    info: dict[str, Any],
    found: Blame | None,
    *,
    met_at_start: bool,
    understood: bool = False,
    **counts: Any,
) -> Row:
    """The row of an episode that was begun; `found`: where and why it failed, None for a success."""
    outcome: Outcome = "success" if found is None else "failure"
    if info["feasible"] is False:
        outcome, found = "infeasible", ("infeasible", info["infeasible_cause"])
    return _row(
        episode,
        outcome,
        cause=found,
        sim_seconds=round(float(info["seconds"]), 2),
        **_lengths(outcome, info, met_at_start=met_at_start),
        met_at_start=met_at_start,
        goals_met=info["goal_conditions_met"],
        goals_total=info["goal_conditions_total"],
        branches=tuple(info["branches"]),
        violations=tuple(info["violations"]),
        moved_by_others=info["moved_by_others"],
        understood=understood if episode.agent in READERS else None,
        **counts,
    )


def _lengths(outcome: Outcome, info: dict[str, Any], *, met_at_start: bool) -> dict[str, float | None]:
    """What a row says of the way. Whose first step ended the episode, whatever it was, has gone no way round."""
    driven, shortest = float(info["path_length"]), float(info["shortest_length"])
    lengths = {"path_length": round(driven, 3), "shortest_length": None, "spl": 0.0 if outcome == "failure" else None}
    if outcome == "success" and shortest >= 0:  # below 0 there is none
        longer = max(driven, shortest)
        spl = 1.0 if met_at_start or not longer else round(shortest / longer, 4)
        lengths |= {"shortest_length": round(shortest, 3), "spl": spl}
    return lengths


def _row(episode: Episode, outcome: Outcome, *, cause: tuple[Any, str] | None = None, **found: Any) -> Row:
    stage, why = cause or (None, None)
    return Row(
        example=episode.example,
        seed=episode.seed,
        agent=episode.agent,
        reading=episode.source,
        judged_by="gold",
        flow=tuple(episode.gold.flow.to_json()),
        outcome=outcome,
        stage=stage,
        cause=why,
        **found,
    )
