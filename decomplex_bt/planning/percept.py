"""What a body reports of one moment, in the domain's names: the only thing a belief is fed with."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

_NOTHING: Mapping[Any, str] = MappingProxyType({})


class Percept(NamedTuple):
    """One look at the world.

    `room`: the robot's room. `held`: the thing in the gripper. `tray`: the things on it by slot, None where free.
    `places`: each entity seen now, to the place it lies on or in, the person who has it, "robot", or (for a person) the
    room; also those in `unseen`, whose place is known without seeing them. `states`: (entity, state pair) seen now, to
    the value ("open", "hot", ...). `inspected`: places whose whole contents are in view now, so that what is not seen
    there is not there. `near`: names of all places, doorways and people within the 1 m (1.5 m for people) in which the
    robot counts as being at them. `result`: what came of the last interaction ("" if there was none, "ok", or the
    reason why it did nothing). `seconds`: simulated time.
    """

    room: str
    held: str | None = None
    tray: tuple[str | None, ...] = (None, None, None, None)
    places: Mapping[str, str] = _NOTHING
    states: Mapping[tuple[str, str], str] = _NOTHING
    inspected: frozenset[str] = frozenset()
    near: frozenset[str] = frozenset()
    result: str = ""
    seconds: float = 0.0
    unseen: frozenset[str] = frozenset()
