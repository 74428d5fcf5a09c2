"""What the robot's view takes in: the view cone cut off by walls and closed doors."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def view_polygon(x: float, y: float, heading: float, reach: float, field_of_view: float, lines: Floats) -> Floats:
    """The area seen from a point as a polygon, `(n, 2)` metres, the point itself first.

    `reach` in metres, `field_of_view` in radians around `heading`; `lines`: `(m, 4)` segments that block the view.
    """
    angles = np.linspace(-field_of_view / 2, field_of_view / 2, max(3, math.ceil(field_of_view / 0.06)))
    if len(lines):
        ends = lines.reshape(-1, 2)
        towards = np.arctan2(ends[:, 1] - y, ends[:, 0] - x) - heading
        towards = (towards + math.pi) % (2 * math.pi) - math.pi
        near = towards[np.abs(towards) < field_of_view / 2]
        angles = np.sort(np.concatenate([angles, near - 1e-4, near, near + 1e-4]))
    directions = np.column_stack([np.cos(angles + heading), np.sin(angles + heading)])
    lengths = np.full(len(angles), reach)
    if len(lines):
        start, along = lines[:, :2] - (x, y), lines[:, 2:] - lines[:, :2]
        across = directions[:, :1] * along[:, 1] - directions[:, 1:] * along[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            distance = (start[:, 0] * along[:, 1] - start[:, 1] * along[:, 0]) / across
            share = (start[:, 0] * directions[:, 1:] - start[:, 1] * directions[:, :1]) / across
        hits = (np.abs(across) > 1e-12) & (distance > 0) & (share >= 0) & (share <= 1)
        lengths = np.minimum(lengths, np.where(hits, distance, reach).min(axis=1))
    outline = directions * lengths[:, None] + (x, y)
    return np.vstack([[(x, y)], outline])
