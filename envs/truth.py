"""The true world as the judge reads it: the only window between the simulator and the monitor."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Protocol

ROBOT = "robot"
"""The place of what is in the gripper or on the tray."""


class Truth(Protocol):
    """The true world of this moment, in the house's names. Nothing here is for the agent."""

    @property
    def room(self) -> str:
        """The room the robot is in."""

    def view(self) -> Hashable:
        """A value that changes when anything comes into view or goes out of it, or the robot enters another room."""

    def is_near(self, name: str) -> bool:
        """Whether the robot is at a place or doorway (within 1 m) or with a person (within 1.5 m), in the same room."""

    def place(self, name: str) -> str | None:
        """What a thing lies on or in, who has it, or "robot"; a person's room; None for what is not in the house."""

    def state(self, name: str, pair: str) -> str | None:
        """The value of a state pair; None where the entity has no such state."""

    def is_broken(self, name: str) -> bool:
        """Whether a device refuses to be switched on."""

    def is_seen(self, name: str) -> bool:
        """Whether the robot sees an entity now."""

    def is_inspected(self, place: str) -> bool:
        """Whether the whole contents of a place are in the robot's view now."""
