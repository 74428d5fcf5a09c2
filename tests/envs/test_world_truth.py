"""The world as the judge reads it."""

from __future__ import annotations

import pytest

from decomplex_bt.envs.world_truth import WorldTruth


@pytest.mark.parametrize(
    ("at", "room", "is_near"),
    [
        ((3.2, 3.4), "bedroom", True),
        ((3.2, 4.4), "hallway", True),
        ((3.2, 2.6), "bedroom", False),
        ((4.6, 3.7), "bathroom", False),  # 0.95 m away, beyond a wall of the bedroom
    ],
)
def test_the_robot_is_at_a_door_from_the_rooms_that_it_joins(trial, at, room, is_near):
    t = trial(at=at)
    truth = WorldTruth(t.world, t.sensor)
    assert truth.room == room
    assert truth.is_near("bedroom_door") is is_near
