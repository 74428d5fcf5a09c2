"""Worlds to try things in: the default house without chance, the robot put where a test wants it."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2
from typing import Any

import numpy as np
import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.chance import Draw
from decomplex_bt.envs.hands import interact
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.options import apply_options, read_options
from decomplex_bt.envs.sensing import SensingConfig, Sensor
from decomplex_bt.envs.setting import setting_of
from decomplex_bt.envs.world import World, WorldConfig

Point = tuple[float, float]


class Trial:
    """A world with the robot in it, spoken to by names."""

    def __init__(self, world: World, sensor: Sensor) -> None:
        self.world, self.sensor = world, sensor
        self.row = world.geometry.row

    def do(self, interaction: Interaction, target: str) -> Result:
        return interact(self.world, interaction, self.row[target])

    def state(self, name: str, pair: int) -> int:
        return int(self.world.states[self.row[name], pair])

    def place(self, thing: str) -> str | None:
        at = int(self.world.place[self.row[thing]])
        return None if at < 0 else self.world.geometry.names[at]

    def drive(self, forward: float, turn: float = 0.0, steps: int = 1) -> None:
        for _ in range(steps):
            self.world.drive(forward, turn)
            self.sensor.look()

    def sees(self, name: str) -> bool:
        return bool(self.sensor.table[self.row[name], 0])


@pytest.fixture
def trial() -> Callable[..., Trial]:
    """Makes a trial: `at` is the robot's point, `facing` what it looks at, `config` what it can; the rest are reset
    options."""

    def make(
        at: Point, facing: Point | None = None, seed: int = 0, config: WorldConfig | None = None, **options: Any
    ) -> Trial:
        setting = setting_of(load_domain("household"))
        rng = np.random.default_rng(seed)
        draw = Draw(setting.prior, setting.spots)
        draw.likeliest()
        options.setdefault("people", {"user": "study", "anna": None, "tom": None, "guest": None})
        apply_options(read_options(options, setting.geometry), draw, rng)
        row = setting.geometry.robot_row
        draw.start.position[row] = at
        draw.start.heading = 0.0 if facing is None else atan2(facing[1] - at[1], facing[0] - at[0])
        world = World(
            setting.geometry,
            setting.prior,
            setting.spots,
            draw.start,
            config=config or WorldConfig(),
            noise=rng,
            whims=rng.random,
        )
        world.grasp_slip = 0.0
        sensor = Sensor(world, SensingConfig())
        sensor.missed_detection = 0.0
        sensor.look()
        return Trial(world, sensor)

    return make
