"""The geometry of a house follows from its file."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest

from decomplex_bt.domain.house import Doorway
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.setting import setting_of
from decomplex_bt.envs.wedges import wedges
from decomplex_bt.errors import InputError

DOMAIN = load_domain("household")
GEOMETRY = setting_of(DOMAIN).geometry


def test_walls_stand_around_rooms_but_not_in_doorways():
    assert GEOMETRY.is_free_line((2.2, 5.0), (2.2, 5.6), ())
    assert not GEOMETRY.is_free_line((1.0, 5.0), (1.0, 5.6), ())
    assert not GEOMETRY.is_free_line((4.2, 8.0), (4.6, 8.0), ())


def test_a_closed_leaf_blocks_a_line():
    through = (3.2, 3.5), (3.2, 4.3)
    assert GEOMETRY.is_free_line(*through, ())
    assert not GEOMETRY.is_free_line(*through, ("bedroom_door",))


@pytest.mark.parametrize("door", GEOMETRY.leaves)
def test_nothing_gets_past_the_edge_of_a_closed_door(door):
    ax, y, bx, _ = GEOMETRY.leaves[door]  # both doors of the house are in walls along x
    for x in (ax, bx, *np.linspace(ax - 0.1, bx + 0.1, 61)):
        for lean in (0.0, -0.3, 0.3):
            assert not GEOMETRY.is_free_line((x - lean, y - 0.3), (x + lean, y + 0.3), (door,))


def test_an_open_door_is_free_from_edge_to_edge():
    ax, y, bx, _ = GEOMETRY.leaves["bedroom_door"]
    free = [GEOMETRY.is_free_line((x, y - 0.3), (x, y + 0.3), ()) for x in (ax - 0.01, ax + 0.01, bx - 0.01, bx + 0.01)]
    assert free == [False, True, True, False]


def test_who_stands_right_in_a_doorway_is_stopped_by_no_wall():
    ax, y, bx, _ = GEOMETRY.leaves["bedroom_door"]
    middle = ((ax + bx) / 2, y)
    assert all(GEOMETRY.is_free_line(middle, end, ()) for end in (middle, (ax + 0.1, y), (bx, y + 0.2), (ax, y - 0.2)))


def test_what_stands_against_a_wall_is_not_free_from_behind_it():
    assert not GEOMETRY.is_free_line((4.2, 8.0), (4.4, 8.0), ())


def test_rooms_of_points():
    points = np.array([(1.0, 8.0), (11.0, 1.0), (6.0, 4.6)])
    rooms = [GEOMETRY.rooms[room] for room in GEOMETRY.rooms_at(points)]
    assert rooms == ["kitchen", "study", "hallway"]
    assert [GEOMETRY.rooms[GEOMETRY.room_at(x, y)] for x, y in points] == rooms


def test_a_doorway_in_no_wall_is_an_error_that_names_it():
    doorways = {**DOMAIN.house.doorways, "hole": Doorway(rooms=("kitchen", "study"), centre=(3.0, 7.0))}
    with pytest.raises(InputError, match=r"doorways\.hole"):
        Geometry(DOMAIN.house.model_copy(update={"doorways": doorways}), DOMAIN.kinds)


def test_what_is_in_sight_is_what_no_wall_stands_before():
    rng = np.random.default_rng(0)
    jambs = [(line[0], line[1]) for line in GEOMETRY.openings.values()]
    jambs += [(line[2], line[3]) for line in GEOMETRY.openings.values()]
    seen_through = 0
    for _ in range(60):
        eye = rng.uniform((0.1, 0.1), (11.9, 8.9))
        points = rng.uniform((0.1, 0.1), (11.9, 8.9), (60, 2))
        room, rooms = GEOMETRY.room_at(*eye), GEOMETRY.rooms_at(points)
        leaves = ("bathroom_door",)
        found = wedges(GEOMETRY, room, complex(*eye), leaves)
        for point, other in zip(points, rooms, strict=True):
            if other == room or min(distance_to_line(jamb, eye, point) for jamb in jambs) < 0.12:
                continue
            towards = complex(*(point - eye))
            seen = any(
                (right.conjugate() * towards).imag >= 0 and (left.conjugate() * towards).imag <= 0
                for beyond, (right, left) in found
                if beyond == other
            )
            assert seen == GEOMETRY.is_free_line(tuple(eye), tuple(point), leaves)
            seen_through += seen
    assert seen_through > 50


def distance_to_line(point, start, end):
    along = np.clip(np.dot(np.subtract(point, start), end - start) / np.dot(end - start, end - start), 0, 1)
    return hypot(*(start + along * (end - start) - point))
