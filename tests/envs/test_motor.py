"""What makes the environment quick changes none of its numbers: the direct motor, the kept stage, the one product."""

from __future__ import annotations

from math import cos, hypot, pi, radians, sin

import numpy as np
import pymunk
import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs import stage as stage_module
from decomplex_bt.envs import world as world_module
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.houses import generate_house, with_house
from decomplex_bt.envs.motor import DirectMotor, PymunkMotor
from decomplex_bt.envs.scene import PLACE_X, PLACE_Y, Samples, Scene
from decomplex_bt.envs.setting import setting_of
from decomplex_bt.envs.wedges import wedges

DOMAIN = load_domain("household")
TELL = read_markup("[Tell](1:informing) [me](1:recipient) [hello](1:message).", DOMAIN.ontology, flow=[1])


def drive(env, seed):
    env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    trace = []
    for _ in range(120):
        action = {"drive": rng.uniform((-0.2, -0.6), (1.0, 0.6)), "interact": int(rng.integers(3)), "target": 70}
        trace.append(env.step(action)[0]["robot"].tolist())
    return trace, env.world.position.tobytes()


def test_the_direct_motor_moves_as_pymunk_does(monkeypatch):
    direct = HouseholdEnv(TELL)
    first = drive(direct, 5)
    assert isinstance(direct.world._motor, DirectMotor)
    monkeypatch.setattr(world_module, "make_motor", PymunkMotor)
    public = HouseholdEnv(TELL)
    assert drive(public, 5) == first
    assert isinstance(public.world._motor, PymunkMotor)


def test_a_stage_that_has_been_used_is_as_good_as_new():
    fresh, used = HouseholdEnv(TELL), HouseholdEnv(TELL)
    for seed in (1, 2, 3):
        drive(used, seed)
    assert drive(used, 9) == drive(fresh, 9)


def test_a_stage_set_up_by_pymunk_s_own_calls_is_the_same(monkeypatch):
    direct = HouseholdEnv(TELL)
    traces = [drive(direct, seed) for seed in (4, 5)]
    monkeypatch.setattr(stage_module, "_add_shape", None)
    public = HouseholdEnv(TELL)
    assert [drive(public, seed) for seed in (4, 5)] == traces
    assert len(public.world.space.shapes) == len(direct.world.space.shapes)


def test_what_begins_again_moves_as_what_is_made_anew(monkeypatch):
    again = HouseholdEnv(TELL)
    traces = [drive(again, seed) for seed in (4, 5, 4)]
    assert traces[0] == traces[2]
    monkeypatch.setattr(stage_module, "_begin", ())
    anew = HouseholdEnv(TELL)
    assert [drive(anew, seed) for seed in (4, 5, 4)] == traces


def test_what_was_pushed_about_is_begun_as_if_it_had_never_moved():
    geometry = setting_of(DOMAIN).geometry
    stage, row = stage_module.Stage(geometry), geometry.thing_rows[0]

    def moved(mover):
        space = pymunk.Space()
        space.add(mover.body, mover.shape, *mover.joints)
        trace = []
        for pushed in (False, True):
            if pushed:
                mover.body.velocity, mover.body.angular_velocity = (0.7, 0.1), 2.0
            for _ in range(20):
                space.step(0.01)
                trace.append((*mover.body.position, mover.body.angle, *mover.body.velocity))
        space.remove(mover.body, mover.shape, *mover.joints)
        return trace

    first, again = (moved(stage.thing(row, 0.2, 0.05)) for _ in range(2))
    assert first[-1] != first[0]
    assert again == first


def test_what_a_stage_holds_does_not_grow():
    env = HouseholdEnv(TELL)
    counts = []
    for seed in range(12):
        env.reset(seed=seed)
        counts.append(len(env.world._ground.shapes))
    assert len(set(counts)) == 1


@pytest.mark.parametrize("seed", [None, 3, 5, 8])
def test_a_scene_shows_what_is_in_range_ahead_and_behind_no_wall(seed):
    domain = DOMAIN if seed is None else with_house(DOMAIN, generate_house(DOMAIN, 9, seed))
    geometry = setting_of(domain).geometry
    samples = Samples(geometry, 5.0, 2.0)
    rng = np.random.default_rng(0)
    nobody, nowhere = np.empty(0, dtype=np.int64), np.full((len(geometry.names), 2), np.nan)
    all_open = np.ones(geometry.place_count, dtype=bool)
    jambs = [line[:2] for line in geometry.openings.values()] + [line[2:] for line in geometry.openings.values()]
    shown = two_ways = 0
    for _ in range(80):
        x0, y0, x1, y1 = geometry.room_rects[rng.integers(len(geometry.rooms))]
        x, y = rng.uniform((x0 + 0.1, y0 + 0.1), (x1 - 0.1, y1 - 0.1)).tolist()
        heading, room = float(rng.uniform(-pi, pi)), geometry.room_at(x, y)
        beyond = wedges(geometry, room, complex(x, y), (), reach=5.0)
        ways = (room, *[other for other, _ in beyond])
        two_ways += len(set(ways)) < len(ways)
        scene = Scene(samples, ways, nobody, nobody, np.empty(0), nowhere, half_angle=radians(100), is_open=all_open)
        scene.view(complex(x, y), heading, beyond)
        for index, seen in enumerate(scene.in_view):
            px, py = scene.points[[PLACE_X, PLACE_Y], index].tolist()
            if any(_off(jamb, (x, y), (px, py)) < 0.12 for jamb in jambs):
                continue  # wedges end at the jambs, walls at their round ends
            away = hypot(px - x, py - y)
            ahead = (px - x) * cos(heading) + (py - y) * sin(heading)
            is_near_border = abs(away - 5.0) < 1e-6 or abs(ahead - cos(radians(100)) * away) < 1e-6
            is_clear = geometry.is_free_line((x, y), (px, py), ())
            if not is_near_border and geometry.room_at(px, py) in ways:
                assert seen == (away <= 5.0 and ahead >= cos(radians(100)) * away and is_clear)
                shown += seen
    assert shown > 200
    assert seed is None or two_ways, "some rooms are seen through two doorways"


def _off(point, start, end):
    direction = np.subtract(end, start)
    share = np.clip(np.dot(np.subtract(point, start), direction) / max(1e-12, np.dot(direction, direction)), 0, 1)
    return float(hypot(*(np.add(start, share * direction) - point)))
