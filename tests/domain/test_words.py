"""Verbs and nouns: what a word can mean in the household."""

from __future__ import annotations

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.domain.nouns import be, singulars
from decomplex_bt.domain.verbs import sense_of

DOMAIN = load_domain()


@pytest.mark.parametrize(
    ("form", "particles", "task", "state"),
    [
        ("Turn", ["off"], "change_state", "off"),
        ("switching", ["back", "on"], "change_state", "on"),
        ("killed", [], "change_state", "off"),
        ("Microwave", [], "change_state", "hot"),
        ("rinsing", [], "change_state", "clean"),
        ("top", ["up"], "change_state", "full"),
        ("emptied", [], "change_state", "empty"),
        ("shutting", [], "change_state", "closed"),
        ("rummage", [], "searching", None),
        ("nip", [], "motion", None),
        ("stash", [], "placing", None),
        ("let", ["know"], "informing", None),
        ("escorts", [], "following", None),
        ("pick", ["up"], "taking", None),
        ("get", [], "taking", None),
    ],
)
def test_a_verb_form_says_its_task_and_state(form: str, particles: list[str], task: str, state: str | None) -> None:
    sense = sense_of(form, particles, DOMAIN.lexicon)
    assert sense is not None
    assert (sense.tasks[0], sense.state) == (task, state)


def test_the_lexicon_is_broad() -> None:
    by_task = {
        task: [v for v, s in DOMAIN.lexicon.verbs.items() if task in s.tasks] for task in DOMAIN.ontology.task_types
    }
    assert len(DOMAIN.lexicon.verbs) > 900
    assert min(map(len, by_task.values())) >= 40


@pytest.mark.parametrize(
    ("phrase", "names", "plurals"),
    [
        ("pens", (), ("pen_1", "pen_2")),
        ("knives", (), ("knife",)),
        ("glasses", ("glasses",), ("glass_1", "glass_2")),
        ("keys", ("keys",), ("keys",)),
        ("towel", ("towel",), ()),
        ("machine", ("coffee_machine", "dishwasher", "washing_machine"), ()),
        ("anna", ("anna",), ()),
        ("zeppelin", (), ()),
    ],
)
def test_a_noun_names_entities(phrase: str, names: tuple[str, ...], plurals: tuple[str, ...]) -> None:
    assert DOMAIN.nouns.lookup(phrase) == (names, plurals)


def test_singulars_of_what_is_no_plural_are_none() -> None:
    assert singulars("glass") == ()
    assert "battery" in singulars("batteries")


def test_the_nearest_word_to_a_slip_of_the_pen() -> None:
    assert DOMAIN.nouns.nearest("fridg")[0] == "fridge"


@pytest.mark.parametrize("word", ["xqzzy", "eggs", "salmon"])
def test_a_word_like_none_is_no_slip_of_the_pen(word: str) -> None:
    assert DOMAIN.nouns.nearest(word) == ()


@pytest.mark.parametrize(
    "phrase",
    [
        "my keys",
        "the living room curtains",
        "both of the mugs",
        "two pens",
        "Anna and Tom",
        "the dishes",
        "keys in a box",
    ],
)
def test_several_are(phrase: str) -> None:
    assert be(phrase) == "are"


@pytest.mark.parametrize(
    "phrase", ["the glass", "a box of pens", "Thomas", "one of the mugs", "glass 1", "all the milk", "the bus", ""]
)
def test_one_is(phrase: str) -> None:
    assert be(phrase) == "is"
