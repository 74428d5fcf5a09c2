"""The stage: the walls and furniture of a house as bodies, made once and moved from each episode's space to the next.

An episode has a fresh `pymunk.Space`, for one that has been used goes its own way; its shapes that never move, most of
all there are, need not be made anew for that. pymunk checks and notes down each shape that it adds or removes, which
takes five times as long as the Chipmunk function that it calls then; here that function is called for all of them in a
row. Where a version of pymunk does not have it in the same place, pymunk's own calls are made, with the same result.
"""

from __future__ import annotations

from typing import Any

import pymunk

from decomplex_bt.envs.geometry import WALL_RADIUS, Geometry

try:
    from pymunk._chipmunk_cffi import lib as _chipmunk

    _add_shape: Any = _chipmunk.cpSpaceAddShape
    _remove_shape: Any = _chipmunk.cpSpaceRemoveShape
except (ImportError, AttributeError):  # pragma: no cover - another pymunk than those known
    _add_shape = _remove_shape = None


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
            _take_out(self._ground.space, self._shapes)
            self._ground.space.remove(self._ground)
        space.add(self._ground)
        if not _is_known(space, self._shapes):
            space.add(*self._shapes)
            return
        chipmunk_space = space._space
        for shape in self._shapes:
            _add_shape(chipmunk_space, shape._shape)
        space._shapes.update(dict.fromkeys(self._shapes))


def clear(space: pymunk.Space) -> None:
    """Takes everything out of a space that is of no more use."""
    space.remove(*space.constraints)
    _take_out(space, tuple(space.shapes))
    space.remove(*space.bodies)


def _take_out(space: pymunk.Space, shapes: tuple[pymunk.Shape, ...]) -> None:
    if not _is_known(space, shapes):
        space.remove(*shapes)
        return
    kept, chipmunk_space = space._shapes, space._space
    for shape in shapes:
        _remove_shape(chipmunk_space, shape._shape)
        del kept[shape]


def _is_known(space: pymunk.Space, shapes: tuple[pymunk.Shape, ...]) -> bool:
    """Whether this is a pymunk whose inside is where it is expected."""
    if _add_shape is None or not hasattr(space, "_space"):
        return False
    # Not by `vars(space)`: a space whose `__dict__` was asked for once is slower from then on.
    return isinstance(getattr(space, "_shapes", None), dict) and all(hasattr(shape, "_shape") for shape in shapes[:1])
