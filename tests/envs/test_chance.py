"""How an episode begins is drawn from the generator alone, and fits the house."""

from __future__ import annotations

import numpy as np
import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.balance import PersonTest, PlaceTest, StateTest, Whereabouts, WorksTest, at_least, mix
from decomplex_bt.envs.chance import POWER, TEMPERATURE, Draw
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.prior import ABSENT
from decomplex_bt.envs.setting import setting_of
from decomplex_bt.envs.spots import PERSON_RADIUS
from decomplex_bt.envs.stream import Stream
from decomplex_bt.errors import InputError

SETTING = setting_of(load_domain("household"))
ROW = SETTING.geometry.row


def drawn(seed, tests=(), balance=0.3):
    draw = Draw(SETTING.prior, SETTING.spots)
    draw.everything(Stream(np.random.default_rng(seed)))
    mix(draw, tests, balance, np.random.default_rng([seed, 1]))
    return draw.start


def share(test_is_true, tests, count=300, balance=0.3):
    return np.mean([test_is_true(drawn(seed, tests, balance)) for seed in range(count)])


def test_same_seed_same_start():
    one, other = drawn(5), drawn(5)
    assert np.array_equal(one.position, other.position, equal_nan=True)
    assert np.array_equal(one.states, other.states)


def test_things_lie_at_places_that_suit_them_and_none_on_another():
    for seed in range(30):
        start = drawn(seed)
        for place in np.unique(start.place[start.place != ABSENT]):
            rows = np.flatnonzero(start.place == place)
            for row in rows:
                at, weights = SETTING.prior.places(row)
                assert weights[at == place] > 0
                for other in rows[rows > row]:
                    gap = np.hypot(*(start.position[row] - start.position[other]))
                    assert gap >= SETTING.prior.radius[row] + SETTING.prior.radius[other] - 1e-9


def test_places_come_up_as_often_as_their_weights_say():
    rows, weights = SETTING.prior.places(ROW["milk"])
    expected = weights[rows == ROW["fridge"]].sum()
    assert share(lambda start: start.place[ROW["milk"]] == ROW["fridge"], ()) == pytest.approx(expected, abs=0.09)


def test_broken_devices_are_off_and_closed_fridges_cool():
    for seed in range(60):
        start = drawn(seed)
        assert (start.states[start.broken, POWER] != 1).all()
        inside = np.flatnonzero(start.place == ROW["fridge"])
        if start.states[ROW["fridge"], 1] == 0:
            assert (start.states[inside, TEMPERATURE] != 1).all()


def test_the_user_is_always_at_home_and_others_now_and_then():
    starts = [drawn(seed) for seed in range(40)]
    assert all(start.home[ROW["user"]] for start in starts)
    for name in ("anna", "guest", "relative"):
        assert {bool(start.home[ROW[name]]) for start in starts} == {True, False}


def test_people_stand_clear_of_furniture_and_each_other():
    for seed in range(30):
        start = drawn(seed)
        people = start.position[start.home]
        for index, (x, y) in enumerate(people):
            for x0, y0, x1, y1 in SETTING.geometry.blocks:
                assert np.hypot(max(x0 - x, 0, x - x1), max(y0 - y, 0, y - y1)) >= PERSON_RADIUS
            assert all(np.hypot(*(other - (x, y))) > 2 * PERSON_RADIUS for other in people[index + 1 :])


@pytest.mark.parametrize("balance", [0.3, 0.5])
def test_a_tested_state_holds_with_probability_within_the_balance(balance):
    test = StateTest(("fridge",), "aperture", "open")
    holds = share(lambda start: start.states[ROW["fridge"], 1] == 1, [test], balance=balance)
    assert holds == pytest.approx(balance, abs=0.08), "the prior is 0.08"


def test_no_balance_is_the_prior():
    test = StateTest(("fridge",), "aperture", "open")
    holds = share(lambda start: start.states[ROW["fridge"], 1] == 1, [test], balance=0.0)
    assert holds == pytest.approx(0.08, abs=0.05)


def test_the_robot_stands_where_it_can_get_everywhere_from():
    corner = (3.74, 5.67)
    tom_in_the_way = [(3.3, 5.966)]
    free, shut_in = (np.array(SETTING.spots.robot(0, people=people)) for people in ((), tom_in_the_way))
    assert np.hypot(*(free - corner).T).min() < 0.1
    assert np.hypot(*(shut_in - corner).T).min() > 0.4


def test_all_that_a_phrase_may_mean_agrees():
    windows = ("kitchen_window", "living_room_window", "bedroom_window")
    for seed in range(20):
        states = drawn(seed, [StateTest(windows, "aperture", "open")]).states
        assert len({int(states[ROW[window], 1]) for window in windows}) == 1


def test_a_chain_of_searches_ends_at_each_of_its_leaves():
    stages = (("kitchen_table",), ("desk_drawer",), ("box",))
    rows = [[ROW[place] for place in stage] for stage in stages]

    def leaf(start):
        at = {int(start.place[ROW[pen]]) for pen in ("pen_1", "pen_2")}
        return next((index for index, stage in enumerate(rows) if at & set(stage)), 3)

    leaves = [leaf(drawn(seed, [PlaceTest(("pen_1", "pen_2"), stages)])) for seed in range(400)]
    assert (np.bincount(leaves, minlength=4) / 400).min() >= 0.2 - 0.05


def test_presence_is_mixed():
    test = PlaceTest(("apple",), ((),))
    assert share(lambda start: start.place[ROW["apple"]] != ABSENT, [test]) == pytest.approx(0.7, abs=0.08)


DIRTY, EMPTY = ("cleanliness", "dirty"), ("fill", "empty")
MUGS, DISHES = ("mug_1", "mug_2"), ("plate_1", "plate_2")


def so_at(start, things, place, *where):
    """Those of the things at a place that are in all of these states, each the second of its pair."""
    columns = [STATE_PAIRS.index(pair) for pair, _ in where]
    there = [ROW[name] for name in things if start.place[ROW[name]] == ROW[place]]
    return [row for row in there if all(start.states[row, column] == 0 for column in columns)]


@pytest.mark.parametrize(
    ("things", "place", "where"),
    [
        (MUGS, "desk", (DIRTY,)),
        (DISHES, "sink", (DIRTY,)),
        (DISHES, "counter", (DIRTY,)),
        (MUGS, "bathroom_shelf", (DIRTY,)),
        (MUGS, "desk", (DIRTY, EMPTY)),
        (("bottle",), "fridge", (EMPTY,)),
    ],
    ids=str,
)
def test_a_thing_in_a_state_is_at_a_place_with_probability_within_the_balance(things, place, where):
    test = PlaceTest(things, ((place,),), where)
    held = share(lambda start: bool(so_at(start, things, place, *where)), [test])
    assert 0.3 - 0.08 <= held <= 0.7 + 0.08


def test_a_thing_in_a_state_is_in_the_house_with_probability_within_the_balance():
    def is_here(start):
        rows = [ROW[name] for name in MUGS if start.place[ROW[name]] != ABSENT]
        return any(start.states[row, STATE_PAIRS.index("cleanliness")] == 0 for row in rows)

    assert 0.3 - 0.08 <= share(is_here, [PlaceTest(MUGS, ((),), (DIRTY,))]) <= 0.7 + 0.08


def test_each_leaf_of_a_chain_is_reached_by_things_in_a_state():
    places = "desk", "sink"
    test = PlaceTest(MUGS, tuple((place,) for place in places), (DIRTY,))

    def leaf(start):
        return next((i for i, place in enumerate(places) if so_at(start, MUGS, place, DIRTY)), 2)

    leaves = [leaf(drawn(seed, [test])) for seed in range(400)]
    assert (np.bincount(leaves, minlength=3) / 400).min() >= 0.2 - 0.05


def test_what_is_said_to_be_there_is_there_more_often_than_it_is_so_and_agrees():
    test = PlaceTest(MUGS, (("desk",),), (DIRTY,), is_said_there=True)
    starts = [drawn(seed, [test]) for seed in range(300)]
    there, so = ([len(so_at(start, MUGS, "desk", *where)) for start in starts] for where in ((), (DIRTY,)))
    assert np.mean(np.array(so) > 0) == pytest.approx(0.3, abs=0.08)
    assert np.mean(np.array(there) > 0) == pytest.approx(0.65, abs=0.08)
    assert all(some in (0, all_of_them) for some, all_of_them in zip(so, there, strict=True))


def test_a_state_that_an_earlier_test_has_settled_stays():
    tests = [StateTest(MUGS, *DIRTY), PlaceTest(MUGS, (("desk",),), (DIRTY,))]
    for seed in range(40):
        first, both = drawn(seed, tests[:1]), drawn(seed, tests)
        assert np.array_equal(first.states, both.states)
        assert any("cleanliness is settled" in line for line in both.exempt)


def test_people_and_devices_are_mixed():
    assert share(lambda start: start.home[ROW["anna"]], [PersonTest(("anna",))]) == pytest.approx(0.7, abs=0.08)
    assert share(lambda start: start.broken[ROW["tv"]], [WorksTest(("tv",))]) == pytest.approx(0.3, abs=0.08)


ON, WORKS = StateTest(("coffee_machine",), "power", "on"), WorksTest(("coffee_machine",))


@pytest.mark.parametrize("balance", [0.3, 0.5])
@pytest.mark.parametrize(
    "tests", [(ON, WORKS), (WORKS, ON), (WORKS, StateTest(("coffee_machine",), "power", "off"))], ids=str
)
def test_whether_a_device_is_on_and_whether_it_works_are_both_mixed(tests, balance):
    starts = [drawn(seed, tests, balance) for seed in range(600)]
    on = np.array([start.states[ROW["coffee_machine"], POWER] == 1 for start in starts])
    broken = np.array([start.broken[ROW["coffee_machine"]] for start in starts])
    assert balance - 0.05 <= on.mean() <= 1 - balance + 0.05
    assert balance - 0.05 <= broken.mean() <= 1 - balance + 0.05
    assert not (on & broken).any(), "what is broken is off"
    assert not any(start.exempt for start in starts)


@pytest.mark.parametrize("tests", [(ON, WORKS), (WORKS, ON)], ids=["on first", "works first"])
def test_of_a_device_what_an_earlier_test_has_settled_stays(tests):
    for seed in range(60):
        first, both = (drawn(seed, some, 0.5) for some in (tests[:1], tests))
        if tests[0] is ON:
            assert np.array_equal(first.states, both.states)
        else:
            assert np.array_equal(first.broken, both.broken)


def test_where_no_draw_leaves_enough_worlds_in_which_all_are_broken_it_says_so():
    each = [StateTest((name,), "power", "on") for name in ("tv", "radio", "fan")]
    tests = [*each, WorksTest(("tv", "radio", "fan"))]
    starts = [drawn(seed, tests, 0.5) for seed in range(60)]
    assert all("broken in 12% at most" in start.exempt[0] for start in starts)
    assert 0 < sum(bool(start.broken[ROW["tv"]]) for start in starts) < 20


def room_of(start, person):
    row, geometry = ROW[person], SETTING.geometry
    return geometry.rooms[geometry.room_at(*start.position[row])] if start.home[row] else None


@pytest.mark.parametrize("who", ["tom", "relative", "user"])
def test_who_is_said_to_be_somewhere_is_there(who):
    assert {room_of(drawn(seed, [Whereabouts((who,), ("study",))]), who) for seed in range(40)} == {"study"}
    assert len({room_of(drawn(seed, [Whereabouts((who,), ("study",))], balance=0), who) for seed in range(40)}) > 1


def test_of_several_who_may_be_there_one_is():
    for seed in range(20):
        plain, start = drawn(seed), drawn(seed, [Whereabouts(("anna", "tom"), ("bathroom",))])
        assert "bathroom" in [room_of(start, who) for who in ("anna", "tom")]
        assert "bathroom" not in [room_of(plain, who) for who in ("anna", "tom")]
        assert sum(room_of(start, who) != room_of(plain, who) for who in ("anna", "tom")) == 1


def test_who_is_out_for_an_earlier_test_stays_out():
    tests = [PersonTest(("tom",)), Whereabouts(("tom",), ("study",))]
    rooms = [room_of(drawn(seed, tests), "tom") for seed in range(100)]
    assert set(rooms) == {None, "study"}
    assert rooms.count(None) == pytest.approx(30, abs=12)


def test_what_is_not_mentioned_is_drawn_as_without_an_instruction():
    tests = [PlaceTest(("pen_1",), (("kitchen_table",),)), StateTest(("tv",), "power", "on"), PersonTest(("anna",))]
    for seed in range(25):
        plain, mixed = drawn(seed), drawn(seed, tests)
        others = [row for name, row in ROW.items() if name not in ("pen_1", "tv", "anna")]
        assert np.array_equal(plain.position[others], mixed.position[others], equal_nan=True)
        assert np.array_equal(plain.states[others], mixed.states[others])
        assert np.array_equal(plain.broken[others], mixed.broken[others])


def test_what_cannot_be_mixed_is_listed():
    exempt = drawn(0, [PersonTest(("user",)), PlaceTest(("pen_1",), (("tv",),))]).exempt
    assert any("user" in line for line in exempt)
    assert any("tv" in line for line in exempt)


@pytest.mark.parametrize(
    ("shares", "least", "expected"),
    [((1.0, 0.0), 0.3, (0.7, 0.3)), ((0.9, 0.05, 0.05), 0.2, (0.6, 0.2, 0.2)), ((1, 0, 0, 0, 0, 0), 0.2, (1 / 6,) * 6)],
)
def test_at_least_lifts_the_small_shares(shares, least, expected):
    assert at_least(np.array(shares, dtype=float), least) == pytest.approx(expected)


def test_a_balance_that_is_no_probability_is_refused():
    with pytest.raises(InputError, match=r"0\.9"):
        drawn(0, (), balance=0.9)
