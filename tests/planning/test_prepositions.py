"""What leads a phrase and what trails it, in plain words or those of a dialect."""

from __future__ import annotations

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.planning.phrases import read_phrases
from decomplex_bt.planning.prepositions import split_preposition

DOMAIN = load_domain("household")


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("fae the kitchen table", ("from", "the kitchen table")),
        ("tae Anna", ("to", "anna")),
        ("on top of the shelf", ("on top of", "the shelf")),
    ],
)
def test_a_preposition_of_a_dialect_leads_as_the_plain_one(said: str, expected: tuple[str, str]) -> None:
    assert split_preposition(said, DOMAIN) == expected


@pytest.mark.parametrize("said", ["a pen to sign the letter with", "a pen"])
def test_what_a_thing_is_for_names_no_other(said: str) -> None:
    (phrase,) = read_phrases(said, DOMAIN)
    assert phrase.entities == read_phrases("a pen", DOMAIN)[0].entities
    assert phrase.entities


def test_something_for_an_unknown_use_names_nothing() -> None:
    with pytest.raises(InputError, match="something to sign the letter with"):
        read_phrases("something to sign the letter with", DOMAIN)
