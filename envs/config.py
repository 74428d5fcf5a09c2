"""How an environment is set up: plain values, which need nothing of what they set up. Each raises `InputError`, naming
the field, for a value that cannot be."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import Any, TypeVar

from decomplex_bt.envs.values import choice, number, positive, whole
from decomplex_bt.errors import InputError, among

REWARDS = ("success", "progress")
MAX_SPEED = 2.0  # [m/s] observed speeds are clipped to it; the robot's own is lower, a push may be faster
MAX_TURN_RATE = 10.0  # [rad/s]
MAX_SUBSTEP = 0.05  # [s] in which the fastest robot gets 0.1 m far, less than half of what keeps its centre off a wall
Config = TypeVar("Config")


@dataclass(frozen=True, slots=True)
class WorldConfig:
    """What the robot can do, and how time runs.

    `substep` [s] of physics, `substeps` of them in one control step. Speeds in m/s and rad/s, accelerations in m/s² and
    rad/s², up to `MAX_SPEED` and `MAX_TURN_RATE`, which is what observations can tell; a `substep` up to `MAX_SUBSTEP`.
    The accelerations are limits of a drive; without one the robot brakes, and stands within a control step. Nothing
    comes through a wall or a closed door at any of these, though the longer a substep, the deeper what is pushed
    against one gets into it, up to its middle, and the farther it is flung aside. `reach` [m]: from the robot's centre
    to the nearest point of what it handles; `speak_reach` [m]: from centre to centre, to speak and to hand over.
    `tray_slots`: things the tray holds. The tree's skills get everywhere with a `reach` from 0.7 and a `speak_reach`
    from 1.0; with less they do not, and the judge calls it feasible all the same.
    """

    substep: float = 0.01
    substeps: int = 10
    max_speed: float = 1.0
    max_turn_rate: float = 2.5
    max_acceleration: float = 1.5
    max_turn_acceleration: float = 8.0
    reach: float = 0.8
    speak_reach: float = 1.5
    tray_slots: int = 4

    def __post_init__(self) -> None:
        _check(self, positive, "max_acceleration", "max_turn_acceleration")
        _check(self, positive, "substep", high=MAX_SUBSTEP)
        _check(self, positive, "max_speed", high=MAX_SPEED)
        _check(self, positive, "max_turn_rate", high=MAX_TURN_RATE)
        _check(self, number, "reach", "speak_reach")
        _check(self, whole, "tray_slots")
        _check(self, whole, "substeps", low=1)

    @property
    def step_seconds(self) -> float:
        return self.substep * self.substeps


@dataclass(frozen=True, slots=True)
class SensingConfig:
    """How the robot sees. `range`, `inside_range` in metres, `field_of_view` in degrees.

    `every`: control steps between two looks (between them the table stays; a change that the robot itself brings about
    is seen at once). `memory` [s]: a floor is inspected when each part of it was in view within this time, and what was
    seen there in that time is reported along, as it was seen last. `looks`: looks in a row with a place in full view
    that make it inspected.
    """

    range: float = 5.0
    inside_range: float = 2.0
    field_of_view: float = 200.0
    every: int = 5
    memory: float = 15.0
    looks: int = 2

    def __post_init__(self) -> None:
        _check(self, number, "range", "inside_range", "memory")
        _check(self, positive, "field_of_view", high=360.0)
        _check(self, whole, "every", "looks", low=1, high=1000)


@dataclass(frozen=True, slots=True)
class HouseholdConfig:
    """How an environment is set up. `max_seconds` of simulated time (None: what houses of its size take), `balance` in
    [0, 0.5], `reward` "success" or "progress"; what the robot can do, and how it sees, also as mappings of their
    fields."""

    max_seconds: float | None = None
    balance: float = 0.3
    reward: str = "success"
    world: WorldConfig = field(default_factory=WorldConfig)
    sensing: SensingConfig = field(default_factory=SensingConfig)

    def __post_init__(self) -> None:
        if self.max_seconds is not None:
            _check(self, number, "max_seconds", high=float("inf"))
        _check(self, number, "balance", high=0.5)
        _check(self, choice, "reward", choices=REWARDS)
        object.__setattr__(self, "world", read_config(self.world, WorldConfig, "world"))
        object.__setattr__(self, "sensing", read_config(self.sensing, SensingConfig, "sensing"))


def read_config(value: Any, kind: type[Config], name: str) -> Config:
    """A configuration as it is, or of a mapping of its fields; None: the default. Raises `InputError`."""
    if isinstance(value, kind):
        return value
    if value is not None and not isinstance(value, Mapping):
        raise InputError(f"{name} is {value!r}; expected a {kind.__name__} or a mapping of its fields")
    names = [item.name for item in fields(kind)]  # type: ignore[arg-type]
    for key in value or {}:
        if key not in names:
            raise InputError(f"{name}: unknown {key!r}{among(key, names)}")
    return kind(**(value or {}))


def _check(config: Any, check: Callable[..., Any], *names: str, **limits: Any) -> None:
    for name in names:
        object.__setattr__(config, name, check(name, getattr(config, name), **limits))
