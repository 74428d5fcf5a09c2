"""Monte-Carlo: instructions times drawn worlds, each an episode, judged by the corpus' gold flow.

All episodes are fixed before the first one runs, so that no figure depends on which of them were quick; rows come out
in that order, and are the same for any number of processes as long as planners and makers give the same for the same:
one that goes by a clock, or by the episodes before, of which each process meets others, may give other rows.
Environments are reached through their Gymnasium id alone.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from functools import cache, lru_cache, partial
from pickle import PicklingError
from typing import Any, Literal

import gymnasium as gym

from decomplex_bt.corpus import Example
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import InputError, check_jobs, is_whole
from decomplex_bt.evaluation.agents import (
    AGENTS,
    READERS,
    Agents,
    Maker,
    by_name,
    check_agent,
    is_given_flow,
    make_policy,
    name_of,
    needs_flow,
)
from decomplex_bt.evaluation.blame import Blame, blame_reading, blame_run
from decomplex_bt.evaluation.environments import check_env, domain_in, make_env, offered
from decomplex_bt.evaluation.lending import lend
from decomplex_bt.evaluation.planners import Planning, planner_of
from decomplex_bt.evaluation.row import Outcome, Row
from decomplex_bt.evaluation.sendable import check_sendable
from decomplex_bt.evaluation.setup import Setup
from decomplex_bt.instruction import Instruction
from decomplex_bt.planning.planner import Planner
from decomplex_bt.processes import results

__all__ = [
    "AGENTS",
    "CHUNK",
    "READERS",
    "Agents",
    "Episode",
    "Maker",
    "Progress",
    "ReadingSource",
    "Readings",
    "Setup",
    "evaluate",
    "evaluate_agents",
    "plan_episodes",
    "run_episode",
    "run_episodes",
    "those_that_ground",
]

CHUNK = 5
"""Episodes that a process takes at once; few, so that none is left with the slow ones."""
Progress = Callable[[int, int], None]
"""Told after each episode how many of how many are done."""
ReadingSource = Literal["own", "gold"]
Readings = Sequence[Instruction | str]
"""The agent's own reading of every example; of a text that cannot be read at all, why."""

logger = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Episode:
    """One episode to be run. `reading`: how the agent is to understand it; None with `problem`: it could not. `reads`:
    whether it goes by a reading. `maker`: of a policy that the environment does not offer; what that goes by may turn
    out once it is made."""

    example: str
    gold: Instruction
    seed: int
    agent: str
    source: ReadingSource
    reading: Instruction | None
    problem: str | None = None
    reads: bool = False
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
    planner: Planning | None = None,
    progress: Progress | None = None,
) -> tuple[Row, ...]:
    """The rows of `episodes` worlds for every example, world k with seed `seed + k`.

    `agent`: the name of a policy, or what makes one of the environment (`Maker`), which the rows name as it is named.
    `reading`: whether the tree agent understands the text itself or is given the gold flow. `jobs`: processes, -1 for
    one a core; joblib's `parallel_config` chooses another backend. `planner`: in place of the setup's (`Setup`). Raises
    `InputError`, before any episode, for options that make no sense and an environment that cannot be made or does not
    offer the agent; also for a planner or a maker that other processes need and cannot have.
    """
    return evaluate_agents(
        examples,
        (agent,),
        episodes=episodes,
        seed=seed,
        jobs=jobs,
        reading=reading,
        setup=setup,
        planner=planner,
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
    planner: Planning | None = None,
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
    setup = setup if planner is None else replace(setup, planner=planner)
    domain = load_domain(setup.domain)
    readings = cache(lambda: _understand([example.instruction.text for example in examples], domain))
    planned = [
        episode
        for name, agent in by_name(agents).items()
        for episode in plan_episodes(
            examples,
            episodes=episodes,
            seed=seed,
            agent=agent,
            name=name,
            reading=reading,
            domain=domain,
            readings=readings,
        )
    ]
    return tuple(run_episodes(planned, setup, jobs=jobs, progress=progress))


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
    readings: Callable[[], Readings] | None = None,
) -> tuple[Episode, ...]:
    """All episodes, fixed. Every text is understood here, once and in a batch; `readings` gives what was understood
    before. `name`: of the agent, in the rows; None: as it is named. Raises `InputError`."""
    name = name_of(agent) if name is None else name
    check_agent(name, agent)
    if not is_whole(episodes) or episodes < 1:
        raise InputError(f"episodes is {episodes!r}; expected at least one world for each instruction")
    if not is_whole(seed) or seed < 0:
        raise InputError(f"seed is {seed!r}; expected a whole number from 0")
    if reading not in ("own", "gold"):
        raise InputError(f"reading is {reading!r}; expected 'own' or 'gold'")
    _check_examples(examples)
    source: ReadingSource = reading if agent == "tree" or is_given_flow(agent) else "gold"
    texts = [example.instruction.text for example in examples]
    understood = (readings or partial(_understand, texts, domain)) if source == "own" else None
    gone_by: Readings = [example.instruction for example in examples] if understood is None else understood()
    return tuple(
        Episode(
            example.id,
            example.instruction,
            int(seed) + world,
            name,
            source,
            found if isinstance(found, Instruction) else None,
            None if isinstance(found, Instruction) else found,
            agent in READERS or is_given_flow(agent),
            None if isinstance(agent, str) else agent,
        )
        for example, found in zip(examples, gone_by, strict=True)
        for world in range(episodes)
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
    """The rows of the episodes, in their order, as they come. Raises `InputError` for a setup in which none can be
    run."""
    from joblib import delayed

    check_env(setup, {episode.agent: episode.gold for episode in planned if episode.maker is None})
    size = 1 if jobs == 1 else CHUNK
    chunks = [planned[start : start + size] for start in range(0, len(planned), size)]
    lent = replace(setup, planner=lend(setup.planner))
    done = 0
    try:
        for rows in results((delayed(_run_chunk)(chunk, lent) for chunk in chunks), jobs):
            for row in rows:
                done += 1
                if progress is not None:
                    progress(done, len(planned))
                yield row
    except PicklingError:
        makers = {episode.agent: episode.maker for episode in planned}
        check_sendable("planner", setup.planner, remedy="give a function of a module that makes one, or jobs=1")
        for name, maker in makers.items():
            check_sendable(f"the agent {name!r}", maker, remedy="give a function of a module, or jobs=1")
        raise


def run_episode(episode: Episode, setup: Setup) -> Row:
    """One episode from reset to verdict, as a row. Raises `InputError` for a setup that no episode can be run in."""
    with closing(make_env(setup)) as env:
        return _run_in(env, episode, setup)


def _run_in(env: gym.Env[Any, Any], episode: Episode, setup: Setup) -> Row:
    planner = planner_of(setup.planner)
    try:
        observation, info = env.reset(seed=episode.seed, options={"instruction": episode.gold, **setup.options()})
    except InputError as error:
        return _row(episode, "ungroundable", cause=("grounding", str(error)))
    domain = domain_in(env, setup)
    ended = partial(_ended, met_at_start=bool(info["is_success"]))
    if episode.reading is None and episode.maker is not None and not needs_flow(episode.maker):
        episode = _as_left_alone(episode)
    misread = _misreading(episode, domain)
    if misread and episode.reading is None:
        return ended(episode, info, misread)
    make = _maker_of(episode, env, planner, setup)
    steps, is_over, truncated = 0, False, False
    try:
        policy = make()
        try:
            policy.reset(observation, info)
        except InputError as error:
            episode = _as_refused(episode, policy, domain)
            return ended(episode, info, _misreading(episode, domain) or ("grounding", str(error)))
        episode = _as_gone_by(episode, getattr(policy, "instruction", None))
        misread = _misreading(episode, domain)
        while not is_over:
            observation, _, terminated, truncated, info = env.step(policy.act(observation))
            steps += 1
            is_over = terminated or truncated
        failures = tuple(failure.to_json() for failure in getattr(policy, "failures", ()))
        counts: dict[str, Any] = {name: getattr(policy, name, 0) for name in ("plans", "replans")}
    except Exception as error:  # one broken episode must not lose the others
        logger.exception("%s, seed %d: the episode broke off", episode.example, episode.seed)
        broke: Blame = ("execution", f"broke off: {type(error).__name__}: {error}")
        return ended(episode, info, broke, steps=steps, understood=misread is None)
    found = None
    if not info["is_success"]:
        found = misread or blame_run(failures, info["violations"], is_truncated=truncated)
    counts["understood"] = misread is None
    return ended(episode, info, found, steps=steps, failures=failures, **counts)


def _maker_of(episode: Episode, env: gym.Env[Any, Any], planner: Planner, setup: Setup) -> Callable[[], Any]:
    """What makes the episode's policy."""
    if episode.maker is not None:
        is_chosen = setup.planner is not None
        return partial(make_policy, episode.maker, env, flow=episode.reading, planner=planner, is_chosen=is_chosen)
    return partial(offered(env, setup), episode.agent, flow=episode.reading, planner=planner, seed=episode.seed)


def _as_left_alone(episode: Episode) -> Episode:
    """The episode of a policy of one's own that can do without the reading that we do not have: it may read itself."""
    return replace(episode, problem=None, reads=False)


def _as_gone_by(episode: Episode, instruction: Any) -> Episode:
    """The episode of a policy of one's own that tells by what instruction it goes."""
    if episode.maker is None or not isinstance(instruction, Instruction):
        return episode
    is_gold = episode.source == "gold" if episode.reads else instruction == episode.gold
    return replace(episode, source="gold" if is_gold else "own", reading=instruction, reads=True)


def _as_refused(episode: Episode, policy: Any, domain: Domain) -> Episode:
    """The episode of a tree agent of one's own that refused what it had read: that is read anew."""
    from decomplex_bt.behaviour.agent import TreeAgent

    if episode.reads or not isinstance(policy, TreeAgent):
        return episode
    found = policy.flow or _understand([episode.gold.text], domain)[0]
    if isinstance(found, Instruction):
        return _as_gone_by(episode, found)
    return replace(episode, source="own", reading=None, problem=found, reads=True)


def _misreading(episode: Episode, domain: Domain) -> Blame | None:
    """What is wrong with the agent's reading; None where nothing is, or where it reads nothing."""
    if not episode.reads or episode.reading == episode.gold:
        return None
    if episode.reading is None:
        return "understanding", episode.problem or "not understood"
    return _compared(episode.reading, episode.gold, domain)


@lru_cache(maxsize=64)
def _compared(reading: Instruction, gold: Instruction, domain: Domain) -> Blame | None:
    return blame_reading(reading, gold, domain)


def _understand(texts: Sequence[str], domain: Domain) -> list[Instruction | str]:
    """The agent's own reading of every text; where a text cannot be read at all, why."""
    from decomplex_bt.understanding.interpreter import Interpreter, check_text

    problems: dict[str, str] = {}
    for text in texts:
        try:
            check_text(text)
        except InputError as error:
            problems[text] = str(error)
    usable = [text for text in texts if text not in problems]
    readings = dict(zip(usable, Interpreter.load(domain).interpret_batch(usable), strict=True))
    return [problems.get(text) or readings[text] for text in texts]


def _run_chunk(episodes: Iterable[Episode], setup: Setup) -> list[Row]:
    return [run_episode(episode, setup) for episode in episodes]


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
        understood=understood if episode.reads else None,
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
