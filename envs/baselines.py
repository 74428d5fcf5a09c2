"""Policies to compare with, all behind one interface: the tree agent, an oracle that knows the world, random, idle."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from gymnasium.spaces import Dict
from numpy.typing import NDArray

from decomplex_bt.envs.feasibility import feasible_bindings
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.sensing import FIRST_STATE, INSPECTED, PLACE, VISIBLE, X, Y
from decomplex_bt.envs.truth import Truth
from decomplex_bt.envs.walking import is_near_person
from decomplex_bt.errors import InputError
from decomplex_bt.planning.ground_task import FINDING_OUT
from decomplex_bt.planning.pddl import GroundAction

if TYPE_CHECKING:
    from decomplex_bt.behaviour.agent import TreeAgent
    from decomplex_bt.behaviour.failure import Failure
    from decomplex_bt.corpus import Example
    from decomplex_bt.domain.loader import Domain
    from decomplex_bt.envs.household import HouseholdEnv
    from decomplex_bt.envs.world import World
    from decomplex_bt.instruction import Instruction
    from decomplex_bt.planning.planner import Planner

    Reading = Instruction | Example | None

Places = NDArray[np.int64]
_LOOKS = 4
"""Looks at the truth that a belief takes in before it believes that what is not there is not there."""


class Policy(Protocol):
    """What acts in an environment: `reset` once per episode, then an action for each observation.

    `failures`: why tasks failed, in order, where the policy knows of tasks. `plans`, `replans`: counts of the episode.
    """

    @property
    def done(self) -> bool:
        """Whether it has sent its last action."""

    def reset(self, observation: Any, info: Mapping[str, Any]) -> None:
        """Begins an episode. Raises `InputError` for an instruction that the policy can do nothing with."""

    def act(self, observation: Any) -> Any:
        """The action for this observation."""

    @property
    def failures(self) -> tuple[Failure, ...]: ...

    @property
    def plans(self) -> int: ...

    @property
    def replans(self) -> int: ...


def make_policy(
    name: str,
    env: HouseholdEnv,
    *,
    flow: Reading = None,
    planner: Planner | None = None,
    seed: int = 0,
) -> Policy:
    """The policy of this name for an environment. Raises `InputError` for an unknown name, or for flat spaces.

    `flow`: what the policy goes by instead of understanding the text, as in `TreeAgent`. `planner`: shared by the
    episodes, for its cache. `seed`: of a random policy.
    """
    if name not in POLICIES:
        raise InputError(f"there is no agent {name!r}; known: {', '.join(POLICIES)}")
    if not isinstance(env.action_space, Dict):
        raise InputError(
            f"policies give actions of drive, interact and target, not of {env.action_space}; make Household-v0"
        )
    return POLICIES[name](env, flow, planner, seed)


class TreePolicy:
    """The tree agent: it goes by its observations and the house map alone."""

    def __init__(self, env: HouseholdEnv, flow: Reading, planner: Planner | None, seed: int) -> None:
        from decomplex_bt.behaviour.agent import TreeAgent

        self.agent: TreeAgent = TreeAgent(_Body(env), flow=flow, planner=planner)

    def reset(self, observation: Any, info: Mapping[str, Any]) -> None:
        self.agent.reset(observation, {"instruction": info["instruction"]})

    def act(self, observation: Any) -> Any:
        return self.agent.act(observation)

    @property
    def done(self) -> bool:
        return self.agent.done

    @property
    def failures(self) -> tuple[Failure, ...]:
        return self.agent.failures

    @property
    def plans(self) -> int:
        return self.agent.session.plans

    @property
    def replans(self) -> int:
        return self.agent.session.replans


class OraclePolicy(TreePolicy):
    """The tree agent with the whole truth of the start in its belief, and told where things are that somebody else has
    moved since: what one would reach who need not search."""

    def __init__(self, env: HouseholdEnv, flow: Reading, planner: Planner | None, seed: int) -> None:
        super().__init__(env, flow, planner, seed)
        self._env = env
        self._moves, self._places = 0, np.empty(0, dtype=np.int64)

    def act(self, observation: Any) -> Any:
        moves = self._env.inform()["moved_by_others"]
        if moves != self._moves:
            self._moves = moves
            self._take_in(see_moved(self._env, observation, self._places), observation)
            self._places = self._env.world.place.copy()
        return super().act(observation)

    def reset(self, observation: Any, info: Mapping[str, Any]) -> None:
        super().reset(observation, info)
        self._moves, self._places = 0, self._env.world.place.copy()
        self._take_in(see_all(self._env, observation), observation)
        session = self.agent.session
        domain, truth = self._env.domain, self._env.truth()
        for step in _refused(domain, truth):
            session.belief.failed(step, "broken")
        tasks = self.agent.grounded.tasks
        asked = {referent for task in tasks if task.type in FINDING_OUT for referent in task.objects}
        for task in tasks:
            # Of two lamps that may be meant, the one that can be switched on. Which one is still to be changed is seen
            # when that is due, unless it was asked before.
            is_open = any(task.seeks_change(referent) and referent not in asked for referent in task.objects)
            if task.type == "change_state" and not is_open:
                session.bindings = feasible_bindings(task, session.bindings, domain, truth)

    def _take_in(self, truth: Mapping[str, Any], observation: Mapping[str, Any]) -> None:
        session = self.agent.session
        for _ in range(_LOOKS):
            session.belief.update(session.embodiment.perceive(dict(truth)))
        for _ in range(_LOOKS):  # what was seen through walls is out of sight again
            session.belief.update(session.embodiment.perceive(dict(observation)))


class RandomPolicy:
    """Drives and handles things at random, otherwise in each episode; it never gives up."""

    plans = replans = 0
    failures: tuple[Failure, ...] = ()

    def __init__(self, env: HouseholdEnv, flow: Reading, planner: Planner | None, seed: int) -> None:
        self._env, self._rng = env, np.random.default_rng(seed)
        self.done = False

    def reset(self, observation: Any, info: Mapping[str, Any]) -> None:
        self._rows = len(self._env.entities)  # the house may be another one by now

    def act(self, observation: Any) -> Any:
        rng = self._rng
        return {
            "drive": rng.uniform(-1.0, 1.0, 2).astype(np.float32),
            "interact": int(rng.integers(Interaction.FINISH)),
            "target": int(rng.integers(self._rows)),
        }


class IdlePolicy:
    """Does nothing and says so: what it reaches, nobody had to do."""

    plans = replans = 0
    failures: tuple[Failure, ...] = ()

    def __init__(self, env: HouseholdEnv, flow: Reading, planner: Planner | None, seed: int) -> None:
        self.done = False

    def reset(self, observation: Any, info: Mapping[str, Any]) -> None:
        self.done = False

    def act(self, observation: Any) -> Any:
        self.done = True
        return {"drive": np.zeros(2, dtype=np.float32), "interact": int(Interaction.FINISH), "target": 0}


POLICIES: dict[str, Callable[[HouseholdEnv, Reading, Planner | None, int], Policy]] = {
    "tree": TreePolicy,
    "oracle": OraclePolicy,
    "random": RandomPolicy,
    "idle": IdlePolicy,
}


def see_all(env: HouseholdEnv, observation: Mapping[str, Any]) -> dict[str, Any]:
    """The observation of one who sees the whole house at once, into every container."""
    world, table = env.world, np.array(observation["entities"])
    places, rows = world.geometry.place_count, len(env.entities)
    is_here = np.ones(rows, dtype=bool)
    is_here[places:] = ~np.isnan(world.position[places:]).any(axis=1)
    here = np.flatnonzero(is_here)
    movable = here[here >= places]
    table[here, VISIBLE] = 1
    table[movable, X : Y + 1] = world.position[movable]
    table[here, PLACE] = world.place[here]
    table[here, FIRST_STATE:] = world.states[here]
    table[:places, INSPECTED] = world.prior.holds
    for person in _behind_walls(world):
        # Seen, they would be taken for near enough to speak with.
        floor = int(world.geometry.floor_row[world.room[person]])
        table[person], table[floor, INSPECTED] = observation["entities"][person], 0
    return {**observation, "entities": table}


def see_moved(env: HouseholdEnv, observation: Mapping[str, Any], places: Places) -> dict[str, Any]:
    """The observation of one who sees, besides, where the things are that lie at another place than before.

    `places` `(rows,)`: the row of the place that each was at, as `World.place` has it. Nothing else of them is seen:
    what is asked about them is still to be found out.
    """
    world, table = env.world, np.array(observation["entities"])
    moved = np.flatnonzero(world.place != places)
    moved = moved[(world.place[moved] >= 0) & (world.place[moved] < world.geometry.place_count)]
    table[moved, VISIBLE] = 1
    table[moved, X : Y + 1] = world.position[moved]
    table[moved, PLACE] = world.place[moved]
    return {**observation, "entities": table}


def _behind_walls(world: World) -> list[int]:
    """The people within earshot of the robot but for a wall."""
    people = [row for row in world.geometry.people_rows if world.home[row] and not is_near_person(world, row)]
    return [row for row in people if np.hypot(*(world.position[row] - world.robot)) <= world.config.speak_reach + 0.1]


def _refused(domain: Domain, truth: Truth) -> list[GroundAction]:
    """The steps that broken devices refuse."""
    broken = [name for name in domain.house.places() if truth.is_broken(name)]
    refused = [GroundAction("switch-on", (device,)) for device in broken]
    for device in broken:
        kind = domain.kind(device)
        for step, tags in (("heat", kind.heats), ("wash", kind.washes), ("fill", kind.fills)):
            things = [thing for thing in domain.house.things if set(tags) & set(domain.kind(thing).tags)]
            refused += [GroundAction(step, (thing, device)) for thing in things]
    return refused


class _Body:
    """All of an environment that the tree agent gets: what makes it a body."""

    def __init__(self, env: HouseholdEnv) -> None:
        self._embodiment = env.embodiment

    def get_wrapper_attr(self, name: str) -> Any:
        if name != "embodiment":
            raise AttributeError(name)
        return self._embodiment
