"""Driving to a place: a way over the floorplan, pursued within the robot's limits, around what stands in it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from decomplex_bt.envs.floorplan import Cells, Disc, Floorplan, Point, Way

LOOK_AHEAD = 1.6
"""[m] How far along its way the robot minds what is not on the map."""
CHECK_EVERY = 0.15
"""[m] So often it is looked whether a corner can be cut by now."""
ARRIVED = 0.08
"""[m] Distance to the end of the way that counts as being there."""
PATIENCE = 1.5
"""[s] Without progress for so long, the robot is stuck: it backs off and looks for another way."""
PROGRESS = 0.06
"""[m] Less than this is no progress."""
BACK_OFF = 0.6
"""[s] How long it backs off."""
MAX_RESCUES = 3
"""How often it backs off before it gives up."""
SLOWEST = 0.08
"""[m/s] It creeps at this speed at least."""
DITHERING = 6.0
"""[s] Moving about for so long without coming nearer to the goal counts as stuck as well."""


class Pose(NamedTuple):
    """Where the robot is and how it moves: metres, radians (counter-clockwise from +x), m/s, rad/s."""

    x: float
    y: float
    heading: float
    speed: float = 0.0
    turn_rate: float = 0.0

    @property
    def point(self) -> Point:
        return self.x, self.y


@dataclass(frozen=True, slots=True)
class Limits:
    """What the robot can do: m/s, rad/s, m/s², rad/s²; `step` is the control step in seconds."""

    speed: float = 1.0
    turn_rate: float = 2.5
    acceleration: float = 1.5
    turn_acceleration: float = 8.0
    step: float = 0.1


DEFAULT_LIMITS = Limits()


class Course(NamedTuple):
    """What to do now: `drive` is (forward, turn) as shares of the limits in [-1, 1].

    `has_arrived` and a non-empty `problem` (why there is no getting there) both end the drive.
    """

    drive: tuple[float, float] = (0.0, 0.0)
    has_arrived: bool = False
    problem: str = ""


class Driver:
    """One drive to the nearest of some goal cells. Ask it once per control step; it holds the way and its troubles.

    `second_best`: cells that will do where somebody stands in the way to all the others.
    """

    def __init__(self, floorplan: Floorplan, goal: Cells, limits: Limits, *, second_best: Cells | None = None) -> None:
        self.floorplan = floorplan
        self.goal = goal
        self.second_best = second_best
        self.limits = limits
        self._way: Way | None = None
        self._rest: list[Point] = []
        self._behind_next = 0.0
        self._minded: tuple[Disc, ...] = ()
        self._obstacles: Sequence[Disc] = ()
        self._new: list[Disc] = []
        self._leeway: tuple[Point, float] | None = None
        self._checked: Point | None = None
        self._anchor: Point | None = None
        self._anchor_heading = 0.0
        self._idle = 0.0
        self._nearest = math.inf
        self._dithered = 0.0
        self._backing = 0.0
        self._rescues = 0

    def steer(self, pose: Pose, *, closed: frozenset[str] = frozenset(), obstacles: Sequence[Disc] = ()) -> Course:
        """The course for this step.

        `closed`: doors believed closed. `obstacles`: what is seen now besides the map; those in the way are driven
        around, or through (they may move, or be pushed) where there is no way around.
        """
        if self._backing > 0:
            return self._back_off()
        if self._is_stuck(pose):
            self._rescues += 1
            if self._rescues > MAX_RESCUES:
                return Course(problem="stuck: no progress on the way there")
            self._way, self._backing = None, BACK_OFF
            self._nearest, self._dithered = math.inf, 0.0
            return self._back_off()
        if self._way is None or self._is_obstructed(pose, obstacles):
            problem = self._plan(pose, closed, obstacles)
            if problem:
                return Course(problem=problem)
        return self._pursue(pose)

    def _plan(self, pose: Pose, closed: frozenset[str], obstacles: Sequence[Disc]) -> str:
        way = self.floorplan.way(pose.point, self.goal, closed=closed)
        self._minded = ()
        if way is not None and _leeway(way.points, obstacles, self.floorplan.inflation, math.inf) < 0:
            self._minded = tuple(obstacles)
            way = self._way_around(pose, closed, obstacles) or way
        if way is None:
            return "no way there" if not closed else f"no way there with {', '.join(sorted(closed))} closed"
        self._way, self._rest = way, list(way.points)
        self._behind_next = _length(self._rest)
        self._note(obstacles)
        return ""

    def _way_around(self, pose: Pose, closed: frozenset[str], obstacles: Sequence[Disc]) -> Way | None:
        """A way clear of all obstacles, else one clear of those that do not give way."""
        firm = [disc for disc in obstacles if not disc.gives_way]
        for goal in (self.goal, self.second_best):
            for discs in (obstacles, firm) if goal is not None else ():
                assert goal is not None
                around = self.floorplan.way(pose.point, goal, closed=closed, obstacles=discs)
                if around is not None and (discs or not obstacles):
                    return around
        return None

    def _is_obstructed(self, pose: Pose, obstacles: Sequence[Disc]) -> bool:
        """Whether something new stands in the way ahead."""
        if obstacles is not self._obstacles:
            if obstacles == self._obstacles:
                self._obstacles = obstacles  # to be told by itself that it is the same
            else:
                self._note(obstacles)
        if not self._new:
            return False
        point = pose.point
        if self._leeway is None or math.dist(point, self._leeway[0]) >= self._leeway[1]:
            leeway = _leeway([point, *self._rest], self._new, self.floorplan.inflation - 0.05, LOOK_AHEAD)
            self._leeway = point, leeway
            return leeway < 0
        return False

    def _note(self, obstacles: Sequence[Disc]) -> None:
        """Notes what stands about, and what of it was not minded when the way was made."""
        self._obstacles = obstacles
        self._new = [disc for disc in obstacles if not _has_near(self._minded, disc)]
        self._leeway = None

    def _pursue(self, pose: Pose) -> Course:
        assert self._way is not None
        rest = self._rest
        while len(rest) > 1 and self._can_skip(pose, rest):
            rest.pop(0)
            self._behind_next = _length(rest)
            self._checked = self._leeway = None
        target = rest[0]
        gap = math.hypot(target[0] - pose.x, target[1] - pose.y)
        if len(rest) == 1 and gap <= ARRIVED:
            return Course(has_arrived=True)
        return Course(self._towards(pose, target, gap, is_last=len(rest) == 1))

    def _can_skip(self, pose: Pose, rest: list[Point]) -> bool:
        assert self._way is not None
        if math.hypot(rest[0][0] - pose.x, rest[0][1] - pose.y) < 0.05:
            return True
        if self._checked is not None and math.dist(self._checked, pose.point) < CHECK_EVERY:
            return False
        self._checked = pose.point
        return self.floorplan.is_clear(pose.point, rest[1], self._way.free)

    def _towards(self, pose: Pose, target: Point, gap: float, *, is_last: bool) -> tuple[float, float]:
        limits = self.limits
        x, y, heading, speed, _ = pose
        error = wrap(math.atan2(target[1] - y, target[0] - x) - heading)
        turn = steer_turn(error, limits)
        if abs(error) > 1.0:
            return 0.0, turn
        corner = 0.0 if is_last else 0.35
        # Brakes so as to stop at the target; a step is lost before a command takes effect.
        braking = gap - abs(speed) * limits.step
        wanted = corner if braking <= 0 else math.sqrt(2 * 0.8 * limits.acceleration * braking) + corner
        if wanted < SLOWEST:
            wanted = SLOWEST
        share = wanted / limits.speed if wanted < limits.speed else 1.0
        return share * math.cos(error) ** 3, turn

    def _is_stuck(self, pose: Pose) -> bool:
        point = pose.point
        return self._has_dithered(point) or self._has_stopped(point, pose.heading)

    def _has_dithered(self, point: Point) -> bool:
        """Whether the rest of the way has not become shorter for long."""
        left = math.dist(point, self._rest[0]) + self._behind_next if self._rest else math.inf
        if left < self._nearest - PROGRESS:
            self._nearest, self._dithered = left, 0.0
        self._dithered += self.limits.step
        return self._dithered > DITHERING

    def _has_stopped(self, point: Point, heading: float) -> bool:
        has_moved = self._anchor is None or math.dist(point, self._anchor) > PROGRESS
        if has_moved or abs(wrap(heading - self._anchor_heading)) > 0.3:
            self._anchor, self._anchor_heading, self._idle = point, heading, 0.0
            return False
        self._idle += self.limits.step
        return self._idle > PATIENCE

    def _back_off(self) -> Course:
        self._backing -= self.limits.step
        self._anchor = None
        return Course(drive=(-0.4, 0.3 if self._rescues % 2 else -0.3))


def steer_turn(error: float, limits: Limits) -> float:
    """The turning command in [-1, 1] that takes a heading error (rad) away without overshooting."""
    size, fastest = abs(error), limits.turn_rate
    rate = min(fastest, math.sqrt(2 * 0.6 * limits.turn_acceleration * size), size / (1.5 * limits.step))
    return math.copysign(rate / fastest, error)


def wrap(angle: float) -> float:
    """The angle in [-pi, pi]."""
    return math.remainder(angle, math.tau)


def _has_near(discs: Sequence[Disc], disc: Disc) -> bool:
    return any(math.hypot(d.x - disc.x, d.y - disc.y) < 0.15 for d in discs)


def _length(points: Sequence[Point]) -> float:
    """Metres along a polyline."""
    return sum(map(math.dist, points, points[1:]))


def _leeway(points: Sequence[Point], discs: Sequence[Disc], inflation: float, horizon: float) -> float:
    """How far (m) the start of a polyline can move before a disc may stand on it; negative where one does.

    Of a polyline only the segments that begin within `horizon` metres of its start count.
    """
    leeway, travelled = math.inf, 0.0
    for start, end in pairwise(points):
        if travelled > horizon:
            return min(leeway, travelled - horizon)
        length = math.hypot(end[0] - start[0], end[1] - start[1])
        for disc in discs:
            leeway = min(leeway, _segment_distance(start, end, length, disc) - (disc.radius + inflation))
        travelled += length
    return leeway


def _segment_distance(start: Point, end: Point, length: float, disc: Disc) -> float:
    if length < 1e-9:
        return math.hypot(disc.x - start[0], disc.y - start[1])
    dx, dy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    along = min(length, max(0.0, (disc.x - start[0]) * dx + (disc.y - start[1]) * dy))
    return math.hypot(start[0] + along * dx - disc.x, start[1] + along * dy - disc.y)
