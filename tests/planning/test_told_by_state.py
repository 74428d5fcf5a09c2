"""Phrases told by a state: which states tell anything, and when it matters that nothing is so."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.planning.ground_task import GroundTask
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain()
DIRTY, HOT = (("cleanliness", "dirty"),), (("temperature", "hot"),)
CLOTHES = {"shirt", "jacket", "socks"}


def tasks(text: str, count: int = 1) -> tuple[GroundTask, ...]:
    return ground(read_markup(text, DOMAIN.ontology, flow=list(range(1, count + 1))), DOMAIN).tasks


def bring(phrase: str) -> GroundTask:
    return tasks(f"[Bring](1:bringing) [me](1:recipient) [{phrase}](1:object)")[0]


@pytest.mark.parametrize("phrase", ["a clean pen", "the warm blanket", "my running shoes", "a fresh cup of tea"])
def test_a_state_that_nothing_named_can_be_in_tells_nothing(phrase: str) -> None:
    assert bring(phrase).objects[0].where == ()


def test_what_cannot_be_in_a_state_is_not_meant_by_it() -> None:
    assert bring("a full bottle of water").objects[0].candidates == ("bottle",)
    assert set(bring("a bottle of water").objects[0].candidates) == {"bottle", "water"}
    assert {"pen_1", "cup_1"} <= set(bring("a clean cup or a pen").objects[0].candidates)


def test_the_only_one_of_its_kind_is_told_by_its_state_too() -> None:
    assert bring("the hot soup").objects[0].where == HOT
    assert bring("the soup").objects[0].where == ()
    goal = tasks("[Put](1:placing) [the soup](1:object) [in the open fridge](1:goal)")[0].goal
    assert goal is not None
    assert goal.where == ()


def test_a_state_that_is_to_be_changed_or_asked_of_the_only_one_is_no_matter() -> None:
    text = "[Wash](1:change_state) [the dirty shirt](1:object) and [put](2:placing) [it](2:object=the dirty shirt) "
    wash, put = tasks(text + "[on the bed](2:goal)", 2)
    assert wash.objects == put.objects
    assert wash.objects[0].where == ()
    check = tasks("[Is](1:check_state) [the dirty shirt](1:object) [clean](1:state)?")[0]
    assert check.objects[0].where == ()
    assert tasks("[Fill](1:change_state) [the dirty bowl](1:object)")[0].objects[0].where == DIRTY


def test_of_all_that_are_so_there_may_be_none_where_something_is_done_with_them() -> None:
    def may_be_none(text: str) -> bool:
        task = tasks(text)[0]
        return task.may_be_none(task.objects[0])

    assert may_be_none("[Close](1:change_state) [all the open windows](1:object)")
    assert may_be_none("[Bring](1:bringing) [me](1:recipient) [the dirty towels](1:object)")
    assert not may_be_none("[Close](1:change_state) [all the windows](1:object)")
    assert not may_be_none("[Close](1:change_state) [the open window](1:object)")
    assert not may_be_none("[Find](1:searching) [the dirty plates](1:object)")


@pytest.mark.parametrize("phrase", ["the clothes", "my clothes", "all the clothing"])
def test_clothes_are_what_is_worn_and_no_cloths(phrase: str) -> None:
    clothes = bring(phrase).objects[0]
    assert (set(clothes.candidates), clothes.is_all) == (CLOTHES, True)
    assert bring("the cloth").objects[0].candidates == ("rag",)


def test_a_piece_of_them_is_one() -> None:
    piece = bring("a piece of clothing").objects[0]
    assert (set(piece.candidates), piece.is_all, piece.count) == (CLOTHES, False, 1)
