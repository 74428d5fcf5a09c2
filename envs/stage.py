"""The stage: the bodies that a house has in every episode, made once and moved from each space to the next.

An episode has a fresh `pymunk.Space`, for one that has been used goes its own way; walls and furniture, most of all
there is in it, need not be made anew for that, nor the leaves of doors, people who stand, what lies on the floor, and
the robot: what moves is begun again as Chipmunk begins it, for to move it back would leave it the push that its last
contact gave it. pymunk checks each body, joint and shape that it adds or removes, which takes five times as long as the
Chipmunk function that it calls then; here that function is called, and what is in the space noted where pymunk notes
it. Where a version of pymunk does not have them in the same place, pymunk's own calls are made, with the same result.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from functools import cache
from typing import Any

import pymunk

from decomplex_bt.envs.geometry import LEAF_RADIUS, WALL_RADIUS, Geometry
from decomplex_bt.envs.spots import PERSON_RADIUS, ROBOT_RADIUS

try:
    from pymunk._chipmunk_cffi import ffi as _ffi
    from pymunk._chipmunk_cffi import lib as _chipmunk

    _add_shape: Any = _chipmunk.cpSpaceAddShape
    _add_body: Any = _chipmunk.cpSpaceAddBody
    _add_joint: Any = _chipmunk.cpSpaceAddConstraint
    _remove_shape: Any = _chipmunk.cpSpaceRemoveShape
    _remove_joint: Any = _chipmunk.cpSpaceRemoveConstraint
    _begin: tuple[Any, ...] = (
        _chipmunk.cpBodyInit,
        _chipmunk.cpBodySetUserData,
        _chipmunk.cpPivotJointInit,
        _chipmunk.cpGearJointInit,
        _chipmunk.cpConstraintSetUserData,
        _chipmunk.cpConstraintSetMaxBias,
        _chipmunk.cpConstraintSetMaxForce,
    )
except (ImportError, AttributeError):  # pragma: no cover - another pymunk than those known
    _add_shape = None
    _begin = ()

GRAVITY = 9.81  # [m/s²] presses things on the floor
FLOOR_FRICTION = 0.4  # [-] of things on the floor
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
        self._robot = Mover(ROBOT_MASS, ROBOT_RADIUS, Collision.ROBOT)
        self._things: dict[int, Mover] = {}

    def set_up(self, space: pymunk.Space) -> None:
        """Moves walls and furniture into a space; the one they were in is emptied."""
        if self._floor.space is not None:
            clear(self._floor.space)
        # A space's own static body could not be taken out of it again.
        space.add(self.ground, self._floor)
        if not _is_known():
            space.add(*self._shapes)
            return
        add, inside = _add_shape, space._space
        for handle in self._handles:
            add(inside, handle)
        space._shapes.update(self._noted)

    def person(self, row: int, position: tuple[float, float]) -> pymunk.Shape:
        """Somebody who stands somewhere, in no space yet."""
        shape = self._people[row]
        shape.unsafe_set_offset(position)
        return shape

    def robot(self) -> Mover:
        """The robot as if it had never moved, in no space yet."""
        if not self._robot.begin(self.ground):
            self._robot = Mover(ROBOT_MASS, ROBOT_RADIUS, Collision.ROBOT)
        return self._robot

    def thing(self, row: int, mass: float, radius: float) -> Mover:
        """A thing that slides on the floor, as if it had never moved, in no space yet."""
        mover = self._things.get(row)
        if mover is None or not mover.begin(self.ground):
            mover = self._things[row] = Mover(mass, radius, Collision.THING)
            mover.rub(self.ground)
        return mover


class Mover:
    """A round body that moves, with its shape and, where it rubs against the floor, its joints to the ground."""

    def __init__(self, mass: float, radius: float, category: Collision) -> None:
        self._mass, self._moment = mass, pymunk.moment_for_circle(mass, 0, radius)
        friction = FLOOR_FRICTION * mass * GRAVITY
        self._forces = friction * 1.0, friction * (radius * 2 / 3)
        """Beyond which it slides and spins on the floor [N, N m]."""
        self.body = pymunk.Body(mass, self._moment)
        self.shape: pymunk.Shape = shaped(pymunk.Circle(self.body, radius), category)
        self.joints: tuple[pymunk.Constraint, ...] = ()
        self._handles: tuple[Any, ...] = ()
        self._can_begin = _can_begin(self.body)

    def rub(self, ground: pymunk.Body) -> None:
        """Lets it slide with friction: by joints to the ground that give way."""
        slide, spin = (
            pymunk.PivotJoint(ground, self.body, (0, 0), (0, 0)),
            pymunk.GearJoint(ground, self.body, 0.0, 1.0),
        )
        self.joints = slide, spin
        for joint, force in zip(self.joints, self._forces, strict=True):
            joint.max_bias, joint.max_force = 0, force
        self._can_begin = _can_begin(self.body, *self.joints)
        if self._can_begin:
            names = "cpPivotJoint *", "cpGearJoint *"
            self._handles = tuple(
                _ffi.cast(name, joint._constraint) for name, joint in zip(names, self.joints, strict=True)
            )

    def begin(self, ground: pymunk.Body) -> bool:
        """Makes it as it was when it was new; False where this version of pymunk does not allow it."""
        body: Any = self.body
        if not self._can_begin:
            return False
        begin_body, name_body, begin_slide, begin_spin, name_joint, limit_bias, limit_force = _begin
        begin_body(body._body, self._mass, self._moment)
        name_body(body._body, body._data_handle)
        if self.joints:
            slide, spin = self._handles
            begin_slide(slide, ground._body, body._body, (0, 0), (0, 0))
            begin_spin(spin, ground._body, body._body, 0.0, 1.0)
            joint: Any
            for joint, force in zip(self.joints, self._forces, strict=True):
                name_joint(joint._constraint, joint._data_handle)
                limit_bias(joint._constraint, 0.0)
                limit_force(joint._constraint, force)
        return True


def put(space: Any, shape: Any, body: Any = None, joints: Sequence[Any] = ()) -> None:
    """Adds a shape to a space; that of something that moves with its body and joints."""
    if not _is_known():
        space.add(*(() if body is None else (body,)), *joints, shape)
        return
    inside = space._space
    if body is not None:
        _add_body(inside, body._body)
        space._bodies[body] = None
    for joint in joints:
        _add_joint(inside, joint._constraint)
        space._constraints[joint] = None
    _add_shape(inside, shape._shape)
    space._shapes[shape] = None


def shaped(shape: Any, category: Collision) -> Any:
    """The shape of something that moves, with all that contacts go by."""
    shape.friction = CONTACT_FRICTION
    shape.filter = _FILTERS[category]
    return shape


def clear(space: Any) -> None:
    """Takes everything out of a space that is of no more use."""
    if not _is_known():
        space.remove(*space.constraints, *space.shapes, *space.bodies)
        return
    inside = space._space
    for joint in space._constraints:
        _remove_joint(inside, joint._constraint)
    for shape in space._shapes:
        _remove_shape(inside, shape._shape)
    space._constraints.clear()
    space._shapes.clear()
    space.remove(*space.bodies)


def _is_known() -> bool:
    """Whether this is a pymunk whose inside is where it is expected."""
    return _add_shape is not None and _has_known_parts()


@cache
def _has_known_parts() -> bool:
    space, body = pymunk.Space(), pymunk.Body(1.0, 1.0)
    shape, joint = pymunk.Circle(body, 1.0), pymunk.PivotJoint(space.static_body, body, (0, 0))
    parts = (body, "_body"), (shape, "_shape"), (joint, "_constraint")
    notes = (getattr(space, name, None) for name in ("_bodies", "_shapes", "_constraints"))
    has_parts = hasattr(space, "_space") and all(hasattr(part, name) for part, name in parts)
    return has_parts and all(isinstance(note, dict) for note in notes)


def _can_begin(body: pymunk.Body, *joints: pymunk.Constraint) -> bool:
    """Whether this is a pymunk in which what moves can be begun again."""
    parts = (body, *joints)
    return bool(_begin) and hasattr(body, "_body") and all(hasattr(part, "_data_handle") for part in parts)
