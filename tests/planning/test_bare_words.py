"""Words without a noun of their own ("the blue one", "anything") or with one for several ("the kitchen and bedroom
windows")."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.planning.ground_task import HERE, GroundInstruction
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain()
THINGS = tuple(DOMAIN.house.things)
IF_THERE = "If [there](1:location=on the couch) [is](1:check_state) [{}](1:object), "


def grounded(text: str, count: int = 1) -> GroundInstruction:
    return ground(read_markup(text, DOMAIN.ontology, flow=list(range(1, count + 1))), DOMAIN)


def objects(phrase: str) -> list[tuple[str, ...]]:
    return [r.candidates for r in grounded(f"[Take](1:taking) [{phrase}](1:object)").tasks[0].objects]


@pytest.mark.parametrize(
    ("phrase", "meant"),
    [
        ("the white plate and the blue one", [("plate_1",), ("plate_2",)]),
        ("the red mug or the green one", [("mug_1", "mug_2")]),
        ("the red pen, the white cup and the blue one", [("pen_2",), ("cup_1",), ("cup_2",)]),
        ("the green mugs and the red one", [("mug_2",), ("mug_1",)]),
        ("the red pen and the other one", [("pen_2",), ("pen_1",)]),
        ("one of the mugs", [("mug_1", "mug_2")]),
    ],
)
def test_one_stands_for_the_noun_before_it(phrase: str, meant: list[tuple[str, ...]]) -> None:
    assert objects(phrase) == meant


def test_one_of_a_colour_that_there_is_not_is_refused_by_its_noun() -> None:
    with pytest.raises(UnknownWordError, match="'the green towel'"):
        objects("the towel and the green one")


def test_the_one_there_is_another_with_and_and_the_same_with_or() -> None:
    start = "[Bring](1:bringing) [me](1:recipient) [the {0}](1:object) [from the desk](1:source) "
    text = start + "{1} [the one](1:object) [on the bed](1:source)"
    pen, other = grounded(text.format("pen", "and")).tasks
    assert other.objects[0].others == pen.objects
    with pytest.raises(ImpossibleGoalError, match="only one"):
        grounded(text.format("blanket", "and"))
    (blanket,) = grounded(text.format("blanket", "or")).tasks
    assert [place.candidates for place in blanket.places] == [("desk", "bed")]
    window = "[Close](1:change_state) [the window](1:object) [in the kitchen](1:location) and [the one](1:object) "
    one, two = grounded(window + "[in the bedroom](1:location)").tasks
    assert (one.objects[0].candidates, two.objects[0].candidates) == (("kitchen_window",), ("bedroom_window",))


@pytest.mark.parametrize("word", ["anything", "something", "nothing"])
def test_any_thing_at_a_place_is_asked_for_and_it_is_what_was_found(word: str) -> None:
    text = IF_THERE.format(word) + f"[bring](2:bringing) [it](2:object={word}) [to me](2:recipient)."
    check, bring = grounded(text, 2).tasks
    assert (check.state, check.objects[0].candidates, check.objects[0].is_any) == (HERE, THINGS, True)
    assert bring.objects == check.objects
    assert not bring.is_only_there


def test_anything_dirty_is_what_can_be() -> None:
    text = IF_THERE.format("anything dirty") + "[wash](2:change_state) [it](2:object=anything dirty)."
    check, wash = grounded(text, 2).tasks
    assert check.objects == wash.objects
    assert "pen_1" not in check.objects[0].candidates
    assert {"plate_1", "rag"} <= set(check.objects[0].candidates)
    with pytest.raises(ImpossibleGoalError, match="may be what cannot be clean"):
        grounded(IF_THERE.format("something") + "[wash](2:change_state) [it](2:object=something).", 2)


def test_something_from_a_place_is_from_there_alone() -> None:
    task = grounded("[Bring](1:bringing) [me](1:recipient) [something](1:object) [from the fridge](1:source)").tasks[0]
    assert (task.is_only_there, task.places[0].candidates) == (True, ("fridge",))


@pytest.mark.parametrize(
    "text",
    [
        "[Bring](1:bringing) [me](1:recipient) [something](1:object)",
        "[Take](1:taking) [nothing](1:object) [from the fridge](1:source)",
        "[Take](1:taking) [anything](1:object) [from the fridge](1:source)",
        "[Is](1:check_state) [anything](1:object) [on](1:state)?",
        "[Take](1:taking) [something red](1:object) [from the desk](1:source)",
    ],
)
def test_what_leaves_open_what_is_meant_is_refused(text: str) -> None:
    with pytest.raises(UnknownWordError, match="thing"):
        grounded(text)


@pytest.mark.parametrize(
    ("phrase", "meant"),
    [
        ("the kitchen and bedroom windows", [("kitchen_window",), ("bedroom_window",)]),
        ("the kitchen and the bedroom window", [("kitchen_window",), ("bedroom_window",)]),
    ],
)
def test_a_noun_behind_a_second_room_is_that_of_the_first_too(phrase: str, meant: list[tuple[str, ...]]) -> None:
    task = grounded(f"[Close](1:change_state) [{phrase}](1:object)").tasks[0]
    assert [referent.candidates for referent in task.objects] == meant


def test_a_room_beside_a_thing_is_no_part_of_its_name() -> None:
    with pytest.raises(ImpossibleGoalError, match="'the kitchen' cannot be closed"):
        grounded("[Close](1:change_state) [the kitchen and the window](1:object)")


@pytest.mark.parametrize(
    ("where", "meant"),
    [
        ("in the kitchen and in the bedroom", [("kitchen_window",), ("bedroom_window",)]),
        ("in the kitchen and the bedroom", [("kitchen_window",), ("bedroom_window",)]),
        ("in the kitchen or in the bedroom", [("kitchen_window", "bedroom_window")]),
        ("in the bedroom", [("bedroom_window",)]),
    ],
)
def test_in_two_rooms_there_is_one_each(where: str, meant: list[tuple[str, ...]]) -> None:
    task = grounded(f"[Close](1:change_state) [the window](1:object) [{where}](1:location)").tasks[0]
    assert [sorted(referent.candidates) for referent in task.objects] == [sorted(names) for names in meant]


@pytest.mark.parametrize("words", ["everybody", "everybody in the house", "everyone at home", "everybody else"])
def test_everybody_may_be_said_to_be_in_the_house(words: str) -> None:
    (task,) = grounded(f"[Tell](1:informing) [{words}](1:recipient) [that it is late](1:message)").tasks
    (people,) = task.recipients
    assert (people.is_all, set(people.candidates)) == (True, set(DOMAIN.house.people) - {DOMAIN.house.user})


@pytest.mark.parametrize(
    ("words", "places"),
    [
        ("everybody in the kitchen", [("kitchen",)]),
        ("everyone at the kitchen table", [("kitchen_table",)]),
        ("Anna in the kitchen", []),
        ("everybody at home", []),
    ],
)
def test_everybody_may_be_said_to_be_somewhere(words: str, places: list[tuple[str, ...]]) -> None:
    (task,) = grounded(f"[Tell](1:informing) [{words}](1:recipient) [that it is late](1:message)").tasks
    assert [place.candidates for place in task.places] == places


@pytest.mark.parametrize("words", ["everybody with Anna", "everyone near the laptop"])
def test_who_is_with_somebody_is_refused(words: str) -> None:
    with pytest.raises(ImpossibleGoalError, match="say a room"):
        grounded(f"[Tell](1:informing) [{words}](1:recipient) [that it is late](1:message)")


def test_everybody_else_is_all_but_those_named_before() -> None:
    text = "[Tell](1:informing) [Anna](1:recipient) [hello](1:message), "
    text += "[tell](2:informing) [{}](2:recipient) [bye](2:message)"
    for words in ("everyone else", "somebody else"):
        assert "anna" not in grounded(text.format(words), 2).tasks[1].recipients[0].candidates
    assert "anna" in grounded(text.format("everyone"), 2).tasks[1].recipients[0].candidates


@pytest.mark.parametrize(("phrase", "all_meant"), [("cups", False), ("the cups", True), ("all cups", True)])
def test_of_a_bare_plural_that_is_sought_any_will_do(phrase: str, all_meant: bool) -> None:
    text = f"[Look](1:searching) [on the counter](1:location) for [{phrase}](1:object)"
    (sought,) = grounded(text).tasks[0].objects
    assert (sought.is_all, sought.is_any) == (all_meant, not all_meant)
    (handled,) = grounded(f"[Wash](1:change_state) [{phrase}](1:object)").tasks[0].objects
    assert handled.is_all
