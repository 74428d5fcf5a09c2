"""What the body has seen: observations decoded to names, with a short memory, by the house map alone."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.domain.house import House
from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.envs.floorplan import Disc, Floorplan, rect_distance
from decomplex_bt.envs.interface import COLUMNS, STATE_PAIRS, Result
from decomplex_bt.envs.navigation import Pose

STEADY = 0.3
"""[s] For so long somebody or something out of view still counts as seen for the sake of a skill."""
STANDING = 1.0
"""[s] A person who was not seen to move for so long stands."""
STIR = 0.05
"""[m] Less than this between two looks is no move."""
RECALL = 15.0
"""[s] For so long a floor seen bit by bit counts as inspected, and people seen meanwhile as still there."""
REMEMBERED = 10.0
"""[s] For so long a person out of view is still reckoned with as an obstacle where they were."""
NEAR_PLACE = 1.0
"""[m] Within this distance of its footprint, and in its room, the robot is at a place."""
NEAR_PERSON = 1.5
"""[m] Within this distance of their centre, and in their room, the robot is with a person."""
_VISIBLE, _X, _Y, _INSPECTED = (COLUMNS.index(name) for name in ("visible", "x", "y", "inspected"))
_RESULTS = tuple(Result)
_PERSON_RADIUS = 0.25
_REPORTED = [COLUMNS.index(name) for name in ("place", *STATE_PAIRS)]

Obstacle = tuple[str, Disc, float]
"""Who or what it is, where, and until when [s] it is reckoned with."""
Places = Mapping[str, str]
States = Mapping[tuple[str, str], str]


class Senses:
    """The last observation in the domain's names, and where each entity was seen last.

    The mappings keep their identity while nothing in them changes, so that a reader can tell by `is` that there is
    nothing new.
    """

    def __init__(self, house: House, kinds: Kinds, floorplan: Floorplan) -> None:
        self.house, self.kinds, self.floorplan = house, kinds, floorplan
        self.names = house.entities()
        self.row = {name: index for index, name in enumerate(self.names)}
        self.people = tuple(house.people)
        self._things = np.array([name in house.things for name in self.names])
        self._values = {
            (column, flag): kinds.state_pairs[pair].values[0 if flag else 1]
            for column, pair in enumerate(STATE_PAIRS)
            if pair in kinds.state_pairs
            for flag in (0, 1)
        }
        self._fixed = {
            room: [
                (name, floorplan.footprint(name))
                for name in (*house.furniture, *house.doorways)
                if room in floorplan.rooms_of(name)
            ]
            for room in house.rooms
        }
        self._floor_rows = frozenset(self.row[house.floor_of(room)] for room in house.rooms)
        self._people_rows = [self.row[name] for name in house.people]
        self._radius = {name: house.kind(name, kinds).radius for name in house.things}
        self._least, self._most = _bounds(len(self.names), kinds)
        self.clear()

    def clear(self) -> None:
        """Forgets everything."""
        count = len(self.names)
        self.pose = Pose(0.0, 0.0, 0.0)
        self.room = ""
        self._rect = (0.0, 0.0, 0.0, 0.0)
        self.held: str | None = None
        self.tray: tuple[str | None, ...] = ()
        self._rows = b""
        self._carried: tuple[str | None, ...] = ()
        self.result = Result.NONE
        self.seconds = 0.0
        self.places: Places = MappingProxyType({})
        self.states: States = MappingProxyType({})
        self.inspected: frozenset[str] = frozenset()
        self.unseen: frozenset[str] = frozenset()
        self.near: frozenset[str] = frozenset()
        self._near: list[str] = []
        self._near_places: list[str] = []
        self._near_from = ((0.0, 0.0), "", -1.0)
        self._position = np.full((count, 2), np.nan)
        self._data = b""
        self._visible = np.zeros(count, dtype=bool)
        self._seen_at = np.full(count, -math.inf)
        self._signature: tuple[bytes, bytes, tuple[str, ...]] | None = None
        self._recalled: tuple[str, ...] = ()
        self._door_states: dict[str, str] = {}
        self._closed: frozenset[str] | None = None
        self._about: list[Obstacle] = []
        self._stood: dict[str, tuple[float, float]] = {}
        self._walked_at: dict[str, float] = {}
        self._lying: list[Obstacle] = []
        self._on_floors: list[tuple[str, int]] = []
        self._obstacles: list[Disc] = []
        self._besides: str | None = None
        self._until = -math.inf
        self._told: dict[int, tuple[list[float], str | None, dict[tuple[str, str], str]]] = {}

    def take(self, observation: Mapping[str, Any]) -> None:
        """Takes one observation in. Call it once per observation, in order.

        Raises one of Python's errors (`ValueError`, `TypeError`, ...) for what is none of this house, before anything
        of it is taken in.
        """
        x, y, heading, speed, turn_rate = observation["robot"].tolist()
        carried, result, (seconds,) = observation["held"], observation["result"], observation["seconds"].tolist()
        rows, table = carried.tobytes(), observation["entities"][: len(self.names)]
        data = table.tobytes()
        held, *tray = self._carried if rows == self._rows else self._named(carried)
        is_fit = math.isfinite(x + y + heading + speed + turn_rate + seconds) and 0 <= result < len(_RESULTS)
        if not is_fit or (data != self._data and not self.is_table(table)):
            raise ValueError("no observation of this house")
        self.pose = Pose(x, y, heading, speed, turn_rate)
        self.room = self._room_at(x, y)
        self._rows, self._carried = rows, (held, *tray)
        self.held, self.tray = held, tuple(tray)
        self.result = _RESULTS[result]
        self.seconds = seconds
        if data != self._data:  # between two looks the table stays as it is
            self._data = data
            self._take_table(table)
        self._take_near()

    def is_table(self, table: Any) -> bool:
        """Whether it is an entity table of this house; further rows of it stand for nothing."""
        is_like = isinstance(table, np.ndarray) and table.ndim == 2 and table.dtype.kind == "f"
        if not is_like or table.shape[0] < len(self.names) or table.shape[1] != len(COLUMNS):
            return False
        own = table[: len(self.names)]
        return bool(((own >= self._least) & (own <= self._most)).all())  # and so no NaN

    def _named(self, carried: NDArray) -> list[str | None]:
        """Names of the rows that are carried. Raises `ValueError`."""
        rows = carried.tolist()
        if not rows or not all(-1 <= row < len(self.names) for row in rows):
            raise ValueError("no rows of this house")
        return [self.names[row] if row >= 0 else None for row in rows]

    def _room_at(self, x: float, y: float) -> str:
        """The room a point lies in, asked of the last one first; outside the house the last one."""
        left, bottom, right, top = self._rect
        if not (left <= x < right and bottom <= y < top):
            room = self.floorplan.room_at(x, y)
            if room is None:
                return self.room
            self._rect = self.house.rooms[room].rect
            return room
        return self.room

    # -- answers ------------------------------------------------------------------------------------------------------

    def position(self, name: str) -> tuple[float, float] | None:
        """Where an entity was seen last (m); None if never."""
        x, y = self._position[self.row[name]].tolist()
        return None if math.isnan(x) else (x, y)

    def is_seen(self, name: str) -> bool:
        """Whether it is in view, or was a moment ago."""
        return self._was_seen(self.row[name], STEADY)

    def distance(self, name: str) -> float:
        """Metres from the robot's centre to a place's footprint, or to the centre of a thing or person as last seen."""
        if name in self.house.furniture or name in self.house.doorways:
            return self.floorplan.distance_to(name, self.pose.x, self.pose.y)
        position = self.position(name)
        if position is None:
            return math.inf
        return math.hypot(position[0] - self.pose.x, position[1] - self.pose.y)

    def room_of_person(self, name: str) -> str | None:
        """The room a person was last seen in; None if never seen."""
        position = self.position(name)
        return None if position is None else self.floorplan.room_at(*position)

    def has_walked(self, name: str) -> bool:
        """Whether a person was seen to walk a moment ago; between two looks they may be elsewhere by now."""
        return self.seconds - self._walked_at.get(name, -math.inf) < STANDING

    def closed_doors(self) -> frozenset[str]:
        """The doorways last seen closed."""
        if self._closed is None:
            self._closed = frozenset(name for name, value in self._door_states.items() if value == "closed")
        return self._closed

    def note_opened(self, name: str) -> None:
        """Notes that the robot has opened a door, which it need not see: it may have its back to it."""
        if name in self._door_states:
            self._door_states[name], self._closed = "open", None

    def obstacles(self, *, besides: str | None = None) -> list[Disc]:
        """The people seen in the last seconds and the things seen on floors now, except for `besides`.

        The same list while nothing in it changes: not to be altered.
        """
        if besides != self._besides or self.seconds >= self._until:
            now = [each for each in (*self._about, *self._lying) if each[0] != besides and self.seconds < each[2]]
            self._obstacles = [disc for _, disc, _ in now]
            self._besides, self._until = besides, min((until for *_, until in now), default=math.inf)
        return self._obstacles

    def _was_seen(self, row: int, within: float) -> bool:
        return bool(self._visible[row]) or self.seconds - self._seen_at[row] < within

    # -- decoding -----------------------------------------------------------------------------------------------------

    def _take_table(self, table: NDArray) -> None:
        self._until = -math.inf
        self._seen_at[self._visible] = self.seconds
        self._visible = visible = table[:, _VISIBLE] > 0.5
        known = visible | ((table[:, _X] != 0) | (table[:, _Y] != 0))
        self._position[known] = table[known, _X : _Y + 1]
        inspected = table[:, _INSPECTED] > 0.5
        self._take_people(visible)
        self._recalled = self._recall(visible, inspected)
        signature = visible.tobytes() + inspected.tobytes(), table[:, _REPORTED].tobytes(), self._recalled
        if signature != self._signature or self._has_moving_person(visible):
            self._signature = signature
            self._report(table, np.flatnonzero(visible), np.flatnonzero(inspected))
        self._lying = []
        for name, row in self._on_floors:
            x, y = self._position[row].tolist()
            self._lying.append((name, Disc(x, y, self._radius[name], gives_way=True), math.inf))

    def _take_people(self, visible: NDArray) -> None:
        """Notes who is about, and until when they are reckoned with where they were seen."""
        about = []
        for name, row in zip(self.people, self._people_rows, strict=True):
            until = math.inf if visible[row] else float(self._seen_at[row]) + REMEMBERED
            if self.seconds < until:
                x, y = self._position[row].tolist()
                if math.dist(self._stood.get(name, (x, y)), (x, y)) > STIR:
                    self._walked_at[name] = self.seconds
                self._stood[name] = x, y
                about.append((name, Disc(x, y, _PERSON_RADIUS), until))
        self._about = about

    def _recall(self, visible: NDArray, inspected: NDArray) -> tuple[str, ...]:
        """The people out of view who are taken to be where they were: in a room whose floor counts as inspected.

        It counts so for what was seen of it in the last seconds, and so must they.
        """
        recalled = []
        for name, row in zip(self.people, self._people_rows, strict=True):
            if not visible[row] and self.seconds - self._seen_at[row] <= RECALL:
                room = self.room_of_person(name)
                if room is not None and inspected[self.row[self.house.floor_of(room)]]:
                    recalled.append(name)
        return tuple(recalled)

    def _has_moving_person(self, visible: NDArray) -> bool:
        """Whether a person in view has walked into another room since the last report."""
        return any(
            (visible[self.row[name]] or name == self.house.user) and self.places.get(name) != self.room_of_person(name)
            for name in self.people
        )

    def _report(self, table: NDArray, visible: NDArray, inspected: NDArray) -> None:
        places: dict[str, str] = {}
        states: dict[tuple[str, str], str] = {}
        names = self.names
        on_floors = []
        reported = table.take(visible, axis=0).take(_REPORTED, axis=1).tolist()
        for index, row in zip(visible.tolist(), reported, strict=True):
            name = names[index]
            told = self._told.get(index)
            if told is None or told[0] != row:
                told = self._told[index] = row, *self._tell(name, row)
            _, place, its_states = told
            if place is not None:
                places[name] = place
                if name in self._radius and row[0] in self._floor_rows:
                    on_floors.append((name, index))
            elif name in self.house.people:
                places[name] = self.room_of_person(name) or ""
            if its_states:
                states.update(its_states)
                if name in self.house.doorways:
                    self._door_states[name], self._closed = its_states[name, "aperture"], None
        for name in self._recalled:
            places[name] = self.room_of_person(name) or ""
        unseen = set(self._recalled)
        if self.house.user not in places and (room := self.room_of_person(self.house.user)) is not None:
            places[self.house.user] = room  # the user's place is always known
            unseen.add(self.house.user)
        if unseen != self.unseen:
            self.unseen = frozenset(unseen)
        self._on_floors = on_floors
        self.places, self.states = _kept(self.places, places), _kept(self.states, states)
        looked_into = frozenset(names[index] for index in inspected.tolist())
        if looked_into != self.inspected:
            self.inspected = looked_into

    def _tell(self, name: str, row: Sequence[float]) -> tuple[str | None, dict[tuple[str, str], str]]:
        """Where an entity is and in which states, by the reported columns of its row."""
        at, *flags = map(int, row)
        states = {
            (name, pair): self._values[column, flag]
            for column, (pair, flag) in enumerate(zip(STATE_PAIRS, flags, strict=True))
            if flag >= 0
        }
        return (self.names[at] if at >= 0 else None), states

    def _take_near(self) -> None:
        point = x, y = self.pose.point
        at, room, margin = self._near_from
        if room != self.room or math.dist(point, at) >= margin:
            self._take_near_places(point)
        near = self._near_places
        for name, disc, until in self._about:
            is_seen = self.seconds < until - REMEMBERED + STEADY
            if is_seen and math.hypot(disc.x - x, disc.y - y) <= NEAR_PERSON:
                near = [*near, name]
        if near != self._near:
            self._near, self.near = near, frozenset(near)

    def _take_near_places(self, point: tuple[float, float]) -> None:
        """The places at which the robot is, and how far it may move before it need be asked again."""
        x, y = point
        near, margin = [], math.inf
        for name, rect in self._fixed.get(self.room, ()):
            beyond = rect_distance(rect, x, y) - NEAR_PLACE
            if beyond <= 0:
                near.append(name)
            margin = min(margin, abs(beyond))
        if self.room:
            near.append(self.house.floor_of(self.room))
        self._near_places, self._near_from = near, (point, self.room, margin)


def _bounds(rows: int, kinds: Kinds) -> tuple[NDArray, NDArray]:
    """The least and the most that each column of an entity table of so many rows holds."""
    most = np.full(len(COLUMNS), np.finfo(np.float32).max, dtype=np.float32)
    least = -most
    least[[_VISIBLE, _INSPECTED]], most[[_VISIBLE, _INSPECTED]] = 0, 1
    least[_REPORTED] = -1
    most[_REPORTED] = rows - 1, *(1 if pair in kinds.state_pairs else -1 for pair in STATE_PAIRS)
    return least, most


def _kept(old: Mapping, new: dict) -> Mapping:
    """The old mapping where nothing has changed."""
    return old if old == new else MappingProxyType(new)
