"""What a picture costs beside pymunk's own debug drawing of the same space, in one run and interleaved. Read the ratio.

    python benchmarks/rendering.py [ROUNDS]

Both draw 512 x 512 pixels and copy them out as an array. `moving`: the robot elsewhere in every frame; `changing`: a
device switched in every frame, too, so that the interior is drawn anew.
"""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable
from statistics import median
from time import perf_counter

import gymnasium as gym
import numpy as np
import pygame
import pymunk.pygame_util

import decomplex_bt.envs.rendering  # noqa: F401 - silences pygame's greeting, so it comes first
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.rendering import Camera, Pose

SIDE = 512
FRAMES = 40


def main(rounds: int = 9) -> None:
    env = gym.make("decomplex_bt/Household-v0", render_mode="rgb_array").unwrapped
    assert isinstance(env, HouseholdEnv)
    env.reset(seed=0)
    camera = Camera(env.setting.geometry, size=(SIDE, SIDE), sight=env.camera.sight)
    still = camera.scene(env.world, instruction="Bring me a pen if you can find one on the desk.")
    poses = [Pose(1.0 + 0.2 * number, 4.6, number * 0.3) for number in range(FRAMES)]
    moving = [dataclasses.replace(still, robot=pose) for pose in poses]
    powers = [{**still.states, ("tv", "power"): ("on", "off")[number % 2]} for number in range(FRAMES)]
    changing = [dataclasses.replace(scene, states=states) for scene, states in zip(moving, powers, strict=True)]
    measures: dict[str, Callable[[], float]] = {
        "moving": lambda: _each(lambda number: camera.renderer.frame(moving[number])),
        "changing": lambda: _each(lambda number: camera.renderer.frame(changing[number])),
        "scene and frame": lambda: _each(lambda number: camera.show(camera.scene(env.world), "rgb_array")),
        "debug_draw and copy": _debug_draw(env.world.space),
    }
    times: dict[str, list[float]] = {name: [] for name in measures}
    for _ in range(rounds):
        for name, measure in measures.items():
            times[name].append(measure())
    for name, values in times.items():
        print(f"{name:20} {median(values) * 1e3:8.2f} ms")
    ratio = median(a / b for a, b in zip(times["moving"], times["debug_draw and copy"], strict=True))
    print(f"moving to debug_draw and copy: {ratio:.2f}")


def _debug_draw(space: pymunk.Space) -> Callable[[], float]:
    surface = pygame.Surface((SIDE, SIDE))
    options = pymunk.pygame_util.DrawOptions(surface)

    def draw(number: int) -> None:
        surface.fill((255, 255, 255))
        space.debug_draw(options)
        np.array(pygame.surfarray.pixels3d(surface).swapaxes(0, 1))

    return lambda: _each(draw)


def _each(draw: Callable[[int], object]) -> float:
    """Seconds a frame, over all frames."""
    start = perf_counter()
    for number in range(FRAMES):
        draw(number)
    return (perf_counter() - start) / FRAMES


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
