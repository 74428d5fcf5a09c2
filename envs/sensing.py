"""Sensing: what the robot sees of the world, as the entity table of an observation.

It sees what is within `range` and its field of view, behind no wall and no closed door; furniture hides nothing but
what is in a closed container, and into an open one it looks from `inside_range`.
"""

from __future__ import annotations

from collections import deque
from functools import lru_cache
from math import radians
from struct import Struct

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.chance import APERTURE
from decomplex_bt.envs.config import SensingConfig
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.interface import COLUMNS, STATE_PAIRS
from decomplex_bt.envs.scene import Scene, samples_of
from decomplex_bt.envs.wedges import wedges
from decomplex_bt.envs.world import World

VISIBLE, X, Y, HEADING, PLACE, INSPECTED = range(6)
FIRST_STATE = COLUMNS.index(STATE_PAIRS[0])
Table = NDArray[np.float32]
MOST_SCENES = 32
"""Scenes kept at once."""
_NONE = np.empty(0, dtype=np.int64)
_pack = Struct("3f").pack_into
_ROW = np.dtype((np.void, np.dtype(np.float32).itemsize * len(COLUMNS)))


class Sensor:
    """The robot's eyes in one episode. `look` takes the world in; `table` and the masks hold what came of it.

    `visible`: `(rows,)` what is seen now, `inspected`: `(places,)` whose whole contents are in view; `changes` counts
    the looks after which one of them was another than before. Only what is in
    rooms in sight is looked at, laid out in a `Scene` for each set of rooms, kept until something is brought into
    another room.
    """

    # As for `World`: with more than thirty attributes every step would take longer without.
    __slots__ = """
        world config missed_detection _samples _places _movable _floors _half_angle _count _shut _seen_floor _seen_when
        _seen_at _short_before _tracked _known _shown _now _now_at _shown_at table _robot_pose _known_rows _shown_rows
        _now_rows _table_rows _on_floors _floors_at _astray _version _deeds _arrangement _stirs _due _scenes _rooms
        _last_seen changes visible inspected _is_open _limit _seeable
    """.split()

    def __init__(self, world: World, config: SensingConfig) -> None:
        geometry = world.geometry
        self.world, self.config = world, config
        self.missed_detection = geometry.house.missed_detection
        self._samples = samples = samples_of(geometry, config.range, config.inside_range)
        self._places = geometry.place_count
        self._movable = slice(geometry.place_count, geometry.robot_row)
        self._floors = slice(geometry.place_count - len(geometry.rooms), geometry.place_count)
        self._half_angle = radians(min(config.field_of_view, 360.0)) / 2
        self._count = len(geometry.names)
        count = geometry.robot_row - geometry.place_count
        self._shut = np.zeros(self._places + 1, dtype=np.bool_)  # the last one is for what is at no place
        self._seen_floor = samples.never_seen[: samples.floor_count].copy()
        self._seen_when = samples.never_seen[:count].copy()  # of what is out of view; what is in view: by the last look
        self._seen_at = 0.0
        self._short_before = deque([samples.all_short] * (config.looks - 1), maxlen=config.looks - 1)
        self._tracked = np.zeros(count, dtype=np.bool_)
        tables = _tables(geometry).copy()
        self._known, self.table, self._shown, now = tables
        self._known_rows, self._table_rows, self._shown_rows, now_rows = _as_rows(tables)
        self._now, self._now_rows = now[self._movable], now_rows[self._movable]
        self._now_at, self._shown_at = self._now[:, X : Y + 1], self._shown[self._movable, X : Y + 1]
        self._robot_pose = self.table[-1, X : HEADING + 1].data
        self._on_floors = self._floors_at = self._astray = np.empty(0, dtype=np.int64)
        self._version = self._deeds = self._arrangement = self._stirs = -1
        self._due = 0
        self._scenes: dict[tuple[int, ...], Scene] = {}
        self._rooms = np.empty(0, dtype=np.int64)
        self._last_seen = b"", b""
        self.changes = 0
        self.visible = np.zeros(self._count, dtype=np.bool_)
        self.inspected = np.zeros(self._places, dtype=np.bool_)

    def look(self) -> bool:
        """Looks if it is time to, or if the robot changed something; says whether it looked.

        What others change does not make it look: when it looks would tell of what it cannot see.
        """
        world = self.world
        if world.steps < self._due and world.deeds == self._deeds:
            return False
        is_changed = world.version != self._version
        if is_changed:
            self._take_changes()
        is_rearranged = is_changed or world.arrangement != self._arrangement
        if is_rearranged:
            self._note_seeable(is_changed)
        is_moved = is_rearranged or world.stirs != self._stirs
        self._version, self._deeds = world.version, world.deeds
        self._arrangement, self._stirs = world.arrangement, world.stirs
        self._due = world.steps + self.config.every
        if is_moved:
            self._take_motion()
        scene = self._look_round()
        is_news = self._see_movable(is_changed, is_moved)
        self._recall_floors(scene)
        self._write(is_news)
        return True

    def _take_changes(self) -> None:
        """Takes in what changes only when something is done: states, and from how far each thing can be seen."""
        world, samples = self.world, self._samples
        self._shown[: self._places, FIRST_STATE:] = world.states[: self._places]
        self._now[:, FIRST_STATE:] = world.states[self._movable]
        self._now[:, PLACE] = world.place[self._movable]
        shut = self._shut
        np.logical_and(world.prior.has_door, world.states[: self._places, APERTURE] == 0, out=shut[:-1])
        self._is_open = ~shut[:-1]
        at = samples.place_at[world.place[self._movable]]
        limit = self._limit = samples.limit[at]
        limit[shut[at] | ~world.is_somewhere[self._movable]] = -1

    def _note_seeable(self, is_changed: bool) -> None:
        """Notes which things and people can be seen at all, and the rooms they are in.

        Where only the robot has come into another room, the scenes stay as they are.
        """
        self._seeable = (self._limit >= 0).nonzero()[0] + self._places
        before, self._rooms = self._rooms, self.world.room[self._seeable]
        if is_changed or not np.array_equal(self._rooms, before):
            self._scenes.clear()

    def _take_motion(self) -> None:
        """Takes in where things and people are, and where the user is, who is known wherever the robot looks."""
        world, user = self.world, self.world.geometry.user_row
        position = world.position
        self._now_at[...] = position[self._movable]
        self._now[user - self._places :, HEADING] = world.heading[user:-1]
        self._known[user, X : Y + 1] = position[user]

    # -- what is in view ----------------------------------------------------------------------------------------------

    def _look_round(self) -> Scene:
        """What is in view, which places are so with their whole contents, and which floors were within the memory."""
        world, now = self.world, self.world.seconds
        x, y = world.robot
        eye, room = complex(x, y), world.robot_room
        beyond = wedges(world.geometry, room, eye, world.closed_leaves, reach=self.config.range)
        scene = self._scene_of((room, *[other for other, _ in beyond]))
        seen = scene.view(eye, world.robot_heading, beyond)
        self.visible, is_short = seen[: self._count], seen[self._count :]
        short = is_short
        for before in self._short_before:
            short = short | before
        self._short_before.append(is_short)
        self.inspected = inspected = ~short
        layout = scene.layout
        self._seen_floor[layout.floor_numbers[scene.in_view[layout.floor_points]]] = now
        oldest = np.minimum.reduceat(self._seen_floor, self._samples.floor_starts)
        np.greater_equal(oldest, now - self.config.memory, out=inspected[self._floors])
        return scene

    def _scene_of(self, ways: tuple[int, ...]) -> Scene:
        """The scene of the robot's room and those that wedges lead into, with everything where it is now."""
        scene = self._scenes.get(ways)
        if scene is None:
            if len(self._scenes) >= MOST_SCENES:
                self._scenes.clear()
            is_in_sight = np.zeros(len(self.world.geometry.rooms), dtype=np.bool_)
            is_in_sight[list(ways)] = True
            here = is_in_sight[self._rooms].nonzero()[0]
            movable = self._seeable[here]
            self._scenes[ways] = scene = Scene(
                self._samples,
                ways,
                movable,
                self._rooms[here],
                self._limit[movable - self._places],
                self.world.position,
                half_angle=self._half_angle,
                is_open=self._is_open,
            )
            scene.moved_at = self._stirs
        if scene.moved_at != self._stirs:
            scene.moved_at = self._stirs
            scene.move(self.world.position)
        return scene

    def _see_movable(self, is_changed: bool, is_moved: bool) -> bool:
        """Things and people in view, less what is missed: as they are now is how they are shown from here on.

        What was seen by the last look is missed by none. Says whether anything may be shown otherwise than before.
        """
        world = self.world
        in_view = self.visible[self._movable]
        fresh = _NONE
        if in_view.tobytes() != self._tracked.tobytes():
            self._seen_when[self._tracked] = self._seen_at
            (fresh,) = (in_view > self._tracked).nonzero()
            if fresh.size and self.missed_detection > 0:
                in_view[fresh] = world.noise.random(fresh.size) >= self.missed_detection
            self._tracked = in_view.copy()
        self._seen_at = world.seconds
        if not (is_moved or fresh.size):
            return False
        np.copyto(self._shown_rows[self._movable], self._now_rows, where=in_view)
        if is_changed or fresh.size:
            at = self._samples.place_at[self._shown[self._movable, PLACE].astype(np.int64)]
            self._on_floors = self._samples.is_floor[at].nonzero()[0]
            self._floors_at = at[self._on_floors]
        if self._on_floors.size:
            is_astray = np.logical_or.reduce(self._now_at != self._shown_at, axis=1)
            if fresh.size:
                is_astray[fresh] |= ~in_view[fresh]
            self._astray = is_astray[self._on_floors].nonzero()[0]
        return True

    def _recall_floors(self, scene: Scene) -> None:
        """Things seen on a floor a while ago: of an inspected one they are reported along, as they were seen last."""
        on_floors, oldest = self._on_floors, self.world.seconds - self.config.memory
        if not on_floors.size:
            return
        if self._astray.size:
            self._forget(scene, oldest)
        is_inspected = self.inspected[self._floors_at]
        if True in is_inspected.tolist():
            self.visible[self._movable][on_floors] |= is_inspected & (self._seen_when[on_floors] >= oldest)

    def _forget(self, scene: Scene, oldest: float) -> None:
        """Forgets what is not seen any more though its spot is in view.

        Only what is not where it was seen, or was missed, needs to be asked about: the spot of anything else is in view
        when it is itself.
        """
        things = self._on_floors[self._astray]
        is_recent = self._seen_when[things] >= oldest
        self._astray = self._astray[is_recent]
        if self._astray.size:
            things, floors = things[is_recent], self._floors_at[self._astray]
            spots = self._shown_at[things].astype(np.float64)
            is_gone = scene.shows(spots, self.world.geometry.place_room[floors])
            self._seen_when[things[is_gone]] = -np.inf

    # -- the table ----------------------------------------------------------------------------------------------------

    def _write(self, is_news: bool) -> None:
        """Brings the table in line: what is known for ever, and what is seen now."""
        world = self.world
        before, self._last_seen = self._last_seen, (self.visible.tobytes(), self.inspected.tobytes())
        is_change = before != self._last_seen
        self.changes += is_change
        if is_news or is_change:
            self._table_rows[...] = self._known_rows
            np.copyto(self._table_rows, self._shown_rows, where=self.visible)
            self.table[: self._places, INSPECTED] = self.inspected
        _pack(self._robot_pose, 0, *world.robot, world.robot_heading)


def _as_rows(tables: Table) -> NDArray[np.void]:
    """The same tables with each row as one value: chosen by a mask, it is copied whole, in a quarter of the time."""
    return tables.view(_ROW)[..., 0]


@lru_cache(maxsize=8)
def _tables(geometry: Geometry) -> Table:
    """`(4, rows, columns)`, to be copied: twice the entity table before anything is seen, then twice what is shown of
    what is seen: of what is fixed, where it is."""
    known = np.zeros((len(geometry.names), len(COLUMNS)), dtype=np.float32)
    known[: geometry.place_count, X : Y + 1] = geometry.footprints.reshape(-1, 2, 2).mean(axis=1)
    known[:, PLACE] = known[:, FIRST_STATE:] = -1
    shown = known.copy()
    shown[:, VISIBLE] = 1
    return np.stack((known, known, shown, shown))
