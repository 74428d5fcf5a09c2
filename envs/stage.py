"""The stage: the bodies that a house has in every episode, made once and moved from each space to the next.

An episode has a fresh `pymunk.Space`, for one that has been used goes its own way; walls and furniture, most of all
there is in it, need not be made anew for that, nor the leaves of doors, people who stand, and the robot. pymunk checks
and notes down each shape that it adds or removes, which takes five times as long as the Chipmunk function that it calls
then; here that function is called for all of them in a row. Where a version of pymunk does not have it in the same
place, pymunk's own calls are made, with the same result.
"""

from __future__ import annotations

from enum import IntFlag
from typing import Any

import pymunk

from decomplex_bt.envs.geometry import LEAF_RADIUS, WALL_RADIUS, Geometry
from decomplex_bt.envs.spots import PERSON_RADIUS, ROBOT_RADIUS

try:
    from pymunk._chipmunk_cffi import lib as _chipmunk

    _add_shape: Any = _chipmunk.cpSpaceAddShape
    _remove_shape: Any = _chipmunk.cpSpaceRemoveShape
    _begin_body: Any = _chipmunk.cpBodyInit
    _name_body: Any = _chipmunk.cpBodySetUserData
except (ImportError, AttributeError):  # pragma: no cover - another pymunk than those known
    _add_shape = _remove_shape = _begin_body = _name_body = None

CONTACT_FRICTION = 0.2  # [-] between bodies
ROBOT_MASS = 15.0  # [kg]


class Collision(IntFlag):
    """Categories of what moves; everything collides with everything, and walls and furniture are in all categories."""

    ROBOT = 1
    THING = 2
    PERSON = 4


_FILTERS = {category: pymunk.ShapeFilter(categories=int(category)) for category in Collision}


class Stage:
    """The fixed shapes of a house, and who is always in it. They are in one space at a time: the last one set up.

    `ground`: what is fixed to the floor for an episode is fixed to this body. `leaves`: by door, as it is when closed.
    """

    def __init__(self, geometry: Geometry) -> None:
        self._floor = pymunk.Body(body_type=pymunk.Body.STATIC)
        self._shapes: tuple[pymunk.Shape, ...] = (
            *(pymunk.Segment(self._floor, (ax, ay), (bx, by), WALL_RADIUS) for ax, ay, bx, by in geometry.walls),
            *(pymunk.Poly(self._floor, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]) for x0, y0, x1, y1 in geometry.blocks),
        )
        self._noted = dict.fromkeys(self._shapes)
        self._handles = tuple(getattr(shape, "_shape", None) for shape in self._shapes)
        self.ground = ground = pymunk.Body(body_type=pymunk.Body.STATIC)
        self.leaves = {
            door: pymunk.Segment(ground, (ax, ay), (bx, by), LEAF_RADIUS)
            for door, (ax, ay, bx, by) in geometry.leaves.items()
        }
        self._people = {
            row: shaped(pymunk.Circle(ground, PERSON_RADIUS), Collision.PERSON) for row in geometry.people_rows
        }
        self._robot = _make_robot()

    def set_up(self, space: pymunk.Space) -> None:
        """Moves walls and furniture into a space; the one they were in is emptied."""
        if self._floor.space is not None:
            clear(self._floor.space)
        # A space's own static body could not be taken out of it again.
        space.add(self.ground, self._floor)
        if not _is_known(space, self._shapes):
            space.add(*self._shapes)
            return
        add, chipmunk_space = _add_shape, space._space
        for handle in self._handles:
            add(chipmunk_space, handle)
        space._shapes.update(self._noted)

    def person(self, row: int, position: tuple[float, float]) -> pymunk.Shape:
        """Somebody who stands somewhere, in no space yet."""
        shape = self._people[row]
        shape.unsafe_set_offset(position)
        return shape

    def robot(self) -> tuple[pymunk.Body, pymunk.Shape]:
        """The robot's body as if it had never moved, and its shape, in no space yet."""
        body, _ = self._robot
        if _begin_body is None or not hasattr(body, "_data_handle"):
            self._robot = _make_robot()
        else:
            # What moves a body back would leave the push that its last contact gave it.
            _begin_body(body._body, body.mass, body.moment)
            _name_body(body._body, body._data_handle)
        return self._robot


def put(space: pymunk.Space, shape: pymunk.Shape) -> None:
    """Adds one shape of a stage to a space."""
    if not _is_known(space, (shape,)):
        space.add(shape)
        return
    _add_shape(space._space, shape._shape)
    space._shapes[shape] = None


def shaped(shape: Any, category: Collision) -> Any:
    """The shape of something that moves, with all that contacts go by."""
    shape.friction = CONTACT_FRICTION
    shape.filter = _FILTERS[category]
    return shape


def clear(space: pymunk.Space) -> None:
    """Takes everything out of a space that is of no more use."""
    space.remove(*space.constraints)
    shapes = tuple(space.shapes)
    if _is_known(space, shapes):
        remove, chipmunk_space = _remove_shape, space._space
        for shape in shapes:
            remove(chipmunk_space, shape._shape)
        space._shapes.clear()
    else:
        space.remove(*shapes)
    space.remove(*space.bodies)


def _is_known(space: pymunk.Space, shapes: tuple[pymunk.Shape, ...]) -> bool:
    """Whether this is a pymunk whose inside is where it is expected."""
    if _add_shape is None or not hasattr(space, "_space"):
        return False
    # Not by `vars(space)`: a space whose `__dict__` was asked for once is slower from then on.
    return isinstance(getattr(space, "_shapes", None), dict) and all(hasattr(shape, "_shape") for shape in shapes[:1])


def _make_robot() -> tuple[pymunk.Body, pymunk.Shape]:
    body = pymunk.Body(ROBOT_MASS, pymunk.moment_for_circle(ROBOT_MASS, 0, ROBOT_RADIUS))
    return body, shaped(pymunk.Circle(body, ROBOT_RADIUS), Collision.ROBOT)
