"""What the robot can get to in a house, from its map alone: computed once per house."""

from __future__ import annotations

from functools import lru_cache

from decomplex_bt.domain.loader import Domain


def is_reachable(domain: Domain, name: str) -> bool:
    """Whether the robot can get to where a place or doorway is used from, or into a room."""
    return name in _reachable(domain)


@lru_cache(maxsize=8)
def _reachable(domain: Domain) -> frozenset[str]:
    """Everything that lies on the largest piece of free floor, all doors open."""
    import numpy as np
    from scipy.ndimage import label

    from decomplex_bt.envs.floorplan import floorplan_of

    plan = floorplan_of(domain.house, domain.kinds)
    pieces, _ = label(plan.free.reshape(plan.rows, plan.columns), structure=np.ones((3, 3)))
    pieces = pieces.ravel()
    main = np.bincount(pieces[pieces > 0]).argmax()
    names = [*domain.house.places(), *domain.house.doorways]
    reached = {
        name for name in names for room in plan.rooms_of(name) if (pieces[plan.cells_at(name, room=room)] == main).any()
    }
    house = domain.house
    return frozenset(reached | {room for room in house.rooms if house.floor_of(room) in reached})
