"""Words that only some people say have plain ones."""

from __future__ import annotations

import pytest

from decomplex_bt.domain.dialects import plain_words


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("the lid is aff", "the lid is off"),
        ("Owt left ?", "Anything left ?"),
        ("tak it fae Lea", "take it from Lea"),
        ("din nae shout", "do not shout"),
        ("there 's nae lid", "there 's no lid"),
        ("there is nae lid", "there is no lid"),
        ("gonnae open it", "please open it"),
        ("so , gonnae open it", "so , please open it"),
        ("start moppin' the hall", "start mopping the hall"),
    ],
)
def test_a_word_that_is_none_stands_for_the_plain_one(said: str, meant: str) -> None:
    assert plain_words(said.split()) == meant.split()


@pytest.mark.parametrize(
    "said", ["take it off", "an aria for the canny arena", "she 's gonnae open it", "the 'old coin'", ""]
)
def test_plain_words_stay(said: str) -> None:
    assert plain_words(said.split()) is None
