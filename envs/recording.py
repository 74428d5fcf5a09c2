"""A recording: how an episode began and what was done since, enough to do all of it again exactly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any
from zlib import crc32

import numpy as np

from decomplex_bt.envs.options import Options, Request
from decomplex_bt.envs.world import World
from decomplex_bt.errors import InputError

FORMAT = 1
CHECK_EVERY = 50
"""Steps between two checksums."""


class Recording:
    """One episode's recording, kept up by `note` after every step."""

    def __init__(self, generator: Mapping[str, Any], request: Request, options: Options) -> None:
        self.generator, self.request, self.options = generator, request, options
        self.actions: list[tuple[float, float, int, int]] = []
        self.checksums: list[int] = []

    def note(self, forward: float, turn: float, interaction: int, target: int, world: World) -> None:
        self.actions.append((forward, turn, interaction, target))
        if len(self.actions) % CHECK_EVERY == 0:
            self.checksums.append(checksum(world))

    def to_dict(self) -> dict[str, Any]:
        """The recording as a value that pickles."""
        return {
            "format": FORMAT,
            "generator": dict(self.generator),
            "request": self.request,
            "options": self.options,
            "actions": tuple(self.actions),
            "checksums": tuple(self.checksums),
        }

    def check(self, recorded: Sequence[int]) -> None:
        """Raises `InputError` naming the step by which this episode departs from the recorded checksums."""
        for index, (mine, theirs) in enumerate(zip(self.checksums, recorded, strict=True), start=1):
            if mine != theirs:
                raise InputError(
                    f"the replay departs from the recording by step {index * CHECK_EVERY}; it was recorded with "
                    "another version, domain or configuration"
                )


def checksum(world: World) -> int:
    """A number that stands for all positions and states; equal worlds have equal ones."""
    position = world.position.copy()
    position[np.isnan(position)] = 0.0
    return crc32(world.states.tobytes(), crc32(position.tobytes()))
