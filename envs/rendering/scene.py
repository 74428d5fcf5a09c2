"""The scene: all that a picture shows of one moment, in the domain's names, apart from the house itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple


class Pose(NamedTuple):
    """Where something is: metres in the world frame, radians counter-clockwise from +x."""

    x: float
    y: float
    heading: float = 0.0


@dataclass(frozen=True, slots=True)
class Scene:
    """One moment of an episode as it truly is, hidden things included.

    `things`: where each thing lies, with `places` saying on or in what; what is carried or nowhere in the house is in
    neither. `people`: those at home. `states`: (entity, state pair) to its value ("open", "hot", ...). `held`, `tray`:
    what the robot carries. `with_person`: thing to the person who has it. `path`: where the robot drove, oldest first.
    `sight`: range (m) and field of view (rad) of the view cone, None for no cone. `pointed_out`: entities to mark.
    `instruction`, `doing`: the caption's two lines; `verdict`: "", "success", "failure" or "infeasible"; `said`: what
    the robot is saying now.
    """

    robot: Pose
    things: Mapping[str, Pose] = field(default_factory=dict)
    places: Mapping[str, str] = field(default_factory=dict)
    people: Mapping[str, Pose] = field(default_factory=dict)
    states: Mapping[tuple[str, str], str] = field(default_factory=dict)
    held: str | None = None
    tray: tuple[str | None, ...] = (None, None, None, None)
    with_person: Mapping[str, str] = field(default_factory=dict)
    path: tuple[tuple[float, float], ...] = ()
    sight: tuple[float, float] | None = None
    pointed_out: tuple[str, ...] = ()
    instruction: str = ""
    doing: str = ""
    verdict: str = ""
    said: str = ""
    seconds: float = 0.0
