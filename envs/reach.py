"""What the robot can get to in a house, from its map alone: computed once per house."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import DataFileError, InputError


def is_reachable(domain: Domain, name: str) -> bool:
    """Whether the robot can get to where a place or doorway is used from, or into a room."""
    return name in _reachable(domain)


def check_access(domain: Domain, path: str | Path) -> None:
    """Raises `DataFileError` where a doorway is in no wall or too narrow for the robot, or it cannot get to a room.

    `path`: the file of the house.
    """
    from decomplex_bt.envs.floorplan import RESOLUTION, floorplan_of

    house = domain.house
    try:
        plan = floorplan_of(house, domain.kinds)
    except InputError as error:
        raise DataFileError(path, str(error)) from None
    for name, doorway in house.doorways.items():
        if not plan.cells_around(*doorway.centre, nearest=0.0, farthest=RESOLUTION, room=None).size:
            raise DataFileError(path, f"doorways.{name}: the robot cannot drive through it; widen it, or clear the way")
    here, there = ([room for room in house.rooms if is_reachable(domain, room) is is_so] for is_so in (True, False))
    if there:
        apart = here if 0 < len(here) < len(there) else there
        raise DataFileError(
            path, f"rooms.{apart[0]}: no way joins it with the other rooms; add a doorway, or clear the way"
        )


@lru_cache(maxsize=8)
def _reachable(domain: Domain) -> frozenset[str]:
    """Everything that lies on the largest piece of free floor, all doors open."""
    import numpy as np
    from scipy.ndimage import label

    from decomplex_bt.envs.floorplan import floorplan_of

    plan = floorplan_of(domain.house, domain.kinds)
    pieces, _ = label(plan.free.reshape(plan.rows, plan.columns), structure=np.ones((3, 3)))
    pieces = pieces.ravel()
    indoors = np.concatenate([plan.cells_at(domain.house.floor_of(room), room=room) for room in domain.house.rooms])
    main = np.bincount(pieces[indoors], minlength=1).argmax()
    names = [*domain.house.places(), *domain.house.doorways]
    reached = {
        name for name in names for room in plan.rooms_of(name) if (pieces[plan.cells_at(name, room=room)] == main).any()
    }
    house = domain.house
    return frozenset(reached | {room for room in house.rooms if house.floor_of(room) in reached})
