"""How an environment is set up: plain values, which need nothing of what they set up."""

from __future__ import annotations

from dataclasses import dataclass, field

from decomplex_bt.errors import InputError


@dataclass(frozen=True, slots=True)
class WorldConfig:
    """What the robot can do, and how time runs.

    `substep` [s] of physics, `substeps` of them in one control step. Speeds in m/s and rad/s, accelerations in m/s² and
    rad/s². `reach` [m]: from the robot's centre to the nearest point of what it handles; `speak_reach` [m]: from centre
    to centre, to speak and to hand over. `tray_slots`: things the tray holds.
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
        if self.looks < 1 or self.every < 1:
            raise InputError(f"looks is {self.looks}, every is {self.every}; expected whole numbers from 1 on")


@dataclass(frozen=True, slots=True)
class HouseholdConfig:
    """How an environment is set up. `max_seconds` of simulated time, `balance` in [0, 0.5], `reward` "success" or
    "progress"; what the robot can do, and how it sees."""

    max_seconds: float = 600.0
    balance: float = 0.3
    reward: str = "success"
    world: WorldConfig = field(default_factory=WorldConfig)
    sensing: SensingConfig = field(default_factory=SensingConfig)
