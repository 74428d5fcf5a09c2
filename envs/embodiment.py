"""The household robot's body: observations become percepts, plan steps become skills. It knows the house map alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from reprlib import repr as shortened
from typing import Any

import numpy as np

from decomplex_bt.behaviour.embodiment import Skill
from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.floorplan import Cells, floorplan_of
from decomplex_bt.envs.interface import ROBOT_FIELDS, Interaction, Result
from decomplex_bt.envs.navigation import DEFAULT_LIMITS, Driver, Limits
from decomplex_bt.envs.senses import Senses
from decomplex_bt.errors import InputError, is_whole
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.percept import Percept

Action = dict[str, Any]
_NO_INTERACTION = int(Interaction.NONE)
_RESULT_TEXTS = tuple("" if result is Result.NONE else result.name.lower().replace("_", " ") for result in Result)
"""What `Percept.result` says of each result."""
_SENSED = ("robot", "held", "entities", "result", "seconds")
"""The keys of an observation that the body goes by."""


@dataclass(frozen=True, slots=True)
class BodyConfig:
    """What the body knows of itself. Metres.

    `reach`: how far from its centre the gripper gets; `reach_person`: how far it speaks and hands over; `radius`: of
    the robot.
    """

    limits: Limits = DEFAULT_LIMITS
    radius: float = 0.22
    reach: float = 0.8
    reach_person: float = 1.5


class HouseholdEmbodiment:
    """Implements `decomplex_bt.behaviour.embodiment.Embodiment` for the household environments.

    It holds the house map and what it has observed; nothing in it leads to the simulator.
    """

    def __init__(self, domain: Domain, config: BodyConfig | None = None) -> None:
        self.config = config or BodyConfig()
        self.move_to(domain)

    # -- what the environment tells it --------------------------------------------------------------------------------

    def move_to(self, domain: Domain) -> None:
        """Gives the body the map of another house to live in."""
        self.domain = domain
        self.house = domain.house
        self.floorplan = floorplan_of(domain.house, domain.kinds, radius=self.config.radius)
        self.senses = Senses(domain.house, domain.kinds, self.floorplan)
        self.ended: Any = None
        self.is_out_of_time = False
        self._last: Any = None

    def end(self, observation: Mapping[str, Any], *, is_out_of_time: bool) -> None:
        """Tells the body that the episode has ended, with what observation, and whether by the time limit: what
        everybody else is told by `step` as well."""
        self.ended, self.is_out_of_time = observation, is_out_of_time

    # -- the protocol -------------------------------------------------------------------------------------------------

    def reset(self, observation: Mapping[str, Any]) -> None:
        """Begins an episode. Raises `InputError` for an observation that is not of `HouseholdEnv`."""
        _check(observation, self.senses)
        self.senses.clear()
        self._last = self.ended = None
        self.is_out_of_time = False
        self.sense(observation)

    def perceive(self, observation: Mapping[str, Any]) -> Percept:
        """The observation in the domain's names; call it for every observation, in order.

        Raises `InputError` for an observation that is not of `HouseholdEnv`.
        """
        self.sense(observation)
        senses = self.senses
        return Percept(
            room=senses.room,
            held=senses.held,
            tray=senses.tray,
            places=senses.places,
            states=senses.states,
            inspected=senses.inspected,
            near=senses.near,
            result=_RESULT_TEXTS[senses.result],
            seconds=senses.seconds,
            unseen=senses.unseen,
        )

    def skill(self, step: GroundAction) -> Skill:
        from decomplex_bt.envs.skills import make_skill

        return make_skill(self, step)

    def rest(self) -> Action:
        return self.drive(0.0, 0.0)

    def finish(self) -> Action:
        return self.interact(Interaction.FINISH)

    # -- for the skills -----------------------------------------------------------------------------------------------

    def sense(self, observation: Mapping[str, Any]) -> None:
        """Takes an observation in, unless it is the one taken in last."""
        if observation is self._last:
            return
        try:
            self.senses.take(observation)
        except (KeyError, IndexError, TypeError, ValueError, AttributeError):
            _check(observation, self.senses)  # only now, for it would be a part of every tick
            raise
        self._last = observation

    def drive(self, forward: float, turn: float) -> Action:
        """The action that drives: shares of the limits in [-1, 1]."""
        return {
            "drive": np.array((forward, turn), np.float32),
            "interact": _NO_INTERACTION,
            "target": 0,
        }

    def interact(self, interaction: Interaction, target: str | None = None) -> Action:
        """The action that stands still and does `interaction` with `target`, an entity's name."""
        return {
            "drive": np.zeros(2, dtype=np.float32),
            "interact": int(interaction),
            "target": 0 if target is None else self.senses.row[target],
        }

    def driver(self, goal: Cells, *, second_best: Cells | None = None) -> Driver:
        return Driver(self.floorplan, goal, self.config.limits, second_best=second_best)


def _check(observation: Any, senses: Senses) -> None:
    """Raises `InputError` for what is not one observation of `HouseholdEnv`, in the house of these senses."""
    if not isinstance(observation, Mapping):
        raise InputError(
            f"the robot goes by the observations of Household-v0, by name, and was given a "
            f"{type(observation).__name__}; make that environment, without a wrapper that flattens what is observed"
        )
    if missing := [key for key in _SENSED if key not in observation]:
        raise InputError(f"the observation lacks {', '.join(missing)}; give what reset or step returned, as it is")
    if np.ndim(observation["entities"]) != 2:
        raise InputError(
            f"the observation's entities have the shape {np.shape(observation['entities'])}; expected one row for "
            "each entity. Of a vector environment give each agent the observation of its own environment"
        )
    fitting = {
        "robot": _is_array(observation["robot"], len(ROBOT_FIELDS)),
        "held": _is_array(observation["held"]) and _are_rows(observation["held"], len(senses.names)),
        "entities": senses.is_table(observation["entities"]),
        "result": is_whole(observation["result"]) and 0 <= observation["result"] < len(Result),
        "seconds": _is_array(observation["seconds"], 1),
    }
    if wrong := next((key for key, is_fit in fitting.items() if not is_fit), None):
        value = observation[wrong]
        given = f"of the shape {value.shape}" if isinstance(value, np.ndarray) else shortened(value)
        raise InputError(
            f"the observation's {wrong!r} ({given}) is none of this house; give what reset or step of the agent's "
            "environment returned, as it is"
        )


def _is_array(value: Any, size: int | None = None) -> bool:
    """Whether it is a list of finite numbers as numpy has it, of this size or at least one."""
    is_list = isinstance(value, np.ndarray) and value.ndim == 1 and value.dtype.kind in "iuf"
    return is_list and (value.size == size or (size is None and value.size > 0)) and bool(np.isfinite(value).all())


def _are_rows(values: Any, rows: int) -> bool:
    """Whether all are rows of a table with so many, or -1."""
    return bool(((values >= -1) & (values < rows)).all())
