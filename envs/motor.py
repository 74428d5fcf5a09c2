"""The motor: sets one body going, lets time run, and reads the body, with as little as can be around Chipmunk's calls.

`pymunk.Space.step` spends most of its time on what may be added or removed meanwhile, and a property of a body on
making vectors. Nothing is added within a control step here, so that only the first substep after a body or shape was
added or removed goes through pymunk, and all others straight to the Chipmunk function that pymunk itself calls. A body
is read at one go, by the function with which `pymunk.batch` reads each of all bodies. Where a version of pymunk does
not have them in the same place, pymunk's own calls are made: the numbers are the same.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from itertools import repeat, starmap
from struct import Struct
from typing import Any, Protocol

import pymunk

try:
    from pymunk._chipmunk_cffi import ffi as _ffi
    from pymunk._chipmunk_cffi import lib as _chipmunk

    _FUNCTIONS: tuple[Any, ...] = (
        _chipmunk.cpSpaceStep,
        _chipmunk.cpBodySetVelocity,
        _chipmunk.cpBodySetAngularVelocity,
        _chipmunk.pmSpaceBodyGetIteratorFuncBatched,
        _chipmunk.cpBodyIsSleeping,
        _chipmunk.cpBodyGetPosition,
    )
    _READ: int = _chipmunk.POSITION | _chipmunk.ANGLE | _chipmunk.VELOCITY | _chipmunk.ANGULAR_VELOCITY
except (ImportError, AttributeError):  # pragma: no cover - another pymunk than those known
    _FUNCTIONS = ()

_ROOM = 16
"""Numbers that there is room for where a body is read into: more than are read, for what is full is made anew."""
_STATE = Struct("6d")
_exhaust = deque[Any](maxlen=0).extend
Point = tuple[float, float]
State = tuple[float, float, float, float, float, float]
"""x, y [m], angle [rad], velocity along x and y [m/s], angular velocity [rad/s]."""


class Motor(Protocol):
    """What moves one body of a space on, and sees whether others stir."""

    def push(self, vx: float, vy: float, turn_rate: float) -> None:
        """Sets the body's velocities: m/s in the world frame, rad/s."""

    def run(self, substep: float, substeps: int) -> None:
        """Lets time run: so many substeps of so many seconds."""

    def read(self) -> State:
        """How the body is and moves."""

    def watch(self, others: Iterable[pymunk.Body]) -> None:
        """Whom it sees besides from now on, in this order."""

    def is_stirring(self) -> bool:
        """Whether one of the others is awake."""

    def is_awake(self, index: int) -> bool:
        """Whether that one of the others is."""

    def point(self, index: int) -> Point:
        """Where that one of the others is [m]."""


def make_motor(space: pymunk.Space, body: pymunk.Body) -> Motor:
    """The fastest motor that this version of pymunk allows."""
    names = ("_space", "_bodies_to_check", "_removed_shapes")
    if _FUNCTIONS and hasattr(body, "_body") and all(hasattr(space, name) for name in names):
        return DirectMotor(space, body)
    return PymunkMotor(space, body)


class PymunkMotor:
    """Moves a body by pymunk's public calls."""

    def __init__(self, space: pymunk.Space, body: pymunk.Body) -> None:
        self._space, self._body = space, body
        self._others: tuple[pymunk.Body, ...] = ()

    def push(self, vx: float, vy: float, turn_rate: float) -> None:
        self._body.velocity = vx, vy
        self._body.angular_velocity = turn_rate

    def run(self, substep: float, substeps: int) -> None:
        for _ in range(substeps):
            self._space.step(substep)

    def read(self) -> State:
        body = self._body
        return *body.position, body.angle, *body.velocity, body.angular_velocity

    def watch(self, others: Iterable[pymunk.Body]) -> None:
        self._others = tuple(others)

    def is_stirring(self) -> bool:
        return any(not body.is_sleeping for body in self._others)

    def is_awake(self, index: int) -> bool:
        return not self._others[index].is_sleeping

    def point(self, index: int) -> Point:
        return self._others[index].position


class DirectMotor:
    """Moves a body by the Chipmunk functions that pymunk calls."""

    def __init__(self, space: pymunk.Space, body: pymunk.Body) -> None:
        self._pymunk_space: Any = space
        self._space: Any = space._space
        self._owner, self._body = body, body._body
        self._step, self._set_velocity, self._set_turn_rate, self._get, self._sleeps, self._where = _FUNCTIONS
        self._others: tuple[Any, ...] = ()
        numbers = _ffi.new("cpFloat[]", _ROOM)
        self._taken = _ffi.new("pmFloatArray *", {"arr": numbers, "max": _ROOM})
        self._batch = _ffi.new("pmBatchedData *", {"fields": _READ, "floatArray": self._taken})
        self._numbers = _ffi.buffer(numbers)

    def push(self, vx: float, vy: float, turn_rate: float) -> None:
        self._set_velocity(self._body, (vx, vy))
        self._set_turn_rate(self._body, turn_rate)

    def run(self, substep: float, substeps: int) -> None:
        owner = self._pymunk_space
        if substeps > 0 and (owner._bodies_to_check or owner._removed_shapes):
            owner.step(substep)
            substeps -= 1
        _exhaust(starmap(self._step, repeat((self._space, substep), substeps)))

    def read(self) -> State:
        self._taken.num = 0
        self._get(self._body, self._batch)
        return _STATE.unpack_from(self._numbers)

    def watch(self, others: Iterable[Any]) -> None:
        self._others = tuple(body._body for body in others)

    def is_stirring(self) -> bool:
        sleeps = self._sleeps
        for body in self._others:  # noqa: SIM110 - asked in every step, where `any` takes twice as long
            if not sleeps(body):
                return True
        return False

    def is_awake(self, index: int) -> bool:
        return not self._sleeps(self._others[index])

    def point(self, index: int) -> Point:
        at = self._where(self._others[index])
        return at.x, at.y
