"""Wedges: how much of the other rooms can be seen through open doorways from a point in one room.

Rooms are rectangles, so a point in the eye's own room is in sight, and one in another room where it lies in the wedge
that the doorways on the way there leave. Points and directions are complex numbers, x + iy.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.geometry import Geometry, Portal

Complex = NDArray[np.complex128]
Wedge = tuple[complex, complex]
"""Directions of its right and its left edge, less than half a turn apart."""


def in_sight(
    geometry: Geometry, room: int, eye: complex, closed: Collection[str], rooms: NDArray[np.int64], directions: Complex
) -> NDArray[np.bool_]:
    """Which points in other `rooms`, in these `directions` from the eye, no wall and no `closed` leaf hides; `(n,)`."""
    seen = np.zeros(len(rooms), dtype=bool)
    for right, left in _layers(geometry, room, eye, closed):
        seen |= ((right.conj()[rooms] * directions).imag >= 0) & ((left[rooms] * directions.conj()).imag >= 0)
    return seen


def _layers(geometry: Geometry, room: int, eye: complex, closed: Collection[str]) -> list[tuple[Complex, Complex]]:
    """The wedges by room, right and left edges; more than one layer where two ways lead to a room."""
    layers: list[tuple[Complex, Complex]] = []
    count: dict[int, int] = {}
    for beyond, (right, left) in _through(geometry, room, eye, None, (room,), closed):
        layer = count[beyond] = count.get(beyond, -1) + 1
        if layer == len(layers):
            # nothing compares with NaN: a room without a wedge is out of sight
            blank = np.full(len(geometry.rooms), complex("nan"))
            layers.append((blank, blank.copy()))
        layers[layer][0][beyond], layers[layer][1][beyond] = right, left
    return layers


def _through(
    geometry: Geometry, room: int, eye: complex, wedge: Wedge | None, path: tuple[int, ...], closed: Collection[str]
) -> Iterator[tuple[int, Wedge]]:
    """The rooms seen through open doorways of `room`, each with its wedge; deeper ones through nearer ones."""
    for portal in geometry.portals[room]:
        if portal.beyond in path or portal.leaf in closed:
            continue
        narrowed = _narrowed(portal, eye, wedge)
        if narrowed is not None:
            yield portal.beyond, narrowed
            yield from _through(geometry, portal.beyond, eye, narrowed, (*path, portal.beyond), closed)


def _narrowed(portal: Portal, eye: complex, wedge: Wedge | None) -> Wedge | None:
    """The part of a wedge that goes through an opening; None where nothing of it does."""
    right, left = complex(*portal.right) - eye, complex(*portal.left) - eye
    if wedge is not None:
        first, last = wedge
        if _cross(first, left) <= 0 or _cross(right, last) <= 0:
            return None
        right = first if _cross(first, right) < 0 else right
        left = last if _cross(left, last) < 0 else left
    return None if _cross(right, left) < 0 else (right, left)


def _cross(one: complex, other: complex) -> float:
    """Positive where `other` lies to the left of `one`."""
    return (one.conjugate() * other).imag
