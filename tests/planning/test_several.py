"""Any of several: an order behind a check means all that are so; all from a place are those that were there."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.ground_task import GroundTask
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain()
OPEN, DIRTY = (("aperture", "open"),), (("cleanliness", "dirty"),)
THEN = [{"if": 1, "then": [2]}]


def tasks(text: str, flow: list) -> tuple[GroundTask, ...]:
    return ground(read_markup(text, DOMAIN.ontology, flow=flow), DOMAIN).tasks


@pytest.mark.parametrize("words", ["any windows", "any of the windows", "some windows"])
def test_what_was_asked_of_any_of_several_is_done_to_all_that_are_so(words: str) -> None:
    check, order = tasks(
        f"If [{words}](1:object) [are](1:check_state) [open](1:state), [shut](2:change_state) [all](2:object={words}).",
        THEN,
    )
    assert check.objects[0].is_any
    assert not check.objects[0].is_all
    assert (order.objects[0].is_all, order.objects[0].where) == (True, OPEN)
    assert order.may_be_none(order.objects[0])


@pytest.mark.parametrize(("words", "count"), [("one of the windows", 1), ("two windows", 2), ("a window", 1)])
def test_of_a_certain_number_no_more_is_meant(words: str, count: int) -> None:
    order = tasks(
        f"If [{words}](1:object) [is](1:check_state) [open](1:state), [close](2:change_state) [it](2:object={words}).",
        THEN,
    )[1]
    assert (order.objects[0].is_all, order.objects[0].count) == (False, count)


def test_where_they_were_asked_for_they_are_looked_for() -> None:
    order = tasks(
        "If [any plates](1:object) [in the sink](1:location) [are](1:check_state) [dirty](1:state), "
        "[wash](2:change_state) [them](2:object=any plates).",
        THEN,
    )[1]
    assert order.objects[0].where == DIRTY
    assert [place.candidates for place in order.places] == [("sink",)]


def test_any_is_all_there_are_where_nothing_was_asked_and_some_is_not() -> None:
    every = tasks("[Wash](1:change_state) [any dirty plates](1:object).", [1])[0].objects[0]
    assert (every.is_all, every.where) == (True, DIRTY)
    for words in ("some plates", "any of the plates", "any plate"):
        some = tasks(f"[Wash](1:change_state) [{words}](1:object).", [1])[0].objects[0]
        assert not some.is_all


@pytest.mark.parametrize(("words", "is_any"), [("any that are open", True), ("them if they are open", False)])
def test_a_check_of_several_asks_after_any_that_are_so(words: str, is_any: bool) -> None:
    said, _, rest = words.partition(" ")
    text = (
        "[Check](1:check_state) [the windows](1:object) and [close](2:change_state) "
        f"[{said}](2:object=the windows) {rest.replace('open', '[open](1:state)')}."
    )
    assert tasks(text, THEN)[0].objects[0].is_any == is_any


@pytest.mark.parametrize(("said", "count"), [("both of them", 2), ("them", 2), ("it", 1), ("one of them", 1)])
def test_both_of_two_that_an_or_joins_are_each_of_them(said: str, count: int) -> None:
    order = tasks(
        "If [the tv or the radio](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) "
        f"[{said}](2:object=the tv or the radio) [off](2:state).",
        THEN,
    )[1]
    assert len(order.objects) == count


@pytest.mark.parametrize("word", ["nothing", "anything"])
def test_a_check_of_what_is_at_a_place_asks_after_anything(word: str) -> None:
    check = tasks(
        f"If there [is](1:check_state) {word} [in the box](1:location), [shut](2:change_state) [the window](2:object).",
        THEN,
    )[0]
    assert check.objects[0].is_any
    assert len(check.objects[0].candidates) == len(DOMAIN.house.things)


@pytest.mark.parametrize(
    ("words", "said"), [("everything", "it"), ("whatever is", "it"), ("all the mugs", "them"), ("the mugs", "them")]
)
def test_all_that_is_taken_from_a_place_is_meant_of_there_later(words: str, said: str) -> None:
    take, put = tasks(
        f"[Take](1:taking) [{words}](1:object) [off the desk](1:source) and [put](2:placing) "
        f"[{said}](2:object={words}) [in the box](2:goal).",
        [1, 2],
    )
    assert take.objects == put.objects
    assert [place.candidates for place in (*take.places, *put.places)] == [("desk",)] * 2


def test_one_that_is_taken_from_a_place_may_be_elsewhere_later() -> None:
    put = tasks(
        "[Take](1:taking) [a mug](1:object) [off the desk](1:source) and [put](2:placing) [it](2:object=a mug) "
        "[in the box](2:goal).",
        [1, 2],
    )[1]
    assert not put.places


def test_everything_behind_a_check_of_anything_is_what_is_there() -> None:
    text = "If there ['s](1:check_state) [anything](1:object) [on the desk](1:location), [take](2:taking) "
    take = tasks(text + "[everything](2:object).", THEN)[1]
    assert [place.candidates for place in take.places] == [("desk",)]
    told = tasks(text + "[everything](2:object) [off the couch](2:source).", THEN)[1]
    assert [place.candidates for place in told.places] == [("couch",)]


@pytest.mark.parametrize(
    ("words", "count"),
    [("the soup with a spoon", 2), ("my coffee with two mugs", 2), ("the mug with the spoon", 1)],
)
def test_what_is_brought_along_is_brought_too(words: str, count: int) -> None:
    (task,) = tasks(f"[Bring](1:bringing) [me](1:recipient) [{words}](1:object)", [1])
    assert len(task.objects) == count
