"""Wedges: how much of the other rooms can be seen through open doorways from a point in one room.

Rooms are rectangles, so a point in the eye's own room is in sight, and one in another room where it lies in the wedge
that the doorways on the way there leave. Points and directions are complex numbers, x + iy.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import inf

from decomplex_bt.envs.geometry import Geometry, Portal

Wedge = tuple[complex, complex]
"""Directions of its right and its left edge, less than half a turn apart."""


def wedges(
    geometry: Geometry, room: int, eye: complex, closed: Collection[str], *, reach: float = inf
) -> list[tuple[int, Wedge]]:
    """The other rooms seen through doorways without a `closed` leaf, each with its wedge, nearer ones first.

    A room to which two ways lead comes twice. Doorways that are farther than `reach` metres are left out.
    """
    found: list[tuple[int, Wedge]] = []
    portals = geometry.portals
    for beyond, right, left, leaf, middle, half in portals[room]:
        to_right, to_left = right - eye, left - eye
        if leaf in closed or (to_right.conjugate() * to_left).imag < 0 or abs(middle - eye) - half > reach:
            continue
        found.append((beyond, (to_right, to_left)))
        if len(portals[beyond]) > 1:
            _look_through(portals, beyond, eye, (to_right, to_left), (room, beyond), closed, reach, found)
    return found


def _look_through(
    portals: Sequence[Sequence[Portal]],
    room: int,
    eye: complex,
    wedge: Wedge,
    path: tuple[int, ...],
    closed: Collection[str],
    reach: float,
    found: list[tuple[int, Wedge]],
) -> None:
    """Adds what is seen within a wedge through the doorways of `room`, and through those behind them."""
    for beyond, right, left, leaf, middle, half in portals[room]:
        if beyond in path or leaf in closed or abs(middle - eye) - half > reach:
            continue
        narrowed = _narrowed(right - eye, left - eye, wedge)
        if narrowed is not None:
            found.append((beyond, narrowed))
            if len(portals[beyond]) > 1:
                _look_through(portals, beyond, eye, narrowed, (*path, beyond), closed, reach, found)


def _narrowed(right: complex, left: complex, wedge: Wedge) -> Wedge | None:
    """The part of a wedge that goes through an opening with these edges; None where nothing of it does."""
    first, last = wedge
    if _cross(first, left) <= 0 or _cross(right, last) <= 0:
        return None
    right = first if _cross(first, right) < 0 else right
    left = last if _cross(left, last) < 0 else left
    return None if _cross(right, left) < 0 else (right, left)


def _cross(one: complex, other: complex) -> float:
    """Positive where `other` lies to the left of `one`."""
    return (one.conjugate() * other).imag
