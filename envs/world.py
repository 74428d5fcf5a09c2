"""The world: bodies, contacts and time of one episode, and the truth about everything in the house.

SI units; world frame with the origin bottom left; headings in radians, counter-clockwise from +x.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import cos, pi, sin
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pymunk
from numpy.random import Generator
from numpy.typing import NDArray

from decomplex_bt.envs.chance import APERTURE, Start
from decomplex_bt.envs.config import WorldConfig
from decomplex_bt.envs.geometry import Floats, Geometry
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.motor import make_motor
from decomplex_bt.envs.prior import ABSENT, Prior
from decomplex_bt.envs.spots import PERSON_RADIUS, ROBOT_RADIUS, Disc, Spots
from decomplex_bt.envs.stage import Collision, Mover, Stage, clear, put, shaped

if TYPE_CHECKING:
    from decomplex_bt.envs.walking import Walk

TURN = 2 * pi  # [rad]
STILL = 1e-3  # [m/s, rad/s] slower than this nothing needs to be braked
NOTHING = -1
"""In place of a row: an empty hand or slot."""
_INTERACTIONS, _RESULTS = (
    tuple(member.name.lower().replace("_", " ") for member in members) for members in (Interaction, Result)
)


class Event(NamedTuple):
    """An interaction that was tried in the last step, by names: with what in the hand (before it) and what came of it.

    `person`: who was spoken to, who got or gave the thing. `goal`: where somebody who leads the way is going.
    """

    interaction: Interaction
    target: str
    result: Result
    thing: str | None = None
    person: str | None = None
    goal: str | None = None

    def __str__(self) -> str:
        target = self.target if self.goal is None else f"lead to {self.goal}"
        thing = f" with {self.thing}" if self.thing not in (None, self.target) else ""
        return f"{_INTERACTIONS[self.interaction]} {target}{thing}: {_RESULTS[self.result]}"


class World:
    """One episode's world. `drive` moves it on by a control step; `hands.interact` changes it by what the robot does.

    Arrays by row of the entity table: `position` `(rows, 2)`, `heading` `(rows,)`, `place` (row of the place a thing
    lies at or of who carries it, `ABSENT` where nowhere and for all but things), `room` (index, -1 where not in the
    house), `states` `(rows, pairs)`, `broken`, `home`. `held` and `tray` are rows or `NOTHING`. `version` counts
    changes that are no motion, `deeds` those of them that the robot made, `arrangement` moves from one room to
    another, the robot's too (which is in room `robot_room`), and `stirs` steps in which anything but the robot moved.
    `closed_leaves`: the doors between rooms that are closed. `noise` is for slips and misses, `whims` gives numbers in
    [0, 1) for where people go who may go wherever they like.
    `stage`: the fixed shapes to use, which leave the world they were in before; None: this world gets its own.
    """

    # An object with more than thirty attributes in its dictionary shares no keys with others of its class, so that
    # CPython looks up each attribute and method of it anew: every step would take longer.
    __slots__ = """
        __dict__ __weakref__ geometry prior spots config noise whims grasp_slip place _position _is_stale _is_still
        _substep _substeps _step_seconds _max_speed _max_turn_rate _most_gained _most_turned heading robot_heading
        states broken home exempt room is_somewhere robot_room held tray speed turn_rate steps seconds version
        arrangement stirs deeds event walks _floors space _stage _ground _bodies _people _leaf_shapes closed_leaves
        _loose _awake _moved _motor robot _robot _carried _is_carrying
    """.split()

    _is_dismantled = False

    def __init__(
        self,
        geometry: Geometry,
        prior: Prior,
        spots: Spots,
        start: Start,
        *,
        config: WorldConfig,
        noise: Generator,
        whims: Callable[[], float],
        stage: Stage | None = None,
    ) -> None:
        self.geometry, self.prior, self.spots, self.config = geometry, prior, spots, config
        self.noise, self.whims = noise, whims
        self.grasp_slip = geometry.house.grasp_slip
        self.place = start.place.copy()
        self._position = start.position.copy()
        self._is_stale = False
        self._substep, self._substeps, self._step_seconds = config.substep, config.substeps, config.step_seconds
        step = config.step_seconds
        self._max_speed, self._max_turn_rate = config.max_speed, config.max_turn_rate
        self._most_gained, self._most_turned = config.max_acceleration * step, config.max_turn_acceleration * step
        self.heading = np.zeros(len(geometry.names))
        self.heading[geometry.robot_row] = self.robot_heading = start.heading
        self.states: NDArray[np.int8] = start.states.copy()
        self.broken: NDArray[np.bool_] = start.broken.copy()
        self.home: NDArray[np.bool_] = start.home.copy()
        self.exempt = tuple(start.exempt)
        self.room = prior.nowhere.copy()
        self.is_somewhere = self.home | (self.place != ABSENT)
        """`(rows,)`: of things and people, whether they are in the house."""
        self.robot_room = 0
        self.held = NOTHING
        self.tray = [NOTHING] * config.tray_slots
        self.speed = self.turn_rate = 0.0
        self._is_still = True
        self.steps, self.seconds = 0, 0.0
        self.version = 0
        self.arrangement = self.stirs = self.deeds = 0
        self.event: Event | None = None
        self.walks: dict[int, Walk] = {}
        self._floors = frozenset(prior.floors)
        self._build(stage or Stage(geometry))
        self._locate_all()

    # -- time ---------------------------------------------------------------------------------------------------------

    def drive(self, forward: float, turn: float) -> None:
        """One control step: `forward` and `turn` in [-1, 1], as shares of the highest speed and turn rate; both 0 to
        brake."""
        self._push(forward, turn)
        self._motor.run(self._substep, self._substeps)
        self.steps += 1
        self.seconds = self.steps * self._step_seconds
        self._read()
        self.locate()

    # -- questions ----------------------------------------------------------------------------------------------------

    @property
    def position(self) -> Floats:
        """`(rows, 2)` metres, NaN for what is not in the house."""
        if self._is_stale:
            self._read_all()
        return self._position

    def is_floor(self, row: int) -> bool:
        return row in self._floors

    def at(self, place: int) -> list[int]:
        """The things that lie at a place, or are carried by a person or the robot, in order of rows."""
        return np.flatnonzero(self.place == place).tolist()

    def discs_at(self, place: int) -> Iterator[Disc]:
        """What takes up room at a place: the things there; on a floor also people and robot."""
        for row in self.at(place):
            yield (*self.position[row].tolist(), self.prior.radius[row])
        if place in self._floors:
            for row in np.flatnonzero(self.home).tolist():
                yield (*self.position[row].tolist(), PERSON_RADIUS)
            yield (*self.robot, ROBOT_RADIUS)

    # -- changes ------------------------------------------------------------------------------------------------------

    def lift(self, thing: int, holder: int) -> None:
        """Takes a thing from where it is to its holder: the robot or a person."""
        if thing in self._bodies:
            self._drop_body(thing)
        self.place[thing] = holder
        self._note_carried()
        self._is_stale = True
        self.version += 1

    def lay(self, thing: int, place: int, spot: tuple[float, float]) -> None:
        """Lays a thing down at a spot of a place."""
        self.place[thing] = place
        self.position[thing] = spot
        self.room[thing] = self.geometry.place_room[place]
        if place in self._floors:
            self._add_thing(thing)
        self._note_carried()
        self.version += 1

    def shift(self, thing: int, place: int, spot: tuple[float, float]) -> None:
        """Moves a thing that lies somewhere to a spot of a place, without the robot."""
        if thing in self._bodies:
            self._drop_body(thing)
        self.lay(thing, place, spot)
        self.arrangement += 1

    def set_state(self, row: int, pair: int, value: int) -> None:
        self.states[row, pair] = value
        self.version += 1
        name = self.geometry.names[row]
        if pair == APERTURE and name in self.geometry.leaves:
            self._swing(name)

    def is_leaf_clear(self, door: str) -> bool:
        """Whether nobody and nothing stands where the door's leaf closes."""
        everything = pymunk.ShapeFilter.ALL_CATEGORIES()
        hits = self.space.shape_query(self._stage.leaves[door])
        return not any(hit.shape is not None and hit.shape.filter.categories != everything for hit in hits)

    def start_walking(self, person: int) -> pymunk.Body:
        """Gives a standing person a body that can be moved; the walk sets its velocity."""
        self.space.remove(self._people.pop(person))
        body = pymunk.Body(70.0, float("inf"))
        body.position = self.position[person].tolist()
        self._add_body(person, body, shaped(pymunk.Circle(body, PERSON_RADIUS), Collision.PERSON))
        return body

    def stop_walking(self, person: int) -> None:
        self._drop_body(person)
        self._stand(person)
        self.room[person] = self.geometry.room_at(*self.position[person].tolist())
        self.arrangement += 1

    def dismantle(self) -> None:
        """Takes everything out of the space; the world is of no more use then.

        A space that still holds something when it is thrown away is taken to pieces by callbacks from within the
        garbage collector, where what they touch may be gone already: the process may crash.
        """
        clear(self.space)
        self._bodies.clear()
        self._is_dismantled = True

    def __del__(self) -> None:
        if self._is_dismantled:
            return
        # no `suppress`: while the interpreter shuts down, this module's names may be gone
        try:  # noqa: SIM105
            self.space.remove(*self.space.constraints, *self.space.shapes, *self.space.bodies)
        except Exception:
            pass  # half made, or pymunk's own names are gone

    # -- building -----------------------------------------------------------------------------------------------------

    def _build(self, stage: Stage) -> None:
        geometry = self.geometry
        self.space = pymunk.Space()
        self.space.sleep_time_threshold = 0.4
        self.space.idle_speed_threshold = 0.02
        self.space.collision_slop = 0.002  # [m]; the default suits pixels
        stage.set_up(self.space)
        self._stage, self._ground = stage, stage.ground
        self._bodies: dict[int, tuple[pymunk.Body, tuple[pymunk.Shape | pymunk.Constraint, ...]]] = {}
        self._people: dict[int, pymunk.Shape] = {}
        self._leaf_shapes: dict[str, pymunk.Shape] = {}
        self.closed_leaves: tuple[str, ...] = ()
        self._loose: list[int] = []  # the rows of what may move, besides the robot, in order
        self._awake: set[int] = set()
        self._moved: set[int] = set()
        for name in geometry.leaves:
            self._swing(name)
        for person in self.home.nonzero()[0].tolist():
            self._stand(person)
        robot = stage.robot()
        self._motor = make_motor(self.space, robot.body)
        places = self.place.tolist()
        for thing in geometry.thing_rows:
            if places[thing] in self._floors:
                self._add_thing(thing)
        self._add_robot(robot)
        self._note_carried()

    def _add_robot(self, robot: Mover) -> None:
        row, body = self.geometry.robot_row, robot.body
        x, y = self.position[row].tolist()
        self.robot = body.position = x, y
        body.angle = self.robot_heading
        self._add_body(row, body, robot.shape)
        self._robot = body

    def _add_thing(self, thing: int) -> None:
        """Puts a thing on the floor."""
        kind = self.prior.kinds[thing]
        mover = self._stage.thing(thing, kind.mass, kind.radius)
        mover.body.position = self.position[thing].tolist()
        self._add_body(thing, mover.body, mover.shape, *mover.joints)

    def _add_body(self, row: int, body: pymunk.Body, shape: pymunk.Shape, *joints: pymunk.Constraint) -> None:
        self._bodies[row] = (body, (shape, *joints))
        put(self.space, shape, body, joints)
        if row != self.geometry.robot_row:
            self._watch(sorted((*self._loose, row)))
            self._awake.add(row)
        self.arrangement += 1

    def _drop_body(self, row: int) -> None:
        if self._is_stale:
            self._read_all()
        body, parts = self._bodies.pop(row)
        self.space.remove(*parts, body)
        self._watch([other for other in self._loose if other != row])
        self._awake.discard(row)
        self._moved.discard(row)
        self.arrangement += 1

    def _watch(self, rows: list[int]) -> None:
        self._loose = rows
        self._motor.watch(self._bodies[row][0] for row in rows)

    def _stand(self, person: int) -> None:
        self._people[person] = shape = self._stage.person(person, self.position[person].tolist())
        put(self.space, shape)

    def _swing(self, door: str) -> None:
        """Brings the leaf of a door in line with its state."""
        is_closed = self.states[self.geometry.row[door], APERTURE] == 0
        if is_closed and door not in self._leaf_shapes:
            self._leaf_shapes[door] = shape = self._stage.leaves[door]
            put(self.space, shape)
        elif not is_closed and door in self._leaf_shapes:
            self.space.remove(self._leaf_shapes.pop(door))
        self.closed_leaves = tuple(self._leaf_shapes)

    # -- moving -------------------------------------------------------------------------------------------------------

    def _push(self, forward: float, turn: float) -> None:
        """Sets the robot's velocities for a step: towards those wanted, within its accelerations, no sideways slip.

        Where none is wanted at all it brakes, harder than it accelerates: it stands from this step on, and stays where
        it is unless it is pushed. The contacts of the step may then change the velocities. The direction is that of the
        middle of the step.
        """
        if forward == 0.0 and turn == 0.0:
            if not self._is_still:
                self._motor.push(0.0, 0.0, 0.0)
            return
        speed, turn_rate = self.speed, self.turn_rate
        gain, most = forward * self._max_speed - speed, self._most_gained
        speed += most if gain > most else -most if gain < -most else gain
        gain, most = turn * self._max_turn_rate - turn_rate, self._most_turned
        turn_rate += most if gain > most else -most if gain < -most else gain
        middle = self.robot_heading + turn_rate * self._step_seconds / 2
        self._motor.push(speed * cos(middle), speed * sin(middle), turn_rate)

    def _read(self) -> None:
        """Reads where the robot is; the others are read when somebody asks."""
        x, y, angle, vx, vy, turn_rate = self._motor.read()
        angle = (angle + pi) % TURN - pi
        self.robot = (x, y)
        self.heading[-1] = self.robot_heading = angle
        self.speed = vx * cos(angle) + vy * sin(angle)
        self.turn_rate = turn_rate
        self._is_still = -STILL < vx < STILL and -STILL < vy < STILL and -STILL < turn_rate < STILL
        self._is_stale = True

    def _read_all(self) -> None:
        """Reads the bodies that may have moved; what is carried goes along."""
        self._is_stale = False
        position, motor = self._position, self._motor
        position[-1] = self.robot
        for index, row in enumerate(self._loose):
            is_awake = motor.is_awake(index)
            if is_awake or row in self._awake:  # one that has just fallen asleep is read once more
                position[row] = self._held_back(row, motor.point(index))
                self._moved.add(row)
                (self._awake.add if is_awake else self._awake.discard)(row)
        if self._moved or self._is_carrying:
            self.stirs += 1
        if self._is_carrying:
            position[self._carried] = position[self.place[self._carried]]

    def _held_back(self, row: int, point: tuple[float, float]) -> tuple[float, float]:
        """Where something that moves is after a step. A thing that came through a wall or a closed door is put back.

        The robot outweighs a pencil so much that the solver gives way between it and a wall: what is squeezed there
        gets through now and then, however short the substeps.
        """
        if row not in self.geometry.thing_rows:
            return point
        x, y = self._position[row].tolist()
        if point == (x, y) or self.geometry.is_free_line((x, y), point, self.closed_leaves):
            return point
        body, _ = self._bodies[row]
        body.position, body.velocity, body.angular_velocity = (x, y), (0.0, 0.0), 0.0
        return x, y

    def locate(self) -> None:
        """Brings rooms in line with positions, and the floor a thing lies on with where it was pushed."""
        room, before = self.room, self.robot_room
        x, y = self.robot
        self.robot_room = here = self.geometry.room_at(x, y, guess=before)
        if here != before:
            room[-1] = here
            self.arrangement += 1
        is_carrying = self._is_carrying
        if self._is_stale and (is_carrying or self._awake or self._motor.is_stirring()):
            self._read_all()
        if self._moved:
            self._locate(sorted(self._moved))
            self._moved.clear()
        if is_carrying:
            rooms = room[self.place[self._carried]]
            if not np.array_equal(rooms, room[self._carried]):
                room[self._carried] = rooms
                self.arrangement += 1

    def _locate(self, rows: list[int]) -> None:
        """Brings the rooms of things and people that moved in line, and the floors that the things lie on."""
        for row in rows:
            was = int(self.room[row])
            room = self.geometry.room_at(*self._position[row].tolist(), guess=was)
            if room == was:
                continue
            self.room[row] = room
            self.arrangement += 1
            if row < self.geometry.people_rows[0]:
                self.place[row] = self.geometry.floor_row[room]
                self.version += 1

    def _locate_all(self) -> None:
        geometry = self.geometry
        self.room[:] = geometry.room_of_place[self.place]
        self.room[: geometry.place_count] = geometry.place_room
        (people,) = self.home.nonzero()
        for person, (x, y) in zip(people.tolist(), self._position[people].tolist(), strict=True):
            self.room[person] = geometry.room_at(x, y)
        self.robot_room = self.room[-1] = geometry.room_at(*self.robot)
        if self._is_carrying:
            self.locate()

    def _note_carried(self) -> None:
        """Notes which things somebody carries, the robot or a person."""
        (self._carried,) = (self.place >= self.geometry.user_row).nonzero()
        self._is_carrying = self._carried.size > 0
