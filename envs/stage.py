"""The stage: the walls and furniture of a house as bodies, made once and moved from each episode's space to the next.

An episode has a fresh `pymunk.Space`, for one that has been used goes its own way; its shapes that never move, most of
all there are, need not be made anew for that.
"""

from __future__ import annotations

import pymunk

from decomplex_bt.envs.geometry import WALL_RADIUS, Geometry


class Stage:
    """The fixed shapes of a house. They are in one space at a time: the one they were set up in last."""

    def __init__(self, geometry: Geometry) -> None:
        self._ground = pymunk.Body(body_type=pymunk.Body.STATIC)
        self._shapes: tuple[pymunk.Shape, ...] = (
            *(pymunk.Segment(self._ground, (ax, ay), (bx, by), WALL_RADIUS) for ax, ay, bx, by in geometry.walls),
            *(
                pymunk.Poly(self._ground, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
                for x0, y0, x1, y1 in geometry.blocks
            ),
        )

    def set_up(self, space: pymunk.Space) -> None:
        """Moves the shapes into a space, out of the one they were in."""
        if self._ground.space is not None:
            self._ground.space.remove(*self._shapes, self._ground)
        space.add(self._ground, *self._shapes)
