"""Places that a clause tells by who or what is there."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import ImpossibleGoalError
from decomplex_bt.planning.ground_task import GroundTask
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain()


def first(text: str, count: int = 1) -> GroundTask:
    return ground(read_markup(text, DOMAIN.ontology, flow=list(range(1, count + 1))), DOMAIN).tasks[0]


@pytest.mark.parametrize(
    ("where", "goal"),
    [
        ("[to the room](1:goal) where Tom is", ("tom",)),
        ("[to the room](1:goal) Anna is in", ("anna",)),
        ("[to the room](1:goal) in which the guest is sleeping", ("guest",)),
        ("[to the room where the phone is](1:goal)", ("phone",)),
        ("[wherever Tom is](1:goal)", ("tom",)),
        ("[to the room](1:goal) where I'm sitting", ("user",)),
        ("[where I am](1:goal)", ("user",)),
        ("[to the room](1:goal) where the tv is", ("living_room",)),
        ("[to the room](1:goal) that has the laundry basket", ("bathroom",)),
        ("[to the room](1:goal) [with the bed](1:manner)", ("bedroom",)),
    ],
)
def test_a_room_is_told_by_what_is_in_it_and_people_are_gone_to(where: str, goal: tuple[str, ...]) -> None:
    task = first(f"[Go](1:motion) {where}.")
    assert task.goal is not None
    assert task.goal.candidates == goal


def test_a_lamp_is_of_the_room_that_the_map_tells() -> None:
    task = first("[Turn](1:change_state) [on](1:state) [the lamp](1:object) [in the room](1:location) where the bed is")
    assert [referent.candidates for referent in task.objects] == [("bedroom_lamp",)]


@pytest.mark.parametrize(
    ("text", "people", "where"),
    [
        ("[Bring](1:bringing) [the book](1:object) [to Tom in the study](1:recipient)", ("tom",), ("study",)),
        ("[Bring](1:bringing) [the book](1:object) [to me in the study](1:recipient)", ("user",), ("study",)),
        ("[Bring](1:bringing) [the book](1:object) [to Anna on the couch](1:goal)", ("anna",), ("couch",)),
        ("[Bring](1:bringing) [us](1:recipient) [the soup](1:object) [to the study](1:goal)", ("user",), ("study",)),
        ("[Tell](1:informing) [my mother in the kitchen](1:recipient) [hello](1:message)", ("relative",), ("kitchen",)),
        ("[Go](1:motion) [to Tom in the kitchen](1:goal)", ("tom",), ("kitchen",)),
        ("[Follow](1:following) [Anna in the hallway](1:object) [to the kitchen](1:goal)", ("anna",), ("hallway",)),
    ],
)
def test_where_somebody_is_said_to_be(text: str, people: tuple[str, ...], where: tuple[str, ...]) -> None:
    ((who, place),) = first(text).whereabouts
    assert (who.candidates, place.candidates) == (people, where)


@pytest.mark.parametrize(
    "text",
    [
        "[Bring](1:bringing) [Tom](1:recipient) [the book](1:object) [in the study](1:source)",
        "[Bring](1:bringing) [Tom](1:recipient) [the book in the study](1:object)",
        "[Bring](1:bringing) [Tom](1:recipient) [the book](1:object) [on the desk](1:goal)",
        "[Tell](1:informing) [everybody in the kitchen](1:recipient) [hello](1:message)",
        "[Tell](1:informing) [Tom next to the laptop](1:recipient) [hello](1:message)",
        "[Tell](1:informing) [Tom](1:recipient) [that the book is in the study](1:message)",
        "[Go](1:motion) [to the lamp in the bedroom](1:goal)",
    ],
)
def test_what_is_said_of_no_person_in_particular_is_not_where_one_is(text: str) -> None:
    assert first(text).whereabouts == ()


@pytest.mark.parametrize(
    "text",
    [
        "[Turn](1:change_state) [on](1:state) [the light](1:object) [in the room](1:location) where Anna is.",
        "[Turn](1:change_state) [on](1:state) [the light](1:object) where Anna is.",
        "[Bring](1:bringing) [the book](1:object) [to the room](1:goal) Tom is in.",
        "[Put](1:placing) [the pen](1:object) [on the table where the laptop is](1:goal)",
        "[Fetch](1:bringing) [the pen](1:object) [from the table](1:source) where the laptop is",
        "[Go](1:motion) [to the room](1:goal) where you left the book",
        "[Go](1:motion) [to the room](1:goal) that has the piano",
    ],
)
def test_what_nobody_can_know_beforehand_is_refused(text: str) -> None:
    with pytest.raises(ImpossibleGoalError, match="cannot be known beforehand; say it by name"):
        first(text)


def test_a_thing_goes_to_who_is_somewhere_or_next_to_what_is() -> None:
    take = first("[Take](1:bringing) [the cup](1:object) [to where Anna is](1:goal)")
    assert [person.candidates for person in take.recipients] == [("anna",)]
    put = first("[Put](1:placing) [the book](1:object) [where the laptop is](1:goal)")
    assert put.goal is not None
    assert put.goal.candidates == ("laptop",)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("[Go](1:motion) [to the kitchen](1:goal), where Tom is", 1),  # of one place alone it tells nothing
        ("[Go](1:motion) [to the kitchen](1:goal) where it is warm", 1),
        ("[Go](1:motion) [to the room](1:goal) and [see](2:check_state) if [Anna](2:object) is [in](2:state)", 2),
        ("[Go](1:motion) [to the room](1:goal) with the cup", 1),
    ],
)
def test_what_tells_no_place_from_another_changes_nothing(text: str, count: int) -> None:
    bare = first(text.split("(1:goal)")[0] + "(1:goal)")
    assert first(text, count).goal == bare.goal
    first("[Tell](1:informing) [Anna](1:recipient) [where the keys are](1:message)")


@pytest.mark.parametrize(
    ("order", "meant"),
    [
        ("[Turn](1:change_state) [off](1:state) [the tv and the light](1:object) [in the bedroom](1:location).", "tv"),
        (
            "[Close](1:change_state) [the front door and the window](1:object) [in the bedroom](1:location).",
            "front_door",
        ),
        ("[Close](1:change_state) [the curtains and the window](1:object) [in the bedroom](1:location).", "bedroom_"),
    ],
)
def test_a_place_is_of_what_can_be_there(order: str, meant: str) -> None:
    one, other = first(order).objects
    assert all(name.startswith(meant) for name in one.candidates)
    assert all(name.startswith("bedroom_") for name in other.candidates)


def test_the_last_of_several_has_to_be_there() -> None:
    with pytest.raises(ImpossibleGoalError, match="the tv"):
        first("[Turn](1:change_state) [off](1:state) [the light and the tv](1:object) [in the bedroom](1:location).")
