"""What English settles about a task is settled, and what it leaves open is left to the models."""

from __future__ import annotations

import pytest
from documents import document

from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.facts import corrected
from decomplex_bt.understanding.tasks import FoundTask

GAZETTEER = Gazetteer({}, {}, frozenset(), ending={"throw away": "placing", "get rid": "placing", "discard": "placing"})
TYPES = ("check_state", "change_state", "placing", "bringing")


def found(words: str, *tasks: tuple[int, str], types: tuple[str, ...] = TYPES) -> list[tuple[int, str]]:
    """The places and types of tasks after correction; the words as `documents.document` takes them, their tags only."""
    said = [f"{word}/dep/{i}" if "/" in word else word for i, word in enumerate(words.split())]
    corrections = corrected(Observed(document(*said), GAZETTEER), [FoundTask(i, kind, 0.9) for i, kind in tasks], types)
    return [(task.token, task.type) for task in corrections]


@pytest.mark.parametrize(
    "words",
    [
        "make/VB sure/JJ the/DT door/NN is/VBZ locked/VBN .",
        "ensure/VB it/PRP 's/VBZ off/RP and/CC go/VB",
        "be/VB certain/JJ both/DT windows/NNS are/VBP properly/RB shut/JJ",
        "see/VB to/IN it/PRP that/IN the/DT heating/NN is/VBZ on/RP",
        "make/VB sure/JJ it/PRP is/VBZ off/RP ,/, and/CC if/IN the/DT fan/NN is/VBZ on/RP ,/, go/VB",
    ],
)
def test_what_somebody_makes_sure_of_is_brought_about(words: str) -> None:
    assert found(words, (0, "check_state"))[0] == (0, "change_state")


@pytest.mark.parametrize(
    "words",
    [
        "make/VB sure/JJ the/DT door/NN is/VBZ locked/VBN ./. if/IN it/PRP is/VBZ n't/RB ,/, lock/VB it/PRP",
        "make/VB sure/JJ the/DT keys/NNS are/VBP on/IN the/DT hook/NN",
        "make/VB sure/JJ mum/NN is/VBZ asleep/JJ",
        "make/VB sure/JJ mum/NN is/VBZ in/IN the/DT garden/NN",
        "make/VB sure/JJ ./. is/VBZ it/PRP locked/VBN",
        "make/VB sure/JJ there/EX is/VBZ clean/JJ water/NN",
        "make/VB sure/JJ nobody/NN is/VBZ locked/VBN in/RP",
        "check/VB that/IN the/DT door/NN is/VBZ locked/VBN",
        "make/VB sure/JJ",
    ],
)
def test_what_is_asked_or_cannot_be_brought_about_stays_a_check(words: str) -> None:
    assert found(words, (0, "check_state")) == [(0, "check_state")]


def test_a_second_state_is_made_sure_of_like_the_first() -> None:
    sure = "make/VB sure/JJ the/DT door/NN is/VBZ shut/JJ"
    tasks = (0, "check_state"), (9, "check_state")
    assert found(f"{sure} and/CC the/DT fan/NN is/VBZ off/RP", *tasks) == [(0, "change_state"), (9, "change_state")]
    assert found(f"{sure} when/WRB the/DT fan/NN is/VBZ off/RP", *tasks) == [(0, "change_state"), (9, "check_state")]
    assert found(f"{sure} and/CC the/DT cat/NN is/VBZ asleep/JJ", *tasks) == [(0, "change_state"), (9, "check_state")]


def test_a_domain_without_the_type_keeps_its_own() -> None:
    locked = "make/VB sure/JJ the/DT door/NN is/VBZ locked/VBN"
    assert found(locked, (0, "check_state"), types=("check_state",)) == [(0, "check_state")]


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("put/VB on/RP the/DT radio/NN", "change_state"),
        ("put/VB out/RP the/DT candle/NN", "change_state"),
        ("put/VB out/RP six/CD plates/NNS", "placing"),
        ("put/VB on/IN the/DT shelf/NN the/DT cup/NN", "placing"),
        ("lay/VB the/DT kitchen/NN table/NN for/IN two/CD", "change_state"),
        ("set/VB the/DT cup/NN on/IN the/DT table/NN", "placing"),
        ("put/VB out/RP the/DT plates/NNS on/IN the/DT table/NN", "placing"),
        ("move/VB the/DT table/NN", "placing"),
        ("set/VB", "placing"),
    ],
)
def test_to_put_on_is_to_switch_and_a_table_that_is_laid_goes_nowhere(words: str, kind: str) -> None:
    assert found(words, (0, "placing")) == [(0, kind)]


def test_putting_without_a_particle_is_placing() -> None:
    assert found("put/VB the/DT cup/NN", (0, "change_state")) == [(0, "placing")]
    assert found("put/VB the/DT lamp/NN on/RP", (0, "change_state")) == [(0, "change_state")]
    assert found("put/VB the/DT cup/NN and/CC go/VB on/RP", (0, "change_state"), (4, "bringing"))[0] == (0, "placing")


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("throw/VB the/DT old/JJ paper/NN away/RP", "placing"),
        ("get/VB rid/JJ of/IN it/PRP", "placing"),
        ("discard/VB it/PRP", "placing"),
        ("throw/VB it/PRP to/IN me/PRP", "bringing"),
        ("get/VB it/PRP", "bringing"),
    ],
)
def test_a_verb_that_says_where_it_puts_a_thing_places_it(words: str, kind: str) -> None:
    assert found(words, (0, "bringing")) == [(0, kind)]


@pytest.mark.parametrize(
    ("words", "at", "told_by"),
    [
        ("if/IN the/DT kettle/NN 's/POS just/RB boiled/VBN", 3, 5),
        ("if/IN he/PRP 's/VBZ got/VBN it/PRP", 2, 3),
        ("if/IN it/PRP 's/VBZ gone/VBN cold/JJ", 2, 3),
        ("if/IN it/PRP 's/VBZ gone/VBN ,/, tell/VB me/PRP", 3, 2),
        ("if/IN it/PRP 's/VBZ gone/VBN too/RB", 2, 2),
        ("if/IN it/PRP 's/VBZ locked/VBN", 2, 2),
        ("if/IN it/PRP is/VBZ gone/VBN cold/JJ", 2, 2),
        ("if/IN it/PRP 's/VBZ", 2, 2),
        ("if/IN they/PRP 've/VBP flowered/VBN", 2, 3),
        ("if/IN they/PRP have/VBP not/RB yet/RB eaten/VBN", 2, 5),
        ("if/IN they/PRP have/VBP two/CD", 2, 2),
        ("if/IN it/PRP has/VBZ been/VBN washed/VBN", 3, 4),
        ("if/IN it/PRP has/VBZ been/VBN washed/VBN", 2, 4),
        ("if/IN he/PRP has/VBZ been/VBN ill/JJ", 3, 3),
        ("unless/IN somebody/NN 's/VBZ already/RB cut/VBN the/DT cake/NN ,/, sit/VB", 2, 4),
        ("if/IN Ann/NNP 's/VBZ put/VBN it/PRP away/RB ,/, sit/VB", 2, 3),
        ("if/IN she/PRP 's/VBZ called/VBN the/DT boss/NN", 2, 2),
        ("if/IN he/PRP 's/VBZ dressed/VBN i/PRP mean/VBP", 2, 2),
    ],
)
def test_a_perfect_is_told_by_its_participle(words: str, at: int, told_by: int) -> None:
    assert found(words, (at, "check_state")) == [(told_by, "check_state")]


def test_what_has_been_done_is_one_check() -> None:
    words = "if/IN it/PRP has/VBZ been/VBN put/VBN away/RB"
    assert found(words, (3, "check_state"), (4, "placing")) == [(4, "check_state")]


def test_a_place_that_another_task_has_is_left_to_it() -> None:
    words = "if/IN he/PRP 's/VBZ got/VBN it/PRP"
    assert found(words, (2, "check_state"), (3, "bringing")) == [(2, "check_state"), (3, "bringing")]


def test_what_somebody_has_done_to_something_is_one_check() -> None:
    words = "if/IN Ann/NNP 's/VBZ shut/VBN the/DT gate/NN ,/, go/VB"
    assert found(words, (2, "check_state"), (3, "change_state")) == [(3, "check_state")]


def test_what_a_check_asks_of_a_participle_is_no_task_of_its_own() -> None:
    words = "check/VB that/IN the/DT heater/NN 's/VBZ switched/VBN on/RP"
    assert found(words, (0, "check_state"), (5, "change_state")) == [(0, "check_state")]
    assert found("see/VB if/IN they/PRP have/VBP been/VBN switched/VBD off/RP", (0, "check_state"), (5, "placing")) == [
        (0, "check_state")
    ]
    told = "check/VB the/DT heater/NN and/CC get/VB it/PRP 's/VBZ switched/VBN on/RP"
    assert found(told, (0, "check_state"), (7, "change_state")) == [(0, "check_state"), (7, "change_state")]


def test_drunk_is_how_somebody_is() -> None:
    assert found("if/IN he/PRP 's/VBZ drunk/JJ ,/, tell/VB me/PRP", (2, "check_state")) == [(2, "check_state")]
    assert found("if/IN he/PRP 's/VBZ drunk/VBN it/PRP", (2, "check_state")) == [(3, "check_state")]


def test_a_reason_checks_nothing() -> None:
    words = "since/IN it/PRP is/VBZ broken/JJ ,/, open/VB it/PRP"
    assert found(words, (2, "check_state"), (5, "change_state")) == [(5, "change_state")]


def test_a_tag_question_asks_nothing_of_its_own() -> None:
    words = "he/PRP 's/VBZ asleep/JJ ,/, is/VBZ he/PRP ?/."
    assert found(words, (1, "check_state"), (4, "check_state")) == [(1, "check_state")]
    asked = "go/VB home/RB ./. ,/, is/VBZ he/PRP ?/."
    assert found(asked, (0, "motion"), (4, "check_state")) == [(0, "motion"), (4, "check_state")]


@pytest.mark.parametrize("cue", ["if", "unless"])
@pytest.mark.parametrize("tag", ["VBN", "VBD"])
def test_what_others_have_done_is_checked_not_done(cue: str, tag: str) -> None:
    words = f"{cue}/IN Tim/NNP has/VBZ already/RB put/{tag} it/PRP away/RB ,/, go/VB"
    assert found(words, (4, "placing")) == [(4, "check_state")]
    assert found(words, (2, "check_state"), (4, "placing")) == [(4, "check_state")]


@pytest.mark.parametrize(
    "words",
    [
        "once/IN you/PRP have/VBP just/RB put/VBN it/PRP away/RB ,/, go/VB",
        "if/IN you/PRP have/VBP just/RB put/VBN it/PRP away/RB ,/, go/VB",
        "if/IN Tim/NNP has/VBZ ,/, put/VB it/PRP away/RB",
        "so/CC if/IN Tim/NNP has/VBZ put/VB it/PRP away/RB",
    ],
)
def test_what_the_robot_has_done_is_its_own_task(words: str) -> None:
    assert found(words, (4, "placing")) == [(4, "placing")]


@pytest.mark.parametrize(
    ("words", "is_task"),
    [
        ("ca/MD n't/RB find/VB my/PRP$ keys/NNS look/VB", False),
        ("ca/MD n't/RB find/VB them/PRP ,/, look/VB", True),
        ("ca/MD n't/RB find/VB keys/NNS ?/. look/VB", True),
        ("if/IN we/PRP ca/MD n't/RB find/VB keys/NNS look/VB", True),
        ("you/PRP ca/MD n't/RB find/VB keys/NNS ,/, look/VB", True),
    ],
)
def test_what_somebody_cannot_find_is_not_looked_for_yet(words: str, is_task: bool) -> None:
    said = [word.split("/")[0] for word in words.split()]
    tasks = found(words, (said.index("find"), "searching"), (said.index("look"), "searching"))
    assert (said.index("find"), "searching") in tasks or not is_task
    assert len(tasks) == 1 + is_task


def test_who_looks_how_much_something_is_so_checks_it() -> None:
    assert found("look/VB how/WRB warm/JJ the/DT milk/NN is/VBZ", (0, "searching")) == [(0, "check_state")]
    assert found("look/VB how/WRB many/JJ eggs/NNS are/VBP left/VBN", (0, "searching")) == [(0, "searching")]


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("Feed the cat, wipe the table and clear up.", ["change_state", "change_state", "change_state"]),
        ("When we've gone out, lock the gate.", ["check_state", "change_state"]),
        ("Walk to the gate and clear off.", ["motion", "motion"]),
    ],
)
def test_who_clears_up_or_has_gone_is_not_sent_anywhere(text: str, kinds: list[str]) -> None:
    assert [task.type for task in Interpreter.load().interpret(text).tasks] == kinds


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("Has anybody fed the hens? If not, feed them.", ["check_state", "change_state"]),
        ("Did Lea put the jam in the cellar? If not, put it there.", ["check_state", "placing"]),
        ("Have you shut the hatch? If not, shut it.", None),
        ("Did you hear? Shut the hatch.", ["change_state"]),
    ],
)
def test_a_question_whether_somebody_has_done_something_is_no_order(text: str, kinds: list[str] | None) -> None:
    found = [task.type for task in Interpreter.load("household").interpret(text).tasks]
    assert found[-1] == "change_state" if kinds is None else found == kinds


def test_what_a_thing_has_is_no_check_of_its_own() -> None:
    text = "if/IN the/DT pie/NN has/VBZ nuts/NNS in/IN it/PRP"
    assert found(text, (3, "check_state"), (4, "check_state")) == [(3, "check_state")]
